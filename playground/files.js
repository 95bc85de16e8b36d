// The files that the page saves: pictures and heights of any size, from the same shaders that draw.
import { Gif } from "./gif.js";
import { linkOf, lookOf } from "./links.js";
import { isSolid, mapsOf, rangeOf, reliefHeight, uses } from "./model.js";
import { paletteOf } from "./palette.js";
import { Png } from "./png.js";
import { kBits, kColours, unitsOf } from "./shaders.js";
import { kFiles } from "./tables.js";

const kMostOfStrip = 262144; // pixels, so that no draw keeps the GPU for long
const kMostOfLoop = 4e8; // pixels, since all frames are in memory until the file is saved
const kGreys = 65536;
const kColoursOfGif = 256;

// The heights of values, as numbers of 16 bits: each value is a whole number of steps of 2^-20, and those between the
// lowest and the highest colour are distributed to the numbers as they are to the 256 colours.
export function heightsOf(values, state) {
  const { low, span } = unitsOf(state);
  return Uint16Array.from(values, (value) => {
    const d = Math.min(Math.max(Math.floor(value * 1048576) - low, 0), span - 1);
    return Math.floor((d * kGreys) / span);
  });
}

const inOrder = (numbers, littleEndian) => {
  const bytes = new DataView(new ArrayBuffer(numbers.length * 2));
  numbers.forEach((number, at) => bytes.setUint16(at * 2, number, littleEndian));
  return new Uint8Array(bytes.buffer);
};
const floatsOf = (bytes) => {
  const view = new DataView(bytes.buffer);
  return Float32Array.from({ length: bytes.length / 4 }, (_, at) => view.getFloat32(at * 4, true));
};

// How a file writes the four bytes of each pixel.
const kEncoded = {
  colours: (bytes) => bytes.filter((_, at) => at % 4 < 3),
  heights: (bytes, state) => inOrder(heightsOf(floatsOf(bytes), state), false),
  r16: (bytes, state) => inOrder(heightsOf(floatsOf(bytes), state), true),
  r32: (bytes) => bytes,
  tiff: (bytes) => bytes,
};

// The colours of a normal map, as OpenGL has it: green is up. The values have one more on each side. Heights are those of
// the terrain of the same picture.
export function normalsOf(values, state, width, rows, shorter) {
  const [low, high] = rangeOf(state);
  const factor = (reliefHeight(state) * shorter) / 2 / (high - low);
  const made = new Uint8Array(3 * width * rows);
  const wide = width + 2;
  for (let row = 0, to = 0; row < rows; ++row)
    for (let column = 0; column < width; ++column) {
      const at = (row + 1) * wide + column + 1;
      const right = (values[at - 1] - values[at + 1]) * factor;
      const up = (values[at + wide] - values[at - wide]) * factor;
      const size = Math.hypot(right, up, 1);
      for (const part of [right, up, 1]) made[to++] = Math.round(((part / size) * 0.5 + 0.5) * 255);
    }
  return made;
}

// The head of a TIFF file of one float a pixel, without compression.
const kTiffTags = 10;
export function tiffHead(width, height) {
  const size = 8 + 2 + 12 * kTiffTags + 4;
  const view = new DataView(new ArrayBuffer(size));
  view.setUint32(0, 0x49492a00); // little-endian from here on
  view.setUint32(4, 8, true);
  view.setUint16(8, kTiffTags, true);
  const [short, long] = [3, 4];
  [
    [256, long, width], [257, long, height], [258, short, 32], [259, short, 1], [262, short, 1], [273, long, size],
    [277, short, 1], [278, long, height], [279, long, 4 * width * height], [339, short, 3],
  ].forEach(([tag, type, value], number) => {
    const at = 10 + 12 * number;
    view.setUint16(at, tag, true);
    view.setUint16(at + 2, type, true);
    view.setUint32(at + 4, 1, true);
    view.setUint32(at + 8, value, true);
  });
  return new Uint8Array(view.buffer);
}

// Rows from the lower left corner on, turned, so that the upper row comes first.
export function turned(bytes, width) {
  const rows = bytes.length / (4 * width);
  const made = new Uint8Array(bytes.length);
  for (let row = 0; row < rows; ++row)
    made.set(bytes.subarray(row * width * 4, (row + 1) * width * 4), (rows - 1 - row) * width * 4);
  return made;
}

// The state as a plane: a solid has the plane through its middle.
export const planeOf = (state) => (isSolid(state) ? { ...state, view: "plane" } : { ...state });

// The state whose picture a file has. In place of tiles it is one tile.
export const fileState = (state) =>
  state.view === "tiles" ? { ...state, view: "plane", cells: state.period } : planeOf(state);

// The states of the frames of a loop: what moves comes back to where it was. A picture in which nothing does is one
// frame.
export function framesOf(state) {
  const used = uses(state);
  const last = used.w ? "w" : "z";
  const moved = used.phase
    ? (part) => ({ phase: part })
    : used.z && state.period
      ? (part) => ({ [last]: state[last] + part * state.period })
      : undefined;
  if (!moved) return [state];
  // The phase is never 0, for which there is another shader, but a whole turn.
  return Array.from({ length: state.frames }, (_, at) => ({ ...state, ...moved((at + 1) / state.frames) }));
}

// The bytes of strips of a picture, from the upper one on, each with its upper row first; with so many pixels around.
async function* strips(read, mode, state, border = 0) {
  const { width, height } = state;
  const most = Math.max(1, Math.floor(kMostOfStrip / width));
  for (let above = height; above > 0; above -= most) {
    const rows = Math.min(most, above);
    yield turned(await read(mode, above - rows, rows, state, border), width + 2 * border);
  }
}

