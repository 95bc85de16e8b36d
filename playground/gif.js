// Moving pictures as GIF files: they have 256 colours, as a map has, so nothing is lost.

const kDelay = 4; // hundredths of a second that a frame is shown
const kDepth = 8; // bits of a pixel
const kClearCode = 1 << kDepth;
const kEndCode = kClearCode + 1;
const kMostCodes = 4096;
const kBlock = 255; // bytes

const little = (...words) => words.flatMap((word) => [word & 255, word >> 8]);

// Codes of growing length, the lowest bit first.
class Codes {
  constructor() {
    this.bytes = [];
    this.held = 0;
    this.count = 0;
  }

  add(code, length) {
    this.held |= code << this.count;
    for (this.count += length; this.count >= 8; this.count -= 8, this.held >>>= 8) this.bytes.push(this.held & 255);
  }
}

// The pixels compressed by LZW. A string is the code of all but its last pixel, and that pixel.
function compressed(pixels) {
  const codes = new Codes();
  const strings = new Map(); // their codes
  let [next, length] = [0, kDepth + 1];
  const clear = () => {
    codes.add(kClearCode, length);
    strings.clear();
    [next, length] = [kEndCode + 1, kDepth + 1];
  };
  clear();
  let prefix = pixels[0];
  for (const pixel of pixels.subarray(1)) {
    const string = (prefix << 8) | pixel;
    const code = strings.get(string);
    if (code !== undefined) {
      prefix = code;
      continue;
    }
    codes.add(prefix, length);
    prefix = pixel;
    if (next === kMostCodes) {
      clear();
      continue;
    }
    strings.set(string, next);
    if (next++ === 1 << length) ++length;
  }
  codes.add(prefix, length);
  // Who reads has one string more now.
  codes.add(kEndCode, next === 1 << length && length < 12 ? length + 1 : length);
  codes.add(0, 7);
  return codes.bytes;
}

export class Gif {
  // The palette has four bytes for each of 256 colours.
  constructor(width, height, palette) {
    this.size = [width, height];
    const colours = Array.from(palette).filter((_, at) => at % 4 < 3);
    this.parts = [
      Uint8Array.from([...new TextEncoder().encode("GIF89a"), ...little(width, height), 0xf7, 0, 0, ...colours]),
      // Without an end: from the last frame on to the first.
      Uint8Array.from([0x21, 0xff, 11, ...new TextEncoder().encode("NETSCAPE2.0"), 3, 1, 0, 0, 0]),
    ];
  }

  // The numbers of the colours of a frame, from the upper row on.
  add(pixels) {
    const bytes = compressed(pixels);
    const blocks = [];
    for (let at = 0; at < bytes.length; at += kBlock) {
      const block = bytes.slice(at, at + kBlock);
      blocks.push(Uint8Array.of(block.length, ...block));
    }
    const head = [0x21, 0xf9, 4, 0, ...little(kDelay), 0, 0, 0x2c, ...little(0, 0, ...this.size), 0, kDepth];
    this.parts.push(Uint8Array.from(head), ...blocks, Uint8Array.of(0));
  }

  done() {
    return [...this.parts, Uint8Array.of(0x3b)];
  }
}
