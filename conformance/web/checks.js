// The checks of the cases. As in case.hpp: an outcome is a status, counts, the largest differences, a message and the
// first wrong values.
import { DriverError } from "./renderer.js";
import { crc32, digestInputs, fnv1a64, hex, kInputWords, kOutputWords } from "./suite.js";

export const kStatuses = ["pass", "warning", "fail", "unsupported", "crash", "timeout", "error"];
export const kBadStatuses = ["fail", "crash", "timeout", "error"];

// The most failures that a case lists; further ones add nothing.
const kMostExamples = 8;

const kScratch = new DataView(new ArrayBuffer(4));

function floatOf(bits) {
  kScratch.setUint32(0, bits);
  return kScratch.getFloat32(0);
}

function bitsOf(value) {
  kScratch.setFloat32(0, value);
  return kScratch.getUint32(0);
}

// Maps floats to integers in their order, with -0 and 0 together.
function ordinal(value) {
  const bits = bitsOf(value);
  return bits >>> 31 ? -(bits & 0x7fffffff) : bits;
}

function ulpDistance(a, b) {
  if (Number.isNaN(a) || Number.isNaN(b)) return Number.isNaN(a) && Number.isNaN(b) ? 0 : 0xffffffff;
  return Math.abs(ordinal(a) - ordinal(b));
}

// As many digits as distinguish any two floats.
function describeFloat(value) {
  return `${Number.isFinite(value) ? Number(value.toPrecision(9)) : value} (${hex(bitsOf(value))})`;
}

