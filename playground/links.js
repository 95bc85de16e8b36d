// Links, which carry the whole state, and the looks to begin with.

import {
  changed, goingWith, kMostLayers, kSettings, possible, settingsOf, usualLayer, usualOf, usualState, uses,
} from "./model.js";
import { isLastPosition, parsedNumber, parsedPosition, positionText } from "./numbers.js";
import { kSums } from "./tables.js";

// The first layer has plain names, and the second has "sum2" and so on.
const nameIn = (name, at) => `${name}${at ? at + 1 : ""}`;

// "#noise=simplex&cells=16": what differs from the usual, in one order, so that equal states have equal links. How a
// layer above the first is combined is always there, so that there is the layer.
export function linkOf(state) {
  const parts = state.layers.flatMap((layer, at) => {
    const used = uses(state, at);
    return Object.entries(kSettings).flatMap(([name, setting]) => {
      const value = setting.layer ? layer[name] : state[name];
      const here = used[name] && (setting.layer || at === 0);
      if (!here || (value === usualOf(name, layer) && name !== "blend")) return [];
      return [`${nameIn(name, at)}=${typeof value === "bigint" ? positionText(value) : value}`];
    });
  });
  return parts.length ? `#${parts.join("&")}` : "";
}

// The value of a setting that somebody wrote. Nothing for a text that should be a number and is none.
export function parsed(name, text) {
  const setting = kSettings[name];
  if (typeof setting.usual === "string") return text;
  return typeof setting.usual === "bigint" ? parsedPosition(text) : parsedNumber(text);
}

