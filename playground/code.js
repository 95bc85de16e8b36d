// The functions of what is shown, in each language. The page draws with the same functions: the text that is copied has
// numbers where that of the page has uniforms, so that no shader is compiled again when a number changes.
import { kNoises, kSums, uses } from "./model.js";

export const kLanguages = { glsl: "GLSL", hlsl: "HLSL", wgsl: "WGSL", cpp: "C++" };

const vector = (prefix, scalar) => (n) => (n === 1 ? scalar : `${prefix}${n}`);
export const kTypes = {
  glsl: { float: vector("vec", "float"), int: vector("ivec", "int"), uint: "uint" },
  hlsl: { float: vector("float", "float"), int: vector("int", "int"), uint: "uint" },
  cpp: { float: vector("vec", "float"), int: vector("ivec", "int"), uint: "uint" },
  wgsl: { float: (n) => (n === 1 ? "f32" : `vec${n}f`), int: (n) => (n === 1 ? "i32" : `vec${n}i`), uint: "u32" },
};

export const decimal = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));

export const declaration = (language, type, name, value) =>
  language === "wgsl" ? `let ${name} = ${value};` : `${type} ${name} = ${value};`;

// A number as a float of the language.
function literal(language, value) {
  return language === "cpp" ? `${decimal(value)}f` : decimal(value);
}

// What the functions are called with, as numbers.
export function numbers(language, state) {
  const { int } = kTypes[language];
  const n = state.dimensions;
  const whole = String(state.period);
  const alike = language === "hlsl" && n > 1 ? Array(n).fill(whole).join(", ") : whole;
  return {
    seed: `${state.seed}u`,
    otherSeed: `${(state.seed + 1) % 4294967296}u`,
    octaves: String(state.octaves),
    lacunarity: literal(language, state.lacunarity),
    gain: literal(language, state.gain),
    strength: literal(language, state.strength),
    amplitude: literal(language, state.amplitude),
    jitter: literal(language, state.jitter),
    phase: literal(language, state.phase),
    period: n === 1 ? whole : `${int(n)}(${alike})`,
  };
}

// Which forms of the functions what is shown needs. States that agree in this have one shader.
function shape(state) {
  const used = uses(state);
  return {
    ...state,
    warp: used.warp ? state.warp : "none",
    metric: used.metric ? state.metric : "euclidean",
    tiled: state.period > 0,
    turned: used.phase && state.phase > 0,
    full: (used.jitter && state.jitter !== 1) || (used.metric && state.metric !== "euclidean"),
  };
}

// What a sum makes of the mean, by what the catalog calls it: the function that ends the loop, and what becomes of that.
const kMeans = {
  density: { end: "hn_density" },
  billows: { of: (mean) => `min(2.0 * ${mean} - 1.0, 1.0)` },
  bounded: { of: (mean) => `min(max(${mean}, -1.0), 1.0)` }, // roundings may take it beyond
};

// The functions of what is shown, in one language. `values` are what numbers() returns, or names of uniforms.
class Writer {
  constructor(library, language, state, values) {
    this.library = library;
    this.language = language;
    this.state = shape(state);
    this.values = values;
    this.types = kTypes[language];
    this.noise = kNoises[state.noise];
    this.files = new Set();
    this.needs = new Set(); // what the functions call, by the names in WGSL
    this.summed = state.sum !== "none";
    // Where a noise is asked: at a position, in a cell, or at a place that is given.
    this.position = { position: "p" };
    this.cell = { cell: "cell", f: "f" };
    this.place = { place: "place" };
  }

  get n() {
    return this.state.dimensions;
  }

  number(text) {
    return this.language === "cpp" ? text.replace(/\b\d+\.\d+\b/g, "$&f") : text;
  }

  // A call of a function of the library by the name that it has in WGSL, which has no overloads.
  called(name, renamed, ...passed) {
    this.needs.add(renamed);
    return `${this.language === "wgsl" ? renamed : name}(${passed.join(", ")})`;
  }

  // A call of a noise or of a sum, in a tile if the state has one. A place that is given is in it already.
  call(name, { position, cell, f, place }, form, ...rest) {
    const { n, state, values } = this;
    let passed = place ?? position ?? this.called("hn_place", `hn_place_of_cell${n}`, cell, f);
    if (state.tiled && !place) {
      passed = this.called("hn_tile", `hn_tile${n}${cell ? "_place" : ""}`, passed, values.period);
    }
    const placed = place || cell || state.tiled ? "_place" : "";
    return this.called(name, `${name}${n}${placed}${form && `_${form}`}`, passed, ...rest);
  }

