// The shaders of the page, and the numbers that they read. With HN_FIXED they draw the same bytes on every GPU, since
// everything from the position to the colour is whole numbers. With floats the edge between two colours of a map is smooth.
import { edgeOf, functions, numbers, partOf, shapes, spreadOf } from "./code.js";
import { hasDrift, isLeaning, isSolid, kMostLayers, mapsOf, rangeOf, shownLayers, tintedLayers, usualLayer } from "./model.js";
import { hasEdge } from "./palette.js";
import { kNoises } from "./tables.js";
import { solidPlace, solidShader, wordsOfSolid } from "./solid.js";
import { cellOf, leaningSteps, leant, originOf, partsOf, placeOf, shiftOf, stepOf, tileOf } from "./view.js";

// The content of a pixel: a colour of the map, or the four bytes of the value.
export const kColours = 0;
export const kBits = 1;
export const kTimes = 8; // that a shader computes the noise of a pixel, when it is timed
const kUnit = 1048576; // of a value, when it is made a whole number: 2^20
const kFinest = 16; // parts of the colours: a pixel on an edge has the colours of one part at most

// The words of a frame: ten vectors of four, and six more for each layer.
const kWordsOfFrame = 40;
const kWordsOfLayer = 24;
export const kFrameBytes = 4 * (kWordsOfFrame + kMostLayers * kWordsOfLayer);
const kGlslFrame = `struct Layer { ivec4 octaves; vec4 sum; vec4 more; uvec4 seed; ivec4 cell; uvec4 place; };
layout(std140) uniform Frame {
  ivec4 u_cell;
  uvec4 u_place;
  uvec4 u_step;
  ivec4 u_shown;
  uvec4 u_drawn;
  vec4 u_turn;
  ivec4 u_solid[4];
  Layer u_layers[${kMostLayers}];
};`;

// Where the frame begins, and how long a step is from one of its places to the next.
function placed(state, width, height) {
  if (isSolid(state)) return solidPlace(state);
  const position = [...originOf(state, width, height), partsOf(state.z), partsOf(state.w)];
  return { position, step: stepOf(state, width, height) };
}

const isSmooth = (state) => state.arithmetic === "fast" && state.dimensions > 1 && mapsOf(state).some(hasEdge);

// The values that the lowest and the highest colour stand for, in whole numbers of steps of 2^-20.
export function unitsOf(state) {
  const [low, high] = rangeOf(state).map((end) => Math.round(end * kUnit));
  return { low, span: Math.min(Math.max(high - low, 64), 16777215) };
}

// The frame of a picture of this size, or of so many rows of it from `first` on, counted from below. `position` is
// that of the pixel in the lower left corner of the picture, if it is not that of the state. A solid is in the middle
// of the first `free` columns.
export function frameOf(state, width, height, mode, { position, first = 0, rows = height, free = width } = {}) {
  const { position: begin, step } = placed(state, width, height);
  position ??= begin;
  if (isLeaning(state)) position = leant(state, position);
  const bytes = new ArrayBuffer(kFrameBytes);
  const whole = new Int32Array(bytes);
  const word = new Uint32Array(bytes);
  const float = new Float32Array(bytes);
  whole.set(position.map(cellOf), 0);
  word.set(position.map(placeOf), 4);
  word.set([Math.floor(step / 16777216), step % 16777216, width, height], 8);
  const { low, span } = unitsOf(state);
  whole.set([low, span, mode, first], 12);
  word.set([kTimes, first + rows - 1, tileOf(state, width, height), isSmooth(state) ? 1 : 0], 16);
  float.set([state.phase, state.time, 0, 0], 20);
  if (isSolid(state)) whole.set(wordsOfSolid(state, free, height), 24);
  if (isLeaning(state)) whole.set(leaningSteps(state, step).flatMap((way) => [...way.map(cellOf), 0, ...way.map(placeOf), 0]), 24);
  const soft = shapes(state).map((shape) => shape.soft);
  for (const [at, layer] of shownLayers(state).entries()) {
    const start = kWordsOfFrame + at * kWordsOfLayer;
    const { scale, lacunarity, gain, amplitude, seed } = layer;
    const { from, width, rate } = edgeOf(state, layer);
    const counts = soft[at] ? [from, width, rate] : [layer.weight, layer.offset].map((part) => partOf(state, part));
    const { unit, ratio } = spreadOf(state, layer);
    const [strength, jitter] = kNoises[layer.noise].shape ? [unit, ratio] : [layer.strength, layer.jitter];
    whole.set([layer.octaves, scale, state.period * scale, 0], start);
    float.set([lacunarity, gain, strength, amplitude, jitter, ...counts], start + 4);
    word.set([seed, (seed + 1) % 4294967296, 0, 0], start + 12);
    const shift = shiftOf(state, layer);
    whole.set(shift.map(cellOf), start + 16);
    word.set(shift.map(placeOf), start + 20);
  }
  return bytes;
}

