// The twin's class: a field reports wrong settings, and grids and arrays have the values of single points.
//
//   node fields.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import test from "node:test";
import { fileURLToPath } from "node:url";
import { Field, init } from "hashnoise";

const bits = (values) => Array.from(new Uint32Array(Float32Array.from(values).buffer));

/** Every noise and every fractal, in each of their dimensions. */
function* all() {
  for (const dimensions of [1, 2, 3]) {
    for (const noise of Field.noises(dimensions)) yield new Field(dimensions, { noise, seed: 3, period: 5 });
    for (const fractal of Field.fractals(dimensions)) yield new Field(dimensions, { fractal, seed: 3, octaves: 3 });
  }
}

/** Planes of a field at the points of a list. */
const planes = (field, points) =>
  field.components.flatMap((_, i) => points.map((point) => field.all(...point)[i]));

test("grids have the values of single points", () => {
  for (const field of all()) {
    const size = [7, 3, 2].slice(0, field.dimensions);
    const origin = [-1.5, 2.25, 100].slice(0, field.dimensions);
    const points = [];
    for (let z = 0; z < (size[2] ?? 1); ++z) {
      for (let y = 0; y < (size[1] ?? 1); ++y) {
        for (let x = 0; x < size[0]; ++x) {
          points.push([x, y, z].slice(0, field.dimensions).map((i, axis) => Math.fround(origin[axis] + i * Math.fround(0.3))));
        }
      }
    }
    assert.deepEqual(bits(field.grid(size, { origin, step: 0.3 })), bits(planes(field, points)));
    const axes = origin.map((_, axis) => points.map((point) => point[axis]));
    assert.deepEqual(bits(field.points(axes)), bits(planes(field, points)));
    const names = ["x", "y", "z"].slice(0, field.dimensions);
    const named = Object.fromEntries(names.map((name, axis) => [name, Float32Array.from(axes[axis])]));
    assert.deepEqual(bits(field.points(named)), bits(planes(field, points)));
    const nested = field.dimensions === 1 ? [] : [points, points.map((point) => new Float32Array(point))];
    for (const list of [...nested, points.flat(), new Float32Array(points.flat())]) {
      assert.deepEqual(bits(field.points({ [names.join("")]: list })), bits(planes(field, points)));
    }
  }
});

test("parts of a grid have the bits that the whole has there", () => {
  let moved = 0;
  for (const field of all()) {
    const of = (values) => values.slice(0, field.dimensions);
    const [size, first, part] = [of([30, 10, 5]), of([9, -4, 1]), of([14, 5, 2])];
    const from = of([-3, -6, -1]);
    for (const place of [{ origin: of([1447.7, -3.3, 40.1]) }, { origin: of([0.3, 0.7, 0.1]), cell: of([1e9, 2 ** 31 - 1, -7]) }]) {
      for (const step of [0.03, of([0.1, -0.07, 1 / 3])]) {
        const whole = field.grid(size, { ...place, step, first: from });
        const expected = [];
        const [width, height = 1, depth = 1] = size;
        for (let plane = 0; plane < field.components.length; ++plane) {
          for (let z = 0; z < (part[2] ?? 1); ++z) {
            for (let y = 0; y < (part[1] ?? 1); ++y) {
              for (let x = 0; x < part[0]; ++x) {
                const at = [x, y, z].map((one, axis) => (axis < field.dimensions ? one + first[axis] - from[axis] : 0));
                expected.push(whole[((plane * depth + at[2]) * height + at[1]) * width + at[0]]);
              }
            }
          }
        }
        assert.deepEqual(bits(field.grid(part, { ...place, step, first })), bits(expected));
        if (place.cell) continue;
        // An origin that is moved makes another grid, as long as its step is no power of two.
        const steps = typeof step === "number" ? of([step, step, step]) : step;
        const origin = place.origin.map((one, axis) => one + first[axis] * steps[axis]);
        moved += field.grid(part, { origin, step }).some((value, i) => value !== expected[i]);
      }
    }
  }
  assert.ok(moved > 20, `${moved} grids differ if their origin is moved`);
  const usual = new Field(2).grid([4, 4], { step: 0.1 });
  assert.deepEqual(usual, new Field(2).grid([4, 4], { step: 0.1, first: 0 }));
});