  let(type, name, value) {
    return declaration(this.language, type, name, value);
  }

  // A function of our own, of one or of several lines.
  define(name, parameters, lines) {
    const { float } = this.types;
    if (this.language === "wgsl") {
      const list = parameters.map(([type, parameter]) => `${parameter}: ${type}`).join(", ");
      return this.body(`fn ${name}(${list}) -> ${float(1)} {`, lines);
    }
    const list = parameters.map(([type, parameter]) => `${type} ${parameter}`).join(", ");
    return this.body(`${this.language === "cpp" ? "inline " : ""}${float(1)} ${name}(${list}) {`, lines);
  }

  body(head, lines) {
    if (lines.length === 1 && head.length + lines[0].length < 118) return [`${head} ${lines[0]} }`];
    return [head, ...lines.map((line) => `  ${line}`), "}"];
  }

  // The noise itself at a place: the lines before its value, and the value.
  noiseAt(where, values) {
    const { noise, state } = this;
    const { float, int } = this.types;
    const cellular = noise.metric || noise.jitter;
    const metric = `HN_METRIC_${state.metric.toUpperCase()}`;
    this.files.add(`${noise.file}${state.turned ? "_phase" : ""}${this.n}d.glsl`);
    if (noise.metric && (state.full || noise.nearest)) this.needs.add(metric);
    if (noise.nearest) {
      const wgsl = this.language === "wgsl";
      const set = wgsl ? ["&nearest", "&offset"] : ["nearest", "offset"];
      const call = this.call(noise.calls, where, "nearest", values.jitter, metric, values.seed, ...set);
      const word = this.called("hn_lattice", `hn_lattice${this.n}`, "nearest", values.otherSeed);
      return {
        lines: wgsl
          ? [`var nearest: ${int(this.n)};`, `var offset: ${float(this.n)};`, `${call};`]
          : [`${int(this.n)} nearest;`, `${float(this.n)} offset;`, `${call};`],
        value: this.called("hn_unorm", "hn_unorm", word),
      };
    }
    let call;
    if (cellular && state.full) {
      call = this.call(noise.calls, where, "full", values.jitter, ...(noise.metric ? [metric] : []), values.seed);
    } else if (state.turned) {
      call = this.call(noise.calls, where, "phase", values.phase, values.seed);
    } else {
      call = this.call(noise.calls, where, "", values.seed);
    }
    if (noise.between) {
      return { lines: [this.let(float(2), "distances", call)], value: "distances.y - distances.x" };
    }
    return { lines: [], value: noise.of ? noise.of(call) : call };
  }

  // The noise that a sum takes: the library's own, or a function of ours that makes one of distances.
  summedNoise() {
    const { noise, state } = this;
    if (!noise.signed) {
      const steep = kSums[state.sum].steep ? "_d" : "";
      this.files.add(`${noise.file}${steep}${this.n}d.glsl`);
      return { name: `${noise.calls}${steep}`, lines: [] };
    }
    const values = { ...this.values, seed: "seed", otherSeed: "seed + 1u" };
    const { lines, value } = this.noiseAt(this.place, values);
    const parameters = [
      [`hn_place${this.n}`, "place"],
      [this.types.uint, "seed"],
    ];
    return {
      name: state.noise,
      lines: this.define(state.noise, parameters, [...lines, `return ${this.number(noise.signed(value))};`]),
    };
  }

