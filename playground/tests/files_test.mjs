// The files that are saved, without a browser: read back by other code than wrote them.
import assert from "node:assert/strict";
import test from "node:test";
import { crc32, inflateSync } from "node:zlib";
import { fileOf, framesOf, heightsOf, linkInFile, nameOfFile, normalsOf } from "../files.js";
import { linkOf, stateOf } from "../links.js";
import { changed, possible, rangeOf, settingsOf, usualState } from "../model.js";

// The parts of a PNG, and its pixels as it has them, without the filter; throws for a checksum that is wrong.
function readPng(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  assert.deepEqual([...bytes.subarray(0, 8)], [...Buffer.from("\x89PNG\r\n\x1a\n", "latin1")]);
  const found = {};
  for (let at = 8; at < bytes.length; ) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    found[type] = bytes.subarray(at + 8, at + 8 + length);
    assert.equal(view.getUint32(at + 8 + length), crc32(bytes.subarray(at + 4, at + 8 + length)), `checksum of ${type}`);
    at += length + 12;
  }
  assert.deepEqual(Object.keys(found), ["IHDR", "tEXt", "IDAT", "IEND"]);
  const header = new DataView(found.IHDR.buffer, found.IHDR.byteOffset, 13);
  const [width, height] = [header.getUint32(0), header.getUint32(4)];
  const [depth, kind, ...rest] = [...found.IHDR.subarray(8)];
  assert.deepEqual(rest, [0, 0, 0]);
  const pixel = (depth / 8) * { 0: 1, 2: 3 }[kind];
  const lines = inflateSync(found.IDAT);
  assert.equal(lines.length, height * (width * pixel + 1));
  const pixels = [];
  for (let row = 0; row < height; ++row) {
    const line = lines.subarray(row * (width * pixel + 1));
    assert.equal(line[0], 1);
    for (let at = 0; at < width * pixel; ++at)
      pixels.push(at < pixel ? line[1 + at] : (line[1 + at] + pixels.at(-pixel)) & 255);
  }
  return { width, height, depth, kind, pixels, comment: Buffer.from(found.tEXt).toString("latin1") };
}

// A picture whose pixel (x, y), counted from below, has the value (97 x - 211 y) / 65536.
const valueOf = (x, y) => (97 * x - 211 * y) / 65536;
function reader(width, asked = []) {
  return async (mode, first, rows) => {
    asked.push([mode, first, rows]);
    const bytes = new DataView(new ArrayBuffer(width * rows * 4));
    for (let row = 0; row < rows; ++row)
      for (let x = 0; x < width; ++x) {
        if (mode) bytes.setFloat32((row * width + x) * 4, valueOf(x, first + row), true);
        else bytes.setUint32((row * width + x) * 4, ((x & 255) << 24) | (((first + row) & 255) << 16) | (7 << 8) | 255);
      }
    return new Uint8Array(bytes.buffer);
  };
}
const saved = async (state, asked) => {
  const file = await fileOf(state, reader(state.width, asked));
  return { file, bytes: new Uint8Array(await file.arrayBuffer()) };
};
const stateFor = (settings) => possible(changed(usualState(), { width: 600, height: 450, ...settings }));

test("a PNG has the colours, the upper row first, and the link", async () => {
  const asked = [];
  const { file, bytes } = await saved(stateFor({ file: "colours", seed: 9 }), asked);
  const { width, height, depth, kind, pixels, comment } = readPng(bytes);
  assert.deepEqual([width, height, depth, kind, file.name, file.type],
                   [600, 450, 8, 2, "hashnoise-fbm-perlin-seed9-600x450.png", "image/png"]);
  for (const [x, y] of [[0, 0], [599, 0], [0, 449], [301, 13], [17, 440]]) {
    const at = ((449 - y) * 600 + x) * 3;
    assert.deepEqual(pixels.slice(at, at + 3), [x & 255, y & 255, 7], `${x}, ${y}`);
  }
  // A large picture comes in parts, each row once.
  assert.deepEqual(asked, [[0, 14, 436], [0, 0, 14]]);
  assert.equal(comment, "Comment\0hashnoise #seed=9&width=600&height=450");
  assert.equal(settingsOf(stateOf(comment.split(" ")[1])).seed, 9);
});

test("heights are the whole numbers of the page's description", async () => {
  const state = stateFor({ file: "heights", contrast: 0.8 });
  const { depth, kind, pixels } = readPng((await saved(state)).bytes);
  assert.deepEqual([depth, kind], [16, 0]);
  const raw = new DataView((await saved({ ...state, file: "r16" })).bytes.buffer);
  const values = new DataView((await saved({ ...state, file: "r32" })).bytes.buffer);
  const [low, high] = rangeOf(state).map((end) => BigInt(Math.round(end * 2 ** 20)));
  const seen = new Set();
  for (let at = 0; at < 600 * 450; at += 7) {
    const value = valueOf(at % 600, 449 - Math.floor(at / 600));
    assert.equal(values.getFloat32(at * 4, true), value);
    const d = BigInt(Math.floor(value * 2 ** 20)) - low;
    const height = d < 0n ? 0n : d >= high - low ? 65535n : (d * 65536n) / (high - low);
    assert.equal(pixels[2 * at] * 256 + pixels[2 * at + 1], Number(height), `${value}`);
    assert.equal(raw.getUint16(at * 2, true), Number(height));
    seen.add(height);
  }
  assert.ok(seen.size > 10000 && seen.has(0n));
  assert.deepEqual([...heightsOf([-9, 9], state)], [0, 65535]);
});

