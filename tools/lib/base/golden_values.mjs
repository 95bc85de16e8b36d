// The reader of golden files (docs/reference/formats.md), for tests: words in, and those that must come out.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const view = new DataView(new ArrayBuffer(8));

/** The bits of a float that a word of a file stands for; those of a double must be exact as one. */
function word(kind, text) {
  if (kind !== "f64") return Number.parseInt(text, 16);
  view.setBigUint64(0, BigInt(`0x${text}`));
  const value = view.getFloat64(0);
  if (Math.fround(value) !== value && !Number.isNaN(value)) throw new Error(`${text} is no float`);
  view.setFloat32(0, value);
  return view.getUint32(0);
}

/** The value of a word that goes in. */
export function meaning(kind, bits) {
  view.setUint32(0, bits);
  return { f32: () => view.getFloat32(0), i32: () => bits | 0, u32: () => bits >>> 0 }[kind]();
}

export function bitsOf(value) {
  view.setFloat32(0, value);
  return view.getUint32(0);
}

/**
 * A function with a setting: the function of the library that it calls, how many axes it takes, its columns that go in
 * and come out, as [name, kind], and its rows, but for those with an infinity, where packages return NaN.
 */
export function read(folder, id, setting = "lattice+fixed") {
  const lines = readFileSync(join(folder, `${id}.golden`), "ascii").split("\n");
  const end = lines.findIndex((line) => line.startsWith("rows "));
  const head = Object.fromEntries(lines.slice(1, end + 1).map((line) => line.split(/ (.*)/)));
  const [inputs, outputs] = head.columns.split(" = ").map((side) => side.split(" ").map((column) => column.split(":")));
  const group = 1 + head.settings.split(" ").findIndex((named) => named.split(":")[0] === setting);
  if (group === 0) throw new Error(`${id} has no values with ${setting}`);
  const all = lines.slice(end + 1, end + 1 + Number(head.rows)).map((line) => line.split(" = "));
  const rows = all.filter((groups) => groups[group] !== "-").map((groups) => ({
    inputs: groups[0].split(" ").map((text) => Number.parseInt(text, 16)),
    expected: groups[group].split(" ").map((text, i) => word(outputs[i][1], text)),
  })).filter((row) => inputs.every(([, kind], i) => Number.isFinite(meaning(kind, row.inputs[i]))));
  const axes = inputs.filter(([name]) => /^c?[xyzw]$/.test(name)).length;
  return { id, calls: head.calls, axes, inputs, outputs, rows };
}

/** The ids of all functions that have a file. */
export function ids(folder) {
  return readdirSync(folder).filter((name) => name.endsWith(".golden")).map((name) => name.slice(0, -".golden".length)).sort();
}

/** Whether a function has values with a setting. */
export function has(folder, id, setting = "lattice+fixed") {
  const line = /^settings (.*)$/m.exec(readFileSync(join(folder, `${id}.golden`), "ascii"));
  return line[1].split(" ").some((named) => named.split(":")[0] === setting);
}
