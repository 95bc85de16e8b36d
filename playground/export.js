// The texts to copy: the functions of code.js with the colours, with their helpers, and as a whole shader.
import { decimal, declaration, functions, kLanguages, kTypes, knobs, numbers } from "./code.js";
import { bakeLines, pythonLines } from "./lines.js";
import { hasDrift, isLeaning, mapsOf, numbersOfTinted, rangeOf, shownLayers } from "./model.js";
import { partsOfColour, rampOf } from "./palette.js";
import { isScalar, scalarCode } from "./scalar.js";
import { cellOf, cellsAcross, kPartsOfCell, leaningNumbers, leant, partsOf, placeOf } from "./view.js";

// The values that the lowest and the highest colour stand for, and how the lowest is taken off.
function endsOf(state) {
  const [low, high] = rangeOf(state).map((end) => Number(end.toFixed(4)));
  return { low, high, span: high - low, minus: low < 0 ? `+ ${decimal(-low)}` : `- ${decimal(low)}` };
}

// The colours as functions of the value: of the picture, or of the picture and of layers that have their own; and
// of these a function of a position, where `at` defines one.
function colours(language, state, at) {
  const [picture, ...tints] = mapsOf(state);
  if (!tints.length) return coloursOf(language, state, picture, "colour");
  const wgsl = language === "wgsl";
  const numbers = numbersOfTinted(state);
  const mix = language === "hlsl" ? "lerp" : "mix";
  const mixed = (part, k) => `c = ${mix}(c, colours_${numbers[k]}(v), ${wgsl ? `vec3f(${part})` : part});`;
  const first = wgsl ? "var c = colours(v);" : `${kTypes[language].float(3)} c = colours(v);`;
  const colour = at("colour", (parts) => [first, ...parts.map(mixed), "return c;"], 3);
  const maps = tints.flatMap((map, number) => ["", ...coloursOf(language, state, map, `colours_${numbers[number]}`)]);
  return [...coloursOf(language, state, picture, "colours"), ...maps, "", ...colour];
}

function coloursOf(language, state, map, name) {
  const { low, high, span, minus } = endsOf(state);
  const { float } = kTypes[language];
  const colour = (stop) => {
    const parts = partsOfColour(stop.colour).map((part) => (part / 255).toFixed(3));
    return `${float(3)}(${parts.join(", ")})`;
  };
  const { whole, stops } = rampOf(map);
  const mix = language === "hlsl" ? "lerp" : "mix"; // Metal has HLSL's types, and mix
  const scale = Number((whole / span).toPrecision(7));
  const wgsl = language === "wgsl";
  const three = (part) => (wgsl ? `vec3f(${part})` : part);
  // Which part of the way from one stop to the next one is behind `t`. Two stops in one place are an edge.
  const way = (from, to) => {
    if (from === to) return `step(${to}.0, t)`;
    const gone = from ? `t - ${from}.0` : "t";
    if (to - from === 1) return `clamp(${gone}, 0.0, 1.0)`;
    return `clamp(${from ? `(${gone})` : gone} / ${to - from}.0, 0.0, 1.0)`;
  };
  const lines = [
    wgsl
      ? `let t = clamp((value ${minus}) * ${decimal(scale)}, 0.0, ${whole}.0);`
      : `float t = clamp((value ${minus}) * ${decimal(scale)}, 0.0, ${whole}.0);`,
    wgsl ? `var c = ${colour(stops[0])};` : `${float(3)} c = ${colour(stops[0])};`,
    ...stops
      .slice(1)
      .map((stop, at) => `c = ${mix}(c, ${colour(stop)}, ${three(way(stops[at].place, stop.place))});`),
    "return c;",
  ];
  const head = wgsl ? `fn ${name}(value: f32) -> vec3f {` : `${float(3)} ${name}(float value) {`;
  const whose = map === state ? "the picture" : `layer ${name.split("_")[1]}`;
  return [`// From ${low} to ${high}: the colours of ${whose}.`, head, ...lines.map((line) => `  ${line}`), "}"];
}

