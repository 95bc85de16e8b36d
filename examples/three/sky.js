// A clear sky, which all scenes have: what light comes from a direction.
import { Vector3 } from "three/webgpu";
import { Fn, max, mix, pow, vec3 } from "three/tsl";

export const sun = new Vector3(-0.62, 0.42, -0.66).normalize();

export const sky = Fn(([direction]) => {
  const height = max(direction.y, 0);
  const toSun = max(direction.dot(vec3(sun)), 0);
  const blue = mix(vec3(0.44, 0.58, 0.76), vec3(0.06, 0.20, 0.52), pow(height, 0.5));
  return blue.add(vec3(1.0, 0.72, 0.42).mul(pow(toSun, 8).mul(0.28)))
    .add(vec3(1.0, 0.92, 0.75).mul(pow(toSun, 900).mul(6)));
});
