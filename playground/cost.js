// What the shown noise costs on this GPU, as a ratio to hn_perlin on the plane. Both are drawn in turns, so that what
// else the machine does concerns both; what a shader costs that computes nothing is taken off both.
import { emptyShader, frameOf, kColours, kPlain, timedShader } from "./shaders.js";

const kRounds = 9;
const kFewRounds = 3; // of what is so slow that more would take too long
const kLongest = 2500; // milliseconds
const kEnough = 4; // milliseconds that the plain noise should take, since browsers make their clocks coarse
const kMostSide = 2048;
const kMostDraws = 64;

const median = (numbers) => numbers.toSorted((a, b) => a - b)[numbers.length >> 1];

// {ratio, low, high}: the median of the rounds, and between which half of them lie.
export async function costOf(backend, library, state) {
  const plain = { ...state, ...kPlain };
  const states = [plain, plain, state];
  const texts = [
    emptyShader(library, backend.language, plain),
    timedShader(library, backend.language, plain),
    timedShader(library, backend.language, state),
  ];
  const programs = [];
  try {
    for (const text of texts) programs.push(await backend.build(text));
    let side = 256;
    let draws = 1;
    const measured = (number) =>
      backend.time(programs[number], frameOf(states[number], side, side, kColours), side, draws);
    for (const number of [0, 1, 2]) await measured(number); // some drivers compile at the first draw
    while ((await measured(1)) - (await measured(0)) < kEnough && (side < kMostSide || draws < kMostDraws)) {
      if (side < kMostSide) side *= 2;
      else draws *= 2;
    }
    const ratios = [];
    const end = performance.now() + kLongest;
    let rounds = 0;
    for (; rounds < kFewRounds || (rounds < kRounds && performance.now() < end); ++rounds) {
      const [empty, base, cost] = [await measured(0), await measured(1), await measured(2)];
      if (base > empty) ratios.push(Math.max(cost - empty, 0) / (base - empty));
      await new Promise((resolve) => setTimeout(resolve)); // let the page react in between
    }
    if (ratios.length <= rounds / 2) throw new Error("The clock of this browser is too coarse to tell.");
    const sorted = ratios.toSorted((a, b) => a - b);
    return { ratio: median(ratios), low: sorted[sorted.length >> 2], high: sorted[(3 * sorted.length) >> 2] };
  } finally {
    programs.forEach((program) => backend.discard(program));
  }
}
