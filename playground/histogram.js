// The histogram of the values, and the mask of the layer that the panel shows: how much it counts.
import { byId } from "./elements.js";
import { chosen, easeAround, easeOf, maskState, rangeOf, settingsOf } from "./model.js";
import { gradientOf } from "./palette.js";
import { kBits } from "./shaders.js";
import { coveredBy, edgeIn, histogramOf, percent, summaryOf, wordsOf } from "./values.js";

const kSampled = 48; // pixels on the shorter side, whose values the page summarizes

export class Histogram {
  constructor(page) {
    this.page = page;
    this.masking = false;
    byId("mask").addEventListener("click", () => {
      this.masking = !this.masking;
      page.take(page.state);
    });
  }

  // The state that draws the mask, while the button shows it.
  get mask() {
    return this.masking ? maskState(this.page.state, this.page.controls.layer) : undefined;
  }

  offerMask() {
    const hasMask = Boolean(maskState(this.page.state, this.page.controls.layer));
    byId("row-ease").hidden = !hasMask;
    this.masking &&= hasMask;
    byId("mask").ariaPressed = String(this.masking);
  }

  // Where a layer counts follows from the values that decide it, in the step of the choice.
  async ease(at, key) {
    const { page } = this;
    const { layers } = page.state;
    const values = await this.deciding(at);
    if (!values?.length || JSON.stringify(layers) !== JSON.stringify(page.state.layers)) return;
    const next = chosen(page.state, easeAround(values), at);
    page.steps.note(page.state, next, key, true);
    page.take(next);
  }

  // How the values of the picture are distributed; or, while the mask is shown, those that decide it.
  async draw() {
    const { state, seen, controls } = this.page;
    const deciding = await this.deciding(controls.layer);
    const values = seen.masks ? deciding : await this.sampled(seen);
    if (state !== this.page.state) return;
    let [range, colours] = [rangeOf(seen), gradientOf(seen)];
    if (deciding) {
      const ease = easeOf(settingsOf(state, controls.layer));
      const { least, greatest } = summaryOf(deciding, [0, 1]);
      byId("covered").textContent = `Counts on ${percent(coveredBy(deciding, ease))}`;
      controls.showEnds(least, greatest);
      if (seen.masks) [range, colours] = [[least, greatest], edgeIn([least, greatest], ease)];
    }
    const summary = summaryOf(values, range);
    const { words, shape } = histogramOf(summary);
    const sentences = wordsOf(summary, range);
    byId("values").textContent = seen.masks ? `${sentences.split(". ")[0]}. They decide where the layer counts.` : sentences;
    byId("histogram").setAttribute("aria-label", words);
    byId("bars").style.clipPath = shape;
    byId("bars").style.background = colours;
  }

  // The values of some pixels. Beside a solid there are none.
  async sampled(state) {
    const [width, height] = this.page.size;
    const scale = kSampled / Math.min(width, height);
    const size = [width, height].map((side) => Math.min(Math.round(side * scale), 4 * kSampled));
    const bytes = await this.page.pixels(...size, kBits, state);
    return new Float32Array(bytes.buffer).filter((value) => !Number.isNaN(value));
  }

  // The values that decide how much a layer counts; nothing for a layer that has none.
  async deciding(at) {
    const state = maskState(this.page.state, at, true);
    return state && (await this.sampled(state)).map((part) => 16 * part - 8);
  }
}
