// Writes the picture of the page that the README shows, as PNG: node picture.mjs PAGE.html FILE, in the folder of
// tools/lib/base/javascript. tools/playground --picture calls this.
import { kForWebGl, launched, opened } from "./tests/support.mjs";

const kLink = "#sum=eroded&seed=12&octaves=8&map=land&cells=4&view=terrain";
const kDrawn = 5000; // ms: terrain is drawn step by step, and software takes two seconds

const browser = await launched(kForWebGl);
try {
  const page = await opened(browser, { link: kLink, viewport: { width: 1200, height: 720 } });
  await new Promise((done) => setTimeout(done, kDrawn));
  await page.screenshot({ path: process.argv[3] });
} finally {
  await browser.close();
}
