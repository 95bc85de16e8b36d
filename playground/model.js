// The state of the picture, as a list of layers and the settings of the whole picture.

import { scaleWithin, wrapped } from "./numbers.js";
import { possibleStops, stopsOfMap } from "./palette.js";
import {
  kArithmetics, kBlends, kFiles, kHashes, kMaps, kMetrics, kNoises, kShapes, kSums, kTints, kViews, kWarps,
} from "./tables.js";

// The settings, in the order of a link. A number has its ends; x and y are read and written by the view. Each layer has
// its own of some, and the others are those of the whole picture.
export const kSettings = {
  sum: { usual: "fbm", of: kSums, layer: true },
  noise: { usual: "perlin", of: kNoises, layer: true },
  dimensions: { usual: 2, from: 1, to: 4, whole: true },
  seed: { usual: 7, from: 0, to: 4294967295, whole: true, layer: true },
  octaves: { usual: 6, from: 1, to: 16, whole: true, layer: true },
  lacunarity: { usual: 2, from: 1, to: 8, layer: true },
  gain: { usual: 0.5, from: 0, to: 1, layer: true },
  strength: { usual: 1, from: 0, to: 16, layer: true }, // usual: as the sum has it
  period: { usual: 0, from: 0, to: 65536, whole: true },
  jitter: { usual: 1, from: 0, to: 1, layer: true },
  metric: { usual: "euclidean", of: kMetrics, layer: true },
  shape: { usual: "round", of: kShapes, layer: true },
  radius: { usual: 3, from: 0.25, to: 64, layer: true },
  warp: { usual: "none", of: kWarps, layer: true },
  amplitude: { usual: 2, from: 0, to: 16, layer: true },
  on: { usual: 1, from: 0, to: 1, whole: true, layer: true },
  blend: { usual: "add", of: kBlends, layer: true },
  weight: { usual: 1, from: -4, to: 4, layer: true },
  offset: { usual: 0, from: -4, to: 4, layer: true },
  from: { usual: 0, from: -8, to: 8, layer: true },
  soft: { usual: 0, from: -16, to: 16, layer: true }, // usual: the weight and the offset count, as in links before 1.1
  scale: { usual: 1, from: 1, to: 64, power: true, layer: true },
  driftx: { usual: 0, from: -16, to: 16, layer: true },
  drifty: { usual: 0, from: -16, to: 16, layer: true },
  driftz: { usual: 0, from: -16, to: 16, layer: true },
  tint: { usual: "none", of: kTints, layer: true },
  tints: { usual: "0-000000_100-ffffff", fit: possibleStops, layer: true },
  time: { usual: 0, from: 0, to: 1e6 },
  phase: { usual: 0, from: 0, to: 1 },
  z: { usual: 0.37, from: -1e9, to: 1e9 },
  w: { usual: 0.62, from: -1e9, to: 1e9 },
  lean: { usual: 0, from: 0, to: 0.25 },
  arithmetic: { usual: "fast", of: kArithmetics },
  hash: { usual: "lattice", of: kHashes },
  view: { usual: "plane", of: kViews },
  turn: { usual: 0.1, from: 0, to: 1 },
  tilt: { usual: 0.1, from: -0.25, to: 0.25 },
  steep: { usual: 0.2, from: 0, to: 1 },
  sea: { usual: 0, from: 0, to: 1 },
  map: { usual: "dusk", of: kMaps },
  stops: { usual: "0-000000_100-ffffff", fit: possibleStops },
  contrast: { usual: 1, from: 0.25, to: 4 },
  x: { usual: 0n },
  y: { usual: 0n },
  cells: { usual: 8, from: 1 / 64, to: 1048576 },
  file: { usual: "colours", of: kFiles },
  width: { usual: 1024, from: 1, to: 8192, whole: true },
  height: { usual: 1024, from: 1, to: 8192, whole: true },
  frames: { usual: 40, from: 2, to: 200, whole: true },
};

export const kMostLayers = 8;
const kMostSlopes = 2; // layers, since each needs what is below it at several places
const kLeastSoft = 0.016; // so that its reciprocal has few bits
export const kLeastTilt = 0.02; // of terrain, which has nothing to be seen from below
const kUsualTile = 4; // cells of a period that nobody has chosen

