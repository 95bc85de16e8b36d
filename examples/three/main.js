// Draws the scene that the address names, ?terrain, ?clouds or ?water, by WebGPU or else by WebGL2.
import { ACESFilmicToneMapping, PerspectiveCamera, WebGPURenderer } from "three/webgpu";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const name = ["clouds", "water"].find((one) => location.search.startsWith(`?${one}`)) ?? "terrain";
const { scene, eye, target } = await import(`./${name}.js`);
document.querySelector(`[href="?${name}"]`).setAttribute("aria-current", "page");

// ?water&webgl has no WebGPU.
export const renderer = new WebGPURenderer({ antialias: true, forceWebGL: location.search.endsWith("&webgl") });
renderer.toneMapping = ACESFilmicToneMapping;
document.body.append(renderer.domElement);
await renderer.init();

export const camera = new PerspectiveCamera(45, 1, 0.05, 200);
camera.position.set(...eye);
camera.lookAt(...target);
if (name !== "clouds") { // one does not fly around the sky
  const controls = new OrbitControls(camera, renderer.domElement);
  controls.target.set(...target);
  controls.maxPolarAngle = Math.PI * 0.49; // it stays above the ground
}

function resize() {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 1.5));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
}
addEventListener("resize", resize);
resize();
renderer.setAnimationLoop(() => renderer.render(scene, camera));
export { scene };
