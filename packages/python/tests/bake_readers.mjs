// Readers of KTX 2.0 and of EXR that others wrote, ktx-parse and the loader of three.js, read the files of a folder.
//
//   node bake_readers.mjs FOLDER     in a folder with three.js; prints in JSON what they find
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const { resolve } = createRequire(join(process.cwd(), "package.json"));
const three = (file) => import(pathToFileURL(resolve(`three${file}`)));
const { read } = await three("/examples/jsm/libs/ktx-parse.module.js");
const { EXRLoader } = await three("/examples/jsm/loaders/EXRLoader.js");
const { default: { FloatType } } = await three("");

const planesOf = (numbers, count) =>
  Array.from({ length: count }, (_, at) => Array.from(numbers).filter((__, i) => i % count === at));

function ktx2(bytes) {
  const file = read(bytes);
  const [descriptor] = file.dataFormatDescriptor;
  const count = descriptor.samples.length;
  const isFloat = file.vkFormat >= 100;
  const bits = isFloat ? 32 : 16;
  assert.deepEqual([file.faceCount, file.layerCount, file.supercompressionScheme, file.typeSize], [1, 0, 0, bits / 8]);
  assert.deepEqual([descriptor.colorModel, descriptor.transferFunction], [1, 1]);
  descriptor.samples.forEach((sample, i) => {
    assert.deepEqual([sample.bitOffset, sample.bitLength], [i * bits, bits - 1]);
    assert.equal(sample.channelType, (isFloat ? 0xc0 : 0) + [0, 1, 2, 15][i]);
  });
  assert.match(file.keyValue.KTXwriter, /^hashnoise /);
  const [{ levelData }] = file.levels;
  const texels = levelData.buffer.slice(levelData.byteOffset, levelData.byteOffset + levelData.byteLength);
  const numbers = new (isFloat ? Float32Array : Uint16Array)(texels);
  const size = [file.pixelWidth, file.pixelHeight || 1, file.pixelDepth || 1];
  assert.equal(numbers.length, size[0] * size[1] * size[2] * count);
  const record = JSON.parse(new TextDecoder().decode(file.keyValue.hashnoise).replace("\0", ""));
  return { form: file.vkFormat, record, planes: planesOf(numbers, count) };
}

function exr(bytes) {
  const { header, data, width, height } = new EXRLoader().setDataType(FloatType).parse(bytes.buffer);
  const names = header.channels.map(({ name }) => name);
  const order = ["Y", "R", "G", "B", "A"].filter((name) => names.includes(name));
  const rows = Array.from({ length: height }, (_, y) => Array.from(data.subarray(4 * width * y, 4 * width * (y + 1))));
  const planes = planesOf(rows.reverse().flat(), 4).slice(0, names.length);  // it has four colours, from below
  return { form: order.join(" "), record: JSON.parse(header.hashnoise), planes };
}

const folder = process.argv[2];
const names = readdirSync(folder).filter((name) => /\.(ktx2|exr)$/.test(name));
const found = names.map((name) => {
  const bytes = new Uint8Array(readFileSync(join(folder, name)));
  return [name, name.endsWith("exr") ? exr(new Uint8Array(bytes)) : ktx2(bytes)];
});
// A file that is cut off, and a format that does not go with its descriptor, are noticed.
const whole = new Uint8Array(readFileSync(join(folder, names.find((name) => name.endsWith("ktx2")))));
assert.throws(() => ktx2(whole.slice(0, -4)));
assert.throws(() => ktx2(Object.assign(new Uint8Array(whole), { 12: 77 })));
process.stdout.write(JSON.stringify(Object.fromEntries(found)));
