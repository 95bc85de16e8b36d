// The page, as people use it: they open it from a disk, use a keyboard alone, two fingers, links.
import assert from "node:assert/strict";
import test from "node:test";
import {
  browser, decoding, focused, keepCopies, kLaptop, kPane, kThorough, pixelsOf, press, screenshot, settled,
  shownOnShared, tabTo, visibleText, wait,
} from "./input_support.mjs";
import { kPage, kPhone, opened, pixels, ready, stateOfPage } from "./support.mjs";
import "./input_panel.mjs";
import "./input_turned.mjs";

test("it opens from a disk, and loads nothing", async () => {
  assert.match(kPage, /^file:/);
  const page = await browser.newPage();
  await page.setViewport(kLaptop);
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(kPage);
  await ready(page);
  assert.deepEqual(
    asked.filter((url) => url !== kPage && !url.startsWith("data:")),
    [],
  );
  // With a look that sells, which another seed does not change; what is shown later comes back.
  const chosen = async () => {
    await wait(settled);
    return page.$$eval('#looks [aria-pressed="true"]', (buttons) => buttons.map((button) => button.textContent));
  };
  assert.deepEqual([await chosen(), (await stateOfPage(page)).view], [["Island"], "terrain"]);
  await page.click("#dice");
  assert.deepEqual(await chosen(), ["Island"]);
  await page.evaluate(() => window.hashnoise.open("#", ""));
  assert.deepEqual(await chosen(), ["Dusk"]);
  await page.reload();
  await ready(page);
  assert.deepEqual([await chosen(), (await stateOfPage(page)).view], [["Dusk"], "plane"]);
  // Not even if it wanted to.
  const refused = await page.evaluate(() =>
    fetch("http://127.0.0.1:1/").then(
      () => "asked",
      () => "refused",
    ),
  );
  assert.equal(refused, "refused");
  await page.close();
});

