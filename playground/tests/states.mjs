// The states whose functions tools/pick has written for the page, each once.
import { changed, dimensionsOfLayer, kSettings, possible, uses, usualState } from "../model.js";
import { kArithmetics, kNoises, kSums } from "../tables.js";

const kForms = [{}, { phase: 0.25 }, { jitter: 0.5 }, { metric: "hybrid" }];

// States of one noise, or of a sum over Perlin noise, near, without a tile and without a warp.
export const simpleStates = () =>
  Object.keys(kArithmetics).flatMap((arithmetic) =>
    Object.keys(kSums).flatMap((sum) =>
      (sum === "none" ? Object.keys(kNoises) : ["perlin"]).flatMap((noise) =>
        dimensionsOfLayer({ sum, noise }).flatMap((dimensions) => {
          const state = possible(changed(usualState(), { arithmetic, sum, noise, dimensions }));
          return kForms
            .filter((form) => Object.keys(form).every((setting) => uses(state)[setting]))
            .map((form) => changed(state, form));
        }),
      ),
    ),
  );

// Numbers that are the same in every run.
export function* chance(word) {
  for (;;) {
    word = (Math.imul(word, 1664525) + 1013904223) >>> 0;
    yield word / 4294967296;
  }
}
// Makes any settings of a layer, or of the whole picture.
export const settingsBy = (next) => (ofLayer) => {
  const one = (list) => list[Math.floor(next() * list.length)];
  const found = {};
  for (const [name, setting] of Object.entries(kSettings)) {
    if (Boolean(setting.layer) !== ofLayer) continue;
    if (setting.of) found[name] = one(Object.keys(setting.of));
    else if (setting.fit) found[name] = one([setting.usual, "5-0a0b0c_5-ffffff_90-000000", "7-12"]);
    else if (typeof setting.usual === "bigint")
      found[name] = BigInt.asIntN(56, BigInt(Math.floor(next() * 2 ** 53)) * 8n);
    else found[name] = setting.from + next() * (Math.min(setting.to, 1e6) - setting.from);
  }
  return found;
};

// Layers that count by values, and distances from the middle of all kinds.
export const kSteered =
  "#sum=ridged&blend2=add&sum2=none&noise2=middle&radius2=2.7&weight2=0.6&blend3=mask&sum3=none&noise3=middle&shape3=along_x" +
  "&radius3=5&from3=-0.3&soft3=-0.5&blend4=mix&sum4=none&tint4=moss&blend5=height&sum5=none&noise5=middle&shape5=square" +
  "&scale5=2&from5=0.4&soft5=0.3&tint5=grey&blend6=slope&sum6=none&noise6=middle&shape6=along_y&from6=1.2&soft6=0.016&tint6=land";

// Pictures of up to three layers, with integers and without a solid, for compilers.
export function anyStates(count, seed = 5) {
  const from = chance(seed);
  const any = settingsBy(() => from.next().value);
  return Array.from({ length: count }, (_, at) =>
    possible({ ...any(false), view: "plane", arithmetic: "fixed", layers: Array.from({ length: 1 + (at % 3) }, () => any(true)) }),
  );
}
