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
const kRadiusShown = 0.46; // the radius of the ball in shorter sides of the picture
const kTurn = 2 * Math.PI;
const kLightOfSolid = [-0.35, 0.45, 0.82]; // from where light comes: right, up, and to who looks
const kDarkSide = 0.5; // of the colour, where no light comes
const kLit = 0.5; // of it, which the light adds
const kBehind = [0.11, 0.115, 0.14]; // the colour behind the solid

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

// Which point of the solid is at a pixel, if there is one, and how bright it is there. `ahead` is known of each
// kind of solid: how far its point is in front of the middle, and which way it faces.
const glslPoint = (ahead) => `bool solid_at(ivec2 pixel, out ivec3 point, out float light) {
  ivec2 s = ((2 * pixel + 1 - u_solid[3].xy) * u_solid[3].z) >> 8;
  if (max(abs(s.x), abs(s.y)) > ${kRadius}) return false;
  ivec3 beside = s.x * u_solid[0].xyz + s.y * u_solid[1].xyz;
  ivec3 towards = u_solid[2].xyz;
  vec3 normal;
${ahead}
  light = ${kDarkSide} + ${kLit} * clamp(dot(normal, vec3(${kLightOfSolid.join(", ")})), 0.0, 1.0);
  return true;
}`;
const wgslPoint = (ahead) => `
fn solid_at(pixel: vec2i, point: ptr<function, vec3i>, light: ptr<function, f32>) -> bool {
  let s = ((2 * pixel + 1 - u.solid[3].xy) * u.solid[3].z) >> vec2u(8u);
  if (max(abs(s.x), abs(s.y)) > ${kRadius}) { return false; }
  let beside = s.x * u.solid[0].xyz + s.y * u.solid[1].xyz;
  let towards = u.solid[2].xyz;
  var normal: vec3f;
${ahead}
  *light = ${kDarkSide} + ${kLit} * clamp(dot(normal, vec3f(${kLightOfSolid.join(", ")})), 0.0, 1.0);
  return true;
}`;

// The root of the ball is a whole number, whatever the GPU's own root is.
const kGlslBall = `  int rest = ${kRadius * kRadius} - s.x * s.x - s.y * s.y;
  if (rest < 0) return false;
  int near = int(sqrt(float(rest)));
  if (near * near > rest) --near;
  if ((near + 1) * (near + 1) <= rest) ++near;
  point = (beside + near * towards) >> ${kBitsOfOne};
  normal = vec3(s, near) / ${kRadius}.0;`;
const kWgslBall = `  let rest = ${kRadius * kRadius} - s.x * s.x - s.y * s.y;
  if (rest < 0) { return false; }
  var near = i32(sqrt(f32(rest)));
  if (near * near > rest) { near -= 1; }
  if ((near + 1) * (near + 1) <= rest) { near += 1; }
  *point = (beside + near * towards) >> vec3u(${kBitsOfOne}u);
  normal = vec3f(vec3i(s, near)) / ${kRadius}.0;`;

// Of the cube's faces that look here the nearest one. Languages round quotients below 0 in different ways, so what is
// divided is made larger first.
const kAway = 32768;
const kGlslCube = `  int near = ${kNowhere};
  int face = 0;
  int side = 0;
  for (int k = 0; k < 3; ++k) {
    int facing = sign(towards[k]);
    int steep = max(abs(towards[k]), 1);
    int far = (${kHalfEdge * kOne} - facing * beside[k] + steep * ${kAway}) / steep - ${kAway};
    if (facing != 0 && far < near) { near = far; face = k; side = facing; }
  }
  if (abs(near) > ${kRadius}) return false;
  point = (beside + near * towards) >> ${kBitsOfOne};
  if (max(max(abs(point.x), abs(point.y)), abs(point.z)) > ${kHalfEdge + kRounded}) return false;
  point = clamp(point, ivec3(-${kHalfEdge}), ivec3(${kHalfEdge}));
  point[face] = side * ${kHalfEdge};
  normal = vec3(u_solid[0][face], u_solid[1][face], u_solid[2][face]) * (float(side) / ${kOne}.0);`;
const kWgslCube = `  var near = ${kNowhere};
  var face = 0;
  var side = 0;
  for (var k = 0; k < 3; k++) {
    let facing = sign(towards[k]);
    let steep = max(abs(towards[k]), 1);
    let far = (${kHalfEdge * kOne} - facing * beside[k] + steep * ${kAway}) / steep - ${kAway};
    if (facing != 0 && far < near) { near = far; face = k; side = facing; }
  }
  if (abs(near) > ${kRadius}) { return false; }
  var found = (beside + near * towards) >> vec3u(${kBitsOfOne}u);
  if (max(max(abs(found.x), abs(found.y)), abs(found.z)) > ${kHalfEdge + kRounded}) { return false; }
  found = clamp(found, vec3i(-${kHalfEdge}), vec3i(${kHalfEdge}));
  found[face] = side * ${kHalfEdge};
  *point = found;
  normal = vec3f(vec3i(u.solid[0][face], u.solid[1][face], u.solid[2][face])) * (f32(side) / ${kOne}.0);`;

const kBehindIt = `${kBehind.join(", ")}, 1.0`;
const kSolidPlaces = {
  glsl: (bits) => `  ivec3 point;
  float light;
  if (!solid_at(ivec2(at), point, light)) {
    color = u_shown.z == ${bits} ? vec4(1.0) : vec4(${kBehindIt});
    return;
  }
  uvec2 x = place_of(u_cell.x, u_place.x, uint(point.x + ${kRadius}));
  uvec2 y = place_of(u_cell.y, u_place.y, uint(point.y + ${kRadius}));
  uvec2 z = place_of(u_cell.z, u_place.z, uint(point.z + ${kRadius}));`,
  wgsl: (bits) => `  var point: vec3i;
  var light: f32;
  if (!solid_at(vec2i(at), &point, &light)) {
    return select(vec4f(${kBehindIt}), vec4f(1.0), u.shown.z == ${bits});
  }
  let x = place_of(u.cell.x, u.place.x, u32(point.x + ${kRadius}));
  let y = place_of(u.cell.y, u.place.y, u32(point.y + ${kRadius}));
  let z = place_of(u.cell.z, u.place.z, u32(point.z + ${kRadius}));`,
};
const kPoints = {
  glsl: { sphere: glslPoint(kGlslBall), cube: glslPoint(kGlslCube) },
  wgsl: { sphere: wgslPoint(kWgslBall), cube: wgslPoint(kWgslCube) },
};
const kLitColours = {
  glsl: (bits) => `u_shown.z == ${bits} ? vec4(1.0) : vec4(vec3(light), 1.0)`,
  wgsl: (bits) => `select(vec4f(vec3f(light), 1.0), vec4f(1.0), u.shown.z == ${bits})`,
};

// The parts of the shader of a solid: a function; lines of main, which is called with a pixel `at`, up to the places of its
// point along each axis; and what its colour is multiplied by. A pixel without a point has four bytes of 255 in place
// of a value, which is no number. `bits` is the mode of the frame in which pixels are values.
export const solidShader = (language, { view }, bits) => ({
  point: kPoints[language][view],
  places: kSolidPlaces[language](bits),
  light: kLitColours[language](bits),
});