// Three digits, as {:.3g} of fmt writes them: "0.389", "3.51e-06".
function shortNumber(value) {
  const [digits, exponent] = value.toExponential(2).split("e").map(Number);
  if (value === 0 || (exponent >= -4 && exponent < 3)) return String(Number(value.toPrecision(3)));
  return `${digits}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
}

// Such a word counts as a whole, even of a function whose floats may be off.
const isWhole = (type) => type === "i32" || type === "u32";

function describeWord(word, type) {
  // f64: the value of a golden file, which a shader has as a float.
  if (type === "f32" || type === "f64") return describeFloat(floatOf(word));
  return `${type === "i32" ? word | 0 : word} (0x${hex(word)})`;
}

function describeInputs(columns, words) {
  return columns.map(({ name, type }, i) => `${name}=${describeWord(words[i], type)}`).join(" ");
}

export function outcomeWith(status, message) {
  return { status, samples: 0, mismatches: 0, max_abs: 0, max_ulp: 0, message, examples: [] };
}

const kMostUlpsTold = 1000;

// As in verdict.hpp.
export function measureOf({ samples, mismatches, max_abs, max_ulp, allowed }) {
  const wrong = `${mismatches} of ${samples} values are wrong`;
  if (max_abs === 0) return wrong;
  if (max_abs === Number.MAX_VALUE) return `${wrong}, some of them infinite or not a number`;
  if (allowed === undefined || allowed >= max_abs) return wrong;
  const off = `${wrong}; the largest difference is ${shortNumber(max_abs)}`;
  if (allowed > 0) return `${off}, and ${shortNumber(allowed)} is allowed`;
  const few = max_ulp !== 0 && max_ulp <= kMostUlpsTold;
  const units = few ? ` (${max_ulp} ${max_ulp === 1 ? "unit" : "units"} in the last place)` : "";
  return `${off}${units}, and none is allowed`;
}

class Comparison {
  constructor(columns, inputs) {
    this.columns = columns;
    this.inputs = inputs;
    this.outcome = outcomeWith("pass", "");
  }

  // Every bit counts.
  bits(point, got, expected, type) {
    ++this.outcome.samples;
    if (got === expected) return;
    if (type === "f32" || type === "f64") this.noteDifference(floatOf(got), floatOf(expected), 0);
    this.note(point, describeWord(got, type), describeWord(expected, type));
  }

  // |got - expected| <= allowed. NaN is never right.
  number(point, got, expected, allowed) {
    ++this.outcome.samples;
    this.noteDifference(got, expected, allowed);
    if (Math.abs(got - expected) <= allowed) return;
    // Nothing is near an infinity or NaN.
    const within = Number.isFinite(expected) ? ` within ${shortNumber(allowed)}` : "";
    this.note(point, describeFloat(got), `${describeFloat(expected)}${within}`);
  }

  noteDifference(got, expected, allowed) {
    const outcome = this.outcome;
    const difference = Math.abs(got - expected);
    outcome.max_ulp = Math.max(outcome.max_ulp, ulpDistance(got, Math.fround(expected)));
    // Written so that a NaN is noted. JSON has none; infinity is recorded as the largest double.
    if (difference <= outcome.max_abs) return;
    outcome.max_abs = Number.isFinite(difference) ? difference : Number.MAX_VALUE;
    outcome.allowed = Math.min(allowed, Number.MAX_VALUE);
  }

  note(point, got, expected) {
    const outcome = this.outcome;
    outcome.status = "fail";
    if (outcome.mismatches++ >= kMostExamples) return;
    const words = [...this.inputs.subarray(point * kInputWords, (point + 1) * kInputWords)];
    const inputs = describeInputs(this.columns, words);
    if (!outcome.examples.length) outcome.message = `first at ${inputs}: got ${got}, expected ${expected}`;
    outcome.examples.push({ point, words, inputs, got, expected });
  }

  finish() {
    return this.outcome.samples ? this.outcome : outcomeWith("error", "nothing was compared");
  }
}

function checkCompiles(renderer, suite, test) {
  renderer.gl.deleteProgram(renderer.build(suite.program(test.program)).id);
  return outcomeWith("pass", "");
}

function checkRefused(renderer, suite, test) {
  try {
    renderer.gl.deleteShader(renderer.compile("fragment", suite.shader(test.fragment)));
  } catch (error) {
    if (!(error instanceof DriverError)) throw error;
    if (error.log.includes(test.names)) return outcomeWith("pass", "");
    return outcomeWith(test.too_old ? "unsupported" : "fail",
                       `the shader is refused, but no message names ${test.names}\n${error.log}`);
  }
  return outcomeWith("fail", `it compiles, but an error should name ${test.names}`);
}

// kOutputWords per point.
async function evaluate(renderer, suite, number, inputs) {
  const program = await renderer.kept(number, () => suite.program(number));
  return renderer.evaluate(program, inputs, suite.uniforms);
}

async function checkDigest(renderer, suite, test, outcome) {
  const { digest } = test;
  const inputs = digestInputs(digest);
  const outputs = await evaluate(renderer, suite, test.program, inputs);
  const values = new Uint32Array(inputs.length / kInputWords);
  for (let i = 0; i < values.length; ++i) values[i] = outputs[i * kOutputWords];
  outcome.samples += values.length;
  const got = fnv1a64(values);
  if (got === digest.fnv1a64) return outcome;
  ++outcome.mismatches;
  outcome.status = "fail";
  outcome.message = `the digest of ${values.length} points from ` +
                    `${describeInputs(suite.columns(test.columns).inputs, inputs)} is ${got}, expected ${digest.fnv1a64}`;
  return outcome;
}

const areNaN = (a, b) => Number.isNaN(floatOf(a)) && Number.isNaN(floatOf(b));

function distanceOf(got, expected, type) {
  const [a, b] = [floatOf(got), floatOf(expected)];
  if (isWhole(type) || !Number.isFinite(a) || !Number.isFinite(b)) return "";
  const units = ulpDistance(a, b);
  return `, ${units} ${units === 1 ? "unit" : "units"} in the last place away`;
}

// The outcome of somebody's own function, in the words of judge_bug in cases/bugs/bugs.cpp.
function givenOutcome(outcome, test, columns, inputs, wrongPoints, nanPoints) {
  const points = `of ${inputs.length / kInputWords} points`;
  if (outcome.status === "fail") {
    const [{ inputs: at, got, expected }] = outcome.examples;
    outcome.message = `differs first at ${at}: got ${got}, expected ${expected}, and at ${wrongPoints.size} ${points}. ` +
                      test.note;
  } else if (nanPoints.size) {
    const [first] = nanPoints;
    const at = describeInputs(columns.inputs, inputs.subarray(first * kInputWords));
    outcome.status = "warning";
    outcome.message = `NaN, as expected, at ${nanPoints.size} ${points}, first at ${at}. GLSL leaves NaN open: a driver ` +
                      `may return a number there. ${test.note}`;
  }
  return outcome;
}

// Against expected values: words if every bit counts or a bug is looked for, else exact values as 64-bit floats. A wrong
// value that a specification leaves open is a warning. For somebody's own function (given) equal bits are equal, and
// so are any two NaN.
async function checkValues(renderer, suite, test) {
  const isBug = test.check === "bug";
  const columns = suite.columns(test.columns);
  const inputs = suite.inputs(columns, test.inputs);
  const outputs = await evaluate(renderer, suite, test.program, inputs);
  const comparison = new Comparison(columns.inputs, inputs);
  const width = columns.outputs.length;
  const expected = test.exact || isBug ? suite.words(test.expected) : suite.doubles(test.expected);
  const allowed = suite.allowed(test);
  const words = new Uint32Array(expected.length);
  const wrongPoints = new Set();
  const nanPoints = new Set();
  for (let i = 0; i < expected.length; ++i) {
    const point = Math.floor(i / width);
    const got = outputs[point * kOutputWords + (i % width)];
    words[i] = got;
    const { type } = columns.outputs[i % width];
    const before = comparison.outcome.mismatches;
    if (test.exact || isWhole(type)) {
      comparison.bits(point, got, expected[i] >>> 0, type);
    } else if (test.given && (got === expected[i] || areNaN(got, expected[i]))) {
      ++comparison.outcome.samples;
      if (areNaN(got, expected[i])) nanPoints.add(point);
    } else {
      comparison.number(point, floatOf(got), isBug ? floatOf(expected[i]) : expected[i], allowed(i));
    }
    if (comparison.outcome.mismatches === before) continue;
    wrongPoints.add(point);
    if (test.given && before < kMostExamples) {
      comparison.outcome.examples.at(-1).expected += distanceOf(got, expected[i], type);
    }
  }
  const outcome = comparison.finish();
  if (test.exact) outcome.checksum = hex(crc32(words));
  if (test.given) return givenOutcome(outcome, test, columns, inputs, wrongPoints, nanPoints);
  if (isBug && outcome.status === "fail") {
    outcome.status = test.defined ? "fail" : "warning";
    outcome.message = `${test.defined ? "wrong" : "not the usual value, but allowed"}: ${outcome.message}. ${test.note}`;
  }
  return test.digest && outcome.status === "pass" ? checkDigest(renderer, suite, test, outcome) : outcome;
}

// Against what the same driver finds in another way, or at other inputs. In a loop, each word of the result is of
// another point: the one at hand, then its neighbours.
async function checkSame(renderer, suite, test) {
  const columns = suite.columns(test.columns);
  const inputs = suite.inputs(columns, test.inputs);
  const others = suite.columns(test.other_columns);
  const expected = await evaluate(renderer, suite, test.other, suite.inputs(others, test.other_inputs));
  const outputs = await evaluate(renderer, suite, test.program, inputs);
  const comparison = new Comparison(columns.inputs, inputs);
  const allowed = suite.allowed(test);
  const width = test.words;
  const compare = (point, word, got, wanted) => {
    const { type } = columns.outputs[word];
    const within = allowed(point * width + word);
    // Negative where a value jumps so near that two ways of rounding need not agree.
    if (!test.exact && within < 0) return;
    if (test.exact || isWhole(type)) comparison.bits(point, got, wanted, type);
    else comparison.number(point, floatOf(got), test.factor * floatOf(wanted), within);
  };
  for (let point = 0; point * kInputWords < inputs.length; ++point) {
    for (let word = 0; word < (test.in_loop ? kOutputWords : width); ++word) {
      const got = outputs[point * kOutputWords + word];
      const other = (test.in_loop ? point ^ word : point) * kOutputWords;
      const [x, y, z, w] = expected.subarray(other, other + kOutputWords);
      if (test.in_loop) compare(point ^ word, 0, got, (x ^ y ^ z ^ w) >>> 0);
      else compare(point, word, got, expected[other + word]);
    }
  }
  return comparison.finish();
}

const kChecks = {
  compiles: checkCompiles, refused: checkRefused, values: checkValues, same: checkSame, bug: checkValues,
};

// The outcome of a case; whatever happens in it becomes one.
export async function runCase(renderer, suite, test) {
  if (test.decided) return outcomeWith(test.decided.status, test.decided.message);
  try {
    const check = kChecks[test.check];
    if (!check) return outcomeWith("error", `the page knows no check "${test.check}"`);
    return await check(renderer, suite, test);
  } catch (error) {
    return outcomeWith(error instanceof DriverError ? "fail" : "error", error.message);
  }
}
