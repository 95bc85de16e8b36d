// Two versions of the package in one page: the heights of each in JavaScript, and in shaders that have either text, or
// both.
import { Field } from "hashnoise";
import now from "hashnoise/glsl/fbm2d";
import { Field as FieldBefore } from "hashnoise-before";
import before from "hashnoise-before/glsl/fbm2d";
import { version } from "hashnoise-before/package.json";

const settings = { octaves: 6, seed: 7 };
const fractal = version.startsWith("0.") ? "sum" : "fractal"; // the setting's name in 1.0
const fields = {
  now: [Field, { ...settings, fractal: "fbm" }],
  before: [FieldBefore, { ...settings, [fractal]: "fbm" }],
};
// All names of the library begin so, and one shader has each once (docs/reference/frozen.md).
const renamed = before.replace(/\b(hn|HN)_/g, "$1before_");
const texts = {
  now: "#define HN_ARITHMETIC HN_FIXED\n" + now,
  before: "#define HN_ARITHMETIC HN_FIXED\n" + before,
  renamed: "#define HNbefore_ARITHMETIC HNbefore_FIXED\n" + renamed,
};
const calls = { now: "hn_fbm", before: "hn_fbm", renamed: "hnbefore_fbm" };

/** The bits of the heights at the points, by the shader that has these texts: a list for each. */
function drawn(names, points) {
  const canvas = new OffscreenCanvas(points.length, names.length);
  const gl = canvas.getContext("webgl2");
  const rows = names.map((name, row) => `
    if (int(gl_FragCoord.y) == ${row}) word = floatBitsToUint(${calls[name]}(p, 6, 2.0, 0.5, 7u));`);
  const program = gl.createProgram();
  for (const [type, text] of [
    [gl.VERTEX_SHADER, "in vec2 corner; void main() { gl_Position = vec4(corner, 0.0, 1.0); }"],
    [gl.FRAGMENT_SHADER, `precision highp float;\nprecision highp int;\n${names.map((name) => texts[name]).join("\n")}
      uniform vec2 points[${points.length}];
      out uvec4 words;
      void main() {
        vec2 p = points[int(gl_FragCoord.x)];
        uint word = 0u;${rows.join("")}
        words = uvec4(word, 0u, 0u, 1u);
      }`],
  ]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, `#version 300 es\n${text}`);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  gl.uniform2fv(gl.getUniformLocation(program, "points"), points.flat());
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.bindRenderbuffer(gl.RENDERBUFFER, gl.createRenderbuffer());
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32UI, points.length, names.length);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER,
    gl.getParameter(gl.RENDERBUFFER_BINDING));
  gl.viewport(0, 0, points.length, names.length);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new Uint32Array(4 * points.length * names.length);
  gl.readPixels(0, 0, points.length, names.length, gl.RGBA_INTEGER, gl.UNSIGNED_INT, pixels);
  return names.map((_, row) => points.map((_, i) => pixels[4 * (row * points.length + i)]));
}

/** The values of the twin in JavaScript. */
function computed(name, points) {
  const [Type, chosen] = fields[name];
  const field = new Type(2, chosen);
  return [...new Uint32Array(Float32Array.from(points, (p) => field.at(...p)).buffer)];
}

globalThis.hashnoise = { drawn, computed };
