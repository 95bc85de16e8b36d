// Layers: their choice, their links, their range and their code, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { functions, numbers, shaderKey } from "../code.js";
import { exported } from "../export.js";
import { scalarCode } from "../scalar.js";
import { linkOf, stateOf } from "../links.js";
import {
  changed, chosen, detailsOf, dimensionsOf, easeAround, easeOf, kMostLayers, mapsOf, maskState, noisesOf, rangeOf, settingsOf,
  titlesOf, usualState, uses, withLayer, withoutLayer,
} from "../model.js";
import { coveredBy } from "../values.js";

const kThree = "#sum=none&noise=value&weight=2&sum2=none&blend2=add&offset2=0.5&scale2=4&blend3=mix&weight3=0.25";
// The text alone, without that of the library.
const textOf = (state, language = "glsl", forms = ["position"]) =>
  functions(language, state, numbers(language, state), forms).lines.join("\n");

test("links of one layer are as they were, and a number names another layer", () => {
  const one = stateOf("#sum=ridged&noise=simplex&seed=42&weight=0.5&sum2=none");
  assert.equal(one.layers.length, 1);
  assert.equal(linkOf(one), "#sum=ridged&noise=simplex&seed=42");
  // A layer that is left alone has no scale, with which its tiles would be other ones.
  assert.equal(withoutLayer(stateOf("#period=3&scale=4&blend2=add"), 1).layers[0].scale, 1);
  const three = stateOf(kThree);
  assert.equal(linkOf(three), kThree);
  assert.deepEqual(titlesOf(three), ["Value", "+ Perlin", "mix fBm of Perlin"]);
  // A layer between two that a link names is there, too, and there are no more than eight.
  assert.equal(linkOf(stateOf("#blend3=min")), "#blend2=add&blend3=min");
  assert.equal(stateOf("#blend9=min").layers.length, 1);
  assert.equal(settingsOf(stateOf("#blend2=add&scale2=5"), 1).scale, 4);
  assert.equal(settingsOf(stateOf("#blend2=add&scale2=1e9&weight2=-99&blend3=x"), 1).scale, 64);
  assert.equal(settingsOf(stateOf("#blend2=absent&sum2=ping_pong"), 1).strength, 2);
  // One of the layers at least is shown.
  assert.deepEqual(stateOf("#on=0&blend2=add&on2=0").layers.map(({ on }) => on), [1, 0]);
});

test("a choice is that of its layer, and what goes with it follows", () => {
  const state = stateOf(kThree);
  const next = chosen(state, { sum: "ping_pong", seed: 99, map: "land" }, 1);
  assert.deepEqual(next.layers.map(({ sum, strength, seed }) => [sum, strength, seed]),
                   [["none", 1, 7], ["ping_pong", 2, 99], ["fbm", 1, 7]]);
  assert.equal(next.map, "land");
  assert.equal(chosen(state, { view: "tiles" }).period, 4);
  assert.equal(settingsOf(chosen(state, { blend: "mix" }, 1), 1).weight, 0.5);
  assert.deepEqual(dimensionsOf(state), [1, 2, 3, 4]);
  const plane = chosen(changed(state, { dimensions: 1 }), { sum: "none", noise: "simplex_smooth" }, 2);
  assert.deepEqual([plane.dimensions, dimensionsOf(plane)], [2, [2, 3]]);
  assert.deepEqual([uses(state, 0).blend, uses(state, 1).blend, uses(state, 2).offset], [false, true, false]);
  assert.equal(uses(usualState()).weight, false);
});

test("there are up to eight layers, each with noise of its own", () => {
  let state = chosen(usualState(), { seed: 4294967295, sum: "ridged" });
  for (let number = 2; number <= kMostLayers; ++number) state = withLayer(state);
  // Above the largest seed they go on from 0.
  assert.deepEqual(state.layers.map(({ seed }) => seed), [4294967295, 9, 19, 29, 39, 49, 59, 69]);
  assert.equal(withLayer(state).layers.length, kMostLayers);
});

