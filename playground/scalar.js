// The picture as a function of numbers, for languages without vectors: C, Rust, C#, Java, Go, JavaScript and OSL. It calls
// what tools/pick writes, so that here are calls and sums alone.
import { decimal, edgeOf, kStepBeside, partOf, shapes, spreadOf } from "./code.js";
import { combined } from "./combine.js";
import { driftOf, hasDrift, remapOf } from "./model.js";
import { named } from "./pieces.js";
import { kMetrics, kNoises, kSums } from "./tables.js";

export const kAxes = ["x", "y", "z", "w"];
const kPlain = ["perlin", "value", "simplex"]; // these have functions of a position
const signed = (seed) => String(seed | 0); // where words are numbers with a sign

const typed = (parameters) => parameters.map(([type, one]) => `${type} ${one}`).join(", ");
const doWhile = (lines, next, indent = "  ") =>
  ["do {", ...lines.map((line) => indent + line), `} while (${next});`];
const typesInC = (uint) => ({ float: "float", uint, place: (n) => `hn_place${n}`, octaves: (n) => `hn_octaves${n}` });
const typesByName = (float, uint) => ({ float, uint, place: (n) => `Place${n}`, octaves: (n) => `Octaves${n}` });

// How a language writes the functions' helpers. `o` is how a sum is passed to what changes it.
const kC = {
  float: (value) => `${decimal(value)}f`, uint: (value) => `${value}u`, o: "&o", s: "&s", place: "o.place", seed: "o.seed",
  head: (name, parameters) => `static inline float ${name}(${typed(parameters)}) {`, types: typesInC("uint32_t"),
  let: (name, value) => `float ${name} = ${value};`, struct: (type, name, value) => `${type} ${name} = ${value};`, loop: doWhile,
};
const kJava = {
  ...kC, uint: signed, o: "o", s: "s", types: typesByName("float", "int"),
  head: (name, parameters, isPublic) => `${isPublic ? "public" : "private"} static float ${name}(${typed(parameters)}) {`,
  struct: (_, name, value) => `var ${name} = ${value};`, loop: (lines, next) => doWhile(lines, next, "    "),
};
const kSyntax = {
  c: kC,
  rust: {
    float: decimal, uint: String, o: "&mut o", s: "&mut s", place: "o.place", seed: "o.seed", types: typesByName("f32", "u32"),
    head: (name, parameters, isPublic) =>
      `${isPublic ? "pub " : ""}fn ${name}(${parameters.map(([type, one]) => `${one}: ${type}`).join(", ")}) -> f32 {`,
    let: (name, value) => `let ${name} = ${value};`, struct: (_, name, value) => `let mut ${name} = ${value};`,
    loop: (lines, next) => ["loop {", ...lines.map((line) => `    ${line}`), `    if !${next} {`, "        break;", "    }", "}"],
  },
  csharp: { ...kJava, uint: kC.uint, o: "ref o", s: "ref s", place: "o.Place", seed: "o.Seed", types: typesByName("float", "uint") },
  java: kJava,
  go: {
    float: decimal, uint: String, o: "&o", s: "&s", place: "o.Place", seed: "o.Seed", types: typesByName("float32", "uint32"),
    head: (name, parameters) => `func ${name}(${parameters.map(([type, one]) => `${one} ${type}`).join(", ")}) float32 {`,
    let: (name, value) => `var ${name} float32 = ${value}`, struct: (_, name, value) => `${name} := ${value}`, end: "",
    loop: (lines, next) => ["for {", ...lines.map((line) => `\t${line}`), `\tif !${next} {`, "\t\tbreak", "\t}", "}"],
  },
  javascript: {
    float: String, uint: String, o: "o", s: "s", place: "o.place", seed: "o.seed", types: typesByName("", ""),
    head: (name, parameters, isPublic) => `${isPublic ? "export " : ""}function ${name}(${parameters.map(([, one]) => one).join(", ")}) {`,
    let: (name, value) => `const ${name} = ${value};`, struct: (_, name, value) => `const ${name} = ${value};`,
    loop: doWhile,
  },
  osl: {
    ...kC, float: decimal, uint: signed, o: "o", s: "s", types: typesInC("int"),
    head: (name, parameters) => `float ${name}(${typed(parameters)}) {`,
  },
};
const kIndent = { rust: "    ", csharp: "    ", java: "    ", go: "\t" };
export const isScalar = (language) => Object.hasOwn(kSyntax, language);

