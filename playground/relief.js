// Terrain: a square of heights as a block that one looks at from above, without perspective. It is drawn column by
// column of the screen and from the front to the back, so that what stands in front hides what is behind it.

const kBase = 0.04; // of the side of the block, below the lowest height
const kMargin = 1.04; // around the block
const kLight = [-0.45, 0.55, 0.7]; // from where light comes: right, up on the plane, and above
const kDark = 0.35; // of the colour, where no light comes
const kFlank = [52, 48, 50]; // the colour of the sides of the block
const kRound = 2 * Math.PI;

// The heights of values, from 0 for the lowest colour to 1 for the highest, and the colour of each with its light.
// `side` is the number of values on a side, the first in the lower left corner; `steep` is the height of the highest
// colour in sides of the block. Colours are the palette's, or of `pixels` if there are some.
export function surfaceOf(values, side, [low, high], palette, steep, pixels) {
  const heights = Float32Array.from(values, (value) => Math.min(Math.max((value - low) / (high - low), 0), 1));
  const colours = new Uint8Array(3 * side * side);
  const size = Math.hypot(...kLight);
  const light = kLight.map((part) => part / size);
  for (let row = 0, at = 0; row < side; ++row)
    for (let column = 0; column < side; ++column, ++at) {
      const right = heights[at + (column < side - 1 ? 1 : 0)] - heights[at - (column > 0 ? 1 : 0)];
      const up = heights[at + (row < side - 1 ? side : 0)] - heights[at - (row > 0 ? side : 0)];
      const slope = [-right, -up].map((part) => part * steep * side * 0.5);
      const shine = (slope[0] * light[0] + slope[1] * light[1] + light[2]) / Math.hypot(slope[0], slope[1], 1);
      const bright = kDark + (1 - kDark) * Math.min(Math.max(shine / light[2], 0), 1.25);
      const colour = 4 * (pixels ? at : Math.min(Math.floor(heights[at] * 256), 255));
      for (let part = 0; part < 3; ++part)
        colours[3 * at + part] = Math.min((pixels || palette)[colour + part] * bright, 255);
    }
  return { heights, colours, side, steep };
}

// How far along a line it is in the block, by one axis and those before it.
function crossed(start, direction, [enters, leaves]) {
  if (Math.abs(direction) < 1e-9) return Math.abs(start) > 0.5 ? [1, 0] : [enters, leaves];
  const ends = [(-0.5 - start) / direction, (0.5 - start) / direction];
  return [Math.max(enters, Math.min(...ends)), Math.min(leaves, Math.max(...ends))];
}

// The bytes of a picture, from the upper row on; where there is no block they are 0. `turn` is how far the block is
// turned, and `tilt` how far one looks down, in turns: 0.25 is from above. The block is in the middle of the first
// `free` columns. It sets the bytes of the columns from `begin` to `end` alone.
export function reliefOf({ heights, colours, side, steep }, { turn, tilt }, width, height, free = width,
  bytes = new Uint8ClampedArray(4 * width * height), [begin, end] = [0, width]) {
  const [sine, cosine] = [Math.sin(turn * kRound), Math.cos(turn * kRound)];
  const [down, across] = [Math.sin(tilt * kRound), Math.cos(tilt * kRound)];
  const deep = Math.SQRT2 * down + (steep + kBase) * across; // the block on the screen, in sides
  const scale = Math.min(free / (Math.SQRT2 * kMargin), height / (deep * kMargin));
  const middle = height / 2 - (steep - kBase) * 0.5 * across * scale; // the row of the block's middle, from below
  const step = 0.7 / side;
  const most = side - 1.001;
  for (let column = begin; column < Math.min(end, width); ++column) {
    const right = (column + 0.5 - free / 2) / scale;
    // The line of the block that this column shows, from the front to the back.
    const start = [right * cosine, right * sine];
    const [first, last] = crossed(start[1], cosine, crossed(start[0], -sine, [-1, 1]));
    if (first > last) continue;
    let filled = Math.max(0, Math.floor(middle + (first * down - kBase * across) * scale));
    for (let depth = first, front = true; depth <= last; depth += step, front = false) {
      const x = Math.min(Math.max((start[0] - depth * sine + 0.5) * side - 0.5, 0), most);
      const y = Math.min(Math.max((start[1] + depth * cosine + 0.5) * side - 0.5, 0), most);
      const [left, below] = [x | 0, y | 0];
      const at = below * side + left;
      const [u, v] = [x - left, y - below];
      const lower = heights[at] + (heights[at + 1] - heights[at]) * u;
      const upper = heights[at + side] + (heights[at + side + 1] - heights[at + side]) * u;
      const z = (lower + (upper - lower) * v) * steep;
      const top = Math.min(Math.floor(middle + (depth * down + z * across) * scale), height);
      if (top <= filled) continue;
      const colour = 3 * (at + (u > 0.5 ? 1 : 0) + (v > 0.5 ? side : 0));
      const [red, green, blue] = front ? kFlank : colours.subarray(colour, colour + 3);
      for (; filled < top; ++filled) {
        const to = 4 * ((height - 1 - filled) * width + column);
        bytes[to] = red;
        bytes[to + 1] = green;
        bytes[to + 2] = blue;
        bytes[to + 3] = 255;
      }
    }
  }
  return bytes;
}
