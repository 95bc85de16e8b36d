// A sphere that drei's material distorts, without movement; globalThis.drawn() has its pixels.
import { Canvas } from "@react-three/fiber";
import { MeshDistortMaterial } from "@react-three/drei";
import { createElement } from "react";
import { createRoot } from "react-dom/client";
import snoise from "glsl-noise/simplex/3d.glsl?raw";

const scene = createElement(
  Canvas,
  {
    flat: true,
    frameloop: "never",
    camera: { position: [0, 0, 2.5] },
    onCreated: (state) => {
      globalThis.drawn = () => {
        state.advance(0);
        const { drawingBufferWidth: width, drawingBufferHeight: height } = state.gl.getContext();
        const pixels = new Uint8Array(4 * width * height);
        state.gl.getContext().readPixels(0, 0, width, height, 0x1908, 0x1401, pixels);
        return Array.from(pixels);
      };
      globalThis.imported = snoise;
    },
  },
  createElement("ambientLight", { intensity: 3 }),
  createElement(
    "mesh",
    {},
    createElement("sphereGeometry", { args: [0.7, 64, 64] }),
    createElement(MeshDistortMaterial, { distort: 0.9, speed: 0, color: "#ffffff" }),
  ),
);
createRoot(document.getElementById("scene")).render(scene);
