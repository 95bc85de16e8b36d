// Nodes of three.js: a function of the library in WGSL or in GLSL, whichever the renderer speaks.
import { Fn, glsl, glslFn, uint, wgsl, wgslFn } from "three/tsl";
import { wgsl as textOf } from "../wgsl/wgsl.js";

const WGSL_TYPES = { float: "f32", int: "i32", uint: "u32" };
const wgslType = (type) => WGSL_TYPES[type] ?? type.replace(/^([iu]?)vec(\d)$/, (_, kind, size) => `vec${size}${kind || "f"}`);

// A text stands in a shader once, however many functions need it: its node is made once.
const nodes = new Map();
function once(key, make) {
  let made = nodes.get(key);
  if (!made) nodes.set(key, (made = make()));
  return made;
}

const definitionNode = (one) => once(one, () => wgsl(one.code, one.needs.map(definitionNode)));

// Guards keep what two texts have in common from standing in a shader twice. So the first decides the arithmetic.
const checked = (arithmetic, text) => `#ifndef HN_CONFIG_GLSL
#define HN_ARITHMETIC ${arithmetic}
#elif HN_ARITHMETIC != ${arithmetic}
#error a shader takes its noise from hashnoise/tsl or from hashnoise/tsl/fixed, not from both
#endif
${text}`;
const textNode = (arithmetic, text) => once(`${arithmetic}\n${text}`, () => glsl(checked(arithmetic, text)));

/**
 * A function that makes nodes. `declared` are its parameters in GLSL, `called` its name there, `text` what that needs;
 * `definition` is the function in WGSL.
 */
export function node(name, type, declared, called, text, definition, arithmetic) {
  const parameters = declared.split(", ").map((one) => one.split(" "));
  const passed = parameters.map(([, parameter]) => parameter).join(", ");
  const inWgsl = () => {
    const typed = parameters.map(([of, parameter]) => `${parameter}: ${wgslType(of)}`).join(", ");
    const code = `fn tsl_${name}(${typed}) -> ${wgslType(type)} { return ${name}(${passed}); }`;
    return once(`wgsl ${arithmetic} ${name}`, () => wgslFn(code, [definitionNode(definition)]));
  };
  const inGlsl = () => {
    const code = `${type} tsl_${name}(${declared}) { return ${called}(${passed}); }`;
    return once(`glsl ${arithmetic} ${name}`, () => glslFn(code, [textNode(arithmetic, text)]));
  };
  const chosen = Fn((inputs, builder) => {
    const speaks = builder.renderer.backend.isWebGPUBackend ? inWgsl() : inGlsl();
    return speaks(...parameters.map((_, i) => inputs[i]));
  }, type);
  const seedAt = parameters.at(-1)[1] === "seed" ? parameters.length - 1 : -1;
  return (...given) => {
    if (given.length === seedAt) given.push(uint(0));
    if (given.length !== parameters.length) throw new TypeError(`${name} wants (${passed}), and got ${given.length} values`);
    return chosen(...given);
  };
}
