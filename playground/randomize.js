// "Surprise me": any value of the unlocked settings, from ranges in which pictures are good.
import { chosen, changed, dimensionsOf, easeBelow, noisesOf, possible, uses, usualOf } from "./model.js";
import { kBlends, kMaps, kMetrics, kNoises, kSums } from "./tables.js";

const between = (random, low, high, step = 0.01) => Math.round((low + (high - low) * random()) / step) * step;
const oneOf = (random, list) => list[Math.floor(random() * list.length)];

// The settings of a layer, in an order in which later ones may depend on earlier ones.
const kOfLayer = {
  sum: (random) => oneOf(random, Object.keys(kSums)),
  noise: (random, { sum }) => oneOf(random, noisesOf(sum).filter((name) => kNoises[name].dimensions.includes(2))),
  seed: (random) => Math.floor(random() * 1000000),
  octaves: (random) => Math.round(between(random, 3, 9, 1)),
  lacunarity: (random) => between(random, 1.8, 2.4),
  gain: (random) => between(random, 0.35, 0.65),
  strength: (random, layer) => usualOf("strength", layer) * between(random, 0.5, 2),
  jitter: (random) => (random() < 0.6 ? 1 : between(random, 0.2, 1)),
  metric: (random) => oneOf(random, Object.keys(kMetrics)),
  warp: (random) => oneOf(random, ["none", "none", "warp", "warp_progressive"]),
  amplitude: (random) => between(random, 0.2, 1.6),
  blend: (random) => oneOf(random, Object.keys(kBlends)),
  weight: (random) => between(random, 0.3, 1.2),
  scale: (random) => oneOf(random, [1, 2, 4]),
};
const kOfPicture = {
  map: (random) => oneOf(random, Object.keys(kMaps).filter((name) => name !== "own")),
  contrast: (random) => between(random, 0.8, 1.4),
  cells: (random) => between(random, 3, 10, 0.5),
};
export const kLockable = [...Object.keys(kOfLayer), ...Object.keys(kOfPicture)];

// `locked` are names of settings that stay as they are; `random` gives numbers from 0 to below 1.
export function randomized(state, locked, random = Math.random) {
  let next = state;
  for (const at of state.layers.keys()) {
    for (const [name, made] of Object.entries(kOfLayer))
      if (!locked.has(name) && (at > 0 || !["blend", "weight", "scale"].includes(name)))
        next = changed(next, { [name]: made(random, next.layers[at]) }, at);
    if (!locked.has("blend") && uses(next, at).ease) next = changed(next, easeBelow(next, at), at);
  }
  for (const [name, made] of Object.entries(kOfPicture)) if (!locked.has(name)) next = changed(next, { [name]: made(random) });
  next = possible(next);
  return dimensionsOf(next).length ? chosen(next, {}) : state;
}