// Numbers have at most four digits behind the point, and at most seven in all, so that a link has them as they are.
function rounded(value, setting) {
  if (setting.whole) return Math.round(value);
  if (setting.power) return 2 ** Math.round(Math.log2(value));
  return Number(Number(value.toPrecision(9)).toFixed(4));
}

const usualsOf = (ofLayer) =>
  Object.fromEntries(
    Object.entries(kSettings)
      .filter(([, { layer = false }]) => layer === ofLayer)
      .map(([name, { usual }]) => [name, usual]),
  );
export const usualLayer = () => usualsOf(true);
export const usualState = () => ({ ...usualsOf(false), layers: [usualLayer()] });

export const usualOf = (name, layer) =>
  name === "strength" ? kSums[layer.sum].strength?.usual ?? kSettings.strength.usual : kSettings[name].usual;

// All settings by their names, those of this layer among them.
export const settingsOf = (state, at = 0) => ({ ...state, ...state.layers[at] });

// The layers that are not switched off.
export const shownLayers = ({ layers }) => layers.filter(({ on }) => on);

// How far a layer moves in a second along each axis; and whether one that is shown does.
export const driftOf = ({ driftx, drifty, driftz }, { dimensions }) => [driftx, drifty, driftz, 0].slice(0, dimensions);
export const isDrifting = (layer, state) => driftOf(layer, state).some(Boolean);
export const hasDrift = (state) => shownLayers(state).some((layer) => isDrifting(layer, state));

// Whether colours of its own can show where a layer counts, and whether they do.
const canTint = ({ blend }) => ["mix", "mask", "height", "slope"].includes(blend);
const isTinted = (layer, at) => at > 0 && layer.tint !== "none" && canTint(layer);
// The layers that are shown and have colours of their own. Nothing is below the lowest one.
export const tintedLayers = (state) => shownLayers(state).filter(isTinted);
// Their numbers among those that are shown, from 1 on, as code has them.
export const numbersOfTinted = (state) => tintedLayers(state).map((layer) => shownLayers(state).indexOf(layer) + 1);
export const mapsOf = (state) =>
  state.masks ? [{ map: "grey" }] : [state, ...tintedLayers(state).map(({ tint, tints }) => ({ map: tint, stops: tints }))];

// A ball or a cube of space, for which there have to be three dimensions.
export const isSolid = ({ view, dimensions }) => dimensions > 2 && (view === "sphere" || view === "cube");
// Everything but a plane can be rotated.
export const isTurned = (state) => state.view === "terrain" || isSolid(state);
// A file with frames.
export const isLoop = ({ file }) => kFiles[file].part === "loop";

// A slice of space that is not along the cells. Tiles and loops need one that is.
const canLean = (state) => state.dimensions > 2 && !state.period && !isSolid(state);
export const isLeaning = (state) => canLean(state) && state.lean > 0;

// The height of the highest colour on terrain, in sides of the block. More cells make it lower, as if seen from farther
// away: with one height for all scales many cells would be a field of spires.
const kCellsOfWholeRelief = 2;
export const reliefHeight = ({ steep, cells }) => steep * Math.min(1, kCellsOfWholeRelief / cells);

// The names of the layers, for people, and the settings by which layers of one name differ.
export const titleOf = ({ sum, noise }) =>
  sum === "none" ? kNoises[noise].label : `${kSums[sum].label} of ${kNoises[noise].label}`;
export const detailsOf = ({ blend, noise, seed, scale }, at) =>
  `${at ? kBlends[blend].label : "Base"}${kNoises[noise].shape ? "" : ` · seed ${seed}`}${scale > 1 ? ` · ${scale} × as fine` : ""}`;
export const titlesOf = ({ layers }) =>
  layers.map((layer, at) => `${at ? `${kBlends[layer.blend].sign} ` : ""}${titleOf(layer)}`);

// The state with these settings, those of a layer in this one.
export function changed(state, changes, at = 0) {
  const [ofLayer, ofPicture] = [true, false].map((layer) =>
    Object.fromEntries(Object.entries(changes).filter(([name]) => Boolean(kSettings[name]?.layer) === layer)),
  );
  const next = { ...state, ...ofPicture };
  return { ...next, layers: next.layers.map((layer, number) => (number === at ? { ...layer, ...ofLayer } : layer)) };
}

