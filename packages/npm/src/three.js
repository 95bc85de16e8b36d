import { ShaderChunk } from "three";
import * as parts from "./glsl/all.js";

/**
 * Lets shaders of three.js write #include <hashnoise/fbm2d>, for every file of the library. Calling it again changes
 * nothing.
 */
export function registerChunks() {
  for (const [name, text] of Object.entries(parts)) ShaderChunk[`hashnoise/${name}`] = text;
}
