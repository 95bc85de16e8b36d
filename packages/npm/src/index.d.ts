/** The kind of a field: a noise, or a fractal: octaves of a noise. A setting that the function does not have is an error. */
export interface Settings {
  /** "fbm", "ridged", ...; the noise itself if it is left out. */
  fractal?: FractalName;
  /** 0 to 2^32 - 1; 0 if it is left out. */
  seed?: number;
  /** After how many cells the field repeats, along all axes or along each; 0 for never. */
  period?: number | ArrayLike<number>;
  // tools/pack npm: settings
}

// tools/pack npm: names

/**
 * The coordinates of many points: `{ x, y }`, an array for each axis, all of the same length; or by the joined names,
 * `{ xy }`, an array of points, or their numbers one behind the other, such as those of three.js's attributes. Arrays
 * are typed or not.
 */
export interface Coordinates {
  x?: ArrayLike<number>;
  y?: ArrayLike<number>;
  z?: ArrayLike<number>;
  xy?: ArrayLike<number> | readonly ArrayLike<number>[];
  xyz?: ArrayLike<number> | readonly ArrayLike<number>[];
}

/** A noise or a fractal in one, two or three dimensions, with the bits of HN_FIXED. Its settings do not change. */
export declare class Field {
  constructor(dimensions: 1 | 2 | 3, settings?: Settings);

  readonly dimensions: 1 | 2 | 3;
  /** The numbers at a point: "value", or also "dx" and so on. */
  readonly components: readonly string[];

  /** The names of the noises that there are in so many dimensions. */
  static noises(dimensions: 1 | 2 | 3): NoiseName[];
  /** The names of the fractals that there are in so many dimensions. */
  static fractals(dimensions: 1 | 2 | 3): FractalName[];

  /**
   * The first component at a position, in cells. From 2^23 on a float has no fraction, and from 2^31 on a position counts
   * as the last cell before it: far out use inCell, and cells of points and grid.
   */
  at(...position: number[]): number;
  /** All components at a position. */
  all(...position: number[]): number[];

  /** The first component in a cell, at a fraction in it from 0 to 1 along each axis: exact however far out. */
  inCell(cell: number | ArrayLike<number>, fraction: number | ArrayLike<number>): number;
  /** All components there. */
  allInCell(cell: number | ArrayLike<number>, fraction: number | ArrayLike<number>): number[];

  /**
   * The values at many positions: an array of coordinates for each axis, typed or not, all of the same length. With
   * `cells`, arrays of whole numbers, the coordinates are the fractions in those. All first components come first, then
   * all second ones. As many points as axes might be meant otherwise, so these are an error: pass { x, y } or { xy }.
   */
  points(
    coordinates: readonly ArrayLike<number>[],
    options?: { cells?: readonly ArrayLike<number>[]; out?: Float32Array },
  ): Float32Array;
  points(
    coordinates: Coordinates,
    options?: { cells?: Coordinates | readonly ArrayLike<number>[]; out?: Float32Array },
  ): Float32Array;

  /**
   * A uniform grid of size[0] by size[1] points and so on, from `origin` on, `step` cells apart; x is the fastest. With
   * a `cell` the origin is the fraction in it, and the grid is exact however far out. With `first`, the number of the
   * first point along each axis, which may be negative, it is that part of a larger grid, and has its bits.
   */
  grid(
    size: number | ArrayLike<number>,
    options: {
      step: number | ArrayLike<number>;
      origin?: number | ArrayLike<number>;
      cell?: number | ArrayLike<number>;
      first?: number | ArrayLike<number>;
      out?: Float32Array;
    },
  ): Float32Array;
}

/**
 * Compiles the module ahead of the first field, beside other work. Pages for old browsers have to call it: Chromium
 * until 2023 compiles no more than 4 kB at once there. A host that compiles no module while it runs passes the one of
 * "hashnoise/field.wasm", which it has compiled.
 */
export declare function init(module?: WebAssembly.Module): Promise<void>;
