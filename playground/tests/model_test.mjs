// Links, positions, and the texts of the library, without a browser.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { shaderKey } from "../code.js";
import { exported, exportedText, kKinds, kLicense } from "../export.js";
import { ignoredIn, kLooks, linkOf, stateOf, stateOfLook } from "../links.js";
import {
  changed, dimensionsOf, kSettings, noisesOf, possible, settingsOf, shownLayers, uses, usualLayer, usualState,
} from "../model.js";
import { chance, settingsBy } from "./states.mjs";
import { parsedNumber, parsedPosition, positionText } from "../numbers.js";
import { paletteOf } from "../palette.js";
import { Library, unpacked } from "../pieces.js";
import { pageShader } from "../shaders.js";
import { Speed } from "../speed.js";
import { kLockable, randomized } from "../randomize.js";
import { kHashes, kWarps } from "../tables.js";
import { cellsAcross, leaningNumbers, leant, originOf, panned, positionOfPixel, stepOf, zoomed } from "../view.js";
import "./model_palette.mjs";
import "./model_undo.mjs";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "..", "..");
const page = readFileSync(process.argv[2], "utf8");
const library = new Library("1.2.3", await unpacked(/id="pieces">([^<]*)</.exec(page)[1]));

test("the page is small", () => assert.ok(page.length < 950_000, `${page.length} bytes`));

const from = chance(19);
const next = () => from.next().value;
const one = (list) => list[Math.floor(next() * list.length)];

const anySettings = settingsBy(next);

function anyState(most = 4) {
  const layers = Array.from({ length: 1 + Math.floor(next() * most) }, () => {
    const layer = { ...usualLayer(), ...anySettings(true) };
    return { ...layer, noise: one(noisesOf(layer.sum)) };
  });
  const state = { ...usualState(), ...anySettings(false), layers };
  return possible({ ...state, dimensions: one(dimensionsOf(state)) });
}
const text = (state) => JSON.stringify(state, (_, value) => (typeof value === "bigint" ? `${value} parts` : value));

