// The functions of the picture, in each language. The page draws with the same functions: the text that is copied has
// numbers where that of the page has uniforms, so that no shader is compiled again when a number changes.
import { combined } from "./combine.js";
import { driftOf, isDrifting, isLeaning, isSolid, remapOf, settingsOf, shownLayers, tintedLayers, uses } from "./model.js";
import { kMetrics, kNoises, kSums } from "./tables.js";

// In the order of the page. Languages behind C++ have one form, and no library beside it.
export const kLanguages = {
  glsl: "GLSL", hlsl: "HLSL", wgsl: "WGSL", cpp: "C++", metal: "Metal", godot: "Godot", tsl: "three.js TSL", csharp: "C#, Unity",
  rust: "Rust", go: "Go", java: "Java", c: "C", javascript: "JavaScript", python: "Python", osl: "OSL, Blender", bake: "tools/bake",
};

const vector = (prefix, scalar) => (n) => (n === 1 ? scalar : `${prefix}${n}`);
export const kTypes = {
  glsl: { float: vector("vec", "float"), int: vector("ivec", "int"), uints: vector("uvec", "uint"), uint: "uint" },
  hlsl: { float: vector("float", "float"), int: vector("int", "int"), uints: vector("uint", "uint"), uint: "uint" },
  wgsl: {
    float: (n) => (n === 1 ? "f32" : `vec${n}f`),
    int: (n) => (n === 1 ? "i32" : `vec${n}i`),
    uints: (n) => (n === 1 ? "u32" : `vec${n}u`),
    uint: "u32",
  },
};
kTypes.cpp = kTypes.godot = kTypes.glsl;
kTypes.metal = kTypes.hlsl;

export const decimal = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));

export const declaration = (language, type, name, value) =>
  language === "wgsl" ? `let ${name} = ${value};` : `${type} ${name} = ${value};`;

const hasSuffix = (language) => language === "cpp" || language === "metal";

// A number as a float of the language.
function literal(language, value) {
  return hasSuffix(language) ? `${decimal(value)}f` : decimal(value);
}

// A part of a value with integers is a whole number of these steps, so that no product of two has to be rounded.
const kSteps = 65536;
// How far beside a place its slope is measured, in cells.
export const kStepBeside = 0.0625;
export const partOf = ({ arithmetic }, value) =>
  arithmetic === "fixed" ? Math.round(value * kSteps) / kSteps : value;

// From which value on a layer counts, in how wide an edge, and the reciprocal of that: of a whole number of steps a little
// too large, so that it counts whole where the edge ends.
export function edgeOf(state, { from, soft }) {
  const width = Math.abs(partOf(state, soft)) || 1;
  const rate = state.arithmetic === "fixed" ? Math.ceil(kSteps / width) / kSteps : Number((1 / width).toPrecision(7));
  return { from: partOf(state, from), width, rate };
}

// A coordinate times both numbers is the distance from the middle, in radii: a power of two, which is exact, and a rest from
// 1 to 2.
export function spreadOf(state, { radius }) {
  const unit = 2 ** -Math.ceil(Math.log2(radius));
  return { unit, ratio: partOf(state, Number((1 / (radius * unit)).toPrecision(7))) };
}

// A place gets this behind it when its layer drifts.
function driftText(language, state, layer) {
  const [first, ...others] = driftOf(layer, state);
  if (!others.length) return ` ${first < 0 ? "+" : "-"} ${literal(language, Math.abs(first))} * seconds`;
  const parts = [first, ...others].map((speed) => literal(language, speed)).join(", ");
  return ` - ${kTypes[language].float(state.dimensions)}(${parts}) * seconds`;
}

