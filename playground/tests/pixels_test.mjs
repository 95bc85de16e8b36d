// The pixels: with HN_FIXED their values are those of the C++ header, bit for bit; and their colours follow from the
// values.
import assert from "node:assert/strict";
import test, { after, before } from "node:test";
import { linkOf, stateOf } from "../links.js";
import { changed, isLeaning, mapsOf, numbersOfTinted, rangeOf, usualState } from "../model.js";
import { kMaps } from "../tables.js";
import { leaningSteps, leant } from "../view.js";
import { kSteered } from "./states.mjs";
import { compiled, copiedCode, floatOf, kForWebGl, launched, opened, pixels, setState } from "./support.mjs";

const kParts = 16777216;

// Pictures whose every pixel is compared with C++: 8 pixels make a cell, and far out a cell has its own neighbours.
const far = { x: -1000000000n * 16777216n + 4711n, y: 2000000000n * 16777216n, cells: 0.75 };
const pictures = [
  { sum: "fbm", noise: "simplex", ...far },
  { sum: "ridged", noise: "value_cubic", dimensions: 3, z: -3.25, hash: "pcg", gain: 0.625, seed: 4294967295 },
  { sum: "ping_pong", noise: "cellular", metric: "manhattan", jitter: 0.75, strength: 3, octaves: 3 },
  { sum: "none", noise: "cells", period: 3, map: "land" },
  { sum: "none", noise: "curl", dimensions: 3, z: 0.5, map: "signed" },
  { sum: "eroded", noise: "value", warp: "warp_progressive", amplitude: 1.5, strength: 2 },
  { sum: "none", noise: "simplex", phase: 0.375, period: 4, hash: "pcg" },
  { sum: "weighted", noise: "cell_border", dimensions: 3, z: 7.125, period: 5, octaves: 2 },
  { sum: "turbulence", noise: "perlin", dimensions: 4, z: 1.75, w: -0.125, octaves: 3, lacunarity: 1.875 },
  { sum: "clouds", noise: "value", dimensions: 1, map: "sky" },
  { sum: "none", noise: "perlin", dimensions: 4, ...far, z: 1.75, lean: 0.152 },
  { sum: "none", noise: "simplex_smooth", dimensions: 3, z: 2.5, hash: "pcg" },
  { sum: "hybrid", noise: "perlin", dimensions: 3, z: 0.125, period: 7, lacunarity: 3 },
  { sum: "none", noise: "random", dimensions: 1 },
].map((state) => changed(usualState(), { x: 5n, y: -7n, cells: 6, ...state, arithmetic: "fixed" }));
// Layers, far out: every way to combine them, finer ones, one that is off, a warp and weights that are rounded.
const kLayered =
  "#sum=ridged&weight=1.1&blend2=add&sum2=billow&noise2=simplex&weight2=-0.7&offset2=0.1&scale2=4&" +
  "blend3=multiply&on3=0&blend4=mix&sum4=none&noise4=cells&weight4=0.35&seed4=3&warp4=warp&" +
  "blend5=mask&sum5=none&noise5=value&weight5=1.5&offset5=0.3&blend6=height&sum6=none&noise6=simplex&weight6=0.7&offset6=0.2&" +
  "tint4=ember&tint5=moss&tint6=grey&blend7=slope&sum7=none&weight7=0.5&offset7=-0.4&tint7=land";
const kOthers =
  "#noise=value&blend2=multiply&weight2=1.3&blend3=min&sum3=none&noise3=cellular&offset3=-0.6&" +
  "blend4=max&sum4=none&noise4=curl&weight4=0.2&scale4=64&dimensions=3&z=7.3&period=3";
pictures.push(changed(stateOf(kLayered), { ...far, arithmetic: "fixed", map: "land" }));
pictures.push(changed(stateOf(kSteered), { ...far, arithmetic: "fixed", map: "land" }));
pictures.push(changed(stateOf(kSteered), { x: 5n, y: -7n, cells: 6, arithmetic: "fixed", hash: "pcg" }));
pictures.push(changed(stateOf(kOthers), { x: 5n, y: -7n, cells: 6, arithmetic: "fixed" }));
const kWidth = 40;
const kHeight = 32;

