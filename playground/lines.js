// The picture as lines for tools/bake and for Python, which compute grids.
import { edgeOf, kStepBeside, shapes } from "./code.js";
import { combined } from "./combine.js";
import { fileState } from "./files.js";
import { kAxes } from "./scalar.js";
import { kNoises, kSums } from "./tables.js";
import { driftOf, hasDrift, isLeaning, numbersOfTinted, rangeOf, remapOf, shownLayers, uses } from "./model.js";
import { cellsAcross, kPartsOfCell, leaningNumbers, originOf, shiftOf, stepOf } from "./view.js";

// Which number of the results of a noise is shown, in Python and by tools/bake.
const kShown = { cellular: 0, cellular_second: 1, cellular_third: 2, curl: 0 };
const kComponents = { cellular: "f1", cellular_second: "f2", cellular_third: "f3", curl: "x" };

// The settings of a layer that differ from those of the functions, by their names there.
function optionsOf(state, layer, at) {
  const used = uses(state, at);
  const sum = layer.sum !== "none";
  const noise = kNoises[layer.noise];
  return {
    ...(sum && layer.noise !== "perlin" ? { noise: noise.calls.replace("hn_", "") + (kSums[layer.sum].steep ? "_d" : "") } : {}),
    seed: layer.seed,
    ...(sum ? { octaves: layer.octaves, lacunarity: layer.lacunarity, gain: layer.gain } : {}),
    ...(kSums[layer.sum].strength ? { strength: layer.strength } : {}),
    ...(used.jitter && layer.jitter !== 1 ? { jitter: layer.jitter } : {}),
    ...(used.metric && layer.metric !== "euclidean" ? { metric: layer.metric } : {}),
    ...(state.phase && !sum && noise.phase && state.dimensions > 1 && state.dimensions < 4 ? { phase: state.phase } : {}),
  };
}

// The function of a layer; nothing if there is none of that name: what is between two points, a random number for each
// cell, and sums of distances.
function functionOf({ sum, noise }) {
  if (sum !== "none") return kNoises[noise].signed ? undefined : sum;
  return ["cellular_between", "cells", "middle"].includes(noise) ? undefined : kNoises[noise].calls.replace("hn_", "");
}

const isOneLine = (state) => {
  const shown = shownLayers(state);
  const { weight, offset } = remapOf(state, state.layers.indexOf(shown[0]));
  const [{ warp, scale }] = shown;
  return (
    shown.length === 1 && !isLeaning(state) &&
    [weight, offset, scale, state.hash].join(" ") === "1 0 1 lattice" &&
    functionOf(shown[0]) !== undefined &&
    (warp === "none" || state.dimensions === 1 || state.dimensions === 4)
  );
};

// {source, commands}: a file of Python, if one is needed, and the words of the calls of tools/bake, each with the range of what
// it writes: the values first, and then how much each layer counts that has colours of its own. Nothing for a picture that
// it does not have.
export function bakeParts(state) {
  const { width, height, dimensions } = state;
  if (!isOneLine(state) && !isInPython(state)) return undefined;
  // The places of the page's files, exactly, with the upper row first.
  const file = fileState(state);
  const corner = originOf(file, width, height).map((parts) => Number(parts) / kPartsOfCell);
  // Of a line alone the origin moves where the layer drifts.
  const shift = isOneLine(state) ? shiftOf(state, shownLayers(state)[0]) : [];
  const origin = [...corner, state.z, state.w].slice(0, dimensions).map((place, at) => place + Number(shift[at] ?? 0n) / kPartsOfCell);
  const place = [
    "--size", [width, height, 1, 1].slice(0, dimensions).join("x"), "--cells", String((width * stepOf(file, width, height)) / kPartsOfCell),
    `--origin=${origin.join("x")}`, ...(dimensions > 1 ? ["--y-up"] : []),
    ...(state.period ? ["--period", Array(dimensions).fill(state.period).join("x")] : []), "--arithmetic", state.arithmetic,
  ];
  const range = rangeOf(state).map((end) => Number(end.toFixed(6))).join(":");
  if (!isOneLine(state)) {
    const { lines, call } = patternOf(state, kAxes);
    const masks = numbersOfTinted(state).map((number) => ["0:1", `mask_${number}`]);
    const commands = [[range, "noise"], ...masks].map(([ends, name], at) => ({
      words: ["--expression", `${call}${masks.length ? `[${at}]` : ""}`, "--source", "pattern.py", ...place], range: ends, name,
    }));
    return { source: lines, commands };
  }
  const [layer] = shownLayers(state);
  const options = Object.entries(optionsOf(state, layer, state.layers.indexOf(layer))).flatMap(([name, value]) => [`--${name}`, String(value)]);
  const component = layer.sum === "none" ? kComponents[layer.noise] : undefined;
  if (component) options.push("--components", component);
  return { source: [], commands: [{ words: [functionOf(layer), ...options, ...place], range, name: "noise" }] };
}

