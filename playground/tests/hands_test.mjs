// What people do with the page: open it from a disk, use a keyboard alone, two fingers, links, the clipboard.
import assert from "node:assert/strict";
import test, { after, before } from "node:test";
import { kForWebGl, kPage, kPhone, launched, opened, pixels, ready, stateOfPage } from "./support.mjs";

// A pixel of the picture has eight on a side of the page, since most tests are not about the picture.
const kLaptop = { width: 1280, height: 720, deviceScaleFactor: 0.125 };
const settled = 400; // milliseconds, after which the link is written

const kThorough = Boolean(process.env.HN_THOROUGH);

// A picture of 360 x 260 pixels, with the panel on it.
const kPane = { width: 720, height: 520, deviceScaleFactor: 0.5 };

// What is copied, without a clipboard.
const keepCopies = () => {
  window.copies = [];
  Object.defineProperty(navigator, "clipboard", {
    value: { writeText: async (text) => void window.copies.push(text) },
  });
};
const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const focused = (page) => page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim());

async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
}

// By Tab alone from where the focus is, to the control of this name; fails after a whole round.
async function tabTo(page, id) {
  for (let i = 0; i < 120; ++i) {
    await page.keyboard.press("Tab");
    if ((await focused(page)) === id) return;
  }
  assert.fail(`Tab does not lead to ${id}`);
}

// What a screen reader has nothing to say of.
async function nameless(page) {
  const tree = await page.accessibility.snapshot({ interestingOnly: true });
  const found = [];
  const look = (node) => {
    const control = /^(button|checkbox|combobox|radio|slider|spinbutton|tab|textbox|application)$/.test(node.role);
    if (control && !node.name?.trim()) found.push(node.role);
    (node.children ?? []).forEach(look);
  };
  look(tree);
  return found;
}

// The text of an element; nothing if nobody sees it.
const visibleText = (page, id) =>
  page.$eval(`#${id}`, (shown) => (shown.checkVisibility() ? shown.textContent : ""));

// What is seen, as a PNG.
const screenshot = (page) => page.screenshot({ encoding: "base64" });

// As bytes of pixels. Megabytes of them take a second to come here.
const pixelsOf = (page, png) => page.evaluate(async (text) => Array.from(await window.bytesOf(text)), png);

// What decodes a PNG in the page.
const decoding = () => {
  window.bytesOf = async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]));
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, image.width, image.height).data;
  };
};

// How many pixels of two screens differ so much that everybody sees it: three to one in light.
const differing = (page, first, second) =>
  page.evaluate(
    async (...texts) => {
      const [one, other] = await Promise.all(texts.map(window.bytesOf));
      const light = (screen, at) => {
        const [red, green, blue] = [0, 1, 2].map((part) => (screen[at + part] / 255) ** 2.2);
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue + 0.05;
      };
      let count = 0;
      for (let at = 0; at < one.length; at += 4) {
        const ratio = light(one, at) / light(other, at);
        if (ratio >= 3 || ratio <= 1 / 3) ++count;
      }
      return count;
    },
    first,
    second,
  );

// One page for several tests, since to open one takes long: with the state of this link, and nothing else of the others.
let shared;
async function shownOnShared(link = "") {
  shared ??= await opened(browser, { viewport: kLaptop });
  await shared.evaluate((hash) => {
    history.replaceState(null, "", location.pathname + hash);
    window.dispatchEvent(new PopStateEvent("popstate", { state: null }));
    return window.hashnoise.drawing;
  }, link);
  assert.deepEqual(shared.complaints, []);
  return shared;
}

let browser;
let other; // for the few tests that see WebGPU's canvas
const withWebGpu = async () => (other ??= await launched());
before(async () => (browser = await launched(kForWebGl)));
after(async () => {
  await browser.close();
  await other?.close();
});

test("it opens from a disk, and loads nothing", async () => {
  assert.match(kPage, /^file:/);
  const page = await browser.newPage();
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(kPage);
  await ready(page);
  assert.deepEqual(
    asked.filter((url) => url !== kPage && !url.startsWith("data:")),
    [],
  );
  // Not even if it wanted to.
  const refused = await page.evaluate(() =>
    fetch("http://127.0.0.1:1/").then(
      () => "asked",
      () => "refused",
    ),
  );
  const policy = await page.$eval("meta[http-equiv]", (meta) => meta.content);
  assert.equal(refused, "refused");
  assert.match(policy, /^default-src 'none';/);
  await page.close();
});

