// Where the picture is. Positions are whole numbers of parts of a cell, so that a pixel's cell and its place in the
// cell are exact, however far out.
import { kParts, wrapped } from "./numbers.js";

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

export const cellOf = (parts) => Number(BigInt.asIntN(32, parts >> 24n));
export const placeOf = (parts) => Number(parts & (kParts - 1n));

// A coordinate of a slice as parts.
export const partsOf = (number) => wrapped(BigInt(Math.round(number * kPartsOfCell)));

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
  const cells = Number(Math.min(Math.max(state.cells * factor, limits.from), limits.to).toPrecision(6));
  const moved = stepOf(state, width, height) - stepOf({ ...state, cells }, width, height);
  return {
    cells,
    x: wrapped(state.x + BigInt(Math.round(right * moved))),
    y: state.dimensions === 1 ? state.y : wrapped(state.y + BigInt(Math.round(up * moved))),
  };
}
