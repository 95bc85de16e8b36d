// The twin: noises and fractals with the bits that HN_FIXED has in shaders. The functions are in WebAssembly (twin.cpp);
// this checks settings, and computes where the points are.
import { bytes } from "./twin.js";

const AXES = ["x", "y", "z"];
// The numbers at a point.
const SHAPES = {
  value: () => ["value"],
  slopes: (dimensions) => ["value", ...AXES.slice(0, dimensions).map((axis) => `d${axis}`)],
  two_distances: () => ["f1", "f2"],
  vector: (dimensions) => AXES.slice(0, dimensions),
};
// NOISES, FRACTALS, METRICS, NUMBERS and OWNERS: the functions, in the order of twin.cpp. The noise of a fractal is the one
// that it takes unless another of its shape is named, and its strength is the name of that number. OWNERS lists which
// noises or fractals have a setting.
// tools/pack npm: constants
const KNOWN = ["noise", "fractal", "seed", "period", "octaves", "lacunarity", "gain", "strength", "amplitude", "jitter", "metric"];
const OF_FRACTALS = ["octaves", "lacunarity", "gain"];
// Settings by their names in other libraries and before 1.0, without capitals and underscores; or what takes their place.
const MULTIPLY = "multiply the position by it, since that is in cells";
const DIVIDE = "divide the position by it, since that is in cells";
const ELSEWHERE = {
  noisetype: "noise", sum: "fractal", fractaltype: "fractal", persistence: "gain", distancefunction: "metric",
  cellularjitter: "jitter", pingpongstrength: "strength", weightedstrength: "strength", domainwarpamp: "amplitude",
  warpamplitude: "amplitude", repeat: "period", tile: "period", tileable: "period",
  frequency: MULTIPLY, freq: MULTIPLY, zoom: MULTIPLY, scale: DIVIDE, wavelength: DIVIDE,
};
// The names of a table, and what sets them.
const setBy = (setting, rows) => Object.fromEntries(Object.keys(rows).map((name) =>
  [bareName(name), `${name} is a ${setting}: pass { ${setting}: "${name}" }`]));
const FRACTALS_THERE = setBy("fractal", FRACTALS);
const NOISES_THERE = setBy("noise", NOISES);
// Noises, without the dimensions at their ends: those of closest.hpp.
const NOISES_ELSEWHERE = {
  ...FRACTALS_THERE,
  snoise: "simplex", opensimplex: "simplex", opensimplex2s: "simplex_smooth", pnoise: "perlin", cnoise: "perlin",
  worley: "cellular", voronoi: "cellular",
};
const FRACTALS_ELSEWHERE = { ...NOISES_THERE, none: "leave it out" };
const MOST_VALUES = 2 ** 31 - 1; // of an array, in every browser
const MOST_POINTS = 2 ** 29 - 1; // along an axis of a grid, as in field.hpp
const BATCH = 1024; // points, as in twin.cpp
const SETTINGS = 14; // words: the struct of twin.cpp

// ---------------------------------------------------------------------------------------------------------------------
// The module in WebAssembly. It is compiled where the first field is made, so that a page which makes none does
// nothing.

const PICK = "`tools/pick hn_fbm2 --language javascript` of hashnoise writes functions that need none";
const PRECOMPILED = 'pass a module that the host has compiled, `import module from "hashnoise/field.wasm"`, to `await init(module)`';

let twin;
let current; // the field whose settings are in it

function started(instance) {
  const { memory, settings, batch, split, run, at: valueAt } = instance.exports;
  const floats = (first, count = BATCH) => new Float32Array(memory.buffer, first, count);
  const at = batch();
  const plane = (number) => at + 4 * BATCH * number;
  return {
    split,
    run,
    valueAt,
    settings: new Uint32Array(memory.buffer, settings(), SETTINGS),
    cells: [0, 1, 2].map((axis) => new Int32Array(memory.buffer, plane(axis), BATCH)),
    places: [3, 4, 5].map((number) => floats(plane(number))),
    values: [6, 7, 8, 9].map((number) => floats(plane(number))),
  };
}

