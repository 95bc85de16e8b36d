// A bundler keeps the used parts of the package, and each text once. Also: the arguments of a node and of wgsl.
//
//   node bundles.mjs
import assert from "node:assert/strict";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import test from "node:test";
import { gzipSync } from "node:zlib";
import { build } from "vite";

const folder = join(import.meta.dirname, "entries");
await mkdir(folder, { recursive: true });
let entries = 0;

/** The code that Vite makes of a module. */
async function bundled(code) {
  const input = join(folder, `${(entries += 1)}.js`);
  await writeFile(input, code);
  const made = await build({
    root: folder,
    configFile: false,
    logLevel: "error",
    build: { write: false, modulePreload: false, rollupOptions: { input, external: [/^three/], treeshake: true } },
  });
  return made.output.map((chunk) => chunk.code ?? "").join("");
}

const count = (text, part) => text.split(part).length - 1;

test("what is imported and not used is left out", async () => {
  const names = ["hashnoise", "hashnoise/glsl/hashnoise", "hashnoise/wgsl", "hashnoise/wgsl/fixed"];
  const code = await bundled(names.map((name, i) => `import * as unused${i} from "${name}";`).join("\n"));
  assert.ok(code.length < 100, code.slice(0, 300));
});

test("each text of GLSL is there once", async () => {
  const code = await bundled(`import fbm2d from "hashnoise/glsl/fbm2d";
import fbm3d from "hashnoise/glsl/fbm3d";
console.log(fbm2d, fbm3d);`);
  for (const guard of ["CONFIG", "ARITHMETIC", "OCTAVE", "FBM2D", "FBM3D", "PERLIN3D"]) {
    assert.equal(count(code, `#ifndef HN_${guard}_GLSL`), 1, guard);
  }
  assert.equal(count(code, "HN_CELLULAR2D_GLSL"), 0);
  console.log(`fbm2d and fbm3d: ${code.length} bytes`);
});

test("of WGSL and of nodes, a function brings what it needs", async () => {
  for (const name of ["hashnoise/wgsl", "hashnoise/wgsl/fixed", "hashnoise/tsl", "hashnoise/tsl/fixed"]) {
    const code = await bundled(`import { hn_perlin2 } from "${name}";\nconsole.log(hn_perlin2);`);
    assert.equal(count(code, "fn hn_perlin2("), 1, name);
    assert.equal(count(code, "fn hn_fbm2("), 0, name);
    assert.equal(count(code, "HN_FBM2D_GLSL"), 0, name);
    assert.equal(count(code, "#ifndef HN_PERLIN2D_GLSL"), name.includes("tsl") ? 1 : 0, name);
    console.log(`hn_perlin2 of ${name}: ${code.length} bytes`);
  }
});

test("a name in place of a function of WGSL is an error", async () => {
  const { hn_fbm2, wgsl } = await import("hashnoise/wgsl");
  assert.equal(count(wgsl(hn_fbm2), "fn hn_fbm2("), 1);
  assert.throws(() => wgsl("hn_fbm2"), /^TypeError: wgsl takes what you import from hashnoise\/wgsl, .*, not hn_fbm2$/);
});

test("the twin brings its module alone", async () => {
  const code = await bundled('import { Field } from "hashnoise";\nconsole.log(new Field(2).at(0.5, 0.5));');
  assert.equal(count(code, "HN_CONFIG_GLSL"), 0);
});

test("the documentation's sizes are those of bundles", async () => {
  const page = await readFile(join(import.meta.dirname, "page.md"), "utf8");
  const rows = [...page.matchAll(/^\| `(import (?:{ )?(\w+).*)` \| (\d+) kB \| (\d+) kB \|$/gm)];
  assert.equal(rows.length, 5);
  const wrong = [];
  for (const [, imported, name, size, zipped] of rows) {
    const code = await bundled(`${imported};\nconsole.log(${name});`);
    const found = [code.length, gzipSync(code).length].map((bytes) => bytes / 1000);
    console.log(`${imported}: ${found.map((one) => one.toFixed(1)).join(" and ")} kB`);
    if (found.some((one, i) => Math.abs([size, zipped][i] - one) > Math.max(0.05 * one, 0.5))) wrong.push([imported, ...found]);
  }
  assert.deepEqual(wrong, []);
});

test("what a node cannot take is named in a line", async () => {
  const { ivec2, uniform, vec2 } = await import("three/tsl");
  const { hn_fbm2, hn_fbm2_place, hn_tile2 } = await import("hashnoise/tsl");
  const p = vec2(1, 2);
  hn_fbm2(p, uniform(6, "int"), 2, uniform(0.5), 4294967295);
  hn_fbm2(p, 6, 2, 0.5, undefined);
  hn_fbm2_place(hn_tile2(p, ivec2(8, 8)), 6, 2, 0.5, 7);
  for (const [given, name, message] of [
    [[p, 6, 2, 0.5, -1], "RangeError", "hn_fbm2: seed has to be a whole number from 0 to 4294967295, not -1"],
    [[p, 6, 2, 0.5, 7.5], "RangeError", "hn_fbm2: seed has to be a whole number from 0 to 4294967295, not 7.5"],
    [[p, 6, 2, 0.5, 2 ** 32], "RangeError", "hn_fbm2: seed has to be a whole number from 0 to 4294967295, not 4294967296"],
    [[p, 6.5, 2, 0.5], "RangeError", "hn_fbm2: octaves has to be a whole number from -2147483648 to 2147483647, not 6.5"],
    [[p, 6, NaN, 0.5], "RangeError", "hn_fbm2: lacunarity has to be a finite number, not NaN"],
    [[p, 6, 2, 1e39], "RangeError", "hn_fbm2: gain has to be a number up to 3.4e38, not 1e+39"],
    [[p, "6", 2, 0.5], "TypeError", "hn_fbm2: octaves has to be a number or a node of three.js, and is of the type string"],
    [[p, 6, undefined, 0.5], "TypeError", "hn_fbm2: lacunarity has to be a number or a node of three.js, and is of the type undefined"],
    [[p, 6, 2, 0.5, null], "TypeError", "hn_fbm2: seed has to be a number or a node of three.js, and is of the type object"],
    [[1, 6, 2, 0.5], "TypeError", "hn_fbm2: p has to be a node of three.js, and is of the type number"],
    [[[1, 2], 6, 2, 0.5], "TypeError", "hn_fbm2: p has to be a node of three.js, and is of the type object"],
  ]) {
    assert.throws(() => hn_fbm2(...given), { name, message });
  }
});

test("a node lacks its seed at most, and that where GLSL lets it", async () => {
  const { vec2 } = await import("three/tsl");
  const { hn_fbm2, hn_perlin2_phase, hn_phasor2, hn_warp2 } = await import("hashnoise/tsl");
  hn_fbm2(vec2(1, 2), 6, 2, 0.5);
  hn_warp2(vec2(1, 2), 6, 2, 0.5, 1, 7);
  assert.throws(() => hn_fbm2(vec2(1, 2), 6, 2), /^TypeError: hn_fbm2 wants .* got 3 values$/);
  // Each lacks an argument before the seed.
  assert.throws(() => hn_warp2(vec2(1, 2), 6, 2, 0.5, 7), /^TypeError: hn_warp2 wants .* got 5 values$/);
  assert.throws(() => hn_phasor2(vec2(1, 2), vec2(3, 0), 7), /^TypeError: hn_phasor2 wants .* got 3 values$/);
  assert.throws(() => hn_perlin2_phase(vec2(1, 2), 7), /^TypeError: hn_perlin2_phase wants .* got 2 values$/);
});
