// The package in a project of Vite and in Chromium: three.js draws golden values, and what the documentation prints.
//
//   node browser.mjs GOLDEN    a folder of golden files
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { build, preview } from "vite";
import { Field } from "hashnoise";
import { launch, open } from "../chromium.mjs";
import { serve } from "./files.mjs";
import { bitsOf, meaning, read } from "./golden_values.mjs";

const [golden] = process.argv.slice(2);
const root = import.meta.dirname;
const policies = { "/strict.html": "script-src 'self'", "/open.html": "script-src 'self' 'wasm-unsafe-eval'" };
let server;
let browser;
let address;
let files; // of the project as they are, without Vite

before(async () => {
  await build({ root });
  server = await preview({ root, preview: { port: 0, host: "127.0.0.1" } });
  address = `http://127.0.0.1:${server.httpServer.address().port}/pages/`;
  // As Node.js finds packages: here, and above.
  files = await serve((path) => policies[path] ? `<meta http-equiv="Content-Security-Policy" content="${policies[path]}">`
    : readFile(join(root, path)).catch(() => readFile(join(root, "..", path))));
  browser = await launch({ protocolTimeout: 60_000 });
});
after(async () => {
  await browser?.close();
  await server?.close();
  files?.close();
});

async function page(path, at = address) {
  const opened = await open(browser, at + path);
  await opened.waitForFunction("globalThis.hashnoise").catch((error) => {
    throw new Error(`${error.message}\n${opened.complaints.join("\n")}`);
  });
  return opened;
}

// Evaluates a row of a golden file in GLSL, with the seed or with another one: its words are a, b, c and d.
const bodies = {
  "noise2d.perlin": (more) => `
    return uvec4(bits_of(hn_perlin(vec2(float_of(a.x), float_of(a.y)), a.z + ${more}u)), 0u, 0u, 0u);`,
  "fbm.ridged2_cell": (more) => `
    vec2 f = vec2(float_of(a.z), float_of(a.w));
    float n = hn_ridged(hn_place(ivec2(a.xy), f), int(b.x), float_of(b.y), float_of(b.z), b.w + ${more}u);
    return uvec4(bits_of(n), 0u, 0u, 0u);`,
  "noise3d.cellular": (more) => `
    vec2 n = hn_cellular(vec3(float_of(a.x), float_of(a.y), float_of(a.z)), a.w + ${more}u);
    return uvec4(bits_of(n.x), bits_of(n.y), 0u, 0u);`,
};

const differing = (file, results) =>
  file.rows.filter((row, i) => !row.expected.every((word, k) => word === results[i][k])).length;

test("three.js with WebGLRenderer has golden values, with the text from everywhere", async () => {
  const opened = await page("webgl.html");
  const ways = await opened.evaluate(() => hashnoise.ways);
  assert.deepEqual(ways, ["string", "raw", "included", "chunks"]);
  let rows = 0;
  for (const [id, body] of Object.entries(bodies)) {
    const file = read(golden, id);
    const inputs = file.rows.map((row) => row.inputs);
    const evaluated = (way, body) => opened.evaluate((...given) => hashnoise.evaluate(...given), way, body, inputs);
    for (const way of ways) {
      assert.equal(differing(file, await evaluated(way, body(0))), 0, `${way} of ${id}`);
      rows += inputs.length;
    }
    const wrong = differing(file, await evaluated("string", body(1)));
    assert.ok(wrong > inputs.length / 2, `another seed of ${id} is noticed in ${wrong} of ${inputs.length} rows`);
  }
  console.log(`${rows} rows in ${await browser.version()}`);
  assert.deepEqual(opened.complaints, []);
});

test("the documentation's materials for WebGLRenderer draw what Field computes", async () => {
  const opened = await page("webgl.html");
  const found = await opened.evaluate(() => hashnoise.materials());
  console.log("furthest, and with a mistake:", JSON.stringify(found));
  assert.deepEqual(Object.keys(found), ["string", "chunks", "included"]);
  for (const [name, [off, wrong]] of Object.entries(found)) {
    assert.ok(off <= 1, `${name} is off by ${off} of 255`);
    assert.ok(wrong > 2, `a mistake in ${name} is not noticed`);
  }
  const [off, wrong] = await opened.evaluate(() => hashnoise.land());
  console.log("furthest of the land, and with a mistake:", off, wrong);
  assert.ok(off <= 1 && wrong > 2, `${off}, ${wrong}`);
  assert.deepEqual(opened.complaints, []);
});

test("the documentation's heights are the same in Node.js and in a bundle", async () => {
  const opened = await page("webgl.html");
  const [right, wrong] = await opened.evaluate(() => hashnoise.twin());
  const { height, heights } = await import("./blocks/heights.js");
  const { here, tile } = await import("./blocks/world.js");
  const expected = { height, heights: Array.from(heights.slice(0, 300)), here, tile: Array.from(tile.slice(0, 300)) };
  assert.deepEqual(right, expected);
  for (const name of Object.keys(expected)) {
    if (name !== "tile") assert.notDeepEqual(wrong[name], expected[name], `a mistake in ${name} is not noticed`);
  }
});

test("a page whose policy forbids WebAssembly prints what to add to it", async () => {
  const expected = new Field(2).at(0.5, 0.25);
  for (const path of Object.keys(policies)) {
    const opened = await open(browser, `http://127.0.0.1:${files.address().port}${path}`);
    const found = await opened.evaluate(async () => {
      const { Field, init } = await import("/node_modules/hashnoise/index.js");
      const message = await init().catch((error) => error.message);
      try {
        return [message ?? null, new Field(2).at(0.5, 0.25)];
      } catch (error) {
        return [message, error.message];
      }
    });
    if (path === "/open.html") assert.deepEqual(found, [null, expected]);
    else for (const message of found) assert.match(message, /^this host compiles no WebAssembly .* add 'wasm-unsafe-eval' to the script-src/);
  }
});