class ScalarWriter {
  constructor(language, state) {
    this.language = language;
    this.syntax = kSyntax[language];
    this.state = state;
    this.n = state.dimensions;
    this.needs = new Set();
    this.end = this.syntax.end ?? ";";
  }

  // A call of a function by its name in C.
  call(name, ...passed) {
    this.needs.add(name);
    return `${named(this.language, name)}(${passed.join(", ")})`;
  }

  float(value) {
    return this.syntax.float(value);
  }

  ours(name) {
    return named(this.language, name);
  }

  get axes() {
    return kAxes.slice(0, this.n);
  }

  // The coordinates where a layer is read.
  axesOf(layer) {
    return driftOf(layer, this.state).map((speed, at) =>
      speed ? `${kAxes[at]} ${speed < 0 ? "+" : "-"} ${this.float(Math.abs(speed))} * seconds` : kAxes[at]);
  }

  settings({ octaves, lacunarity, gain }) {
    return [String(octaves), this.float(lacunarity), this.float(gain)];
  }

  placeOf(layer) {
    const { n, state } = this;
    const period = state.period ? [String(state.period * layer.scale)] : [];
    const tile = state.period ? "_in_tile" : "";
    const scale = this.float(layer.scale);
    if (layer.warp === "none") return this.call(`hn_play_${state.period ? "in_tile" : "at"}${n}`, ...this.axesOf(layer), scale, ...period);
    const moved = [...this.settings(layer), this.float(layer.amplitude), this.syntax.uint((layer.seed + 1) % 4294967296)];
    return this.call(`hn_play_${layer.warp}${tile}${n}`, ...this.axesOf(layer), scale, ...period, ...moved);
  }

  // The noise of a layer at a place, as it is or as a sum takes it.
  noiseAt(layer, place, seed, forSum) {
    const { n } = this;
    const noise = kNoises[layer.noise];
    if (noise.shape) {
      const { unit, ratio } = spreadOf(this.state, layer);
      return this.call(`hn_play_${layer.shape}${n}_place`, place, this.float(unit), this.float(ratio));
    }
    const suffix = forSum && noise.signed ? "_signed" : "";
    if (layer.turned) return this.call(`${noise.calls}${n}_place_phase`, place, this.float(this.state.phase), seed);
    const jitter = this.float(layer.jitter);
    if (noise.metric) {
      const metric = String(Object.keys(kMetrics).indexOf(layer.metric) + 1);
      return this.call(`hn_play_${layer.noise}${suffix}${n}_place_jitter`, place, jitter, metric, seed);
    }
    if (noise.jitter) return this.call(`hn_${suffix ? "play_" : ""}${layer.noise}${suffix}${n}_place_jitter`, place, jitter, seed);
    if (suffix || noise.of) return this.call(`hn_play_${layer.noise}${suffix}${n}_place`, place, seed);
    return this.call(`${noise.calls}${n}_place`, place, seed);
  }

  define(name, parameters, lines, isPublic = false) {
    const indent = kIndent[this.language] ?? "  ";
    if (this.language === "rust") lines.push(lines.pop().replace(/^return (.*);$/, "$1"));
    return [this.syntax.head(name, parameters, isPublic), ...lines.map((line) => `${indent}${line}`), "}", ""];
  }

