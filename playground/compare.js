// Two settings side by side: the left half of the picture is of the setting that was kept, at the place and the scale of the
// other one.
import { byId } from "./elements.js";
import { turned } from "./files.js";
import { isTurned } from "./model.js";
import { frameOf, kColours } from "./shaders.js";

export class Comparison {
  constructor(page) {
    this.page = page;
    this.kept = undefined;
    byId("compare").addEventListener("click", () => this.toggle());
    byId("exchange").addEventListener("click", () => this.exchange());
  }

  toggle() {
    this.kept = this.kept ? undefined : this.page.state;
    byId("compare").setAttribute("aria-pressed", String(Boolean(this.kept)));
    byId("exchange").hidden = !this.kept;
    byId("picture-kept").hidden = true;
    if (!this.kept) return;
    this.page.notice("On the left the setting stays as it is now; on the right you go on.");
    this.draw().catch(() => {});
  }

  // The two settings change places: you go on with the kept one.
  exchange() {
    const { state } = this.page;
    const { x, y, cells } = state;
    const next = { ...this.kept, x, y, cells };
    this.kept = state;
    this.page.replace(next, "The two settings have changed places.");
  }

  // After the picture itself, when it rests.
  async draw() {
    const { page, kept } = this;
    const canvas = byId("picture-kept");
    if (!kept || isTurned(page.state) || isTurned(kept)) {
      canvas.hidden = true;
      return;
    }
    const { x, y, cells } = page.state;
    const state = { ...kept, x, y, cells, view: "plane" };
    const [width, height] = page.size.map((side) => Math.max(1, side >> 1));
    const program = await page.program(state);
    page.usePalette(state);
    const frame = frameOf(state, width, height, kColours);
    const bytes = await page.gpu.read(program, frame, width, height);
    if (this.kept !== kept) return;
    const image = new ImageData(new Uint8ClampedArray(turned(bytes, width)), width, height);
    Object.assign(canvas, { width, height, hidden: false });
    canvas.getContext("2d").putImageData(image, 0, 0);
  }
}