// The settings that a view needs, unless they are given: tiles have a period, and solids have three dimensions.
export const goingWith = (state, isGiven = () => false) => ({
  ...(state.view === "tiles" && !state.period && !isGiven("period") ? { period: kUsualTile } : {}),
  ...(isSolid({ ...state, dimensions: 3 }) && state.dimensions < 3 && !isGiven("dimensions") ? { dimensions: 3 } : {}),
});

// The state after a choice, with what goes with it: a strength as its sum has it, half of a mixture is seen of
// each, tiles have a period, solids have three dimensions, and a map of one's own begins with the one that was shown.
export function chosen(state, changes, at = 0) {
  const next = changed(state, changes, at);
  const layer = next.layers[at];
  if (changes.sum && changes.sum !== state.layers[at].sum) layer.strength = usualOf("strength", layer);
  if (changes.noise && kNoises[changes.noise].shape) layer.sum = "none"; // no fractal has it
  if (changes.blend === "mix" && layer.weight === 1) layer.weight = 0.5;
  if (changes.blend && canEase(layer)) Object.assign(layer, easeBelow(next, at));
  if (changes.from !== undefined || changes.soft !== undefined) Object.assign(layer, easeOf(state.layers[at]), changes);
  if (changes.view) Object.assign(next, goingWith(next));
  const untouched = next.stops === kSettings.stops.usual;
  if (changes.map === "own" && state.map !== "own" && untouched) next.stops = stopsOfMap(state.map);
  if (changes.tint === "own" && layer.tints === kSettings.tints.usual) {
    const { tint } = state.layers[at];
    const { map, stops } = tint === "none" ? state : { map: tint, stops: layer.tints };
    layer.tints = map === "own" ? stops : stopsOfMap(map);
  }
  return possible(next);
}

// The setting as it is, or the nearest that it can be.
function possibleSetting(name, given) {
  const setting = kSettings[name];
  const { usual } = setting;
  if (setting.of) return Object.hasOwn(setting.of, given) ? given : usual;
  if (setting.fit) return setting.fit(given) ?? usual;
  if (typeof usual === "bigint") return typeof given === "bigint" ? wrapped(given) : usual;
  const value = typeof given !== "number" || Number.isNaN(given) ? usual : given;
  if (name === "cells") return scaleWithin(value, setting);
  return rounded(Math.min(Math.max(value, setting.from), setting.to), setting);
}

const possibleSettings = (usuals, given) =>
  Object.fromEntries(
    Object.entries(usuals).map(([name, usual]) => [name, possibleSetting(name, given[name] ?? usual)]),
  );

function possibleLayer(given, period) {
  const layer = possibleSettings(usualLayer(), given);
  if (!noisesOf(layer.sum).includes(layer.noise)) layer.noise = "perlin";
  const { strength } = kSums[layer.sum];
  if (layer.soft) layer.soft = Math.sign(layer.soft) * Math.max(Math.abs(layer.soft), kLeastSoft);
  layer.strength = strength ? Math.min(layer.strength, strength.most) : kSettings.strength.usual;
  if (period && layer.sum !== "none") layer.lacunarity = Math.floor(layer.lacunarity);
  return layer;
}

// The state with every setting possible: a setting that a noise or a sum lacks becomes one that it has.
export function possible(state) {
  const next = possibleSettings(usualsOf(false), state);
  next.layers = state.layers.slice(0, kMostLayers).map((layer) => possibleLayer(layer, next.period));
  for (const layer of next.layers.filter(({ blend }) => blend === "slope").slice(kMostSlopes)) layer.blend = "height";
  if (!shownLayers(next).length) next.layers[0].on = 1;
  if (next.layers.length === 1) next.layers[0].scale = 1; // of a layer alone there is none, and its tiles would have it
  if (!dimensionsOf(next).includes(next.dimensions)) next.dimensions = 2;
  if ((next.view === "tiles" && !next.period) || next.dimensions === 1) next.view = "plane";
  if (next.view !== "plane" && next.view !== "tiles" && !isTurned(next)) next.view = "plane";
  if (!isSolid(next)) next.tilt = Math.max(next.tilt, kLeastTilt);
  return next;
}

export function noisesOf(sum) {
  if (sum === "none") return Object.keys(kNoises);
  const fits = (noise) => (kSums[sum].steep ? noise.steep : noise.span || noise.signed || !noise.range);
  return Object.keys(kNoises).filter((name) => fits(kNoises[name]));
}