/** The floats, integers and seeds of a golden row, as the page takes them. */
function split(file) {
  const floats = [];
  const integers = [];
  const seeds = [];
  for (const row of file.rows) {
    const given = { f32: [], i32: [] };
    file.inputs.forEach(([name, kind], k) => {
      if (name === "seed") seeds.push(row.inputs[k]);
      else given[kind].push(meaning(kind, row.inputs[k]));
    });
    floats.push(...given.f32, ...Array(4 - given.f32.length).fill(0));
    integers.push(...given.i32, ...Array(4 - given.i32.length).fill(0));
  }
  return [floats, integers, seeds];
}

for (const [path, backend] of [["webgpu.html", "WebGPU"], ["webgpu.html?webgl", "WebGL2"]]) {
  test(`nodes of three.js have golden values with ${backend}`, async () => {
    const opened = await page(path);
    assert.equal(await opened.evaluate(() => hashnoise.backend), backend);
    let rows = 0;
    for (const id of await opened.evaluate(() => hashnoise.rows)) {
      const file = read(golden, id);
      const given = split(file);
      const evaluated = (...all) => opened.evaluate((...one) => hashnoise.evaluate(...one), id, ...all);
      const component = id === "noise2d.cellular" ? 1 : 0;
      const off = (results) => file.rows.filter((row, i) => bitsOf(results[i]) !== row.expected[component]).length;
      assert.equal(off(await evaluated("fixed", ...given)), 0, id);
      assert.ok(off(await evaluated("fast", ...given)) > file.rows.length / 4, `${id} in floats does not differ from HN_FIXED`);
      rows += file.rows.length;
    }
    console.log(`${rows} rows with ${backend}`);
    const [right, wrong] = await opened.evaluate(() => hashnoise.materials());
    console.log("furthest, and with a mistake:", right, wrong);
    assert.ok(right <= 1, `the documentation's material is off by ${right} of 255`);
    assert.ok(wrong > 2, "a mistake in it is not noticed");
    const counts = await opened.evaluate(() => hashnoise.dither());
    assert.deepEqual(Object.keys(counts), ["100", "101"]);
    const part = counts[101] / (counts[100] + counts[101]); // the pass keeps colors in half floats
    assert.ok(Math.abs(part - 0.25) < 0.03, `the documentation's dither makes ${JSON.stringify(counts)}`);
    assert.deepEqual(opened.complaints, []);
  });
}

for (const [path, backend] of [["bits.html", "WebGPU"], ["bits.html?webgl", "WebGL2"]]) {
  test(`nodes of tools/pick have the bits of Field with ${backend}, without a build step`, async () => {
    const opened = await page(path, `http://127.0.0.1:${files.address().port}/picked/`);
    assert.equal(await opened.evaluate(() => hashnoise.backend), backend);
    const points = Array.from({ length: 64 }, (_, i) => [i * 0.37 - 11, 5 - i * 0.61].map(Math.fround));
    const of = (settings) => points.map((p) => bitsOf(new Field(2, settings).at(...p)));
    const expected = {
      fbm: of({ fractal: "fbm", octaves: 6, seed: 7 }), fbmOfSeedZero: of({ fractal: "fbm", octaves: 6 }),
      tile: of({ noise: "perlin", period: [8, 5], seed: 7 }),
    };
    for (const [name, bits] of Object.entries(expected)) {
      const results = await opened.evaluate((...given) => hashnoise.evaluate(...given), name, points);
      assert.deepEqual(results.map(bitsOf), bits, name);
    }
    assert.notDeepEqual(expected.fbm, expected.fbmOfSeedZero);
    assert.deepEqual(opened.complaints, []);
  });
}

test("the documentation's page without a build step draws what Field computes", async () => {
  const found = [];
  for (const name of ["page.html", "wrong.html"]) {
    const opened = await open(browser, "about:blank");
    await opened.evaluateOnNewDocument(() => Object.defineProperty(navigator, "gpu", { value: undefined })); // WebGL2 is seen
    await opened.goto(`http://127.0.0.1:${files.address().port}/picked/${name}`);
    const canvas = await opened.waitForSelector("canvas");
    await opened.waitForNetworkIdle();
    const png = await canvas.screenshot({ encoding: "base64" });
    found.push(await opened.evaluate(async (text) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob());
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context.drawImage(image, 0, 0);
      return Array.from({ length: 512 / 16 }, (_, i) => context.getImageData(16 * i, 16 * i, 1, 1).data[0]);
    }, png));
  }
  const field = new Field(2, { fractal: "fbm", octaves: 6, seed: 7 });
  const shown = (v) => 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055); // sRGB
  const expected = found[0].map((_, i) => {
    const at = (8 * (16 * i + 0.5)) / 512;
    return shown(Math.min(Math.max(0.5 + field.at(at, 8 - at), 0), 1));
  });
  const off = found.map((pixels) => Math.max(...pixels.map((pixel, i) => Math.abs(pixel - expected[i]))));
  console.log("furthest, and with a mistake:", ...off);
  assert.ok(off[0] <= 1.5 && off[1] > 3, off.join(", "));
});

test("the documentation's WGSL draws what Field computes", async () => {
  const opened = await page("webgpu.html");
  const [right, wrong] = await opened.evaluate(() => hashnoise.code());
  console.log("furthest, and with a mistake:", right, wrong);
  assert.ok(right <= 1 && wrong > 2);
});