test("a grid of more points than are computed at once has the same values", () => {
  const field = new Field(2, { noise: "perlin_d" });
  for (const size of [[2500, 3], [3, 700], [1024, 2], [1, 1500]]) {
    const whole = field.grid(size, { step: 0.01 });
    const count = size[0] * size[1];
    for (const [x, y] of [[0, 0], [size[0] - 1, 0], [0, size[1] - 1], [size[0] - 1, size[1] - 1], [size[0] >> 1, size[1] >> 1]]) {
      const at = [x, y].map((i) => Math.fround(i * Math.fround(0.01)));
      const found = [0, 1, 2].map((plane) => whole[plane * count + y * size[0] + x]);
      assert.deepEqual(bits(found), bits(field.all(...at)), `${size} at ${[x, y]}`);
    }
  }
  const line = Float32Array.from({ length: 2051 }, (_, i) => i / 7);
  const many = field.points([line, line]);
  assert.equal(many[2050], field.at(line[2050], line[2050]));
  assert.equal(many[2051 * 2 + 1024], field.all(line[1024], line[1024])[2]);
});

test("cells are exact far out, and wrap at 2^32", () => {
  const field = new Field(2, { fractal: "fbm", seed: 7 });
  const grid = field.grid([5, 2], { step: 0.75, cell: [2 ** 31 - 2, -3], origin: [0.5, 0] });
  for (let y = 0; y < 2; ++y) {
    for (let x = 0; x < 5; ++x) {
      const at = [0.5 + 0.75 * x, 0.75 * y];
      const cell = [2 ** 31 - 2 + Math.floor(at[0]), -3 + Math.floor(at[1])];
      assert.equal(grid[5 * y + x], field.inCell(cell, at.map((one) => one - Math.floor(one))));
    }
  }
  assert.equal(field.inCell([2 ** 31, -3], [0.5, 0.25]), field.inCell([-(2 ** 31), -3 + 2 ** 32], [0.5, 0.25]));
  const fractions = [[0.5, 0.25], [0.75, 0]];
  const cells = [[1e9, 5], [2 ** 31, -5]];
  const alone = [0, 1].map((i) => field.inCell(cells[i], fractions[i]));
  assert.deepEqual(Array.from(field.points({ xy: fractions }, { cells: { xy: cells } })), alone);
  assert.equal(field.inCell([3, 4], [0.5, 0.25]), field.at(3.5, 4.25));
  // Steps backward, and smaller than the distance of floats there.
  const back = field.grid([3, 1], { step: [-0.5, 1], cell: [0, 0], origin: [0.25, 0] });
  assert.deepEqual(Array.from(back), [field.at(0.25, 0), field.at(-0.25, 0), field.at(-0.75, 0)]);
  assert.equal(new Set(field.grid([64, 1], { step: 2 ** -12, cell: [1e9, 0], origin: [0.25, 0.5] })).size, 64);
});

test("a position beyond all cells counts as the last one", () => {
  const field = new Field(2, { noise: "random" });
  for (const [far, last] of [[1e20, 2147483520], [2 ** 31, 2147483520], [-1e20, -(2 ** 31)]]) {
    assert.equal(field.at(far, 0.5), field.at(last, 0.5));
    assert.equal(field.at(last, 0.5), field.inCell([last, 0], [0, 0.5]));
  }
});

