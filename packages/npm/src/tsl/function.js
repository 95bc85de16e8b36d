// A function of the library as nodes of three.js: in WGSL or in GLSL, whichever the renderer speaks. The text that
// tools/pick writes for three.js has this text, too.
import { Fn, glslFn, uint, wgslFn } from "three/tsl";

const WGSL_TYPES = { float: "f32", int: "i32", uint: "u32" };
const wgslType = (type) => WGSL_TYPES[type] ?? type.replace(/^([iu]?)vec(\d)$/, (_, kind, size) => `vec${size}${kind || "f"}`);

const RANGES = { int: [-(2 ** 31), 2 ** 31 - 1], uint: [0, 2 ** 32 - 1], float: [] };

/** Refuses what three.js would turn into another number, such as a seed of -1 into 0, and what it cannot draw. */
function checked(what, type, value) {
  if (value?.isNode) return;
  const range = RANGES[type];
  if (typeof value !== "number" || !range) {
    throw new TypeError(`${what} has to be ${range ? "a number or " : ""}a node of three.js, and is of the type ${typeof value}`);
  }
  const [least, most] = range;
  if (type === "float" ? !Number.isFinite(Math.fround(value)) : !Number.isInteger(value) || value < least || value > most) {
    const float = Number.isFinite(value) ? "number up to 3.4e38" : "finite number";
    const right = type === "float" ? float : `whole number from ${least} to ${most}`;
    throw new RangeError(`${what} has to be a ${right}, not ${value}`);
  }
}

/**
 * Makes the nodes of a function from its parameters and its name in GLSL, and two functions that return the node of
 * the text that it needs, in WGSL and in GLSL. The seed is the last parameter, and may be left out where GLSL lets it:
 * elsewhere it would be taken for what was forgotten before it.
 */
export function nodesOf(name, type, declared, called, inWgsl, inGlsl, mayLackSeed = false) {
  const parameters = declared.split(", ").map((one) => one.split(" "));
  const passed = parameters.map(([, parameter]) => parameter).join(", ");
  const ofWgsl = () => {
    const typed = parameters.map(([of, parameter]) => `${parameter}: ${wgslType(of)}`).join(", ");
    return wgslFn(`fn tsl_${name}(${typed}) -> ${wgslType(type)} { return ${name}(${passed}); }`, [inWgsl()]);
  };
  const ofGlsl = () =>
    glslFn(`${type} tsl_${name}(${declared}) { return ${called}(${passed}); }`, [inGlsl()]);
  const made = {}; // once: a text stands in a shader once by its node
  const chosen = Fn((inputs, builder) => {
    const speaks = builder.renderer.backend.isWebGPUBackend ? (made.wgsl ??= ofWgsl()) : (made.glsl ??= ofGlsl());
    return speaks(...parameters.map((_, i) => inputs[i]));
  }, type);
  return (...given) => {
    const last = parameters.length - 1;
    if (mayLackSeed && given.length >= last && given[last] === undefined) given[last] = uint(0);
    if (given.length !== parameters.length) throw new TypeError(`${name} wants (${passed}), and got ${given.length} values`);
    parameters.forEach(([of, parameter], i) => checked(`${name}: ${parameter}`, of, given[i]));
    return chosen(...given);
  };
}
