// A sky with a layer of clouds, which drift and change; the sun shines through their edges.
import { BackSide, Mesh, MeshBasicNodeMaterial, Scene, SphereGeometry } from "three/webgpu";
import { Fn, exp, max, mix, positionWorldDirection, pow, smoothstep, time, vec2, vec3 } from "three/tsl";
import { hn_clouds3 } from "./noise.js";
import { sky, sun } from "./sky.js";

/** How dense the clouds are over a place of the ground, in [0, 1]. */
export const density = Fn(([p]) => hn_clouds3(p, 8, 2, 0.55, 7));

const drifting = (p) => density(vec3(p.x.add(time.mul(0.05)), p.y, time.mul(0.03)));

const material = new MeshBasicNodeMaterial({ side: BackSide });
material.colorNode = Fn(() => {
  const direction = positionWorldDirection.toVar();
  const up = max(direction.y, 0.02);
  const p = direction.xz.div(up.add(0.08)).mul(0.75).toVar(); // where the ray meets the layer, which is bent down
  const dense = drifting(p).toVar();
  const toSun = drifting(p.add(vec2(sun.x, sun.z).mul(0.2)));
  const lit = exp(dense.add(toSun.sub(dense).mul(2).max(0)).mul(-2.6)); // less, the more cloud there is before the sun
  const glow = pow(max(direction.dot(vec3(sun)), 0), 6);
  const cloud = mix(vec3(0.20, 0.25, 0.34), vec3(1.0, 0.95, 0.88).mul(glow.mul(0.9).add(1.25)), lit);
  const clear = sky(direction);
  const cover = smoothstep(0.03, 0.4, dense).mul(smoothstep(0.0, 0.22, direction.y));
  return mix(clear, cloud, cover);
})();

export const scene = new Scene();
scene.add(new Mesh(new SphereGeometry(100, 48, 24), material));

export const eye = [0, 0, 0];
export const target = [-0.35, 0.36, -1];
