// LZMA, as Python's lzma module writes it raw (tools/lib/ship/playground/picks.py): lc 3, lp 0, pb 0. The names are those
// of the LZMA specification, which is in the public domain. Browsers unpack gzip alone, which leaves twice as much.

const kTop = 2 ** 24;
const kHalf = 1024; // a probability of a half, in steps of 2^-11
const kStates = 12;
const kAlignBits = 4;
const kEndPosModel = 14;
const kSlice = 1 << 16; // bytes, after which other work of the page gets its turn

const probabilities = (count) => new Uint16Array(count).fill(kHalf);

class RangeDecoder {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 5; // the first byte is always 0
    this.range = 0xffffffff;
    this.code = new DataView(bytes.buffer, bytes.byteOffset).getUint32(1);
  }

  normalize() {
    if (this.range >= kTop) return;
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.bytes[this.at++]) >>> 0;
  }

  bit(table, index) {
    const probability = table[index];
    const bound = (this.range >>> 11) * probability;
    const bit = this.code < bound ? 0 : 1;
    if (bit) {
      this.range -= bound;
      this.code -= bound;
      table[index] = probability - (probability >> 5);
    } else {
      this.range = bound;
      table[index] = probability + ((2048 - probability) >> 5);
    }
    this.normalize();
    return bit;
  }

  direct(count) {
    let result = 0;
    for (; count > 0; --count) {
      this.range >>>= 1;
      const bit = this.code >= this.range ? 1 : 0;
      if (bit) this.code -= this.range;
      result = result * 2 + bit;
      this.normalize();
    }
    return result;
  }

  // A number of so many bits, the highest or the lowest first, from `from` on in the table.
  tree(table, count, from = 0) {
    let m = 1;
    for (let i = 0; i < count; ++i) m = 2 * m + this.bit(table, from + m);
    return m - (1 << count);
  }

  reverse(table, count, from = 0) {
    let [m, result] = [1, 0];
    for (let i = 0; i < count; ++i) {
      const bit = this.bit(table, from + m);
      m = 2 * m + bit;
      result |= bit << i;
    }
    return result;
  }
}

class Lengths {
  constructor() {
    [this.choice, this.low, this.middle, this.high] = [2, 8, 8, 256].map(probabilities);
  }

  next(decoder) {
    if (!decoder.bit(this.choice, 0)) return 2 + decoder.tree(this.low, 3);
    if (!decoder.bit(this.choice, 1)) return 10 + decoder.tree(this.middle, 3);
    return 18 + decoder.tree(this.high, 8);
  }
}

// All `size` bytes.
export async function unpackedLzma(bytes, size) {
  const decoder = new RangeDecoder(bytes);
  const out = new Uint8Array(size);
  const literals = probabilities(0x300 << 3);
  const [isMatch, isRep, isRep0, isRep1, isRep2, isRep0Long] = Array.from({ length: 6 }, () => probabilities(kStates));
  const slots = Array.from({ length: 4 }, () => probabilities(64));
  const special = probabilities(128);
  const align = probabilities(1 << kAlignBits);
  const [lengths, repeated] = [new Lengths(), new Lengths()];
  let [rep0, rep1, rep2, rep3, state, at, rest] = [0, 0, 0, 0, 0, 0, kSlice];
  while (at < size) {
    if (at > rest) {
      rest = at + kSlice;
      await new Promise((resolve) => setTimeout(resolve));
    }
    if (!decoder.bit(isMatch, state)) {
      const from = 0x300 * ((at ? out[at - 1] : 0) >> 5);
      let symbol = 1;
      if (state >= 7) {
        let match = out[at - rep0 - 1];
        while (symbol < 256) {
          const matched = (match >> 7) & 1;
          match <<= 1;
          const bit = decoder.bit(literals, from + ((1 + matched) << 8) + symbol);
          symbol = 2 * symbol + bit;
          if (matched !== bit) break;
        }
      }
      while (symbol < 256) symbol = 2 * symbol + decoder.bit(literals, from + symbol);
      out[at++] = symbol - 256;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length;
    if (decoder.bit(isRep, state)) {
      if (!decoder.bit(isRep0, state)) {
        if (!decoder.bit(isRep0Long, state)) {
          state = state < 7 ? 9 : 11;
          out[at] = out[at - rep0 - 1];
          ++at;
          continue;
        }
      } else if (!decoder.bit(isRep1, state)) {
        [rep0, rep1] = [rep1, rep0];
      } else if (!decoder.bit(isRep2, state)) {
        [rep0, rep1, rep2] = [rep2, rep0, rep1];
      } else {
        [rep0, rep1, rep2, rep3] = [rep3, rep0, rep1, rep2];
      }
      length = repeated.next(decoder);
      state = state < 7 ? 8 : 11;
    } else {
      [rep1, rep2, rep3] = [rep0, rep1, rep2];
      length = lengths.next(decoder);
      state = state < 7 ? 7 : 10;
      const slot = decoder.tree(slots[Math.min(length - 2, 3)], 6);
      if (slot < 4) {
        rep0 = slot;
      } else {
        const bits = (slot >> 1) - 1;
        rep0 = (2 | (slot & 1)) * 2 ** bits;
        if (slot < kEndPosModel) rep0 += decoder.reverse(special, bits, rep0 - slot);
        else rep0 += decoder.direct(bits - kAlignBits) * 16 + decoder.reverse(align, kAlignBits);
      }
    }
    for (const end = Math.min(at + length, size); at < end; ++at) out[at] = out[at - rep0 - 1];
  }
  return out;
}
