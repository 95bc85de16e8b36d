// The values of a picture: how far they go, and how often each is.

const kBins = 40;
const kTenths = 10; // for people who hear the histogram

// {least, greatest, mean, below, above, bins}: `below` and `above` are the shares of the values beyond the colours,
// which go from `low` to `high`; of each of the bins, which divide the colours evenly, there is the share in it.
export function summaryOf(values, [low, high]) {
  const bins = new Array(kBins).fill(0);
  let [least, greatest, sum, below, above] = [Infinity, -Infinity, 0, 0, 0];
  for (const value of values) {
    least = Math.min(least, value);
    greatest = Math.max(greatest, value);
    sum += value;
    if (value < low) ++below;
    else if (value > high) ++above;
    else ++bins[Math.min(Math.floor(((value - low) / (high - low)) * kBins), kBins - 1)];
  }
  const share = (count) => count / values.length;
  return { least, greatest, mean: share(sum), below: share(below), above: share(above), bins: bins.map(share) };
}

const shown = (value) => String(Number(value.toFixed(3)) || 0).replace("-", "−");
export const percent = (share) => `${share > 0 && share < 0.01 ? "less than 1" : Math.round(share * 100)} %`;

export function wordsOf({ least, greatest, mean, below, above }, [low, high]) {
  const beyond = below + above > 0 ? `; ${percent(below)} of the values are below, and ${percent(above)} above` : "";
  return (
    `The values are from ${shown(least)} to ${shown(greatest)}, and ${shown(mean)} in the mean. ` +
    `The colours go from ${shown(low)} to ${shown(high)}${beyond}.`
  );
}

// On which share of values a layer counts.
export const coveredBy = (values, { from, soft }) =>
  values.reduce((sum, value) => sum + Math.min(Math.max((value - from) / soft, 0), 1), 0) / values.length;

// The colours of the histogram of these values: black where the layer does not count, and white where it does.
export function edgeIn([low, high], { from, soft }) {
  const stops = [[from, "#000"], [from + soft, "#fff"]].sort(([one], [other]) => one - other);
  const place = (value) => `${(((value - low) / (high - low || 1)) * 100).toFixed(2)}%`;
  return `linear-gradient(90deg, ${stops.map(([value, colour]) => `${colour} ${place(value)}`).join(", ")})`;
}

// The histogram in words, and as a shape for CSS.
export function histogramOf({ bins }) {
  const size = kBins / kTenths;
  const parts = Array.from({ length: kTenths }, (_, part) =>
    percent(bins.slice(part * size, (part + 1) * size).reduce((sum, share) => sum + share)),
  );
  const most = Math.max(...bins, 1e-9);
  const steps = bins.flatMap((share, at) => [at, at + 1].map((x) => [x / kBins, 1 - share / most]));
  const place = (corner) => corner.map((side) => `${(side * 100).toFixed(2)}%`).join(" ");
  const corners = [[0, 1], ...steps, [1, 1]].map(place);
  return {
    words: `Histogram: of ten equal parts of the colours, from the lowest, each has ${parts.join(", ")} of the values.`,
    shape: `polygon(${corners.join(", ")})`,
  };
}
