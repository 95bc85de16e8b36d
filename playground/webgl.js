// The picture by WebGL2.
import { kMostLayers } from "./model.js";
import { kFrameBytes, kVertex } from "./shaders.js";

const kImpatient = 4; // milliseconds

// Timers wait for up to 4 ms, which is longer than most pictures take; a message arrives at once.
const soon = () =>
  new Promise((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => {
      channel.port1.close();
      resolve();
    };
    channel.port2.postMessage(0);
  });

export class WebGL2 {
  // Throws if the browser has no WebGL2.
  constructor(canvas) {
    const gl = canvas.getContext("webgl2", {
      alpha: false, antialias: false, depth: false, powerPreference: "high-performance", preserveDrawingBuffer: false,
    });
    if (!gl) throw new Error("This browser does not give a WebGL2 context.");
    this.canvas = canvas;
    this.gl = gl;
    this.parallel = gl.getExtension("KHR_parallel_shader_compile");
    gl.bindVertexArray(gl.createVertexArray());
    this.frames = gl.createBuffer();
    gl.bindBuffer(gl.UNIFORM_BUFFER, this.frames);
    gl.bufferData(gl.UNIFORM_BUFFER, kFrameBytes, gl.DYNAMIC_DRAW);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, this.frames);
    this.palette = this.texture(256, kMostLayers);
    this.vertex = this.shader(gl.VERTEX_SHADER, kVertex);
    gl.disable(gl.DITHER);
  }

  describe() {
    const { gl } = this;
    const unmasked = gl.getExtension("WEBGL_debug_renderer_info");
    return String(gl.getParameter(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  }

  get lost() {
    return this.gl.isContextLost();
  }

  texture(width, height) {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
    return texture;
  }

  shader(type, text) {
    const shader = this.gl.createShader(type);
    this.gl.shaderSource(shader, text);
    this.gl.compileShader(shader);
    return shader;
  }

  // Compiles without holding the page up, where the driver can.
  async build(text) {
    const { gl } = this;
    const program = gl.createProgram();
    const fragment = this.shader(gl.FRAGMENT_SHADER, text);
    gl.attachShader(program, this.vertex);
    gl.attachShader(program, fragment);
    gl.linkProgram(program);
    while (this.parallel && !this.lost && !gl.getProgramParameter(program, this.parallel.COMPLETION_STATUS_KHR)) {
      await new Promise((resolve) => setTimeout(resolve, 4));
    }
    const linked = gl.getProgramParameter(program, gl.LINK_STATUS);
    const log =
      linked || this.lost ? "" : `${gl.getShaderInfoLog(fragment) ?? ""}${gl.getProgramInfoLog(program) ?? ""}`;
    gl.deleteShader(fragment);
    if (!linked) {
      gl.deleteProgram(program);
      throw new Error(`The driver does not compile the shader. ${log}`.trim());
    }
    gl.uniformBlockBinding(program, gl.getUniformBlockIndex(program, "Frame"), 0);
    return program;
  }

  discard(program) {
    this.gl.deleteProgram(program);
  }

  // 256 colours of four bytes, for each map.
  setPalette(bytes) {
    const { gl } = this;
    gl.bindTexture(gl.TEXTURE_2D, this.palette);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 256, bytes.length / 1024, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  }

  use(program, frame, width, height) {
    const { gl } = this;
    gl.useProgram(program);
    gl.bindTexture(gl.TEXTURE_2D, this.palette);
    gl.bufferSubData(gl.UNIFORM_BUFFER, 0, new Uint8Array(frame));
    gl.viewport(0, 0, width, height);
  }

  // Draws so many rows from this one on of a picture of this size, which nobody sees before show().
  strip(program, frame, width, height, from, rows) {
    const { gl } = this;
    if (this.hidden?.width !== width || this.hidden?.height !== height) {
      if (this.hidden) this.remove(this.hidden);
      this.hidden = this.offscreen(width, height);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.hidden.framebuffer);
    this.use(program, frame, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, from, width, rows);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.SCISSOR_TEST);
  }

  // The canvas takes its size from the picture only now, since with another size it is empty.
  show() {
    const { gl, canvas } = this;
    const { framebuffer, width, height } = this.hidden;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  // Resolves when the GPU has drawn everything so far.
  async finished() {
    const { gl } = this;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    gl.flush();
    const start = performance.now();
    while (!this.lost && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) {
      await (performance.now() - start < kImpatient ? soon() : new Promise((resolve) => setTimeout(resolve, 2)));
    }
    gl.deleteSync(fence);
  }

  offscreen(width, height) {
    const { gl } = this;
    const texture = this.texture(width, height);
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    return { texture, framebuffer, width, height };
  }

  remove({ texture, framebuffer }) {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(framebuffer);
    gl.deleteTexture(texture);
  }

  // The bytes of a picture of this size, four a pixel, from the lower left corner on.
  async read(program, frame, width, height) {
    const { gl } = this;
    const target = this.offscreen(width, height);
    this.use(program, frame, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    // Through a buffer, so that the page goes on while the GPU draws.
    const bytes = new Uint8Array(width * height * 4);
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes.length, gl.STREAM_READ);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    this.remove(target);
    await this.finished();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, bytes);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.deleteBuffer(buffer);
    return bytes;
  }

  // Milliseconds of so many draws of a square.
  async time(program, frame, side, draws) {
    const { gl } = this;
    const target = this.offscreen(side, side);
    this.use(program, frame, side, side);
    const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    wait();
    const start = performance.now();
    for (let i = 0; i < draws; ++i) gl.drawArrays(gl.TRIANGLES, 0, 3);
    wait();
    const milliseconds = performance.now() - start;
    this.remove(target);
    return milliseconds;
  }
}