// Names of uniforms for the layers that are shown.
function uniforms(state) {
  const n = state.dimensions;
  const [ints, floats] = n === 1 ? ["int", "float"] : [`ivec${n}`, `vec${n}`];
  return shownLayers(state).map((_, at) => {
    const of = `u_layers[${at}]`;
    return {
      seed: `${of}.seed.x`, otherSeed: `${of}.seed.y`, octaves: `${of}.octaves.x`, lacunarity: `${of}.sum.x`,
      gain: `${of}.sum.y`, strength: `${of}.sum.z`, amplitude: `${of}.sum.w`, jitter: `${of}.more.x`,
      weight: `${of}.more.y`, offset: `${of}.more.z`, from: `${of}.more.y`, width: `${of}.more.z`, rate: `${of}.more.w`,
      unit: `${of}.sum.z`, ratio: `${of}.more.x`, phase: "u_turn.x",
      period: `${ints}(${of}.octaves.z)`, scale: `float(${of}.octaves.y)`, wholeScale: `uint(${of}.octaves.y)`,
      shift: `${ints}(${of}.cell)`, drift: ` + ${floats}(${of}.place) * kPart`,
    };
  });
}

// The place of a pixel along an axis is origin + i * step. The step is taken in halves, so that no product leaves 32
// bits. On a slice that leans each axis has a step for both coordinates of a pixel.
const kPlace = `uvec2 place_beside(uvec2 place, uvec2 by, uint i) {
  uint low = i * (by.y & 4095u) + (place.y & 4095u);
  uint high = i * (by.y >> 12u) + (place.y >> 12u) + (low >> 12u);
  return uvec2(place.x + i * by.x + (high >> 12u), ((high & 4095u) << 12u) | (low & 4095u));
}
uvec2 place_of(int cell, uint place, uint i) {
  return place_beside(uvec2(uint(cell), place), u_step.xy, i);
}`;
const placesOf = (state, timed) => {
  if (timed || !isLeaning(state))
    return ["x", "y"].map((axis) => `  uvec2 ${axis} = place_of(u_cell.${axis}, u_place.${axis}, at.${axis});`);
  const by = (axis, way) => `uvec2(uint(u_solid[${way}].${axis}), uint(u_solid[${way + 1}].${axis}))`;
  return ["x", "y", "z"].map((axis) =>
    `  uvec2 ${axis} = place_beside(place_beside(uvec2(uint(u_cell.${axis}), u_place.${axis}), ${by(axis, 0)}, at.x), ${by(axis, 2)}, at.y);`);
};

// How a value is shown. A value in steps of 2^-20 is a whole number; the colour is one of 256. In one dimension the
// picture is a graph: full colour below the value, and an eighth of it above. Colours of layers are mixed in whole numbers,
// too. A map with an edge is read at four values, which are as far apart as in the pixels next to this one.
const shade = (tints) => `${tints ? `float tints[${tints}];\n` : ""}vec4 palette_at(int x, int y) { return texelFetch(u_palette, ivec2(x, y), 0); }
vec4 shade_value(float value, int row) {
  uint d = uint(clamp(int(floor(value * ${kUnit}.0)) - u_shown.x, 0, u_shown.y - 1));
  int entry = int(d * 256u / uint(u_shown.y));
  vec4 color = palette_at(entry, 0);${tints ? `
  for (int k = 0; k < ${tints}; k++) {
    uint part = uint(tints[k] * 65536.0);
    uvec4 other = uvec4(palette_at(entry, k + 1) * 255.0 + 0.5);
    color = vec4((uvec4(color * 255.0 + 0.5) * (65536u - part) + other * part + 32768u) >> uvec4(16u)) / 255.0;
  }` : ""}
  if (row >= 0 && uint(row) > (d >> 6u) * u_step.w / (uint(u_shown.y) >> 6u)) color = vec4(color.rgb * 0.125, 1.0);
  return color;
}
vec4 shade(float value, int row) {
  if (u_shown.z == ${kBits}) {
    uint bits = floatBitsToUint(value);
    return vec4(float(bits & 255u), float((bits >> 8u) & 255u), float((bits >> 16u) & 255u), float(bits >> 24u)) / 255.0;
  }
  if (u_drawn.w == 0u) return shade_value(value, row);
  float beside = min(fwidth(value), float(u_shown.y) / ${kUnit * kFinest}.0);
  vec4 color = vec4(0.0);
  for (int k = 0; k < 4; k++) color += shade_value(value + beside * (float(k) * 0.25 - 0.375), row);
  return color * 0.25;
}`;
// How much the layers with colours count at the pixel is kept for "shade".
const kept = (parts) => [...parts.map((part, at) => `tints[${at}] = ${part};`), "return v;"];