test("a link shows the same picture", async () => {
  const page = await opened(browser, { viewport: kLaptop, before: keepCopies });
  await page.click("#looks button:nth-child(4)");
  await page.click("#in");
  await page.click("#dice");
  await wait(settled);
  const link = await page.evaluate(() => location.hash);
  assert.match(link, /^#seed=\d+&octaves=7&warp=warp_progressive&map=lagoon&cells=[\d.]+$/);
  await page.click("#link");
  assert.deepEqual(await page.evaluate(() => window.copies), [kPage + link]);
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

test("a keyboard alone is enough", async () => {
  const page = await opened(browser, { viewport: kLaptop, before: keepCopies });
  await press(page, "Tab");
  assert.equal(await focused(page), "picture-webgl2");
  await press(page, "ArrowRight", "ArrowUp", "ArrowUp", "+");
  let state = await stateOfPage(page);
  assert.ok(state.x > 0n && state.y > 0n && state.cells < 8);
  await press(page, "Home", "r", "-");
  state = await stateOfPage(page);
  assert.ok(state.x === 0n && state.y === 0n && state.cells > 8 && state.seed !== 7);

  await tabTo(page, "sum");
  await press(page, "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown");
  await tabTo(page, "noise");
  await press(page, "ArrowDown");
  await tabTo(page, "dimensions-2");
  await press(page, "ArrowRight");
  await tabTo(page, "octaves");
  await press(page, "ArrowRight", "ArrowRight");
  await tabTo(page, "z");
  await press(page, "ArrowLeft");
  await tabTo(page, "seed");
  await page.keyboard.down("Control");
  await press(page, "a");
  await page.keyboard.up("Control");
  await page.keyboard.type("99");
  await press(page, "Enter", "ArrowUp");
  await tabTo(page, "map-dusk");
  await press(page, "ArrowRight");
  await tabTo(page, "language-glsl");
  await press(page, "ArrowRight", "ArrowRight");
  await tabTo(page, "copy");
  await press(page, "Enter");
  await tabTo(page, "arithmetic-fast");
  await press(page, "ArrowRight");
  state = await stateOfPage(page);
  assert.deepEqual(
    [state.sum, state.noise, state.dimensions, state.octaves, state.z, state.seed, state.map, state.arithmetic],
    ["ridged", "value", 3, 8, 0.36, 100, "lagoon", "fixed"],
  );
  const copies = (await page.evaluate(() => window.copies)).join();
  assert.match(copies, /fn pattern_cell\(cell: vec3i, f: vec3f\)/);
  assert.match(copies, /fn hn_i_cell_vec3f/);

  await page.evaluate(() => document.getElementById("picture-webgl2").focus());
  const before = (await stateOfPage(page)).z;
  await press(page, "Space");
  await page.waitForFunction((z) => window.hashnoise.state.z > z + 0.02, {}, before);
  await press(page, "Space");
  assert.equal(await page.evaluate(() => window.hashnoise.playing), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("the focus is seen wherever it is, on a dark picture and on a light one", async () => {
  // In such a small part of a cell the picture has one colour.
  for (const [seed, colour] of [
    [5, 0],
    [1, 255],
  ]) {
    const link = `#sum=none&noise=cells&map=grey&contrast=4&cells=0.02&seed=${seed}`;
    const viewport = { width: 720, height: 400, deviceScaleFactor: 1 }; // A ring is a few pixels wide.
    const page = await opened(browser, { viewport, before: decoding, link });
    // It is still on the screen when its values have been read.
    await page.waitForFunction(() => document.getElementById("values").textContent);
    const clip = { x: 300, y: 200, width: 4, height: 4 };
    const png = await page.screenshot({ encoding: "base64", clip });
    assert.ok((await pixelsOf(page, png)).every((part, at) => part === (at % 4 === 3 ? 255 : colour)));
    assert.deepEqual(await pixels(page, 1, 1), [colour, colour, colour, 255]);
    for (const id of ["picture-webgl2", "play", ...(colour ? [] : ["sum", "seed", "copy"])]) {
      await tabTo(page, id);
      const focus = await screenshot(page);
      await page.evaluate(() => document.activeElement.blur());
      const pixelsOfRing = await differing(page, focus, await screenshot(page));
      await page.$eval(`#${id}`, (control) => control.focus());
      assert.ok(pixelsOfRing > 100, `${pixelsOfRing} pixels differ by the focus on ${id}, above ${colour}`);
    }
    await page.close();
  }
});

test("what is not of a place is not taken, and said", async () => {
  const page = await shownOnShared();
  const enter = async (id, text) => {
    await page.$eval(
      `#${id}`,
      (input, value) => {
        input.value = value;
        input.dispatchEvent(new Event("change"));
      },
      text,
    );
  };
  const message = () => page.$eval("#wrong-x", (text) => (text.checkVisibility() ? text.textContent : ""));
  assert.equal(await message(), "");
  await enter("x", "nowhere");
  assert.equal(await page.$eval("#x", (input) => input.getAttribute("aria-invalid")), "true");
  assert.match(await message(), /takes a number from −2147483648 to 2147483648, such as/);
  assert.equal(await page.$eval("#x", (input) => input.getAttribute("aria-describedby")), "wrong-x");
  // It stays while people look elsewhere, until they choose something.
  await page.focus("#x");
  await page.focus("#y");
  assert.notEqual(await message(), "");
  assert.equal(await page.$eval("#x", (input) => input.value), "nowhere");
  await enter("y", "2.5e1");
  assert.equal((await stateOfPage(page)).y, 25n << 24n);
  assert.equal(await message(), "");
  assert.equal(await page.$eval("#x", (input) => input.value), "0");
  await enter("seed", "many");
  assert.match(await page.$eval("#wrong-seed", (text) => text.textContent), /a whole number from 0 to 4294967295\.$/);
  await enter("x", "1000000000.5");
  assert.equal((await stateOfPage(page)).x, 1000000000n * 16777216n + 8388608n);
  assert.equal(await page.$eval("#x", (input) => input.getAttribute("aria-invalid")), null);
});

// A GPU in slow motion: each picture takes so many milliseconds and more for each pixel. Keeps the sizes that are shown
// and how long each strip took.
const slowDown = (page, wait, pixel) =>
  page.evaluate(
    (latency, cost) => {
      const { hashnoise } = window;
      const backend = hashnoise.backends[hashnoise.state.renderer];
      const { strip, show, finished } = backend;
      const seen = (window.seen = { sizes: [], strips: [] });
      let pending = 0;
      backend.strip = (...arguments_) => {
        pending = latency + arguments_[2] * arguments_[5] * cost;
        seen.strips.push(pending);
        strip.apply(backend, arguments_);
      };
      backend.finished = async () => {
        await finished.apply(backend);
        await new Promise((resolve) => setTimeout(resolve, pending));
      };
      backend.show = () => {
        show.apply(backend);
        seen.sizes.push(`${backend.canvas.width} x ${backend.canvas.height}`);
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
    ["", { width: 640, height: 400 }],
    ["#sum=none&noise=cellular&dimensions=3&renderer=webgpu", { ...kPane, deviceScaleFactor: 0.7 }],
    ["#sum=none", { ...kPhone, width: 195, height: 422, deviceScaleFactor: 3.5 }],
    // SwiftShader takes a second for it.
    ...(kThorough ? [["#sum=eroded&dimensions=3&warp=warp_progressive&octaves=8", kPane]] : []),
  ]) {
    const page = await opened(link.includes("webgpu") ? await withWebGpu() : browser, { link, viewport });
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
  for (const renderer of ["webgl2", "webgpu"]) {
    const link = `#sum=none&map=grey&cells=40&renderer=${renderer}`;
    const on = renderer === "webgpu" ? await withWebGpu() : browser;
    const page = await opened(on, { link, viewport: kPane, before: decoding });
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
    // What is wanted meanwhile does not wait for the end.
    await page.evaluate(() => window.hashnoise.change({ seed: 9 }));
    await page.waitForFunction((count) => window.seen.sizes.length > count, {}, seen.sizes.length + 1);
    await page.evaluate(() => window.hashnoise.change({ seed: 10 }));
    await page.waitForFunction(() => window.hashnoise.shown.layers[0].seed === 10, { timeout: 800 });
    await page.close();
  }
});

test("the page says that it draws until there is a picture", async () => {
  const page = await browser.newPage();
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

test("a typed number that is changed says so", async () => {
  const page = await shownOnShared("#dimensions=3");
  const enter = async (id, text) => {
    await page.click(`#${id}`, { count: 3 });
    await page.keyboard.type(text);
    await press(page, "Tab");
    return visibleText(page, `wrong-${id}`);
  };
  for (const [id, typed, sentence] of [
    ["seed", "5000000000", "5000000000 became 4294967295. This field takes a whole number from 0 to 4294967295."],
    ["seed", "2.5", "2.5 became 3. This field takes a whole number from 0 to 4294967295."],
    ["seed", "1e3", ""],
    ["period", "-4", "-4 became 0. This field takes a whole number from 0 to 65536."],
    ["x", "1e10", /^1e10 became 2147483647\.99999994\. /],
    ["x", "0,50", ""],
    ["x", "0.12345678901", /^0\.12345678901 became 0\.1234567\d\. /],
    ["cells", "7.1234567", /^7\.1234567 became 7\.12346\. This field takes a number of at most six digits /],
  ]) {
    const said = await enter(id, typed);
    if (typeof sentence === "string") assert.equal(said, sentence);
    else assert.match(said, sentence);
    assert.equal(await page.$eval(`#${id}`, (input) => input.getAttribute("aria-invalid")), null);
  }
  // It stays while the picture plays, and goes with the number.
  await page.click("#play");
  await page.waitForFunction(() => window.hashnoise.state.z > 0.5);
  assert.match(await visibleText(page, "wrong-cells"), /became/);
  await page.click("#play");
  await page.click("#home");
  assert.equal(await visibleText(page, "wrong-cells"), "");
});

test("one arrow key is one whole step", async () => {
  const link = "#dimensions=3&z=0.375&octaves=16&x=0.25&sum=ridged&noise=simplex&cells=8.5&w=3";
  const page = await shownOnShared(link);
  const after = async (id, ...keys) => {
    await page.focus(`#${id}`);
    await press(page, ...keys);
    return (await stateOfPage(page))[id];
  };
  // These numbers lie between the slider's, and beyond them.
  assert.equal(await after("z", "ArrowRight"), 0.385);
  assert.equal(await after("z", "ArrowLeft", "ArrowDown", "PageUp"), 0.465);
  assert.equal(await after("octaves", "ArrowRight"), 16);
  assert.equal(await after("octaves", "ArrowLeft"), 15);
  assert.equal(await after("gain", "ArrowUp"), 0.51);
  assert.equal(await after("x", "ArrowUp"), 5n << 22n);
  assert.equal(await after("x", "ArrowLeft"), 5n << 22n);
  assert.equal(await after("cells", "ArrowUp"), 9.5);
  assert.equal(await after("cells", "PageDown", "ArrowDown"), 0.1875);
  // What is typed counts, whether or not it is entered.
  await page.click("#seed", { count: 3 });
  await page.keyboard.type("41");
  assert.equal(await after("seed", "ArrowUp"), 42);
  // The picture goes by whole pixels.
  await page.evaluate(() => window.hashnoise.change({ x: 0n, cells: 8 }));
  await page.focus("#picture-webgl2");
  await press(page, "ArrowRight");
  const { x } = await stateOfPage(page);
  const step = await page.evaluate(() => Math.round((8 / Math.min(...window.hashnoise.size)) * 16777216));
  assert.ok(x > 0n && x % BigInt(step) === 0n, `${x} is no multiple of ${step}`);
});

test("every control has a name", async () => {
  const page = await opened(browser, {
    link: "#sum=ping_pong&noise=cellular&dimensions=3&warp=warp&blend2=add&sum2=none",
    viewport: kLaptop,
  });
  assert.deepEqual(await nameless(page), []);
  // The values of the picture, in words.
  await page.waitForFunction(() => document.getElementById("values").textContent);
  const [, least, greatest] = /^The values are from (\S+) to (\S+), and/.exec(await visibleText(page, "values"));
  const values = new Float32Array(new Uint32Array(await pixels(page, 85, 48, true)).buffer);
  assert.ok(Math.abs(Math.min(...values) - least.replace("−", "-")) < 0.001);
  assert.ok(Math.abs(Math.max(...values) - greatest) < 0.001);
  assert.match(await page.$eval("#histogram", (shown) => shown.ariaLabel), /^Histogram: of ten equal parts/);
  await page.evaluate(() => {
    document.querySelector("label[for=octaves]").remove();
    document.getElementById("play").removeAttribute("aria-label");
    document.getElementById("play").removeAttribute("title");
  });
  assert.deepEqual((await nameless(page)).toSorted(), ["button", "slider"]);
  await page.close();
});

test("two fingers change the scale, and one moves the picture", async () => {
  const page = await opened(browser, { viewport: kPhone });
  const session = await page.createCDPSession();
  const touch = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const below = ([x, y]) =>
    page.evaluate(
      (px, py) => {
        const { state, canvas } = window.hashnoise;
        const box = canvas.getBoundingClientRect();
        const cell = state.cells / Math.min(box.width, box.height);
        const parts = [px - box.left - box.width / 2, box.height / 2 - (py - box.top)].map((side) => side * cell);
        return [Number(state.x) / 16777216 + parts[0], Number(state.y) / 16777216 + parts[1]];
      },
      x,
      y,
    );
  const near = (a, b) => a.every((side, axis) => Math.abs(side - b[axis]) < 0.05);

  const [left, right] = [
    [120, 150],
    [240, 250],
  ];
  const [one, two] = [await below(left), await below(right)];
  await touch("touchStart", left, right);
  const wider = [
    [60, 110],
    [320, 300],
  ];
  for (let i = 1; i <= 8; ++i) {
    const way = (from, to) => from.map((side, axis) => side + ((to[axis] - side) * i) / 8);
    await touch("touchMove", way(left, wider[0]), way(right, wider[1]));
  }
  await touch("touchEnd");
  const state = await stateOfPage(page);
  const factor = Math.hypot(120, 100) / Math.hypot(260, 190);
  assert.ok(Math.abs(state.cells / 8 - factor) < 0.01, `${state.cells} cells`);
  // The fingers turned a little, which the picture does not: what was in the middle between them is still there.
  const middle = (a, b) => a.map((side, axis) => (side + b[axis]) / 2);
  assert.ok(near(await below(middle(...wider)), middle(one, two)));

  const held = await below([200, 200]);
  await touch("touchStart", [200, 200]);
  for (let i = 1; i <= 5; ++i) await touch("touchMove", [200 + 12 * i, 200 - 10 * i]);
  await touch("touchEnd");
  assert.ok(near(await below([260, 150]), held));
  assert.ok(!near(await below([200, 200]), held));
  assert.equal((await stateOfPage(page)).cells, state.cells);
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

test("it fits a phone", async () => {
  const page = await opened(browser, {
    viewport: { ...kPhone, deviceScaleFactor: 0.25 },
    link: "#sum=ping_pong&noise=cells&dimensions=3&warp=warp&metric=manhattan&blend2=mix&sum2=none&blend3=add&sum3=none",
  });
  for (const [viewport, least] of [
    [kPhone, 40],
    [{ ...kPhone, width: 320, height: 568 }, 40],
    [{ ...kPhone, width: 844, height: 390 }, 40],
    [kLaptop, 28],
  ]) {
    await page.setViewport({ ...viewport, deviceScaleFactor: 0.25 });
    await ready(page);
    const found = await page.evaluate((size) => {
      const sheet = document.getElementById("sheet");
      const small = [
        ...document.querySelectorAll(
          "button, select, input:not([type=radio], [type=checkbox]), .choices label, .swatches label",
        ),
      ]
        .filter((control) => control.checkVisibility() && control.getBoundingClientRect().height < size)
        .map((control) => control.id || control.textContent);
      const wide = [...sheet.querySelectorAll("*")]
        .filter(
          (inner) =>
            !inner.closest("#looks, pre, .unseen, select") && inner.getBoundingClientRect().right > innerWidth + 1,
        )
        .map((inner) => inner.id || inner.className);
      return {
        small,
        wide,
        scrolls: document.documentElement.scrollWidth > innerWidth || sheet.scrollWidth > sheet.clientWidth,
      };
    }, least);
    assert.deepEqual(found, { small: [], wide: [], scrolls: false }, JSON.stringify(viewport));
  }
  await page.close();
});

test("light and dark have enough contrast", async () => {
  const page = await shownOnShared();
  for (const value of ["light", "dark"]) {
    await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value }]);
    const ratios = await page.evaluate(() => {
      const style = getComputedStyle(document.documentElement);
      const light = (name) => {
        const hex = style.getPropertyValue(name).trim().replace("#", "");
        const full = hex.length === 3 ? [...hex].map((digit) => digit + digit).join("") : hex;
        const parts = [0, 2, 4]
          .map((at) => parseInt(full.slice(at, at + 2), 16) / 255)
          .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));
        return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
      };
      const ratio = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
      return [
        ratio("--ink", "--paper"),
        ratio("--faint", "--paper"),
        ratio("--faint", "--code"),
        ratio("--on-accent", "--accent"),
        ratio("--ink", "--field"),
        ratio("--ink", "--chosen"),
        ratio("--wrong", "--paper"),
      ];
    });
    assert.ok(Math.min(...ratios) >= 4.5, `${value}: ${ratios}`);
  }
  await page.emulateMediaFeatures([]);
});

test("WebGPU draws, and where there is none the page says so and goes on", async () => {
  const page = await opened(await withWebGpu(), { link: "#renderer=webgpu", viewport: kLaptop });
  assert.match(await page.$eval("#gpu", (text) => text.textContent), /swiftshader/i);
  assert.equal(await page.$eval("#picture-webgpu", (canvas) => canvas.hidden), false);
  // Who asks twice until there is a device gets one.
  const same = await page.evaluate(async () => {
    delete window.hashnoise.backends.webgpu;
    const [one, two] = await Promise.all([window.hashnoise.backend(), window.hashnoise.backend()]);
    return one === two;
  });
  assert.ok(same);
  assert.deepEqual(page.complaints, []);
  await page.close();
  const without = await opened(browser, {
    link: "#renderer=webgpu",
    viewport: kLaptop,
    before: () => Object.defineProperty(navigator, "gpu", { value: undefined }),
  });
  assert.equal(await without.$eval("#renderer-webgpu", (choice) => choice.disabled), true);
  await without.waitForFunction(
    () => window.hashnoise.state.renderer === "webgl2" && !document.getElementById("picture-webgl2").hidden,
  );
  assert.equal(await without.$eval("#message", (message) => message.hidden), true);
  assert.match(await visibleText(without, "note-renderer"), /^WebGPU does not work in this browser/);
  await without.close();
});

test("a WebGPU that does not work leaves a sentence, and the focus", async () => {
  const page = await opened(browser, {
    viewport: kLaptop,
    before: () => {
      navigator.gpu.requestAdapter = async () => {
        throw new Error("raw text");
      };
    },
  });
  await page.evaluate(() => {
    window.messages = [];
    const message = document.getElementById("message");
    new MutationObserver(() => window.messages.push(message.textContent)).observe(message, {
      attributes: true,
      childList: true,
    });
  });
  assert.equal(await visibleText(page, "note-renderer"), "");
  await page.focus("#renderer-webgl2");
  await press(page, "ArrowRight");
  await page.waitForFunction(() => document.getElementById("renderer-webgpu").disabled);
  await wait(settled);
  const sentence = "WebGPU does not work in this browser, so WebGL2 draws the picture.";
  assert.equal(await visibleText(page, "note-renderer"), sentence);
  assert.equal(await focused(page), "renderer-webgl2");
  assert.equal((await stateOfPage(page)).renderer, "webgl2");
  const messages = await page.evaluate(() => window.messages);
  assert.ok(!messages.includes("raw text"), messages.join());
  await page.close();
});

test("Back undoes a look, and nothing else", async () => {
  const page = await opened(browser, { viewport: kLaptop, link: "#noise=value&octaves=3" });
  const back = async (seed) => {
    await page.evaluate(() => history.back());
    await page.waitForFunction((expected) => window.hashnoise.state.layers[0].seed === expected, {}, seed);
  };
  const entries = () => page.evaluate(() => history.length);
  const number = await entries();
  await page.click("#dice"); // not yet in the address when the look comes
  const before = await stateOfPage(page);
  await page.click("#looks button:nth-child(1)");
  assert.equal(await entries(), number + 1);
  await page.click("#looks button:nth-child(1)"); // which is shown already
  await page.click("#in");
  await wait(settled);
  assert.equal(await entries(), number + 1);
  await page.click("#looks button:nth-child(3)");
  await page.click("#in");
  await back(21);
  assert.equal((await stateOfPage(page)).sum, "fbm");
  assert.ok((await stateOfPage(page)).cells < 5);
  await back(before.seed);
  assert.deepEqual(await stateOfPage(page), before);
  await wait(settled);
  assert.equal(await page.evaluate(() => location.hash), `#noise=value&seed=${before.seed}&octaves=3`);
  await page.evaluate(() => history.forward());
  await page.waitForFunction(() => window.hashnoise.state.map === "land");
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("Back brings back what the picture did not use", async () => {
  const page = await shownOnShared("#dimensions=3&z=3.5");
  await page.click("#dimensions label:nth-child(2)");
  await page.click("#looks button:nth-child(1)");
  await page.evaluate(() => history.back());
  await page.waitForFunction(() => window.hashnoise.state.layers[0].seed === 7);
  await page.click("#dimensions label:nth-child(3)");
  assert.equal((await stateOfPage(page)).z, 3.5);
});

test("layers are added, chosen, moved, switched off and removed by the keyboard, and Back undoes it", async () => {
  const page = await shownOnShared("#sum=ridged&seed=3");
  const layers = async () => (await stateOfPage(page)).layers.map(({ sum, seed, on }) => `${sum} ${seed} ${on}`);
  const go = async (id, ...keys) => {
    await page.focus(`#${id}`);
    await press(page, ...keys);
  };
  assert.equal(await visibleText(page, "layers"), "");
  const one = await pixels(page, 16, 16);
  await go("add-layer", "Enter");
  assert.deepEqual(await layers(), ["ridged 3 1", "fbm 13 1"]);
  assert.equal(await visibleText(page, "heading-noise"), "Noise of layer 2");
  // The settings are those of the layer that is chosen.
  await go("blend", "ArrowDown");
  await go("seed", "ArrowUp");
  await go("weight", "ArrowLeft", "ArrowLeft");
  await go("layer-2", "ArrowUp");
  assert.equal(await visibleText(page, "heading-noise"), "Noise of layer 1");
  assert.equal(await page.$eval("#seed", (field) => field.value), "3");
  assert.deepEqual(await layers(), ["ridged 3 1", "fbm 14 1"]);
  assert.deepEqual(
    await page.$$eval("#layers li:not([hidden]) .layer", (rows) => rows.map((row) => row.textContent)),
    ["Ridged of Perlin", "× fBm of Perlin"],
  );
  assert.match(await page.$eval("#picture-webgl2", (canvas) => canvas.ariaLabel), /Ridged of Perlin, × fBm of Perlin/);
  assert.equal(
    await page.evaluate(() => window.hashnoise.link),
    "#sum=ridged&seed=3&seed2=14&blend2=multiply&weight2=0.9",
  );
  assert.match(await page.evaluate(() => window.hashnoise.controls.code), /v = v \* \(0\.9 \* layer_2\(p\)\);/);
  const two = await pixels(page, 16, 16);
  assert.notDeepEqual(two, one);
  await go("on-2", "Space");
  assert.deepEqual(await pixels(page, 16, 16), one);
  await go("on-2", "Space");
  await go("up-2", "Enter");
  assert.deepEqual(await layers(), ["fbm 14 1", "ridged 3 1"]);
  assert.equal(await focused(page), "up-1");
  await go("remove-2", "Enter");
  assert.deepEqual(await layers(), ["fbm 14 1"]);
  assert.equal(await focused(page), "add-layer");
  await page.evaluate(() => history.back());
  await page.waitForFunction(() => window.hashnoise.state.layers.length === 2);
  await page.evaluate(() => history.back());
  await page.waitForFunction(() => window.hashnoise.state.layers[0].sum === "ridged");
  assert.deepEqual(await pixels(page, 16, 16), two);
  assert.deepEqual(page.complaints, []);
});

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

test("Smaller undoes Larger", async () => {
  for (const link of ["#sum=none", "#sum=none&cells=7.3", "#sum=none&cells=0.723456", "#sum=none&cells=987654"]) {
    const page = await shownOnShared(link);
    const { cells } = await stateOfPage(page);
    for (const id of ["in", "in", "in", "out", "out", "out"]) await page.click(`#${id}`);
    assert.equal((await stateOfPage(page)).cells, cells);
    await page.focus("#cells");
    await press(page, "ArrowDown", "ArrowDown", "ArrowDown", "ArrowUp", "ArrowUp", "ArrowUp");
    assert.equal((await stateOfPage(page)).cells, cells);
  }
});

test("it says that it has copied only if it has", async () => {
  const page = await opened(browser, {
    viewport: kLaptop,
    before: () => {
      window.works = false;
      const writeText = async () => {
        if (!window.works) throw new Error("refused");
      };
      Object.defineProperty(navigator, "clipboard", { value: { writeText } });
      document.execCommand = () => false;
    },
  });
  const label = (id) => page.$eval(`#${id}`, (button) => button.textContent);
  for (const [id, expected] of [
    ["copy", await page.evaluate(() => window.hashnoise.controls.code)],
    ["link", kPage],
  ]) {
    const before = await label(id);
    await page.click(`#${id}`);
    assert.equal(await label(id), before);
    assert.match(await visibleText(page, "note-uncopied"), /did not let the page copy/);
    assert.match(await page.$eval("#said", (said) => said.textContent), /is not copied/);
    const selected = await page.evaluate(() => {
      const { value, selectionStart, selectionEnd } = document.activeElement;
      return value.slice(selectionStart, selectionEnd);
    });
    assert.equal(selected, expected);
  }
  await page.evaluate(() => (window.works = true));
  await page.click("#copy");
  assert.equal(await label("copy"), "Copied");
  assert.equal(await visibleText(page, "note-uncopied"), "");
  // The second time counts from its own beginning.
  await wait(1000);
  await page.click("#copy");
  await wait(1000);
  assert.equal(await label("copy"), "Copied");
  await wait(800);
  assert.equal(await label("copy"), "Copy");
  await page.close();
});

test("Play says why it does not", async () => {
  const page = await shownOnShared();
  const described = () =>
    page.$eval("#play", (button) => document.getElementById(button.getAttribute("aria-describedby")).textContent);
  assert.match(await described(), /^This picture does not move\. Choose 3D or 4D/);
  assert.equal(await visibleText(page, "hint"), "");
  for (const id of ["play", "picture-webgl2"]) {
    await page.focus(`#${id}`);
    await press(page, "Space");
    assert.equal(await visibleText(page, "hint"), await described());
    await page.waitForFunction(() => /does not move/.test(document.getElementById("said").textContent));
    await page.click("#dimensions label:nth-child(3)");
    assert.equal(await visibleText(page, "hint"), "");
    assert.equal(await described(), "");
    await page.click("#dimensions label:nth-child(2)");
  }
  assert.equal(await page.evaluate(() => window.hashnoise.playing), false);
});

test("a picture that plays leaves what is typed", async () => {
  const page = await shownOnShared("#dimensions=3");
  await page.click("#play");
  await page.click("#seed", { count: 3 });
  await page.keyboard.type("12");
  await wait(settled);
  assert.equal(await page.$eval("#seed", (field) => field.value), "12");
  await page.keyboard.press("Enter");
  await wait(settled);
  assert.equal(Number((await stateOfPage(page)).seed), 12);
});

test("a lost context comes back", async () => {
  const page = await opened(browser);
  const before = await pixels(page, 16, 16);
  await page.evaluate(async () => {
    const { gl } = window.hashnoise.backends.webgl2;
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
  const measure = async () => {
    await page.evaluate(() => window.hashnoise.measure());
    return page.$eval("#cost", (output) => output.textContent);
  };
  const plain = parseFloat(await measure());
  assert.ok(plain > 0.5 && plain < 2, `hn_perlin costs ${plain} times as much as itself`);
  await page.evaluate(() => window.hashnoise.change({ sum: "fbm", octaves: 4 }));
  assert.equal(await page.$eval("#cost", (output) => output.textContent), "Cost on this GPU");
  const sum = parseFloat(await measure());
  assert.ok(sum > 1.8 && sum > plain, `four octaves cost ${sum}`);
  assert.match(
    await page.$eval("#note-cost", (note) => note.textContent),
    /^That is pattern\(p\)\. From a cell, pattern\(cell, f\) costs [\d.]+ ×\. hn_perlin\(p\) in 2D, .* on ANGLE/,
  );
  // The button keeps the focus, and a second press does nothing meanwhile.
  const pressed = await page.evaluate(() => {
    const button = document.getElementById("measure");
    button.focus();
    button.click();
    button.click();
    return [button.ariaDisabled, document.activeElement.id, document.getElementById("cost").textContent];
  });
  assert.deepEqual(pressed, ["true", "measure", "Measuring …"]);
  await page.waitForFunction(() => document.getElementById("measure").ariaDisabled === "false");
  assert.equal(await focused(page), "measure");
  await page.close();
});
