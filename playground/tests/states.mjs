// The states whose functions tools/pick has written for the page, each once.
import { changed, dimensionsOfLayer, possible, uses, usualState } from "../model.js";
import { kArithmetics, kNoises, kSums } from "../tables.js";

const kForms = [{}, { phase: 0.25 }, { jitter: 0.5 }, { metric: "hybrid" }];

// Of one noise, or of a sum over Perlin noise, near, without a tile and without a warp.
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
