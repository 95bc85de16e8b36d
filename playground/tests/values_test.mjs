// The summary of the values of a picture.
import assert from "node:assert/strict";
import test from "node:test";
import { histogramOf, summaryOf, wordsOf } from "../values.js";

const close = (one, other) => Math.abs(one - other) < 1e-12;

test("how far values go, and how many each part of the colours has", () => {
  const range = [-0.5, 0.5];
  const values = [-1, -0.5, -0.5, -0.26, 0, 0.2, 0.499, 0.5, 0.75, 2];
  const summary = summaryOf(values, range);
  assert.deepEqual([summary.least, summary.greatest, summary.below, summary.above], [-1, 2, 0.1, 0.2]);
  assert.ok(close(summary.mean, 0.1689));
  // Fortieths: the lowest one, that of -0.26, and so on; the end of the colours belongs to the last.
  const filled = summary.bins.flatMap((share, bin) => (share ? [[bin, Math.round(share * 10)]] : []));
  assert.deepEqual(filled, [[0, 2], [9, 1], [20, 1], [28, 1], [39, 2]]);
  assert.equal(
    wordsOf(summary, range),
    "The values are from −1 to 2, and 0.169 in the mean. The colours go from −0.5 to 0.5; " +
      "10 % of the values are below, and 20 % above.",
  );
  const { words, shape } = histogramOf(summary);
  assert.match(words, /^Histogram: .* each has 20 %, 0 %, 10 %, 0 %, 0 %, 10 %, 0 %, 10 %, 0 %, 20 % of the values\.$/);
  assert.match(shape, /^polygon\(0\.00% 100\.00%, 0\.00% 0\.00%, 2\.50% 0\.00%, 2\.50% 100\.00%, /);
  assert.match(shape, /22\.50% 50\.00%, 25\.00% 50\.00%/);
});

test("values within the colours need no words, and few beyond them are called few", () => {
  const many = [...Array(1000).fill(0.25), 3];
  assert.match(wordsOf(summaryOf(many.slice(0, -1), [0, 1]), [0, 1]), /from 0\.25 to 0\.25, .* from 0 to 1\.$/);
  assert.match(wordsOf(summaryOf(many, [0, 1]), [0, 1]), /; 0 % of the values are below, and less than 1 % above\.$/);
  assert.match(wordsOf(summaryOf([-0.0001, 0], [-1, 1]), [-1, 1]), /^The values are from 0 to 0, and 0 in the mean/);
});
