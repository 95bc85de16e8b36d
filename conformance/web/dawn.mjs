// Evaluates shaders by npm's package webgpu, which is Dawn with Tint, by the page's own webgpu.js.
//
//   node dawn.mjs FD    first writes its device into that file, and then an answer for each line that it reads, as lines
//                       of JSON: as tools/lib/translate/wgsl/wgpu_program.py
import { readFileSync, writeFileSync, writeSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

const kKept = 16;  // pipelines
const send = (what) => writeSync(Number(process.argv[2]), `${JSON.stringify(what)}\n`);
const messageOf = (error) => String(error.message ?? error);

async function open() {
  const path = createRequire(`${process.env.HN_DAWN || process.cwd()}/`).resolve("webgpu");
  const { create, globals } = await import(pathToFileURL(path));
  Object.assign(globalThis, globals);
  // Dawn crashes when it is collected.
  Object.defineProperty(globalThis, "navigator", { value: { gpu: create([]) }, configurable: true });
  const device = await (await import("./webgpu.js")).openDevice();
  const { version } = JSON.parse(readFileSync(`${dirname(path)}/package.json`));
  const { vendor, renderer } = device.describe();
  return [device, { vendor, renderer, version: `Dawn of npm's webgpu ${version}, Node.js ${process.versions.node}` }];
}

async function evaluate(device, pipelines, { shader, points, results, uniforms }) {
  if (!pipelines.has(shader)) {
    if (pipelines.size === kKept) pipelines.delete(pipelines.keys().next().value);
    pipelines.set(shader, await device.build({ wgsl: { text: readFileSync(shader, "utf8") } }));
  }
  if (!points) return {};
  const words = new Uint32Array(new Uint8Array(readFileSync(points)).buffer);
  writeFileSync(results, await device.evaluate(pipelines.get(shader), words, uniforms));
  return {};
}

try {
  const [device, info] = await open();
  send(info);
  const pipelines = new Map();
  for await (const line of createInterface({ input: process.stdin })) {
    const answer = await evaluate(device, pipelines, JSON.parse(line)).catch((error) => ({ error: messageOf(error) }));
    send(device.isLost() ? { ...answer, lost: true } : answer);
  }
} catch (error) {
  const isMissing = error.code === "MODULE_NOT_FOUND";  // and its message has several lines
  send({ absent: isMissing ? "Node.js finds no package webgpu; HN_DAWN names a folder that has it" : messageOf(error) });
}
process.exit(0);
