// The page: the state, the picture, and what moves it.
import { shaderKey } from "./code.js";
import { Controls } from "./controls.js";
import { Comparison } from "./compare.js";
import { costOf } from "./cost.js";
import { byId } from "./elements.js";
import { linkInFile, planeOf } from "./files.js";
import { Histogram } from "./histogram.js";
import { anywhere, listen, listKeys, undoing } from "./input.js";
import { firstState, ignoredIn, linkOf, stateOf, stateOfLook } from "./links.js";
import { changed, chosen, isTurned, kSettings, titlesOf, uses } from "./model.js";
import { positionText } from "./numbers.js";
import { kCanvases, Picture } from "./picture.js";
import { Library, unpacked } from "./pieces.js";
import { kViews } from "./tables.js";
import { randomized } from "./randomize.js";
import { Steps } from "./undo.js";
import { panned, partsOf, positionOfPixel, zoomed } from "./view.js";

const kLinkDelay = 300; // browsers refuse an address that changes too often
const kStill = "This picture does not move. Choose a drift, 3D or 4D, or one octave of Perlin or simplex noise in 2D.";
const kLocal =
  "A page from a disk has no address for others, so the part from # on is copied. Put it behind the address of a " +
  "playground on a web site.";
const kTurnOfPixel = 0.0008; // turns by a pixel
const kTold = 1500; // milliseconds for which a button shows that it has copied
const kSpeed = 0.25; // cells, or turns over four, in a second

class Playground extends Picture {
  constructor(library) {
    super(library, location.href.includes("#") ? stateOf(location.hash) : firstState());
    this.labelTimers = new Map(); // by the button
    this.steps = new Steps();
    this.playing = false;
    this.pointer = undefined; // where the value is read
    this.controls = new Controls(library, {
      change: (changes, at) => this.change(changes, at),
      chose: () => this.take(this.state),
      look: (name) => this.look(name),
      replace: (state, said) => this.replace(state, said),
      say: (sentence) => this.say(sentence),
    });
    this.histogram = new Histogram(this);
    byId("drawing").hidden = false; // until there is a picture
  }

  // ------------------------------------------------------------------------------------------------------------------
  // The state.

  // The state with these settings, as they are.
  with(changes, at = this.controls.layer) {
    return changed(this.state, changes, at);
  }

  // Settings of this layer, and of the whole picture.
  change(changes, at = this.controls.layer) {
    const next = chosen(this.state, changes, at);
    const key = [at, ...Object.keys(changes)].join(" ");
    this.steps.note(this.state, next, key);
    this.take(next);
    if (changes.blend) this.histogram.ease(at, key).catch(() => {});
  }

  // The state that is drawn: of a mask, while the button shows it.
  get seen() {
    return this.histogram?.mask ?? this.state;
  }

  take(state) {
    this.state = state;
    if (this.playing && !this.animated) this.play(false);
    byId("play").setAttribute("aria-disabled", String(!this.animated));
    byId("play").title = this.animated ? "Play (space)" : kStill;
    byId("still").textContent = this.animated ? "" : kStill;
    for (const id of ["in", "out"]) byId(id).ariaDisabled = String(!uses(state).cells);
    for (const [id, { length }] of [["undo", this.steps.done], ["redo", this.steps.undone]])
      byId(id).ariaDisabled = String(length === 0);
    if (!this.playing) {
      byId("hint").hidden = true;
      this.controls.showUncopied();
    }
    this.controls.show(state);
    this.histogram.offerMask();
    this.describe();
    if (this.measured && this.measured !== this.costKey) {
      byId("cost").textContent = "Cost on this GPU";
      byId("note-cost").hidden = true;
      this.measured = undefined;
    }
    this.chooseCanvas();
    this.restless();
    this.request();
    clearTimeout(this.linkTimer);
    this.linkTimer = setTimeout(() => this.writeLink(), kLinkDelay);
  }

  // A change of more than a setting.
  replace(next, said) {
    this.steps.note(this.state, next);
    this.take(next);
    byId("status").textContent = said;
  }

  look(name) {
    this.replace(stateOfLook(name, this.state), `${name} is shown. Undo takes it back.`);
  }

