// Heights at points, for tools/lib/ship/heights: of Field, and of texts in GLSL, which Chromium runs by WebGL2.
//
//   node heights.mjs JOB    {"rows": [[x, y, seed], ...], "texts": {NAME: GLSL}}, all words
//
// It prints the results as JSON, by names: a word for each row. The package's own text is "page", and Field "npm".
import { readFile } from "node:fs/promises";
import { Field } from "hashnoise";
import fbm2d from "hashnoise/glsl/fbm2d";
import { launch, open } from "../chromium.mjs";
import { bitsOf, meaning } from "./golden_values.mjs";

const { rows, texts } = JSON.parse(await readFile(process.argv[2], "utf8"));
const found = {
  npm: rows.map(([x, y, seed]) =>
    bitsOf(new Field(2, { fractal: "fbm", octaves: 6, seed }).at(meaning("f32", x), meaning("f32", y)))),
};

/** In the page: a word for each row, which the stage of vertices computes. */
function evaluate(text, rows) {
  const gl = document.createElement("canvas").getContext("webgl2");
  const program = gl.createProgram();
  for (const [stage, source] of [[gl.VERTEX_SHADER, `#version 300 es
#define HN_ARITHMETIC HN_FIXED
${text}
in highp uvec3 row;
flat out highp uint height;
void main() {
  highp vec2 p = vec2(uintBitsToFloat(row.x), uintBitsToFloat(row.y));
  height = floatBitsToUint(hn_fbm(p, 6, 2.0, 0.5, row.z));
  gl_Position = vec4(0.0);
}`], [gl.FRAGMENT_SHADER, "#version 300 es\nvoid main() {}"]]) {
    const shader = gl.createShader(stage);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.transformFeedbackVaryings(program, ["height"], gl.SEPARATE_ATTRIBS);
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Uint32Array(rows.flat()), gl.STATIC_DRAW);
  const at = gl.getAttribLocation(program, "row");
  gl.enableVertexAttribArray(at);
  gl.vertexAttribIPointer(at, 3, gl.UNSIGNED_INT, 0, 0);
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, gl.createBuffer());
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 4 * rows.length, gl.STATIC_READ);
  gl.enable(gl.RASTERIZER_DISCARD);
  gl.beginTransformFeedback(gl.POINTS);
  gl.drawArrays(gl.POINTS, 0, rows.length);
  gl.endTransformFeedback();
  const words = new Uint32Array(rows.length);
  gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, words);
  return Array.from(words);
}

const browser = await launch();
try {
  const page = await open(browser, "about:blank");
  for (const [name, text] of Object.entries({ page: fbm2d, ...texts })) {
    found[name] = await page.evaluate(evaluate, text, rows);
  }
} finally {
  await browser.close();
}
console.log(JSON.stringify(found));