  // The functions of a sum over another noise, or at a place; and its name.
  loopOf(layer, at) {
    const { n, syntax } = this;
    const { step, mean, steep } = kSums[layer.sum];
    const noise = this.ours(`noise_${at + 1}`);
    const name = this.ours(`sum_${at + 1}`);
    const strength = kSums[layer.sum].strength ? [this.float(layer.strength)] : [];
    const { place, seed } = syntax;
    const begin = [syntax.struct(syntax.types.octaves(n), "o", "given")];
    const lines = [];
    const octave = [];
    if (steep) {
      begin.push(syntax.struct(`hn_slopes${n}`, "s", this.call(`hn_slopes_of${n}`, "o")));
      octave.push(`${this.call(`hn_play_add_eroded_${layer.noise}${n}`, syntax.o, syntax.s, ...strength)}${this.end}`);
    } else {
      const parameters = [[syntax.types.place(n), "place"], [syntax.types.uint, "seed"]];
      lines.push(...this.define(noise, parameters, [`return ${this.noiseAt(layer, "place", "seed", true)}${this.end}`]));
      const add = this.call(`hn_add${step ? `_${step}` : ""}${n}`, syntax.o, "n", ...strength);
      octave.push(syntax.let("n", `${noise}(${place}, ${seed})`), `${add}${this.end}`);
    }
    const end = { density: `hn_density${n}`, billows: `hn_play_billows${n}`, bounded: `hn_play_bounded${n}` }[mean] ?? `hn_mean${n}`;
    const body = [...begin, ...syntax.loop(octave, this.call(`hn_next${n}`, syntax.o)), `return ${this.call(end, "o")}${this.end}`];
    lines.push(...this.define(name, [[syntax.types.octaves(n), "given"]], body));
    return { lines, name };
  }

  // The value of a layer, with the functions that it needs.
  layer(layer, at) {
    const seed = this.syntax.uint(layer.seed);
    const near = layer.warp === "none" && !layer.tiled && !layer.scaled;
    const noise = kNoises[layer.noise];
    if (layer.sum === "none") {
      const plain = near && !layer.turned && kPlain.includes(layer.noise);
      if (!plain) return { lines: [], value: this.noiseAt(layer, this.placeOf(layer), seed, false) };
      return { lines: [], value: this.call(`${noise.calls}${this.n}`, ...this.axesOf(layer), seed) };
    }
    const settings = this.settings(layer);
    if (near && layer.noise === "perlin") {
      const strength = kSums[layer.sum].strength ? [this.float(layer.strength)] : [];
      return { lines: [], value: this.call(`hn_${layer.sum}${this.n}`, ...this.axesOf(layer), ...settings, ...strength, seed) };
    }
    const { lines, name } = this.loopOf(layer, at);
    return { lines, value: `${name}(${this.call(`hn_octaves_of${this.n}_place`, this.placeOf(layer), ...settings, seed)})` };
  }

  // How steep it is below a layer.
  slopeBelow(number, v) {
    const beside = this.axes.map((axis) => this.axes.map((other) => (other === axis ? `${axis} + ${this.float(kStepBeside)}` : other)));
    const clock = hasDrift(this.state) ? ["seconds"] : [];
    return this.call("hn_play_slope1", v, ...beside.map((place) => `${this.ours(`below_${number}`)}(${[...place, ...clock].join(", ")})`));
  }

  stepped(text) {
    return this.state.arithmetic === "fixed" ? this.call("hn_play_steps1", text) : text;
  }

  words(shown) {
    const isExact = this.state.arithmetic === "fixed";
    const stepped = (text) => this.stepped(text);
    const [lower, higher] = ["lower", "higher"].map((name) => (...values) => this.call(`hn_play_${name}1`, ...values));
    return {
      name: (kind, at) => `${kind}${at + 1}`,
      numbers: (at) => [shown[at].weight, shown[at].offset].map((number) => this.float(partOf(this.state, number))),
      ease: (at) => Object.values(edgeOf(this.state, shown[at])).map((number) => this.float(number)),
      zero: this.float(0),
      product: (one, other) => (isExact ? this.call("hn_play_product1", one, other) : `${one} * ${other}`),
      stepped, result: stepped, isExact, hasTints: true, lower, higher,
      part: (value) => stepped(lower(higher(value, this.float(0)), this.float(1))),
      slope: (v, at) => this.slopeBelow(at + 1, v),
    };
  }