// In C++: a function that prints the values of a picture, with the positions of its pixels by 64-bit arithmetic.
function printer(state, name) {
  const n = state.dimensions;
  const step = Math.round((state.cells / kHeight) * kParts);
  const steps = leaningSteps(state, step);
  const corner = leant(state, [state.x - BigInt(kWidth / 2 * step), state.y - BigInt(kHeight / 2 * step), BigInt(Math.round(state.z * kParts)), 0n]);
  const leaning = ["x", "y", "z"].map((axis, k) => `const long long ${axis} = ${corner[k]}LL + column * ${steps[0][k]}LL + row * ${steps[1][k]}LL;`);
  const axes = ["x", "y", isLeaning(state) ? "z" : String(Math.round(state.z * kParts)), String(Math.round(state.w * kParts))].slice(0, n);
  const list = (type, part) => (n === 1 ? part("x") : `${type}${n}(${axes.map((axis) => part(axis)).join(", ")})`);
  const place = `${list("hashnoise::ivec", (axis) => `cell(${axis})`)}, ${list("hashnoise::vec", (axis) => `place(${axis})`)}`;
  return `void print_${name}() {
  for (int row = 0; row < ${kHeight}; ++row) {
    for (int column = 0; column < ${kWidth}; ++column) {
      ${isLeaning(state) ? leaning.join(" ") : `const long long x = ${state.x}LL + (column - ${kWidth / 2}) * ${step}LL;
      [[maybe_unused]] const long long y = ${state.y}LL + (row - ${kHeight / 2}) * ${step}LL;`}
      const auto value = hashnoise::${name}::pattern(${place});
      std::printf("%08x", hashnoise::floatBitsToUint(value));
${numbersOfTinted(state).map((number) => `      std::printf(" %08x", hashnoise::floatBitsToUint(hashnoise::${name}::mask_${number}(${place})));\n`).join("")}      std::printf("\\n");
    }
  }
}
`;
}
const kPlaces = `#include <cstdio>
int cell(long long at) { return static_cast<int>(static_cast<unsigned>(at >> 24)); }
float place(long long at) { return static_cast<float>(at & 0xFFFFFF) * 0x1p-24f; }
`;