// The state of a link. Unknown names and values that are none count as absent.
export function stateOf(link) {
  const given = new URLSearchParams(link.replace(/^#/, ""));
  const number = Math.max(...Array.from({ length: kMostLayers }, (_, at) => (given.has(nameIn("blend", at)) ? at : 0)));
  let state = { ...usualState(), layers: Array.from({ length: number + 1 }, usualLayer) };
  for (let at = 0; at <= number; ++at) {
    const found = Object.entries(kSettings).flatMap(([name, setting]) => {
      const text = at > 0 && !setting.layer ? null : given.get(nameIn(name, at));
      return text === null ? [] : [[name, parsed(name, text) ?? setting.usual]];
    });
    state = changed(state, Object.fromEntries(found), at);
    if (at === 0) Object.assign(state, goingWith(state, (name) => given.has(name)));
    const layer = state.layers[at];
    if (!given.has(nameIn("strength", at)) && Object.hasOwn(kSums, layer.sum))
      layer.strength = usualOf("strength", layer);
  }
  return possible(state);
}

// The parts of a link that the page does not take, as a sentence: names and values that do not exist, and numbers that became
// others. Nothing for a link that is right.
export function ignoredIn(link) {
  const state = stateOf(link);
  const absent = [];
  const others = [];
  for (const [key, text] of new URLSearchParams(link.replace(/^#/, ""))) {
    const [, name, number] = /^([a-z]+)([2-9]?)$/.exec(key) ?? [];
    const at = number ? number - 1 : 0;
    const isKnown = Object.hasOwn(kSettings, name) && at < state.layers.length && (at ? kSettings[name].layer : name !== "blend");
    const [given, value] = isKnown ? [parsed(name, text), settingsOf(state, at)[name]] : [];
    const shown = typeof value === "bigint" ? positionText(value) : String(value);
    if (given === undefined || (typeof given === "string" && given.toLowerCase() !== value)) absent.push(`${key}=${text}`);
    else if (isLastPosition(value) && text !== shown)
      others.push(`${key}=${text} became ${shown}`);
    else if (given !== value && !(typeof given === "number" && Math.abs(given - value) <= 1e-4 * Math.abs(given)))
      others.push(`${key}=${text} became ${shown}`);
  }
  const list = (words) => words.map((one) => one.slice(0, 60)).join(", ");
  return [
    ...(absent.length ? [`The link has what this page does not know: ${list(absent)}.`] : []),
    ...(others.length ? [`${list(others)}.`] : []),
  ].join(" ");
}

// Looks to begin with. `layers` are those above the first.
export const kLooks = {
  Marble: {
    sum: "turbulence", octaves: 6, gain: 0.35, warp: "warp", amplitude: 0.7, cells: 4, seed: 8, map: "own",
    stops: "0-23252e_8-5d606b_22-b4b5ba_50-e3e2e0_100-fbfaf8",
  },
  Wood: {
    sum: "ping_pong", noise: "value_cubic", octaves: 2, gain: 0.12, strength: 8, warp: "warp", amplitude: 0.5, cells: 4, seed: 6, map: "own",
    stops: "0-7a4522_30-a4682f_70-c68e52_100-dfb57c",
    layers: [{ blend: "add", octaves: 4, gain: 0.8, weight: 0.5, scale: 32, seed: 5 }],
  },
  Moss: {
    octaves: 5, gain: 0.8, scale: 4, cells: 5, map: "own",
    stops: "0-2b2a2c_40-4d4a4a_70-7a7673_90-a5a09a_100-cfcac2",
    layers: [
      { blend: "max", sum: "ridged", gain: 0.6, weight: 3, offset: -2.1, seed: 8 },
      { blend: "mask", sum: "fbm", seed: 18, from: -0.1, soft: 0.08 },
      {
        blend: "mix", octaves: 5, gain: 0.7, scale: 8, weight: 0.9, seed: 4, tint: "own",
        tints: "0-16260a_30-35541a_55-6a9430_80-a9c64f_100-e2ec9a",
      },
    ],
  },
  Island: {
    sum: "fbm", octaves: 9, seed: 21, map: "land", cells: 8, view: "terrain", sea: 0.4, steep: 0.3, tilt: 0.09,
    layers: [{ blend: "add", sum: "none", noise: "middle", radius: 3 }],
  },
  Planet: {
    octaves: 8, gain: 0.55, dimensions: 3, view: "sphere", tilt: 0.06, cells: 3.4, z: 0, seed: 11, map: "own",
    stops: "0-051238_44-0f4766_44-33592a_60-6e7a4a_72-9e876b_86-9e876b_90-f5f8ff_100-ffffff",
    layers: [
      { blend: "add", sum: "ridged", octaves: 7, weight: 0.5, offset: -0.32, seed: 3 },
      { blend: "max", sum: "clouds", octaves: 7, gain: 0.55, weight: 1.2, offset: -0.3, scale: 2, seed: 5, driftx: 0.05, driftz: 0.02 },
    ],
  },
  Hills: { sum: "fbm", octaves: 8, map: "land", cells: 5, seed: 21 },
  Dusk: {},
  Ridges: { sum: "ridged", octaves: 8, map: "grey", cells: 3, seed: 3 },
  Ink: { sum: "fbm", warp: "warp_progressive", map: "lagoon", cells: 5, octaves: 7 },
  Sky: { sum: "clouds", dimensions: 3, map: "sky", cells: 6, octaves: 8, driftx: 0.3, driftz: 0.05 },
  Agate: { sum: "ping_pong", octaves: 4, gain: 0.4, strength: 3, warp: "warp", amplitude: 1, map: "wood", cells: 3 },
  Stones: { sum: "none", noise: "cellular_between", map: "moss", cells: 9 },
  Cracks: { sum: "none", noise: "cell_border", map: "ember", cells: 7, warp: "warp", amplitude: 0.6 },
  Mosaic: { sum: "none", noise: "cells", jitter: 0.7, metric: "manhattan", map: "lagoon", cells: 8 },
  Scales: { sum: "none", noise: "cellular_third", jitter: 0.35, metric: "chebyshev", map: "wood", cells: 8 },
  Slopes: { sum: "eroded", octaves: 9, map: "marble", cells: 4, strength: 4 },
  Tiles: { sum: "fbm", period: 3, map: "signed", cells: 9, seed: 4 },
  Foam: { sum: "fbm", noise: "cellular", octaves: 4, map: "lagoon", cells: 7 },
  Peaks: {
    sum: "ridged", octaves: 8, map: "land", cells: 4, seed: 12,
    layers: [
      { blend: "multiply", sum: "none", weight: 0.8, offset: 0.5, seed: 5 },
      { blend: "add", noise: "simplex", weight: 0.3, scale: 4, seed: 8 },
    ],
  },
  Mud: {
    sum: "none", noise: "cell_border", map: "wood", cells: 6, contrast: 1.2, warp: "warp", amplitude: 0.3,
    layers: [
      { blend: "min", sum: "none", noise: "cell_border", scale: 4, weight: 0.8, offset: 0.1, seed: 4 },
      { blend: "add", sum: "billow", weight: 0.08, scale: 8, seed: 9 },
    ],
  },
  Caustics: {
    sum: "none", noise: "cellular", dimensions: 3, cells: 5, z: 0, warp: "warp", amplitude: 0.5, map: "own",
    stops: "0-08455f_30-1b6f82_70-8fdcd2_100-d9fbf2",
    layers: [
      { blend: "multiply", sum: "none", noise: "cellular", warp: "warp", amplitude: 0.5 },
      { blend: "add", sum: "none", noise: "cellular", warp: "warp", amplitude: 0.5, scale: 2, weight: 0.3, seed: 8 },
    ],
  },
  Granite: {
    octaves: 5, gain: 0.8, scale: 4, cells: 5, map: "own",
    stops: "0-54221d_38-6b3128_56-9a5f50_84-b87a66_90-e6d2c2_100-f4ebe0",
    layers: [{ blend: "max", sum: "ridged", gain: 0.6, weight: 3, offset: -2.1, seed: 8 }],
  },
  "Far out": {
    sum: "fbm", noise: "simplex", map: "dusk", cells: 4, x: 1000000000n * 16777216n, y: -2000000000n * 16777216n,
  },
};

export function stateOfLook(name, { arithmetic, file, width, height, frames }) {
  const { layers = [], ...look } = kLooks[name];
  let state = { ...usualState(), arithmetic, file, width, height, frames };
  state.layers.push(...layers.map(usualLayer));
  for (const [at, changes] of [look, ...layers].entries()) {
    state = changed(state, changes, at);
    if (changes.strength === undefined) state.layers[at].strength = usualOf("strength", state.layers[at]);
  }
  return possible(state);
}

// The look that a state shows, wherever, from whichever side and with whichever seeds; nothing if it is none.
const kOfNoLook = ["arithmetic", "file", "width", "height", "frames", "x", "y", "z", "w", "cells", "time", "phase", "turn", "tilt"];
const keyOfLook = (state) => {
  const usual = usualState();
  const other = Object.fromEntries(kOfNoLook.map((name) => [name, usual[name]]));
  return linkOf({ ...state, ...other, layers: state.layers.map((layer) => ({ ...layer, seed: usual.layers[0].seed })) });
};
let looks;
export function lookOf(state) {
  looks ??= new Map(Object.keys(kLooks).map((name) => [keyOfLook(stateOfLook(name, usualState())), name]));
  return looks.get(keyOfLook(state));
}

// The page opens with it, without a link.
export const firstState = () => stateOfLook("Island", usualState());
