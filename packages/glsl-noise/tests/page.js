// A sphere that drei's material distorts; globalThis.drawn() has its pixels at eight times. The sphere is about as large as
// a cell of the noise, so at a single time its size is chance. It moves by five cells in a unit of time: these times are
// at other places of a cell.
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
        const gl = state.gl.getContext();
        const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
        return [0.37, 0.74, 1.11, 1.48, 1.85, 2.22, 2.59, 2.96].flatMap((time) => {
          state.advance(time);
          gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, 0x1908, 0x1401, pixels);
          return Array.from(pixels);
        });
      };
      globalThis.imported = snoise;
    },
  },
  createElement("ambientLight", { intensity: 3 }),
  createElement(
    "mesh",
    {},
    createElement("sphereGeometry", { args: [0.7, 64, 64] }),
    createElement(MeshDistortMaterial, { distort: 0.9, speed: 1, color: "#ffffff" }),
  ),
);
createRoot(document.getElementById("scene")).render(scene);
