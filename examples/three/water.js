// Water: waves in space and time, with normals of the slopes that the noise returns beside its height.
import { Mesh, MeshBasicNodeMaterial, PlaneGeometry, Scene } from "three/webgpu";
import { Fn, cameraPosition, max, mix, normalize, positionLocal, positionWorld, positionWorldDirection, pow, reflect,
  smoothstep, time, vec3 } from "three/tsl";
import { hn_fbm_d3 } from "./noise.js";
import { sky, sun } from "./sky.js";

const HEIGHT = 0.35; // of a noise of 1

/** The height of the waves and its slopes; the third axis is time. */
export const waves = Fn(([p]) => hn_fbm_d3(p, 5, 2, 0.42, 7));

const moving = () => waves(vec3(positionLocal.x, positionLocal.z.mul(1.6), time.mul(0.4)));

const material = new MeshBasicNodeMaterial();
material.positionNode = vec3(positionLocal.x, moving().x.mul(HEIGHT), positionLocal.z);
material.colorNode = Fn(() => {
  const n = moving().toVar();
  const toEye = cameraPosition.sub(positionWorld);
  const distance = toEye.length();
  const view = toEye.div(distance).toVar();
  const calm = smoothstep(2, 26, distance).oneMinus().mul(0.9); // far away waves are finer than pixels
  const normal = normalize(vec3(n.y.mul(-HEIGHT).mul(calm), 1, n.z.mul(-HEIGHT * 1.6).mul(calm))).toVar();
  const mirrored = reflect(view.negate(), normal).toVar();
  const seen = sky(vec3(mirrored.x, max(mirrored.y, 0.02), mirrored.z));
  const fresnel = pow(max(normal.dot(view), 0).oneMinus(), 5).mul(0.96).add(0.04);
  const depth = mix(vec3(0.004, 0.045, 0.075), vec3(0.03, 0.20, 0.20), smoothstep(-0.3, 0.6, n.x));
  const glint = pow(max(mirrored.dot(vec3(sun)), 0), 300).mul(3);
  const color = mix(depth, seen, fresnel).add(vec3(1.0, 0.85, 0.6).mul(glint));
  return mix(sky(view.negate().mul(vec3(1, 0, 1))), color, smoothstep(15, 60, distance).oneMinus());
})();

export const scene = new Scene();
scene.add(new Mesh(new PlaneGeometry(80, 80, 300, 300).rotateX(-Math.PI / 2), material));
scene.backgroundNode = sky(positionWorldDirection);

export const eye = [3, 1.6, 6];
export const target = [0, 0.4, 0];
