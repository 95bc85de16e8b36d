// A ball or a cube of space, seen without perspective: which of its points a pixel shows. The fragment shader computes
// that in whole numbers, so that every GPU shows the same points.
import { wrapped } from "./numbers.js";
import { kPartsOfCell, partsOf } from "./view.js";

const kRadius = 16384; // of the ball in its own units, and of a ball around the cube
const kHalfEdge = 9459; // of the cube
const kRounded = 4; // how far beyond its edges roundings may take a point of it
const kOne = 16384; // of the whole numbers by which the solid is turned
const kBitsOfOne = 14;
const kNowhere = 1048576; // farther than anything is
const kAway = 32768;
const kRadiusShown = 0.46; // the radius of the ball in shorter sides of the picture
const kTurn = 2 * Math.PI;
const kLightOfSolid = [-0.35, 0.45, 0.82]; // from where light comes: right, up, and to who looks
const kDarkSide = 0.5; // of the colour, where no light comes
const kLit = 0.5; // of it, which the light adds
const kBehind = [0.11, 0.115, 0.14]; // the colour behind the solid; the edge of a ball has some of it

// The directions to the right, up, and towards the viewer, in space. From above, x is right and y is up.
export function axesOf({ turn, tilt }) {
  const [sine, cosine] = [Math.sin(turn * kTurn), Math.cos(turn * kTurn)];
  const [down, across] = [Math.sin(tilt * kTurn), Math.cos(tilt * kTurn)];
  const axes = [[cosine, sine, 0], [-sine * down, cosine * down, across], [sine * across, -cosine * across, down]];
  return axes.map((axis) => axis.map((part) => Math.round(part * kOne)));
}

// The words of the frame: the axes, and where the middle is, in halves of pixels. The solid is in the middle of the
// first `free` columns.
export function wordsOfSolid(state, free, height) {
  const scale = Math.round((kRadius * 256) / (2 * kRadiusShown * Math.min(free, height)));
  return [...axesOf(state).flatMap((axis) => [...axis, 0]), free, height, scale, 0];
}

// {position, step}: where the corner of a cube around the ball is, and how long a unit is, in parts of a cell. A ball
// has "Cells across" on its diameter, and a cube on its edge.
export function solidPlace(state) {
  const reach = state.view === "cube" ? kHalfEdge : kRadius;
  const step = Math.max(1, Math.round((state.cells * kPartsOfCell) / (2 * reach)));
  const corner = [state.x, state.y, partsOf(state.z)].map((middle) => wrapped(middle - BigInt(step * kRadius)));
  return { position: [...corner, partsOf(state.w)], step };
}

// Which point of the solid is at a pixel, and how bright it is there: less than 0 where there is none. `ahead` is known of
// each kind of solid: how far its point is in front of the middle, and which way it faces.
const pointOf = (ahead) => `vec4 solid_at(ivec2 pixel) {
  ivec2 s = ((2 * pixel + 1 - u_solid[3].xy) * u_solid[3].z) >> uvec2(8u);
  vec4 nowhere = vec4(0.0, 0.0, 0.0, -1.0);
  if (max(abs(s.x), abs(s.y)) > ${kRadius}) return nowhere;
  ivec3 beside = s.x * u_solid[0].xyz + s.y * u_solid[1].xyz;
  ivec3 towards = u_solid[2].xyz;
${ahead}
  float light = clamp(dot(normal, vec3(${kLightOfSolid.join(", ")})), 0.0, 1.0);
  return vec4(vec3(point), ${kDarkSide} + ${kLit} * light);
}`;

const kPoints = {
  // The root of the ball is a whole number, whatever the GPU's own root is.
  sphere: pointOf(`  int rest = ${kRadius * kRadius} - s.x * s.x - s.y * s.y;
  if (rest < 0) return nowhere;
  int near = int(sqrt(float(rest)));
  if (near * near > rest) near -= 1;
  if ((near + 1) * (near + 1) <= rest) near += 1;
  ivec3 point = (beside + near * towards) >> uvec3(${kBitsOfOne}u);
  vec3 normal = vec3(ivec3(s, near)) / ${kRadius}.0;`),
  // The nearest of the cube's faces that look here. Languages round quotients below 0 in different ways, so what is
  // divided is made larger first.
  cube: pointOf(`  int near = ${kNowhere};
  int face = 0;
  int side = 0;
  for (int k = 0; k < 3; k++) {
    int facing = sign(towards[k]);
    int steep = max(abs(towards[k]), 1);
    int far = (${kHalfEdge * kOne} - facing * beside[k] + steep * ${kAway}) / steep - ${kAway};
    if (facing != 0 && far < near) { near = far; face = k; side = facing; }
  }
  if (abs(near) > ${kRadius}) return nowhere;
  ivec3 point = (beside + near * towards) >> uvec3(${kBitsOfOne}u);
  if (max(max(abs(point.x), abs(point.y)), abs(point.z)) > ${kHalfEdge + kRounded}) return nowhere;
  point = clamp(point, ivec3(-${kHalfEdge}), ivec3(${kHalfEdge}));
  point[face] = side * ${kHalfEdge};
  vec3 normal = vec3(ivec3(u_solid[0][face], u_solid[1][face], u_solid[2][face])) * (float(side) / ${kOne}.0);`),
};
const lightOf = (bits) => `vec4 solid_lit(vec4 color, float light, uvec2 pixel) {
  if (u_shown.z == ${bits}) return light < 0.0 ? vec4(1.0) : color;
  if (light < 0.0) return vec4(${kBehind.join(", ")}, 1.0);
  return mix(vec4(${kBehind.join(", ")}, 1.0), vec4(color.rgb * light, color.a), solid_part(ivec2(pixel)));
}`;
// How much of a pixel the solid has.
const kShares = {
  sphere: `float solid_part(ivec2 pixel) {
  vec2 s = vec2(2 * pixel + 1 - u_solid[3].xy);
  return clamp(${2 * kRadius * 64}.0 / float(u_solid[3].z) - 0.5 * length(s), 0.0, 1.0);
}`,
  cube: "float solid_part(ivec2 pixel) { return 1.0; }",
};
const kPlacesOfSolid = ["x", "y", "z"].map((axis) => `  uvec2 ${axis} = place_of(u_cell.${axis}, u_place.${axis}, uint(int(solid.${axis}) + ${kRadius}));`);

// The parts of the shader of a solid: functions; lines of main, which is called with a pixel `at`, up to the places of its
// point along each axis; and its lit colour. A pixel without a point has four bytes of 255 in place
// of a value, which is no number. `bits` is the mode of the frame in which pixels are values.
export function solidShader({ view }, bits) {
  const lit = (color) => `solid_lit(${color}, solid.w, at)`;
  const places = ["  vec4 solid = solid_at(ivec2(at));", `  if (solid.w < 0.0) { color = ${lit("vec4(0.0)")}; return; }`, ...kPlacesOfSolid];
  return { point: `${kPoints[view]}\n${kShares[view]}\n${lightOf(bits)}`, places: places.join("\n"), lit };
}
