// How long drawing takes. Whoever draws waits some milliseconds for any picture, however small; so what a pixel adds is
// the difference between two pictures.

const kSmall = 64; // pixels
const kFirst = 4096;
const kGrowth = 4;
const kClear = 8; // milliseconds between two pictures that show what a pixel costs

export class Speed {
  // `wait` is what any picture takes, in milliseconds, and `pixel` what each pixel adds.
  constructor(wait, pixel) {
    this.wait = wait;
    this.pixel = pixel;
  }

  // `time` draws a picture of so many pixels, and returns how many milliseconds that took. None has more than `most`.
  static async measured(time, most) {
    await time(kSmall); // at which some drivers still compile
    const wait = Math.min(await time(kSmall), await time(kSmall));
    for (let pixels = kFirst; ; pixels *= kGrowth) {
      const count = Math.min(pixels, most);
      const once = await time(count);
      if (once - wait < kClear && count < most) continue;
      // Other work of the machine only adds time.
      const more = Math.min(once, await time(count)) - wait;
      if (more >= kClear || count >= most) return new Speed(wait, Math.max(more, 0) / Math.max(count - kSmall, 1));
    }
  }

  // Learns from a picture: the settings matter, too, as more octaves take longer. Few pixels show little of them,
  // if it takes about as long as any picture: the last strip of one may be a single row.
  learn(pixels, milliseconds) {
    this.wait = Math.min(this.wait, milliseconds);
    const told = milliseconds - this.wait;
    const most = Math.max(told, this.pixel * pixels);
    if (most <= 0) return;
    const weight = (0.5 * most) / (most + this.wait);
    this.pixel += weight * (told / pixels - this.pixel);
  }

  // How many pixels take so long, without the wait.
  pixelsIn(milliseconds) {
    return this.pixel > 0 ? milliseconds / this.pixel : Infinity;
  }
}
