// WebGPU: build a pipeline, evaluate it at many points, read back raw bits. Points and results are in buffers.
import { DriverError, NoContext } from "./renderer.js";
import { kInputWords, kOutputWords } from "./suite.js";

const kGroup = 64;  // invocations, as in tools/lib/translate/wgsl/evaluation.py
const kBytes = 4;   // of a word
const kNothing = 0xdeadbeef;

// A device of the browser's WebGPU.
export async function openDevice() {
  if (!navigator.gpu) throw new NoContext("this browser has no WebGPU, or not for this page");
  const adapter = await navigator.gpu.requestAdapter();
  if (!adapter) throw new NoContext("this browser gives no WebGPU adapter");
  return new Device(adapter, await adapter.requestDevice());
}

class Device {
  constructor(adapter, device) {
    this.adapter = adapter;
    this.device = device;
    this.lost = false;
    const entries = ["storage", "read-only-storage", "uniform"].map((type, binding) => ({
      binding, visibility: GPUShaderStage.COMPUTE, buffer: { type },
    }));
    this.group = device.createBindGroupLayout({ entries });
    this.layout = device.createPipelineLayout({ bindGroupLayouts: [this.group] });
    device.lost.then(() => (this.lost = true));
  }

  describe() {
    const { vendor, architecture, device, description } = this.adapter.info;
    const renderer = [architecture, device, description].filter(Boolean).join(", ");
    return { vendor, renderer: renderer || "unknown", gl_version: "WebGPU", glsl_version: "WGSL" };
  }

  isLost() {
    return this.lost;
  }

  // WebGPU reports an error of a call later, and only on request.
  async checked(what, call) {
    this.device.pushErrorScope("validation");
    this.device.pushErrorScope("out-of-memory");
    this.device.pushErrorScope("internal");
    const result = await call();
    for (let i = 0; i < 3; ++i) {
      const error = await this.device.popErrorScope();
      if (error) throw new DriverError(`the driver does not ${what}`, error.message);
    }
    return result;
  }

  async build({ wgsl }) {
    const module = await this.checked("compile the WGSL", () => this.device.createShaderModule({ code: wgsl.text }));
    return this.checked("make a pipeline", () => this.device.createComputePipelineAsync({
      layout: this.layout, compute: { module, entryPoint: "main" },
    }).catch((error) => {
      throw new DriverError("the driver does not make a pipeline", error.message);
    }));
  }

  // A program lasts as long as its case: no two of WGSL share one.
  kept(number, sources) {
    return this.build(sources());
  }

  // inputs: kInputWords per point; uniforms: words that shaders of others may read. Returns kOutputWords per point.
  async evaluate(pipeline, inputs, uniforms = []) {
    const points = inputs.length / kInputWords;
    const size = points * kOutputWords * kBytes;
    const { STORAGE, UNIFORM, COPY_SRC, COPY_DST, MAP_READ } = GPUBufferUsage;
    const buffers = [];
    const filled = (usage, words) => {
      const buffer = this.device.createBuffer({ size: words.length * kBytes, usage, mappedAtCreation: true });
      new Uint32Array(buffer.getMappedRange()).set(words);
      buffer.unmap();
      buffers.push(buffer);
      return buffer;
    };
    const read = await this.checked("evaluate", async () => {
      const target = filled(STORAGE | COPY_SRC, new Uint32Array(points * kOutputWords).fill(kNothing));
      const all = [target, filled(STORAGE, inputs), filled(UNIFORM, Uint32Array.from({ ...uniforms, length: 4 }))];
      const copy = this.device.createBuffer({ size, usage: COPY_DST | MAP_READ });
      buffers.push(copy);
      const entries = all.map((buffer, binding) => ({ binding, resource: { buffer } }));
      const group = this.device.createBindGroup({ layout: this.group, entries });
      const encoder = this.device.createCommandEncoder();
      const pass = encoder.beginComputePass();
      pass.setPipeline(pipeline);
      pass.setBindGroup(0, group);
      pass.dispatchWorkgroups(Math.ceil(points / kGroup));
      pass.end();
      encoder.copyBufferToBuffer(target, 0, copy, 0, size);
      this.device.queue.submit([encoder.finish()]);
      return copy;
    });
    await read.mapAsync(GPUMapMode.READ);
    const words = new Uint32Array(read.getMappedRange().slice(0));
    for (const buffer of buffers) buffer.destroy();
    return words;
  }
}
