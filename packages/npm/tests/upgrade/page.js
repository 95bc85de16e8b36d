// Two versions of the package in one page: the heights of each in JavaScript, and texts for shaders that have either, or
// both.
import { Field } from "hashnoise";
import now from "hashnoise/glsl/fbm2d";
import { Field as FieldBefore } from "hashnoise-before";
import before from "hashnoise-before/glsl/fbm2d";
import { version } from "hashnoise-before/package.json";

const settings = { octaves: 6, seed: 7 };
const fractal = version.startsWith("0.") ? "sum" : "fractal"; // the setting's name in 1.0
const fields = {
  now: [Field, { ...settings, fractal: "fbm" }],
  before: [FieldBefore, { ...settings, [fractal]: "fbm" }],
};
// All names of the library begin so, and one shader has each once (docs/reference/frozen.md).
const renamed = before.replace(/\b(hn|HN)_/g, "$1before_");
const texts = {
  now: "#define HN_ARITHMETIC HN_FIXED\n" + now,
  before: "#define HN_ARITHMETIC HN_FIXED\n" + before,
  renamed: "#define HNbefore_ARITHMETIC HNbefore_FIXED\n" + renamed,
};

/** The values of the twin in JavaScript. */
function computed(name, points) {
  const [Type, chosen] = fields[name];
  const field = new Type(2, chosen);
  return [...new Uint32Array(Float32Array.from(points, (p) => field.at(...p)).buffer)];
}

globalThis.hashnoise = { texts, computed };
