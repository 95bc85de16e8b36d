// Writes the pictures of the looks of a page beside each other, FILE.webp, or the picture of the page that the README shows,
// FILE.png: node picture.mjs PAGE.html FILE, in the folder of tools/lib/base/javascript. tools/playground --picture calls it.
import { writeFile } from "node:fs/promises";
import { kForWebGl, launched, opened } from "./tests/support.mjs";

const kSide = 64; // pixels of a look
const kQuality = 0.55;

async function photographed(browser, file) {
  const page = await opened(browser, { link: "", viewport: { width: 1200, height: 720 } });
  await page.waitForFunction(() => !window.hashnoise.moves && window.hashnoise.coarse === 1 && !window.hashnoise.drawing, { timeout: 300000 });
  await page.screenshot({ path: file });
}

async function drawn(browser, file) {
  const looks = await opened(browser);
  const url = await looks.evaluate(
    async (side, quality) => {
      const { hashnoise } = window;
      const names = Array.from(document.querySelectorAll("#looks button"), (button) => button.textContent.trim());
      const canvas = Object.assign(document.createElement("canvas"), { width: side * names.length, height: side });
      for (const [at, name] of names.entries()) {
        hashnoise.look(name);
        await hashnoise.drawing;
        // Four by four pixels become one. The lower row comes first.
        const large = new OffscreenCanvas(4 * side, 4 * side);
        const bytes = new Uint8ClampedArray(await hashnoise.pixels(large.width, large.height));
        large.getContext("2d").putImageData(new ImageData(bytes, large.width, large.height), 0, 0);
        const context = canvas.getContext("2d");
        Object.assign(context, { imageSmoothingQuality: "high" }).setTransform(1, 0, 0, -1, 0, side);
        context.drawImage(large, at * side, 0, side, side);
      }
      return canvas.toDataURL("image/webp", quality);
    },
    kSide,
    kQuality,
  );
  await writeFile(file, Buffer.from(url.split(",")[1], "base64"));
}

const browser = await launched(kForWebGl);
try {
  const [, , , file] = process.argv;
  await (file.endsWith(".webp") ? drawn : photographed)(browser, file);
} finally {
  await browser.close();
}
