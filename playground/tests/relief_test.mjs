// Terrain and solids, without a browser. (pixels_test.mjs has the points that solids show.)
import assert from "node:assert/strict";
import test from "node:test";
import { shaderKey } from "../code.js";
import { fileState, turned } from "../files.js";
import { linkOf, stateOf } from "../links.js";
import { chosen, uses, usualState } from "../model.js";
import { paletteOf } from "../palette.js";
import { onBackdrop, reliefOf, surfaceOf } from "../relief.js";

const kSide = 32;
const kGrey = paletteOf({ map: "grey" });
const surface = (of, steep = 0.2, sea = 0) => {
  const values = Array.from({ length: kSide * kSide }, (_, at) => of(at % kSide, Math.floor(at / kSide)));
  return surfaceOf(values, kSide, [0, 1], kGrey, { steep, sea });
};
const kWidth = 90;
const kHeight = 60;
const drawn = (of, { turn = 0, tilt = 0.25, steep, free, sea } = {}) => {
  const bytes = reliefOf(surface(of, steep, sea), { turn, tilt }, kWidth, kHeight, free);
  // A pixel, counted from the middle, to the right and up.
  return (right, up) => {
    const at = 4 * ((kHeight / 2 - 1 - up) * kWidth + kWidth / 2 + right);
    return [...bytes.subarray(at, at + 4)];
  };
};

test("from above it is the plane, and a turn turns it", () => {
  // Only the quarter above and to the right is bright, but for the light.
  const quarter = (x, y) => (x >= kSide / 2 && y >= kSide / 2 ? 1 : 0);
  for (const [turn, right, up] of [[0, 1, 1], [0.25, 1, -1], [0.5, -1, -1], [0.75, -1, 1]]) {
    const at = drawn(quarter, { turn, steep: 0 });
    for (const [x, y] of [[1, 1], [1, -1], [-1, -1], [-1, 1]]) {
      const bright = x === right && y === up ? 255 : 0;
      assert.deepEqual(at(10 * x, 10 * y), [bright, bright, bright, 255], `${turn}: ${x}, ${y}`);
    }
    assert.deepEqual(at(-44, 0), [0, 0, 0, 0]);
  }
});

test("a surface has the colours of pixels, where layers have their own", () => {
  const flat = new Float32Array(4).fill(0.5);
  const pixels = Uint8Array.from([9, 8, 7, 255, 1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255]);
  const { colours } = surfaceOf(flat, 2, [0, 1], kGrey, { steep: 0.2 }, pixels);
  assert.deepEqual([...colours], [...pixels].filter((_, at) => at % 4 < 3));
});

test("what stands in front hides what is behind, and a flat look sees its side", () => {
  const wall = (_, y) => (y >= 6 && y <= 9 ? 1 : 0);
  const count = (tilt) => {
    const at = drawn(wall, { tilt, steep: 0.6 });
    let ground = 0;
    for (let up = -30; up < 30; ++up) if (at(0, up)[3] && at(0, up)[0] < 5) ++ground;
    return ground;
  };
  assert.ok(count(0.05) < count(0.15) && count(0.15) < count(0.25), [count(0.05), count(0.15), count(0.25)].join());
  // The side of the block is in front, below everything.
  const at = drawn(() => 1, { tilt: 0.06, steep: 0.4 });
  const column = [...Array(60).keys()].map((row) => at(0, row - 30)).filter((pixel) => pixel[3] === 255);
  assert.deepEqual(column[0], [52, 48, 50, 255]);
  assert.deepEqual(column.at(-1), [255, 255, 255, 255]);
});

test("slopes towards the light are brighter than those away from it", () => {
  const shade = (sign) => drawn((x) => 0.5 + (sign * (x - 16)) / 64, { steep: 1 })(0, 0)[0];
  assert.ok(shade(1) > shade(-1) + 40, `${shade(1)} and ${shade(-1)}`);
});

test("water is flat, and mirrors the sky, whatever is below it", () => {
  const bed = (x, y) => 0.1 * ((x + y) % 2);
  const { heights, colours } = surface(bed, 0.5, 0.4);
  assert.deepEqual([...new Set(heights)], [Math.fround(0.4)]);
  assert.equal(new Set([10, 11].map((at) => String(colours.subarray(3 * at, 3 * at + 3)))).size, 1); // deep water has one colour
  const shallow = surface(() => 0.38, 0.5, 0.4).colours;
  assert.ok(shallow[0] > colours[0]);
  const lights = (of) => {
    const at = drawn(of, { tilt: 0.08, steep: 0.5, sea: 0.4 });
    const column = [...Array(60).keys()].map((row) => at(0, row - 30)).filter((pixel) => pixel[3] === 255);
    return new Set(column.slice(-8).map(String)).size; // without the side in front
  };
  assert.deepEqual([lights(() => 0.1) > 5, lights(() => 0.9)], [true, 1]);
});

