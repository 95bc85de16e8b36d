// The choices: noises, sums and the others, each with its properties.

import { kCatalog } from "./catalog.js";

// Rows, each with the catalog's entry of the function that it shows, and a row for each function that none shows.
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
  middle: {
    label: "Distance from the middle", dimensions: [1, 2, 3, 4], range: [-1, 1], shape: true,
    about: "No noise: 1 in the middle, x = y = 0, 0 at the radius, and -1 far from it. It makes islands, and edges dark.",
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
export const kShapes = { round: "Round", square: "Square", along_x: "Along x", along_y: "Along y" };
export const kArithmetics = { fast: "Floats", fixed: "Integers" };
export const kHashes = {
  lattice: "Lattice, the default", fnv1: "FNV-1", partial_fnv1: "FNV-1, partial", jenkins: "Jenkins",
  partial_jenkins: "Jenkins, partial", murmur: "Murmur", pcg: "PCG", xxhash32: "xxHash32",
};
// The kinds of files. A height is a number of 16 bits.
const kOfHeights = "Heights go from 0 for the lowest colour to 65535 for the highest. ";
const kOfRaw = "The upper row comes first, and of each number the lowest byte.";
const kOfLoop =
  "One octave of Perlin or simplex noise loops in 2D and 3D. Others need a period, in 3D or 4D, or have one frame.";
const kOfNormals = "Red is to the right, green is up, as in OpenGL; for Direct3D turn green over. Relief sets how steep it is. ";
export const kFiles = {
  colours: { label: "PNG, colours", png: true, ending: "png", note: "The file has the colours of the picture." },
  heights: { label: "PNG, heights in 16 bits", png: true, ending: "png", note: kOfHeights },
  normals: { label: "PNG, normal map", png: true, ending: "png", note: kOfNormals },
  tiff: { label: "TIFF, values in floats", ending: "tif", part: "values", note: "Values are as pattern(p) returns them." },
  gif: { label: "GIF, a loop", ending: "gif", part: "loop", note: kOfLoop },
  r16: { label: "Raw heights in 16 bits", ending: "r16", part: "heights", note: kOfHeights + kOfRaw },
  r32: { label: "Raw values in floats", ending: "r32", part: "values", note: `Values are as pattern(p) returns them. ${kOfRaw}` },
  json: { label: "JSON, the setting", ending: "json", part: "setting", note: "Drop it onto the picture to open it again, or a PNG of this page." },
};
export const kViews = { plane: "Plane", tiles: "3 × 3 tiles", terrain: "Terrain", sphere: "Sphere", cube: "Cube" };
// How a layer is combined with the layers below it.
export const kBlends = {
  add: { label: "Add", sign: "+" },
  multiply: { label: "Multiply", sign: "×" },
  min: { label: "Take the lower", sign: "min" },
  max: { label: "Take the higher", sign: "max" },
  mix: { label: "Mix", sign: "mix" },
  mask: { label: "Mask of the next", sign: "mask" },
  height: { label: "Where it is high", sign: "high" },
  slope: { label: "Where it is steep", sign: "steep" },
};
// The line below each setting. The glossary has these, too (docs/reference/glossary.md). A fractal and a noise have a note.
export const kAbout = {
  ...kCatalog.settings,
  gain: "Ratio of amplitudes, octave to octave (persistence).",
  strength: "How much the fractal does what it is named for.",
  metric: "How distances to points are measured.",
  shape: "Of the lines on which the value is the same.",
  radius: "Where the value is 0, in cells from the middle.",
  warp: "Noise moves each place first, so the pattern bends.",
  amplitude: "How far the warp moves a place at most, in cells.",
  blend: "How the layer changes the value of those above it.",
  weight: "The values of the layer are multiplied by it.",
  offset: "It is added to the values of the layer.",
  from: "Where the layer begins to count, by the value.",
  soft: "How wide its edge is. Below 0 it counts downwards.",
  scale: "How many times as fine as the picture the layer is.",
  driftx: "Cells that it moves to the right in a second.",
  drifty: "Cells that it moves up in a second.",
  driftz: "Cells through space in a second, which change it.",
  time: "How long layers have drifted. Play lets it pass.",
  z: "Which slice of space the picture shows.",
  w: "Which part of the fourth dimension it shows.",
  lean: "How far it leans to the diagonal, in turns.",
  hash: "It makes random numbers: each another picture.",
  contrast: "How steeply colours follow the values.",
  steep: "How high the highest colour is.",
  sea: "Lower ground is under water. 0 is no sea.",
};

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
  own: { label: "Your own" }, // of the setting "stops"
};
export const kTints = { none: { label: "Colours of the picture" }, ...kMaps };
