import glsl from "vite-plugin-glsl";

export default {
  plugins: [glsl({ warnDuplicatedImports: false })],
  logLevel: "warn",
  build: { rollupOptions: { input: ["pages/webgl.html", "pages/webgpu.html"] }, chunkSizeWarningLimit: 4000 },
};
