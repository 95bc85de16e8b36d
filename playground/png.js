// PNG files, some rows at a time, so that a large picture is never in memory as a whole.

const kSignature = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);
const kGrey = 0;
const kRgb = 2;
const kByLeft = 1; // the filter that writes each byte as its difference from that of the pixel on the left

const kCrcs = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crcOf(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = kCrcs[(crc ^ byte) & 255] ^ (crc >>> 8);
  return ~crc >>> 0;
}

// The length, the type, the bytes and their checksum.
function chunk(type, bytes) {
  const whole = new Uint8Array(bytes.length + 12);
  const view = new DataView(whole.buffer);
  view.setUint32(0, bytes.length);
  whole.set(new TextEncoder().encode(type), 4);
  whole.set(bytes, 8);
  view.setUint32(bytes.length + 8, crcOf(whole.subarray(4, bytes.length + 8)));
  return whole;
}

export class Png {
  // The picture has one channel of 16 bits, or three of 8. The comment is in ASCII.
  constructor(width, height, deep, comment) {
    this.rowBytes = width * (deep ? 2 : 3);
    this.pixelBytes = deep ? 2 : 3;
    const header = new DataView(new ArrayBuffer(13));
    header.setUint32(0, width);
    header.setUint32(4, height);
    header.setUint8(8, deep ? 16 : 8);
    header.setUint8(9, deep ? kGrey : kRgb);
    const stream = new CompressionStream("deflate");
    this.writer = stream.writable.getWriter();
    this.compressed = new Response(stream.readable).arrayBuffer();
    this.head = [
      kSignature,
      chunk("IHDR", new Uint8Array(header.buffer)),
      chunk("tEXt", new TextEncoder().encode(`Comment\0${comment}`)),
    ];
  }

  // The next rows from the top on, in the order of bytes of the file.
  add(bytes) {
    const rows = bytes.length / this.rowBytes;
    const filtered = new Uint8Array(bytes.length + rows);
    for (let row = 0, from = 0, to = 0; row < rows; ++row) {
      filtered[to++] = kByLeft;
      for (let at = 0; at < this.rowBytes; ++at, ++from)
        filtered[to++] = bytes[from] - (at < this.pixelBytes ? 0 : bytes[from - this.pixelBytes]);
    }
    return this.writer.write(filtered);
  }

  async parts() {
    await this.writer.close();
    return [...this.head, chunk("IDAT", new Uint8Array(await this.compressed)), chunk("IEND", new Uint8Array())];
  }
}
