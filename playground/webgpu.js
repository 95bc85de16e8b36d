// The picture by WebGPU.
import { kMostLayers } from "./model.js";
import { kFrameBytes } from "./shaders.js";

const kFormat = "rgba8unorm";
const kMostWait = 10000; // milliseconds, for an adapter: some browsers never answer

export class WebGPU {
  // Throws if the browser has no WebGPU, or no device for it.
  static async create(canvas) {
    const late = new Promise((resolve) => setTimeout(resolve, kMostWait));
    const adapter = await Promise.race([navigator.gpu?.requestAdapter({ powerPreference: "high-performance" }), late]);
    if (!adapter) throw new Error("This browser does not give a WebGPU device.");
    const device = await adapter.requestDevice();
    const context = canvas.getContext("webgpu");
    const usage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_DST;
    context.configure({ device, format: kFormat, alphaMode: "opaque", usage });
    return new WebGPU(canvas, adapter, device, context);
  }

  constructor(canvas, adapter, device, context) {
    this.canvas = canvas;
    this.info = adapter.info;
    this.device = device;
    this.context = context;
    this.language = "wgsl";
    this.lost = false;
    device.lost.then(() => {
      this.lost = true;
      canvas.dispatchEvent(new Event("lost"));
    });
    this.frames = device.createBuffer({ size: kFrameBytes, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
    this.palette = this.texture(256, kMostLayers, GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST);
    const visibility = GPUShaderStage.FRAGMENT;
    this.layout = device.createBindGroupLayout({
      entries: [
        { binding: 0, visibility, buffer: {} },
        { binding: 1, visibility, texture: { sampleType: "unfilterable-float" } },
      ],
    });
    this.group = device.createBindGroup({
      layout: this.layout,
      entries: [
        { binding: 0, resource: { buffer: this.frames } },
        { binding: 1, resource: this.palette.createView() },
      ],
    });
  }

  describe() {
    const { description, vendor, architecture } = this.info ?? {};
    return description || [vendor, architecture].filter(Boolean).join(" ") || "WebGPU";
  }

  texture(width, height, usage) {
    return this.device.createTexture({ size: [width, height], format: kFormat, usage });
  }

  async build(text) {
    const { device } = this;
    device.pushErrorScope("validation");
    const module = device.createShaderModule({ code: text });
    const error = await device.popErrorScope();
    if (error) throw new Error(`The driver does not compile the shader. ${error.message}`);
    return device
      .createRenderPipelineAsync({
        layout: device.createPipelineLayout({ bindGroupLayouts: [this.layout] }),
        vertex: { module, entryPoint: "vertex" },
        fragment: { module, entryPoint: "fragment", targets: [{ format: kFormat }] },
      })
      .catch((failure) => {
        throw new Error(`The driver does not make a pipeline. ${failure.message}`);
      });
  }

  discard() {}

  setPalette(bytes) {
    this.device.queue.writeTexture({ texture: this.palette }, bytes, { bytesPerRow: 1024 }, [256, bytes.length / 1024]);
  }

  // Draws a picture, or a part of it: a rectangle, as setScissorRect takes one.
  pass(encoder, program, view, part) {
    const loadOp = part ? "load" : "clear";
    const pass = encoder.beginRenderPass({ colorAttachments: [{ view, loadOp, storeOp: "store" }] });
    if (part) pass.setScissorRect(...part);
    pass.setPipeline(program);
    pass.setBindGroup(0, this.group);
    pass.draw(3);
    pass.end();
  }

  // As WebGL2 has it.
  strip(program, frame, width, height, from, rows) {
    const { device } = this;
    if (this.hidden?.width !== width || this.hidden?.height !== height) {
      this.hidden?.destroy();
      this.hidden = this.texture(width, height, GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC);
    }
    device.queue.writeBuffer(this.frames, 0, frame);
    const encoder = device.createCommandEncoder();
    this.pass(encoder, program, this.hidden.createView(), [0, from, width, rows]);
    device.queue.submit([encoder.finish()]);
  }

  show() {
    const { device, canvas, context } = this;
    const { width, height } = this.hidden;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToTexture({ texture: this.hidden }, { texture: context.getCurrentTexture() }, [width, height]);
    device.queue.submit([encoder.finish()]);
  }

  finished() {
    return this.device.queue.onSubmittedWorkDone();
  }

  // As WebGL2 has it: from the lower left corner on.
  async read(program, frame, width, height) {
    const { device } = this;
    const target = this.texture(width, height, GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC);
    const bytesPerRow = Math.ceil((width * 4) / 256) * 256;
    const buffer = device.createBuffer({
      size: bytesPerRow * height,
      usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ,
    });
    device.queue.writeBuffer(this.frames, 0, frame);
    const encoder = device.createCommandEncoder();
    this.pass(encoder, program, target.createView());
    encoder.copyTextureToBuffer({ texture: target }, { buffer, bytesPerRow }, [width, height]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const rows = new Uint8Array(buffer.getMappedRange());
    const bytes = new Uint8Array(width * height * 4);
    for (let row = 0; row < height; ++row) {
      const start = (height - 1 - row) * bytesPerRow;
      bytes.set(rows.subarray(start, start + width * 4), row * width * 4);
    }
    buffer.destroy();
    target.destroy();
    return bytes;
  }

  async time(program, frame, side, draws) {
    const { device } = this;
    const target = this.texture(side, side, GPUTextureUsage.RENDER_ATTACHMENT);
    const view = target.createView();
    device.queue.writeBuffer(this.frames, 0, frame);
    await this.finished();
    const start = performance.now();
    const encoder = device.createCommandEncoder();
    for (let i = 0; i < draws; ++i) this.pass(encoder, program, view);
    device.queue.submit([encoder.finish()]);
    await this.finished();
    const milliseconds = performance.now() - start;
    target.destroy();
    return milliseconds;
  }
}