test("a coast and the edge of a hill are no stairs", () => {
  // A coast that crosses the rows at a small angle goes from water to land in steps, in each row elsewhere.
  const { wet } = surface((x, y) => 0.5 + 0.02 * (y - 16) + 0.002 * x, 0.2, 0.5);
  const column = [...Array(kSide).keys()].map((x) => Math.max(...[12, 13, 14, 15, 16].map((y) => Math.min(wet[y * kSide + x], 1 - wet[y * kSide + x]))));
  assert.ok(Math.min(...column) > 0.04 && new Set(column.map((part) => part.toFixed(2))).size > 5, `${column}`);
  assert.ok(wet[20] === 1 && wet[31 * kSide] === 0);
  const at = drawn((x, y) => (y > 12 ? x / 80 : 0), { tilt: 0.05, steep: 1 });
  const edge = [...Array(40).keys()].map((k) => Math.max(...[...Array(60).keys()].map((row) => at(k - 20, row - 30)[3]).filter((own) => own < 255)));
  assert.ok(new Set(edge).size > 8 && edge.filter((own) => own > 0).length > 30, `${edge}`);
});

test("terrain is saved as it is shown, before what is behind it", async () => {
  const bytes = reliefOf(surface(() => 1), { turn: 0.1, tilt: 0.1 }, kWidth, kHeight);
  const covered = bytes.filter((byte, at) => at % 4 === 3 && byte).length;
  const read = onBackdrop(bytes.slice(), kWidth, kHeight);
  const rows = new Uint8Array(4 * kWidth * kHeight);
  for (let row = 0; row < kHeight; row += 20) rows.set(await read(0, row, 20), 4 * kWidth * row);
  const whole = turned(rows, kWidth);
  const own = (at) => bytes[4 * at + 3] === 255;
  for (let at = 0; at < kWidth * kHeight; ++at)
    if (own(at)) assert.deepEqual(whole.subarray(4 * at, 4 * at + 4), new Uint8Array(bytes.subarray(4 * at, 4 * at + 4)));
  assert.ok(covered > 500 && covered < kWidth * kHeight && !whole.filter((byte, at) => at % 4 === 3).includes(0));
  assert.deepEqual([...whole.subarray(0, 3)], [42, 44, 54]);
});

test("all of the block is in the picture, and beside a panel", () => {
  for (const [turn, tilt, free] of [[0.125, 0.25, 90], [0.125, 0.02, 90], [0.3, 0.1, 60], [0.625, 0.2, 40]]) {
    const at = drawn((x, y) => (x + y) / 62, { turn, tilt, steep: 1, free });
    const seen = [];
    for (let up = -30; up < 30; ++up)
      for (let right = -45; right < 45; ++right) if (at(right, up)[3]) seen.push([right, up]);
    const ends = (axis) => seen.map((pixel) => pixel[axis]);
    assert.ok(seen.length > 100);
    assert.ok(Math.min(...ends(0)) > -45 && Math.max(...ends(0)) < free - 45, `${free}: ${Math.max(...ends(0))}`);
    assert.ok(Math.min(...ends(1)) > -30 && Math.max(...ends(1)) < 29, `${Math.min(...ends(1))}`);
  }
});

test("a solid has three dimensions or four, and a link", () => {
  const state = chosen(usualState(), { view: "sphere" });
  assert.deepEqual([state.dimensions, uses(state).turn, uses(state).steep], [3, true, false]);
  assert.equal(linkOf(chosen(state, { tilt: -0.2 })), "#dimensions=3&view=sphere&tilt=-0.2");
  assert.equal(stateOf("#dimensions=4&view=cube&tilt=-0.2").tilt, -0.2);
  for (const [link, expected] of [
    ["#view=sphere", ["sphere", 0.1]],
    ["#dimensions=2&view=sphere", ["plane", 0.1]],
    ["#dimensions=3&view=ball", ["plane", 0.1]],
    ["#dimensions=3&view=terrain&tilt=-0.2", ["terrain", 0.02]],
  ]) {
    const { view, tilt } = stateOf(link);
    assert.deepEqual([view, tilt], expected, link);
  }
  assert.equal(chosen(state, { dimensions: 2 }).view, "plane");
  // Its file is the plane through its middle, by another shader.
  assert.equal(fileState(state).view, "plane");
  assert.equal(new Set([state, fileState(state), { ...state, view: "cube" }].map(shaderKey)).size, 3);
});
