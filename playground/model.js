// What can be chosen: noises, sums, settings, the text of a link, and the looks to begin with.

import { kCatalog } from "./catalog.js";

// Rows, each with what the library says of the function that it shows, and a row for each function that none shows.
function completed(rows, functions) {
  const shown = Object.entries(rows).map(([name, row]) => row.shows ?? name);
  const others = Object.keys(functions).filter((name) => !shown.includes(name));
  return Object.fromEntries([
    ...Object.entries(rows).map(([name, row]) => [name, { ...functions[row.shows ?? name], ...row }]),
    ...others.map((name) => [name, { label: titled(name), ...functions[name] }]),
  ]);
}
const isUnit = (range) => range !== undefined && range[0] === 0 && range[1] === 1;
const titled = (name) => `${name[0].toUpperCase()}${name.slice(1).replaceAll("_", " ")}`;

// Each noise: its name, and what of its values the colours span, if that is less than all. `of` makes the value that is shown of a call, `signed`
// makes of it a noise in about [-1, 1] that a sum can take. Both are exact in floats: products with powers of two, and
// differences of few bits.
const kNoiseRows = {
  perlin: { label: "Perlin", span: [0.6, 0.65, 0.5, 0.5] },
  value: { label: "Value", span: [0.95, 0.9, 0.85, 0.8] },
  value_cubic: { label: "Value, cubic", span: [0.75, 0.6, 0.43] },
  simplex: { label: "Simplex", span: [0, 0.7, 0.75, 0.7] },
  simplex_smooth: { label: "Simplex, smooth", span: [0, 0.75, 0.7] },
  curl: { label: "Curl, along x", range: [-5, 5], of: (call) => `${call}.x` },
  cellular: {
    label: "Cellular: nearest point", range: [0, 0.85], of: (call) => `${call}.x`,
    signed: (value) => `1.0 - 2.0 * ${value}`,
  },
  cellular_second: {
    label: "Cellular: second point", shows: "cellular", range: [0.2, 1.15], of: (call) => `${call}.y`,
    signed: (value) => `1.5 - 2.0 * ${value}`,
  },
  cellular_between: {
    label: "Cellular: second − nearest", shows: "cellular", range: [0, 0.7], between: true,
    signed: (value) => `1.0 - 2.0 * (${value})`,
  },
  cellular_third: {
    label: "Cellular: third point", shows: "cellular_three", range: [0.4, 1.3], of: (call) => `${call}.z`,
    signed: (value) => `1.75 - 2.0 * ${value}`,
  },
  cellular_smooth: { label: "Cellular: smooth", range: [0, 0.75], signed: (value) => `1.0 - 2.0 * ${value}` },
  cell_border: { label: "Cellular: border", range: [0, 0.4], signed: (value) => `4.0 * ${value} - 1.0` },
  cells: {
    label: "Cellular: cells", shows: "cellular", range: [0, 1], nearest: true,
    signed: (value) => `2.0 * ${value} - 1.0`,
  },
};
const kNoiseFunctions = Object.entries(kCatalog.noises).map(([name, noise]) => [
  name,
  { calls: `hn_${name}`, file: name, ...noise, ...(isUnit(noise.range) ? { signed: (value) => `2.0 * ${value} - 1.0` } : {}) },
]);
export const kNoises = completed(kNoiseRows, Object.fromEntries(kNoiseFunctions));

// Each sum: what of its values the colours span, for Perlin noise. A range that is not around 0 has two ends.
const kSumRows = {
  none: { label: "None: one octave" },
  fbm: { label: "fBm", span: [0.4, 0.4, 0.3, 0.3] },
  turbulence: { label: "Turbulence", ranges: [[0, 0.5], [0, 0.5], [0, 0.38], [0, 0.38]] },
  billow: { label: "Billow", ranges: [[-1, 0], [-1, -0.02], [-1, -0.25], [-1, -0.25]] },
  clouds: { label: "Clouds", ranges: [[0, 1], [0, 1], [0, 0.92], [0, 0.92]] },
  ridged: { label: "Ridged", ranges: [[0.1, 0.95], [0.1, 0.9], [0.3, 0.92], [0.3, 0.92]] },
  ping_pong: {
    label: "Ping-pong", strength: { ...kCatalog.sums.ping_pong.strength, most: 8 },
    ranges: [[-0.85, 0.6], [-0.8, 0.65], [-0.85, 0.45], [-0.85, 0.45]],
  },
  weighted: { label: "Weighted", span: [0.38, 0.34, 0.26, 0.26] },
  eroded: { label: "Eroded", span: [0, 0.26, 0.2] },
};
export const kSums = completed(kSumRows, kCatalog.sums);

