// Positions and numbers, as links have them.

// A position is a whole number of these parts of a cell: a BigInt of 56 bits, since cells wrap at 2^32.
export const kParts = 16777216n;
const kDigits = 100000000n;  // of a fraction in a link: finer than a part, so that a part comes back as it was
const kLimit = 2147483648n * kParts;  // positions are from -2^31 cells up to below 2^31

export const wrapped = (parts) => BigInt.asIntN(56, parts);

export function positionText(parts) {
  const size = parts < 0n ? -parts : parts;
  const whole = size / kParts;
  const digits = ((size % kParts) * kDigits + kParts / 2n) / kParts;
  const fraction = digits.toString().padStart(8, "0").replace(/0+$/, "");
  return `${parts < 0n ? "-" : ""}${whole}${fraction ? `.${fraction}` : ""}`;
}

// A number as links have it, such as -12.5, .5, 3e-4 or Infinity, and nothing for another text. One too large for a
// float becomes an infinity, and possible() makes the largest allowed number of that.
export const parsedNumber = (text) =>
  /^[-+]?(?:Infinity|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)$/.test(text) ? Number(text) : undefined;

// The position nearest to a number. Without a power of ten it is exact: a float has too few digits far out.
export function parsedPosition(text) {
  const number = parsedNumber(text);
  if (number === undefined) return undefined;
  const [, sign, whole, fraction] = /^([-+]?)(\d*)\.?(\d*)$/.exec(text) ?? [];
  if (whole === undefined || Math.abs(number) > 2 ** 32) {
    const parts = Math.round(Math.min(Math.max(number, -(2 ** 32)), 2 ** 32) * Number(kParts));
    return within(BigInt(parts));
  }
  const ten = 10n ** BigInt(fraction.length);
  const size = (BigInt(`0${whole}${fraction}`) * kParts + ten / 2n) / ten;
  return within(sign === "-" ? -size : size);
}
const within = (parts) => (parts < -kLimit ? -kLimit : parts >= kLimit ? kLimit - 1n : parts);
export const isLastPosition = (parts) => parts === -kLimit || parts === kLimit - 1n;

// A scale has six digits, but for its limits.
export const scaleWithin = (cells, { from, to }) => Math.min(Number(Math.max(cells, from).toPrecision(6)), to);
