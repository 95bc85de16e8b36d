// Islands: a plane whose height is eroded noise, coloured by its height and by its slope.
import { DirectionalLight, HemisphereLight, Mesh, MeshStandardNodeMaterial, PlaneGeometry, Scene } from "three/webgpu";
import { Fn, fog, mix, normalize, positionLocal, positionWorld, positionWorldDirection, rangeFogFactor, smoothstep,
  transformNormalToView, vec2, vec3 } from "three/tsl";
import { hn_eroded2, hn_fbm2 } from "./noise.js";
import { sky, sun } from "./sky.js";

const OCTAVES = 10;
const HEIGHT = 2.2; // of a noise of 1

/** How high the land is, before it is stretched; 0 is the sea. */
export const height = Fn(([p]) => hn_eroded2(p.mul(0.375), OCTAVES, 2, 0.5, 1, 7));

const land = (p) => height(p).mul(HEIGHT);
const normalAt = (p) => {
  const step = 0.01;
  const here = land(p);
  const east = land(p.add(vec2(step, 0))).sub(here);
  const south = land(p.add(vec2(0, step))).sub(here);
  return normalize(vec3(east.negate(), step, south.negate()));
};

const material = new MeshStandardNodeMaterial({ roughness: 1 });
material.positionNode = vec3(positionLocal.x, land(positionLocal.xz), positionLocal.z);
const normal = normalAt(positionLocal.xz);
material.normalNode = transformNormalToView(normal);
material.colorNode = Fn(() => {
  const p = positionWorld.xz;
  const rough = hn_fbm2(p.mul(6), 4, 2, 0.5, 8); // borders are not straight
  const y = positionWorld.y.add(rough.mul(0.12));
  const flat = normal.y.add(rough.mul(0.1));
  const grass = mix(vec3(0.13, 0.21, 0.06), vec3(0.22, 0.24, 0.09), rough.add(0.5));
  const rock = mix(vec3(0.20, 0.17, 0.15), vec3(0.32, 0.29, 0.26), rough.add(0.5));
  const sand = mix(vec3(0.10, 0.22, 0.22), vec3(0.55, 0.46, 0.30), smoothstep(-0.1, 0.0, y));
  const ground = mix(sand, grass, smoothstep(0.02, 0.06, y));
  const sunk = smoothstep(-0.05, 0.05, y).oneMinus(); // the sea hides rocks
  const hills = mix(rock, ground, smoothstep(0.62, 0.78, flat).max(sunk));
  return mix(hills, vec3(0.9, 0.92, 0.95), smoothstep(0.62, 0.85, y).mul(smoothstep(0.5, 0.7, flat)));
})();

const water = new MeshStandardNodeMaterial({ color: 0x0b2f42, roughness: 0.3, transparent: true });
water.opacityNode = smoothstep(-0.12, 0.0, land(positionLocal.xz)).oneMinus().mul(0.97); // shallow water is clear

export const scene = new Scene();
const plane = new PlaneGeometry(24, 24, 300, 300).rotateX(-Math.PI / 2);
scene.add(new Mesh(plane, material), new Mesh(new PlaneGeometry(60, 60).rotateX(-Math.PI / 2), water));
const light = new DirectionalLight(0xfff0dd, 4);
light.position.copy(sun);
scene.add(light, new HemisphereLight(0xbcd4f0, 0x55504a, 0.9));
scene.backgroundNode = sky(positionWorldDirection);
scene.fogNode = fog(vec3(0.44, 0.58, 0.76), rangeFogFactor(7, 22));

export const eye = [2.5, 2.6, 7.5];
export const target = [0, 0.2, 0];
