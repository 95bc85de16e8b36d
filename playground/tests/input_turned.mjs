// Terrain and solids, which people rotate. input_test.mjs runs it.
import assert from "node:assert/strict";
import test from "node:test";
import { press, shownOnShared } from "./input_support.mjs";
import { stateOfPage } from "./support.mjs";

test("terrain is turned by keys and by a finger, and is sharp at rest", async () => {
  const page = await shownOnShared("#map=land&cells=4");
  await page.focus("#view-plane");
  await press(page, "ArrowRight", "ArrowRight");
  const seen = () =>
    page.evaluate(async () => {
      await window.hashnoise.drawing;
      return document.getElementById("picture-terrain").toDataURL();
    });
  assert.equal((await stateOfPage(page)).view, "terrain");
  assert.equal(await page.$eval("#picture-webgl2", (canvas) => canvas.hidden), true);
  await page.waitForFunction(() => window.hashnoise.surface?.side === 384 && !window.hashnoise.drawing);
  assert.match(await page.$eval("#picture-terrain", (canvas) => canvas.ariaLabel), /^Terrain of fBm of Perlin noise/);
  const first = await seen();
  await page.focus("#picture-terrain");
  await press(page, "ArrowRight", "ArrowUp");
  assert.notEqual(await seen(), first);
  let { turn, tilt, x } = await stateOfPage(page);
  assert.ok(turn < 0.1 && tilt < 0.1 && x === 0n, `${turn}, ${tilt}, ${x}`);
  await page.keyboard.down("Shift");
  await press(page, "ArrowRight");
  await page.keyboard.up("Shift");
  assert.ok((await stateOfPage(page)).x > 0n);
  await page.mouse.move(400, 300);
  await page.mouse.down();
  await page.mouse.move(300, 300, { steps: 2 });
  await page.mouse.up();
  assert.ok((await stateOfPage(page)).turn > turn);
  await page.click("#home");
  ({ turn, tilt, x } = await stateOfPage(page));
  assert.deepEqual([x, await page.evaluate(() => window.hashnoise.link.includes("view=terrain"))], [0n, true]);
  assert.deepEqual(page.complaints, []);
});

test("terrain is saved as it is shown", async () => {
  const page = await shownOnShared("#view=terrain&sea=0.6&width=90&height=70&blend2=add&sum2=none&noise2=middle");
  const [corner, middle] = await page.evaluate(async () => {
    const image = await createImageBitmap(await window.hashnoise.file(() => {}));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    return [0, 4 * (90 * 50 + 45)].map((at) => Array.from(data.subarray(at, at + 4)));
  });
  assert.deepEqual(corner, [42, 44, 54, 255]);
  assert.ok(middle[2] > middle[0] + 20, `${middle}`); // water
});

test("a sphere is turned by keys", async () => {
  const page = await shownOnShared("#sum=none&noise=value");
  await page.click("#view label:nth-child(4)");
  assert.equal(await page.evaluate(() => window.hashnoise.link), "#sum=none&noise=value&dimensions=3&view=sphere");
  assert.match(await page.$eval("#picture-webgl2", (canvas) => canvas.ariaLabel), /^Sphere of Value noise in 3D/);
  await page.focus("#picture-webgl2");
  await press(page, "ArrowRight", "ArrowDown");
  const { turn, tilt, x } = await stateOfPage(page);
  assert.ok(turn < 0.1 && tilt > 0.1 && x === 0n);
  assert.deepEqual(page.complaints, []);
});
