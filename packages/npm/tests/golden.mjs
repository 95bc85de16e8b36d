// Golden values (docs/formats.md), for tests: the words that go in, and those that must come out.
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

/** What a word that goes in means. */
export function meaning(kind, bits) {
  view.setUint32(0, bits);
  return { f32: () => view.getFloat32(0), i32: () => bits | 0, u32: () => bits >>> 0 }[kind]();
}

export function bitsOf(value) {
  view.setFloat32(0, value);
  return view.getUint32(0);
}

const columnsOf = (text) => text.split(" ").map((column) => column.split(":"));

/** A file: its columns in and out, as [name, kind], and its rows. */
export function read(folder, id, configuration = "lattice+fixed") {
  const lines = readFileSync(join(folder, `${id}.${configuration}.golden`), "ascii").split("\n");
  const columns = lines.find((line) => line.startsWith("columns ")).slice(8).split(" = ");
  const [inputs, outputs] = columns.map(columnsOf);
  const rows = lines.filter((line) => /^[0-9a-f]{8}\b.* = /.test(line)).map((line) => {
    const [given, expected] = line.split(" = ").map((words) => words.split(" "));
    return {
      inputs: given.map((text) => Number.parseInt(text, 16)),
      expected: expected.map((text, i) => word(outputs[i][1], text)),
    };
  });
  return { id, inputs, outputs, rows };
}

/** The ids of all files of a configuration. */
export function ids(folder, configuration = "lattice+fixed") {
  const end = `.${configuration}.golden`;
  return readdirSync(folder).filter((name) => name.endsWith(end)).map((name) => name.slice(0, -end.length)).sort();
}