test("who chooses a mask gets one of about a third, and a mask of nothing changes nothing", () => {
  const { from, soft } = chosen(stateOf("#blend2=add"), { blend: "mask" }, 1).layers[1]; // of values from -0.4 to 0.4
  assert.deepEqual([from, soft], [0, 0.16]);
  for (const values of [Array.from({ length: 900 }, (_, at) => at / 300 - 1), [1, 1, 1, 1]]) {
    const ease = easeAround(Float32Array.from(values));
    assert.ok(Math.abs(coveredBy(values, ease) - (values.length > 4 ? 1 / 3 : 0.5)) < 0.01, JSON.stringify(ease));
  }
  assert.deepEqual(rangeOf(stateOf("#seed=3&blend2=mask")), rangeOf(stateOf("#seed=3")));
});

test("a layer with a weight and an offset counts as it always did, until its edge is chosen", () => {
  const old = stateOf("#sum=none&blend2=height&weight2=4&offset2=-1&sum2=none&blend3=add");
  assert.equal(linkOf(old), "#sum=none&sum2=none&blend2=height&weight2=4&offset2=-1&blend3=add");
  assert.match(textOf(old), /min\(max\(4\.0 \* v \+ -1\.0, 0\.0\), 1\.0\)/);
  assert.deepEqual(easeOf(old.layers[1]), { from: 0.25, soft: 0.25 });
  const next = chosen(old, { from: 0.125 }, 1);
  assert.equal(linkOf(next), "#sum=none&sum2=none&blend2=height&from2=0.125&soft2=0.25&blend3=add");
  assert.match(textOf(next), /min\(max\(\(v - 0\.125\) \* 4\.0, 0\.0\), 1\.0\)/);
  // Below 0 it counts downwards; and an edge is never so narrow that integers have no room for its reciprocal.
  assert.match(textOf(chosen(next, { soft: -0.5 }, 1)), /\(0\.125 - v\) \* 2\.0/);
  assert.equal(chosen(next, { soft: -0.001 }, 1).layers[1].soft, -0.016);
  assert.notEqual(shaderKey(next), shaderKey(old));
});

test("the picture of a mask is grey, of the layers up to it", () => {
  const state = stateOf("#view=terrain&map=land&blend2=mask&soft2=0.5&blend3=height&soft3=0.5&tint3=moss&blend4=add");
  const mask = maskState(state, 2);
  assert.deepEqual([mask.layers.length, mapsOf(mask), rangeOf(mask), mask.view], [3, [{ map: "grey" }], [0, 1], "plane"]);
  assert.notEqual(shaderKey(mask), shaderKey({ ...mask, masks: undefined }));
  // The values that decide it are those below, whatever another mask makes of it.
  assert.deepEqual(maskState(state, 2, true).layers.map(({ on }) => on), [1, 0, 1]);
  for (const [link, at] of [["#blend2=add", 1], ["#blend2=mask", 0], ["#blend2=mask&on2=0", 1], ["#on=0&blend2=mask", 1]])
    assert.equal(maskState(stateOf(link), at), undefined, link);
});

test("a distance from the middle is a layer without a seed", () => {
  const state = stateOf("#blend2=add&noise2=middle&sum2=none&radius2=99&seed2=5&shape2=along_y&period=4");
  assert.equal(linkOf(state), "#period=4&sum2=none&noise2=middle&shape2=along_y&radius2=64&blend2=add");
  assert.deepEqual(noisesOf("fbm").includes("middle"), false);
  assert.equal(chosen(stateOf("#blend2=add"), { noise: "middle" }, 1).layers[1].sum, "none");
  const text = textOf(stateOf("#sum=none&noise=middle"));
  assert.match(text, /float ux = min\(max\(p\.x \* 0\.25, -2\.0\), 2\.0\) \* 1\.333333;/);
  assert.match(text, /return max\(1\.0 - \(ux \* ux \+ uy \* uy\), -1\.0\);/);
});