export function bakeLines(state) {
  const made = bakeParts(state);
  if (!made) return ["# tools/bake has no sums of distances: GLSL and WGSL have all pictures."];
  const quoted = (word) => (/^[\w.:=x-]+$/.test(word) ? word : `'${word}'`);
  return [
    ...(made.source.length ? ["cat > pattern.py << END", ...made.source, "END"] : []),
    ...made.commands.map(({ words, range, name }) => `tools/bake ${words.map(quoted).join(" ")} --range=${range} -o ${name}.png`),
  ];
}

const kSlope = [
  "def slope(v, *beside):", "    length = 0", "    for other in beside:", `        d = numpy.minimum(abs(other - v) * ${1 / kStepBeside}, 8)`,
  "        length = numpy.maximum(length, d) + 0.5 * numpy.minimum(length, d)", "    return length", "",
];

// A function of arrays of coordinates; one line if a grid is enough.
export function pythonLines(state) {
  const { width, height, dimensions } = state;
  const shown = shownLayers(state);
  if (state.hash !== "lattice" || !isInPython(state))
    return ["# Python has no such hash, and no sums of distances: GLSL and WGSL have all pictures."];
  const step = Number((cellsAcross(state) / Math.min(width, height)).toPrecision(9));
  if (isOneLine(state) && dimensions === 2 && !hasDrift(state)) {
    const first = [[state.x, width], [state.y, height]].map(
      ([middle, side]) => Math.round(Number(middle) / kPartsOfCell / step) - Math.floor(side / 2),
    );
    const options = pythonOptions(state, optionsOf(state, shown[0], state.layers.indexOf(shown[0])));
    const grid = `"${functionOf(shown[0])}", (${width}, ${height}), step=${step}, first=(${first.join(", ")})`;
    return ["import hashnoise", "", `values = hashnoise.grid(${grid}, ${options})${indexOf(shown[0])}`];
  }
  const { lines, call } = patternOf(state, ["x", "y", state.z, state.w]);
  const line = `numpy.arange(${width}) * ${step}`;
  return [
    "import hashnoise", "import numpy", "", ...lines, "",
    dimensions === 1 ? `x = ${line}` : `x, y = numpy.meshgrid(${line}, numpy.arange(${height}) * ${step})`,
    `${["values", ...numbersOfTinted(state).map((number) => `mask_${number}`)].join(", ")} = ${call}`,
  ];
}

const indexOf = (layer) => (layer.sum === "none" && kShown[layer.noise] !== undefined ? `[${kShown[layer.noise]}]` : "");
const isInPython = (state) => shownLayers(state).every((layer) => functionOf(layer) || layer.noise === "middle");
// The distance from the middle, of the expressions of coordinates.
const middleInPython = ({ shape, radius }, [x, y = "0 * x"]) =>
  ({
    round: `numpy.maximum(1 - ((${x}) ** 2 + (${y}) ** 2) / ${radius * radius}, -1)`,
    square: `numpy.maximum(1 - numpy.maximum(abs(${x}), abs(${y})) ** 2 / ${radius * radius}, -1)`,
    along_x: `numpy.clip((${x}) / ${radius}, -1, 1) + 0 * (${y})`,
  })[shape] ?? `numpy.clip((${y}) / ${radius}, -1, 1) + 0 * (${x})`;