/** The error of a host that does not compile the module, and what to do there. */
function refusal(cause) {
  if (typeof WebAssembly === "undefined") return new Error(`this host has no WebAssembly (node --jitless has none); ${PICK}`);
  if (cause instanceof RangeError) {
    return new Error("this browser compiles only small modules at once: call `await init()` of hashnoise first", { cause });
  }
  if (!WebAssembly.validate(bytes())) return new Error(`this host has no SIMD in WebAssembly; ${PICK}`, { cause });
  return new Error("this host compiles no WebAssembly while it runs. On a page, add 'wasm-unsafe-eval' to the script-src of its " +
    `Content-Security-Policy; on a server such as Cloudflare's workerd, ${PRECOMPILED}; else ${PICK}`, { cause });
}

function start() {
  if (twin) return;
  try {
    twin = started(new WebAssembly.Instance(new WebAssembly.Module(bytes())));
  } catch (error) {
    throw refusal(error);
  }
}

function isOurs(module) {
  return typeof WebAssembly !== "undefined" && module instanceof WebAssembly.Module && WebAssembly.Module.exports(module).some(({ name }) => name === "split");
}

/**
 * Compiles the module ahead of the first field, beside other work. Pages for old browsers have to call it: Chromium
 * until 2023 compiles no more than 4 kB at once there. A host that compiles no module while it runs passes the one of
 * "hashnoise/field.wasm", which it has compiled.
 */
export async function init(module) {
  if (module !== undefined && !isOurs(module)) {
    throw new TypeError(`init takes the WebAssembly.Module of "hashnoise/field.wasm", or nothing, not ${shown(module)}`);
  }
  if (twin) return;
  let made;
  try {
    made = module ?? (await WebAssembly.compile(bytes()));
  } catch (error) {
    throw refusal(error);
  }
  const instance = await WebAssembly.instantiate(made);
  twin ??= started(instance);
}

// ---------------------------------------------------------------------------------------------------------------------
// Values that users pass.

/** The error of a value of the wrong type, or of the right one and beyond its range. */
const errorOf = (value, type) => (typeof value === type ? RangeError : TypeError);

function whole(name, value, least, most) {
  if (!Number.isInteger(value) || value < least || value > most) {
    throw new (errorOf(value, "number"))(`${name} has to be a whole number from ${least} to ${most}, not ${shown(value)}`);
  }
  return value;
}

const isFraction = (value) => typeof value === "number" && value >= 0 && value <= 1;
const isFloat = (value) => typeof value === "number" && Number.isFinite(Math.fround(value));

function real(name, value, least = -Infinity, most = Infinity) {
  if (!isFloat(value)) {
    const right = Number.isFinite(value) ? "number up to 3.4e38" : "finite number";
    const hint = AXES.includes(name) && isList(value) ? ": pass arrays to points" : "";
    throw new (errorOf(value, "number"))(`${name} has to be a ${right}, not ${shown(value)}${hint}`);
  }
  if (value < least || value > most) {
    throw new RangeError(`${name} has to be ${most === Infinity ? `${least} or more` : `from ${least} to ${most}`}, not ${value}`);
  }
  return value;
}

// HN_FIXED takes a lacunarity and a gain beyond these as the nearer end, and in a tile drops the fraction of a
// lacunarity.
const MOST_IN_FIXED = { lacunarity: 255, gain: 1 };
const inFixed = (name, value) => real(name, value, 0, MOST_IN_FIXED[name]);
const wholeInTile = (name, value) => whole(`${name} with a period`, value, 1, MOST_IN_FIXED[name]);

function oneOf(name, value, names, elsewhere = {}) {
  if (!names.includes(value)) {
    const hint = typeof value === "string" ? hintOf(bareName(value), names, elsewhere) : "";
    throw new (errorOf(value, "string"))(`${name} has to be one of ${names.join(", ")}, not ${shown(value)}${hint}`);
  }
  return value;
}

function bareName(name) {
  return name.toLowerCase().replaceAll("_", "");
}

/** For a name of another library or of another setting: what takes its place here. */
function hintOf(bare, names, elsewhere) {
  const known = [bare, bare.replace(/[1-4d]+$/, "")].find((one) => Object.hasOwn(elsewhere, one));
  const meant = elsewhere[known] ?? "";
  if (names.includes(meant)) return ` (here it is "${meant}")`;
  return meant.includes(" ") ? ` (${meant})` : ""; // a noise that these dimensions do not have
}

