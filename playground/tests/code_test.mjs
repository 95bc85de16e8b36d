// The copied code: it compiles as it is, with the library in it and without, and draws what the page draws. (That of C++
// is what pixels_test.mjs compares pictures with.)
import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import test, { after, before } from "node:test";
import { kLanguages } from "../code.js";
import { kKinds, kWgslVertex } from "../export.js";
import { linkOf, stateOf } from "../links.js";
import { changed, hasDrift, mapsOf, usualState } from "../model.js";
import { hasCompiler, kCompiled, wordsOf, wordsOfJavaScript } from "./languages.mjs";
import { anyStates, kSteered, simpleStates } from "./states.mjs";
import { copiedCode, floatOf, inFolder, kRoot, launched, opened, pixels, run, setState } from "./support.mjs";

const kThorough = Boolean(process.env.HN_THOROUGH);
// Eighths of a cell from 0 on, so that both pattern(cell, f) and pattern(p) are exact.
const kWidth = 32;
const kHeight = 24;
const kClock = 1.5; // seconds since a whole shader began
const kOrigin = { x: BigInt(kWidth / 2) << 21n, y: BigInt(kHeight / 2) << 21n, cells: 3 };
const chosen = [
  { sum: "fbm", noise: "perlin" },
  { sum: "ridged", noise: "simplex", hash: "pcg", map: "land" },
  { sum: "none", noise: "cell_border", jitter: 0.5, period: 3, map: "signed" },
  { sum: "billow", noise: "cellular_between", metric: "chebyshev", octaves: 2 },
  { sum: "none", noise: "cells", map: "grey" },
  { sum: "eroded", noise: "simplex", dimensions: 3, z: 0.75, hash: "fnv1" },
  { sum: "none", noise: "perlin", dimensions: 3, z: -1.5, phase: 0.25, period: 5 },
  { sum: "ping_pong", noise: "value", warp: "warp", amplitude: 0.5, strength: 2.5, contrast: 2 },
  { sum: "clouds", noise: "value_cubic", dimensions: 1 },
  { sum: "weighted", noise: "simplex", dimensions: 4, z: 0.25, w: 1.5, arithmetic: "fast" },
  { sum: "clouds", dimensions: 3, z: 0.75, driftx: 0.5, drifty: -1.25, driftz: 0.375, time: 3 },
  { sum: "none", noise: "value", dimensions: 1, driftx: -0.5, time: 1, map: "land" },
  { sum: "fbm", noise: "cell_border" }, // of all loops the one with the most choices in it, each once a branch in browsers
];
const placed = (settings, state = usualState()) =>
  changed(changed(state, { arithmetic: "fixed" }), { ...settings, ...kOrigin });
// All that tools/pick has written is compiled in a thorough run. (In those the tests of tools/pick hold the bits of all
// functions to the C++ header.)
const picked = simpleStates().map((state) => changed(state, { z: 0.75, w: 1.5, ...kOrigin }));
// Every way to combine layers, with integers, and in a thorough run with floats.
const layered = (kThorough ? ["fixed", "fast"] : ["fixed"]).map((arithmetic) =>
  placed(
    { arithmetic, period: 3 },
    stateOf(
      "#sum=ridged&scale=2&driftx=0.25&time=2.5&blend2=multiply&drifty2=-3.5&noise2=simplex&weight2=0.3&offset2=-0.75&blend3=max&sum3=none&noise3=" +
        "cellular_between&weight3=-1.5&seed3=9&blend4=mix&sum4=billow&noise4=value&weight4=0.3&scale4=4" +
        "&driftx4=-0.5&blend5=mask&sum5=none&noise5=value&weight5=1.5&offset5=0.3&blend6=height&sum6=none&noise6=simplex&weight6=0.7" +
        "&tint4=moss&tint5=own&tints5=0-102030_70-f0e010&tint6=grey&blend7=slope&sum7=none&weight7=0.5&offset7=-0.4&tint7=land",
    ),
  ),
);
// In a thorough run fifty that nobody has chosen. The sum of a position and a shift rounds, which octaves, weights and jumps
// enlarge; so what is warped has few octaves, and a noise without jumps, and no layer of its picture a weight beyond 1.
const isJump = ({ noise }) => noise === "cells" || noise === "random";
const calm = (layer) => {
  if (layer.warp === "none" || isJump(layer)) return { ...layer, warp: "none" };
  return { ...layer, octaves: Math.min(layer.octaves, 2), lacunarity: 2, scale: 1, amplitude: Math.min(layer.amplitude, 1) };
};
const calmed = (layers) => {
  const most = layers.some((layer) => layer.warp !== "none" && !isJump(layer)) ? 1 : Infinity;
  return layers.map((layer) => calm({ ...layer, weight: Math.min(Math.max(layer.weight, -most), most) }));
};
const inEighths = (layer) => ({ ...layer, ...Object.fromEntries(["driftx", "drifty", "driftz"].map((name) => [name, Math.round(8 * layer[name]) / 16])) });
const any = (kThorough ? anyStates(50) : []).map((state) =>
  changed({ ...state, layers: calmed(state.layers).map(inEighths) }, { z: 0.75, w: 1.5, time: 2, ...kOrigin }),
);
const whole = [...chosen.map((settings) => placed(settings)), ...layered, placed({}, stateOf(kSteered)), ...any];
const states = [...whole, ...picked.filter((_, at) => at % 101 === 7)];