export const kWarps = { none: "None", warp: "Warp", warp_progressive: "Progressive" };
export const kMetrics = Object.fromEntries(
  kCatalog.metrics.map((name) => [name, name[0].toUpperCase() + name.slice(1)]),
);
export const kArithmetics = { fast: "Floats", fixed: "Integers" };
export const kHashes = {
  lattice: "Lattice, the default", fnv1: "FNV-1", partial_fnv1: "FNV-1, partial", jenkins: "Jenkins",
  partial_jenkins: "Jenkins, partial", murmur: "Murmur", pcg: "PCG", xxhash32: "xxHash32",
};
// What can be saved. A height is a number of 16 bits.
const kOfHeights = "Heights go from 0 for the lowest colour to 65535 for the highest. ";
const kOfRaw = "The upper row comes first, and of each number the lowest byte.";
export const kFiles = {
  colours: { label: "PNG, colours", png: true, ending: "png", note: "The file has the colours of the picture." },
  heights: { label: "PNG, heights in 16 bits", png: true, ending: "png", note: kOfHeights },
  r16: { label: "Raw heights in 16 bits", ending: "r16", note: kOfHeights + kOfRaw },
  r32: { label: "Raw values in floats", ending: "r32", note: `Values are as pattern(p) returns them. ${kOfRaw}` },
};
export const kViews = { plane: "Plane", tiles: "Tiles, 3 × 3" };
export const kRenderers = { webgl2: "WebGL2", webgpu: "WebGPU" };

// Colours from the lowest value to the highest, at even distances; between them they are mixed.
export const kMaps = {
  grey: { label: "Grey", stops: ["000000", "ffffff"] },
  dusk: { label: "Dusk", stops: ["0d0b26", "2b1a5a", "6a2a7e", "b13c73", "e8695a", "f8a95f", "fde9b8"] },
  lagoon: { label: "Lagoon", stops: ["04141f", "0a3a4c", "0f6a74", "2aa198", "7fd1ae", "e3f5d8"] },
  land: { label: "Land", stops: ["0b2447", "19568a", "4aa3bf", "e2d3a2", "8cab5e", "4a7a4a", "857862", "f6f5f2"] },
  ember: { label: "Ember", stops: ["050308", "3a0a0f", "8a1b10", "d94a12", "f7a027", "fff2c2"] },
  moss: { label: "Moss", stops: ["10140f", "26331f", "4c6233", "8a9a4a", "cfc98a", "f7f2dc"] },
  marble: { label: "Marble", stops: ["23252e", "6d6f7a", "b9b9bd", "e8e6e3", "f6f4f1", "fdfcfb"] },
  sky: { label: "Sky", stops: ["2d6bb0", "5c97d1", "9fc4e4", "dbe8f3", "f7fafc", "ffffff"] },
  wood: { label: "Wood", stops: ["341a0c", "6b3a1a", "9c6231", "c58d52", "e0b67d", "b57a43"] },
  signed: {
    label: "Below and above the middle",
    stops: ["1f4e9c", "6fa0d6", "c9dcee", "f7f6f3", "f3c7a5", "dd7f4c", "a8361a"],
  },
};