// The 256 colours of a GIF for a picture that has more of them: of cubes of colours those with the most pixels; and a
// function that makes the numbers of the nearest ones.
function fewColours(picture) {
  const cubeOf = (bytes, at) => ((bytes[at] >> 3) << 10) | ((bytes[at + 1] >> 3) << 5) | (bytes[at + 2] >> 3);
  const counts = new Uint32Array(32768);
  for (let at = 0; at < picture.length; at += 4) ++counts[cubeOf(picture, at)];
  const cubes = [...counts.keys()].sort((one, other) => counts[other] - counts[one]).slice(0, kColoursOfGif);
  const partsOf = (cube) => [cube >> 10, (cube >> 5) & 31, cube & 31].map((part) => part * 8 + 4);
  const colours = cubes.map(partsOf);
  const nearest = new Map();
  const numberOf = (cube) => {
    if (!nearest.has(cube)) {
      const parts = partsOf(cube);
      const far = colours.map((colour) => colour.reduce((sum, part, k) => sum + (part - parts[k]) ** 2, 0));
      nearest.set(cube, far.indexOf(Math.min(...far)));
    }
    return nearest.get(cube);
  };
  const numbersOf = (bytes) => Uint8Array.from({ length: bytes.length / 4 }, (_, at) => numberOf(cubeOf(bytes, 4 * at)));
  return { palette: Uint8Array.from(colours.flatMap((colour) => [...colour, 255])), numbersOf };
}

async function pictureOf(read, mode, frame) {
  const picture = new Uint8Array(4 * frame.width * frame.height);
  let done = 0;
  for await (const bytes of strips(read, mode, frame)) {
    picture.set(bytes, done);
    done += bytes.length;
  }
  return picture;
}

async function gifOf(state, read, tell) {
  const { width, height } = state;
  const frames = framesOf(state);
  if (width * height * frames.length > kMostOfLoop)
    throw new Error("A loop has at most 400 million pixels in all frames.");
  const mode = mapsOf(state).length > 1 ? kColours : kBits;
  let [made, few] = mode === kBits ? [new Gif(width, height, paletteOf(state))] : [];
  for (const [number, frame] of frames.entries()) {
    const picture = await pictureOf(read, mode, frame);
    if (!made) {
      few = fewColours(picture);
      made = new Gif(width, height, few.palette);
    }
    made.add(few ? few.numbersOf(picture) : Uint8Array.from(heightsOf(floatsOf(picture), frame), (height) => height >> 8));
    tell((number + 1) / frames.length);
  }
  return made.done();
}

async function partsOfFile(state, read, tell) {
  const { file, width, height } = state;
  const made = kFiles[file].png
    ? new Png(width, height, file === "heights", `hashnoise ${linkOf(state)}`.trim())
    : undefined;
  const parts = file === "tiff" ? [tiffHead(width, height)] : [];
  const border = file === "normals" ? 1 : 0;
  let done = 0;
  for await (const bytes of strips(read, file === "colours" ? kColours : kBits, state, border)) {
    const rows = bytes.length / 4 / (width + 2 * border) - 2 * border;
    const encoded = border
      ? normalsOf(floatsOf(bytes), state, width, rows, Math.min(width, height))
      : kEncoded[file](bytes, state);
    if (made) await made.add(encoded);
    else parts.push(encoded);
    done += rows;
    tell(done / height);
  }
  return made ? made.parts() : parts;
}

// Its name has the look or the noises, the seed and the kind, so that no file replaces another one.
export function nameOfFile(state) {
  const { file, width, height } = state;
  const [{ sum, noise, seed }, ...others] = state.layers;
  const ofLayers = [...new Set(state.layers.map((layer) => (layer.sum === "none" ? layer.noise : layer.sum)))].slice(0, 3).join("-");
  const look = others.length && lookOf(state)?.toLowerCase().replaceAll(" ", "-");
  const subject = others.length ? look || ofLayers : `${sum === "none" ? "" : `${sum}-`}${noise}`;
  const { ending, part = file } = kFiles[file];
  const kind = part === "colours" ? "" : `-${part}`;
  const size = file === "json" ? "" : `-${width}x${height}`;
  return `hashnoise-${subject.replaceAll("_", "-")}-seed${seed}${kind}${size}.${ending}`;
}

const kTypesOfFiles = { png: "image/png", gif: "image/gif", tif: "image/tiff", json: "application/json" };

// The file of the state. `read(mode, first, rows, state, border)` gives the bytes of so many rows. The first row is
// this one, counted from below, with so many pixels around; `tell` takes which part is done.
export async function fileOf(state, read, tell = () => {}) {
  const { file } = state;
  const parts =
    file === "json"
      ? [`${JSON.stringify({ hashnoise: linkOf(state) || "#" })}\n`]
      : await (file === "gif" ? gifOf : partsOfFile)(state, read, tell);
  return new File(parts, nameOfFile(state), { type: kTypesOfFiles[kFiles[file].ending] ?? "application/octet-stream" });
}

// The link in a file that the page has saved: of a setting, or in the comment of a PNG. Nothing for another file.
export async function linkInFile(file) {
  const bytes = await file.slice(0, 4096).arrayBuffer();
  const text = new TextDecoder("latin1").decode(bytes);
  const comment = text.indexOf("tEXtComment\0hashnoise");
  if (comment >= 4) return text.slice(comment + 21, comment + 4 + new DataView(bytes).getUint32(comment - 4)).trim() || "#";
  return /"hashnoise": ?"(#[^"]*)"/.exec(text)?.[1];
}
