// Moving pictures as WebM files: VP9 or VP8, as the browser encodes it, in one cluster.

const kDuration = 40; // milliseconds that a frame is shown
const kBitsOfPixel = 0.5; // of a frame
const kWaiting = 4; // frames that the encoder may be behind
const kCodecs = { V_VP9: "vp09.00.51.08", V_VP8: "vp8" }; // by their names in the file

const wordOf = (number) => {
  const bytes = [];
  do bytes.unshift(number % 256);
  while ((number = Math.floor(number / 256)) > 0);
  return Uint8Array.from(bytes);
};
const doubleOf = (number) => {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, number);
  return new Uint8Array(view.buffer);
};

// The parts of an element of the file: its number, its length in five bytes, and its content.
function elementOf(id, ...content) {
  const kinds = { number: wordOf, string: (text) => new TextEncoder().encode(text) };
  const parts = content.flat().map((part) => kinds[typeof part]?.(part) ?? part);
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  return [wordOf(id), wordOf(8 * 2 ** 32 + length), ...parts];
}

export class WebM {
  // Throws if the browser makes none.
  static async create(width, height) {
    const settings = { width, height, framerate: 1000 / kDuration, bitrate: (kBitsOfPixel * width * height * 1000) / kDuration };
    for (const [name, codec] of Object.entries(kCodecs)) {
      const supported = await globalThis.VideoEncoder?.isConfigSupported({ codec, ...settings });
      if (supported?.supported) return new WebM(name, supported.config);
    }
    const where = globalThis.VideoEncoder ? "of this size" : `on a page from ${location.protocol}//`;
    throw new Error(`This browser makes no WebM ${where}. Choose another file, such as a GIF.`);
  }

  constructor(name, config) {
    this.name = name;
    this.config = config;
    this.blocks = [];
    this.count = 0;
    this.encoder = new VideoEncoder({ output: (chunk) => this.take(chunk), error: (error) => (this.error = error) });
    this.encoder.configure(config);
  }

  take(chunk) {
    const time = Math.round(chunk.timestamp / 1000);
    const block = new Uint8Array(4 + chunk.byteLength);
    block.set([0x81, time >> 8, time & 255, chunk.type === "key" ? 0x80 : 0]);
    chunk.copyTo(block.subarray(4));
    this.blocks.push(elementOf(0xa3, block));
  }

  // The colours of a frame, four bytes a pixel, from the upper row on.
  async add(picture) {
    const { width, height } = this.config;
    const [timestamp, duration] = [this.count++, 1].map((frames) => frames * kDuration * 1000);
    const frame = new VideoFrame(picture, { format: "RGBX", codedWidth: width, codedHeight: height, timestamp, duration });
    this.encoder.encode(frame);
    frame.close();
    while (this.encoder.encodeQueueSize > kWaiting) await new Promise((resolve) => setTimeout(resolve, 4));
    if (this.error) throw this.error;
  }

  async done() {
    await this.encoder.flush();
    const { width, height } = this.config;
    const app = "hashnoise";
    const video = elementOf(0xe0, elementOf(0xb0, width), elementOf(0xba, height));
    return [
      ...elementOf(0x1a45dfa3, elementOf(0x4282, "webm"), elementOf(0x4287, 4), elementOf(0x4285, 2)),
      ...elementOf(
        0x18538067,
        elementOf(0x1549a966, elementOf(0x2ad7b1, 1e6), elementOf(0x4489, doubleOf(this.count * kDuration)), elementOf(0x4d80, app), elementOf(0x5741, app)),
        elementOf(0x1654ae6b, elementOf(
          0xae, elementOf(0xd7, 1), elementOf(0x73c5, 1), elementOf(0x83, 1), elementOf(0x86, this.name),
          elementOf(0x23e383, kDuration * 1e6), video,
        )),
        elementOf(0x1f43b675, elementOf(0xe7, 0), ...this.blocks),
      ),
    ];
  }

  stop() {
    if (this.encoder.state !== "closed") this.encoder.close();
  }
}