// In languages without colours: how much each layer that has its own counts.
const masks = (state, at) =>
  numbersOfTinted(state).flatMap((number, k) => ["", ...at(`mask_${number}`, (parts) => [`return ${parts[k]};`])]);

const kPlaces = {
  glsl: "Put it below your #version and #extension lines.",
  hlsl: "Shader model 5 or 6.",
  wgsl: "Put your entry points below.",
  cpp: "C++20.",
  metal: "Metal Shading Language.",
  godot: "Godot 4.4 or later: a .gdshaderinc file, or below shader_type.",
  tsl: "three.js: pattern and colour are functions that make nodes.",
  csharp: "C#, for Unity and .NET. HashNoise.Pattern is the value.",
  rust: "Rust, without std.",
  go: "Go 1.18 or later.",
  java: "Java 17 or later. HashNoise.pattern is the value.",
  c: "C99.",
  javascript: "A module. TypeScript: tools/pick --language typescript.",
  python: "Of the package hashnoise: pip install -v . in the library.",
  osl: "Open Shading Language, for a Script node of Blender's Cycles.",
  bake: "In the library, on Linux.",
};

export const kLicense = "// Copyright (c) 2026 The hashnoise authors; MIT License.";

// As what the code is copied, and of whole shaders what stands around the functions: the first lines, how it is used,
// what is declared, how main begins, where the lower left corner of its pixel is, as on the page, counted from the middle in
// shorter sides of the picture, which part of the height is below it, and what becomes of the colour.
const kGlslMain = {
  use: "Draw a triangle over the picture with it.",
  declared: ["uniform vec2 resolution;  // of the picture, in pixels", "out vec4 fragment;", ""],
  clock: "uniform float time;  // in seconds, by which layers drift",
  time: "time",
  main: "void main() {",
  pixel: "(floor(gl_FragCoord.xy) - floor(0.5 * resolution)) / min(resolution.x, resolution.y)",
  below: "gl_FragCoord.y / resolution.y",
  result: (colour) => `fragment = vec4(${colour}, 1.0);`,
};
// Here rows are counted from above.
const kTurned = {
  below: "1.0 - position.y / resolution.y",
  pixel: (float2) =>
    `${float2}(floor(position.x) - floor(0.5 * resolution.x), ceil(0.5 * resolution.y) - ceil(position.y)) / min(resolution.x, resolution.y)`,
};
export const kWgslVertex = [
  "@vertex fn vertex(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {",
  "  return vec4f(select(-1.0, 3.0, i == 1u), select(-1.0, 3.0, i == 2u), 0.0, 1.0);",
  "}",
];
export const kKinds = {
  glsl: {
    function: { label: "Functions" },
    shader: {
      ...kGlslMain,
      label: "Shader, GLSL ES 3.00",
      first: ["#version 300 es", "precision highp float;", "precision highp int;"],
    },
    desktop: { ...kGlslMain, label: "Shader, GLSL 3.30", first: ["#version 330"] },
    shadertoy: {
      label: "Shadertoy",
      first: [],
      use: "Paste it into the tab Image of a new shader on shadertoy.com.",
      declared: [],
      time: "iTime",
      main: "void mainImage(out vec4 fragColor, in vec2 fragCoord) {",
      pixel: "(floor(fragCoord) - floor(0.5 * iResolution.xy)) / min(iResolution.x, iResolution.y)",
      below: "fragCoord.y / iResolution.y",
      result: (colour) => `fragColor = vec4(${colour}, 1.0);`,
    },
  },
  hlsl: {
    function: { label: "Functions" },
    shader: {
      label: "Whole pixel shader",
      first: [],
      use: "A pixel shader of shader model 5 or 6. Draw a triangle over the picture with it.",
      declared: ["cbuffer Frame : register(b0) { float2 resolution; };  // of the picture, in pixels", ""],
      clock: "cbuffer Clock : register(b1) { float time; };  // in seconds, by which layers drift",
      time: "time",
      main: "float4 main(float4 position : SV_Position) : SV_Target {",
      pixel: kTurned.pixel("float2"),
      below: kTurned.below,
      result: (colour) => `return float4(${colour}, 1.0);`,
    },
  },
  wgsl: {
    function: { label: "Functions" },
    shader: {
      label: "Whole shader",
      first: [],
      use: "Draw three vertices with it.",
      declared: [
        "@group(0) @binding(0) var<uniform> resolution: vec2f;  // of the picture, in pixels",
        "",
        ...kWgslVertex,
        "",
      ],
      clock: "@group(0) @binding(1) var<uniform> time: f32;  // in seconds, by which layers drift",
      time: "time",
      main: "@fragment fn fragment(@builtin(position) position: vec4f) -> @location(0) vec4f {",
      pixel: kTurned.pixel("vec2f"),
      below: kTurned.below,
      result: (colour) => `return vec4f(${colour}, 1.0);`,
    },
  },
};
for (const language of Object.keys(kLanguages)) kKinds[language] ??= { function: { label: "Functions" } };

