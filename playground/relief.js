// Terrain: a square of heights as a block that one looks at from above, without perspective. It is drawn column by
// column of the screen and from the front to the back, so that what stands in front hides what is behind it.
import { turned } from "./files.js";

const kBase = 0.04; // of the side of the block, below the lowest height
const kMargin = 1.04; // around the block
const kLight = [-0.45, 0.55, 0.7]; // from where light comes: right, up on the plane, and above
const kDark = 0.35; // of the colour, where no light comes
const kFlank = [52, 48, 50]; // the colour of the sides of the block
const kWater = [14, 58, 92];
const kShallow = 0.5; // of the colour of water where it is shallowest
const kDeep = 0.25; // how far below the sea it has all of it
const kSky = [150, 176, 190]; // what water mirrors: more of it far away, and most where the sun is
const kBackdrop = [[42, 44, 54], [16, 17, 21]]; // above and below, as in style.css
const kRound = 2 * Math.PI;

// The heights of values, from 0 for the lowest colour to 1 for the highest, the colour of each with its light, and which
// part of it is under water: on a coast that is a part of the step to the next values, so that it is no row of stairs.
// `side` is the number of values on a side, the first in the lower left corner; `steep` is the height of the highest
// colour in sides of the block. Colours are the palette's, or of `pixels` if there are some. Ground lower than `sea` is
// under water, which is flat.
export function surfaceOf(values, side, [low, high], palette, { steep, sea = 0 }, pixels) {
  const beds = Float32Array.from(values, (value) => Math.min(Math.max((value - low) / (high - low), 0), 1));
  const heights = beds.map((bed) => Math.max(bed, sea));
  const colours = new Uint8Array(3 * side * side);
  const wet = new Float32Array(side * side);
  const size = Math.hypot(...kLight);
  const light = kLight.map((part) => part / size);
  for (let row = 0, at = 0; row < side; ++row)
    for (let column = 0; column < side; ++column, ++at) {
      const [east, west] = [at + (column < side - 1 ? 1 : 0), at - (column > 0 ? 1 : 0)];
      const [north, south] = [at + (row < side - 1 ? side : 0), at - (row > 0 ? side : 0)];
      const slope = [heights[west] - heights[east], heights[south] - heights[north]].map((part) => part * steep * side * 0.5);
      const shine = (slope[0] * light[0] + slope[1] * light[1] + light[2]) / Math.hypot(slope[0], slope[1], 1);
      const bright = kDark + (1 - kDark) * Math.min(Math.max(shine / light[2], 0), 1.25);
      const colour = 4 * (pixels ? at : Math.min(Math.floor(beds[at] * 256), 255));
      const coast = (Math.abs(beds[east] - beds[west]) + Math.abs(beds[north] - beds[south])) / 2 || Number.MIN_VALUE;
      wet[at] = sea > 0 ? Math.min(Math.max((sea - beds[at]) / coast + 0.5, 0), 1) : 0;
      const water = wet[at] * Math.min(kShallow + Math.max(sea - beds[at], 0) / kDeep, 1);
      for (let part = 0; part < 3; ++part) {
        const own = (pixels || palette)[colour + part];
        colours[3 * at + part] = Math.min((own + (kWater[part] - own) * water) * bright, 255);
      }
    }
  return { heights, colours, wet, side, steep };
}

// How far along a line it is in the block, by one axis and those before it.
function crossed(start, direction, [enters, leaves]) {
  if (Math.abs(direction) < 1e-9) return Math.abs(start) > 0.5 ? [1, 0] : [enters, leaves];
  const ends = [(-0.5 - start) / direction, (0.5 - start) / direction];
  return [Math.max(enters, Math.min(...ends)), Math.min(leaves, Math.max(...ends))];
}

