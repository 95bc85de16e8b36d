// A reader of KTX 2.0 that others wrote, ktx-parse (of three.js), reads what hn-bake writes.
//
//   node bake_ktx2_test.mjs PATH-OF-HN-BAKE     in a folder with three.js
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

const program = process.argv[2];
const three = createRequire(join(process.cwd(), "package.json")).resolve("three/examples/jsm/libs/ktx-parse.module.js");
const { read } = await import(pathToFileURL(three));
const folder = mkdtempSync(join(tmpdir(), "hashnoise-ktx2-"));
test.after(() => rmSync(folder, { recursive: true }));

const bake = (...words) => execFileSync(program, words, { cwd: folder });
const bytesOf = (name) => new Uint8Array(readFileSync(join(folder, name)));

/** Checks the file's header and its texels. */
function check(bytes, { vkFormat, size, components, is_float, planes }) {
  const file = read(bytes);
  const { pixelWidth, pixelHeight, pixelDepth, levels } = file;
  assert.deepEqual([pixelWidth, pixelHeight, pixelDepth], size);
  assert.deepEqual([file.vkFormat, file.faceCount, file.layerCount, file.supercompressionScheme], [vkFormat, 1, 0, 0]);
  const [descriptor] = file.dataFormatDescriptor;
  assert.equal(descriptor.colorModel, 1);
  assert.equal(descriptor.transferFunction, 1);
  assert.equal(descriptor.samples.length, components);
  const bits = is_float ? 32 : 16;
  descriptor.samples.forEach((sample, i) => {
    assert.equal(sample.bitOffset, i * bits);
    assert.equal(sample.bitLength, bits - 1);
    assert.equal(sample.channelType, (is_float ? 0xc0 : 0) + [0, 1, 2, 15][i]);
  });
  assert.match(file.keyValue.KTXwriter, /^hn-bake of hashnoise /);
  const record = JSON.parse(new TextDecoder().decode(file.keyValue.hashnoise).replace("\0", ""));
  assert.equal(record.components.length, components);
  const data = levels[0].levelData;
  const texels = data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength);
  const numbers = new (is_float ? Float32Array : Uint16Array)(texels);
  const points = planes.length / components;
  assert.equal(numbers.length, planes.length);
  planes.forEach((value, i) => assert.equal(numbers[(i % points) * components + Math.floor(i / points)], value));
}

test("floats", () => {
  bake("perlin_d", "--size", "5x4x3", "--format", "ktx2-float", "-o", "a.ktx2");
  bake("perlin_d", "--size", "5x4x3", "-o", "a.f32");
  const planes = new Float32Array(bytesOf("a.f32").buffer);
  const expected = { vkFormat: 109, size: [5, 4, 3], components: 4, is_float: true, planes };
  check(bytesOf("a.ktx2"), expected);
  // Another format, another byte of a texel, and a file that is cut off, are noticed.
  for (const offset of [12, bytesOf("a.ktx2").length - 2]) {
    const wrong = bytesOf("a.ktx2");
    wrong[offset] ^= 1;
    assert.throws(() => check(wrong, expected), `byte ${offset}`);
  }
  assert.throws(() => check(bytesOf("a.ktx2").slice(0, -4), expected));
});

test("words", () => {
  for (const [vkFormat, noise, size, components] of [[70, "fbm", [7], 1], [77, "cellular", [7, 5], 2],
    [84, "curl", [4, 3, 2], 3]]) {
    const words = [noise, "--size", size.join("x"), "--normalize"];
    bake(...words, "-o", "a.ktx2");
    bake(...words, "-o", "a.r16");
    const planes = new Uint16Array(bytesOf("a.r16").buffer);
    check(bytesOf("a.ktx2"), { vkFormat, size: [...size, 0, 0].slice(0, 3), components, is_float: false, planes });
  }
});