const middleOf = ({ x, y, z, w, dimensions }) => [x, y, partsOf(z), partsOf(w)].slice(0, dimensions);
const inSpace = (state) => (isLeaning(state) ? leant(state, middleOf(state)) : middleOf(state)).slice(0, state.dimensions);

// Where a position of a picture that leans is in space.
function sliceLines(language, state) {
  if (!isLeaning(state)) return [];
  const { float } = kTypes[language];
  const n = state.dimensions;
  const suffix = ["cpp", "metal"].includes(language) ? "f" : "";
  const rows = leaningNumbers(state).map((row) => row.map((part, at) => `${decimal(part)}${suffix} * p.${"xyz"[at]}`).join(" + "));
  const body = `return ${float(n)}(${[...rows, "p.w"].slice(0, n).join(", ")});`;
  const head = language === "wgsl" ? `fn slice(p: ${float(n)}) -> ${float(n)} {` : `${language === "cpp" ? "inline " : ""}${float(n)} slice(${float(n)} p) {`;
  return ["// Where p of the picture is in space, since the slice leans: pattern(slice(p)).", head, `  ${body}`, "}", ""];
}

// By which form of "pattern" the picture is drawn: beyond so many cells a position in floats has too few digits behind
// the point.
const kFar = 1024;
const formOf = (state) =>
  cellsAcross(state) * Math.max(...shownLayers(state).map(({ scale }) => scale)) > kFar || inSpace(state).some((parts) => Math.abs(cellOf(parts)) > kFar) ? "cell" : "position";

