// Positions and numbers, as people and links write them.

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

const kMostPower = 1000000000;  // beyond it a power of ten is as good as this one

// The parts of a number as people and programs write it, such as -12.5, 1,25, .5, 3e-4 or Infinity: its sign, its
// digits, and the power of ten that they are multiplied by. Nothing if it is no number.
function partsOfNumber(text) {
  const match = /^\s*([-+−]?)(?:(Infinity)|(?=[.,]?\d)(\d*)(?:[.,](\d*))?(?:e([-+−]?\d+))?)\s*$/i.exec(text);
  if (!match) return undefined;
  const [, sign, infinite, whole = "", fraction = "", exponent = "0"] = match;
  const power = Number(exponent.replace("−", "-"));
  return {
    negative: sign === "-" || sign === "−",
    digits: infinite ? "1" : (whole + fraction).replace(/^0+/, ""),
    power: infinite ? kMostPower : Math.max(-kMostPower, Math.min(power, kMostPower)) - fraction.length,
  };
}

// A number that is too large for a float becomes an infinity, and possible() makes the largest allowed number of that.
export function parsedNumber(text) {
  const parts = partsOfNumber(text);
  if (!parts) return undefined;
  const { negative, digits, power } = parts;
  const size = Number(`${digits || "0"}e${power}`);
  return negative ? -size : size;
}

// Exact, and the nearest position that there is for a number that is none.
export function parsedPosition(text) {
  const parts = partsOfNumber(text);
  if (!parts) return undefined;
  const { negative, digits, power } = parts;
  const places = digits.length + power; // in front of the point
  if (!digits || places < -9) return 0n;
  if (places > 10) return negative ? -kLimit : kLimit - 1n;
  const scaled = BigInt(digits) * kParts;
  const ten = 10n ** BigInt(Math.abs(power));
  const size = power < 0 ? (scaled + ten / 2n) / ten : scaled * ten;
  if (size >= kLimit) return negative ? -kLimit : kLimit - 1n;
  return negative ? -size : size;
}

// Whether a number lies beyond all positions, so that parsedPosition gives the last one.
export function isBeyondPositions(text) {
  const number = parsedNumber(text);
  return number < -2147483648 || number >= 2147483648;
}

// A scale has six digits, but for its limits.
export const scaleWithin = (cells, { from, to }) => Math.min(Number(Math.max(cells, from).toPrecision(6)), to);

// Whether two texts are one number, however they are written.
export function sameNumber(one, other) {
  const plain = (text) => {
    const { negative, digits, power } = partsOfNumber(text);
    const shortest = digits.replace(/0+$/, "");
    return shortest ? `${negative ? "-" : ""}${shortest}e${power + digits.length - shortest.length}` : "0";
  };
  return plain(one) === plain(other);
}