// The numbers with which the functions of each visible layer are called.
export function numbers(language, state) {
  const { int } = kTypes[language];
  const n = state.dimensions;
  const part = (value) => literal(language, partOf(state, value));
  return shownLayers(state).map((layer) => {
    const whole = String(state.period * layer.scale);
    const alike = language === "hlsl" && n > 1 ? Array(n).fill(whole).join(", ") : whole;
    const others = Object.entries({ ...edgeOf(state, layer), ...spreadOf(state, layer) });
    return {
      ...Object.fromEntries(others.map(([name, value]) => [name, literal(language, value)])),
      seed: `${layer.seed}u`, otherSeed: `${(layer.seed + 1) % 4294967296}u`, octaves: String(layer.octaves),
      lacunarity: literal(language, layer.lacunarity), gain: literal(language, layer.gain),
      strength: literal(language, layer.strength), amplitude: literal(language, layer.amplitude),
      jitter: literal(language, layer.jitter), phase: literal(language, state.phase),
      period: n === 1 ? whole : `${int(n)}(${alike})`, weight: part(layer.weight), offset: part(layer.offset),
      scale: literal(language, layer.scale), wholeScale: `${layer.scale}u`, drift: driftText(language, state, layer),
    };
  });
}

// Which forms of the functions each layer that is shown needs. States that agree in this have one shader.
export function shapes(state) {
  const tinted = tintedLayers(state);
  return state.layers.flatMap((layer, at) => {
    if (!layer.on) return [];
    const used = uses(state, at);
    const { weight, offset } = remapOf(state, at);
    return [
      {
        ...settingsOf(state, at),
        warp: used.warp ? layer.warp : "none",
        metric: used.metric ? layer.metric : "euclidean",
        tiled: state.period > 0,
        turned: layer.sum === "none" && Boolean(kNoises[layer.noise].phase) && used.phase && state.phase > 0,
        full: (used.jitter && layer.jitter !== 1) || (used.metric && layer.metric !== "euclidean"),
        weighted: weight !== 1,
        moved: offset !== 0,
        scaled: used.scale && layer.scale !== 1,
        tinted: tinted.includes(layer),
        soft: used.soft ? layer.soft : 0,
        drifts: isDrifting(layer, state),
      },
    ];
  });
}

// The end of each sum, by its name in the catalog: the function that ends the loop, and an expression of its result.
const kMeans = {
  density: { end: "density" },
  billows: { of: (mean) => `min(2.0 * ${mean} - 1.0, 1.0)` },
  bounded: { of: (mean) => `min(max(${mean}, -1.0), 1.0)` }, // roundings may take it beyond
};

// The functions of a layer, in one language. `values` are what numbers() returns of it, or names of uniforms; `name` is
// what the layer's function is called, and `suffix` stands behind the names of the functions that it calls. One that is
// `short` calls what the page has of tools/pick: a jitter and a metric are passed always, and sums at places are loops.
class Writer {
  constructor(language, state, values, name, suffix, short) {
    this.short = short;
    this.language = language;
    this.state = state;
    this.values = values;
    this.name = name;
    this.suffix = suffix;
    this.types = kTypes[language];
    this.noise = kNoises[state.noise];
    this.files = new Set();
    this.needs = new Set(); // the functions' calls, by the names in WGSL
    this.summed = state.sum !== "none";
    this.isTimed = state.drifts && !values.shift; // the page knows how far
    // Where a noise is computed: at a position, in a cell, or at a place that is given.
    this.position = { position: "p" };
    this.cell = { cell: "cell", f: "f" };
    this.place = { place: "place" };
  }

  get n() {
    return this.state.dimensions;
  }

  number(text) {
    return hasSuffix(this.language) ? text.replace(/\b\d+\.\d+\b/g, "$&f") : text;
  }

  // A call of a function of the library by the name that it has in WGSL, which has no overloads.
  called(name, renamed, ...passed) {
    this.needs.add(renamed);
    return `${this.language === "wgsl" ? renamed : name}(${passed.join(", ")})`;
  }

  // A call of a noise or of a sum, in a tile if the state has one. A place that is given is in it already.
  call(name, { position, cell, f, place }, form, ...rest) {
    const { n, state, values } = this;
    let passed = place ?? position ?? this.called("hn_place", `hn_place_in_cell${n}`, cell, f);
    if (state.tiled && !place) {
      passed = this.called("hn_tile", `hn_tile${n}${cell ? "_place" : ""}`, passed, values.period);
    }
    const placed = place || cell || state.tiled ? "_place" : "";
    const called = name === "hn_octaves" ? "hn_octaves_of" : name;
    return this.called(name, `${called}${n}${placed}${form && `_${form}`}`, passed, ...rest);
  }