test("a link shows the same picture", async () => {
  const page = await opened(browser, { viewport: kLaptop, before: keepCopies });
  await page.click("#looks button:nth-child(9)");
  await page.click("#in");
  await page.click("#dice");
  await wait(settled);
  const link = await page.evaluate(() => location.hash);
  assert.match(link, /^#seed=\d+&octaves=7&warp=warp_progressive&map=lagoon&cells=[\d.]+$/);
  await page.click("#link");
  // A page from a disk has no address for others.
  assert.deepEqual(await page.evaluate(() => window.copies), [link]);
  assert.match(await visibleText(page, "hint"), /has no address for others/);
  const other = await opened(browser, { link, viewport: kLaptop });
  assert.deepEqual(await stateOfPage(other), await stateOfPage(page));
  assert.deepEqual(await pixels(other, 48, 32), await pixels(page, 48, 32));
  // A link that is pasted into the address of an open page.
  await other.evaluate(() => (location.hash = "#noise=value&sum=none&seed=3"));
  await other.waitForFunction(() => window.hashnoise.state.layers[0].noise === "value");
  assert.equal((await stateOfPage(other)).seed, 3);
  assert.deepEqual([...page.complaints, ...other.complaints], []);
  await Promise.all([page.close(), other.close()]);
});

test("the focus has a ring, and on the picture one of two colours", async () => {
  const page = await shownOnShared();
  for (const id of ["picture-webgl2", "play", "sum", "copy"]) {
    await tabTo(page, id);
    const ring = await page.evaluate(() => {
      const { outlineStyle, outlineWidth } = getComputedStyle(document.activeElement);
      return `${outlineStyle} ${outlineWidth}`;
    });
    assert.match(ring, /^solid [23]px$/, id);
  }
  await page.focus("#picture-webgl2");
  const colours = await page.evaluate(() => [
    getComputedStyle(document.activeElement).outlineColor, getComputedStyle(document.getElementById("stage"), "::after").borderTopColor,
  ]);
  assert.deepEqual(colours, ["rgb(255, 255, 255)", "rgb(28, 29, 33)"]);
});

// A GPU in slow motion: each picture takes so many milliseconds and more for each pixel. Keeps the sizes that are shown
// and how long each strip took.
const slowDown = (page, wait, pixel) =>
  page.evaluate(
    (latency, cost) => {
      const { hashnoise } = window;
      const { gpu } = hashnoise;
      const { strip, show, finished } = gpu;
      const seen = (window.seen = { sizes: [], strips: [] });
      let pending = 0;
      gpu.strip = (...arguments_) => {
        pending = latency + arguments_[2] * arguments_[5] * cost;
        seen.strips.push(pending);
        strip.apply(gpu, arguments_);
      };
      gpu.finished = async () => {
        await finished.apply(gpu);
        await new Promise((resolve) => setTimeout(resolve, pending));
      };
      gpu.show = () => {
        show.apply(gpu);
        seen.sizes.push(`${gpu.canvas.width} x ${gpu.canvas.height}`);
        seen.strips.push(0);
      };
      hashnoise.speeds = new WeakMap();
      hashnoise.change({ seed: 8 });
    },
    wait,
    pixel,
  );
const sharp = (page) =>
  page.waitForFunction(
    () => {
      const { canvas, coarse, drawing, moves } = window.hashnoise;
      const { width, height } = canvas.getBoundingClientRect();
      const whole = [width, height].map((side) => Math.round(side * devicePixelRatio));
      return !drawing && !moves && coarse === 1 && canvas.width === whole[0] && canvas.height === whole[1];
    },
    { timeout: 60000 },
  );

test("a picture at rest is sharp", async () => {
  for (const [link, viewport] of [
    ["", { width: 420, height: 260 }],
    ["#sum=none&noise=cellular&dimensions=3", { width: 480, height: 340, deviceScaleFactor: 0.7 }],
    ["#sum=none", { ...kPhone, width: 195, height: 422, deviceScaleFactor: 2.5 }],
    // SwiftShader takes a second for it.
    ...(kThorough ? [["#sum=eroded&dimensions=3&warp=warp_progressive&octaves=8", kPane]] : []),
  ]) {
    const page = await opened(browser, { link, viewport });
    await sharp(page);
    assert.equal(await visibleText(page, "drawing"), "");
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
});

// These measure how long the page is kept waiting, and what a noise costs. So they run alone, as the test
// playground.times.
const kBesideOthers = process.env.HN_BESIDE_OTHERS === "1";

test("a slow picture becomes sharp in strips that leave the page time", { skip: kBesideOthers }, async () => {
  const page = await opened(browser, { link: "#sum=none&map=grey&cells=40", viewport: kPane, before: decoding });
  await sharp(page);
  // Forty milliseconds for nothing are no reason for a coarse picture.
  await slowDown(page, 40, 0.0001);
  await sharp(page);
  let seen = await page.evaluate(() => window.seen);
  assert.equal(seen.sizes.at(-1), "360 x 260");
  assert.ok(seen.strips.length < 40, JSON.stringify(seen));
  // Two seconds for the whole are.
  await slowDown(page, 0, 0.02);
  await page.waitForFunction(() => document.getElementById("drawing").checkVisibility());
  await sharp(page);
  seen = await page.evaluate(() => window.seen);
  assert.equal(seen.sizes.at(-1), "360 x 260");
  assert.ok(new Set(seen.sizes).size >= 2, JSON.stringify(seen.sizes));
  assert.ok(Math.max(...seen.strips.slice(8)) < 80, JSON.stringify(seen.strips));
  assert.equal(await visibleText(page, "drawing"), "");
  // The strips make one picture.
  const seenNow = await pixelsOf(page, await screenshot(page));
  const bytes = await pixels(page, 360, 260);
  for (let row = 70; row < 220; ++row) {
    const [shown, drawn] = [seenNow.slice(row * 1440), bytes.slice((259 - row) * 1440)];
    assert.deepEqual(shown.slice(0, 640), drawn.slice(0, 640), `row ${row}`);
  }
  // A picture that is wanted meanwhile does not wait for the end.
  await page.evaluate(() => window.hashnoise.change({ seed: 9 }));
  await page.waitForFunction((count) => window.seen.sizes.length > count, {}, seen.sizes.length + 1);
  await page.evaluate(() => window.hashnoise.change({ seed: 10 }));
  await page.waitForFunction(() => window.hashnoise.shown.layers[0].seed === 10, { timeout: 800 });
  await page.close();
});

test("the page shows that it draws until there is a picture", async () => {
  const page = await browser.newPage();
  await page.setViewport(kLaptop);
  await page.evaluateOnNewDocument(() => {
    const later = window.requestAnimationFrame.bind(window);
    const held = [];
    window.requestAnimationFrame = (call) => held.push(call);
    window.release = () => {
      window.requestAnimationFrame = later;
      held.forEach(later);
    };
  });
  await page.goto(kPage);
  await page.waitForFunction(() => window.hashnoise);
  assert.equal(await visibleText(page, "drawing"), "Drawing …");
  await page.evaluate(() => window.release());
  await ready(page);
  await sharp(page);
  assert.equal(await visibleText(page, "drawing"), "");
  await page.close();
});

test("two fingers change the scale, and one moves the picture", async () => {
  const page = await opened(browser, { viewport: { ...kPhone, deviceScaleFactor: 1 } });
  const session = await page.createCDPSession();
  const touch = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const below = ([x, y]) =>
    page.evaluate(
      (at) => {
        const { size, state } = window.hashnoise;
        const [right, up] = window.hashnoise.fromMiddle(at).map((side) => (side * state.cells) / Math.min(...size));
        return [Number(state.x) / 16777216 + right, Number(state.y) / 16777216 + up];
      },
      { x, y },
    );
  const near = (a, b) => a.every((side, axis) => Math.abs(side - b[axis]) < 0.05);

  const [left, right, wider] = [[120, 150], [240, 250], [[60, 110], [320, 300]]];
  const [one, two] = [await below(left), await below(right)];
  await touch("touchStart", left, right);
  for (let i = 1; i <= 8; ++i) {
    const way = (from, to) => from.map((side, axis) => side + ((to[axis] - side) * i) / 8);
    await touch("touchMove", way(left, wider[0]), way(right, wider[1]));
  }
  await touch("touchEnd");
  const { cells } = await stateOfPage(page);
  assert.ok(Math.abs(cells / 8 - Math.hypot(120, 100) / Math.hypot(260, 190)) < 0.01, `${cells} cells`);
  // The fingers turned a little, which the picture does not: the place in the middle between them is still there.
  const middle = (a, b) => a.map((side, axis) => (side + b[axis]) / 2);
  assert.ok(near(await below(middle(...wider)), middle(one, two)));

  const held = await below([200, 200]);
  await touch("touchStart", [200, 200]);
  for (let i = 1; i <= 5; ++i) await touch("touchMove", [200 + 12 * i, 200 - 10 * i]);
  await touch("touchEnd");
  assert.ok(near(await below([260, 150]), held));
  assert.ok(!near(await below([200, 200]), held));
  assert.equal((await stateOfPage(page)).cells, cells);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("a wheel changes the scale around the pointer, whose value is shown", async () => {
  const page = await shownOnShared();
  await page.mouse.move(300, 200);
  await page.waitForFunction(() => document.getElementById("value").textContent !== "");
  const shown = () => page.$eval("#value", (output) => Number(output.textContent.replace("−", "-")));
  const before = await shown();
  const expected = await page.evaluate(async () => {
    const { probed, state } = window.hashnoise;
    return (await window.hashnoise.values([[probed.x, probed.y, 0n, 0n]]))[0];
  });
  assert.ok(Math.abs(before - expected) < 1e-4);
  await page.mouse.wheel({ deltaY: -600 });
  await page.waitForFunction(() => window.hashnoise.state.cells < 3);
  await wait(settled);
  assert.ok(Math.abs((await shown()) - before) < 0.05);
});

test("Ctrl+Z and a button undo settings, and leave a text that is typed", async () => {
  const page = await shownOnShared("#octaves=1");
  const ctrl = async (...keys) => {
    for (const key of ["Control", ...keys]) await page.keyboard.down(key);
    for (const key of [...keys, "Control"]) await page.keyboard.up(key);
  };
  const shown = async () => {
    const { gain, seed } = await stateOfPage(page);
    return `${gain} ${seed} ${await page.evaluate(() => window.hashnoise.link)}`;
  };
  const number = await page.evaluate(() => history.length);
  await page.focus("#gain");
  await press(page, "ArrowRight", "ArrowRight");
  await page.click("#dice");
  const last = await shown();
  await ctrl("z");
  assert.equal(await shown(), "0.52 7 #octaves=1&gain=0.52");
  await page.waitForFunction(() => document.getElementById("status").textContent === "The last change is undone.");
  await page.click("#undo");
  assert.equal(await shown(), "0.5 7 #octaves=1");
  await ctrl("Shift", "z");
  await page.click("#redo");
  assert.equal(await shown(), last);
  assert.equal(await page.$eval("#redo", (button) => button.ariaDisabled), "true");
  await page.click("#seed", { count: 3 });
  await page.keyboard.type("12");
  await ctrl("z");
  assert.equal(await shown(), last);
  await press(page, "Escape");
  // A look is one step, and so is a pasted link. An undone step has what its picture did not use.
  await page.evaluate(() => window.hashnoise.open("#dimensions=3&z=3.5", ""));
  const { z } = await stateOfPage(page);
  await page.click("#dimensions label:nth-child(2)");
  await page.click("#looks button:nth-child(1)");
  await page.click("#undo");
  await page.click("#dimensions label:nth-child(3)");
  assert.deepEqual([(await stateOfPage(page)).z, (await stateOfPage(page)).seed], [z, 7]);
  assert.equal(await page.evaluate(() => history.length), number);
  assert.deepEqual(page.complaints, []);
});

test("a lost context comes back", async () => {
  const page = await opened(browser);
  const before = await pixels(page, 16, 16);
  await page.evaluate(async () => {
    const { gl } = window.hashnoise.gpu;
    const loss = gl.getExtension("WEBGL_lose_context");
    const event = (name) => new Promise((resolve) => gl.canvas.addEventListener(name, resolve, { once: true }));
    const lost = event("webglcontextlost");
    loss.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve));
    const back = event("webglcontextrestored");
    loss.restoreContext();
    await back;
    await window.hashnoise.request();
  });
  assert.deepEqual(await pixels(page, 16, 16), before);
  await page.close();
});

test("the times of noise are ratios to Perlin noise", { skip: kBesideOthers }, async () => {
  const page = await opened(browser, { link: "#sum=none" });
  // The middle of three: on a machine with other work one may be off by a factor of two.
  const measure = async () => {
    const found = [];
    for (let i = 0; i < 3; ++i) {
      await page.evaluate(() => window.hashnoise.measure());
      found.push(parseFloat(await page.$eval("#cost", (output) => output.textContent)));
    }
    return found.toSorted((one, other) => one - other)[1];
  };
  const plain = await measure();
  assert.ok(plain > 0.5 && plain < 2, `hn_perlin costs ${plain} times as much as itself`);
  await page.evaluate(() => window.hashnoise.change({ sum: "fbm", octaves: 4 }));
  assert.equal(await page.$eval("#cost", (output) => output.textContent), "Cost on this GPU");
  const sum = await measure();
  assert.ok(sum > 1.8 && sum > plain, `four octaves cost ${sum}`);
  assert.match(
    await page.$eval("#note-cost", (note) => note.textContent),
    /^A million values take [\d.]+ ms\. It is pattern\(p\)\. From a cell, pattern\(cell, f\) costs [\d.]+ ×\. hn_perlin\(p\) in 2D, .* on ANGLE/,
  );
  await page.close();
});
