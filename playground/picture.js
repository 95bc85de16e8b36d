// The picture: what draws the state, how finely, and what else reads its pixels.
import { shaderKey } from "./code.js";
import { byId } from "./elements.js";
import { fileOf, fileState, framesOf, planeOf } from "./files.js";
import { linkOf } from "./links.js";
import { isLoop, mapsOf, rangeOf, reliefHeight } from "./model.js";
import { wrapped } from "./numbers.js";
import { gradientOf, paletteOf, palettesOf } from "./palette.js";
import { onBackdrop, reliefOf, surfaceOf } from "./relief.js";
import { frameOf, kBits, kColours, pageShader } from "./shaders.js";
import { Speed } from "./speed.js";
import { originOf, partsOf, stepOf } from "./view.js";
import { WebGL2 } from "./webgl.js";

export const kCanvases = ["picture-webgl2", "picture-terrain"];
const kSideOfTerrain = 384; // values, at rest
const kSideOfMoving = 128;
const kFinestTerrain = 1024;
const kPixelsOfTerrain = 1.2e6;
const kPixelsOfFirstTerrain = 1e5; // so that a page that opens with terrain shows something soon
const kPixelsOfSharpTerrain = 8e6;
const kColumnPixels = 5e5; // that are drawn between two looks at what else the page has to do
const kKeptPrograms = 24;
const kMostPixels = 16e6;
const kMoving = 34; // milliseconds that a picture may take while it moves; else it is drawn coarser
const kResting = 1200; // when it rests; one that takes longer is drawn finer in steps, until it is sharp
const kStrip = 40; // milliseconds that a part of a picture takes; between two the page and the GPU do other things
const kMostStrips = 256; // of a picture, since one waits for each
const kCoarsest = 8;
const kRest = 160; // milliseconds without a change after which it is drawn fine again
const kPatience = 250; // milliseconds after which the page shows that it draws

// It draws `state`. Whoever extends this has four functions, too: begun() is called when there is the first picture,
// drawn() each time that there is one, rested() some time after the last change, and failed(error) when there is no
// picture.
export class Picture {
  constructor(library, state) {
    this.library = library;
    this.state = state;
    this.programs = new Map();
    this.speeds = new WeakMap(); // by the program
    this.moves = false;
  }

  // Terrain is drawn on a canvas of its own, of the values that the GPU computes.
  get canvas() {
    return byId(kCanvases[this.seen.view === "terrain" ? 1 : 0]);
  }

  // The state that is drawn.
  get seen() {
    return this.state;
  }

  chooseCanvas() {
    for (const canvas of kCanvases.map(byId)) canvas.hidden = canvas !== this.canvas;
  }

  get gpu() {
    if (!this.webgl || this.webgl.lost) {
      this.programs.clear();
      this.webgl = new WebGL2(byId(kCanvases[0]));
    }
    return this.webgl;
  }

  async program(state) {
    const key = shaderKey(state);
    let found = this.programs.get(key);
    this.programs.delete(key);
    if (!found) {
      const { gpu } = this;
      found = await gpu.build(pageShader(this.library, state));
      if (this.programs.size >= kKeptPrograms) {
        const [oldest, program] = this.programs.entries().next().value;
        this.programs.delete(oldest);
        gpu.discard(program);
      }
    }
    this.programs.set(key, found);
    return found;
  }

  usePalette(state) {
    const maps = mapsOf(state);
    const colours = maps.map(gradientOf).join(" ");
    if (this.gpu.colours === colours) return;
    this.gpu.colours = colours;
    this.gpu.setPalette(palettesOf(maps));
  }

  // The size of the picture in pixels of the screen.
  get size() {
    const box = this.canvas.getBoundingClientRect();
    let ratio = window.devicePixelRatio || 1;
    ratio *= Math.min(1, Math.sqrt(kMostPixels / Math.max(1, box.width * box.height * ratio * ratio)));
    return [Math.max(1, Math.round(box.width * ratio)), Math.max(1, Math.round(box.height * ratio))];
  }

  // Something moves: a slow picture is drawn coarser until it rests.
  restless() {
    this.moves = true;
    clearTimeout(this.restTimer);
    this.restTimer = setTimeout(() => {
      this.moves = false;
      if (this.coarse > 1) this.request();
      this.rested().catch(() => {}); // who has no picture has read why
    }, kRest);
  }

  // How many pixels of the screen on a side a pixel of the next picture has: at first so many that it takes no longer
  // than one that moves may, and then fewer with every picture.
  coarseness(speed, [width, height], first) {
    const within = (milliseconds) => Math.max(1, Math.ceil(Math.sqrt((width * height) / speed.pixelsIn(milliseconds))));
    return first ? Math.min(kCoarsest, within(kMoving)) : Math.min(Math.ceil(this.coarse / 2), within(kResting));
  }

