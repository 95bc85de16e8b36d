// Shared by the tests of input: pages, keys, and everything seen and heard.
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { kForWebGl, launched, opened, pixels } from "./support.mjs";

// A pixel of the picture has eight on a side of the page, since most tests are not about the picture.
export const kLaptop = { width: 1280, height: 720, deviceScaleFactor: 0.125 };
export const settled = 400; // milliseconds, after which the link is written

export const kThorough = Boolean(process.env.HN_THOROUGH);

// A picture of 360 x 260 pixels, with the panel on it.
export const kPane = { width: 720, height: 520, deviceScaleFactor: 0.5 };

// Keeps copied texts, without a clipboard.
export const keepCopies = () => {
  window.copies = [];
  Object.defineProperty(navigator, "clipboard", {
    value: { writeText: async (text) => void window.copies.push(text) },
  });
};
export const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
export const focused = (page) =>
  page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim());

export async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
}

// By Tab alone from where the focus is, to the control of this name; fails after a whole round.
export async function tabTo(page, id) {
  for (let i = 0; i < 120; ++i) {
    await page.keyboard.press("Tab");
    if ((await focused(page)) === id) return;
  }
  assert.fail(`Tab does not lead to ${id}`);
}

// The text of an element; nothing if nobody sees it.
export const visibleText = (page, id) =>
  page.$eval(`#${id}`, (shown) => (shown.checkVisibility() ? shown.textContent : ""));

// The screen, as a PNG.
export const screenshot = (page) => page.screenshot({ encoding: "base64" });

// As bytes of pixels. Megabytes of them take a second to come here.
export const pixelsOf = (page, png) => page.evaluate(async (text) => Array.from(await window.bytesOf(text)), png);

// Decodes a PNG in the page.
export const decoding = () => {
  window.bytesOf = async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height).data;
  };
};

// One page for several tests, since to open one takes long: with the state of this link.
let shared;
export async function shownOnShared(link = "") {
  shared ??= await opened(browser, { viewport: kLaptop });
  await shared.evaluate((hash) => {
    window.hashnoise.play(false);
    history.replaceState(null, "", location.pathname + hash);
    window.dispatchEvent(new HashChangeEvent("hashchange"));
    return window.hashnoise.drawing;
  }, link);
  assert.deepEqual(shared.complaints, []);
  return shared;
}

export let browser;
before(async () => (browser = await launched(kForWebGl)));
after(() => browser.close());
