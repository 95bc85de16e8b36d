// The costs of the copied functions on this GPU, pattern(p) and pattern(cell, f), as ratios to hn_perlin(p) on the
// plane. All are drawn in turns, so that what else the machine does concerns all; what a shader costs that computes
// nothing is taken off all.
import { emptyShader, frameOf, kColours, kTimes, plainOf, timedShader } from "./shaders.js";

const kRounds = 12;
const kFewRounds = 3; // of what is so slow that more would take too long
const kLongest = 2500; // milliseconds
const kEnough = 8; // milliseconds that the plain noise should take, since browsers make their clocks coarse
const kMostSide = 2048;
const kMostDraws = 64;

// The ratios of rounds, each a list of milliseconds: of the empty shader, of hn_perlin, of the picture at a position
// and from a cell. Other work of the machine only adds time, so the least counts.
function ratiosOf(rounds) {
  const [empty, plain, ...shown] = rounds[0].map((_, number) => Math.min(...rounds.map((round) => round[number])));
  return shown.map((least) => (plain > empty ? Math.max(least - empty, 0) / (plain - empty) : NaN));
}

// {ratio, low, high, cell, million}: at a position, of all rounds and between which the ratios of three parts of them
// lie; from a cell; and milliseconds of a million values at a position.
export async function costOf(gpu, library, state) {
  // Far out, where floats have no fractions, a position would be the same for all pixels.
  const shown = { ...state, x: 0n, y: 0n };
  const plain = plainOf(shown);
  const states = [plain, plain, shown, shown];
  const texts = [
    emptyShader(library, plain),
    timedShader(library, plain, "position"),
    timedShader(library, shown, "position"),
    timedShader(library, shown, "cell"),
  ];
  const programs = [];
  try {
    for (const text of texts) programs.push(await gpu.build(text));
    let side = 256;
    let draws = 1;
    const measured = (number) =>
      gpu.time(programs[number], frameOf(states[number], side, side, kColours), side, draws);
    for (const number of states.keys()) await measured(number); // some drivers compile at the first draw
    const least = async (number) => Math.min(await measured(number), await measured(number));
    while ((await least(1)) - (await least(0)) < kEnough && (side < kMostSide || draws < kMostDraws)) {
      if (side < kMostSide) side *= 2;
      else draws *= 2;
    }
    const rounds = [];
    const end = performance.now() + kLongest;
    while (rounds.length < kFewRounds || (rounds.length < kRounds && performance.now() < end)) {
      const round = [];
      for (const number of states.keys()) round.push(await measured(number));
      rounds.push(round);
      await new Promise((resolve) => setTimeout(resolve)); // let the page react in between
    }
    const [ratio, cell] = ratiosOf(rounds);
    if (!Number.isFinite(ratio)) throw new Error("The clock of this browser is too coarse to measure it.");
    const parts = [0, 1, 2].map((part) => ratiosOf(rounds.filter((_, number) => number % 3 === part))[0]);
    const known = parts.filter(Number.isFinite);
    const [empty, , position] = states.map((_, number) => Math.min(...rounds.map((round) => round[number])));
    const million = ((position - empty) * 1e6) / (side * side * draws * kTimes);
    return { ratio, low: Math.min(ratio, ...known), high: Math.max(ratio, ...known), cell, million };
  } finally {
    programs.forEach((program) => gpu.discard(program));
  }
}