test("a list may be a typed array of any kind", () => {
  const field = new Field(2, { fractal: "fbm", period: new Int32Array([4, 5]) });
  assert.equal(field.at(0.5, 0.25), new Field(2, { fractal: "fbm", period: [4, 5] }).at(0.5, 0.25));
  const step = new Float64Array([0.1, 0.2]);
  assert.deepEqual(field.grid(new Uint16Array([5, 3]), { step, origin: new Float32Array([1.5, 2]) }),
    field.grid([5, 3], { step: [0.1, 0.2], origin: [1.5, 2] }));
  assert.deepEqual(field.grid([5, 3], { step, cell: new Float64Array([1e9, -3]) }), field.grid([5, 3], { step: [0.1, 0.2], cell: [1e9, -3] }));
  assert.equal(field.inCell(new Int8Array([3, 4]), new Float64Array([0.1, 0.7])), field.inCell([3, 4], [0.1, 0.7]));
  const [xs, ys] = [[0.1, 0.2, 0.3], [0.9, 0.8, 1]];
  assert.deepEqual(field.points([Float64Array.from(xs), Float32Array.from(ys)]), field.points([xs, ys]));
  const cells = [[1, 2, 3], [2 ** 31, 5, -6]];
  assert.deepEqual(field.points([xs, ys], { cells: cells.map((one) => Float64Array.from(one)) }), field.points([xs, ys], { cells }));
});

test("fields do not disturb each other, and neither do seeds and periods", () => {
  const one = new Field(2, { seed: 1 });
  const two = new Field(2, { seed: 2, fractal: "ridged" });
  const first = one.at(0.5, 0.25);
  const second = two.at(0.5, 0.25);
  assert.notEqual(first, second);
  assert.equal(one.at(0.5, 0.25), first);
  assert.equal(two.at(0.5, 0.25), second);
  const tile = new Field(2, { fractal: "fbm", period: [3, 4] });
  assert.equal(tile.at(0.5, 0.25), tile.at(3.5, -3.75));
});

test("what is passed to write into is written into", () => {
  const field = new Field(1, { noise: "perlin_d" });
  const out = new Float32Array(8);
  assert.equal(field.grid(4, { step: 0.3, out }), out);
  assert.deepEqual(out, field.grid([4], { step: [0.3] }));
  assert.equal(field.points([[0.1, 0.2, 0.3, 0.4]], { out }), out);
  assert.deepEqual(field.grid(0, { step: 1 }), new Float32Array(0));
  assert.deepEqual(field.points([[]]), new Float32Array(0));
});

test("options that there are not, and arrays that do not fit, are named in a line", () => {
  const field = new Field(2);
  assert.throws(() => field.grid([4, 4], { step: 1, orign: 2 }), /an option has to be one of step, origin, cell, first, out, not "orign"/);
  assert.throws(() => field.points([[1], [2]], { cell: [[1], [2]] }), /an option has to be one of cells, out, not "cell"/);
  assert.throws(() => field.grid([4, 4], { step: 1, out: new Float64Array(16) }), /out has to be a Float32Array, not Float64Array\(16\)$/);
  assert.throws(() => field.grid([2 ** 20, 2 ** 20], { step: 1 }), /room for 2147483647 values, not for 1099511627776/);
});

