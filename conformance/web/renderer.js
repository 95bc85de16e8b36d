// WebGL2: build a program, evaluate it at many points, read back raw bits. As in gpu.cpp: a point is a fragment or a
// vertex, its input words come from up to four RGBA32UI textures, and nothing is converted on the way in or out.
import { kInputWords, kOutputWords } from "./suite.js";

// The size of the textures. A digest, the largest grid, has 16,384 points: 16 rows. Phones have little memory.
const kWidth = 1024;
const kHeight = 64;
// Cases that share a program follow each other: a variant, what it is compared with, and the same in another stage.
const kKeptPrograms = 3;
// Drivers evaluate what is beside the grid along with it, in blocks of pixels or vertices: that must see zeros instead
// of an earlier case's words, so whole rows are written.
const kBlock = 4;
const kNothing = 0xdeadbeef;
// The textures, as far as a program reads them.
const kInputs = ["input_a", "input_b", "input_c", "input_d"];

export class DriverError extends Error {
  constructor(message, log = "") {
    super(log ? `${message}\n${log}` : message);
    this.log = log;
  }
}

export class NoContext extends Error {}

// A context on a canvas of its own, which nobody sees.
export function openContext() {
  const canvas = document.createElement("canvas");
  let reason = "";
  canvas.addEventListener("webglcontextcreationerror", (event) => (reason = event.statusMessage));
  const gl = canvas.getContext("webgl2", {
    alpha: false, antialias: false, depth: false, powerPreference: "high-performance",
  });
  if (!gl) throw new NoContext(reason || "this browser does not give a WebGL2 context");
  return gl;
}