  let(type, name, value) {
    return declaration(this.language, type, name, value);
  }

  // A function of our own, of one or of several lines.
  define(name, parameters, lines, size = 1) {
    const { float } = this.types;
    if (this.language === "wgsl") {
      const list = parameters.map(([type, parameter]) => `${parameter}: ${type}`).join(", ");
      return this.body(`fn ${name}(${list}) -> ${float(size)} {`, lines);
    }
    const list = parameters.map(([type, parameter]) => `${type} ${parameter}`).join(", ");
    return this.body(`${this.language === "cpp" ? "inline " : ""}${float(size)} ${name}(${list}) {`, lines);
  }

  body(head, lines) {
    if (lines.length === 1 && head.length + lines[0].length < 118) return [`${head} ${lines[0]} }`];
    return [head, ...lines.map((line) => `  ${line}`), "}"];
  }

  // The noise itself at a place: the lines before its value, and the value.
  noiseAt(where, values) {
    const { noise, state } = this;
    if (noise.shape) return this.middleAt(where, values);
    const { float, int } = this.types;
    const cellular = noise.metric || noise.jitter;
    const full = state.full || this.short;
    const named = `HN_METRIC_${state.metric.toUpperCase()}`;
    const metric = this.short ? String(Object.keys(kMetrics).indexOf(state.metric) + 1) : named;
    this.files.add(`${noise.file}${state.turned ? "_phase" : ""}${this.n}d.glsl`);
    if (noise.metric && !this.short && (full || noise.nearest)) this.needs.add(named);
    if (noise.nearest) {
      this.files.add("hash.glsl");
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
    if (cellular && full) {
      call = this.call(noise.calls, where, "jitter", values.jitter, ...(noise.metric ? [metric] : []), values.seed);
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

  // How far a place is from the middle. From a cell both parts of a coordinate are whole numbers of steps before they meet.
  middleAt({ position, cell, f }, { unit, ratio }) {
    const { n, state } = this;
    const { product, stepped } = steppedWords(state.arithmetic === "fixed");
    const along = (axis) => {
      const of = (place) => (n === 1 ? place : /^\w+$/.test(place) ? `${place}.${axis}` : `(${place}).${axis}`);
      const whole = cell && `${this.types.float(1)}(${of(cell)})`;
      const shown = cell
        ? `${stepped(`${whole} * ${unit}`)} + ${stepped(`${of(f)} * ${unit}`)}`
        : stepped(`${of(position)} * ${unit}`);
      return this.let(this.types.float(1), `u${axis}`, product(this.number(`min(max(${shown}, -2.0), 2.0)`), ratio));
    };
    const axes = n === 1 ? ["x"] : state.shape.startsWith("along_") ? [state.shape.at(-1)] : ["x", "y"];
    const squares = axes.map((axis) => product(`u${axis}`, `u${axis}`));
    const value = {
      round: () => `max(1.0 - (${squares.join(" + ")}), -1.0)`,
      square: () => `max(1.0 - ${squares.length > 1 ? `max(${squares.join(", ")})` : squares[0]}, -1.0)`,
    }[state.shape]?.() ?? `min(max(u${axes[0]}, -1.0), 1.0)`;
    return { lines: axes.map(along), value: this.number(value) };
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
    const { lines, value } = this.noiseAt(this.near ? this.position : this.place, values);
    const where = this.near ? [this.types.float(this.n), "p"] : [`hn_place${this.n}`, "place"];
    const parameters = [where, [this.types.uint, "seed"]];
    const name = `${state.noise}${this.suffix}`;
    return { name, lines: this.define(name, parameters, [...lines, `return ${this.number(noise.signed(value))};`]) };
  }

  // Sets the function of the sum, and returns the lines that define it: over another noise than the library's own it is
  // a loop over octaves.
  defineSum() {
    const { state, n } = this;
    const { mean: made, steep, strength } = kSums[state.sum];
    this.files.add(`${steep ? "fbm_d" : "fbm"}${n}d.glsl`);
    this.sum = `hn_${state.sum}`;
    // For sums of values at positions in floats, and in a tile, the page has functions with shorter text.
    const isPlain = this.short && !this.ofCell && state.arithmetic !== "fixed" && !steep;
    const isLoop = this.short && (state.tiled ? !isPlain || n === 1 || n === 4 : this.ofCell);
    if (state.noise === "perlin" && !isLoop) return [];
    const near = isPlain && !state.tiled;
    this.near = near;
    const noise = this.summedNoise();
    this.sum = `${state.sum}_${state.noise}${this.suffix}`;
    const wgsl = this.language === "wgsl";
    const set = (name) => (wgsl ? `&${name}` : name);
    const [o, at] = near ? ["sum", ["p", "seed"]] : ["o", ["o.place", "o.seed"]];
    const ours = (name, ...passed) => this.called(`hn_${near ? "play_" : ""}${name}`, near ? `hn_play_${name}1` : `hn_${name}${n}`, ...passed);
    const { end = "mean", of = (mean) => mean } = kMeans[made] ?? {};
    const octave = noise.lines.length
      ? `${noise.name}(${at.join(", ")})`
      : this.called(noise.name, `${noise.name}${n}${near ? "" : "_place"}`, ...at);
    const rest = [...(steep ? [set("s")] : []), octave, ...(strength ? ["strength"] : [])];
    const add = ours(`add${kSums[state.sum].step ? `_${kSums[state.sum].step}` : ""}`, set(o), ...rest);
    const next = near
      ? this.called("hn_play_next", `hn_play_next${n}`, ...["p", "seed", "sum"].map(set), "lacunarity")
      : ours("next", set("o"));
    const variable = (type, name, value) => (wgsl ? `var ${name}: ${type} = ${value};` : `${type} ${name} = ${value};`);
    const { float, int, uint } = this.types;
    const given = near ? [[float(n), "p"], [uint, "seed"]] : [[`hn_octaves${n}`, "o"]];
    const lines = [
      ...(wgsl ? given.map(([, name]) => `var ${name} = ${name}_in;`) : []),
      ...(near ? [variable("hn_i_octave_sum", "sum", ours("begin", "octaves", "gain"))] : []),
      ...(steep ? [variable(`hn_slopes${n}`, "s", this.called("hn_slopes", `hn_slopes_of${n}`, "o"))] : []),
      ...(wgsl
        ? ["loop {", `  ${add};`, `  continuing { break if !(${next}); }`, "}"]
        : [`do ${add}; while (${next});`]),
      `return ${this.number(of(ours(end, o)))};`,
    ];
    const parameters = [
      ...given.map(([type, name]) => [type, wgsl ? `${name}_in` : name]),
      ...(near ? [[int(1), "octaves"], [float(1), "lacunarity"], [float(1), "gain"]] : []),
      ...(strength ? [[float(1), "strength"]] : []),
    ];
    return [...noise.lines, ...this.define(this.sum, parameters, lines)];
  }

  // The value at a place, with the lines before it.
  shownAt(where) {
    const { state, values } = this;
    if (!this.summed) return this.noiseAt(where, values);
    const settings = [values.octaves, values.lacunarity, values.gain];
    const strength = kSums[state.sum].strength ? [values.strength] : [];
    if (this.near) return { lines: [], value: `${this.sum}(${[where.position, values.seed, ...settings, ...strength].join(", ")})` };
    if (this.sum.startsWith("hn_")) {
      const passed = [...settings, ...strength, values.seed];
      const inTile = `hn_play_${state.sum}_in_tile`;
      const value = this.short && state.tiled
        ? this.called(inTile, `${inTile}${this.n}`, where.position, values.period, ...passed)
        : this.call(this.sum, where, "", ...passed);
      return { lines: [], value };
    }
    const octaves = this.call("hn_octaves", where, "", ...settings, values.seed);
    return { lines: [], value: `${this.sum}(${[octaves, ...strength].join(", ")})` };
  }

  // Where a layer that drifts is read: the lines, and the place.
  drifted(where) {
    const { values, n } = this;
    if (!this.state.drifts) return { lines: [], where };
    const { float, int } = this.types;
    const set = (name, value) => this.let(float(n), name, value);
    if (!where.cell) return { lines: [set("g", `p${values.drift}`)], where: { position: "g" } };
    const cell = `cell + ${values.shift ? `${values.shift} + ` : ""}${int(n)}(over)`;
    return { lines: [set("g", `f${values.drift}`), set("over", "floor(g)")], where: { cell, f: "g - over" } };
  }

  // Finer cells: the lines, and the place in them. Products with powers of two are exact.
  scaled(where) {
    const { values, n } = this;
    if (!this.state.scaled) return { lines: [], where };
    const { float, int, uints } = this.types;
    if (!where.cell) return { lines: [this.let(float(n), "s", `${where.position} * ${values.scale}`)], where: { position: "s" } };
    const cell = `${uints(n)}(${where.cell}) * ${values.wholeScale} + ${uints(n)}(first)`;
    return {
      lines: [this.let(float(n), "s", `${where.f === "f" ? "f" : `(${where.f})`} * ${values.scale}`), this.let(float(n), "first", "floor(s)")],
      where: { cell: `${int(n)}(${cell})`, f: "s - first" },
    };
  }

  // A shift of the place, and where it leads.
  moved(where) {
    const { state, values } = this;
    if (state.warp === "none") return { lines: [], where };
    this.files.add(`warp${this.n}d.glsl`);
    const { float, int } = this.types;
    const { octaves, lacunarity, gain, amplitude, otherSeed } = values;
    const shift = this.call(`hn_${state.warp}`, where, "", octaves, lacunarity, gain, amplitude, otherSeed);
    const set = (name, value) => this.let(float(this.n), name, value);
    if (!where.cell) return { lines: [set("q", `${where.position} + ${shift}`)], where: { position: "q" } };
    return {
      lines: [set("q", `${where.f} + ${shift}`), set("whole", "floor(q)")],
      where: { cell: `${where.cell} + ${int(this.n)}(whole)`, f: "q - whole" },
    };
  }

  nameOf(where) {
    return this.language === "wgsl" && where.cell ? `${this.name}_cell` : this.name;
  }

  parametersOf(where, ...others) {
    const { float, int } = this.types;
    return [...(where.cell ? [[int(this.n), "cell"], [float(this.n), "f"]] : [[float(this.n), "p"]]), ...others];
  }

  clock(isTimed = this.isTimed) {
    return isTimed ? [[this.types.float(1), "seconds"]] : [];
  }

  // The function of the layer at a place.
  pattern(where) {
    const { lines: drifting, where: then } = this.drifted(where);
    const { lines: scaling, where: near } = this.scaled(then);
    const { lines: moving, where: there } = this.moved(near);
    const shown = this.shownAt(there);
    const lines = [...drifting, ...scaling, ...moving, ...shown.lines, `return ${shown.value};`];
    return this.define(this.nameOf(where), this.parametersOf(where, ...this.clock()), lines);
  }

  // The lines of the functions in these forms.
  write(forms) {
    this.ofCell = forms.includes("cell");
    const sums = this.summed ? this.defineSum() : [];
    return [...sums, ...(sums.length ? [""] : []), ...forms.flatMap((form) => this.pattern(this[form]))];
  }
}

const steppedWords = (isExact) => ({
  product: (one, other) => (isExact ? `layer_product(${one}, ${other})` : `${one} * ${other}`),
  stepped: (value) => (isExact ? `layer_steps(${value})` : value),
});

// Layers in one value, as combine.js has it.
class Mixer {
  constructor(language, shown, writers) {
    this.language = language;
    this.shown = shown;
    this.writers = writers;
    this.fixed = shown.some(({ arithmetic }) => arithmetic === "fixed");
    this.isTimed = writers.some(({ isTimed }) => isTimed);
    this.seconds = this.isTimed ? ", seconds" : "";
    this.steep = shown.flatMap(({ blend }, at) => (at > 0 && blend === "slope" ? [at] : []));
  }

  get words() {
    const [writer] = this.writers;
    const { product, stepped } = steppedWords(this.fixed);
    return {
      name: (kind, at) => (kind === "v" ? "v" : `m${at + 1}`),
      numbers: (at) => [this.writers[at].values.weight, this.writers[at].values.offset],
      ease: (at) => ["from", "width", "rate"].map((name) => this.writers[at].values[name]),
      product, stepped, result: stepped, isExact: this.fixed, zero: writer.number("0.0"),
      part: (value) => stepped(writer.number(`min(max(${value}, 0.0), 1.0)`)),
      lower: (...values) => `min(${values.join(", ")})`,
      higher: (...values) => `max(${values.join(", ")})`,
    };
  }

  // How steep it is below a layer, from what is below at the place and a step beside it along each axis.
  slopeBelow({ n, types }, where, number) {
    const passed = Array.from({ length: n }, (_, axis) => {
      const parts = Array.from({ length: n }, (_, other) => this.writers[0].number(other === axis ? String(kStepBeside) : "0.0"));
      const step = n === 1 ? parts[0] : `${types.float(n)}(${parts.join(", ")})`;
      return where.cell ? `beside_${number}(cell, f, ${step}${this.seconds})` : `below_${number}(p + ${step}${this.seconds})`;
    });
    return `layer_slope(${["v", ...passed].join(", ")})`;
  }

  // The functions below a layer. From a cell both summands of a place have few digits, so that it is exact.
  below(form, at) {
    const [writer] = this.writers;
    const { n, types } = writer;
    const where = writer[form];
    const { lines } = this.mixing(form, false, at);
    const name = `below_${at + 1}`;
    const made = this.define(where, name, [...lines, "return v;"]);
    if (!where.cell) return made;
    const called = this.language === "wgsl" ? `${name}_cell` : name;
    const e = [types.float(n), "e"];
    return [...made, ...writer.define(`beside_${at + 1}`, writer.parametersOf(where, e, ...writer.clock(this.isTimed)), [
      writer.let(types.float(n), "whole", "floor(f + e)"),
      `return ${called}(cell + ${types.int(n)}(whole), f + (e - whole)${this.seconds});`,
    ])];
  }

  define(where, name, lines, size) {
    const [writer] = this.writers;
    const called = this.language === "wgsl" && where.cell ? `${name}_cell` : name;
    return writer.define(called, writer.parametersOf(where, ...writer.clock(this.isTimed)), lines, size);
  }

  // The lines that make "v" at a place; and how much each layer with colours of its own counts, behind these lines.
  mixing(form, hasTints, count) {
    const { language, shown, words, writers } = this;
    const [writer] = writers;
    const where = writer[form];
    const calls = writers.map((one) => `${one.nameOf(where)}(${where.cell ? "cell, f" : "p"}${one.isTimed ? ", seconds" : ""})`);
    const slope = (_, at) => this.slopeBelow(writer, where, at + 1);
    const { steps, masks } = combined(shown.slice(0, count), calls, { ...words, slope, hasTints });
    const lines = steps.map(([name, value], at) => {
      if (name !== "v") return writer.let(writer.types.float(1), name, value);
      return `${at ? "" : language === "wgsl" ? "var " : "float "}v = ${value};`;
    });
    return { lines, parts: masks };
  }

  // A function at a place. `end` makes its last lines of how much the layers with colours count, if they matter.
  at(form, name, end, size) {
    const { lines, parts } = this.mixing(form, Boolean(end));
    return this.define(this.writers[0][form], name, [...lines, ...(end ? end(parts) : ["return v;"])], size);
  }

  // The functions that make values steps, and multiply them.
  helpers() {
    return [...(this.fixed ? this.fixedHelpers() : []), ...(this.steep.length ? [...this.slopeHelper(), ""] : [])];
  }

  // The length of a slope along its axes: the greatest, and half of the others, which is at most an eighth too much on a
  // plane. It has no root, so that it is exact with integers.
  slopeHelper() {
    const [writer] = this.writers;
    const { types, n } = writer;
    const axes = ["x", "y", "z", "w"].slice(0, n);
    const set = (name, value) => writer.let(types.float(1), name, writer.number(value));
    const lines = axes.map((x) => set(`d${x}`, `min(max(${x} - v, v - ${x}) * ${decimal(1 / kStepBeside)}, 8.0)`));
    const [first, ...others] = axes.map((x) => `d${x}`);
    let length = first;
    for (const d of others) {
      lines.push(set(`s${d}`, this.words.stepped(`max(${length}, ${d}) + 0.5 * min(${length}, ${d})`)));
      length = `s${d}`;
    }
    return writer.define("layer_slope", ["v", ...axes].map((name) => [types.float(1), name]), [...lines, `return ${length};`]);
  }

  fixedHelpers() {
    const [writer] = this.writers;
    const { float, int } = writer.types;
    const step = writer.number(String(1 / kSteps));
    const [low, high, steps] = ["-8.0", "8.0", `${kSteps}.0`].map((text) => writer.number(text));
    const parts = ["a", "b"].map((name, at) => writer.let(int(1), "ij"[at], `${int(1)}(${name} * ${steps})`));
    return [
      `// Values are whole numbers of steps of 1/${kSteps}, so that no product is rounded.`,
      ...writer.define("layer_steps", [[float(1), "v"]], [
        `return ${float(1)}(${int(1)}(floor(min(max(v, ${low}), ${high}) * ${steps}))) * ${step};`,
      ]),
      ...writer.define("layer_product", [[float(1), "a"], [float(1), "b"]], [
        ...parts,
        `return ${float(1)}(((i >> 8) * j + (((i & 255) * j) >> 8)) >> 8) * ${step};`,
      ]),
      "",
    ];
  }

  write(forms, end) {
    const layers = this.writers.flatMap((writer) => [...writer.write(forms), ""]);
    const below = this.steep.flatMap((at) => forms.flatMap((form) => this.below(form, at)));
    return [...this.helpers(), ...layers, ...below, ...forms.flatMap((form) => this.at(form, "pattern", end))];
  }
}

// {lines, files, needs, public}: the definition of "pattern" in these forms, the files of the library and the functions
// that it needs, and which of those anybody may call. The forms are "cell", pattern(cell, f), and "position",
// pattern(p). `values` are what numbers() returns, or names of uniforms. `at(name, end, size)` defines another function
// in these forms: `end` makes its last lines of how much the layers with colours count. "pattern" may have such lines, too.
export function functions(language, state, values, forms = ["cell", "position"], short = false, end = undefined) {
  const shown = shapes(state);
  const [{ weighted, moved, noise }] = shown;
  const alone = shown.length === 1 && !weighted && !moved && !kNoises[noise].shape;
  const writers = shown.map((shape, at) => {
    const name = alone ? "pattern" : `layer_${at + 1}`;
    return new Writer(language, shape, values[at], name, alone ? "" : `_${at + 1}`, short);
  });
  const mixer = new Mixer(language, shown, writers);
  const lines = alone ? writers[0].write(forms) : mixer.write(forms, end);
  const all = (of) => [...new Set(writers.flatMap((writer) => [...writer[of]]))];
  const needs = all("needs");
  const at = (...made) => forms.flatMap((form) => mixer.at(form, ...made));
  return { lines, at, files: all("files"), needs, public: needs.filter((name) => /^hn_(?!i_|(?:place|octaves|slopes)\d$)/.test(name)) };
}

// The name of the shader of a state: states with the same key differ in uniforms alone.
export function shaderKey(state) {
  const { dimensions, arithmetic, hash } = state;
  const layers = shapes(state).map((given, at) => {
    const { noise, sum, warp, metric, tiled, turned, full, weighted, moved, scaled, drifts, blend, tinted, soft, shape } = given;
    const ofNoise = kNoises[noise].shape ? shape : full ? metric : "";
    return [noise, sum, warp, ofNoise, tiled, turned, weighted, moved, scaled, drifts, at ? blend : "", tinted, Math.sign(soft)].join(" ");
  });
  return [dimensions, arithmetic, hash, isSolid(state) ? state.view : isLeaning(state) ? "leaning" : "", state.masks, ...layers].join(" ");
}

// The knobs that differ from the library's defaults.
export function knobs({ arithmetic, hash }) {
  return [
    ...(arithmetic === "fixed" ? ["#define HN_ARITHMETIC HN_FIXED"] : []),
    ...(hash === "lattice" ? [] : [`#define HN_HASH HN_HASH_${hash.toUpperCase()}`]),
  ];
}