  // Sets the function of the sum, and returns the lines that define it: over another noise than the library's own it is
  // a loop over octaves.
  defineSum() {
    const { state, n } = this;
    const { mean: made, steep, strength } = kSums[state.sum];
    this.files.add(`${steep ? "fbm_d" : "fbm"}${n}d.glsl`);
    this.sum = `hn_${state.sum}`;
    if (state.noise === "perlin") return [];
    const noise = this.summedNoise();
    this.sum = `${state.sum}_${state.noise}`;
    const wgsl = this.language === "wgsl";
    const step = `hn_add${kSums[state.sum].step ? `_${kSums[state.sum].step}` : ""}`;
    const { end = "hn_mean", of = (mean) => mean } = kMeans[made] ?? {};
    const set = (name) => (wgsl ? `&${name}` : name);
    const at = ["o.place", "o.seed"];
    const octave = noise.lines.length
      ? `${noise.name}(${at.join(", ")})`
      : this.called(noise.name, `${noise.name}${n}_place`, ...at);
    const rest = [...(steep ? [set("s")] : []), octave, ...(strength ? ["strength"] : [])];
    const add = this.called(step, `${step}${n}`, set("o"), ...rest);
    const next = this.called("hn_next", `hn_next${n}`, set("o"));
    const mean = of(this.called(end, `${end}${n}`, "o"));
    const slopes = wgsl ? `var s: hn_slopes${n}` : `hn_slopes${n} s`;
    const lines = [
      ...(steep ? [`${slopes} = ${this.called("hn_slopes", `hn_slopes_of${n}`, "o")};`] : []),
      ...(wgsl
        ? ["loop {", `  ${add};`, `  continuing { break if !(${next}); }`, "}"]
        : [`do ${add}; while (${next});`]),
      `return ${this.number(mean)};`,
    ];
    const parameters = [
      [`hn_octaves${n}`, wgsl ? "o_in" : "o"],
      ...(strength ? [[this.types.float(1), "strength"]] : []),
    ];
    if (wgsl) lines.unshift("var o = o_in;");
    return [...noise.lines, ...this.define(this.sum, parameters, lines)];
  }

  // The value at a place, with the lines before it.
  shownAt(where) {
    const { state, values } = this;
    if (!this.summed) return this.noiseAt(where, values);
    const settings = [values.octaves, values.lacunarity, values.gain];
    const strength = kSums[state.sum].strength ? [values.strength] : [];
    if (this.sum.startsWith("hn_")) {
      return { lines: [], value: this.call(this.sum, where, "", ...settings, ...strength, values.seed) };
    }
    const name = this.language === "wgsl" ? "hn_octaves_of" : "hn_octaves";
    const octaves = this.call(name, where, "", ...settings, values.seed);
    return { lines: [], value: `${this.sum}(${[octaves, ...strength].join(", ")})` };
  }

  // A shift of the place, and where it leads.
  moved(where) {
    const { state, values } = this;
    if (state.warp === "none") return { lines: [], where };
    this.files.add(`warp${this.n}d.glsl`);
    const { float, int } = this.types;
    const shift = this.call(
      `hn_${state.warp}`,
      where,
      "",
      values.octaves,
      values.lacunarity,
      values.gain,
      values.amplitude,
      values.otherSeed,
    );
    if (!where.cell) return { lines: [this.let(float(this.n), "q", `p + ${shift}`)], where: { position: "q" } };
    return {
      lines: [this.let(float(this.n), "q", `f + ${shift}`), this.let(float(this.n), "whole", "floor(q)")],
      where: { cell: `cell + ${int(this.n)}(whole)`, f: "q - whole" },
    };
  }

  // "pattern" at a place.
  pattern(where) {
    const { float, int } = this.types;
    const { lines, where: there } = this.moved(where);
    const shown = this.shownAt(there);
    const name = this.language === "wgsl" && where.cell ? "pattern_cell" : "pattern";
    const parameters = where.cell
      ? [
          [int(this.n), "cell"],
          [float(this.n), "f"],
        ]
      : [[float(this.n), "p"]];
    return this.define(name, parameters, [...lines, ...shown.lines, `return ${shown.value};`]);
  }

  // {definitions: lines, files, needs}: "pattern" in these forms.
  write(forms) {
    const sums = this.summed ? this.defineSum() : [];
    const patterns = forms.flatMap((form) => this.pattern(this[form]));
    return {
      lines: [...sums, ...(sums.length ? [""] : []), ...patterns],
      files: [...this.files],
      needs: [...this.needs],
      public: [...this.needs].filter((name) => /^hn_(?!i_|place\d$)/.test(name)),
    };
  }
}

// The forms are "cell", pattern(cell, f), and "position", pattern(p).
export function functions(library, language, state, values, forms = ["cell", "position"]) {
  return new Writer(library, language, state, values).write(forms);
}

// What names the shader of a state: states with the same key differ in uniforms alone.
export function shaderKey(state) {
  const { noise, sum, dimensions, warp, metric, arithmetic, hash, tiled, turned, full } = shape(state);
  return [noise, sum, dimensions, warp, full ? metric : "", arithmetic, hash, tiled, turned].join(" ");
}

// The knobs that differ from the library's defaults.
export function knobs({ arithmetic, hash }) {
  return [
    ...(arithmetic === "fixed" ? ["#define HN_ARITHMETIC HN_FIXED"] : []),
    ...(hash === "lattice" ? [] : [`#define HN_HASH HN_HASH_${hash.toUpperCase()}`]),
  ];
}