// A call of pattern() at the pixel, at a position or from a cell.
function call(language, state, cell) {
  const n = state.dimensions;
  const [float, int] = { glsl: ["vec", "ivec"], hlsl: ["float", "int"], wgsl: ["vec", "vec"] }[language];
  const ends = language === "wgsl" ? ["f", "i"] : ["", ""];
  const vector = (type, end, parts) => (n === 1 ? parts[0] : `${type}${n}${end}(${parts.slice(0, n).join(", ")})`);
  const [f32, i32] = language === "wgsl" ? ["f32", "i32"] : ["float", "int"];
  const places = [`${f32}(column) * 0.125`, `${f32}(row) * 0.125`, state.z.toFixed(4), state.w.toFixed(4)];
  const clock = hasDrift(state) ? `, ${state.time.toFixed(4)}` : "";
  if (!cell) return `pattern(${vector(float, ends[0], places)}${clock})`;
  const cells = ["column >> 3u", "row >> 3u", String(Math.floor(state.z)), String(Math.floor(state.w))];
  const rests = [
    `${f32}(column & 7${language === "wgsl" ? "u" : ""}) * 0.125`,
    `${f32}(row & 7${language === "wgsl" ? "u" : ""}) * 0.125`,
    (state.z - Math.floor(state.z)).toFixed(4),
    (state.w - Math.floor(state.w)).toFixed(4),
  ];
  const whole = cells.map((part, at) => (at < 2 ? `${i32}(${part})` : part));
  return `${language === "wgsl" ? "pattern_cell" : "pattern"}(${vector(int, ends[1], whole)}, ${vector(float, ends[0], rests)}${clock})`;
}

