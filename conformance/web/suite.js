// The data that the page comes with (docs/reference/formats.md, "The page and its suite"): shaders, input words and
// expected values.

// Words that go into and come out of one evaluation, as in functions.hpp.
export const kInputWords = 16;
export const kOutputWords = 4;

export function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
}

// "x:f32 seed:u32" -> [{name: "x", type: "f32"}, {name: "seed", type: "u32"}]
function columnsOf(text) {
  return text.split(" ").filter(Boolean).map((item) => {
    const [name, type] = item.split(":");
    return { name, type };
  });
}

export class Suite {
  constructor(json) {
    this.version = json.version;
    this.library = json.library ?? null;
    this.cases = json.cases;
    this.uniforms = json.uniforms;
    this.golden = json.golden ?? null;  // only of all default cases
    this.reportTo = json.report_to ?? null;
    this.json = json;
    this.api = json.api;
  }

  // {text, translate}: translate turns the line numbers of a driver's log into files and lines.
  shader(number) {
    const { pieces, paths } = this.json.shaders[number];
    return {
      text: pieces.map((piece) => this.json.texts[piece]).join(""),
      translate: (log) => translateLog(log, paths),
    };
  }

  // The arguments of Renderer.build.
  program(number) {
    const { stage, vertex, fragment, wgsl } = this.json.programs[number];
    if (wgsl !== undefined) return { stage, wgsl: this.shader(wgsl) };
    return { stage, vertex: this.shader(vertex), fragment: this.shader(fragment) };
  }

  // 32-bit words, and 64-bit floats. The data are little-endian, as every browser's numbers are.
  words(number) {
    return new Uint32Array(bytesOf(this.json.data[number]).buffer);
  }

  doubles(number) {
    return new Float64Array(bytesOf(this.json.data[number]).buffer);
  }

  // The API that a case needs: "webgl2" or "webgpu".
  apiOf(test) {
    const program = this.json.programs[test.program];
    return program === undefined ? this.api : program.wgsl === undefined ? "webgl2" : "webgpu";
  }

  // The columns of a function: "x:f32 seed:u32 = value:f64".
  columns(text) {
    const [inputs, outputs] = text.split(" = ").map(columnsOf);
    return { inputs, outputs };
  }

  // kInputWords per point, of data with the words that the columns use.
  inputs(columns, number) {
    return spread(this.words(number), columns.inputs.length);
  }

  // How far each value may be off, by its number.
  allowed(test) {
    if (typeof test.allowed === "number") return () => test.allowed;
    const values = this.doubles(test.allowed.data);
    return (value) => values[value];
  }
}

function spread(packed, columns) {
  const words = new Uint32Array((packed.length / columns) * kInputWords);
  for (let point = 0; point * columns < packed.length; ++point) {
    words.set(packed.subarray(point * columns, (point + 1) * columns), point * kInputWords);
  }
  return words;
}

// The inputs of all points of a digest's box, the last axis fastest, with the seed behind the coordinates.
export function digestInputs({ origin, size, seed }) {
  const count = size.reduce((product, length) => product * length, 1);
  const words = new Uint32Array(count * kInputWords);
  for (let point = 0; point < count; ++point) {
    let rest = point;
    for (let axis = size.length - 1; axis >= 0; --axis) {
      words[point * kInputWords + axis] = origin[axis] + (rest % size[axis]);
      rest = Math.floor(rest / size[axis]);
    }
    words[point * kInputWords + size.length] = seed;
  }
  return words;
}

// FNV-1a, 64 bit, of words as little-endian bytes; 16 hexadecimal digits. In two halves, since BigInt is slow:
// the prime is 2^40 + 0x1B3.
export function fnv1a64(words) {
  let high = 0xcbf29ce4;
  let low = 0x84222325;
  for (const word of words) {
    for (let shift = 0; shift < 32; shift += 8) {
      low = (low ^ ((word >>> shift) & 0xff)) >>> 0;
      const product = low * 0x1b3;  // below 2^41, exact
      high = (Math.imul(high, 0x1b3) + Math.floor(product / 0x100000000) + (low << 8)) >>> 0;
      low = product >>> 0;
    }
  }
  return hex(high) + hex(low);
}

// CRC-32, as zlib has it, of words as little-endian bytes.
export function crc32(words) {
  let crc = 0xffffffff;
  for (const word of words) {
    for (let shift = 0; shift < 32; shift += 8) crc = kCrcTable[(crc ^ (word >>> shift)) & 0xff] ^ (crc >>> 8);
  }
  return ~crc >>> 0;
}

const kCrcTable = Uint32Array.from({ length: 256 }, (_, value) => {
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

export function hex(word) {
  return word.toString(16).padStart(8, "0");
}

// Each source has its own range of line numbers; see source.cpp.
const kLinesPerSource = 10000;

export function translateLog(log, paths) {
  return log.replace(/\b\d+(:|\()(\d+)(\)?)/g, (match, open, line, close) => {
    const path = paths[Math.floor(Number(line) / kLinesPerSource)];
    if (path === undefined) return match;
    return `${path}:${Number(line) % kLinesPerSource}${open === "(" ? "" : close}`;
  });
}
