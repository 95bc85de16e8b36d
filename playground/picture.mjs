// Writes the picture of the page that the README shows, as PNG, and those of its looks beside each other, as WebP, for the
// next page: node picture.mjs PAGE.html FILE LOOKS, in the folder of tools/lib/base/javascript. tools/playground --picture
// calls this.
import { writeFile } from "node:fs/promises";
import { kForWebGl, launched, opened } from "./tests/support.mjs";

const kLink = "#sum=eroded&seed=12&octaves=8&map=land&cells=4&view=terrain";
const kDrawn = 9000; // ms: terrain is drawn step by step, and software takes seconds
const kSide = 64; // pixels of a look
const kQuality = 0.55;

const browser = await launched(kForWebGl);
try {
  const page = await opened(browser, { link: kLink, viewport: { width: 1200, height: 720 } });
  await new Promise((done) => setTimeout(done, kDrawn));
  await page.screenshot({ path: process.argv[3] });
  const looks = await opened(browser);
  const url = await looks.evaluate(
    async (side, quality) => {
      const { hashnoise } = window;
      const names = Array.from(document.querySelectorAll("#looks button"), (button) => button.textContent.trim());
      const canvas = Object.assign(document.createElement("canvas"), { width: side * names.length, height: side });
      for (const [at, name] of names.entries()) {
        hashnoise.look(name);
        await hashnoise.drawing;
        const bytes = await hashnoise.pixels(side, side);
        for (let row = 0; row < side; ++row) {
          const line = new ImageData(new Uint8ClampedArray(bytes.slice(row * side * 4, (row + 1) * side * 4)), side, 1);
          canvas.getContext("2d").putImageData(line, at * side, side - 1 - row);
        }
      }
      return canvas.toDataURL("image/webp", quality);
    },
    kSide,
    kQuality,
  );
  await writeFile(process.argv[4], Buffer.from(url.split(",")[1], "base64"));
} finally {
  await browser.close();
}
