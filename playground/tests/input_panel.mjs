// The panel, as people use it: fields, sliders, layers, the clipboard. input_test.mjs runs it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { resolve } from "node:path";
import test from "node:test";
import {
  browser, focused, keepCopies, kLaptop, kThorough, press, settled, shownOnShared, tabTo, visibleText, wait,
} from "./input_support.mjs";
import { kPhone, kRoot, opened, pixels, ready, stateOfPage } from "./support.mjs";

test("a keyboard alone is enough", async () => {
  const page = await opened(browser, { viewport: kLaptop, before: keepCopies });
  await press(page, "Tab");
  assert.equal(await focused(page), "picture-webgl2");
  await press(page, "ArrowRight", "ArrowUp", "ArrowUp", "+");
  let state = await stateOfPage(page);
  assert.ok(state.x > 0n && state.y > 0n && state.cells < 8);
  const step = await page.evaluate(() => Math.round((8 / Math.min(...window.hashnoise.size)) * 16777216));
  assert.equal(state.x % BigInt(step), 0n); // the picture goes by whole pixels
  await press(page, "Home", "r", "-");
  state = await stateOfPage(page);
  assert.ok(state.x === 0n && state.y === 0n && state.cells > 8 && state.seed !== 7);

  for (const [id, ...keys] of [
    ["sum", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown"],
    ["noise", "ArrowDown"],
    ["dimensions-2", "ArrowRight"],
    ["octaves", "ArrowRight", "ArrowRight"],
    ["z", "ArrowLeft"],
    ["seed", "9", "9", "Enter", "ArrowUp"], // Tab selects the number
    ["map-dusk", "ArrowRight"],
    ["arithmetic-fast", "ArrowRight"],
    ["language", "ArrowDown", "ArrowDown"],
    ["copy", "Enter"],
  ]) {
    await tabTo(page, id);
    await press(page, ...keys);
  }
  state = await stateOfPage(page);
  assert.deepEqual(
    [state.sum, state.noise, state.dimensions, state.octaves, state.z, state.seed, state.map, state.arithmetic],
    ["ridged", "value", 3, 8, 0.36, 100, "lagoon", "fixed"],
  );
  const copies = (await page.evaluate(() => window.copies)).join();
  assert.match(copies, /fn pattern\(p: vec3f\)/);
  assert.match(copies, /fn hn_add_ridged3/);

  await page.evaluate(() => document.getElementById("picture-webgl2").focus());
  const before = (await stateOfPage(page)).z;
  await press(page, "Space");
  await page.waitForFunction((z) => window.hashnoise.state.z > z + 0.02, {}, before);
  await press(page, "Space");
  assert.equal(await page.evaluate(() => window.hashnoise.playing), false);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("a field takes the numbers of its setting, and leaves others to the browser", async () => {
  const page = await shownOnShared("#dimensions=3&cells=8.5");
  for (const [id, typed, key, value, isValid = true] of [
    ["seed", "1e3", "Enter", 1000],
    ["seed", "5000000000", "Enter", 1000, false],
    ["seed", "2.5", "Enter", 1000, false],
    ["seed", "41", "ArrowUp", 42], // a typed text counts, whether or not it is entered
    ["period", "-4", "Enter", 0, false],
    ["cells", "7.25", "Tab", 7.25],
    ["x", "1000000000.5", "Enter", (1000000000n << 24n) + (1n << 23n)],
    ["x", "nowhere", "Tab", (1000000000n << 24n) + (1n << 23n), false],
    ["y", "2.5e1", "ArrowDown", 24n << 24n],
  ]) {
    await page.click(`#${id}`, { count: 3 });
    await page.keyboard.press("Delete");
    await page.keyboard.type(typed);
    await press(page, key);
    const found = [(await stateOfPage(page))[id], await page.$eval(`#${id}`, (input) => input.validity.valid)];
    assert.deepEqual(found, [value, isValid], `${typed} in ${id}`);
  }
  await page.click("#home"); // shows the numbers as they are
  assert.equal(await page.$eval("#x", (input) => input.value), "0");
});

test("the values of the picture are in words", async () => {
  const page = await shownOnShared("#sum=ping_pong&seed=77");
  await page.waitForFunction(() => document.getElementById("values").textContent);
  await wait(settled);
  const [, least, greatest] = /^The values are from (\S+) to (\S+), and/.exec(await visibleText(page, "values"));
  const values = new Float32Array(new Uint32Array(await pixels(page, 85, 48, true)).buffer);
  assert.ok(Math.abs(Math.min(...values) - least.replace("−", "-")) < 0.001);
  assert.ok(Math.abs(Math.max(...values) - greatest) < 0.001);
  assert.match(await page.$eval("#histogram", (shown) => shown.ariaLabel), /^Histogram: of ten equal parts/);
});

// The findings of axe-core, by the names of its rules: names, contrast and so on.
async function foundByAxe(page) {
  await page.evaluate(await readFile(resolve("node_modules", "axe-core", "axe.min.js"), "utf8"));
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join()}`);
}

test("axe finds nothing", async () => {
  const page = await shownOnShared("#sum=none&noise=cellular&blend2=add&sum2=none&period=3&dimensions=3&file=gif&map=own");
  // It reads no colours of what lies on glass.
  const paper = await page.addStyleTag({ content: "#panel, #tools, #readout { background: var(--paper); backdrop-filter: none; }" });
  assert.deepEqual(await foundByAxe(page), []);
  await page.click("#view label:nth-child(3)");
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  assert.deepEqual(await foundByAxe(page), []);
  await page.emulateMediaFeatures([]);
  // A button without a name, and letters as light as what is faint in the dark, which have too little contrast.
  const name = await page.$eval("#up-2", (button) => {
    button.textContent = button.title = "";
    const { ariaLabel } = button;
    button.ariaLabel = null;
    document.documentElement.style.setProperty("--ink", "#999");
    return ariaLabel;
  });
  const found = (await foundByAxe(page)).map((one) => one.split(":")[0]);
  assert.deepEqual(found.toSorted(), ["button-name", "color-contrast"]);
  await page.$eval("#up-2", (button, label) => Object.assign(button, { ariaLabel: label, textContent: "↑" }), name);
  await page.evaluate(() => document.documentElement.style.removeProperty("--ink"));
  await paper.evaluate((tag) => tag.remove());
});

test("it fits a phone", async () => {
  const page = await opened(browser, {
    viewport: { ...kPhone, deviceScaleFactor: 0.25 },
    link: "#sum=ping_pong&noise=cells&dimensions=3&warp=warp&metric=manhattan&blend2=mix&sum2=none&blend3=add&map=own",
  });
  for (const [viewport, least] of [
    [kPhone, 40],
    [{ ...kPhone, width: 320, height: 568 }, 40],
    [{ ...kPhone, width: 844, height: 390 }, 40],
    [{ width: 1400, height: 900 }, 28],
  ]) {
    await page.setViewport({ ...viewport, deviceScaleFactor: 0.25 });
    await ready(page);
    await page.$eval("#layer-2", (radio) => radio.click()); // another kind of device loads the page again
    const found = await page.evaluate((size) => {
      const sheet = document.getElementById("sheet");
      const controls = "button, select, input:not([type=radio], [type=checkbox]), .choices label, .swatches label";
      const small = [...document.querySelectorAll(controls)]
        .filter((control) => control.checkVisibility() && control.getBoundingClientRect().height < size)
        .map((control) => control.id || control.textContent);
      const isWide = (inner) => !inner.closest("#looks, pre, .unseen, select") && inner.getBoundingClientRect().right > innerWidth + 1;
      const wide = [...sheet.querySelectorAll("*")].filter(isWide).map((inner) => inner.id || inner.className);
      const cut = [...document.querySelectorAll(".row > select")].filter((select) => {
        const width = select.offsetWidth;
        select.style.width = "max-content"; // as wide as the widest of its choices
        const whole = select.offsetWidth;
        select.style.width = "";
        return width < whole;
      });
      return {
        small,
        wide,
        cut: innerWidth > 320 && innerHeight > 390 ? cut.map((select) => select.id) : [], // small phones have no room
        scrolls: document.documentElement.scrollWidth > innerWidth || sheet.scrollWidth > sheet.clientWidth,
      };
    }, least);
    assert.deepEqual(found, { small: [], wide: [], cut: [], scrolls: false }, JSON.stringify(viewport));
  }
  await page.close();
});

test("layers are added, chosen, moved, switched off and removed by the keyboard, and undone", async () => {
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
    ["Ridged of PerlinBase · seed 3", "fBm of PerlinMultiply · seed 14"],
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
  await page.click("#undo");
  await page.click("#undo");
  assert.deepEqual(await pixels(page, 16, 16), two);
  assert.deepEqual(page.complaints, []);
});

test("a mask of about a third is chosen, shown, steered, and undone in one step", async () => {
  const page = await shownOnShared("#sum=none&noise=value&map=ember&blend2=add&sum2=none");
  const covered = () => visibleText(page, "covered");
  await page.click("#layer-2");
  assert.equal(await covered(), "");
  await page.select("#blend", "height");
  await page.waitForFunction(() => /3\d %$/.test(document.getElementById("covered").textContent));
  const { from, soft } = (await stateOfPage(page)).layers[1];
  assert.ok(from > -0.5 && from < 0.5 && soft > 0.1, `${from}, ${soft}`);
  await page.click("#mask");
  const bytes = await pixels(page, 40, 22);
  assert.ok(bytes.every((byte, at) => at % 4 === 3 || byte === bytes[at - (at % 4)])); // grey
  const mean = bytes.reduce((sum, byte, at) => sum + (at % 4 ? 0 : byte), 0) / (bytes.length / 4) / 255;
  assert.ok(mean > 0.25 && mean < 0.42, `${mean}`);
  await page.waitForFunction(() => /rgb\(0, 0, 0\)/.test(document.getElementById("bars").style.background));
  await page.focus("#from");
  await press(page, "End");
  await page.waitForFunction(() => /Counts on (less than 1|0) %/.test(document.getElementById("covered").textContent));
  await page.click("#undo");
  await page.click("#undo");
  assert.equal(await page.evaluate(() => window.hashnoise.link), "#sum=none&noise=value&map=ember&sum2=none&blend2=add");
  assert.deepEqual([await covered(), await page.$eval("#mask", (button) => button.ariaPressed)], ["", "false"]);
  assert.deepEqual(page.complaints, []);
});

test("each setting that is open has one line, which the glossary has", async () => {
  const page = await shownOnShared("#sum=ping_pong&noise=cellular&dimensions=3&warp=warp&metric=manhattan&view=terrain&blend2=height&noise2=middle&sum2=none&blend3=mix");
  const glossary = await readFile(resolve(kRoot, "docs", "reference", "glossary.md"), "utf8");
  await page.setViewport({ width: 1400, height: 900, deviceScaleFactor: 0.125 });
  const seen = new Set();
  for (const layer of [1, 2, 3]) {
    await page.click(`#layer-${layer}`);
    const found = await page.$$eval(".row", (rows) =>
      rows.filter((row) => row.checkVisibility() && row.id).map((row) => {
        const line = row.querySelector(":scope > small");
        return [row.id.slice(4), line?.textContent, line && line.offsetHeight < 1.6 * parseFloat(getComputedStyle(line).fontSize)];
      }));
    for (const [name, line, isOne] of found) {
      seen.add(name);
      if (["sum", "noise", "x", "y", "cells", "turn", "tilt", "ease", "kind", "file", "width", "height"].includes(name)) continue; // a note, or the name, is enough
      assert.ok(isOne, `${name}: ${line}`);
      assert.ok(glossary.includes(`| ${line.replace(/\.$/, "")} |`), `${name}: ${line}`);
    }
  }
  for (const name of ["lacunarity", "gain", "jitter", "warp", "period", "seed", "from", "soft", "radius", "sea"]) assert.ok(seen.has(name), name);
  await page.setViewport(kLaptop);
  await ready(page);
});