// The arguments of "pattern" at a pixel, for a number of dimensions: the cell and the place in it, or the position.
function argumentsOf(n, form, solid) {
  const vector = (type, parts) => (n === 1 ? parts[0] : `${type}(${parts.slice(0, n).join(", ")})`);
  const cell = vector(`ivec${n}`, ["int(x.x)", "int(y.x)", solid ? "int(z.x)" : "u_cell.z", "u_cell.w"]);
  const third = `float(${solid ? "z.y" : "u_place.z"})`;
  const places = vector(`vec${n}`, ["float(x.y)", "float(y.y)", third, "float(u_place.w)"]);
  if (form === "cell") return `${cell}, ${places} * kPart`;
  return `${n === 1 ? "float" : `vec${n}`}(${cell}) + ${places} * kPart`;
}
export const kVertex = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;

// The fragment shader. `values` are names of uniforms, or numbers; `form` is how "pattern" is called, and `value` what is
// shown. One that is timed computes it at several cells, so that the GPU has more to do than to write pixels. Both
// coordinates go on, so that no compiler computes one of them before the loop.
function shader(library, state, values, { timed, form = "cell", value } = {}) {
  const tints = timed || state.masks ? 0 : tintedLayers(state).length;
  const { lines, at: defined, public: called } = functions("glsl", state, values, [form], true, tints ? kept : undefined);
  const mask = state.masks ? defined("mask", ([part]) => [`return ${part};`]) : [];
  const solid = isSolid(state) && !timed ? solidShader(state, kBits) : undefined;
  const n = state.dimensions;
  const shown = value ?? `${state.masks ? "mask" : "pattern"}(${argumentsOf(n, form, solid || (!timed && isLeaning(state)))}${timed && hasDrift(state) ? ", u_turn.y" : ""})`;
  return [
    "#version 300 es",
    "precision highp float;",
    "precision highp int;",
    "precision highp sampler2D;",
    ...library.texts(called, "glsl", state),
    kGlslFrame,
    "uniform sampler2D u_palette;",
    "out vec4 color;",
    "const float kPart = 1.0 / 16777216.0;",
    shade(tints),
    ...lines,
    ...mask,
    kPlace,
    ...(solid ? [solid.point] : []),
    "void main() {",
    "  uvec2 at = (uvec2(gl_FragCoord.xy) + uvec2(0u, uint(u_shown.w))) % u_drawn.z;",
    ...(solid ? [solid.places] : placesOf(state, timed)),
    ...(timed
      ? [`  float sum = 0.0;`, `  for (uint i = 0u; i < u_drawn.x; ++i) { sum += ${shown}; x.x += 8u; y.x += 5u; }`]
      : [`  float sum = ${shown};`]),
    `  color = ${(solid ? solid.lit : String)(`shade(sum, ${n === 1 ? "int(at.y)" : "-1"})`)};`,
    "}",
    "",
  ].join("\n");
}

// To what costs are compared: hn_perlin on the plane, as the library has it by default.
export const plainOf = (state) => ({
  ...state,
  layers: [{ ...usualLayer(), sum: "none", noise: "perlin" }],
  dimensions: 2,
  phase: 0,
  period: 0,
  arithmetic: "fast",
  hash: "lattice",
});

// The shader that the page draws with: numbers are uniforms.
export const pageShader = (library, state) => shader(library, state, uniforms(state));

// The shader that is timed: the numbers stand in the text, as in a shader of somebody who copied it.
export const timedShader = (library, state, form) => shader(library, state, numbers("glsl", state), { timed: true, form });

// A shader in which nothing is computed but the position.
export function emptyShader(library, state) {
  const plain = plainOf(state);
  return shader(library, plain, numbers("glsl", plain), { timed: true, value: "float(x.x + x.y + y.y) * kPart" });
}