const pythonOptions = (state, options) =>
  Object.entries({
    ...(state.period ? { period: state.period } : {}),
    ...options,
    ...(state.arithmetic === "fast" ? {} : { arithmetic: "fixed" }),
  })
    .map(([name, value]) => `${name}=${typeof value === "string" ? `"${value}"` : value}`).join(", ");

// The picture as a function of Python, and its call at a place.
function patternOf(state, place) {
  const { dimensions } = state;
  const layers = shownLayers(state);
  const shown = shapes(state);
  const axes = kAxes.slice(0, dimensions);
  const clock = hasDrift(state) ? ["seconds"] : [];
  const parameters = [...axes, ...clock].join(", ");
  const warps = []; // by the layer
  const calls = layers.map((layer, number) => {
    const then = driftOf(layer, state).map((speed, i) => (speed ? `${axes[i]} - ${speed} * seconds`.replace("- -", "+ ") : axes[i]));
    const scaled = layer.scale === 1 ? then : then.map((axis) => `${layer.scale} * ${axis.includes(" ") ? `(${axis})` : axis}`);
    const period = state.period ? { period: state.period * layer.scale } : {};
    const options = pythonOptions(state, { ...optionsOf(state, layer, state.layers.indexOf(layer)), ...period });
    const moves = axes.map((axis) => `d${axis}_${number + 1}`);
    const isWarped = shown[number].warp !== "none";
    if (isWarped) {
      const { octaves, lacunarity, gain, amplitude } = layer;
      const ofWarp = pythonOptions(state, { seed: (layer.seed + 1) % 4294967296, octaves, lacunarity, gain, amplitude, ...period });
      warps[number] = `    ${moves.join(", ")} = hashnoise.${layer.warp}(${scaled.join(", ")}, ${ofWarp})`;
    }
    const passed = isWarped ? scaled.map((axis, i) => `${axis} + ${moves[i]}`) : scaled;
    if (kNoises[layer.noise].shape) return middleInPython(layer, passed);
    return `hashnoise.${functionOf(layer)}(${passed.join(", ")}, ${options})${indexOf(layer)}`;
  });
  // As integers are in other languages, as soon as something is done with the value of a noise.
  const isClipped = state.arithmetic === "fixed";
  const words = {
    name: (kind, at) => (kind === "v" ? "v" : `mask_${at + 1}`),
    numbers: (at) => [layers[at].weight, layers[at].offset],
    ease: (at) => Object.values(edgeOf(state, layers[at])),
    product: (one, other) => `${one} * ${other}`,
    stepped: String,
    result: (value) => (isClipped ? `numpy.clip(${value}, -8, 8)` : value),
    isExact: false, hasTints: true,
    part: (value) => `numpy.clip(${value}, 0, 1)`,
    lower: (...values) => `numpy.minimum(${values.join(", ")})`,
    higher: (...values) => `numpy.maximum(${values.join(", ")})`,
    slope: (v, at) => {
      const beside = axes.map((axis) => [...axes.map((other) => (other === axis ? `${axis} + ${kStepBeside}` : other)), ...clock].join(", "));
      return `slope(${["v", ...beside.map((passed) => `below_${at + 1}(${passed})`)].join(", ")})`;
    },
  };
  const linesOf = ({ steps }, count) => [...warps.slice(0, count).filter(Boolean), ...steps.map(([name, value]) => `    ${name} = ${value}`)];
  const whole = combined(shown, calls, words);
  const below = shown.flatMap(({ blend }, at) =>
    at && blend === "slope"
      ? [`def below_${at + 1}(${parameters}):`, ...linesOf(combined(shown.slice(0, at), calls, words), at), "    return v", ""]
      : [],
  );
  const leaning = leaningNumbers(state).map((row) => row.map((part, at) => `${part} * ${place[at]}`).join(" + "));
  const passed = isLeaning(state) ? [...leaning, ...place.slice(3)] : place;
  return {
    lines: [
      ...(below.length ? kSlope : []), ...below, "# Positions are in cells.",
      `def pattern(${parameters}):`, ...linesOf(whole), `    return ${["v", ...whole.masks].join(", ")}`,
    ],
    call: `pattern(${[...passed.slice(0, dimensions), ...clock.map(() => state.time)].join(", ")})`,
  };
}