function shown(value, depth = 2) {
  if (typeof value === "string") return `"${value}"`;
  if (typeof value === "bigint") return `${value}n`;
  if (Array.isArray(value)) {
    if (value.length > 8) return `an array of ${value.length}`;
    return depth === 0 ? "[...]" : `[${Array.from(value, (one) => shown(one, depth - 1))}]`;
  }
  if (isList(value)) return `${value.constructor.name}(${value.length})`;
  if (typeof value === "function") return "a function";
  return typeof value === "object" && value !== null ? "an object" : String(value); // which need not convert to a string
}

const isList = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));

/** The setting of a value, for a message, unless `by` is that one. */
function ofValue(value, by) {
  if (Object.hasOwn(FRACTALS_THERE, value)) return by !== "fractal" && FRACTALS_THERE[value];
  return Object.hasOwn(NOISES_THERE, value) && by !== "noise" && NOISES_THERE[value];
}

/** The values that an object of settings or options has; its names have to be among these. */
function given(kind, object, names, elsewhere) {
  if (typeof object !== "object" || object === null || Array.isArray(object)) {
    throw new TypeError(`${kind}s have to be an object with some of ${names.join(", ")}, not ${shown(object)}`);
  }
  for (const [name, value] of Object.entries(object)) {
    const bare = bareName(name);
    const meant = elsewhere && typeof value === "string" && ofValue(bareName(value), elsewhere[bare]); // as in `type: "fbm"`
    oneOf(`${kind === "option" ? "an" : "a"} ${kind}`, name, names, meant ? { ...elsewhere, [bare]: meant } : elsewhere);
  }
  return Object.fromEntries(Object.entries(object).filter(([, value]) => value !== undefined));
}

/** A number for each axis, from one for all or from an array of them, typed or not. */
function perAxis(name, value, dimensions, check) {
  const values = isList(value) ? value : Array(dimensions).fill(value);
  if (values.length !== dimensions) {
    throw new RangeError(`${name} has to be a number, or an array of ${dimensions}, not ${shown(value)}`);
  }
  return Array.from(values, (one) => check(name, one)); // map() would pass over empty places
}

/**
 * An array of numbers for each axis: of `{ x, y }`, of points by the name of their coordinates, `{ xy }`, or of an array
 * of such arrays. As many points as axes may be meant there, so that is refused.
 */
function axesOf(name, value, dimensions, what, good) {
  const axes = AXES.slice(0, dimensions);
  const all = axes.join("");
  const forms = `{ ${axes.map((axis) => `${axis}: [...]`).join(", ")} } for the axes`
    + (dimensions > 1 ? `, or { ${all}: [[${axes.join(", ")}], ...] } for the points` : "");
  let arrays = value;
  if (typeof value === "object" && value !== null && !isList(value)) {
    const keys = Object.keys(value).filter((key) => value[key] !== undefined);
    if (dimensions > 1 && keys.length === 1 && keys[0] === all) {
      arrays = columns(name, value[all], dimensions, forms);
    } else if (keys.length === dimensions && axes.every((axis) => keys.includes(axis))) {
      arrays = axes.map((axis) => value[axis]);
    } else {
      throw new TypeError(`the ${name} have to be ${forms}, not an object with ${keys.join(", ") || "nothing"}`);
    }
  } else if (!Array.isArray(value) || value.length !== dimensions) {
    const said = Array.isArray(value) ? `an array of ${value.length}` : shown(value);
    throw new TypeError(`the ${name} have to be an array of ${dimensions} arrays, one for each axis, not ${said}: pass ${forms}`);
  } else if (dimensions > 1 && value.every((array) => isList(array) && array.length === dimensions)) {
    throw new TypeError(`${dimensions} arrays of ${dimensions} numbers each may be the ${name} of axes, or points: pass ${forms}`);
  }
  for (const array of arrays) {
    if (!isList(array)) throw new TypeError(`the ${name} of an axis have to be an array, not ${shown(array)}: pass ${forms}`);
    if (array.length !== arrays[0].length) throw new RangeError(`the arrays of ${name} have to be of the same length`);
    const bad = array.findIndex((one) => !good(one));
    if (bad >= 0) throw new (errorOf(array[bad], "number"))(`the ${name} have to be ${what}, not ${shown(array[bad])} at ${bad}`);
  }
  return arrays;
}

