// Where the picture is. Positions are whole numbers of parts of a cell, so that a pixel's cell and its place in the
// cell are exact, however far out.
import { kParts, scaleWithin, wrapped } from "./numbers.js";

export const kPartsOfCell = Number(kParts);

// Tiles along the shorter side of the picture, where it has some.
const kTiles = 3;
const kNoTile = 1 << 24; // pixels, more than any picture has

// How many cells the shorter side of the picture has.
export const cellsAcross = (state) => (state.view === "tiles" ? kTiles * state.period : state.cells);

// How many pixels a tile has on a side. Its pixels are those of the first one, so that one sees whether it has a seam.
export const tileOf = (state, width, height) =>
  state.view === "tiles" ? Math.ceil(Math.min(width, height) / kTiles) : kNoTile;

// The distance between two pixels, in parts.
export function stepOf(state, width, height) {
  const step =
    state.view === "tiles" ? state.period / tileOf(state, width, height) : state.cells / Math.min(width, height);
  return Math.max(1, Math.round(step * kPartsOfCell));
}

// The position of the pixel in the lower left corner; the middle of the picture is at x and y.
export function originOf(state, width, height) {
  const step = BigInt(stepOf(state, width, height));
  const tile = tileOf(state, width, height);
  const before = (side) => step * BigInt((side >> 1) % tile);
  return [wrapped(state.x - before(width)), wrapped(state.y - before(height))];
}

// The rows of a rotation, which leans the slice towards the diagonal of the cells, in whole numbers of 1/16384. So a position
// is whole, too, and the same everywhere.
const kWhole14 = 16384;
export function leaningRows({ lean }) {
  const [sine, cosine] = [Math.sin(lean * 2 * Math.PI), Math.cos(lean * 2 * Math.PI)];
  const [near, far, up] = [(1 + cosine) / 2, (cosine - 1) / 2, sine * Math.SQRT1_2];
  return [[near, far, up], [far, near, up], [-up, -up, cosine]].map((row) => row.map((part) => Math.round(part * kWhole14)));
}
export const leaningNumbers = (state) => leaningRows(state).map((row) => row.map((part) => part / kWhole14));

// Where a position of the picture is in space.
export const leant = (state, [x, y, z, w]) => [
  ...leaningRows(state).map(([a, b, c]) => wrapped((x * BigInt(a) + y * BigInt(b) + z * BigInt(c)) >> 14n)), w,
];

// The distances between two pixels to the right and upwards, each along three axes.
export const leaningSteps = (state, step) =>
  [0, 1].map((way) => leaningRows(state).map((row) => BigInt(Math.round((row[way] * step) / kWhole14))));

export const cellOf = (parts) => Number(BigInt.asIntN(32, parts >> 24n));
export const placeOf = (parts) => Number(parts & (kParts - 1n));

// A coordinate of a slice as parts.
export const partsOf = (number) => wrapped(BigInt(Math.round(number * kPartsOfCell)));

// How far from the place of a pixel a layer is read, since it has drifted the other way.
export const shiftOf = ({ time }, { driftx, drifty, driftz }) => [driftx, drifty, driftz, 0].map((speed) => partsOf(-speed * time));

// The position of a pixel, counted from the lower left corner.
export function positionOfPixel(state, width, height, column, row) {
  const step = BigInt(stepOf(state, width, height));
  const tile = tileOf(state, width, height);
  const [x, y] = originOf(state, width, height);
  return [wrapped(x + step * BigInt(column % tile)), wrapped(y + step * BigInt(row % tile))];
}

// The state after a drag by so many pixels of a picture of this size.
export function panned(state, width, height, right, up) {
  const step = stepOf(state, width, height);
  return {
    x: wrapped(state.x - BigInt(Math.round(right * step))),
    y: state.dimensions === 1 ? state.y : wrapped(state.y - BigInt(Math.round(up * step))),
  };
}

// The state with `factor` times the cells, where what is at this pixel, counted from the middle, stays there.
export function zoomed(state, width, height, factor, right, up, limits) {
  const cells = scaleWithin(state.cells * factor, limits);
  const moved = stepOf(state, width, height) - stepOf({ ...state, cells }, width, height);
  return {
    cells,
    x: wrapped(state.x + BigInt(Math.round(right * moved))),
    y: state.dimensions === 1 ? state.y : wrapped(state.y + BigInt(Math.round(up * moved))),
  };
}
