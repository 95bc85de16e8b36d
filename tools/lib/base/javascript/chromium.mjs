// Chromium for tests: without a window, drawing on SwiftShader, in a profile of its own that goes when it is closed.
import { access } from "node:fs/promises";
import { delimiter, join } from "node:path";
import puppeteer from "puppeteer-core";

const options = [
  "--no-sandbox", // root has none
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--enable-unsafe-webgpu",
  "--use-webgpu-adapter=swiftshader",
  "--disable-background-networking",
  "--disable-background-timer-throttling",
  "--disable-renderer-backgrounding",
];

/** The path of the first of these programs in PATH. */
async function program(...names) {
  for (const name of names) {
    for (const folder of process.env.PATH.split(delimiter)) {
      const path = join(folder, name);
      if (await access(path, 1).then(() => true, () => false)) return path;
    }
  }
  throw new Error(`there is no ${names.join(" or ")} in PATH`);
}

/** puppeteer's browser, with WebGL2 and WebGPU. Close it. */
export async function launch({ args = [], ...others } = {}) {
  return puppeteer.launch({
    // The first is Chromium without what draws windows, which starts in less than half of the time.
    executablePath: await program("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"),
    headless: true,
    args: [...options, ...args],
    ...others,
  });
}

// chromium-headless-shell warns that a test reads pixels: that is no fault of a page.
const readsPixels = (text) => text.includes("GPU stall due to ReadPixels");

/** A page that remembers what went wrong in it: page.complaints has the errors and warnings of its console. */
export async function open(browser, url) {
  const page = await browser.newPage();
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(String(error)));
  page.on("console", (message) => {
    if (["error", "warn"].includes(message.type()) && !readsPixels(message.text())) page.complaints.push(message.text());
  });
  await page.goto(url);
  return page;
}