  // One step back, or forth again.
  step(how, said) {
    const next = this.steps[how](this.state);
    if (!next) return;
    this.take(next);
    this.say(said);
  }

  undo() {
    this.step("undo", "The last change is undone.");
  }

  redo() {
    this.step("redo", "The change is there again.");
  }

  // The words are new each time, so that they are read aloud each time.
  say(sentence) {
    byId("status").textContent = "";
    requestAnimationFrame(() => (byId("status").textContent = sentence));
  }

  get link() {
    return linkOf(this.state);
  }

  writeLink() {
    clearTimeout(this.linkTimer);
    try {
      history.replaceState(null, "", this.link || "#"); // without a link the page opens with another picture
    } catch {
      // A page in a frame without an address of its own has no link. Copying one still works.
    }
  }

  describe() {
    const { state } = this;
    const titles = titlesOf(state).join(", ");
    const kind = isTurned(state) ? kViews[state.view] : "Picture";
    this.canvas.setAttribute("aria-describedby", isTurned(state) ? "keys-turned" : "keys");
    this.canvas.setAttribute("aria-label", `${kind} of ${titles} noise in ${state.dimensions}D`);
    const coordinate = (parts) => {
      const [whole, fraction = ""] = positionText(parts).split(".");
      const digits = Math.max(0, Math.min(6, Math.ceil(Math.log10(400 / state.cells))));
      return digits ? `${whole}.${fraction.padEnd(digits, "0").slice(0, digits)}` : whole;
    };
    const { x, y } = this.probed ?? state;
    byId("where").textContent =
      state.dimensions === 1 ? `x ${coordinate(x)}` : `x ${coordinate(x)}  y ${coordinate(y)}`;
    if (!this.probed) byId("value").textContent = "";
  }

  failed(error) {
    if (this.webgl?.lost) return; // it comes back
    byId("message").textContent = error.message;
    byId("message").hidden = false;
  }

  async drawn() {
    if (this.probed) await this.probe();
  }

  async rested() {
    this.controls.markLook();
    // Reading in the frame in which a picture was drawn can take the picture from the screen.
    await this.drawing;
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    await this.histogram.draw();
    await this.comparison.draw();
  }

  // The value below the pointer.
  async probe() {
    if (!this.pointer || this.probing || isTurned(this.state)) return;
    this.probing = true;
    try {
      const { state } = this;
      const box = this.canvas.getBoundingClientRect();
      const [width, height] = this.size;
      const column = Math.floor(((this.pointer.x - box.left) / box.width) * width);
      const row = height - 1 - Math.floor(((this.pointer.y - box.top) / box.height) * height);
      const [x, y] = positionOfPixel(state, width, height, column, row);
      const [value] = await this.values([[x, y, partsOf(state.z), partsOf(state.w)]]);
      this.probed = { x, y };
      byId("value").textContent = value.toFixed(4).replace("-", "−");
      this.describe();
    } finally {
      this.probing = false;
    }
  }

  // ------------------------------------------------------------------------------------------------------------------
  // Time.

  // The setting that moves: the time, if layers drift, or the last coordinate, or the phase.
  get animated() {
    const used = uses(this.state);
    return used.time ? "time" : used.w ? "w" : used.z ? "z" : used.phase ? "phase" : undefined;
  }

