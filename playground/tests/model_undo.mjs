// Undoing. model_test.mjs runs it.
import assert from "node:assert/strict";
import test from "node:test";
import { stateOfLook } from "../links.js";
import { changed, chosen, usualState } from "../model.js";
import { Steps } from "../undo.js";

// A page without a page: `change` is at so many milliseconds behind the last one.
function visit() {
  let time = 0;
  const steps = new Steps(() => time);
  const page = {
    state: usualState(),
    change(after, changes, at = 0) {
      time += after;
      const next = chosen(page.state, changes, at);
      steps.note(page.state, next, [at, ...Object.keys(changes)].join(" "));
      page.state = next;
    },
    replace(next) {
      steps.note(page.state, next);
      page.state = next;
    },
    step(how) {
      const next = steps[how](page.state);
      if (next) page.state = next;
      return next !== undefined;
    },
    get shown() {
      return `${page.state.layers.map(({ gain, seed }) => `${gain} ${seed}`).join()} ${page.state.contrast}`;
    },
  };
  return page;
}

test("another change takes the place of what was undone", () => {
  const page = visit();
  page.change(10, { gain: 0.6 });
  page.change(10, { contrast: 2 });
  assert.ok(page.step("undo"));
  page.change(10, { contrast: 3 });
  assert.ok(!page.step("redo"));
  assert.ok(page.step("undo"));
  assert.equal(page.shown, "0.6 7 1");
});

test("one slider that is moved is one step", () => {
  const page = visit();
  for (const gain of [0.51, 0.52, 0.53, 0.6]) page.change(300, { gain });
  page.change(5000, { gain: 0.8 });
  page.change(10, { gain: 0.9 }, 1); // of a layer that there is not
  page.change(10, { seed: 9 });
  page.step("undo");
  assert.equal(page.shown, "0.8 7 1");
  page.step("undo");
  assert.equal(page.shown, "0.6 7 1");
  page.step("undo");
  assert.equal(page.shown, "0.5 7 1");
  assert.ok(!page.step("undo"));
  // After an undo the same slider begins a step.
  page.change(10, { gain: 0.6 });
  page.step("undo");
  page.change(10, { gain: 0.7 });
  page.change(10, { gain: 0.8 });
  page.step("undo");
  assert.equal(page.shown, "0.5 7 1");
  // A change that comes back to where it was, or changes nothing, is no step.
  page.change(10, { gain: 0.6 });
  page.change(10, { gain: 0.5 });
  page.change(10, { gain: 0.5 });
  assert.ok(!page.step("undo"));
});

test("a look and a list of layers are a step each, and what plays goes on", () => {
  const page = visit();
  page.change(10, { gain: 0.6 });
  page.replace(stateOfLook("Peaks", page.state));
  page.change(10, { seed: 77 }, 1);
  page.state = changed(page.state, { z: 5 });
  page.step("undo");
  assert.equal(page.state.layers[1].seed, 5);
  assert.equal(page.state.z, 5);
  page.step("undo");
  assert.deepEqual([page.shown, page.state.map, page.state.z], ["0.6 7 1", "dusk", 5]);
  page.step("redo");
  assert.equal(page.state.layers.length, 3);
});

test("so many steps are kept, and the oldest are forgotten", () => {
  const page = visit();
  for (let seed = 10; seed < 260; ++seed) page.change(2000, { seed });
  let count = 0;
  while (page.step("undo")) ++count;
  assert.deepEqual([count, page.shown], [200, "0.5 59 1"]);
});