// The lines of the main function of a whole shader, which draws the picture as the page has it.
function mainOf(language, state, { main, time, pixel, below, result }) {
  const { float, int } = kTypes[language];
  const n = state.dimensions;
  const set = (type, name, value) => declaration(language, type, name, value);
  const vector = (type, parts) => (parts.length === 1 ? parts[0] : `${type}(${parts.join(", ")})`);
  const far = formOf(state) === "cell";
  const leans = isLeaning(state);
  const place = far ? inSpace(state) : middleOf(state);
  const numbers = place.map((parts) => decimal((far ? placeOf(parts) : Number(parts)) / kPartsOfCell));
  const flat = leans ? n : Math.min(n, 2); // The pixel has so many coordinates; the others are the slice's.
  const onPlane = `${n === 1 ? "pixel.x" : "pixel"} * ${decimal(cellsAcross(state))}`;
  const scaled = leans ? `slice(${vector(float(n), [onPlane, "0.0", "0.0"].slice(0, n - 1))})` : onPlane;
  const slice = `${scaled} + ${vector(float(flat), numbers.slice(0, flat))}`;
  const lines = [set(float(2), "pixel", pixel)];
  if (far) {
    // A literal of the lowest cell would be too large without its sign.
    const cells = place.map(cellOf).map((cell) => (cell === -2147483648 ? "-2147483647 - 1" : String(cell)));
    const cell = `${vector(int(flat), cells.slice(0, flat))} + ${int(flat)}(whole)`;
    lines.push(
      set(float(flat), "q", slice),
      set(float(flat), "whole", "floor(q)"),
      set(int(n), "cell", flat === n ? cell : vector(int(n), [cell, ...cells.slice(2)])),
      set(float(n), "f", flat === n ? "q - whole" : vector(float(n), ["q - whole", ...numbers.slice(2)])),
    );
  } else {
    const p = vector(float(n), [leans ? `${onPlane} + ${vector(float(2), numbers.slice(0, 2))}` : slice, ...numbers.slice(2)]);
    lines.push(set(float(n), "p", leans ? `slice(${p})` : p));
  }
  const clock = hasDrift(state) ? `, ${state.time ? `${decimal(state.time)} + ` : ""}${time}` : "";
  const called = (name) => (far ? `${name}${language === "wgsl" ? "_cell" : ""}(cell, f${clock})` : `${name}(p${clock})`);
  const call = called("pattern");
  const hasTints = mapsOf(state).length > 1;
  if (n > 1) {
    lines.push(result(hasTints ? called("colour") : `colour(${call})`));
  } else {
    // A graph of the values.
    const { minus, span } = endsOf(state);
    lines.push(
      set(float(1), "value", call),
      set(float(1), "above", `step((value ${minus}) * ${decimal(Number((1 / span).toPrecision(7)))}, ${below})`),
      result(`${hasTints ? called("colour") : "colour(value)"} * (1.0 - 0.875 * above)`),
    );
  }
  return [main, ...lines.map((line) => `  ${line}`), "}"];
}

// Declarations have highp: in a fragment shader of GLSL ES numbers have 16 bits otherwise, whatever the user's own
// precision is. (A constructor has no blank and a name behind it.)
const withHighp = (line) =>
  line.replace(/(?<![/].*)(?<!highp )\b(?:float|u?int|[iu]?vec[234])(?= [a-z]\w*)/g, "highp $&");

const textLines = (library, language, names, state) =>
  library.texts(names, language, state).flatMap((text) => text.trimEnd().split("\n"));

// {head, library, code}: lines; of the library what tools/pick writes of what is called. Without it the head includes it, if
// the language can. Whole shaders and other languages always have it.
export function exported(library, language, state, kind = "function", withLibrary = true) {
  const note = state.dimensions === 1 ? "p counts cells" : "p is a position in cells: uv * 8.0 has 8 of them on a side";
  const clock = hasDrift(state) && !kKinds[language][kind].main ? ["// Layers drift: seconds is the time."] : [];
  const first = `Made by hashnoise's playground, version ${library.version}. ${kKinds[language][kind].use ?? kPlaces[language]}`;
  if (language === "python") return { head: [`# ${first}`], library: [], code: pythonLines(state) };
  if (language === "bake") {
    const hash = state.hash === "lattice" ? [] : ["# tools/bake has the default hash."];
    return { head: [`# ${first}`, ...hash], library: [], code: bakeLines(state) };
  }
  if (isScalar(language)) {
    const { head, ...rest } = scalarCode(library, language, state);
    const hash = state.hash === "lattice" ? [] : ["// With the default hash: the page has no other in this language."];
    const floats = state.arithmetic === "fixed" ? [] : ["// In integers, whose values differ from those of floats by less than 0.0001."];
    const sum = (row) => row.map((part, at) => `${part} * ${"xyz"[at]}`).join(" + ").replaceAll("+ -", "- ");
    const leaning = isLeaning(state) ? ["// The slice leans: x, y, z of the picture are in space at", ...leaningNumbers(state).map((row) => `//   ${sum(row)}`)] : [];
    return { head: [`// ${first}`, kLicense, ...hash, ...floats, ...clock, ...leaning, ...(head.length ? ["", ...head] : [])], ...rest };
  }
  if (language === "tsl") return tslText(library, state, first);
  const shell = kKinds[language][kind];
  const [cpp, wgsl] = [language === "cpp", language === "wgsl"];
  const isNew = language === "metal" || language === "godot";
  const values = numbers(language, state);
  const inside = !cpp && (isNew || shell.main || withLibrary);
  const forms = inside ? [formOf(state)] : undefined;
  const { lines, at, files, public: called } = functions(language, state, values, forms, inside);
  const included = language === "hlsl" ? ["begin.hlsl", ...files, "end.hlsl"] : files;
  const headers = cpp ? ["<hashnoise/hashnoise.hpp>"] : included.map((file) => `"hashnoise/${file}"`);
  const command = ["// In front of it stands what tools/pick writes:", `// ${pickCommand(language, state, called)}`];
  const written = [
    ...(shell.main ? [] : [`// ${note}.${inside ? "" : " Far out pass an integer cell and the place in it."}`]),
    ...clock,
    ...sliceLines(language, state),
    ...lines,
    ...(cpp ? masks(state, at) : ["", ...colours(language, state, at)]),
    ...(shell.main ? ["", ...(hasDrift(state) && shell.clock ? [shell.clock] : []), ...shell.declared, ...mainOf(language, state, shell)] : []),
  ];
  const code = language === "glsl" && !shell.main ? written.map(withHighp) : written;
  const [opening] = inside ? library.shells[language] : [""];
  return {
    head: [
      ...(shell.first ?? []),
      `// ${first}`,
      ...(inside ? [kLicense] : []),
      ...(!inside && wgsl ? command : []),
      ...(inside || wgsl ? [] : knobs(state)),
      ...(inside || wgsl ? [] : headers.map((header) => `#include ${header}`)),
      ...(opening ? opening.trimEnd().split("\n") : []),
      "",
    ],
    library: inside ? textLines(library, language, called, state) : [],
    code: cpp ? ["namespace hashnoise {", ...code, "}  // namespace hashnoise"] : code,
  };
}