// The settings, in the order of a link. A number has its ends; x and y are read and written by the view.
export const kSettings = {
  sum: { usual: "fbm", of: kSums },
  noise: { usual: "perlin", of: kNoises },
  dimensions: { usual: 2, from: 1, to: 4, whole: true },
  seed: { usual: 7, from: 0, to: 4294967295, whole: true },
  octaves: { usual: 6, from: 1, to: 16, whole: true },
  lacunarity: { usual: 2, from: 1, to: 8 },
  gain: { usual: 0.5, from: 0, to: 1 },
  strength: { usual: 1, from: 0, to: 16 },  // usual: as the sum has it
  period: { usual: 0, from: 0, to: 65536, whole: true },
  jitter: { usual: 1, from: 0, to: 1 },
  metric: { usual: "euclidean", of: kMetrics },
  warp: { usual: "none", of: kWarps },
  amplitude: { usual: 2, from: 0, to: 16 },
  phase: { usual: 0, from: 0, to: 1 },
  z: { usual: 0.37, from: -1e9, to: 1e9 },
  w: { usual: 0.62, from: -1e9, to: 1e9 },
  arithmetic: { usual: "fast", of: kArithmetics },
  hash: { usual: "lattice", of: kHashes },
  view: { usual: "plane", of: kViews },
  map: { usual: "dusk", of: kMaps },
  contrast: { usual: 1, from: 0.25, to: 4 },
  x: { usual: 0n },
  y: { usual: 0n },
  cells: { usual: 8, from: 1 / 64, to: 1048576 },
  renderer: { usual: "webgl2", of: kRenderers },
  file: { usual: "colours", of: kFiles },
  width: { usual: 1024, from: 1, to: 8192, whole: true },
  height: { usual: 1024, from: 1, to: 8192, whole: true },
};

// A position is a whole number of these parts of a cell: a BigInt of 56 bits, since cells wrap at 2^32.
export const kParts = 16777216n;
const kDigits = 100000000n;  // of a fraction in a link: finer than a part, so that a part comes back as it was
const kLimit = 2147483648n * kParts;  // positions are from -2^31 cells up to below 2^31

export const wrapped = (parts) => BigInt.asIntN(56, parts);

export function positionText(parts) {
  const size = parts < 0n ? -parts : parts;
  const whole = size / kParts;
  const digits = ((size % kParts) * kDigits + kParts / 2n) / kParts;
  const fraction = digits.toString().padStart(8, "0").replace(/0+$/, "");
  return `${parts < 0n ? "-" : ""}${whole}${fraction ? `.${fraction}` : ""}`;
}

const kMostPower = 1000000000;  // beyond it a power of ten is as good as this one

// The parts of a number as people and programs write it, such as -12.5, 1,25, .5, 3e-4 or Infinity: its sign, its
// digits, and the power of ten that they are multiplied by. Nothing for what is no number.
function partsOfNumber(text) {
  const match = /^\s*([-+−]?)(?:(Infinity)|(?=[.,]?\d)(\d*)(?:[.,](\d*))?(?:e([-+−]?\d+))?)\s*$/i.exec(text);
  if (!match) return undefined;
  const [, sign, infinite, whole = "", fraction = "", exponent = "0"] = match;
  const power = Number(exponent.replace("−", "-"));
  return {
    negative: sign === "-" || sign === "−",
    digits: infinite ? "1" : (whole + fraction).replace(/^0+/, ""),
    power: infinite ? kMostPower : Math.max(-kMostPower, Math.min(power, kMostPower)) - fraction.length,
  };
}

// Of a number that is too large for a float it is an infinity, and possible() makes of that the largest that can be.
export function parsedNumber(text) {
  const parts = partsOfNumber(text);
  if (!parts) return undefined;
  const { negative, digits, power } = parts;
  const size = Number(`${digits || "0"}e${power}`);
  return negative ? -size : size;
}

// Exact, and the nearest position that there is for a number that is none.
export function parsedPosition(text) {
  const parts = partsOfNumber(text);
  if (!parts) return undefined;
  const { negative, digits, power } = parts;
  const places = digits.length + power; // in front of the point
  if (!digits || places < -9) return 0n;
  if (places > 10) return negative ? -kLimit : kLimit - 1n;
  const scaled = BigInt(digits) * kParts;
  const ten = 10n ** BigInt(Math.abs(power));
  const size = power < 0 ? (scaled + ten / 2n) / ten : scaled * ten;
  if (size >= kLimit) return negative ? -kLimit : kLimit - 1n;
  return negative ? -size : size;
}

