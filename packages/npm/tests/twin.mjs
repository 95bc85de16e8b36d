// The twin in WebAssembly has golden values, bit for bit.
//
//   node twin.mjs GOLDEN    a folder of golden files
import assert from "node:assert/strict";
import test from "node:test";
import { Field } from "hashnoise";
import { bitsOf, has, ids, meaning, read } from "./golden_values.mjs";

const [golden] = process.argv.slice(2);

// Columns that a field lacks.
const ABSENT = ["phase", "detail", "footprint", "units", "nx", "ox"];
const SETTINGS = ["octaves", "lacunarity", "gain", "strength", "amplitude", "jitter"];
const METRICS = ["euclidean", "squared", "manhattan", "chebyshev", "hybrid"];

function functionOf({ calls, axes: dimensions, inputs, outputs }) {
  const name = calls.slice("hn_".length);
  if (dimensions < 1 || dimensions > 3 || [...inputs, ...outputs].some(([column]) => ABSENT.includes(column))) return undefined;
  if (Field.noises(dimensions).includes(name)) return { dimensions, name, settings: { noise: name } };
  if (Field.fractals(dimensions).includes(name)) return { dimensions, name, settings: { fractal: name } };
  return undefined;
}

/** The values of a row: undefined if there is no such field. */
function evaluated({ dimensions, settings }, { inputs }, row) {
  const at = Object.fromEntries(inputs.map(([name, kind], i) => [name, meaning(kind, row.inputs[i])]));
  const along = (prefix) => ["x", "y", "z"].slice(0, dimensions).map((axis) => at[prefix + axis]);
  const chosen = { ...settings, seed: at.seed };
  // A field refuses what GLSL takes as the end: a fraction beyond its cell, more than 32 octaves, a gain above 1, a
  // lacunarity above 255 or, in a tile, with a fraction, and of a noise a period below 0. The seed of a fractal may become a positive one in a late
  // octave.
  if ("px" in at) chosen.period = along("p").map((period) => (settings.noise ? Math.max(period, 0) : period));
  // A fractal without a period has octaves that turn. Octaves of a tile do not, also where the tile has no period.
  if (settings.fractal && "px" in at && chosen.period.every((period) => period <= 0)) return undefined;
  for (const name of SETTINGS) if (name in at) chosen[name] = at[name];
  if (chosen.octaves > 32) chosen.octaves = 32;
  if (settings.fractal) {
    const lacunarity = Math.min(Math.max(chosen.lacunarity, 0), 255);
    chosen.lacunarity = "px" in at ? Math.floor(lacunarity) : lacunarity;
    chosen.gain = Math.min(Math.max(chosen.gain, 0), 1);
  }
  if ("metric" in at) chosen.metric = METRICS[at.metric - 1];
  let field;
  try {
    field = new Field(dimensions, chosen);
  } catch (error) {
    if (error instanceof RangeError) return undefined;
    throw error;
  }
  const inCell = () => field.allInCell(along("c"), along("f").map((fraction) => Math.min(Math.max(fraction, 0), 1)));
  return "cx" in at ? inCell() : field.all(...along(""));
}

function differing(file, change = (n) => n) {
  const made = functionOf(file);
  let refused = 0;
  const wrong = [];
  for (const row of file.rows) {
    const got = evaluated(made, file, row);
    if (!got) {
      refused += 1;
    } else if (!got.every((n, i) => bitsOf(change(n)) === row.expected[i])) {
      wrong.push({ id: file.id, inputs: row.inputs, got, expected: row.expected });
    }
  }
  return { refused, wrong };
}

const files = ids(golden).filter((id) => has(golden, id)).map((id) => read(golden, id)).filter(functionOf);

test("it has the values of the golden files", () => {
  let rows = 0;
  let refused = 0;
  for (const file of files) {
    const found = differing(file);
    assert.deepEqual(found.wrong.slice(0, 3), [], `${found.wrong.length} rows of ${file.id}`);
    rows += file.rows.length;
    refused += found.refused;
  }
  console.log(`${files.length} files, ${rows} rows, without ${refused} for which there is no field`);
  assert.ok(files.length > 120, `${files.length} files`);
  assert.ok(refused < rows / 10, `${refused} of ${rows} rows`);
});

test("a bit that differs is noticed", () => {
  const file = read(golden, "noise2d.perlin");
  assert.ok(differing(file, (n) => n + 2 ** -21).wrong.length === file.rows.length);
  file.rows[5].inputs[0] ^= 0x00400000;
  assert.equal(differing(file).wrong.length, 1);
});

test("every noise and every fractal has golden files", () => {
  for (const dimensions of [1, 2, 3]) {
    for (const name of [...Field.noises(dimensions), ...Field.fractals(dimensions)]) {
      const forms = files.filter((file) => {
        const found = functionOf(file);
        return found.name === name && found.dimensions === dimensions;
      });
      assert.ok(forms.length >= 2, `${name} in ${dimensions}D: ${forms.map(({ id }) => id)}`);
    }
  }
});