// Whether the forms of pattern() that a text has take a cell.
const formsOf = (code) => [true, false].filter((cell) => /pattern(_cell)?\((\w+ cell,|cell:)/.test(code) || !cell);
const callsOf = (language, code, state) => formsOf(code).map((cell) => call(language, state, cell)).join(" + ");
// Its colour: of the value, or of a position where layers have colours of their own.
const colourOf = (language, code, state) =>
  mapsOf(state).length > 1 ? callsOf(language, code, state).replaceAll("pattern", "colour") : `colour(${callsOf(language, code, state)})`;

// glslang's opinion of a shader.
const glslang = (text, name, ...options) =>
  inFolder(async (folder) => {
    await writeFile(join(folder, name), text);
    try {
      await run("glslangValidator", [...options, join(folder, name)]);
      return "";
    } catch (error) {
      return `${error.stdout}${error.stderr}`;
    }
  });

const glslShader = (code, state, version = "450") => {
  const es = version.endsWith("es")
    ? "precision mediump float;\nprecision mediump int;\n"
    : "#extension GL_GOOGLE_include_directive : require\nlayout(location = 0) ";
  return `#version ${version}\n${es.replace("layout", `${code}\nlayout`)}${version.endsWith("es") ? `${code}\n` : ""}out vec4 color;
void main() {
  int column = int(gl_FragCoord.x);
  int row = int(gl_FragCoord.y);
  color = vec4(${colourOf("glsl", code, state)}, 1.0);
}
`;
};
// The text as shadertoy.com completes it.
const onShadertoy = (code) => `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform vec3 iResolution;
uniform float iTime;
uniform vec4 iMouse;
${code}
out vec4 outColor;
void main() {
  vec4 color = vec4(1e20);
  mainImage(color, gl_FragCoord.xy);
  outColor = vec4(color.xyz, 1.0);
}
`;
const hlslShader = (code, state) => `${code}
float4 main(float4 position : SV_Position) : SV_Target {
  int column = int(position.x);
  int row = int(position.y);
  return float4(${colourOf("hlsl", code, state)}, 1.0f);
}
`;

let browser;
let page;
before(async () => {
  browser = await launched();
  page = await opened(browser);
});
after(() => browser.close());

// The picture of a fragment shader by WebGL2, in bytes; or the driver's message.
const drawn = (fragment) =>
  page.evaluate(
    async (text, width, height, clock) => {
      const { gpu } = window.hashnoise;
      try {
        const program = await gpu.build(text);
        gpu.gl.useProgram(program);
        gpu.gl.uniform2f(gpu.gl.getUniformLocation(program, "resolution"), width, height);
        for (const name of ["time", "iTime"]) gpu.gl.uniform1f(gpu.gl.getUniformLocation(program, name), clock);
        gpu.gl.uniform3f(gpu.gl.getUniformLocation(program, "iResolution"), width, height, 1);
        return Array.from(await gpu.read(program, new ArrayBuffer(0), width, height));
      } catch (error) {
        return error.message;
      }
    },
    fragment,
    kWidth,
    kHeight,
    kClock,
  );
// The words that a picture has as its bytes.
const wordsOfBytes = (found) => (Array.isArray(found) ? Array.from(new Uint32Array(Uint8Array.from(found).buffer)) : found);

// The bits of a function of the copied GLSL, where the user's own precision is the lowest; Godot's is the highest.
async function drawnGlsl(code, state, cell, precision = "mediump") {
  const found = await drawn(`#version 300 es
precision ${precision} float;
precision ${precision} int;
${code}
out highp vec4 bytes;
void main() {
  int column = int(gl_FragCoord.x);
  int row = int(gl_FragCoord.y);
  highp uint bits = floatBitsToUint(${call("glsl", state, cell)});
  bytes = vec4((uvec4(bits) >> uvec4(0u, 8u, 16u, 24u)) & 255u) / 255.0;
}
`);
  return wordsOfBytes(found);
}

// The picture of a whole shader in WGSL, from the lower row on, in bytes; or the messages of the compiler.
const drawnByWgsl = (text) =>
  page.evaluate(
    async (code, width, height, clock) => {
      const device = await (await navigator.gpu.requestAdapter()).requestDevice();
      const module = device.createShaderModule({ code });
      const { messages } = await module.getCompilationInfo();
      if (messages.length) return messages.map(({ message }) => message).join("\n");
      const { RENDER_ATTACHMENT, COPY_SRC } = GPUTextureUsage;
      const { UNIFORM, COPY_DST, MAP_READ } = GPUBufferUsage;
      const format = "rgba8unorm";
      const target = device.createTexture({ size: [width, height], format, usage: RENDER_ATTACHMENT | COPY_SRC });
      const fragment = { module, targets: [{ format }] };
      const pipeline = await device.createRenderPipelineAsync({ layout: "auto", vertex: { module }, fragment });
      const encoder = device.createCommandEncoder();
      const view = target.createView();
      const pass = encoder.beginRenderPass({ colorAttachments: [{ view, loadOp: "clear", storeOp: "store" }] });
      pass.setPipeline(pipeline);
      if (code.includes("resolution")) {
        const entries = [[width, height], ...(code.includes("> time:") ? [[clock]] : [])].map((numbers, binding) => {
          const buffer = device.createBuffer({ size: 8, usage: UNIFORM | COPY_DST });
          device.queue.writeBuffer(buffer, 0, new Float32Array(numbers));
          return { binding, resource: { buffer } };
        });
        pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
      }
      pass.draw(3);
      pass.end();
      const bytesPerRow = 256;
      const copy = device.createBuffer({ size: bytesPerRow * height, usage: COPY_DST | MAP_READ });
      encoder.copyTextureToBuffer({ texture: target }, { buffer: copy, bytesPerRow }, [width, height]);
      device.queue.submit([encoder.finish()]);
      await copy.mapAsync(GPUMapMode.READ);
      const bytes = copy.getMappedRange();
      const rowOf = (row) => new Uint8Array(bytes, (height - 1 - row) * bytesPerRow, width * 4);
      const found = Array.from({ length: height }, (_, row) => Array.from(rowOf(row))).flat();
      device.destroy();
      return found;
    },
    text,
    kWidth,
    kHeight,
    kClock,
  );

// The bits of a function of the copied WGSL. Its colours are compiled with it.
async function drawnWgsl(code, state, cell) {
  const colour = mapsOf(state).length > 1 ? call("wgsl", state, cell).replace("pattern", "colour") : "colour(0.0)";
  const found = await drawnByWgsl(
    `${code}
${kWgslVertex.join("\n")}
@fragment fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {
  let column = u32(position.x);
  let row = ${kHeight - 1}u - u32(position.y);
  return unpack4x8unorm(select(bitcast<u32>(${call("wgsl", state, cell)}), 0u, ${colour}.x > 2.0));
}
`,
  );
  return wordsOfBytes(found);
}

// As what a text is copied, how glslang takes it, and what is put around it.
const kGlslForms = [
  ["function", true, [], (code, state) => glslShader(code, state, "300 es")],
  ["function", false, ["-V"], glslShader],
  ["shader", true, [], (code) => code],
  ["desktop", true, [], (code) => code],
  ["shadertoy", true, [], onShadertoy],
];
const kHlslForms = [
  ["function", false, hlslShader],
  ["shader", true, (code) => code],
  ["function", true, hlslShader],
];

// One of the forms for each state; what was picked is in those that have what they call in them. In a default run states
// take turns, too: glslang takes a second for each text. Below, browsers compile them all.
const formOf = (forms, number) => {
  const possible = number < whole.length ? forms : forms.filter(([, whole]) => whole);
  return possible[(kThorough ? number : number >> 1) % possible.length];
};

test("copied GLSL and HLSL compile", async () => {
  const include = `-I${join(kRoot, "glsl")}`;
  const hlslOptions = ["-D", "-V", "--target-env", "vulkan1.1", "-S", "frag", "-e", "main", include];
  const compileHlsl = async (state, number) => {
    const [kind, whole, hlsl] = formOf(kHlslForms, number);
    const text = hlsl(await copiedCode(page, "hlsl", whole, kind), state);
    assert.equal(await glslang(text, "shader.hlsl", ...hlslOptions), "", `HLSL, ${kind}: ${linkOf(state)}`);
  };
  for (const [number, state] of (kThorough ? [...states, ...picked] : states).entries()) {
    await setState(page, state);
    if (kThorough || number % 2) await compileHlsl(state, number);
    if (!kThorough && number % 2) continue;
    const [kind, whole, options, glsl] = formOf(kGlslForms, number);
    const text = glsl(await copiedCode(page, "glsl", whole, kind), state);
    assert.equal(await glslang(text, "shader.frag", ...options, include), "", `${kind}: ${linkOf(state)}`);
    if (kind === "function") {
      assert.match(text, /^highp vec3 colours?\(highp float value\) \{$/m);
      assert.match(text, /^highp float pattern\(highp /m);
      // Nothing is declared with the precision of the user.
      const own = text.slice(text.lastIndexOf("// p ")).split(/\n(?:layout.*)?out vec4/)[0].replace(/\/\/.*/g, "");
      assert.doesNotMatch(own, /(?<!highp )\b(?:float|u?int|[iu]?vec[234]) [a-z]/);
    }
  }
});

// How many pixels have another colour. The page has one of 256, and its graph has an edge.
const unlike = (one, other) => {
  let count = 0;
  for (let at = 0; at < one.length; at += 4)
    if ([0, 1, 2].some((part) => Math.abs(one[at + part] - other[at + part]) > 6)) ++count;
  return count;
};

test("a whole shader draws the picture", async () => {
  for (const [number, state] of [
    { ...states[0], arithmetic: "fast", x: 1000000000n << 24n, y: -(1n << 55n) },
    { ...states[0], arithmetic: "fast" },
    { ...states[5], arithmetic: "fast", map: "land" },
    { ...states[5], map: "own", stops: "20-102030_60-506070_60-ff0000_80-00ff00" }, // with an edge
    { ...states[6], x: 7n - (1n << 55n), z: 5000.5 },
    states[7],
    states[8],
    { ...states[8], x: 1n << 50n },
    layered[0],
    states[11],
    { ...states[11], y: 1n << 50n, arithmetic: "fast" },
    { ...states[12], time: 0 },
    changed(stateOf("#sum=none&dimensions=3&lean=0.1"), { ...kOrigin, arithmetic: "fixed", z: 0.75 }),
    changed(stateOf("#sum=none&dimensions=4&lean=0.2"), { ...kOrigin, x: 1n << 45n, arithmetic: "fixed", z: 0.75 }),
  ].entries()) {
    await setState(page, { ...state, time: state.time + kClock });
    const shown = await pixels(page, kWidth, kHeight);
    assert.ok(unlike(shown, shown.toReversed()) > 100, `${linkOf(state)} shows next to nothing`);
    await setState(page, state);
    const most = state.dimensions === 1 ? 2 * kWidth : 4;
    const ways = [
      ["GLSL", async () => drawn(await copiedCode(page, "glsl", true, "shader"))],
      ["Shadertoy", async () => drawn(onShadertoy(await copiedCode(page, "glsl", true, "shadertoy")))],
      ["WGSL", async () => drawnByWgsl(await copiedCode(page, "wgsl", true, "shader"))],
    ];
    // In a default run each state is drawn in one of the three ways.
    for (const [name, draw] of kThorough ? ways : [ways[number % 3]]) {
      const found = await draw();
      assert.ok(Array.isArray(found), `${name}, ${linkOf(state)}: ${found}`);
      assert.ok(unlike(found, shown) <= most, `${name}, ${linkOf(state)}: ${unlike(found, shown)} pixels`);
    }
  }
  await setState(page, { ...states[0], x: 1n << 24n });
  const other = await drawn(await copiedCode(page, "glsl", true, "shader"));
  await setState(page, states[0]);
  assert.ok(unlike(other, await pixels(page, kWidth, kHeight)) > 100);
});

const kDrawn = { glsl: drawnGlsl, wgsl: drawnWgsl, godot: (...given) => drawnGlsl(...given, "highp") };

test("copied GLSL, WGSL and Godot's text draw the picture", async () => {
  for (const [number, state] of states.entries()) {
    await setState(page, state);
    const shown = await pixels(page, kWidth, kHeight, true);
    // In a default run each state is compiled in one of the languages.
    for (const language of kThorough ? Object.keys(kDrawn) : [number % 2 ? "wgsl" : "glsl"]) {
      const code = await copiedCode(page, language, true);
      for (const cell of formsOf(code)) {
        // At a position floats round the way to it, and so does the sum of a position and a shift.
        const same = cell || (state.arithmetic === "fixed" && state.layers.every(({ warp }) => warp === "none"));
        const exact = state.arithmetic === "fixed" && same;
        const drawn = await kDrawn[language](code, state, cell);
        assert.ok(Array.isArray(drawn), `${language}, ${linkOf(state)}: ${drawn}`);
        const off = Math.max(...drawn.map((word, at) => Math.abs(floatOf(word) - floatOf(shown[at]))));
        assert.ok(off <= (exact ? 0 : 1e-4), `${language}, ${linkOf(state)}: off by ${off}`);
        if (exact) assert.deepEqual(drawn, shown, `${language}, ${linkOf(state)}`);
      }
    }
  }
});

test("copied code of other languages computes the picture", async () => {
  for (const [number, given] of whole.entries()) {
    const state = { ...given, arithmetic: "fixed", hash: "lattice" };
    await setState(page, state);
    const shown = await pixels(page, kWidth, kHeight, true);
    const exact = state.layers.every(({ warp, noise }) => warp === "none" && noise !== "curl");
    // In a default run each language compiles one of them.
    const compilers = kThorough ? kCompiled : kCompiled.slice(number, number + 1);
    for (const language of ["javascript", ...compilers]) {
      if (language !== "javascript" && !(await hasCompiler(language))) continue;
      const code = await copiedCode(page, language, true);
      const words = await (language === "javascript" ? wordsOfJavaScript : wordsOf.bind(undefined, language))(code, state, kWidth, kHeight);
      const floats = [words, shown].map((list) => new Float32Array(new Uint32Array(list).buffer));
      const off = Math.max(...floats[0].map((value, at) => Math.abs(value - floats[1][at])));
      assert.ok(off <= (exact ? 0 : 1e-4), `${language}, ${linkOf(state)}: off by ${off}`);
    }
  }
  // Another number is noticed.
  await setState(page, whole[0]);
  const code = await copiedCode(page, "javascript", true);
  const words = (text) => wordsOfJavaScript(text, whole[0], kWidth, kHeight);
  assert.notDeepEqual(await words(code.replace(", 7)", ", 8)")), await words(code));
});

// Twenty links, in every language and as every kind of text.
const kLinked = Object.keys(kLanguages)
  .flatMap((language) => Object.keys(kKinds[language]).map((kind) => [language, kind]))
  .map(([language, kind], at) => [linkOf(whole[(at * 5) % whole.length]), language, kind]);

test("the text of a link is what the page copies, in a terminal, too: of twenty links", () =>
  inFolder(async (folder) => {
    assert.ok(kLinked.length >= 20, `${kLinked.length}`);
    const [version, pieces] = await page.evaluate(() => ["version", "pieces"].map((id) => document.getElementById(id).textContent));
    await writeFile(join(folder, "pieces"), pieces);
    const printer = join(kRoot, "playground", "text.mjs");
    const print = (...words) => run(process.execPath, [printer, join(folder, "pieces"), version, ...words], { maxBuffer: 1 << 24 });
    for (const [link, language, kind] of kLinked) {
      await page.evaluate((hash) => window.hashnoise.open(hash, ""), link);
      const copied = await copiedCode(page, language, true, kind);
      assert.equal((await print(language, kind, link)).stdout, copied, `${language}, ${kind}: ${link}`);
    }
    const [[link, language, kind]] = kLinked;
    assert.notEqual((await print(language, kind, `${link}&seed=8`)).stdout, (await print(language, kind, `${link}&seed=9`)).stdout);
    await assert.rejects(print(language, kind, "#blen2=add"), /does not know: blen2=add/);
    await assert.rejects(print("cobol", kind, link), /cobol is none of the page/);
    // The command, with the address of a page in front and another arithmetic.
    const picked = await run(join(kRoot, "tools", "pick"), ["a.html#seed=9&arithmetic=fast", "--language", "go", "--arithmetic", "fixed"]);
    assert.equal(picked.stdout, (await print("go", "function", "#seed=9&arithmetic=fixed")).stdout);
  }));

test("code that is wrong is noticed", async () => {
  const state = states[0];
  await setState(page, state);
  const code = await copiedCode(page, "glsl", true);
  assert.match(
    await glslang(glslShader(code.replace("hn_fbm(p", "hn_absent(p"), state), "shader.frag", "-V"),
    /hn_absent/,
  );
  const shown = await pixels(page, kWidth, kHeight, true);
  assert.notDeepEqual(await drawnGlsl(code.replaceAll(", 7u)", ", 8u)"), state, false), shown);
  const wgsl = await copiedCode(page, "wgsl", true);
  assert.match(await drawnWgsl(wgsl.replace("return hn_fbm2(p", "return hn_absent(p"), state, false), /hn_absent/);
  assert.notDeepEqual(await drawnWgsl(wgsl.replaceAll(", 7u)", ", 8u)"), state, false), shown);
  // The text of tools/pick with other arithmetic.
  await page.evaluate(() => {
    const { modules } = window.hashnoise.library;
    for (const key of Object.keys(modules)) modules[key] = modules[key.replace(" fixed ", " fast ")];
  });
  for (const found of [
    await drawnGlsl(await copiedCode(page, "glsl", true), state, false),
    await drawnWgsl(await copiedCode(page, "wgsl", true), state, false),
  ]) {
    assert.equal(found.length, shown.length); // it compiles
    assert.notDeepEqual(found, shown);
  }
});