test("a map of one's own is made by the keyboard", async () => {
  const page = await shownOnShared("#sum=none&noise=value&map=ember");
  const go = async (id, ...keys) => {
    await page.focus(`#${id}`);
    await press(page, ...keys);
  };
  const before = await pixels(page, 16, 16);
  await go("edit-map", "Enter");
  assert.equal(await focused(page), "picked-1");
  assert.match((await stateOfPage(page)).stops, /^0-050308_20-3a0a0f_.*_100-fff2c2$/);
  await go("remove-stop-3", "Enter");
  await go("place-1", "PageUp");
  const pick = (id, colour) =>
    page.$eval(id, (picker, value) => Object.assign(picker, { value }).dispatchEvent(new Event("input")), colour);
  await pick("#picked-2", "#ffee00");
  await go("add-stop", "Enter");
  assert.equal(await focused(page), "place-3");
  await pick("#picked-3", "#00aa00");
  const { stops } = await stateOfPage(page);
  assert.match(stops, /^10-050308_20-ffee00_40-00aa00_60-d94a12_80-f7a027_100-fff2c2$/);
  assert.equal(await page.evaluate(() => window.hashnoise.link), `#sum=none&noise=value&map=own&stops=${stops}`);
  assert.notDeepEqual(await pixels(page, 16, 16), before);
  // A mask has colours of its own in the same place.
  await shownOnShared("#sum=none&map=grey&file=normals&blend2=mask&sum2=none");
  assert.equal(await visibleText(page, "heading-colours"), "Colours");
  await go("layer-1", "ArrowDown");
  assert.equal(await visibleText(page, "heading-colours"), "Colours where layer 2 counts");
  await go("map-none", ...Array(6).fill("ArrowRight"));
  assert.equal(await page.evaluate(() => window.hashnoise.link), "#sum=none&map=grey&file=normals&sum2=none&blend2=mask&tint2=moss");
  await go("edit-map", "Enter");
  await go("place-1", "PageUp");
  assert.match(await page.evaluate(() => window.hashnoise.link), /&map=grey&.*&tint2=own&tints2=10-10140f_20-26331f_/);
  // Relief is where it is of use, and Save names its kind.
  assert.equal(await page.$eval("#row-file", (row) => row.nextElementSibling.id), "row-steep");
  assert.equal(await visibleText(page, "save"), "Save PNG");
  assert.deepEqual(page.complaints, []);
});

