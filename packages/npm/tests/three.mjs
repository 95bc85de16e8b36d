// The scenes of examples/three, made as docs/guide/javascript.md describes, in Chromium with WebGPU and with WebGL2.
//
//   node three.mjs ROOT    the repository
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { Field } from "hashnoise";
import { launch, open } from "../chromium.mjs";
import { serve } from "./files.mjs";
import { bitsOf } from "./golden_values.mjs";

const [repository] = process.argv.slice(2);
const WIDTH = 128; // a row of this width needs no padding in WebGPU
const HEIGHT = 80;
let folder;
let files;
let browser;

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "three-"));
  const page = await readFile(join(repository, "docs", "guide", "javascript.md"), "utf8");
  const [, words] = page.match(/^ {4}hashnoise\/(tools\/pick .*) --out scenes\/noise\.js$/m);
  const [tool, ...options] = words.split(" ");
  execFileSync(join(repository, tool), [...options, "--out", join(folder, "noise.js")]);
  const ofCdn = /https:\/\/cdn\.jsdelivr\.net\/npm\/three@[\d.]+\//g;
  files = await serve(async (path) => {
    if (path.startsWith("/node_modules/")) return readFile(join(import.meta.dirname, "..", path));
    if (path === "/noise.js") return readFile(join(folder, path));
    const text = await readFile(join(repository, "examples", "three", path), "utf8");
    if (path === "/index.html") assert.equal(text.match(ofCdn).length, 4);
    return text.replaceAll(ofCdn, "/node_modules/three/");
  });
  // A processor that draws a GPU's work takes seconds.
  browser = await launch({ protocolTimeout: 300_000, args: ["--disable-gpu-watchdog"] });
});
after(async () => {
  await browser?.close();
  files?.close();
  await rm(folder, { recursive: true, force: true });
});

/** A page whose loop has ended. */
async function page(query) {
  const opened = await open(browser, "about:blank");
  await opened.setViewport({ width: WIDTH, height: HEIGHT });
  await opened.goto(`http://127.0.0.1:${files.address().port}/index.html?${query}`);
  await opened.evaluate(async (width, height) => {
    const { RenderTarget, Scene } = await import("three/webgpu");
    const { Fn, instanceIndex, instancedArray } = await import("three/tsl");
    const { camera, renderer, scene } = await import("./main.js");
    renderer.setAnimationLoop(null);
    const target = new RenderTarget(width, height);
    globalThis.test = {
      backend: renderer.backend.isWebGPUBackend ? "WebGPU" : "WebGL2",
      /** The bytes of a picture of the scene, or of nothing. */
      async draw(isEmpty) {
        renderer.setRenderTarget(target);
        renderer.render(isEmpty ? new Scene() : scene, camera);
        renderer.setRenderTarget(null);
        return Array.from(await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height));
      },
      /** The first number of a function that a module of the page exports, at points of four coordinates. */
      async evaluate(module, name, axes, points) {
        const { [name]: called } = await import(module);
        const at = instancedArray(new Float32Array(points.flat()), "vec4");
        const result = instancedArray(points.length, "float");
        const kernel = Fn(() => {
          const value = called(at.element(instanceIndex)[axes]);
          result.element(instanceIndex).assign(name === "waves" ? value.x : value);
        })().compute(points.length);
        await renderer.computeAsync(kernel);
        const found = new Float32Array(await renderer.getArrayBufferAsync(result.value));
        return Array.from(found.subarray(0, points.length));
      },
    };
  }, WIDTH, HEIGHT);
  return opened;
}

/** How many colors there are. */
const colors = (bytes) =>
  new Set(Array.from({ length: bytes.length / 4 }, (_, i) => bytes.slice(4 * i, 4 * i + 3).join())).size;

/** How far two pictures are apart in the mean, of 255. */
const apart = (one, other) => one.reduce((sum, byte, i) => sum + Math.abs(byte - other[i]), 0) / one.length;

const scenes = {
  terrain: { name: "height", axes: "xy", moves: false,
    at: (field, [x, y]) => field.at(0.375 * x, 0.375 * y),
    settings: [2, { fractal: "eroded", octaves: 10, strength: 1 }] },
  clouds: { name: "density", axes: "xyz", moves: true, at: (field, [x, y, z]) => field.at(x, y, z),
    settings: [3, { fractal: "clouds", octaves: 8, gain: 0.55 }] },
  water: { name: "waves", axes: "xyz", moves: true, at: (field, [x, y, z]) => field.all(x, y, z)[0],
    settings: [3, { fractal: "fbm_d", octaves: 5, gain: 0.42 }] },
};
const points = Array.from({ length: 64 }, (_, i) => [i * 0.37 - 11, 5 - i * 0.61, 2 ** (i % 10), 0].map(Math.fround));
const drawn = {};

for (const [backend, query] of [["WebGPU", ""], ["WebGL2", "&webgl"]]) {
  for (const [name, { name: exported, axes, moves, at, settings: [dimensions, settings] }] of Object.entries(scenes)) {
    test(`${name} is drawn by ${backend}, with the heights of Field`, async () => {
      const opened = await page(name + query);
      assert.equal(await opened.evaluate(() => test.backend), backend);
      const picture = await opened.evaluate(() => test.draw());
      assert.ok(colors(picture) > 1000, `${name} has ${colors(picture)} colors`);
      await new Promise((resolve) => setTimeout(resolve, 500));
      const later = await opened.evaluate(() => test.draw());
      assert.equal(apart(picture, later) > 0, moves, `${name} ${moves ? "stands still" : "moves"}`);
      assert.equal(colors(await opened.evaluate(() => test.draw(true))), 1, "an empty scene has one color");
      if (!moves) (drawn[name] ??= []).push(picture);

      const given = [`./${name}.js`, exported, axes, points];
      const found = await opened.evaluate((...all) => test.evaluate(...all), ...given);
      const expected = (seed) => points.map((p) => bitsOf(at(new Field(dimensions, { ...settings, seed }), p)));
      assert.deepEqual(found.map(bitsOf), expected(7));
      assert.notDeepEqual(expected(8), expected(7));
      assert.deepEqual(opened.complaints, []);
      await opened.close();
    });
  }
}

test("the land is the same with WebGPU and with WebGL2", () => {
  const [one, upsideDown] = drawn.terrain; // OpenGL begins at the bottom
  const row = 4 * WIDTH;
  const from = (y) => upsideDown.slice(row * (HEIGHT - 1 - y), row * (HEIGHT - y));
  const other = Array.from({ length: HEIGHT }, (_, y) => from(y)).flat();
  console.log("apart, and upside down:", apart(one, other), apart(one, upsideDown));
  assert.ok(apart(one, other) < 1 && apart(one, upsideDown) > 20);
});
