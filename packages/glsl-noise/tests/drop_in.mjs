// The package in place of glsl-noise: glslify finds it by that name, and Vite by the aliases of its page, also in drei.
//
//   node drop_in.mjs
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { build, preview } from "vite";
import { launch, open } from "./chromium.mjs";
import all from "./all.js";
import drei from "./drei.js";

const root = import.meta.dirname;
const ours = "0x9E3779B1";
const theirs = "mod289";
let browser;

before(async () => {
  browser = await launch();
});
after(async () => browser?.close());

/** The bundle of the page, its picture, what it imported, and the complaints, with these aliases. */
async function drawn(name, ...alias) {
  const outDir = join(root, "built", name);
  const made = await build({
    root,
    configFile: false,
    logLevel: "error",
    resolve: { alias },
    build: { outDir, emptyOutDir: true, chunkSizeWarningLimit: 4000 },
  });
  const server = await preview({ root, configFile: false, build: { outDir }, preview: { port: 0, host: "127.0.0.1" } });
  try {
    const page = await open(browser, `http://127.0.0.1:${server.httpServer.address().port}/`);
    await page.waitForFunction("globalThis.drawn");
    const pixels = await page.evaluate(() => globalThis.drawn());
    const imported = await page.evaluate(() => globalThis.imported);
    const code = made.output.map((one) => one.code ?? "").join("");
    // React Three Fiber uses what three.js deprecates: that is no fault of a shader.
    return { code, pixels, imported, complaints: page.complaints.filter((text) => !text.startsWith("THREE.Clock")) };
  } finally {
    await server.close();
  }
}

const lit = (pixels) => pixels.filter((value, i) => i % 4 === 0 && value > 0).length;
const differing = (one, other) => one.filter((value, i) => i % 4 === 0 && value !== other[i]).length;

test("drei draws with it by the alias of the page, and with its own noise without", async () => {
  const { alias } = drei.resolve;
  const before = await drawn("before");
  const after = await drawn("after", ...alias);
  const wrong = await drawn("wrong", { ...alias[0], replacement: join(root, "wrong.js") });
  assert.deepEqual([before.complaints, after.complaints], [[], []]);
  // drei has the text inside, and the page's own import is another.
  assert.ok(before.code.includes(theirs) && !after.code.includes(theirs));
  assert.ok(after.code.split(ours).length > before.code.split(ours).length);
  for (const { pixels } of [before, after]) assert.ok(lit(pixels) > 1000, `${lit(pixels)} pixels of the sphere`);
  assert.ok(differing(before.pixels, after.pixels) > 100);
  // About as large, as the noise has the same contrast.
  assert.ok(
    Math.abs(lit(after.pixels) / lit(before.pixels) - 1) < 0.5,
    `${lit(after.pixels)} pixels of the sphere, and ${lit(before.pixels)} before`,
  );
  assert.notDeepEqual(wrong.complaints, [], "a shader that does not compile is not noticed");
});

test("Vite finds it by its own name, with the alias for all imports", async () => {
  assert.ok(existsSync(join(root, "node_modules", "hashnoise-glsl-noise", "simplex", "3d.glsl")));
  const { imported, complaints } = await drawn("all", ...all.resolve.alias);
  assert.match(imported, /^\/\/ float snoise\(vec3 p\), of hashnoise/);
  assert.deepEqual(complaints, []);
});

test("glslify finds the files by the name of glsl-noise, and what it makes of one and of all compiles", async () => {
  const glslify = createRequire(import.meta.url)("glslify");
  const page = await browser.newPage();
  const compiled = (text) =>
    page.evaluate((source) => {
      const gl = document.createElement("canvas").getContext("webgl2");
      const made = gl.createShader(gl.FRAGMENT_SHADER);
      gl.shaderSource(made, source);
      gl.compileShader(made);
      return gl.getShaderInfoLog(made);
    }, text);
  const files = ["simplex", "classic", "periodic"].flatMap((name) => [2, 3, 4].map((axes) => ({ name, axes })));
  const shaderOf = (some) => {
    const required = some.map(
      ({ name, axes }) => `#pragma glslify: ${name}${axes} = require(glsl-noise/${name}/${axes}d)`,
    );
    const calls = some.map(
      ({ name, axes }) => `${name}${axes}(vec${axes}(x)${name === "periodic" ? `, vec${axes}(7.0)` : ""})`,
    );
    return `#version 300 es\n${glslify.compile(`precision mediump float;\nuniform float x;\nout vec4 color;
${required.join("\n")}\nvoid main() { color = vec4(${calls.join(" + ")}); }`)}`;
  };
  for (const some of [...files.map((file) => [file]), files]) {
    const shader = shaderOf(some);
    assert.ok(shader.includes(ours) && !shader.includes(theirs));
    assert.equal(await compiled(shader), "", some.map(({ name, axes }) => `${name}/${axes}d`).join());
    assert.notEqual(await compiled(shader.replace("floor", "flour")), "");
  }
});