  play(on) {
    if (on && !this.animated) {
      this.notice(kStill);
      return;
    }
    this.playing = on;
    byId("play").setAttribute("aria-pressed", String(on));
    byId("play").setAttribute("aria-label", on ? "Stop" : "Play");
    if (!on) return;
    let last = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      requestAnimationFrame(step);
      if (this.drawing) return;
      const seconds = Math.min((now - last) / 1000, 0.25);
      last = now;
      const name = this.animated;
      const value = this.state[name] + seconds * (name === "time" ? 1 : kSpeed);
      // This is no step, since nobody chose it.
      this.take(chosen(this.state, { [name]: name === "phase" ? value % 1 : value }));
    };
    requestAnimationFrame(step);
  }

  // ------------------------------------------------------------------------------------------------------------------
  // Cost, and the copied text.

  get costKey() {
    const { layers, period } = this.state;
    return [shaderKey({ ...this.state, view: "plane" }), ...layers.map(({ octaves }) => octaves), period].join(" ");
  }

  async measure() {
    const button = byId("measure");
    // A button that is disabled loses the focus, so this one is only marked as doing nothing now.
    if (button.ariaDisabled === "true") return;
    button.ariaDisabled = "true";
    byId("cost").textContent = "Measuring …";
    try {
      this.play(false);
      const key = this.costKey;
      const { ratio, low, high, cell, million } = await costOf(this.gpu, this.library, planeOf(this.state));
      const text = (number) => (number < 10 ? number.toFixed(2) : number.toFixed(1));
      byId("cost").textContent = `${text(ratio)} × hn_perlin`;
      byId("note-cost").textContent =
        `A million values take ${text(million)} ms. It is pattern(p). ` +
        `From a cell, pattern(cell, f) costs ${text(cell)} ×. hn_perlin(p) in 2D, in floats, ` +
        `was drawn in turns with both on ${this.gpu.describe()}. ` +
        `Parts of the rounds gave ${text(low)} to ${text(high)}.`;
      byId("note-cost").hidden = false;
      this.measured = key;
      byId("status").textContent = `It costs ${text(ratio)} times as much as Perlin noise in 2D.`;
    } catch (error) {
      byId("cost").textContent = error.message;
    } finally {
      button.ariaDisabled = "false";
      this.request();
    }
  }

  // Saves the file, or stops that.
  async save() {
    if (this.saving) return this.saving.abort();
    const { signal } = (this.saving = new AbortController());
    const button = byId("save");
    const label = button.textContent;
    const tell = (part) => {
      signal.throwIfAborted();
      button.textContent = `Stop, ${Math.round(part * 100)} %`;
    };
    try {
      tell(0);
      const file = await this.file(tell);
      const url = URL.createObjectURL(file);
      Object.assign(document.createElement("a"), { href: url, download: file.name }).click();
      setTimeout(() => URL.revokeObjectURL(url), kTold);
      byId("status").textContent = `${file.name} is saved.`;
    } catch (error) {
      const why = signal.aborted ? "You have stopped it." : error.message;
      byId("status").textContent = byId("note-file").textContent = `The file is not saved. ${why}`;
    } finally {
      this.saving = undefined;
      button.textContent = label;
    }
  }

  // A page from a disk has no address for others.
  async copyLink() {
    this.writeLink();
    const local = location.protocol === "file:";
    const done = await this.copy(local ? this.link || "#" : location.href, byId("link"), local ? "The part behind the address" : "The link");
    if (local && done) this.notice(kLocal);
  }

  // A sentence on the picture, until something changes.
  notice(sentence) {
    byId("hint").textContent = sentence;
    byId("hint").hidden = false;
    this.say(sentence);
  }

  // A file of this page that somebody drops opens its setting.
  async drop(file) {
    const link = file && (await linkInFile(file));
    if (link === undefined) return this.notice("This file has no setting. A PNG or a JSON of this page has one.");
    this.open(link, `The setting of ${file.name} is shown. Undo takes it back.`);
  }

  open(link, said) {
    const ignored = ignoredIn(link);
    this.replace(stateOf(link), said);
    if (ignored) this.notice(ignored);
  }

  async copy(text, button, what) {
    let done = true;
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      done = false; // people copy it themselves
    }
    this.controls.showUncopied(done ? undefined : text);
    if (!done) {
      byId("status").textContent = `${what} is not copied.`;
      return false;
    }
    button.dataset.label ??= button.textContent;
    button.textContent = "Copied";
    clearTimeout(this.labelTimers.get(button));
    this.labelTimers.set(button, setTimeout(() => (button.textContent = button.dataset.label), kTold));
    byId("status").textContent = `${what} is copied.`;
    return true;
  }

  // ------------------------------------------------------------------------------------------------------------------
  // Input.

  // Where a pointer is, in pixels of the picture to the right of and above its middle.
  fromMiddle({ x, y }) {
    const box = this.canvas.getBoundingClientRect();
    const [width, height] = this.size;
    return [
      ((x - box.left) / box.width) * width - (width >> 1),
      height - ((y - box.top) / box.height) * height - (height >> 1),
    ];
  }

  pan(right, up) {
    const [width, height] = this.size;
    this.change(panned(this.state, width, height, right, up));
  }

  // Terrain or a solid, by so many pixels of a finger that drags it.
  turn(right, up) {
    const { turn, tilt } = this.state;
    this.change({ turn: (((turn - right * kTurnOfPixel) % 1) + 1) % 1, tilt: tilt - up * kTurnOfPixel });
  }

  // A scale has six digits. The rest is kept, so that one step back undoes one forth.
  zoom(factor, at = [0, 0]) {
    if (!uses(this.state).cells) return;
    const [width, height] = this.size;
    const { cells } = this.state;
    const { from, to } = kSettings.cells;
    const around = isTurned(this.state) ? [0, 0] : at;
    const exact = (this.scale?.shown === cells ? this.scale.exact : cells) * factor;
    this.change(zoomed(this.state, width, height, exact / cells, ...around, kSettings.cells));
    this.scale = { shown: this.state.cells, exact: Math.min(Math.max(exact, from), to) };
  }

  home() {
    this.change({ x: 0n, y: 0n, cells: kSettings.cells.usual });
  }

  randomize() {
    this.replace(randomized(this.state, this.controls.locked), "Other settings are shown. Undo takes them back.");
  }

  roll() {
    this.change({ seed: crypto.getRandomValues(new Uint32Array(1))[0] % 1000000 });
  }

  restored() {
    this.webgl = undefined;
    this.request();
  }

  // The panel hides, and is there again. The focus does not stay in what nobody sees.
  fold() {
    const folded = document.documentElement.classList.toggle("folded");
    for (const id of ["hide", "handle"]) byId(id).setAttribute("aria-expanded", String(!folded));
    if (folded && !document.activeElement.checkVisibility()) this.canvas.focus();
    this.request();
  }

  async start() {
    for (const name of kCanvases) listen(this, byId(name));
    const clicks = {
      play: () => this.play(!this.playing), dice: () => this.roll(), in: () => this.zoom(2 ** -0.5),
      out: () => this.zoom(2 ** 0.5), home: () => this.home(), surprise: () => this.randomize(),
      save: () => this.save(), measure: () => this.measure(),
      copy: () => this.copy(this.controls.code, byId("copy"), "The code"), link: () => this.copyLink(),
      undo: () => this.undo(), redo: () => this.redo(), help: () => byId("keys-list").showModal(),
    };
    for (const [id, action] of Object.entries(clicks)) byId(id).addEventListener("click", action);
    this.comparison = new Comparison(this);
    for (const id of ["hide", "handle"]) byId(id).addEventListener("click", () => this.fold());
    listKeys(byId("keys-list").querySelector("tbody"));
    addEventListener("keydown", (event) => undoing(this, event));
    addEventListener("keydown", (event) => anywhere(this, event));
    addEventListener("hashchange", () => this.open(location.hash, "The setting of the link is shown."));
    addEventListener("dragover", (event) => event.dataTransfer?.types.includes("Files") && event.preventDefault());
    addEventListener("drop", (event) => {
      if (!event.dataTransfer?.files.length) return;
      event.preventDefault();
      this.drop(event.dataTransfer.files[0]);
    });
    new ResizeObserver(() => this.request()).observe(byId("stage"));
    document.addEventListener("visibilitychange", () => document.hidden && this.play(false));
    this.chooseCanvas();
    const ignored = ignoredIn(location.hash); // before the address loses it
    // Until there is a picture, or a sentence on why there is none. To make it sharp may take longer.
    await new Promise((resolve) => {
      this.begun = resolve;
      this.take(this.state);
      if (ignored) this.notice(ignored);
    });
  }
}

// For the tests, and for people who open the console: hashnoise.pixels(64, 64), hashnoise.state, ...
unpacked(byId("pieces").textContent)
  .then(async (pieces) => {
    window.hashnoise = new Playground(new Library(byId("version").textContent, pieces));
    await window.hashnoise.start();
    document.documentElement.dataset.ready = "yes";
  })
  .catch((error) => {
    byId("message").textContent = `This browser does not show the page. ${error.message}`;
    byId("message").hidden = false;
  });
