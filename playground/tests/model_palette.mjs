// Maps of colours, those of one's own among them. model_test.mjs runs it.
import assert from "node:assert/strict";
import test from "node:test";
import { linkOf, stateOf } from "../links.js";
import { changed, chosen, usualState } from "../model.js";
import {
  canLoseStop, gradientOf, kMostStops, paletteOf, stopsOf, stopsOfMap, withAnotherStop, withoutStop, withStop,
} from "../palette.js";
import { kMaps } from "../tables.js";

const own = (stops) => ({ map: "own", stops });
const colour = (bytes, at) => [...bytes.subarray(4 * at, 4 * at + 4)];

// (pixels_test.mjs compares those of the page's own maps.)
test("a map has the colours of its stops, mixed between them", () => {
  // Before the first stop and behind the last one there is one colour, and two stops in one place are an edge.
  const bytes = paletteOf(own("20-102030_60-506070_60-ff0000_80-00ff00"));
  for (const [at, expected] of [
    [0, [16, 32, 48, 255]], [51, [16, 32, 48, 255]], [102, [48, 64, 80, 255]], [152, [79, 95, 111, 255]],
    [153, [255, 0, 0, 255]], [204, [0, 255, 0, 255]], [255, [0, 255, 0, 255]],
  ])
    assert.deepEqual(colour(bytes, at), expected, at);
  assert.equal(gradientOf(own("0-102030_60-506070")), "linear-gradient(90deg, #102030 0%, #506070 60%)");
  assert.notDeepEqual(paletteOf(own("0-102030_60-506070")), paletteOf(own("0-102030_61-506070")));
});

test("a map of one's own begins with the one that is shown, and is kept", () => {
  let state = chosen(changed(usualState(), { map: "land" }), { map: "own" });
  assert.deepEqual(stopsOf(state.stops).map((stop) => stop.colour), kMaps.land.stops);
  assert.deepEqual(stopsOf(state.stops).map((stop) => stop.place), [0, 14, 29, 43, 57, 71, 86, 100]);
  state = chosen(state, { stops: withStop(state.stops, 1, { colour: "00ff00" }) });
  assert.match(linkOf(state), /^#map=own&stops=0-0b2447_14-00ff00_29-4aa3bf_/);
  assert.equal(stateOf(linkOf(state)).stops, state.stops);
  const other = chosen(state, { map: "moss" });
  assert.equal(linkOf(other), "#map=moss");
  assert.equal(chosen(other, { map: "own" }).stops, state.stops);
});

test("stops are moved between their neighbours, added and removed", () => {
  const text = "0-000000_40-808080_100-ffffff";
  assert.equal(withStop(text, 1, { place: 70 }), "0-000000_70-808080_100-ffffff");
  assert.equal(withStop(text, 1, { place: 170 }), "0-000000_100-808080_100-ffffff");
  assert.equal(withStop(text, 0, { place: 55 }), "40-000000_40-808080_100-ffffff");
  assert.equal(withStop(text, 2, { colour: "ff0000" }), "0-000000_40-808080_100-ff0000");
  // One more changes no colour but for what is rounded.
  const { text: more, at } = withAnotherStop(text);
  assert.deepEqual([more, at], ["0-000000_40-808080_70-c0c0c0_100-ffffff", 2]);
  const [before, after] = [paletteOf(own(text)), paletteOf(own(more))];
  assert.ok(before.every((part, i) => Math.abs(part - after[i]) <= 1));
  assert.equal(withAnotherStop("60-000000_90-ffffff").text, "30-000000_60-000000_90-ffffff");
  let most = text;
  for (let i = 0; i < 9; ++i) ({ text: most } = withAnotherStop(most));
  assert.equal(stopsOf(most).length, kMostStops);
  assert.equal(withAnotherStop(stopsOfMap("land")).at, undefined);
  assert.equal(withoutStop(text, 1), "0-000000_100-ffffff");
  assert.equal(withoutStop("0-000000_100-ffffff", 1), "0-000000_100-ffffff");
  assert.deepEqual([canLoseStop(text), canLoseStop("0-000000_100-ffffff")], [true, false]);
});