test("Smaller undoes Larger", async () => {
  for (const number of kThorough ? ["8", "7.3", "0.723456", "987654"] : ["7.3", "0.723456"]) {
    const page = await shownOnShared(`#sum=none&cells=${number}`);
    const { cells } = await stateOfPage(page);
    for (const id of ["in", "in", "in", "out", "out", "out"]) await page.click(`#${id}`);
    assert.equal((await stateOfPage(page)).cells, cells);
  }
});

test("a button shows that it has copied only if it has", async () => {
  const page = await opened(browser, {
    viewport: kLaptop,
    before: () => {
      window.works = false;
      const writeText = async () => {
        if (!window.works) throw new Error("refused");
      };
      Object.defineProperty(navigator, "clipboard", { value: { writeText } });
      // The call by which a button ends to show that it has copied waits here.
      window.held = new Set();
      const [set, clear] = [window.setTimeout, window.clearTimeout];
      window.setTimeout = (call, time, ...rest) => (time === 1500 ? window.held.add(call) && call : set(call, time, ...rest));
      window.clearTimeout = (id) => window.held.delete(id) || clear(id);
    },
  });
  const label = (id) => page.$eval(`#${id}`, (button) => button.textContent);
  for (const [id, expected] of [
    ["copy", await page.evaluate(() => window.hashnoise.controls.code)],
    ["link", "#"],
  ]) {
    const before = await label(id);
    await page.click(`#${id}`);
    assert.equal(await label(id), before);
    assert.match(await visibleText(page, "note-uncopied"), /did not let the page copy/);
    for (const viewport of [kLaptop, { ...kPhone, width: 320, deviceScaleFactor: 0.25 }]) {
      await page.setViewport({ ...viewport, hasTouch: false, isMobile: false }); // another kind of device loads the page again
      const found = await page.evaluate(() => {
        const box = (name) => document.getElementById(name).getBoundingClientRect();
        return [box("text-uncopied").width / box("bar").width, box("copy").height, box("copy").top - box("uncopied").bottom];
      });
      assert.ok(found[0] > 0.85 && found[1] < 50 && found[2] >= 0, `${viewport.width}: ${found}`);
    }
    await page.setViewport(kLaptop);
    assert.match(await page.$eval("#status", (said) => said.textContent), /is not copied/);
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
  await page.click("#copy");
  assert.equal(await page.evaluate(() => window.held.size), 1);
  assert.equal(await label("copy"), "Copied");
  await page.evaluate(() => window.held.forEach((call) => call()));
  assert.equal(await label("copy"), "Copy");
  await page.close();
});

test("Play states why it does not play", async () => {
  const page = await shownOnShared();
  const described = () =>
    page.$eval("#play", (button) => document.getElementById(button.getAttribute("aria-describedby")).textContent);
  assert.match(await described(), /^This picture does not move\. Choose a drift, 3D or 4D/);
  assert.equal(await visibleText(page, "hint"), "");
  for (const id of ["play", "picture-webgl2"]) {
    await page.focus(`#${id}`);
    await press(page, "Space");
    assert.equal(await visibleText(page, "hint"), await described());
    await page.waitForFunction(() => /does not move/.test(document.getElementById("status").textContent));
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
  // Layers that drift move by the time, and the slice stays.
  const before = await stateOfPage(page);
  await page.evaluate(() => window.hashnoise.change({ driftx: 0.5 }));
  await page.waitForFunction(() => window.hashnoise.state.time > 0.1);
  await page.click("#play"); // it would play on beside the other tests
  assert.ok(before.z > 0.37 && (await stateOfPage(page)).z < before.z + 0.25, `${before.z}`);
});

test("copy, save and link are in sight, and the settings hide", async () => {
  const page = await shownOnShared("#seed=3");
  for (const viewport of [{ width: 1440, height: 900 }, { ...kPhone, width: 390 }]) {
    await page.setViewport({ ...viewport, deviceScaleFactor: 0.125 });
    await ready(page); // another kind of device loads the page again
    const boxes = () =>
      page.$$eval("#copy, #save, #link", (buttons) =>
        buttons.map((button) => button.getBoundingClientRect()).map(({ top, right, bottom, height }) =>
          height > 0 && top >= 0 && bottom <= innerHeight && right <= innerWidth));
    assert.deepEqual(await boxes(), [true, true, true]);
    await page.focus("#picture-webgl2");
    await press(page, "h");
    // On a phone the bar stays.
    assert.deepEqual(await boxes(), Array(3).fill(viewport.width < 700));
    assert.equal(await page.$eval("#octaves", (slider) => slider.checkVisibility()), false);
    await page.$eval(viewport.width < 700 ? "#handle" : "#hide", (button) => button.click());
    assert.equal(await page.$eval("#octaves", (slider) => slider.checkVisibility()), true);
  }
  await press(page, "?");
  assert.match(await page.$eval("dialog[open]", (list) => list.textContent), /Home.*another seed.*hide or show/s);
  assert.deepEqual(await foundByAxe(page), []);
  await press(page, "Escape");
  await page.setViewport(kLaptop);
  await ready(page);
});

test("two settings are side by side, and a wrong link has a message", async () => {
  const page = await shownOnShared("#sum=fmb&seed=4");
  assert.match(await visibleText(page, "hint"), /does not know: sum=fmb/);
  await page.click("#compare");
  await page.evaluate(() => window.hashnoise.change({ seed: 5, map: "land" }));
  await page.waitForFunction(() => !document.getElementById("picture-kept").hidden);
  await page.click("#exchange");
  assert.deepEqual(await page.evaluate(() => [window.hashnoise.link, window.hashnoise.comparison.kept.map]), ["#seed=4", "land"]);
  await page.click("#compare");
  assert.equal(await page.$eval("#picture-kept", (canvas) => canvas.hidden), true);
  await page.click("#surprise");
  assert.notEqual(await page.evaluate(() => window.hashnoise.link), "#seed=4");
  assert.deepEqual(page.complaints, []);
});