test("wrong settings are reported", () => {
  for (const [dimensions, settings, said] of [
    [4, {}, /dimensions has to be a whole number from 1 to 3, not 4/],
    [2, { noise: "perlim" }, /noise in 2D has to be one of perlin, .*, not "perlim"$/],
    [3, { fractal: "fbn" }, /fractal in 3D has to be one of fbm, .*, not "fbn"$/],
    [2, { fractal_type: "fbm" }, /a setting has to be one of noise, fractal, .*, not "fractal_type" \(here it is "fractal"\)$/],
    [2, { fractal: "None" }, /not "None" \(leave it out\)$/],
    [2, { noise: "worley" }, /not "worley" \(here it is "cellular"\)$/],
    [1, { noise: "voronoi" }, /noise in 1D has to be one of .*, not "voronoi"$/],
    [2, { noise: "OpenSimplex2" }, /not "OpenSimplex2" \(here it is "simplex"\)$/],
    [2, { frequency: 0.01 }, /not "frequency" \(multiply the position by it, since that is in cells\)$/],
    [2, { noiseType: "perlin" }, /not "noiseType" \(here it is "noise"\)$/],
    [1, { noise: "simplex" }, /noise in 1D has to be one of perlin, (?!.*simplex,).*, not "simplex"/],
    [2, { fractal: "eroded", noise: "perlin" }, /noise of eroded has to be one of perlin_d, value_d, simplex_d, not "perlin"/],
    [2, { noise: "fbm" }, /noise in 2D has to be one of .*, not "fbm" \(fbm is a fractal: pass { fractal: "fbm" }\)$/],
    [2, { fractal: "simplex" }, /fractal in 2D .*, not "simplex" \(simplex is a noise: pass { noise: "simplex" }\)$/],
    [2, { type: "fbm" }, /a setting has to be .*, not "type" \(fbm is a fractal: pass { fractal: "fbm" }\)$/],
    [2, { noiseType: "fbm" }, /not "noiseType" \(fbm is a fractal: pass { fractal: "fbm" }\)$/],
    [2, { octave: 3 }, /a setting has to be one of noise, .*, not "octave"$/],
    [2, { octaves: 3 }, /perlin has no octaves; only fractals do$/],
    [2, { fractal: "fbm", octaves: 33 }, /octaves has to be a whole number from 1 to 32, not 33/],
    [2, { fractal: "fbm", strength: 1 }, /fbm has no strength; ping_pong, weighted and eroded have one/],
    [2, { fractal: "weighted", strength: 2 }, /strength has to be from 0 to 1, not 2/],
    [2, { fractal: "fbm", gain: 1.5 }, /gain has to be from 0 to 1, not 1.5/],
    [2, { fractal: "fbm", lacunarity: 256 }, /lacunarity has to be from 0 to 255, not 256/],
    [2, { fractal: "fbm", lacunarity: 2.5, period: 8 }, /lacunarity with a period has to be a whole number from 1 to 255, not 2.5/],
    [2, { fractal: "fbm", lacunarity: NaN }, /lacunarity has to be a finite number, not NaN/],
    [2, { seed: -1 }, /seed has to be a whole number from 0 to 4294967295, not -1/],
    [2, { period: new Int32Array(3) }, /period has to be a number, or an array of 2, not Int32Array\(3\)$/],
    [2, { period: 2 ** 31 }, /period has to be a whole number from 0 to 2147483647, not 2147483648/],
    [2, { jitter: 1 }, /perlin has no jitter; cellular has one/],
    [2, { noise: "cellular", metric: "taxi" }, /metric has to be one of euclidean, .*, not "taxi"/],
  ]) {
    assert.throws(() => new Field(dimensions, settings), { name: "RangeError", message: said });
  }
  for (const [dimensions, settings, said] of [
    ["2", {}, /dimensions has to be a whole number from 1 to 3, not "2"$/],
    [2, { noise: 3 }, /not 3$/],
    [2, { fractal: "fbm", octaves: null }, /octaves has to be a whole number from 1 to 32, not null$/],
    [2, { seed: 7n }, /seed has to be a whole number from 0 to 4294967295, not 7n$/],
    [2, { period: new BigInt64Array(2) }, /period has to be a whole number from 0 to 2147483647, not 0n$/],
    [2, { noise: Object.create(null) }, /noise in 2D has to be one of .*, not an object$/],
    [2, { metric: Symbol("m"), noise: "cellular" }, /metric has to be one of .*, not Symbol\(m\)$/],
    [2, { period: [[4, 4], Object.create(null)] }, /period has to be a whole number from 0 to 2147483647, not \[4,4\]$/],
  ]) {
    assert.throws(() => new Field(dimensions, settings), { name: "TypeError", message: said });
  }
  for (const settings of ["fbm", null, [], 3, () => 3]) {
    const said = /settings have to be an object with some of noise, fractal, .*metric, not /;
    assert.throws(() => new Field(2, settings), { name: "TypeError", message: said });
  }
  for (const names of [Field.noises, Field.fractals]) assert.throws(() => names(4), /dimensions has to be a whole number from 1 to 3/);
  const field = new Field(2, { seed: undefined });
  for (const [call, said] of [
    [() => field.at(1), /a position has 2 coordinates here, not 1: pass \(x, y\), or arrays to points$/],
    [() => field.all([1, 2]), /^TypeError: a position has 2 coordinates here, not 1: pass \(x, y\), or arrays to points$/],
    [() => field.at([1], 2), /^TypeError: x has to be a finite number, not \[1\]: pass arrays to points$/],
    [() => new Field(1).at(new Float32Array(2)), /^TypeError: x has to be a finite number, not Float32Array\(2\): pass arrays to points$/],
    [() => field.inCell(1, 0, 0.5, 0.25), /^TypeError: pass a cell and a fraction, each a number or an array of 2, not 4 values$/],
    [() => field.allInCell([1, 2]), /^TypeError: pass a cell and a fraction, .*, not 1 values$/],
    [() => field.at(1, "2"), /y has to be a finite number, not "2"/],
    [() => field.at(1e39, 2), /^RangeError: x has to be a number up to 3.4e38, not 1e\+39$/],
    [() => field.at(Object.create(null), 2), /^TypeError: x has to be a finite number, not an object$/],
    [() => field.inCell([[1], Object.create(null), 2], [0.5, 0.5]), /cell has to be a number, or an array of 2, not \[\[1\],an object,2\]$/],
    [() => field.inCell([0.5, 1], [0.5, 0.5]), /cell has to be a whole number/],
    [() => field.grid([4, 4]), /step has to be a finite number, not undefined/],
    [() => field.grid([4, -4], { step: 1 }), /size has to be a whole number from 0/],
    [() => field.grid([4, 4], { step: 1, out: new Float32Array(15) }), /out has to be of the length 16, and is of 15/],
    [() => field.grid([4, 4], { step: 1, cell: 0, origin: 2 }), /origin has to be from 0 to 1, not 2/],
    [() => field.grid([4, 4], { step: 1e38, origin: 1 }), /the last point has to be a number up to 3.4e38, not 4e\+38/],
    [() => field.points([[1], [1]], { cells: [[1, 1, 1], [1, 1, 1]] }), /coordinates and of cells have to be of the same length/],
    [() => field.points([1, 2]), /the coordinates of an axis have to be an array, not 1: pass { x: \[...\], y: \[...\] } for the axes, or { xy: /],
    [() => field.points([[1, 2], [3, 4], [5, 6]]), /not an array of 3: pass { x: .*, or { xy: \[\[x, y\], ...\] } for the points$/],
    [() => field.points([[0.5, 0.25], [0.75, 0.125]]), /^TypeError: 2 arrays of 2 numbers each may be the coordinates of axes, or points: pass { x: /],
    [() => new Field(3).points([[1, 2, 3], [4, 5, 6], [7, 8, 9]]), /3 arrays of 3 numbers each .* { xyz: \[\[x, y, z\], ...\] }/],
    [() => field.points({ x: [0, 1], y: [1, 0] }, { cells: [[1, 2], [3, 4]] }), /2 arrays of 2 numbers each may be the cells of axes/],
    [() => field.points(new Float32Array(4)), /the coordinates have to be .*, not Float32Array\(4\): pass { x: .* { xy: /],
    [() => field.points({ x: [1] }), /the coordinates have to be { x: .*, y: .*, not an object with x$/],
    [() => field.points({ xyz: [[1, 2, 3]] }), /not an object with xyz$/],
    [() => field.points({ x: 1, y: 2 }), /the coordinates of an axis have to be an array, not 1: pass/],
    [() => field.points({ xy: 1 }), /the coordinates have to be an array, not 1: pass/],
    [() => field.points({ xy: [[1, 2], [3]] }), /a point has to be an array of 2 numbers, not \[3\] at 1$/],
    [() => field.points({ xy: [1, 2, 3] }), /the coordinates have to be 2 numbers for each point, not 3 in all$/],
    [() => field.points({ xy: [[1, 2], [3, "4"]] }), /the coordinates have to be finite numbers, not "4" at 1$/],
    [() => new Field(1).points([0.5, 0.25]), /an array of 1 arrays, one for each axis, not an array of 2: pass { x: \[...\] } for the axes$/],
    [() => field.grid([4, 4], { step: 1, first: 0.5 }), /first has to be a whole number from -536870911 to 536870911, not 0.5/],
    [() => field.grid([4, 4], { step: 1, first: [2 ** 29 - 4, 0] }), /first \+ size has to be a whole number from .* to 536870911, not 536870912/],
    [() => field.grid([4, 4], { step: 1e31, first: 2 ** 28 }), /the first point has to be a number up to 3.4e38, not 2.68435456e\+39/],
    [() => field.points([[1], [1, 2]]), /have to be of the same length/],
    [() => field.points([[1, 2, 5], [3, NaN, 5]]), /the coordinates have to be finite numbers, not NaN at 1$/],
    [() => field.points([[1], new Array(1)]), /the coordinates have to be finite numbers, not undefined at 0$/],
    [() => field.points([[1], [1]], { cells: [[1], [0.5]] }), /the cells have to be whole numbers, not 0.5 at 0$/],
    [() => field.points([[1], [2]], [[1], [2]]), /options have to be an object with some of cells, out, not \[\[1\],\[2\]\]$/],
    [() => field.grid([4, 4], 0.25), /options have to be an object with some of step, origin, cell, first, out, not 0.25$/],
    [() => field.points([[1], [1.5]], { cells: [[1], [1]] }), /the coordinates have to be from 0 to 1 in cells, not 1.5 at 0$/],
    [() => field.inCell([1, 2], [0.5, 1.5]), /fraction has to be from 0 to 1, not 1.5$/],
    [() => field.inCell(new Array(2), [0.5, 0.5]), /cell has to be a whole number from .*, not undefined$/],
  ]) {
    assert.throws(call, said);
  }
});

test("a function without its field has an error that states what to pass", () => {
  const { at, all, inCell, allInCell, points, grid } = new Field(2);
  const message = /^TypeError: a function of Field is called without its field: pass \(x, y\) => field.at\(x, y\)/;
  for (const call of [() => at(1, 2), () => all(1, 2), () => inCell(1, 0), () => allInCell(1, 0), () => points([[], []]),
    () => grid(4, { step: 1 }), () => [[1, 2]].map(at, {})]) {
    assert.throws(call, message);
  }
});

test("the documentation's calls in place of other libraries are noise in their ranges", async () => {
  const { noise2D, looped, noise, getNoise } = await import("./blocks/moving.js");
  const points = Array.from({ length: 500 }, (_, i) => [i * 0.37 - 11, 5 - i * 0.61]);
  for (const [called, least, most, scale] of [[noise2D, -1, 1, 1], [noise, 0, 1, 1], [getNoise, -1, 1, 100]]) {
    const values = points.map(([x, y]) => called(scale * x, scale * y));
    assert.ok(values.every((value) => value >= least && value <= most));
    assert.ok(new Set(values).size > 400);
  }
  for (const [x, y] of points) assert.equal(looped(x, y, 0), looped(x, y, 1));
  assert.notEqual(looped(0.5, 0.25, 0.1), looped(0.5, 0.25, 0.3));
  assert.equal(noise2D(0.5, 0.25), new Field(2, { noise: "simplex", seed: 120 }).at(0.5, 0.25));
});

test("the documentation's points are where it states, and its tiles meet", async () => {
  const field = new Field(2, { seed: 7 });
  const expected = [field.at(0.5, 0.25), field.at(0.75, 0.125)];
  const { ofAxes, ofPoints, farOut, ofVertices } = await import("./blocks/points.js");
  assert.deepEqual([ofAxes, ofPoints].map((found) => Array.from(found)), [expected, expected]);
  assert.deepEqual(Array.from(farOut), [field.inCell([1e9, 5], [0.5, 0]), field.inCell([1e9, 6], [0.75, 0.25])]);
  assert.equal(ofVertices.length, 24);
  assert.equal(ofVertices[0], new Field(3).at(0.5, 0.5, 0.5));
  assert.notDeepEqual(Array.from((await import("./faulty/points.js")).ofPoints), expected);
  const { tile, next, world } = await import("./blocks/world.js");
  const both = world.grid([128, 64], { step: 1 / 64, cell: [1e9, -1e9] });
  for (let i = 0; i < 64 * 64; ++i) {
    const at = (i >> 6) * 128 + (i & 63);
    assert.deepEqual([tile[i], next[i]], [both[at], both[at + 64]]);
  }
});

test("CommonJS has the same class by require", () => {
  assert.equal(createRequire(import.meta.url)("hashnoise").Field, Field);
});

/** Runs a task in a host whose `new WebAssembly.Module` and `compile` throw an error. */
async function inHost(error, task) {
  const { Module, compile } = WebAssembly;
  const refused = () => {
    throw error;
  };
  const again = await import(`${import.meta.resolve("hashnoise")}?${Math.random()}`); // a module of its own
  Object.assign(WebAssembly, { Module: function Refused() { refused(); }, compile: error instanceof RangeError ? compile : refused });
  Object.defineProperty(WebAssembly.Module, Symbol.hasInstance, { value: (one) => one instanceof Module });
  WebAssembly.Module.exports = Module.exports;
  try {
    await task(again);
    assert.equal(new again.Field(2).at(0.5, 0.25), new Field(2).at(0.5, 0.25));
  } finally {
    Object.assign(WebAssembly, { Module, compile });
  }
}

test("a host that compiles little or nothing prints what to do, and does it", async () => {
  const bytes = await readFile(fileURLToPath(import.meta.resolve("hashnoise/field.wasm")));
  const module = new WebAssembly.Module(bytes);
  await inHost(new RangeError("WebAssembly.Compile is disallowed on the main thread"), async ({ Field: One, init: start }) => {
    assert.throws(() => new One(2), /call `await init\(\)` of hashnoise first/);
    await start();
  });
  const message = /^Error: this host compiles no WebAssembly .* 'wasm-unsafe-eval' .* `await init\(module\)`; else `tools\/pick /;
  await inHost(new WebAssembly.CompileError("Wasm code generation disallowed by embedder"), async ({ Field: One, init: start }) => {
    assert.throws(() => new One(2), message);
    await assert.rejects(start(), message);
    for (const wrong of [bytes, null, "field.wasm", {}]) {
      await assert.rejects(start(wrong), /^TypeError: init takes the WebAssembly.Module of "hashnoise\/field.wasm", or nothing, not /);
    }
    const { validate } = WebAssembly;
    WebAssembly.validate = () => false;
    assert.throws(() => new One(2), /^Error: this host has no SIMD in WebAssembly; `tools\/pick /);
    WebAssembly.validate = validate;
    await start(module);
  });
  for (const code of ["new Field(2)", "await init()"]) {
    const { stderr } = spawnSync(process.execPath, ["--jitless", "--input-type=module", "-e", `import { Field, init } from "hashnoise"; ${code}`],
      { encoding: "utf8", cwd: import.meta.dirname });
    assert.match(stderr, /Error: this host has no WebAssembly \(node --jitless has none\); `tools\/pick /, code);
  }
  await init(); // once more
  await init(module); // and that, too, changes nothing
  assert.equal(new Field(2).at(1, 1), 0);
});
