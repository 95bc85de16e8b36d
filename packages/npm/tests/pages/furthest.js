// Pictures of pages, compared with what they should show.
import { Field } from "hashnoise";

export const SIDE = 64; // pixels

const field = new Field(2, { fractal: "fbm", octaves: 6, seed: 7 });
/** The light of the documentation's materials. */
export const gray = (u, v) => 0.5 + field.at(u * 8, v * 8);

/** How far the red of a picture is from that of a function, in steps of 8 bits, where that is farthest. */
export function furthest(pixels, of, { stride = 4 * SIDE, downward = false } = {}) {
  let most = 0;
  for (let y = 0; y < SIDE; ++y) {
    for (let x = 0; x < SIDE; ++x) {
      const v = (y + 0.5) / SIDE;
      const value = of((x + 0.5) / SIDE, downward ? 1 - v : v);
      most = Math.max(most, Math.abs(pixels[stride * y + 4 * x] - 255 * Math.min(Math.max(value, 0), 1)));
    }
  }
  return most;
}