  // The lines that combine the layers; and by the names of other functions those that make what is below a layer, and how
  // much the layers with colours of their own count.
  combining(shown, layers) {
    const calls = layers.map(({ value }) => value);
    const words = this.words(shown);
    const { steps, v, masks } = combined(shown, calls, words);
    // The value, behind the steps that it needs.
    const returning = (value, made) => {
      const needed = [`return ${value}${this.end}`];
      for (const [name, other] of made.toReversed())
        if (needed.some((line) => new RegExp(`\\b${name}\\b`).test(line))) needed.unshift(this.syntax.let(name, other));
      return needed;
    };
    const functions = {};
    for (const [at, { blend }] of shown.entries()) {
      if (at === 0 || blend !== "slope") continue;
      const below = combined(shown.slice(0, at), calls, words);
      functions[`below_${at + 1}`] = returning(below.v, below.steps);
    }
    functions.pattern = returning(v, steps);
    const tinted = shown.flatMap((shape, at) => (shape.tinted ? [at] : []));
    tinted.forEach((at, k) => (functions[`mask_${at + 1}`] = returning(masks[k], steps)));
    return functions;
  }

  write() {
    const shown = shapes(this.state);
    const { weight, offset } = remapOf(this.state, this.state.layers.findIndex(({ on }) => on));
    const alone = shown.length === 1 && weight === 1 && offset === 0;
    const layers = shown.map((layer, at) => this.layer(layer, at));
    const functions = alone ? { pattern: [`return ${layers[0].value}${this.end}`] } : this.combining(shown, layers);
    const parameters = [...this.axes, ...(hasDrift(this.state) ? ["seconds"] : [])].map((name) => [this.syntax.types.float, name]);
    const defined = Object.entries(functions).flatMap(([name, body]) => this.define(this.ours(name), parameters, body, true));
    return [...layers.flatMap(({ lines }) => lines), ...defined];
  }
}

const kShader = (state) => [
  `shader hashnoise_pattern(point p = P, ${state.dimensions > 3 ? "float w = 0.62, " : ""}${hasDrift(state) ? "float seconds = 0, " : ""}output float value = 0) {`,
  `  value = pattern(${[...["p[0]", "p[1]", "p[2]", "w"].slice(0, state.dimensions), ...(hasDrift(state) ? ["seconds"] : [])].join(", ")});`,
  "}",
];

// {head, library, code} as exported() has them.
export function scalarCode(library, language, state) {
  const writer = new ScalarWriter(language, state);
  const code = writer.write();
  const [first, last] = library.shells[language];
  const inside = library.texts(writer.needs, language, { ...state, arithmetic: "fixed", hash: "lattice" }).map((text) => text.trimEnd());
  const indent = ["java", "csharp"].includes(language) ? "    " : "";
  const lined = (text) => text.split("\n").map((line) => (line ? indent + line : line));
  const tabbed = (line) => (language === "go" ? line.replace(/^(?: {4})+/, (found) => "\t".repeat(found.length / 4)) : line);
  const math = language === "go" && !inside.some((text) => text.includes("math.")) ? first.replace(/\nimport "math"\n/, "") : first;
  return {
    head: math.trimEnd().split("\n").filter((line, at, all) => line || all.length > 1),
    library: inside.flatMap((text) => ["", ...lined(text)]).map(tabbed),
    code: [...lined(code.join("\n").trimEnd()), ...(language === "osl" ? ["", ...kShader(state)] : []), ...(last ? last.trimEnd().split("\n") : [])],
  };
}
