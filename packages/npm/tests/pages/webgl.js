// A page with WebGLRenderer draws golden rows with each way to the text, and the materials of the documentation.
import * as THREE from "three";
import cellular3d from "hashnoise/glsl/cellular3d";
import fbm2d from "hashnoise/glsl/fbm2d";
import perlin2d from "hashnoise/glsl/perlin2d";
import raw from "hashnoise/hashnoise.glsl?raw";
import { registerChunks } from "hashnoise/three";
import { furthest, gray, SIDE } from "./furthest.js";
import included from "./golden.glsl";
import { height, heights } from "../blocks/heights.js";
import { here, tile } from "../blocks/world.js";
import { material as ofString } from "../blocks/string.js";
import { material as ofChunks } from "../blocks/chunks.js";
import ofFile from "../blocks/included.glsl";
import { height as wrongHeight, heights as wrongHeights } from "../faulty/heights.js";
import { here as wrongHere, tile as wrongTile } from "../faulty/world.js";
import { material as wrongString } from "../faulty/string.js";
import { material as wrongChunks } from "../faulty/chunks.js";
import wrongFile from "../faulty/included.glsl";

registerChunks();
registerChunks(); // again, which changes nothing

const texts = {
  string: perlin2d + fbm2d + cellular3d,
  raw,
  included,
  chunks: "#include <hashnoise/perlin2d>\n#include <hashnoise/fbm2d>\n#include <hashnoise/cellular3d>\n",
};
const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1);

function draw(material, target = null) {
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.setRenderTarget(null);
}

const WORDS = 4; // vectors of four words for each point

/** The words that `body`, which returns a uvec4 from uvec4 a, b, c and d, makes of those of each point. */
function evaluate(way, body, inputs) {
  const words = new Uint32Array(inputs.length * WORDS * 4);
  inputs.forEach((row, i) => words.set(row, i * WORDS * 4));
  const points = new THREE.DataTexture(words, WORDS, inputs.length, THREE.RGBAIntegerFormat, THREE.UnsignedIntType);
  points.internalFormat = "RGBA32UI";
  points.needsUpdate = true;
  const target = new THREE.WebGLRenderTarget(1, inputs.length, {
    format: THREE.RGBAIntegerFormat, type: THREE.UnsignedIntType, internalFormat: "RGBA32UI", depthBuffer: false,
    minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter,
  });
  const material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    uniforms: { points: { value: points } },
    defines: { HN_ARITHMETIC: "HN_FIXED" },
    vertexShader: "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }",
    fragmentShader: `precision highp float;
precision highp int;
uniform highp usampler2D points;
out uvec4 result;
${texts[way]}
#define float_of uintBitsToFloat
#define bits_of floatBitsToUint
uvec4 evaluate(uvec4 a, uvec4 b, uvec4 c, uvec4 d) { ${body} }
void main() {
  int i = int(gl_FragCoord.y);
  result = evaluate(texelFetch(points, ivec2(0, i), 0), texelFetch(points, ivec2(1, i), 0),
                    texelFetch(points, ivec2(2, i), 0), texelFetch(points, ivec2(3, i), 0));
}`,
  });
  draw(material, target);
  const results = new Uint32Array(inputs.length * 4);
  renderer.readRenderTargetPixels(target, 0, 0, 1, inputs.length, results);
  return inputs.map((_, i) => Array.from(results.subarray(4 * i, 4 * i + 4)));
}

/** Linear light as a canvas shows it, as three.js converts it: sRGB. */
const shown = (v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);

/** Draws a material of the documentation. */
function ofMaterial(material) {
  renderer.setPixelRatio(1);
  renderer.setSize(SIDE, SIDE, false);
  draw(material);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * SIDE * SIDE);
  gl.readPixels(0, 0, SIDE, SIDE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return furthest(pixels, (u, v) => shown(gray(u, v)));
}

/** How far the gray of the documentation's land, seen from above, is from that of its heights. */
async function ofLand(made) {
  const { height } = await import("../blocks/land.js");
  const { land, ball } = await made;
  const above = new THREE.OrthographicCamera(-32, 32, 32, -32, 1, 100);
  above.position.y = 50;
  above.rotation.x = -Math.PI / 2;
  const target = new THREE.WebGLRenderTarget(SIDE, SIDE);
  renderer.setRenderTarget(target);
  renderer.render(new THREE.Scene().add(new THREE.Mesh(land.geometry, land.material)), above);
  renderer.setRenderTarget(null);
  const pixels = new Uint8Array(4 * SIDE * SIDE);
  renderer.readRenderTargetPixels(target, 0, 0, SIDE, SIDE, pixels);
  const off = furthest(pixels, (u, v) => 0.5 + height(SIDE * u - 32, 32 - SIDE * v) / 8);
  return Math.max(off, Math.abs(ball.position.y - 1 - height(ball.position.x, ball.position.z)));
}

const fromFile = (fragmentShader) => new THREE.ShaderMaterial({ vertexShader: ofString.vertexShader, fragmentShader });
const materials = {
  string: () => [ofString, wrongString],
  chunks: () => [ofChunks, wrongChunks],
  included: () => [fromFile(ofFile), fromFile(wrongFile)],
};

globalThis.hashnoise = {
  ways: Object.keys(texts),
  evaluate,
  /** How far a material of the documentation is off, and the same one with a mistake. */
  materials: () => Object.fromEntries(Object.entries(materials).map(([name, made]) => [name, made().map(ofMaterial)])),
  land: () => Promise.all([import("../blocks/land.js"), import("../faulty/land.js")].map(ofLand)),
  /** The documentation's code for the twin: values as printed, and with a mistake. */
  twin: () => [
    { height, heights: Array.from(heights.slice(0, 300)), here, tile: Array.from(tile.slice(0, 300)) },
    { height: wrongHeight, heights: Array.from(wrongHeights.slice(0, 300)), here: wrongHere, tile: Array.from(wrongTile.slice(0, 300)) },
  ],
};
