// What the shown noise costs on this GPU, as a ratio to hn_perlin on the plane. Both are drawn in turns, so that what
// else the machine does concerns both; what a shader costs that computes nothing is taken off both.
import { emptyShader, frameOf, kColours, kPlain, timedShader } from "./shaders.js";

const kRounds = 12;
const kFewRounds = 3; // of what is so slow that more would take too long
const kLongest = 2500; // milliseconds
const kEnough = 8; // milliseconds that the plain noise should take, since browsers make their clocks coarse
const kMostSide = 2048;
const kMostDraws = 64;

// Of rounds, each [empty, plain, shown] in milliseconds. What else the machine does only adds, so the least counts.
function ratioOf(rounds) {
  const [empty, plain, shown] = [0, 1, 2].map((number) => Math.min(...rounds.map((round) => round[number])));
  return plain > empty ? Math.max(shown - empty, 0) / (plain - empty) : NaN;
}

// {ratio, low, high}: of all rounds, and between which the ratios of three parts of them lie.
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
    const least = async (number) => Math.min(await measured(number), await measured(number));
    while ((await least(1)) - (await least(0)) < kEnough && (side < kMostSide || draws < kMostDraws)) {
      if (side < kMostSide) side *= 2;
      else draws *= 2;
    }
    const rounds = [];
    const end = performance.now() + kLongest;
    while (rounds.length < kFewRounds || (rounds.length < kRounds && performance.now() < end)) {
      rounds.push([await measured(0), await measured(1), await measured(2)]);
      await new Promise((resolve) => setTimeout(resolve)); // let the page react in between
    }
    const ratio = ratioOf(rounds);
    if (!Number.isFinite(ratio)) throw new Error("The clock of this browser is too coarse to tell.");
    const parts = [0, 1, 2].map((part) => ratioOf(rounds.filter((_, number) => number % 3 === part)));
    const known = parts.filter(Number.isFinite);
    return { ratio, low: Math.min(ratio, ...known), high: Math.max(ratio, ...known) };
  } finally {
    programs.forEach((program) => backend.discard(program));
  }
}