export function dimensionsOfLayer({ noise, sum }) {
  const possible = kSums[sum].dimensions ?? [1, 2, 3, 4];
  return kNoises[noise].dimensions.filter((dimension) => possible.includes(dimension));
}

export const dimensionsOf = ({ layers }) =>
  [1, 2, 3, 4].filter((dimension) => layers.every((layer) => dimensionsOfLayer(layer).includes(dimension)));

// Which settings this layer and the picture use. The others are not shown, and have no place in a link.
export function uses(state, at = 0) {
  const layer = state.layers[at];
  const noise = kNoises[layer.noise];
  const sum = layer.sum !== "none";
  const turned = isTurned(state);
  const several = state.layers.length > 1;
  const mixed = at > 0 && layer.blend === "mix";
  const warped = state.dimensions === 2 || state.dimensions === 3;
  const octaves = sum || (warped && layer.warp !== "none");
  const ease = at > 0 && canEase(layer);
  const eased = ease && layer.soft !== 0;
  const middle = Boolean(noise.shape);
  const turns = (other) => other.sum === "none" && Boolean(kNoises[other.noise].phase);
  return {
    sum: true, noise: true, dimensions: true, seed: !middle || octaves, period: true, arithmetic: true, hash: true, map: true,
    stops: state.map === "own", contrast: true, x: true, y: state.dimensions > 1, cells: state.view !== "tiles",
    view: state.dimensions > 1, turn: turned, tilt: turned, steep: state.view === "terrain" || state.file === "normals", sea: state.view === "terrain",
    file: true, width: state.file !== "json", height: state.file !== "json", frames: isLoop(state),
    octaves, lacunarity: octaves, gain: octaves, strength: Boolean(kSums[layer.sum].strength),
    jitter: Boolean(noise.jitter), metric: Boolean(noise.metric), shape: middle, radius: middle,
    warp: warped, amplitude: warped && layer.warp !== "none",
    on: several, blend: at > 0, weight: several && !eased, offset: several && !mixed && !eased, ease, from: eased, soft: eased, scale: several,
    tint: at > 0 && canTint(layer), tints: at > 0 && canTint(layer) && layer.tint === "own",
    driftx: true, drifty: state.dimensions > 1, driftz: state.dimensions > 2, time: hasDrift(state),
    phase: warped && state.layers.some(turns), z: state.dimensions > 2, w: state.dimensions > 3, lean: canLean(state),
  };
}

// The factor and the summand of the values of a layer, before the layer is combined. The weight of a
// mixture is another thing.
export function remapOf({ layers }, at) {
  const { weight, offset, soft, blend } = layers[at];
  const plain = layers.length === 1 || (at > 0 && (["mix", "height", "slope"].includes(blend) || (blend === "mask" && soft)));
  return plain ? { weight: 1, offset: 0 } : { weight, offset };
}

// ---------------------------------------------------------------------------------------------------------------------
// Where a layer counts: not at all up to a value, "from", and whole from there "soft" higher on, or lower if that is below 0.

const canEase = ({ blend }) => ["mask", "height", "slope"].includes(blend);

// These of a layer; those with a weight and an offset mean the same by other numbers.
export function easeOf({ weight, offset, from, soft }) {
  if (soft) return { from, soft };
  return weight ? { from: -offset / weight, soft: 1 / weight } : { from: offset > 0 ? -8 : 8, soft: kLeastSoft };
}

// For a layer whose values, or those below it, nobody has seen yet: about a third of what may be there.
export function easeBelow(state, at) {
  const { blend } = state.layers[at];
  const layers = blend === "mask" ? [state.layers[at]] : state.layers.slice(0, at).map((layer) => ({ ...layer, on: 1 }));
  const [low, high] = rangeOf({ ...state, layers, contrast: 1 });
  const [least, span] = blend === "slope" ? [0, 3 * (high - low)] : [low, high - low];
  return { from: least + 0.5 * span, soft: 0.2 * span };
}

// The same from numbers: the highest third counts, and a quarter of how far they usually go is its edge.
export function easeAround(values) {
  const sorted = values.toSorted();
  const at = (part) => sorted[Math.floor(part * (sorted.length - 1))];
  const soft = Math.max((at(0.9) - at(0.1)) / 4, kLeastSoft);
  return { from: at(2 / 3) - soft / 2, soft };
}

