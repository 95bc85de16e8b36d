// The costs of functions, compared with each other on this device: times alone depend more on the browser than on the
// functions.

// A draw takes as long as this: a browser's clock may have steps of a millisecond, and what takes long is ended as if
// it hung.
const kLeastMilliseconds = 10;
const kMostRounds = 1 << 14;
const kSamples = 7;
const kUnit = "noise2d.perlin.fast";
const kEmpty = "empty";
// One evaluation costs the same among twice as many, or the clock measures something else.
const kLeastOfTwice = 0.75;
const kMostOfTwice = 1.35;

// {name: percent of what Perlin noise costs with floats}; null where it cannot be measured. timed: [{name, program}] of
// the suite. breathe lets the browser do other things between samples.
export async function measureCosts(renderer, suite, breathe) {
  const programs = new Map(suite.timed.map(({ name, program }) => [name, renderer.build(suite.program(program))]));
  if (!programs.has(kUnit) || !programs.has(kEmpty)) return null;
  const milliseconds = (name, rounds) => renderer.time(programs.get(name), { rounds: { type: "int", value: rounds } });
  for (const name of programs.keys()) milliseconds(name, 1);  // drivers compile at the first draw
  // As many evaluations a pixel as a draw of that length has.
  const rounds = new Map();
  for (const name of programs.keys()) {
    let count = 1;
    while (name !== kEmpty && count < kMostRounds && milliseconds(name, count) < kLeastMilliseconds) count *= 2;
    rounds.set(name, count);
  }
  // Whatever else the device does makes a draw take longer, never less long: so the least of several times counts.
  const least = new Map();
  const draw = (name, count) => {
    const key = `${name} ${count}`;
    least.set(key, Math.min(least.get(key) ?? Infinity, milliseconds(name, count)));
  };
  const draws = [...rounds, [kUnit, 2 * rounds.get(kUnit)]];
  for (let sample = 0; sample < kSamples; ++sample) {
    for (const [name, count] of draws) {
      draw(name, count);
      draw(kEmpty, count);
      await breathe();
    }
  }
  for (const { id } of programs.values()) renderer.gl.deleteProgram(id);
  const time = (name, count) => least.get(`${name} ${count}`);
  const cost = (name, count = rounds.get(name)) => (time(name, count) - time(kEmpty, count)) / count;
  const unit = cost(kUnit);
  const twice = cost(kUnit, 2 * rounds.get(kUnit)) / unit;
  if (renderer.isLost() || !(unit > 0) || twice < kLeastOfTwice || twice > kMostOfTwice) return null;
  const percents = [...programs.keys()].filter((name) => name !== kEmpty)
                     .map((name) => [name, Math.round((100 * cost(name)) / unit)]);
  return Object.fromEntries(percents.filter(([, percent]) => percent >= 1 && percent <= 1e6));
}