  async speedOf(program, state) {
    if (!this.speeds.has(program)) {
      const size = this.size;
      const area = size[0] * size[1];
      const time = async (pixels) => {
        const [width, height] = size.map((side) => Math.max(1, Math.round(side * Math.sqrt(pixels / area))));
        const frame = this.frameSeen(state, width, height);
        return this.timedStrip(program, frame, width, height, 0, height);
      };
      this.speeds.set(program, await Speed.measured(time, area));
    }
    return this.speeds.get(program);
  }

  // Which part of the width of the picture the panel leaves: it lies on the picture, or beside or below it.
  get free() {
    const box = this.canvas.getBoundingClientRect();
    const { left } = byId("panel").getBoundingClientRect();
    return left > box.left + box.width / 3 && left < box.right ? (left - box.left) / box.width : 1;
  }

  // The frame of the picture that people see.
  frameSeen(state, width, height) {
    return frameOf(state, width, height, kColours, { free: Math.round(width * this.free) });
  }

  async timedStrip(...strip) {
    const start = performance.now();
    this.gpu.strip(...strip);
    await this.gpu.finished();
    return performance.now() - start;
  }

  // Draws a picture in strips where nobody sees it. One that is not the first of a state gives way as soon as another
  // is wanted: false.
  async drawHidden(program, speed, state, width, height, first) {
    const frame = this.frameSeen(state, width, height);
    const least = Math.ceil(height / kMostStrips);
    for (let row = 0; row < height; ) {
      if (row > 0 && this.wanted && !first) return false;
      const rows = Math.min(height - row, Math.max(least, Math.floor(speed.pixelsIn(kStrip) / width)));
      speed.learn(rows * width, await this.timedStrip(program, frame, width, height, row, rows));
      row += rows;
    }
    return true;
  }

  // Shows that a picture is being drawn, if that takes long.
  tell(draws) {
    if (draws) {
      this.drawingTimer ??= setTimeout(() => (byId("drawing").hidden = false), kPatience);
      return;
    }
    clearTimeout(this.drawingTimer);
    this.drawingTimer = undefined;
    byId("drawing").hidden = true;
  }

  // Draws soon, and once for all changes until then.
  request() {
    this.wanted = true;
    if (!this.drawing) this.drawing = this.drawWhatIsWanted().finally(() => (this.drawing = undefined));
    return this.drawing;
  }

  async drawWhatIsWanted() {
    while (this.wanted) {
      this.wanted = false;
      this.tell(true);
      await new Promise((resolve) => (document.hidden ? setTimeout(resolve) : requestAnimationFrame(resolve)));
      try {
        await this.draw();
        byId("message").hidden = true;
      } catch (error) {
        this.tell(false);
        this.failed(error);
        if (!this.wanted) this.begun();
      }
    }
  }

  async draw() {
    const wanted = this.state;
    const state = { ...this.seen };
    const program = await this.program(state);
    this.usePalette(state);
    if (state.view === "terrain") return this.drawTerrain(program, state, wanted);
    const speed = await this.speedOf(program, state);
    const size = this.size;
    const first = this.moves || this.shown !== wanted;
    const coarse = this.coarseness(speed, size, first);
    const [width, height] = size.map((side) => Math.max(1, Math.round(side / coarse)));
    if (!(await this.drawHidden(program, speed, state, width, height, first))) return;
    this.gpu.show();
    await this.wasDrawn(wanted, coarse);
  }

  async wasDrawn(wanted, coarse) {
    this.shown = wanted;
    this.begun();
    this.coarse = coarse;
    if (coarse === 1 || this.moves) this.tell(false);
    else this.wanted = true;
    byId("gpu").textContent = `Drawn by ${this.gpu.describe()}.`;
    await this.drawn();
  }

  // The bytes of a square with so many pixels on a side, in strips between which the page does other things. Nothing if it
  // gives way to another picture that is wanted meanwhile.
  async squareOf(program, state, side, mode, givesWay = true) {
    const bytes = new Uint8Array(4 * side * side);
    // To measure the speed takes longer than to draw a small one.
    const speed = side > kSideOfMoving && (await this.speedOf(program, state));
    for (let row = 0; row < side; ) {
      if (row > 0 && this.wanted && givesWay) return undefined;
      const most = speed ? Math.floor(speed.pixelsIn(kStrip) / side) : side;
      const rows = Math.min(side - row, Math.max(Math.ceil(side / kMostStrips), most));
      const frame = frameOf(state, side, side, mode, { first: row, rows });
      bytes.set(await this.gpu.read(program, frame, side, rows), 4 * row * side);
      row += rows;
    }
    return bytes;
  }