// Whether two texts are one number, however they are written.
export function sameNumber(one, other) {
  const plain = (text) => {
    const { negative, digits, power } = partsOfNumber(text);
    const shortest = digits.replace(/0+$/, "");
    return shortest ? `${negative ? "-" : ""}${shortest}e${power + digits.length - shortest.length}` : "0";
  };
  return plain(one) === plain(other);
}

// Numbers have at most four digits behind the point, and at most seven in all, so that a link has them as they are.
function rounded(value, setting) {
  if (setting.whole) return Math.round(value);
  return Number(Number(value.toPrecision(9)).toFixed(4));
}

export const usualState = () =>
  Object.fromEntries(Object.entries(kSettings).map(([name, setting]) => [name, setting.usual]));

// The state with every setting possible: what a noise or a sum does not have becomes what it has.
export function possible(state) {
  const next = { ...usualState(), ...state };
  for (const [name, setting] of Object.entries(kSettings)) {
    if (setting.of) {
      if (!Object.hasOwn(setting.of, next[name])) next[name] = setting.usual;
    } else if (typeof setting.usual === "bigint") {
      next[name] = typeof next[name] === "bigint" ? wrapped(next[name]) : setting.usual;
    } else {
      const value = typeof next[name] !== "number" || Number.isNaN(next[name]) ? setting.usual : next[name];
      next[name] = name === "cells" ? Number(Math.min(Math.max(value, setting.from), setting.to).toPrecision(6))
                                    : rounded(Math.min(Math.max(value, setting.from), setting.to), setting);
    }
  }
  if (!noisesOf(next.sum).includes(next.noise)) next.noise = "perlin";
  const dimensions = dimensionsOf(next);
  if (!dimensions.includes(next.dimensions)) next.dimensions = 2;
  const { strength } = kSums[next.sum];
  next.strength = strength ? Math.min(next.strength, strength.most) : kSettings.strength.usual;
  if (!next.period || next.dimensions === 1) next.view = "plane";
  if (next.period && next.sum !== "none") next.lacunarity = Math.floor(next.lacunarity);
  return next;
}

export function noisesOf(sum) {
  if (sum === "none") return Object.keys(kNoises);
  const fits = (noise) => (kSums[sum].steep ? noise.steep : noise.span || noise.signed || !noise.range);
  return Object.keys(kNoises).filter((name) => fits(kNoises[name]));
}

export function dimensionsOf({ noise, sum }) {
  const possible = kSums[sum].dimensions ?? [1, 2, 3, 4];
  return kNoises[noise].dimensions.filter((dimension) => possible.includes(dimension));
}

// Which settings the state uses. The others are not shown, and have no place in a link.
export function uses(state) {
  const noise = kNoises[state.noise];
  const sum = state.sum !== "none";
  const warped = state.dimensions === 2 || state.dimensions === 3;
  return {
    sum: true, noise: true, dimensions: true, seed: true, period: true, arithmetic: true, hash: true, map: true,
    contrast: true, x: true, y: state.dimensions > 1, cells: state.view !== "tiles", renderer: true,
    view: state.dimensions > 1,
    file: true, width: true, height: true,
    octaves: sum, lacunarity: sum, gain: sum, strength: Boolean(kSums[state.sum].strength),
    jitter: Boolean(noise.jitter), metric: Boolean(noise.metric),
    warp: warped, amplitude: warped && state.warp !== "none",
    phase: Boolean(noise.phase) && !sum && warped, z: state.dimensions > 2, w: state.dimensions > 3,
  };
}

const usualOf = (name, state) =>
  name === "strength" ? kSums[state.sum].strength?.usual ?? kSettings.strength.usual : kSettings[name].usual;

// "#noise=simplex&cells=16": what differs from the usual, in one order, so that equal states have equal links.
export function linkOf(state) {
  const used = uses(state);
  const parts = [];
  for (const name of Object.keys(kSettings)) {
    if (!used[name] || state[name] === usualOf(name, state)) continue;
    const value = state[name];
    parts.push(`${name}=${typeof value === "bigint" ? positionText(value) : value}`);
  }
  return parts.length ? `#${parts.join("&")}` : "";
}