// A module for three.js: the text of both languages of its renderers, and nodes of what it defines.
function tslText(library, state, first) {
  const textOf = (language) => {
    const shown = functions(language, state, numbers(language, state), ["position"], true);
    const code = [...sliceLines(language, state), ...shown.lines, "", ...colours(language, state, shown.at)];
    const text = [...textLines(library, language, shown.public, state), "", ...(language === "glsl" ? code.map(withHighp) : code)];
    return text.join("\n").replaceAll("\\", "\\\\").replaceAll("`", "\\`").replaceAll("${", "\\${").split("\n");
  };
  const [begin] = library.shells.tsl;
  const p = `${state.dimensions === 1 ? "float" : `vec${state.dimensions}`} p`;
  const then = hasDrift(state) ? `${p}, float seconds` : p;
  const node = (name, type, declared) =>
    `export const ${name} = nodesOf("${name}", "${type}", "${declared}", "${name}", () => textOfWgsl, () => textOfGlsl);`;
  return {
    head: [`// ${first}`, kLicense, "", ...begin.trimEnd().split("\n"), ""],
    library: [],
    code: [
      "const textOfGlsl = glsl(`", ...textOf("glsl"), "`);", "const textOfWgsl = wgsl(`", ...textOf("wgsl"), "`);",
      `// p is a position in cells: pattern(uv().mul(8)${hasDrift(state) ? ", time" : ""}).`, node("pattern", "float", then),
      ...(isLeaning(state) ? [node("slice", p.slice(0, 4), p)] : []),
      node("colour", "vec3", mapsOf(state).length > 1 ? then : "float value"),
    ],
  };
}

function pickCommand(language, { arithmetic, hash }, names) {
  return [
    "tools/pick",
    ...names,
    ...(language === "glsl" ? [] : [`--language ${language}`]),
    ...(arithmetic === "fixed" ? ["--arithmetic fixed"] : []),
    ...(hash === "lattice" ? [] : [`--hash ${hash}`]),
  ].join(" ");
}

export function exportedText(library, language, state, kind, withLibrary) {
  const { head, library: inside, code } = exported(library, language, state, kind, withLibrary);
  return [...head, ...inside, ...(inside.length ? [""] : []), ...code, ""].join("\n");
}