/** The arrays of axes of points, which are arrays of `dimensions` numbers, or one array of all their numbers. */
function columns(name, points, dimensions, forms) {
  if (!isList(points)) throw new TypeError(`the ${name} have to be an array, not ${shown(points)}: pass ${forms}`);
  const axes = AXES.slice(0, dimensions);
  if (points.length === 0 || !isList(points[0])) {
    if (points.length % dimensions) {
      throw new RangeError(`the ${name} have to be ${dimensions} numbers for each point, not ${points.length} in all`);
    }
    return axes.map((_, axis) => Array.from({ length: points.length / dimensions }, (_, i) => points[i * dimensions + axis]));
  }
  const bad = points.findIndex((point) => !isList(point) || point.length !== dimensions);
  if (bad >= 0) throw new TypeError(`a point has to be an array of ${dimensions} numbers, not ${shown(points[bad])} at ${bad}`);
  return axes.map((_, axis) => Array.from(points, (point) => point[axis]));
}

const checkedDimensions = (dimensions) => whole("dimensions", dimensions, 1, 3);

function namesIn(rows, dimensions) {
  checkedDimensions(dimensions);
  return Object.keys(rows).filter((name) => rows[name].dimensions.includes(dimensions));
}

const inItsCell = (name, value) => real(name, value, 0, 1);
const wholeCell = (name, value) => whole(name, value, Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER) | 0;

/** The field of a call. To bind functions in the constructor would make calls of several fields in turns slower. */
function fieldOf(field) {
  if (field instanceof Field) return field;
  throw new TypeError("a function of Field is called without its field: pass (x, y) => field.at(x, y) in place of field.at");
}

// ---------------------------------------------------------------------------------------------------------------------

/** A noise or a fractal in one, two or three dimensions, with the bits of HN_FIXED. Its settings do not change. */
export class Field {
  #settings;

  constructor(dimensions, settings = {}) {
    checkedDimensions(dimensions);
    const set = given("setting", settings, KNOWN, ELSEWHERE);
    const of = (name, usual) => (name in set ? set[name] : usual);
    const fractal = "fractal" in set ? oneOf(`fractal in ${dimensions}D`, set.fractal, Field.fractals(dimensions), FRACTALS_ELSEWHERE) : undefined;
    const row = fractal ? FRACTALS[fractal] : undefined;
    const noises = Field.noises(dimensions).filter((name) => !row || NOISES[name].shape === NOISES[row.noise].shape);
    const place = fractal ? `noise of ${fractal}` : `noise in ${dimensions}D`;
    const noise = oneOf(place, of("noise", row?.noise ?? "perlin"), noises, NOISES_ELSEWHERE);
    const refuse = (name, why) => {
      if (name in set) throw new RangeError(`${fractal ?? noise} has no ${name}; ${why}`);
    };
    if (!fractal) for (const name of OF_FRACTALS) refuse(name, "only fractals do");
    const takes = fractal ? [row.strength] : NOISES[noise].takes;
    for (const [name, owners] of Object.entries(OWNERS)) if (!takes.includes(name)) refuse(name, owners);
    const ruled = (check, name, value) => check(name, value, NUMBERS[name].least, NUMBERS[name].most);
    const number = (name, check = real) => ruled(check, name, of(name, NUMBERS[name].usual));
    const period = perAxis("period", of("period", NUMBERS.period.usual), dimensions, (name, one) => ruled(whole, name, one));
    const isTile = period.some((one) => one > 0);
    const words = new Uint32Array(SETTINGS);
    const floats = new Float32Array(words.buffer);
    words.set([dimensions, Object.keys(NOISES).indexOf(noise), Object.keys(FRACTALS).indexOf(fractal), isTile]);
    words[4] = number("seed", whole);
    words.set(period, 5);
    floats[8] = number("jitter");
    words[9] = METRICS.indexOf(oneOf("metric", of("metric", METRICS[0]), METRICS)) + 1;
    words[10] = number("octaves", whole);
    floats[11] = number("lacunarity", isTile ? wholeInTile : inFixed);
    floats[12] = number("gain", inFixed);
    floats[13] = row?.strength ? real(row.strength, of(row.strength, row.usual), 0, row.most) : 0;
    this.#settings = words;
    this.dimensions = dimensions;
    /** The numbers at a point. */
    this.components = Object.freeze(SHAPES[(row ?? NOISES[noise]).shape](dimensions));
    Object.freeze(this);
    start();
  }

