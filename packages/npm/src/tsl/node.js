// The functions of the package as nodes of three.js, over the texts of its other modules.
import { glsl, wgsl } from "three/tsl";
import { nodesOf } from "./function.js";

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

/** Makes the nodes of a function from the text that it needs in GLSL, and from the function in WGSL. */
export const node = (name, type, declared, called, text, definition, arithmetic, mayLackSeed) =>
  nodesOf(name, type, declared, called, () => definitionNode(definition), () => textNode(arithmetic, text),
    mayLackSeed);