// The words of each picture by C++, each with how much its layers with colours count. Pictures with one hash are in one program, since the header takes long to compile.
async function wordsOfCpp() {
  const words = new Map();
  for (const hash of new Set(pictures.map((state) => state.hash))) {
    const alike = pictures.filter((state) => state.hash === hash);
    const texts = [];
    for (const [number, state] of alike.entries()) {
      await setState(page, state);
      const code = await copiedCode(page, "cpp", false);
      texts.push(code.replace(/^namespace hashnoise \{$/m, `namespace hashnoise::picture${number} {`));
    }
    const names = alike.map((_, number) => `picture${number}`);
    const printers = alike.map((state, number) => printer(state, names[number]));
    const prints = names.map((name) => `print_${name}();`).join(" ");
    // The form that takes a position has the value of the other one.
    const [near, cell] = ["hashnoise::vec2(2.5f, 1.25f)", "hashnoise::ivec2(2, 1), hashnoise::vec2(0.5f, 0.25f)"];
    const same = alike[0].dimensions === 2 ? `hashnoise::picture0::pattern(${near}) == hashnoise::picture0::pattern(${cell})` : "true";
    const main = `int main() { ${prints} return ${same} ? 0 : 1; }`;
    const printed = (await compiled(texts.join("\n"), [kPlaces, ...printers, main].join("\n"))).trim().split("\n");
    alike.forEach((state, number) => {
      const mine = printed.slice(number * kWidth * kHeight, (number + 1) * kWidth * kHeight);
      words.set(state, mine.map((line) => line.split(" ").map((word) => parseInt(word, 16))));
    });
  }
  return words;
}

// The colour that a value has, by another way than the shader's: the map at the number of the colour, and so much of those
// of layers.
function colourOf(value, state, row, counts) {
  const [low, high] = rangeOf(state).map((end) => Math.round(end * 2 ** 20));
  const units = Math.min(Math.max(Math.floor(value * 2 ** 20) - low, 0), high - low - 1);
  const number = Math.floor((units * 256) / (high - low));
  const above =
    state.dimensions === 1 && row > Math.floor((Math.floor(units / 64) * kHeight) / Math.floor((high - low) / 64));
  const [picture, ...tints] = mapsOf(state).map(({ map }) => {
    const stops = kMaps[map].stops.map((stop) => parseInt(stop, 16));
    const place = (number * (stops.length - 1)) / 255;
    const at = Math.min(Math.floor(place), stops.length - 2);
    return [16, 8, 0].map((shift) => {
      const [from, to] = [stops[at], stops[at + 1]].map((stop) => (stop >> shift) & 255);
      return Math.round(from + (to - from) * (place - at));
    });
  });
  const mixed = tints.reduce((below, tint, k) => below.map((part, i) => Math.round(part + (tint[i] - part) * floatOf(counts[k]))), picture);
  return { parts: mixed.map((part) => part * (above ? 0.125 : 1)), exact: !above };
}

function wrongColours(values, bytes, state, counts) {
  let wrong = 0;
  values.forEach((word, at) => {
    const { parts, exact } = colourOf(floatOf(word), state, Math.floor(at / kWidth), counts?.[at]);
    const off = Math.max(...parts.map((part, i) => Math.abs(part - bytes[4 * at + i])));
    if (off > (exact ? 0 : 0.5) || bytes[4 * at + 3] !== 255) ++wrong;
  });
  return wrong;
}

const unequal = (a, b) => a.filter((word, at) => word !== b[at]).length + Math.abs(a.length - b.length);

let browser;
let page;
before(async () => {
  browser = await launched(kForWebGl);
  page = await opened(browser);
});
after(() => browser.close());

test("every pixel of a picture has the value of C++, and its colour", async () => {
  const words = await wordsOfCpp();
  for (const state of pictures) {
    const name = linkOf(state);
    const expected = words.get(state).map(([word]) => word);
    const counts = words.get(state).map(([, ...rest]) => rest);
    assert.ok(new Set(expected).size > 5, `${name} shows next to nothing`);
    await setState(page, state);
    const values = await pixels(page, kWidth, kHeight, true);
    assert.equal(unequal(values, expected), 0, name);
    const colours = await pixels(page, kWidth, kHeight);
    assert.equal(wrongColours(values, colours, state, counts), 0, `colours of ${name}`);
    // Another part of a colour is noticed.
    const others = counts.map((list) => list.map(() => 0x3e800000));
    if (counts[0].length) assert.notEqual(wrongColours(expected, colours, state, others), 0);
  }
});

test("floats are as near as the library promises", async () => {
  await setState(page, { ...pictures[0], arithmetic: "fixed" });
  const exact = await pixels(page, kWidth, kHeight, true);
  await setState(page, { arithmetic: "fast" });
  const values = await pixels(page, kWidth, kHeight, true);
  const off = Math.max(...values.map((word, at) => Math.abs(floatOf(word) - floatOf(exact[at]))));
  assert.ok(off > 0 && off < 1e-4, `off by ${off}`);
});

test("the edge of a map is smooth with floats alone", async () => {
  const edge = { map: "own", stops: "0-000000_50-000000_50-ffffff_100-ffffff", arithmetic: "fast" };
  const shades = async (changes) => {
    await setState(page, { ...pictures[0], ...edge, ...changes });
    return new Set((await pixels(page, kWidth, kHeight)).filter((_, at) => at % 4 === 0)).size;
  };
  assert.deepEqual([await shades({}), await shades({ arithmetic: "fixed" })], [5, 2]); // four values give five shades
});

test("a layer that drifts is where it was before, and the others stay", async () => {
  const at = { x: 3n << 22n, y: 0n, cells: 8, arithmetic: "fixed", dimensions: 3, z: 1.25 };
  const second = { sum: "none", noise: "cells", scale: 4, warp: "warp", seed: 3, blend: "add" };
  for (const settings of [{}, { period: 5 }, { sum: "none", noise: "middle" }, { warp: "warp", arithmetic: "fast" }, { view: "sphere", tilt: -0.1 }]) {
    const state = changed(usualState(), { ...at, ...settings });
    const both = { ...state, layers: [state.layers[0], { ...state.layers[0], ...second }] };
    const shown = async (given) => {
      await setState(page, given);
      return pixels(page, kWidth, kHeight, true);
    };
    const drift = { driftx: -1.5, drifty: 0.25, driftz: 0.5 };
    const moved = (given, changes) => ({ ...given, ...changes, layers: given.layers.map((layer) => ({ ...layer, ...drift })) });
    const place = { x: state.x + (3n << 24n), y: state.y - (1n << 23n), z: state.z - 1 };
    const name = JSON.stringify(settings);
    assert.equal(unequal(await shown(moved(both, { time: 2 })), await shown({ ...both, ...place })), 0, name);
    assert.equal(unequal(await shown(moved(both, { time: 0 })), await shown(both)), 0, name);
    const one = { ...both, time: 2, layers: [both.layers[0], { ...both.layers[1], ...drift }] };
    for (const other of [both, moved(both, { time: 2 })]) assert.ok(unequal(await shown(one), await shown(other)) > 99, name);
  }
});

test("tiles have no seam, and one that is there is seen", async () => {
  const side = 48;
  const state = changed(usualState(), { arithmetic: "fixed", period: 4, cells: 12, x: 99n << 20n });
  await setState(page, state);
  const plane = await pixels(page, side, side, true);
  await setState(page, { view: "tiles" });
  const tiles = await pixels(page, side, side, true);
  tiles.forEach((word, at) => assert.equal(word, tiles[(Math.floor(at / side) % 16) * side + (at % side) % 16]));
  assert.equal(unequal(tiles, plane), 0);
  const wrong = await page.evaluate(async (size) => {
    const { gpu, programs } = window.hashnoise;
    const build = gpu.build.bind(gpu);
    programs.clear();
    gpu.build = (text) => build(text.replaceAll(/ivec2\((u_layers\[0\]\.octaves\.z)\)/g, "ivec2($1 + 1)"));
    const bytes = await window.hashnoise.pixels(size, size, 1);
    programs.clear();
    gpu.build = build;
    return Array.from(new Uint32Array(bytes.buffer));
  }, side);
  await setState(page, { view: "plane", period: 5 });
  assert.notEqual(unequal(wrong, await pixels(page, side, side, true)), 0);
});

// Where the point is that a pixel of a solid shows, in cells from its middle; nothing beside it. In floats.
function pointAt({ view, turn, tilt, cells }, column, row) {
  const radius = 0.46 * Math.min(kWidth, kHeight);
  const [right, up] = [column + 0.5 - kWidth / 2, row + 0.5 - kHeight / 2].map((part) => part / radius);
  const [a, b] = [turn, tilt].map((part) => part * 2 * Math.PI);
  const [sine, cosine, down, across] = [Math.sin(a), Math.cos(a), Math.sin(b), Math.cos(b)];
  const towards = [sine * across, -cosine * across, down];
  const beside = [right * cosine - up * sine * down, right * sine + up * cosine * down, up * across];
  const half = Math.sqrt(1 / 3);
  const near =
    view === "sphere"
      ? Math.sqrt(1 - right * right - up * up)
      : Math.min(...towards.map((part, k) => (half * Math.sign(part) - beside[k]) / part));
  const point = beside.map((part, k) => part + near * towards[k]);
  if (view === "sphere") return Number.isNaN(near) ? undefined : point.map((part) => (part * cells) / 2);
  return point.some((part) => Math.abs(part) > half * 1.0001)
    ? undefined
    : point.map((part) => (part * cells) / 2 / half);
}

test("a sphere and a cube show points of space", async () => {
  const layers = [{ ...pictures[0].layers[0], sum: "none", noise: "value" }];
  for (const view of ["sphere", "cube"]) {
    const state = { ...pictures[0], layers, dimensions: 3, z: 0.25, cells: 3, x: far.x, view, turn: 0.3, tilt: -0.1 };
    await setState(page, state);
    const seen = await pixels(page, kWidth, kHeight, true);
    // Beside the solid there are no values, and on its points there are space's.
    const found = async (shown) => {
      let [beside, wrong] = [0, 0];
      for (let at = 3; at < seen.length; at += 61) {
        const point = pointAt(shown, at % kWidth, Math.floor(at / kWidth));
        const value = floatOf(seen[at]);
        if (!point) beside += 1;
        if (!point !== Number.isNaN(value)) wrong += 1;
        if (!point || Number.isNaN(value)) continue;
        const parts = [state.x, state.y, 4194304n].map((middle, k) => middle + BigInt(Math.round(point[k] * 16777216)));
        const expected = await page.evaluate(
          async (list) => (await window.hashnoise.values([[...list.map(BigInt), 0n]]))[0],
          parts.map(String),
        );
        if (Math.abs(value - expected) > 0.01) wrong += 1;
      }
      return { beside, wrong };
    };
    const { beside, wrong } = await found(state);
    assert.ok(beside > 3 && beside < 18 && wrong === 0, `${view}: ${beside} beside, ${wrong} wrong`);
    if (view === "cube") assert.ok((await found({ ...state, turn: 0.27 })).wrong > 3, "another turn looks the same");
  }
});

// The saved file: the words of the file, and its name.
const saved = () =>
  page.evaluate(async () => {
    const make = URL.createObjectURL.bind(URL);
    const saving = new Promise((resolve) => {
      URL.createObjectURL = (file) => {
        resolve(file);
        URL.createObjectURL = make;
        return make(file);
      };
    });
    document.getElementById("save").click();
    const file = await saving;
    const bytes = new Uint8Array(await file.arrayBuffer());
    return { name: file.name, bytes: Array.from(bytes) };
  });

const turned = (list, size = 1) => Array.from({ length: kHeight * size }, (_, row) =>
  list.slice((kHeight * size - 1 - row) * kWidth * size * 4, (kHeight * size - row) * kWidth * size * 4)).flat();

// All frames of a GIF, as the browser decodes them.
const framesOfGif = (bytes) =>
  page.evaluate(async (list) => {
    const decoder = new ImageDecoder({ data: Uint8Array.from(list), type: "image/gif" });
    await decoder.tracks.ready;
    const { frameCount, repetitionCount } = decoder.tracks.selectedTrack;
    const [frames, durations] = [[], []];
    for (let frameIndex = 0; frameIndex < frameCount; ++frameIndex) {
      const { image } = await decoder.decode({ frameIndex });
      const context = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext("2d");
      context.drawImage(image, 0, 0);
      frames.push(Array.from(context.getImageData(0, 0, image.displayWidth, image.displayHeight).data));
      durations.push(image.duration);
    }
    return { loops: String(repetitionCount), durations, frames };
  }, bytes);

test("a file that is saved has the picture", async () => {
  const state = { ...pictures[4], width: kWidth, height: kHeight };
  await setState(page, { ...state, file: "r32" });
  const file = await saved();
  assert.equal(file.name, "hashnoise-curl-seed7-values-40x32.r32");
  const words = Array.from(new Uint32Array(new Uint8Array(file.bytes).buffer));
  const rows = (list) => [...Array(kHeight).keys()].map((row) => list.slice(row * kWidth, (row + 1) * kWidth));
  assert.deepEqual(rows(words).toReversed(), rows(await pixels(page, kWidth, kHeight, true)));
  // A file of more pixels than one draw takes: each row has its own, in whatever part it is drawn.
  await setState(page, { ...state, file: "r16", width: 1024, height: 300 });
  const { bytes } = await saved();
  assert.equal(bytes.length, 1024 * 300 * 2);
  const lines = new Set([...Array(300).keys()].map((row) => bytes.slice(row * 2048, row * 2048 + 64).join()));
  assert.equal(lines.size, 300);
  // A GIF has so many strings that its table is full more than once.
  const turning = { ...usualState(), layers: [{ ...state.layers[0], noise: "perlin" }], frames: 3, map: "land" };
  await setState(page, { ...turning, file: "gif", dimensions: 2, cells: 90, width: 4 * kWidth, height: 4 * kHeight });
  const gif = await framesOfGif((await saved()).bytes);
  assert.deepEqual([gif.loops, gif.durations], ["Infinity", [40000, 40000, 40000]]);
  for (const [at, frame] of gif.frames.entries()) {
    await setState(page, { phase: (at + 1) / 3 });
    assert.deepEqual(turned(frame, 4), await pixels(page, 4 * kWidth, 4 * kHeight), `frame ${at}`);
  }
  // One with colours of layers has the nearest of its most frequent colours: cubes of eight.
  const tinted = stateOf("#sum=none&noise=cells&map=grey&file=gif&blend2=mask&sum2=none&noise2=cells&seed2=3&tint2=moss");
  await setState(page, { ...tinted, width: kWidth, height: kHeight });
  const { frames } = await framesOfGif((await saved()).bytes);
  const colours = turned(await pixels(page, kWidth, kHeight));
  assert.ok(frames[0].every((part, at) => at % 4 === 3 || Math.abs(part - colours[at]) <= 4));
  // The second click stops it.
  await setState(page, { ...turning, file: "gif" });
  const notes = await page.evaluate(async () => {
    const button = document.getElementById("save");
    window.hashnoise.controls.show(window.hashnoise.state);
    button.click();
    const label = button.textContent;
    button.click();
    while (button.textContent.startsWith("Stop")) await new Promise((resolve) => setTimeout(resolve, 10));
    return [label, document.getElementById("note-file").textContent, button.textContent];
  });
  assert.deepEqual(notes, ["Stop, 0 %", "The file is not saved. You have stopped it.", "Save GIF"]);
  await setState(page, { file: "heights", width: 8, height: 8 });
  assert.deepEqual((await saved()).bytes.slice(1, 4), [...Buffer.from("PNG")]);
});

test("a changed library is noticed", async () => {
  const broken = await opened(browser);
  await broken.evaluate(() => {
    const { library } = window.hashnoise;
    const changed = (text) => text.replaceAll("0x9E3779B9u", "0x9E3779B8u");
    for (const piece of library.pieces) piece.made = changed(piece.text);
  });
  await setState(broken, pictures[0]);
  await setState(page, pictures[0]);
  assert.notEqual(unequal(await pixels(broken, kWidth, kHeight, true), await pixels(page, kWidth, kHeight, true)), 0);
  const values = await pixels(page, kWidth, kHeight, true);
  assert.notEqual(wrongColours(values, await pixels(page, kWidth, kHeight), { ...pictures[0], map: "ember" }), 0);
  await broken.close();
});
