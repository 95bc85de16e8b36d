// The files that the page saves: pictures and heights of any size, from the same shaders that draw.
import { Gif } from "./gif.js";
import { linkOf } from "./links.js";
import { isSolid, uses } from "./model.js";
import { paletteOf } from "./palette.js";
import { Png } from "./png.js";
import { kBits, kColours, unitsOf } from "./shaders.js";
import { kFiles } from "./tables.js";

const kMostOfStrip = 262144; // pixels, so that no draw keeps the GPU for long
const kMostOfLoop = 4e8; // pixels, since all frames are in memory until the file is saved
const kGreys = 65536;

// The heights of values, as numbers of 16 bits: each value is a whole number of steps of 2^-20, and those between the
// lowest and the highest colour are dealt to the numbers as they are to the 256 colours.
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

// What the four bytes of each pixel become in a file.
const kEncoded = {
  colours: (bytes) => bytes.filter((_, at) => at % 4 < 3),
  heights: (bytes, state) => inOrder(heightsOf(floatsOf(bytes), state), false),
  r16: (bytes, state) => inOrder(heightsOf(floatsOf(bytes), state), true),
  r32: (bytes) => bytes,
};

// Rows from the lower left corner on, turned, so that the upper row comes first.
function turned(bytes, width) {
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

// The bytes of strips of a picture, from the upper one on, each with its upper row first.
async function* strips(read, mode, state) {
  const { width, height } = state;
  const most = Math.max(1, Math.floor(kMostOfStrip / width));
  for (let above = height; above > 0; above -= most) {
    const rows = Math.min(most, above);
    yield turned(await read(mode, above - rows, rows, state), width);
  }
}

async function gifOf(state, read, tell) {
  const { width, height } = state;
  const frames = framesOf(state);
  if (width * height * frames.length > kMostOfLoop)
    throw new Error("A loop has at most 400 million pixels in all frames.");
  const made = new Gif(width, height, paletteOf(state));
  for (const [number, frame] of frames.entries()) {
    const pixels = new Uint8Array(width * height);
    let done = 0;
    for await (const bytes of strips(read, kBits, frame)) {
      pixels.set(heightsOf(floatsOf(bytes), frame).map((height) => height >> 8), done);
      done += bytes.length / 4;
    }
    made.add(pixels);
    tell((number + 1) / frames.length);
  }
  return made.done();
}

async function partsOfFile(state, read, tell) {
  const { file, width, height } = state;
  const made = kFiles[file].png
    ? new Png(width, height, file === "heights", `hashnoise ${linkOf(state)}`.trim())
    : undefined;
  const parts = [];
  let done = 0;
  for await (const bytes of strips(read, file === "colours" ? kColours : kBits, state)) {
    const encoded = kEncoded[file](bytes, state);
    if (made) await made.add(encoded);
    else parts.push(encoded);
    done += bytes.length / 4;
    tell(done / (width * height));
  }
  return made ? made.parts() : parts;
}

// The file of the state. `read(mode, first, rows, state)` gives the bytes of so many rows, the first of which is this
// one, counted from below; `tell` takes which part is done.
export async function fileOf(state, read, tell = () => {}) {
  const { file, width, height } = state;
  const { ending } = kFiles[file];
  const parts = await (file === "gif" ? gifOf : partsOfFile)(state, read, tell);
  const [{ sum, noise }, ...others] = state.layers;
  const subject = others.length ? "layers" : `${sum === "none" ? "" : `${sum}-`}${noise}`;
  const type = { png: "image/png", gif: "image/gif" }[ending] ?? "application/octet-stream";
  return new File(parts, `hashnoise-${subject}-${width}x${height}.${ending}`, { type });
}
