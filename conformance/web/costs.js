// What functions cost, compared with each other on this device: times alone say more of the browser than of them.

// A browser's clock may have steps of a millisecond, and a draw that takes long is ended as if it hung.
const kLeastMilliseconds = 10;
const kMostRounds = 1 << 14;
const kSamples = 3;
const kUnit = "noise2d.perlin.fast";
const kEmpty = "empty";
// Twice the work takes twice the time, or the clock measures something else.
const kLeastOfTwice = 1.5;
const kMostOfTwice = 2.7;

function median(values) {
  return [...values].sort((a, b) => a - b)[values.length >> 1];
}

// {name: percent of what Perlin noise costs with floats}; null where it cannot be measured. timed: [{name, program}] of
// the suite. breathe lets the browser do other things between samples.
export async function measureCosts(renderer, suite, breathe) {
  const programs = new Map(suite.timed.map(({ name, program }) => [name, renderer.build(suite.program(program))]));
  if (!programs.has(kUnit) || !programs.has(kEmpty)) return null;
  const milliseconds = (name, rounds) => renderer.time(programs.get(name), { rounds: { type: "int", value: rounds } });
  for (const name of programs.keys()) milliseconds(name, 1);  // drivers compile at the first draw
  const own = (name, rounds) => milliseconds(name, rounds) - milliseconds(kEmpty, rounds);
  let rounds = 1;
  while (rounds < kMostRounds && own(kUnit, rounds) < kLeastMilliseconds) rounds *= 2;
  const samples = new Map([...programs.keys()].map((name) => [name, []]));
  const twice = [];
  for (let sample = 0; sample < kSamples; ++sample) {
    for (const [name, list] of samples) {
      list.push(milliseconds(name, rounds));
      await breathe();
    }
    twice.push(own(kUnit, 2 * rounds));
  }
  for (const { id } of programs.values()) renderer.gl.deleteProgram(id);
  const cost = (name) => median(samples.get(name)) - median(samples.get(kEmpty));
  const unit = cost(kUnit);
  const grows = median(twice) / unit;
  if (renderer.isLost() || !(unit > 0) || grows < kLeastOfTwice || grows > kMostOfTwice) return null;
  const percents = [...programs.keys()].filter((name) => name !== kEmpty)
                     .map((name) => [name, Math.round((100 * cost(name)) / unit)]);
  return Object.fromEntries(percents.filter(([, percent]) => percent >= 1 && percent <= 1e6));
}