test("a loop comes back to where it was", async () => {
  const loop = (settings) => framesOf(stateFor({ file: "gif", frames: 4, ...settings }));
  assert.deepEqual(loop({ sum: "none" }).map(({ phase }) => phase), [0.25, 0.5, 0.75, 1]);
  assert.deepEqual(loop({ dimensions: 3, period: 4, z: 0.5 }).map(({ z }) => z), [1.5, 2.5, 3.5, 4.5]);
  assert.deepEqual(loop({ dimensions: 4, period: 2, w: 0 }).map(({ w }) => w), [0.5, 1, 1.5, 2]);
  assert.equal(loop({ dimensions: 3 }).length, 1);
  const frame = [];
  const state = stateFor({ file: "gif", frames: 3, sum: "none", contrast: 0.8 });
  const read = reader(600);
  const file = await fileOf(state, (mode, first, rows, { phase }) => frame.push(phase) && read(mode, first, rows));
  assert.deepEqual([frame, file.name, file.type],
                   [[1, 1, 2, 2, 3, 3].map((part) => part / 3), "hashnoise-perlin-seed7-loop-600x450.gif", "image/gif"]);
  const large = { ...state, frames: 200, width: 8192, height: 8192 };
  await assert.rejects(fileOf(large, read), /at most 400 million pixels/);
});

test("a slope becomes a colour of a normal map", () => {
  const state = possible({ ...usualState(), file: "normals", steep: 0.5, cells: 1 });
  const [low, high] = rangeOf(state);
  // Values that rise to the right by one height of the colours in two pixels, with one more on each side; 45 degrees.
  const ramp = Float32Array.from({ length: 16 }, (_, at) => low + ((high - low) * (at % 4)) / 2);
  assert.deepEqual([...normalsOf(ramp, state, 2, 2, 4)].slice(0, 3), [37, 128, 218]);
  const flat = new Float32Array(16).fill(0.25);
  assert.deepEqual([...normalsOf(flat, state, 2, 2, 4)], Array(4).fill([128, 128, 255]).flat());
  const up = Float32Array.from({ length: 16 }, (_, at) => -Math.floor(at / 4)); // the upper row comes first
  assert.ok(normalsOf(up, state, 2, 2, 4)[1] < 128);
});

test("names distinguish files, and a file brings its setting back", async () => {
  const state = stateFor({ seed: 12, file: "heights" });
  assert.equal(nameOfFile(state), "hashnoise-fbm-perlin-seed12-heights-600x450.png");
  for (const [link, name] of [
    ["#seed=21&octaves=9&view=terrain&tilt=0.2&steep=0.3&sea=0.4&map=land&sum2=none&noise2=middle&blend2=add", "island-seed21"],
    ["#seed=3&blend2=add&sum2=none&noise2=cell_border&blend3=add&sum3=ridged&blend4=add", "fbm-cell-border-ridged-seed3"],
    ["#sum=none&noise=value_cubic", "value-cubic-seed7"],
  ])
    assert.equal(nameOfFile(stateOf(link)), `hashnoise-${name}-1024x1024.png`);
  const kinds = ["colours", "heights", "normals", "tiff", "gif", "r16", "r32", "json"];
  assert.equal(new Set(kinds.map((file) => nameOfFile({ ...state, file }))).size, kinds.length);
  for (const file of ["json", "colours"]) {
    const made = await fileOf({ ...state, file, width: 4, height: 3 }, async (_, first, rows) => new Uint8Array(4 * 4 * rows));
    assert.equal(linkOf(stateOf(await linkInFile(made))), linkOf({ ...state, file, width: 4, height: 3 }));
  }
  assert.equal(await linkInFile(new File(["something else"], "other.json")), undefined);
});

test("a TIFF has the values of the picture as floats", async () => {
  const values = Float32Array.from({ length: 6 }, (_, at) => at - 2.5);
  const state = possible({ ...usualState(), file: "tiff", width: 3, height: 2 });
  const file = await fileOf(state, async () => new Uint8Array(values.buffer.slice(0)));
  const view = new DataView(await file.arrayBuffer());
  const tags = new Map(
    Array.from({ length: view.getUint16(8, true) }, (_, at) => 10 + 12 * at).map((at) => [view.getUint16(at, true), view.getUint32(at + 8, true)]),
  );
  assert.deepEqual([view.getUint32(0), view.getUint32(4, true)], [0x49492a00, 8]);
  assert.deepEqual([256, 257, 258, 279, 339].map((tag) => tags.get(tag)), [3, 2, 32, 24, 3]);
  const start = tags.get(273);
  assert.equal(view.byteLength, start + 24);
  assert.equal(view.getFloat32(start, true), values[3]); // the upper row comes first
});

test("a file that is wrong is noticed", async () => {
  const { bytes } = await saved(stateFor({ file: "heights", width: 5, height: 3 }));
  readPng(bytes);
  for (const at of [0, 17, 24, 60, bytes.length - 20]) {
    const wrong = bytes.slice();
    wrong[at] ^= 4;
    assert.throws(() => readPng(wrong), undefined, `byte ${at}`);
  }
});
