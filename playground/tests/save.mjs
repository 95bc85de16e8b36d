// Saves the files of links, as the page does, for tests of other programs (packages/python/tests/bake_test.py):
//
//   node save.mjs PAGE.html FOLDER LINK...      writes FOLDER/0, FOLDER/1 and so on
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { kForWebGl, launched, opened } from "./support.mjs";

const [folder, ...links] = process.argv.slice(3);
const browser = await launched(kForWebGl);
try {
  for (const [number, link] of links.entries()) {
    const page = await opened(browser, { link });
    const bytes = await page.evaluate(async () => Array.from(new Uint8Array(await (await window.hashnoise.file(() => {})).arrayBuffer())));
    await writeFile(join(folder, String(number)), Uint8Array.from(bytes));
    await page.close();
  }
} finally {
  await browser.close();
}