// The bytes of a picture, from the upper row on; where there is no block they are 0. `turn` is how far the block is
// turned, and `tilt` how far one looks down, in turns: 0.25 is from above. The block is in the middle of the first
// `free` columns. It sets the bytes of the columns from `begin` to `end` alone. A pixel that several parts of the block
// share has a mixture of their colours; `lines` are drawn in each column.
export function reliefOf({ heights, colours, wet, side, steep }, { turn, tilt }, width, height, free = width,
  bytes = new Uint8ClampedArray(4 * width * height), [begin, end] = [0, width], lines = 2) {
  const [sine, cosine] = [Math.sin(turn * kRound), Math.cos(turn * kRound)];
  const [down, across] = [Math.sin(tilt * kRound), Math.cos(tilt * kRound)];
  const deep = Math.SQRT2 * down + (steep + kBase) * across; // the block on the screen, in sides
  const scale = Math.min(free / (Math.SQRT2 * kMargin), height / (deep * kMargin));
  const middle = height / 2 - (steep - kBase) * 0.5 * across * scale; // the row of the block's middle, from below
  const step = 0.7 / side;
  const most = side - 1.001;
  const sums = new Float32Array(4 * height); // of the colours in a column, from below, and of how much each pixel has
  const colour = new Float64Array(3);
  for (let column = begin; column < Math.min(end, width); ++column) {
    sums.fill(0);
    for (let line = 0; line < lines; ++line) {
      const right = (column + (line + 0.5) / lines - free / 2) / scale;
      // The line of the block that this column shows, from the front to the back.
      const start = [right * cosine, right * sine];
      const [first, last] = crossed(start[1], cosine, crossed(start[0], -sine, [-1, 1]));
      if (first > last) continue;
      let filled = Math.max(0, middle + (first * down - kBase * across) * scale);
      for (let depth = first, front = true; depth <= last; depth += step, front = false) {
        const x = Math.min(Math.max((start[0] - depth * sine + 0.5) * side - 0.5, 0), most);
        const y = Math.min(Math.max((start[1] + depth * cosine + 0.5) * side - 0.5, 0), most);
        const left = x | 0;
        const below = y | 0;
        const at = below * side + left;
        const u = x - left;
        const v = y - below;
        const lower = heights[at] + (heights[at + 1] - heights[at]) * u;
        const upper = heights[at + side] + (heights[at + side + 1] - heights[at + side]) * u;
        const top = Math.min(middle + (depth * down + (lower + (upper - lower) * v) * steep * across) * scale, height);
        if (top <= filled) continue;
        const mixed = (list, from, next) =>
          (list[from] * (1 - u) + list[from + next] * u) * (1 - v) + (list[from + next * side] * (1 - u) + list[from + next * (side + 1)] * u) * v;
        const water = mixed(wet, at, 1);
        const isWater = front ? water > 0.5 : water > 0;
        const sun = Math.max(1 - 5 * right * right - 3 * (depth - 0.2) ** 2, 0) ** 2;
        const sky = isWater ? across * (0.14 + 0.12 * depth + 0.5 * sun) * (front ? 1 : water) : 0;
        for (let part = 0; part < 3; ++part) {
          const own = front ? (isWater ? kWater : kFlank)[part] : mixed(colours, 3 * at + part, 3);
          colour[part] = own + (kSky[part] - own) * sky;
        }
        for (let row = Math.floor(filled); row < top; ++row) {
          const share = (Math.min(top, row + 1) - Math.max(filled, row)) / lines;
          for (let part = 0; part < 3; ++part) sums[4 * row + part] += colour[part] * share;
          sums[4 * row + 3] += share;
        }
        filled = top;
      }
    }
    for (let row = 0; row < height; ++row) {
      const share = sums[4 * row + 3];
      if (!share) continue;
      const to = 4 * ((height - 1 - row) * width + column);
      for (let part = 0; part < 3; ++part) bytes[to + part] = Math.round(sums[4 * row + part] / share);
      bytes[to + 3] = Math.round(share * 255);
    }
  }
  return bytes;
}

// The bytes of a picture with what is behind the block, in strips from the lower row on, as a GPU gives them.
export function onBackdrop(bytes, width, height) {
  for (let at = 0; at < bytes.length; at += 4) {
    const own = bytes[at + 3] / 255;
    if (own === 1) continue;
    const part = Math.floor(at / 4 / width) / height;
    const behind = kBackdrop[0].map((above, k) => above + (kBackdrop[1][k] - above) * part);
    bytes.set([...behind.map((colour, k) => colour + (bytes[at + k] - colour) * own), 255], at);
  }
  return async (_, first, rows) => turned(bytes.subarray((height - first - rows) * width * 4, (height - first) * width * 4), width);
}