test("a layer has colours of its own where it counts", () => {
  const state = stateOf("#blend2=mask&sum2=none&tint2=moss&blend3=add&tint3=land&blend4=mix&weight4=0.25&tint4=own&tints4=0-000000_50-ff0000");
  assert.deepEqual(mapsOf(state).map(({ map, stops }) => [map, stops]).slice(1), [["moss", "0-000000_100-ffffff"], ["own", "0-000000_50-ff0000"]]);
  assert.deepEqual([uses(state, 0).tint, uses(state, 1).tint, uses(state, 1).tints, uses(state, 2).tint, uses(state, 3).tints], [false, true, false, false, true]);
  // Sums have no part of their own, so that colours of theirs are not in the link; and a missing name means those of the picture.
  assert.doesNotMatch(linkOf(state), /tint3/);
  assert.deepEqual(mapsOf(stateOf("#blend2=mask")).length, 1);
  assert.equal(shaderKey(changed(state, { tint: "land" }, 1)), shaderKey(state));
  assert.notEqual(shaderKey(changed(state, { tint: "none" }, 1)), shaderKey(state));
  assert.match(chosen(state, { tint: "own" }, 1).layers[1].tints, /^0-10140f_20-/);
  const shells = { glsl: ["", ""], go: ["", ""] };
  const library = { version: "", texts: () => [], shells };
  // Languages without colours have the parts, and nothing that these do not need.
  const go = scalarCode(library, "go", state).code.join("\n");
  assert.match(go, /^func Mask2\(x float32, y float32\) float32 \{\n\tvar m2 float32 = .*\n\treturn m2$/m);
  assert.doesNotMatch(go.slice(go.indexOf("func Mask2")), /\bv1\b/);
  assert.match(exported(library, "python", state).code.join("\n"), /^ {4}return v, mask_2, numpy\.clip\(mask_4, 0, 1\)$/m);
});

test("a layer counts where it is steep below", () => {
  const state = chosen(stateOf("#sum=none&blend2=slope&noise2=value&sum2=none"), { blend: "slope" }, 1);
  assert.deepEqual([state.layers[1].from, state.layers[1].soft], [1.95, 0.78]);
  assert.equal(detailsOf(changed(state, { scale: 4 }, 1).layers[1], 1), "Where it is steep · seed 7 · 4 × as fine");
  // Each such layer needs what is below it at three places, so there are at most two.
  const blends = stateOf("#blend2=slope&blend3=slope&blend4=slope").layers.map(({ blend }) => blend);
  assert.deepEqual(blends.slice(1), ["slope", "slope", "height"]);
});

test("the colours span what the layers may be together", () => {
  const range = (link) => rangeOf(stateOf(link)).map((end) => Number(end.toFixed(3)));
  const cells = "#sum=none&noise=cells"; // from 0 to 1
  for (const [more, expected] of [
    ["&blend2=max&sum2=none&noise2=cells&offset2=0.5", [0.5, 1.5]],
    ["&blend2=min&sum2=none&noise2=cells&offset2=0.5", [0, 1]],
    ["&blend2=multiply&sum2=none&noise2=cells&weight2=-2&offset2=0.5", [-1.5, 0.5]],
    ["&blend2=add&sum2=none&noise2=cells&on2=0", [0, 1]],
    ["&blend2=mix&sum2=none&noise2=cells&weight2=0", [0, 1]],
    // Both ends are seldom met together.
    ["&blend2=add&sum2=none&noise2=cells&weight2=-1", [-0.707, 0.707]],
  ])
    assert.deepEqual(range(cells + more), expected, more);
});

test("a layer that is off is not in the code", () => {
  assert.doesNotMatch(textOf(changed(stateOf(kThree), { on: 0 }, 1)), /hn_perlin\(|layer_3/);
  // One layer alone is as it always was; but its weight counts if there is another one that is off.
  assert.equal(textOf(stateOf("#seed=3")), textOf(stateOf("#seed=3&blend2=add&on2=0")));
  assert.match(textOf(stateOf("#blend2=add&on2=0&weight=0.5")), /float v = 0\.5 \* layer_1\(p\);/);
  // A mixture without anything below is the layer itself.
  const mixture = stateOf("#on=0&blend2=mix&weight2=0.25&sum2=none");
  assert.match(textOf(mixture), /^float pattern\(vec2 p\) \{ return hn_perlin\(p, 7u\); \}$/);
  assert.deepEqual(rangeOf(mixture), rangeOf(stateOf("#sum=none")));
});

test("a tile of a finer layer has more of its cells", () => {
  assert.match(textOf(changed(stateOf(kThree), { period: 3 })), /hn_tile\(s, ivec2\(12\)\)/);
});