  /** The names of the noises that there are in so many dimensions. */
  static noises(dimensions) {
    return namesIn(NOISES, dimensions);
  }

  /** The names of the fractals that there are in so many dimensions. */
  static fractals(dimensions) {
    return namesIn(FRACTALS, dimensions);
  }

  #load() {
    start();
    if (current === this) return;
    twin.settings.set(this.#settings);
    current = this;
  }

  #go(count, x, y, z) {
    const { dimensions } = this;
    if (count !== dimensions) {
      throw new TypeError(`a position has ${dimensions} coordinates here, not ${count}: pass (${AXES.slice(0, dimensions).join(", ")}), or arrays to points`);
    }
    real("x", x);
    if (dimensions > 1) real("y", y);
    if (dimensions > 2) real("z", z);
    this.#load();
    return twin.valueAt(x, y, z);
  }

  #enter(count, cell, fraction) {
    const { dimensions } = this;
    if (count !== 2) throw new TypeError(`pass a cell and a fraction, each a number or an array of ${dimensions}, not ${count} values`);
    const cells = perAxis("cell", cell, dimensions, wholeCell);
    const fractions = perAxis("fraction", fraction, dimensions, inItsCell);
    this.#load();
    for (let axis = 0; axis < dimensions; ++axis) {
      twin.cells[axis][0] = cells[axis];
      twin.places[axis][0] = fractions[axis];
    }
    twin.run(1);
  }

  #components() {
    return this.components.map((_, i) => twin.values[i][0]);
  }

  /**
   * The first component at a position, in cells. From 2^23 on a float has no fraction, and from 2^31 on a position counts
   * as the last cell before it: far out use inCell, and cells of points and grid.
   */
  at(x, y, z) {
    return fieldOf(this).#go(arguments.length, x, y, z);
  }

  /** All components at a position. */
  all(...position) {
    fieldOf(this).#go(position.length, ...position);
    return this.#components();
  }

  /** The first component in a cell, at a fraction in it from 0 to 1 along each axis: exact however far out. */
  inCell(cell, fraction) {
    fieldOf(this).#enter(arguments.length, cell, fraction);
    return twin.values[0][0];
  }

  /** All components there. */
  allInCell(cell, fraction) {
    fieldOf(this).#enter(arguments.length, cell, fraction);
    return this.#components();
  }

  /**
   * The values at many positions: `{ x, y }`, an array of coordinates for each axis, or `{ xy }`, an array of points or
   * their numbers one behind the other. With `cells`, whole numbers in one of these forms, the coordinates are the
   * fractions in those.
   */
  points(coordinates, options = {}) {
    const { dimensions } = fieldOf(this);
    const { cells, out } = given("option", options, ["cells", "out"]);
    const places = cells === undefined ? ["finite numbers", isFloat] : ["from 0 to 1 in cells", isFraction];
    const axes = axesOf("coordinates", coordinates, dimensions, ...places);
    const cellAxes = cells === undefined ? undefined : axesOf("cells", cells, dimensions, "whole numbers", Number.isSafeInteger);
    const count = axes[0].length;
    if (cellAxes && cellAxes[0].length !== count) {
      throw new RangeError("the arrays of coordinates and of cells have to be of the same length");
    }
    const values = this.#out(out, count);
    this.#load();
    for (let first = 0; first < count; first += BATCH) {
      const some = Math.min(BATCH, count - first);
      for (let axis = 0; axis < dimensions; ++axis) {
        twin.places[axis].set(part(axes[axis], first, some));
        if (cellAxes) {
          twin.cells[axis].set(part(cellAxes[axis], first, some));
        } else {
          twin.split(axis, some);
        }
      }
      this.#compute(values, count, first, some);
    }
    return values;
  }

  /**
   * A uniform grid of size[0] by size[1] points and so on, from `origin` on, `step` cells apart; x is the fastest. With
   * a `cell` the origin is the fraction in it, and the grid is exact however far out. With `first`, the number of the
   * first point along each axis, it is that part of a larger grid, and has its bits.
   */
  grid(size, options = {}) {
    const { dimensions } = fieldOf(this);
    const { step, origin = 0, cell, first = 0, out } = given("option", options, ["step", "origin", "cell", "first", "out"]);
    const sizes = perAxis("size", size, dimensions, (name, one) => whole(name, one, 0, MOST_POINTS));
    const steps = perAxis("step", step, dimensions, real);
    const origins = perAxis("origin", origin, dimensions, cell === undefined ? real : inItsCell);
    const firsts = perAxis("first", first, dimensions, (name, one) => whole(name, one, -MOST_POINTS, MOST_POINTS));
    sizes.forEach((one, axis) => {
      whole("first + size", firsts[axis] + one, -MOST_POINTS, MOST_POINTS);
      if (cell !== undefined) return;
      real("the first point", origins[axis] + firsts[axis] * steps[axis]);
      real("the last point", origins[axis] + (firsts[axis] + one) * steps[axis]);
    });
    const count = sizes.reduce((product, one) => product * one, 1);
    const values = this.#out(out, count);
    if (count === 0) return values;
    this.#load();
    const axes = sizes.map((points, axis) => {
      if (cell === undefined) return positions(axis, points, origins[axis], steps[axis], firsts[axis]);
      return exactly(points, perAxis("cell", cell, dimensions, wholeCell)[axis], origins[axis], steps[axis], firsts[axis]);
    });
    // Rows, or parts of them, are put one behind the other until a batch is full.
    const [row, ...others] = axes;
    const index = others.map(() => 0);
    let done = 0;
    let some = 0;
    for (let x = 0; done + some < count;) {
      const length = Math.min(sizes[0] - x, BATCH - some);
      twin.cells[0].set(row.cells.subarray(x, x + length), some);
      twin.places[0].set(row.places.subarray(x, x + length), some);
      others.forEach(({ cells, places }, i) => {
        twin.cells[i + 1].fill(cells[index[i]], some, some + length);
        twin.places[i + 1].fill(places[index[i]], some, some + length);
      });
      x += length;
      some += length;
      if (x === sizes[0]) {
        x = 0;
        for (let i = 0; i < index.length && ++index[i] === sizes[i + 1]; ++i) index[i] = 0;
      }
      if (some === BATCH || done + some === count) {
        this.#compute(values, count, done, some);
        done += some;
        some = 0;
      }
    }
    return values;
  }

  #out(out, count) {
    const length = count * this.components.length;
    if (out === undefined) {
      if (length > MOST_VALUES) throw new RangeError(`an array has room for ${MOST_VALUES} values, not for ${length}`);
      return new Float32Array(length);
    }
    if (!(out instanceof Float32Array)) throw new TypeError(`out has to be a Float32Array, not ${shown(out)}`);
    if (out.length !== length) {
      throw new RangeError(`out has to be of the length ${length}, and is of ${out.length}`);
    }
    return out;
  }

  #compute(values, count, first, some) {
    twin.run(some);
    this.components.forEach((_, i) => values.set(twin.values[i].subarray(0, some), i * count + first));
  }
}

