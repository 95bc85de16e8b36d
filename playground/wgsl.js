// Functions that both languages of the page have in their shaders. They are written in the part of GLSL that this module knows.
// A condition is in its line with what it holds for; shifts of vectors are by vectors; counters end with ++.
const kScalars = { float: "f32", int: "i32", uint: "u32" };
const kTypesOfGlsl = /\b(float|u?int|[iu]?vec\d)\b/g;
const typeInWgsl = (type) => kScalars[type] ?? type.replace(/^([iu]?)vec(\d)$/, (_, kind, n) => `vec${n}${kind || "f"}`);

export const inWgsl = (text) =>
  text
    .replace(/^(\w+) (\w+)\((.*)\) \{$/gm, (_, type, name, parameters) => `fn ${name}(${parameters.replace(/(\w+) (\w+)/g, "$2: $1")}) -> ${type} {`)
    .replace(/\bif \((.*)\) ([^{\n]*;)$/gm, "if ($1) { $2 }")
    .replace(/\b(?:float|u?int|[iu]?vec\d) (?=\w+ = )/g, "var ")
    .replace(/\b([iu]?vec\d|float|u?int) (\w+);/g, "var $2: $1;")
    .replace(kTypesOfGlsl, typeInWgsl)
    .replace(/\bu_/g, "u.");