// What somebody wrote as the value of a setting. Nothing for what is no number where it should be one.
export function parsed(name, text) {
  const setting = kSettings[name];
  if (setting.of) return text;
  return typeof setting.usual === "bigint" ? parsedPosition(text) : parsedNumber(text);
}

// Which numbers a setting takes, for people.
export function numbersOf(name) {
  const { usual, whole, from, to } = kSettings[name];
  if (typeof usual === "bigint") return "a number from −2147483648 to 2147483648, such as 12.5 or 1e9";
  const digits = name === "cells" ? " of at most six digits" : "";
  return `a ${whole ? "whole " : ""}number${digits} from ${from} to ${to}`;
}

// The state of a link. Unknown names and values that are none count as absent.
export function stateOf(link) {
  const given = new URLSearchParams(link.replace(/^#/, ""));
  const state = usualState();
  for (const [name, setting] of Object.entries(kSettings)) {
    const text = given.get(name);
    if (text === null) continue;
    state[name] = parsed(name, text) ?? setting.usual;
  }
  if (!given.has("strength") && Object.hasOwn(kSums, state.sum)) state.strength = usualOf("strength", state);
  return possible(state);
}

// The values that the lowest and the highest colour stand for.
export function rangeOf(state) {
  const at = state.dimensions - 1;
  const noise = kNoises[state.noise];
  const sum = kSums[state.sum];
  let [low, high] = [0, 1];
  if (state.sum === "none") {
    [low, high] = noise.span ? [-noise.span[at], noise.span[at]] : (noise.range ?? [-1, 1]);
  } else {
    // Noises other than Perlin's have more contrast or less.
    const ratio = Math.min((noise.span?.[at] ?? 0.8) / kNoises.perlin.span[at], 1.6);
    if (sum.span) [low, high] = [-sum.span[at] * ratio, sum.span[at] * ratio];
    else [low, high] = sum.ranges ? sum.ranges[at] : (sum.range ?? [-1, 1]);
    if (state.sum === "turbulence") high *= ratio;
    if (state.sum === "billow") high = Math.min(low + (high - low) * ratio, 1);
  }
  const middle = (low + high) / 2;
  const half = (high - low) / 2 / state.contrast;
  return [middle - half, middle + half];
}

// Looks to begin with.
export const kLooks = {
  Hills: { sum: "fbm", octaves: 8, map: "land", cells: 5, seed: 21 },
  Dusk: {},
  Ridges: { sum: "ridged", octaves: 8, map: "grey", cells: 3, seed: 3 },
  Ink: { sum: "fbm", warp: "warp_progressive", map: "lagoon", cells: 5, octaves: 7 },
  Sky: { sum: "clouds", dimensions: 3, map: "sky", cells: 6, octaves: 8 },
  Agate: { sum: "ping_pong", octaves: 4, gain: 0.4, strength: 3, warp: "warp", amplitude: 1, map: "wood", cells: 3 },
  Stones: { sum: "none", noise: "cellular_between", map: "moss", cells: 9 },
  Cracks: { sum: "none", noise: "cell_border", map: "ember", cells: 7, warp: "warp", amplitude: 0.6 },
  Slopes: { sum: "eroded", octaves: 9, map: "marble", cells: 4, strength: 4 },
  Tiles: { sum: "fbm", period: 3, map: "signed", cells: 9, seed: 4 },
  Foam: { sum: "fbm", noise: "cellular", octaves: 4, map: "lagoon", cells: 7 },
  "Far out": {
    sum: "fbm", noise: "simplex", map: "dusk", cells: 4, x: 1000000000n * 16777216n, y: -2000000000n * 16777216n,
  },
};

export function stateOfLook(name, { renderer, arithmetic, file, width, height }) {
  const look = kLooks[name];
  const state = { ...usualState(), ...look, renderer, arithmetic, file, width, height };
  if (look.strength === undefined) state.strength = usualOf("strength", state);
  return possible(state);
}