function describe(gl) {
  const unmasked = gl.getExtension("WEBGL_debug_renderer_info");
  const text = (name) => String(gl.getParameter(name) ?? "");
  return {
    vendor: text(unmasked ? unmasked.UNMASKED_VENDOR_WEBGL : gl.VENDOR),
    renderer: text(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
    gl_version: text(gl.VERSION),
    glsl_version: text(gl.SHADING_LANGUAGE_VERSION),
  };
}

export class Renderer {
  constructor(gl) {
    this.gl = gl;
    this.programs = new Map();
    this.output = this.makeTexture();
    this.textures = [];  // of the inputs, when a program reads them first
    this.framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.output, 0);
    this.vertexArray = gl.createVertexArray();
    this.captured = gl.createBuffer();
  }

  describe() {
    return describe(this.gl);
  }

  isLost() {
    return this.gl.isContextLost();
  }

  makeTexture() {
    const gl = this.gl;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32UI, kWidth, kHeight);
    return texture;
  }

  // The shader object; throws a DriverError if it does not compile.
  compile(stage, source) {
    const gl = this.gl;
    const shader = gl.createShader(stage === "vertex" ? gl.VERTEX_SHADER : gl.FRAGMENT_SHADER);
    gl.shaderSource(shader, source.text);
    gl.compileShader(shader);
    if (gl.getShaderParameter(shader, gl.COMPILE_STATUS)) return shader;
    const log = source.translate(gl.getShaderInfoLog(shader) ?? "");
    gl.deleteShader(shader);
    throw new DriverError(`the driver does not compile the ${stage} shader`, log);
  }

  // stage: the one that evaluates, "fragment" or "vertex". A vertex's result is captured by transform feedback.
  build({ stage, vertex, fragment }) {
    const gl = this.gl;
    const id = gl.createProgram();
    for (const [name, source] of [["vertex", vertex], ["fragment", fragment]]) {
      const shader = this.compile(name, source);
      gl.attachShader(id, shader);
      gl.deleteShader(shader);
    }
    if (stage === "vertex") gl.transformFeedbackVaryings(id, ["result"], gl.INTERLEAVED_ATTRIBS);
    gl.linkProgram(id);
    if (gl.getProgramParameter(id, gl.LINK_STATUS)) return { id, stage };
    throw new DriverError("the driver does not link the program",
                          (stage === "vertex" ? vertex : fragment).translate(gl.getProgramInfoLog(id) ?? ""));
  }

  // A program by a number of the caller's, built from sources() if it is not among the last few.
  kept(number, sources) {
    const found = this.programs.get(number) ?? this.build(sources());
    this.programs.delete(number);
    this.programs.set(number, found);  // behind all others
    if (this.programs.size > kKeptPrograms) {
      const [oldest, program] = this.programs.entries().next().value;
      this.programs.delete(oldest);
      this.gl.deleteProgram(program.id);
    }
    return found;
  }

  // Uniforms that a program may have: {name: {type: "int" or "uint", value}}.
  setUniforms(program, uniforms) {
    const gl = this.gl;
    const set = (name, type, value) => {
      const place = gl.getUniformLocation(program.id, name);
      if (type === "uint") gl.uniform1ui(place, value);
      else gl.uniform1i(place, value);
    };
    gl.useProgram(program.id);
    kInputs.forEach((name, unit) => set(name, "int", unit));
    for (const [name, { type, value }] of Object.entries(uniforms)) set(name, type, value);
  }

  upload(number, inputs, gridHeight) {
    const gl = this.gl;
    const height = Math.ceil(gridHeight / kBlock) * kBlock;
    const words = new Uint32Array(kWidth * height * 4);
    for (let point = 0; point * kInputWords < inputs.length; ++point) {
      const start = point * kInputWords + number * 4;
      words.set(inputs.subarray(start, start + 4), point * 4);
    }
    gl.activeTexture(gl.TEXTURE0 + number);
    this.textures[number] ??= this.makeTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.textures[number]);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, kWidth, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
  }

  // inputs: kInputWords per point. Returns kOutputWords per point.
  evaluate(program, inputs, uniforms) {
    const gl = this.gl;
    const points = inputs.length / kInputWords;
    const width = Math.min(points, kWidth);
    const height = Math.ceil(points / kWidth);
    if (height > kHeight) throw new Error(`${points} points are more than the page has room for`);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) {
      throw new DriverError("this driver does not render to RGBA32UI, which WebGL2 requires");
    }
    while (gl.getError() !== gl.NO_ERROR && !gl.isContextLost()) ;
    kInputs.forEach((name, number) => {
      if (gl.getUniformLocation(program.id, name)) this.upload(number, inputs, height);
    });
    this.setUniforms(program, uniforms);
    gl.bindVertexArray(this.vertexArray);
    const words = program.stage === "vertex" ? this.capture(program, points) : this.draw(width, height);
    const error = gl.getError();
    if (error !== gl.NO_ERROR) throw new DriverError(`WebGL error 0x${error.toString(16)} at ${points} points`);
    return words.subarray(0, points * kOutputWords);
  }

  draw(width, height) {
    const gl = this.gl;
    gl.viewport(0, 0, width, height);
    // Clear first, so that a draw that does nothing cannot pass for the one before it.
    gl.clearBufferuiv(gl.COLOR, 0, new Uint32Array(4).fill(kNothing));
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const words = new Uint32Array(width * height * kOutputWords).fill(kNothing);
    gl.readPixels(0, 0, width, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
    return words;
  }

  // A row of the grid at a time, from vertex 0 on: some drivers count vertices wrongly in larger draws.
  capture(program, points) {
    const gl = this.gl;
    const words = new Uint32Array(points * kOutputWords).fill(kNothing);
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, this.captured);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, words, gl.STREAM_READ);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, this.captured);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    const row = gl.getUniformLocation(program.id, "row");
    for (let first = 0; first < points; first += kWidth) {
      gl.uniform1i(row, first / kWidth);
      gl.drawArrays(gl.POINTS, 0, Math.min(kWidth, points - first));
    }
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    // WebGL reads no buffer that is bound for feedback.
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
    gl.bindBuffer(gl.COPY_READ_BUFFER, this.captured);
    gl.getBufferSubData(gl.COPY_READ_BUFFER, 0, words);
    gl.bindBuffer(gl.COPY_READ_BUFFER, null);
    return words;
  }
}