  // The heights and the colours of terrain with so many values on a side, or nothing.
  async surfaceFor(program, state, side, givesWay) {
    const values = await this.squareOf(program, state, side, kBits, givesWay);
    const hasTints = mapsOf(state).length > 1;
    const colours = hasTints && (await this.squareOf(program, state, side, kColours, givesWay));
    if (!values || colours === undefined) return undefined;
    const shape = { steep: reliefHeight(state), sea: state.sea };
    return surfaceOf(new Float32Array(values.buffer), side, rangeOf(state), paletteOf(state), shape, colours);
  }

  // The surface is kept, since often the block is only rotated. At rest it first has as many values as it takes to look
  // right, and then as many as the screen shows.
  async drawTerrain(program, state, wanted) {
    const finest = Math.min(kFinestTerrain, Math.max(kSideOfTerrain, Math.min(...this.size)));
    const key = linkOf({ ...state, turn: 0, tilt: 0, width: 0, height: 0 });
    const had = this.surface?.key === key ? this.surface.side : 0;
    const side = this.moves ? Math.max(had, kSideOfMoving) : had < kSideOfTerrain ? kSideOfTerrain : finest;
    if (had !== side) {
      const surface = await this.surfaceFor(program, state, side);
      if (!surface) return;
      this.surface = { key, ...surface };
    }
    const sharp = !this.moves && side === finest;
    const most = sharp ? kPixelsOfSharpTerrain : this.shown ? kPixelsOfTerrain : kPixelsOfFirstTerrain;
    const [width, height] = this.size.map(
      (length, _, size) => Math.ceil(length * Math.min(1, Math.sqrt(most / (size[0] * size[1])))),
    );
    const bytes = new Uint8ClampedArray(4 * width * height);
    const columns = sharp ? Math.ceil(kColumnPixels / height) : width;
    for (let column = 0; column < width; column += columns) {
      reliefOf(this.surface, state, width, height, Math.round(width * this.free), bytes, [column, column + columns], sharp ? 2 : 1);
      if (!sharp) continue;
      await new Promise((resolve) => setTimeout(resolve));
      if (this.wanted) return;
    }
    const canvas = byId("picture-terrain");
    Object.assign(canvas, { width, height });
    canvas.getContext("2d", { willReadFrequently: true }).putImageData(new ImageData(bytes, width, height), 0, 0);
    await this.wasDrawn(wanted, sharp ? 1 : 2);
  }

  // Four bytes a pixel from the lower left corner on, of a picture of this size: of colours, or of the bits of values.
  async pixels(width, height, mode = kColours, state = { ...this.seen }) {
    const program = await this.program(state);
    this.usePalette(state);
    return this.gpu.read(program, frameOf(state, width, height, mode), width, height);
  }

  async file(tell) {
    const state = fileState(this.state);
    const program = await this.program(isLoop(state) ? framesOf(state)[0] : state);
    this.usePalette(state);
    const { width, height } = state;
    if (state.view === "terrain" && state.file === "colours") {
      const side = Math.min(kFinestTerrain, Math.max(kSideOfTerrain, Math.min(width, height)));
      const bytes = reliefOf(await this.surfaceFor(program, state, side, false), state, width, height);
      return fileOf(state, onBackdrop(bytes, width, height), tell);
    }
    const read = (mode, first, rows, shown, border) => {
      if (!border) return this.gpu.read(program, frameOf(shown, width, height, mode, { first, rows }), width, rows);
      const step = BigInt(stepOf(shown, width, height));
      const [x, y] = originOf(shown, width, height);
      const corner = [wrapped(x - step), wrapped(y + step * BigInt(first - 1)), partsOf(shown.z), partsOf(shown.w)];
      const frame = frameOf(shown, width, height, mode, { position: corner, rows: rows + 2 });
      return this.gpu.read(program, frame, width + 2, rows + 2);
    };
    return fileOf(state, read, tell);
  }

  // The values at these points, each [x, y, z, w] in parts of a cell.
  async values(points) {
    const state = planeOf(this.seen);
    const program = await this.program(state);
    const values = new Float32Array(points.length);
    for (const [i, point] of points.entries()) {
      const bytes = await this.gpu.read(program, frameOf(state, 1, 1, kBits, { position: point }), 1, 1);
      values[i] = new DataView(bytes.buffer).getFloat32(0, true);
    }
    return values;
  }
}
