// A page with WebGPURenderer computes in WGSL, or in GLSL where `?webgl` forces the fallback.
import { DataTexture, LinearSRGBColorSpace, MeshBasicNodeMaterial, Mesh, OrthographicCamera, PlaneGeometry, RenderTarget,
  Scene, SRGBColorSpace, WebGPURenderer } from "three/webgpu";
import { Fn, instanceIndex, instancedArray, ivec2, vec2, vec3 } from "three/tsl";
import { Field } from "hashnoise";
import * as fast from "hashnoise/tsl";
import * as fixed from "hashnoise/tsl/fixed";
import { material as ofNodes } from "../blocks/nodes.js";
import { material as wrongNodes } from "../faulty/nodes.js";
import { pipeline } from "../blocks/random.js";
import { code } from "../blocks/wgsl.js";
import { code as wrongCode } from "../faulty/wgsl.js";
import { furthest, gray, SIDE } from "./furthest.js";

const renderer = new WebGPURenderer({ forceWebGL: location.search === "?webgl" });
await renderer.init();

// The rows of golden files that are evaluated: from floats x, integers i and the seed.
const rows = {
  "noise2d.perlin": (noise, x, i, seed) => noise.hn_perlin2(vec2(x.x, x.y), seed),
  "noise3d.perlin": (noise, x, i, seed) => noise.hn_perlin3(vec3(x.x, x.y, x.z), seed),
  "noise2d.value_cell": (noise, x, i, seed) =>
    noise.hn_value2_place(noise.hn_place_in_cell2(ivec2(i.x, i.y), vec2(x.x, x.y)), seed),
  "noise2d.perlin_period": (noise, x, i, seed) =>
    noise.hn_perlin2_place(noise.hn_tile2(vec2(x.x, x.y), ivec2(i.x, i.y)), seed),
  "noise2d.cellular": (noise, x, i, seed) => noise.hn_cellular2(vec2(x.x, x.y), seed).y,
  "fbm.ridged2": (noise, x, i, seed) => noise.hn_ridged2(vec2(x.x, x.y), i.x, x.z, x.w, seed),
};

/** The floats of a row's function, at points of `floats` (four each), `integers` (four each) and `seeds`. */
async function evaluate(id, arithmetic, floats, integers, seeds) {
  const count = seeds.length;
  const x = instancedArray(new Float32Array(floats), "vec4");
  const i = instancedArray(new Int32Array(integers), "ivec4");
  const seed = instancedArray(new Uint32Array(seeds), "uint");
  const result = instancedArray(count, "float");
  const noise = arithmetic === "fixed" ? fixed : fast;
  const kernel = Fn(() => {
    const at = instanceIndex;
    result.element(at).assign(rows[id](noise, x.element(at), i.element(at), seed.element(at)));
  })().compute(count);
  await renderer.computeAsync(kernel);
  return Array.from(new Float32Array(await renderer.getArrayBufferAsync(result.value)).subarray(0, count));
}

const cells = new Field(2, { noise: "cellular", seed: 3 });
const grayOfCode = (u, v) => gray(u, v) + 0.2 * cells.at(u * 4, v * 4);

/** The bytes of a picture of a square, which a function draws of its scene. */
async function drawn(material, draw = (scene, camera) => renderer.render(scene, camera)) {
  const target = new RenderTarget(SIDE, SIDE);
  const scene = new Scene().add(new Mesh(new PlaneGeometry(2, 2), material));
  renderer.setRenderTarget(target);
  await draw(scene, new OrthographicCamera(-1, 1, 1, -1, -1, 1));
  const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIDE, SIDE);
  renderer.setRenderTarget(null);
  return pixels;
}

/** How many pixels have each red, of a gray of 100.25 steps of sRGB that is dithered by a mask with all bytes. */
async function ofDither() {
  renderer.outputColorSpace = SRGBColorSpace;
  const bytes = Uint8Array.from({ length: 64 * 64 * 4 }, (_, i) => (i >> 2) & 255);
  const mask = new DataTexture(bytes, 64, 64);
  mask.needsUpdate = true;
  const material = new MeshBasicNodeMaterial();
  material.colorNode = vec3(((100.25 / 255 + 0.055) / 1.055) ** 2.4);
  const pixels = await drawn(material, (scene, camera) => pipeline(renderer, scene, camera, mask).render());
  const counts = {};
  for (let i = 0; i < pixels.length; i += 4) counts[pixels[i]] = (counts[pixels[i]] ?? 0) + 1;
  return counts;
}

async function ofMaterial(material) {
  renderer.outputColorSpace = LinearSRGBColorSpace;
  const pixels = await drawn(material);
  // Rows are from the top in WebGPU, and from the bottom in WebGL.
  return furthest(pixels, gray, { stride: pixels.length / SIDE, downward: renderer.backend.isWebGPUBackend === true });
}

/** A shader of the documentation, without three.js. */
async function ofCode(text) {
  const device = await (await navigator.gpu.requestAdapter()).requestDevice();
  const module = device.createShaderModule({ code: `${text}
struct Corner { @builtin(position) position: vec4f, @location(0) uv: vec2f }
@vertex fn corner(@builtin(vertex_index) i: u32) -> Corner {
  let uv = vec2f(f32((i << 1u) & 2u), f32(i & 2u));
  return Corner(vec4f(uv * 2.0 - 1.0, 0.0, 1.0), uv);
}` });
  const complaints = (await module.getCompilationInfo()).messages.map(({ message }) => message);
  if (complaints.length) throw new Error(complaints.join("\n"));
  const pipeline = device.createRenderPipeline({
    layout: "auto", vertex: { module }, fragment: { module, targets: [{ format: "rgba8unorm" }] },
  });
  const texture = device.createTexture({
    size: [SIDE, SIDE], format: "rgba8unorm", usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC,
  });
  const buffer = device.createBuffer({ size: 256 * SIDE, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginRenderPass({
    colorAttachments: [{ view: texture.createView(), loadOp: "clear", storeOp: "store" }],
  });
  pass.setPipeline(pipeline);
  pass.draw(3);
  pass.end();
  encoder.copyTextureToBuffer({ texture }, { buffer, bytesPerRow: 256 }, [SIDE, SIDE]);
  device.queue.submit([encoder.finish()]);
  await buffer.mapAsync(GPUMapMode.READ);
  return furthest(new Uint8Array(buffer.getMappedRange()), grayOfCode, { downward: true });
}

globalThis.hashnoise = {
  backend: renderer.backend.isWebGPUBackend ? "WebGPU" : "WebGL2",
  rows: Object.keys(rows),
  evaluate,
  /** How far the documentation's material is off, and the same one with a mistake. */
  materials: async () => [await ofMaterial(ofNodes), await ofMaterial(wrongNodes)],
  dither: ofDither,
  code: async () => [await ofCode(code), await ofCode(wrongCode)],
};