// The picture of how much a layer counts; or, if that is wanted, of the values that decide it: where it is p, the value is
// 16 p - 8. Nothing for a layer without such values.
export function maskState(state, at, ofValues) {
  if (!state.layers[at]?.on || !uses(state, at).ease) return undefined;
  const layers = state.layers.slice(0, at + 1).map((layer, k) => ({ ...layer, tint: k === at ? "grey" : "none" }));
  if (ofValues) {
    Object.assign(layers[at], { from: -8, soft: 16 });
    if (layers[at - 1].blend === "mask") layers[at - 1].on = 0;
  }
  if (shownLayers({ layers }).length === 1) return undefined;
  return { ...state, layers, contrast: 1, masks: true, view: state.view === "terrain" ? "plane" : state.view };
}

// ---------------------------------------------------------------------------------------------------------------------
// The list of layers.

// The state with one more above.
export function withLayer(state) {
  const seed = (state.layers.at(-1).seed + 10) % 4294967296; // next to a seed is that of a warp
  return possible({ ...state, layers: [...state.layers, { ...usualLayer(), seed }] });
}

export const withoutLayer = (state, at) =>
  possible({ ...state, layers: state.layers.filter((_, number) => number !== at) });

// The state with this layer at another place in the list.
export function withMoved(state, from, to) {
  const layers = [...state.layers];
  layers.splice(to, 0, ...layers.splice(from, 1));
  return possible({ ...state, layers });
}

// ---------------------------------------------------------------------------------------------------------------------
// The range.

// The values of a layer that colours would span.
function rangeOfLayer(layer, dimensions) {
  const at = dimensions - 1;
  const noise = kNoises[layer.noise];
  const sum = kSums[layer.sum];
  if (layer.sum === "none") return noise.span ? [-noise.span[at], noise.span[at]] : (noise.range ?? [-1, 1]);
  // Noises other than Perlin's have more contrast or less.
  const ratio = Math.min((noise.span?.[at] ?? 0.8) / kNoises.perlin.span[at], 1.6);
  let [low, high] = sum.span
    ? [-sum.span[at] * ratio, sum.span[at] * ratio]
    : (sum.ranges?.[at] ?? sum.range ?? [-1, 1]);
  if (layer.sum === "turbulence") high *= ratio;
  if (layer.sum === "billow") high = Math.min(low + (high - low) * ratio, 1);
  return [low, high];
}

// For two layers that do not depend on each other: ends are seldom met together, so their distances from the middles
// add as those of deviations do.
function sumOfRanges([low, high], [lower, higher]) {
  const middle = (low + high + lower + higher) / 2;
  const half = Math.hypot(high - low, higher - lower) / 2;
  return [middle - half, middle + half];
}
const times = (range, factor) => range.map((end) => end * factor).sort((one, other) => one - other);
const kRanges = {
  add: sumOfRanges,
  multiply: (range, other) => {
    const products = range.flatMap((end) => other.map((end2) => end * end2));
    return [Math.min(...products), Math.max(...products)];
  },
  min: ([low, high], [lower, higher]) => [Math.min(low, lower), Math.min(high, higher)],
  max: ([low, high], [lower, higher]) => [Math.max(low, lower), Math.max(high, higher)],
};

// The values that the lowest and the highest colour stand for.
export function rangeOf(state) {
  if (state.masks) return [0, 1];
  const found = state.layers.flatMap((layer, at) => {
    if (!layer.on) return [];
    const { weight, offset } = remapOf(state, at);
    const range = times(rangeOfLayer(layer, state.dimensions), weight).map((end) => end + offset);
    return [{ layer, range }];
  });
  let masked = false;
  const [low, high] = found.slice(1).reduce((below, { layer: { blend, weight }, range }) => {
    if (blend === "mask") {
      masked = true;
      return below;
    }
    const both = ([one, other], [lower, higher]) => [Math.min(one, lower), Math.max(other, higher)];
    const next =
      blend === "mix"
        ? sumOfRanges(times(below, 1 - weight), times(range, weight))
        : blend === "height" || blend === "slope"
          ? both(below, range)
          : kRanges[blend](below, range);
    const made = masked ? both(below, next) : next;
    masked = false;
    return made;
  }, found[0].range);
  const middle = (low + high) / 2;
  const half = Math.max(high - low, 0.001) / 2 / state.contrast;
  return [middle - half, middle + half];
}
