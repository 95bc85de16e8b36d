// A function of the library as nodes of three.js: in WGSL or in GLSL, whichever the renderer speaks. The text that
// tools/pick writes for three.js has this text, too.
import { Fn, glslFn, uint, wgslFn } from "three/tsl";

const WGSL_TYPES = { float: "f32", int: "i32", uint: "u32" };
const wgslType = (type) => WGSL_TYPES[type] ?? type.replace(/^([iu]?)vec(\d)$/, (_, kind, size) => `vec${size}${kind || "f"}`);

/**
 * Makes the nodes of a function. `declared` are its parameters in GLSL, and `called` is its name there; `inWgsl`
 * and `inGlsl` return the node of the text that it needs. The seed is the last parameter, and may be left out where
 * GLSL lets it: elsewhere it would be taken for what was forgotten before it.
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
    if (mayLackSeed && given.length === parameters.length - 1) given.push(uint(0));
    if (given.length !== parameters.length) throw new TypeError(`${name} wants (${passed}), and got ${given.length} values`);
    return chosen(...given);
  };
}