function part(array, first, count) {
  return Array.isArray(array) ? array.slice(first, first + count) : array.subarray(first, first + count);
}

// The cells and the places along an axis. Point i is at the float nearest to origin + (number + i) * step.
function positions(axis, count, origin, step, number) {
  const cells = new Int32Array(count);
  const places = new Float32Array(count);
  const from = Math.fround(origin);
  const by = Math.fround(step);
  for (let first = 0; first < count; first += BATCH) {
    const some = Math.min(BATCH, count - first);
    for (let i = 0; i < some; ++i) twin.places[axis][i] = from + (number + first + i) * by;
    twin.split(axis, some);
    cells.set(twin.cells[axis].subarray(0, some), first);
    places.set(twin.places[axis].subarray(0, some), first);
  }
  return { cells, places };
}

// In units of 2^-32 of a cell; a place keeps 24 bits of them.
function exactly(count, cell, origin, step, number) {
  const cells = new Int32Array(count);
  const places = new Float32Array(count);
  const unit = 2 ** 32;
  const by = BigInt(Math.sign(step) * Math.round(Math.abs(step) * unit));
  let at = (BigInt(cell) << 32n) + BigInt(Math.floor(Math.fround(origin) * unit)) + BigInt(number) * by;
  for (let i = 0; i < count; ++i, at += by) {
    cells[i] = Number(BigInt.asIntN(32, at >> 32n));
    places[i] = Number(BigInt.asUintN(32, at) >> 8n) / 2 ** 24;
  }
  return { cells, places };
}
