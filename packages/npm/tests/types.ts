// tsc checks the package: each line below a @ts-expect-error is an error, and no other is.
import { ivec2, uv, vec3 } from "three/tsl";
import { Field, init, type Settings } from "hashnoise";
import fbm2d from "hashnoise/glsl/fbm2d";
import noise2d from "hashnoise/glsl/noise2d";
import included from "hashnoise/glsl/fbm2d.glsl";
import everything from "hashnoise/hashnoise.glsl?raw";
import { registerChunks } from "hashnoise/three";
import { hn_fbm2, hn_fbm2_place, hn_perlin_d2, hn_tile2, hn_warp2 } from "hashnoise/tsl";
import { hn_lattice2 } from "hashnoise/tsl/fixed";
import { hn_cellular2, wgsl } from "hashnoise/wgsl";
import { hn_fbm3 } from "hashnoise/wgsl/fixed";

const settings: Settings = { fractal: "eroded", noise: "simplex_d", period: [4, 8], strength: 2 };
const field = new Field(2, settings);
export const heights: Float32Array = field.grid([4, 4], { step: 0.5, cell: [1, 2] });
export const height: number = field.at(1, 2) + field.inCell([1, 2], [0, 0.5]);
export const several: number[] = [...field.all(1, 2), ...field.points([[1], [2]], { cells: [[1], [2]] })];
export const started: Promise<void> = init();
export const text: string = fbm2d + noise2d + included + everything + wgsl(hn_cellular2, hn_fbm3);
export const color = vec3(hn_fbm2(uv().mul(8), 6, 2, 0.5).add(0.5)).add(hn_perlin_d2(uv(), 7).mul(0.1));
export const tile = hn_fbm2_place(hn_tile2(uv().mul(8), ivec2(8, 8)), 6, 2, 0.5, 7);
export const shift = hn_warp2(uv(), 6, 2, 0.5, 1, 7);
export const tiled = new Field(2, { period: new Int32Array([4, 8]) }).points([new Float64Array(1), [0]]);
const pairs: [number, number][] = [[0.5, 0.25], [0.75, 0.125]];
export const named = [
  field.points({ x: [0, 1], y: new Float32Array(2) }), field.points({ xy: pairs }, { cells: { xy: pairs } }),
  new Field(3).points({ xyz: new Float32Array(9) }),
];
export const part: Float32Array = field.grid([4, 4], { step: 0.1, first: [-4, 4] });
export const ahead: Promise<void> = init(new WebAssembly.Module(new Uint8Array(8)));
registerChunks();

// @ts-expect-error there is no such noise
new Field(2, { noise: "perlim" });
// @ts-expect-error nor such a setting
new Field(2, { octave: 6 });
// @ts-expect-error nor a fifth dimension
new Field(5);
// @ts-expect-error a grid has a step
field.grid([4, 4]);
// @ts-expect-error the axes have other names
field.points({ u: [1], v: [2] });
// @ts-expect-error a height is a number
export const wrong: string = field.at(1, 2);
// @ts-expect-error the text is a string
export const wrongText: number = fbm2d;
// @ts-expect-error a position is a vector
hn_fbm2(1, 6, 2, 0.5);
// @ts-expect-error the octaves are missing
hn_fbm2(uv());
// @ts-expect-error behind an amplitude the seed cannot be left out
hn_warp2(uv(), 6, 2, 0.5, 7);
// @ts-expect-error nor is it a place
hn_fbm2_place(uv(), 6, 2, 0.5, 7);
// @ts-expect-error a cell is of integers
hn_lattice2(uv());
// @ts-expect-error a name is not a definition
wgsl("hn_fbm2");