test("a link brings its state back", () => {
  for (let i = 0; i < 700; ++i) {
    const state = anyState();
    const link = linkOf(state);
    assert.equal(linkOf(stateOf(link)), link);
    // Settings that the state does not use are not in its link; all others are.
    const shader = (of) => {
      const seeds = shownLayers(of).map((layer) => (uses(of, of.layers.indexOf(layer)).seed ? layer.seed : 0));
      const place = of.dimensions === 1 ? [of.x] : [of.x, of.y];
      return [...place, shaderKey(of), ...seeds, of.period, ...paletteOf(of), cellsAcross(of)];
    };
    assert.deepEqual(shader(stateOf(link)), shader(state), link);
    assert.match(link, /^(#[\w.=&-]+)?$/);
  }
  assert.equal(linkOf(usualState()), "");
});

test("the links of the page's description mean what it states", () => {
  const state = settingsOf(stateOf("#sum=ridged&noise=simplex&dimensions=3&z=1.5&seed=42&x=1000000000.25&cells=4"));
  assert.deepEqual(
    [state.sum, state.noise, state.dimensions, state.z, state.seed, state.x, state.cells],
    ["ridged", "simplex", 3, 1.5, 42, 1000000000n * 16777216n + 4194304n, 4],
  );
  const described = [
    ...readFileSync(join(root, "docs", "guide", "playground.md"), "utf8")
      .split("## Links")[1]
      .matchAll(/^\| `(\w+)` \|/gm),
  ].map((match) => match[1]);
  assert.deepEqual(described, Object.keys(kSettings));
});

test("without a drift there is no time, and with one the code has it", () => {
  const link = "#sum=clouds&drifty=-0.5&time=12.5&sum2=none&blend2=add&driftx2=0.25";
  const state = stateOf(`${link}&driftz=1`); // of a third axis there is none
  assert.equal(linkOf(state), link);
  assert.equal(linkOf(stateOf("#time=5&seed=3")), "#seed=3");
  assert.equal(pageShader(library, stateOf("#time=5")), pageShader(library, stateOf("")));
  const kinds = Object.entries(kKinds).flatMap(([language, kinds]) => Object.keys(kinds).map((kind) => [language, kind]));
  for (const [language, kind] of kinds) {
    assert.equal(exportedText(library, language, stateOf("#time=5"), kind), exportedText(library, language, stateOf(""), kind));
    const then = exportedText(library, language, state, kind);
    assert.match(then, language === "bake" ? /pattern\(x, y, 12\.5\)/ : /(?:seconds|time)\b[^]*\bseconds\b/, `${language}, ${kind}`);
    if (kKinds[language][kind].main) assert.match(then, /pattern\(p, 12\.5 \+ (?:iTime|time)\)/);
    assert.notEqual(exportedText(library, language, stateOf(link.replace("12.5", "2")), kind), language === "bake" || kKinds[language][kind].main ? then : "");
  }
  // One layer alone is a line of tools/bake, from another origin.
  const bake = (more) => exportedText(library, "bake", stateOf(`#x=3&period=8${more}`)).split("\n").at(-2);
  assert.equal(bake("&driftx=0.5&time=4"), bake("").replace("--origin=-1x", "--origin=-3x"));
  assert.match(exportedText(library, "python", stateOf("#driftx=-0.5&time=4")), /hashnoise\.fbm\(x \+ 0\.5 \* seconds, y, [^]*pattern\(x, y, 4\)/);
});

test("a link with what is not there still opens", () => {
  for (const [link, name, value] of [
    ["#noise=absent", "noise", "perlin"],
    ["#seed=-5", "seed", 0],
    ["#octaves=1e9", "octaves", 16],
    ["#gain=much", "gain", 0.5],
    ["#lacunarity=Infinity", "lacunarity", 8],
    ["#lacunarity=-Infinity", "lacunarity", 1],
    ["#x=far", "x", 0n],
    ["#x=1e9", "x", 1000000000n << 24n],
    ["#x=10000000000", "x", (1n << 55n) - 1n],
    ["#y=-2147483648", "y", -(1n << 55n)],
    ["#noise=simplex&dimensions=1", "dimensions", 2],
    ["#sum=eroded&noise=cells", "noise", "perlin"],
    ["#toString=1&__proto__=2", "seed", 7],
    ["#cells=0", "cells", 0.015625],
    ["#cells=1e12", "cells", 1048576],
    ["#map=constructor", "map", "dusk"],
    ["#map=own&stops=60-ABCDEF_20-123456", "stops", "20-123456_60-abcdef"],
    ["#map=own&stops=20-123456", "stops", "0-000000_100-ffffff"],
    ["#map=own&stops=0-123456_101-ffffff", "stops", "0-000000_100-ffffff"],
    [`#map=own&stops=${Array(9).fill("5-000000").join("_")}`, "stops", "0-000000_100-ffffff"],
  ]) {
    assert.equal(settingsOf(stateOf(link))[name], value, link);
  }
});

test("a wrong link states what is ignored", () => {
  assert.equal(ignoredIn("#sum=ridged&noise=simplex&x=1e9&blend2=add&seed2=3&cells=0.3333333333&map=land"), "");
  assert.equal(
    ignoredIn("#sum=fmb&octaves=abc&seed=-5&speed=1"),
    "The link has what this page does not know: sum=fmb, octaves=abc, speed=1. seed=-5 became 0.",
  );
  assert.equal(
    ignoredIn("#blend=add&x=2147483648&y=-Infinity"),
    "The link has what this page does not know: blend=add. x=2147483648 became 2147483647.99999994, " +
      "y=-Infinity became -2147483648.",
  );
  assert.equal(ignoredIn("#x=2147483647.99999994&y=-2147483648"), "");
  const looks = Object.keys(kLooks).map((name) => linkOf(stateOfLook(name, usualState())));
  const tutorial = readFileSync(join(root, "docs", "guide", "tutorial.md"), "utf8");
  const links = Array.from(tutorial.matchAll(/\*\*Playground\*\*: `(#[^`]+)`/g), ([, link]) => link);
  assert.ok(links.length > 3);
  for (const link of [...looks, ...links]) assert.equal(ignoredIn(link), "", link);
});

test("a view in a link brings what it needs, as a button does", () => {
  for (const view of ["sphere", "cube"]) {
    assert.equal(ignoredIn(`#view=${view}`), "");
    assert.equal(stateOf(`#view=${view}`).dimensions, 3);
    assert.equal(stateOf(`#view=${view}&dimensions=4`).dimensions, 4);
  }
  assert.equal(ignoredIn("#view=tiles"), "");
  assert.equal(stateOf("#view=tiles&period=9").period, 9);
  assert.match(ignoredIn("#view=sphere&dimensions=2"), /does not know: view=sphere/);
});

test("a surprise is possible, and leaves what is locked", () => {
  const state = stateOf("#sum=ridged&seed=5&map=land&blend2=add");
  const seen = new Set();
  for (let i = 0; i < 50; ++i) {
    const other = randomized(state, new Set(["seed", "map"]), next);
    assert.deepEqual(possible(other), other);
    assert.deepEqual([other.map, ...other.layers.map(({ seed }) => seed)], ["land", 5, 7]);
    seen.add(linkOf(other));
  }
  assert.equal(seen.size, 50);
  assert.deepEqual(randomized(state, new Set(kLockable), next), state);
});

test("a look is possible as it is written", () => {
  for (const [name, look] of Object.entries(kLooks)) {
    const state = stateOfLook(name, usualState());
    for (const [at, settings] of [look, ...(look.layers ?? [])].entries())
      for (const [setting, value] of Object.entries(settings))
        if (setting !== "layers") assert.equal(settingsOf(state, at)[setting], value, `${name}: ${setting}`);
  }
});

test("positions are exact", () => {
  for (let i = 0; i < 2000; ++i) {
    const parts = BigInt.asIntN(56, BigInt(Math.floor(next() * 2 ** 53)) * 8n + BigInt(i));
    assert.equal(parsedPosition(positionText(parts)), parts);
  }
  for (const [given, parts, number] of [
    ["-0.5", -8388608n, -0.5],
    [".5", 8388608n, 0.5],
    ["1.25E+1", 25n << 23n, 12.5],
    ["5e-1", 8388608n, 0.5],
    ["1e999", (1n << 55n) - 1n, Infinity],
    ["-Infinity", -(1n << 55n), -Infinity],
    ["2147483647.99999999", (1n << 55n) - 1n, 2147483647.99999999],
    [`-${"9".repeat(30)}`, -(1n << 55n), -1e30],
    [`${"0".repeat(40)}3.${"0".repeat(40)}`, 3n << 24n, 3],
    ...["", "x", "e5", "1e", "1e5.5", ".", "--1", "1.2.3", "0x10", "1 2", "1,2"].map((text) => [text]),
  ]) {
    assert.equal(parsedPosition(given), parts, given);
    assert.equal(parsedNumber(given), number, given);
  }
});

test("what one waits for any picture is no cost of a pixel", async () => {
  for (const [wait, pixel] of [
    [0.2, 1e-6],
    [6, 1e-4],
    [40, 1e-4],
    [3, 0.02],
    [16, 0],
  ]) {
    const time = async (pixels) => wait + pixels * pixel;
    const speed = await Speed.measured(time, 1280 * 800);
    assert.ok(Math.abs(speed.pixel - pixel) <= 0.02 * pixel, `${speed.pixel} is not ${pixel}`);
    // More octaves, which strips of forty milliseconds show.
    for (let i = 0; i < 20; ++i) {
      const pixels = Math.max(1280, Math.min(1280 * 800, speed.pixelsIn(40)));
      speed.learn(pixels, await time(4 * pixels));
    }
    assert.ok(Math.abs(speed.pixel - 4 * pixel) <= 0.05 * 4 * pixel, `${speed.pixel} is not ${4 * pixel}`);
  }
  // Draws that were slow by chance must not make strips so small that nothing but the wait is left.
  const speed = new Speed(25, 1);
  for (let i = 0; i < 40; ++i) {
    const pixels = Math.max(1280, Math.min(1280 * 800, speed.pixelsIn(40)));
    speed.learn(pixels, 25 + pixels * 1e-5);
  }
  assert.ok(speed.pixel < 4e-5, `${speed.pixel}`);
  // The single row that a picture ends with may take no longer than any: the next strip is about as large as before.
  const steady = new Speed(4, 0.02);
  steady.learn(180, 4);
  assert.ok(steady.pixelsIn(40) * 0.02 < 60, `${steady.pixel}`);
});

test("what is below a pointer stays there while the scale changes", () => {
  for (let i = 0; i < 500; ++i) {
    const state = {
      ...usualState(),
      x: BigInt(Math.floor(next() * 2 ** 50)),
      y: -BigInt(i),
      cells: 2 ** (next() * 16 - 4),
    };
    const [column, row] = [Math.floor(next() * 800), Math.floor(next() * 600)];
    const before = positionOfPixel(state, 800, 600, column, row);
    const nearer = {
      ...state,
      ...zoomed(state, 800, 600, 2 ** (next() * 2 - 1), column - 400, row - 300, kSettings.cells),
    };
    const after = positionOfPixel(nearer, 800, 600, column, row);
    before.forEach((parts, axis) =>
      assert.ok(parts - after[axis] <= 1n && after[axis] - parts <= 1n, `${parts} became ${after[axis]}`),
    );
  }
  const state = { ...usualState(), cells: 6 };
  assert.equal(stepOf(state, 64, 48), 2 ** 21);
  assert.deepEqual(originOf(state, 64, 48), [-(32n << 21n), -(24n << 21n)]);
  assert.deepEqual(panned(state, 64, 48, 8, -4), { x: -(8n << 21n), y: 4n << 21n });
});

test("a slice leans by a rotation, and is where it was without", () => {
  const lean = Math.acos(1 / Math.sqrt(3)) / (2 * Math.PI); // along the diagonal of the cells
  const rows = leaningNumbers({ lean });
  rows.forEach((row) => assert.ok(Math.abs(row[2] - 1 / Math.sqrt(3)) < 1e-4, `${row}`));
  for (const one of [0, 1, 2])
    for (const other of [0, 1, 2]) {
      const product = rows.reduce((sum, row) => sum + row[one] * row[other], 0);
      assert.ok(Math.abs(product - Number(one === other)) < 2e-4, `${one} and ${other}: ${product}`);
    }
  const place = [5n << 24n, -7n, 1n << 30n, 3n];
  assert.deepEqual(leant({ lean: 0 }, place), place);
  assert.deepEqual(stateOf("#dimensions=3&lean=0.1").lean, 0.1);
  assert.equal(linkOf(stateOf("#lean=0.1")), "");
  // A tile has its cells along the axes.
  assert.equal(linkOf(stateOf("#dimensions=3&lean=0.1&period=4")), "#dimensions=3&period=4");
});

test("a picture of tiles has one tile three times on its shorter side", () => {
  const state = possible({ ...usualState(), period: 3, view: "tiles", x: 5n << 24n, cells: 100 });
  assert.equal(stepOf(state, 800, 600), Math.round((3 / 200) * 16777216));
  const at = (column, row) => positionOfPixel(state, 800, 600, column, row);
  assert.deepEqual(at(400, 300), [5n << 24n, 0n]);
  assert.deepEqual(at(0, 0), originOf(state, 800, 600));
  for (const [column, row] of [[17, 30], [199, 199], [0, 100]]) {
    for (const [right, up] of [[1, 0], [0, 2], [3, 1]])
      assert.deepEqual(at(column + 200 * right, row + 200 * up), at(column, row));
    assert.notDeepEqual(at(column + 201, row), at(column, row));
  }
  // Without a period, and on a line, there is nothing to repeat.
  assert.equal(stateOf("#view=tiles&period=0").view, "plane");
  assert.equal(stateOf("#view=tiles&period=3&dimensions=1").view, "plane");
  assert.equal(linkOf(state), "#period=3&view=tiles&x=5");
});

test("hashes and warps are those of the library", () => {
  // Noises, fractals and metrics are the catalog's (tables.js).
  const inFile = (file, pattern) =>
    Array.from(readFileSync(join(root, "glsl", "hashnoise", file), "utf8").matchAll(pattern), ([, name]) => name.toLowerCase());
  const hashes = inFile("config.glsl", /^#define HN_HASH_([A-Z0-9_]+) \d+$/gm);
  assert.deepEqual(hashes.toSorted(), [...Object.keys(kHashes), "custom"].toSorted());
  const warps = inFile("warp2d.glsl", /^HN_FN hn_vec2 hn_(warp\w*)\(hn_vec2 p/gm);
  assert.deepEqual([...new Set(warps), "none"].toSorted(), Object.keys(kWarps).toSorted());
});

test("states with one shader have one text of it, and others have another", () => {
  const texts = new Map();
  for (let i = 0; i < 250; ++i) {
    const state = anyState(2);
    const key = shaderKey(state);
    const made = pageShader(library, state);
    assert.equal(texts.get(key) ?? made, made, key);
    texts.set(key, made);
  }
  assert.equal(new Set(texts.values()).size, texts.size);
});

const kOfShadertoy = 65536; // characters that a tab has
const kDefined = /^ *(?:export |public |private |pub |static |inline |highp )*(?:fn|func|function|[\w<>\[\](), ]+?) \*?(\w+)\(/gm;

// The fault of a copied text: nothing, if it has what it calls of the library, in few characters.
function wrongText(from, language, state) {
  const text = exportedText(from, language, state);
  if (/#include "hashnoise|^#define HN_VERSION_MAJOR|^const HN_I_|…/m.test(text)) return "it has the files of the library";
  if (text.length >= kOfShadertoy) return `it has ${text.length} characters`;
  const defined = new Set(Array.from(text.matchAll(kDefined), ([, name]) => name));
  const code = text.replace(/^ *(?:\/\/|#).*$/gm, "");
  const called = new Set(Array.from(code.matchAll(/\b(hn_(?!uvec|ivec|vec)\w+)\(/gi), ([, name]) => name));
  const absent = [...called].find((name) => !defined.has(name) && !new RegExp(`struct ${name}\\b`).test(code));
  return absent ? `there is no ${absent}` : "";
}
const kShort = ["glsl", "hlsl", "wgsl", "metal", "godot", "tsl", "c", "osl", "rust", "go", "java", "csharp", "javascript"];

test("what is copied in any language needs no file, and is short", () => {
  const sizes = [];
  for (let i = 0; i < 39; ++i) {
    const state = possible({ ...anySettings(false), layers: Array.from({ length: 1 + (i % 3) }, () => anySettings(true)) });
    const language = kShort[i % kShort.length];
    assert.equal(wrongText(library, language, state), "", `${language}, ${linkOf(state)}`);
    for (const kind of Object.keys(kKinds.glsl)) sizes.push(exportedText(library, "glsl", state, kind).length);
  }
  assert.ok(Math.max(...sizes) < kOfShadertoy, `${Math.max(...sizes)}`);
  // One setting more than the plain picture has.
  for (const link of ["", "#period=4", "#warp=warp", "#noise=simplex", "#hash=pcg", "#blend2=multiply&sum2=none&noise2=cellular"]) {
    const { length } = exportedText(library, "glsl", stateOf(link));
    assert.ok(length < (link.includes("blend2") ? 13_000 : 8_300), `${link}: ${length}`);
  }
});

test("a text without a piece is noticed", () => {
  const without = (name) =>
    Object.assign(Object.create(library), {
      texts: (...wanted) => library.texts(...wanted).filter((text) => !text.includes(`${name}(`)),
    });
  for (const language of ["glsl", "hlsl", "wgsl"]) {
    assert.equal(wrongText(library, language, usualState()), "");
  }
  assert.equal(wrongText(without("hn_fbm"), "glsl", usualState()), "there is no hn_fbm");
  assert.throws(() => library.texts(["hn_absent2"], "glsl", usualState()), /no hn_absent2 in glsl/);
});

test("a copied text has the chosen settings", () => {
  const state = possible(
    changed(usualState(), { sum: "ridged", noise: "simplex", octaves: 5, seed: 9, arithmetic: "fixed", hash: "pcg" }),
  );
  const short = exportedText(library, "glsl", state, "function", false);
  for (const part of [
    "#define HN_ARITHMETIC HN_FIXED",
    "#define HN_HASH HN_HASH_PCG",
    '#include "hashnoise/fbm2d.glsl"',
    "do hn_add_ridged(o, hn_simplex(o.place, o.seed)); while (hn_next(o));",
    "ridged_simplex(hn_octaves(hn_place(cell, f), 5, 2.0, 0.5, 9u))",
    "highp vec3 colour(highp float value)",
  ]) {
    assert.ok(short.includes(part), part);
  }
  // By default it needs no other file.
  for (const language of ["glsl", "hlsl", "wgsl"]) {
    for (const kind of Object.keys(kKinds[language])) {
      const text = exportedText(library, language, state, kind);
      assert.ok(!text.includes("#include") && text.includes(kLicense), `${language}, ${kind}`);
      assert.match(text, /^(fn hn_add_ridged2|(highp )?void hn_add_ridged)\(/m);
    }
  }
  assert.match(
    exported(library, "wgsl", state, "function", false).head.join("\n"),
    /tools\/pick .*hn_add_ridged2 .*--language wgsl --arithmetic fixed --hash pcg/,
  );
  assert.match(exportedText(library, "bake", stateOf("#seed=9&period=4")), /^tools\/bake fbm --seed 9 .*--period 4x4 .*-o noise\.png$/m);
  assert.match(exportedText(library, "bake", stateOf("#sum=eroded&noise=simplex")), /^tools\/bake eroded --noise simplex_d /m);
  const layers = exportedText(library, "bake", stateOf("#blend2=mask&blend3=add&dimensions=3&period=4"));
  assert.match(layers, /^def pattern\(x, y, z\):$/m);
  assert.match(layers, /^tools\/bake --expression 'pattern\(x, y, z\)' --source pattern\.py --size \d+x\d+x1 .*-o noise\.png$/m);
  assert.match(exportedText(library, "python", stateOf("#arithmetic=fixed&blend2=add")), /^ {4}v = numpy\.clip\(v \+ .*, -8, 8\)$/m);
  assert.match(exportedText(library, "python", stateOf("#seed=9")), /^values = hashnoise\.grid\("fbm", \(1024, 1024\), .*seed=9/m);
});
