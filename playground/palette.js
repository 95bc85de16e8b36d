// The 256 colours of a map.
import { kMaps } from "./tables.js";

export function paletteOf(map) {
  const stops = kMaps[map].stops.map((stop) => [0, 2, 4].map((at) => parseInt(stop.slice(at, at + 2), 16)));
  const bytes = new Uint8Array(1024);
  for (let i = 0; i < 256; ++i) {
    const at = (i / 255) * (stops.length - 1);
    const below = Math.min(Math.floor(at), stops.length - 2);
    for (let part = 0; part < 3; ++part) {
      const [from, to] = [stops[below][part], stops[below + 1][part]];
      bytes[4 * i + part] = Math.round(from + (to - from) * (at - below));
    }
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

export const gradientOf = (map) => `linear-gradient(90deg, ${kMaps[map].stops.map((stop) => `#${stop}`).join(", ")})`;
