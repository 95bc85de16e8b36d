// The panel: its choices, and how it shows the state.
import { kLanguages } from "./code.js";
import { exported, exportedText, kKinds } from "./export.js";
import { byId, element } from "./elements.js";
import { LayerList } from "./layerlist.js";
import { kLooks, lookOf, parsed } from "./links.js";
import { dimensionsOf, easeOf, isSolid, kLeastTilt, kSettings, noisesOf, settingsOf, uses } from "./model.js";
import { positionText } from "./numbers.js";
import { gradientOf } from "./palette.js";
import { StopList } from "./stoplist.js";
import { kLockable } from "./randomize.js";
import {
  kAbout, kArithmetics, kBlends, kFiles, kHashes, kMaps, kMetrics, kNoises, kShapes, kSums, kTints, kViews, kWarps,
} from "./tables.js";

// name: [label, step, from, to]. Without ends a slider has those of its setting.
const kSliders = {
  octaves: ["Octaves", 1],
  lacunarity: ["Lacunarity", 0.01],
  gain: ["Gain", 0.01],
  strength: ["Strength", 0.05],
  jitter: ["Jitter", 0.01],
  phase: ["Phase", 0.01],
  z: ["Slice at z", 0.01, -8, 8],
  w: ["Slice at w", 0.01, -8, 8],
  lean: ["Slice leans", 0.01],
  amplitude: ["Amplitude", 0.05],
  contrast: ["Contrast", 0.05],
  turn: ["Turn", 0.01],
  tilt: ["Tilt", 0.01],
  steep: ["Relief", 0.01],
  sea: ["Sea level", 0.01],
  radius: ["Radius", 0.05, 0.25, 16],
  weight: ["Weight", 0.05],
  offset: ["Offset", 0.05],
  from: ["From", 0.005, -2, 2],
  soft: ["Softness", 0.005, -2, 2],
  driftx: ["Drift along x", 0.01, -2, 2],
  drifty: ["Drift along y", 0.01, -2, 2],
  driftz: ["Drift along z", 0.01, -2, 2],
};
const kChoices = {
  dimensions: { 1: "1D", 2: "2D", 3: "3D", 4: "4D" },
  view: kViews,
  warp: kWarps,
  arithmetic: kArithmetics,
};
const kScales = Object.fromEntries([1, 2, 4, 8, 16, 32, 64].map((scale) => [scale, `${scale} × as fine`]));
const kSelects = {
  sum: labels(kSums),
  noise: labels(kNoises),
  metric: kMetrics,
  shape: kShapes,
  hash: kHashes,
  file: labels(kFiles),
  blend: labels(kBlends),
  scale: kScales,
};
// The labels of the numbers, each with what stands small below it, and of the selects.
const kNumbers = {
  seed: ["Seed"], period: ["Period"], x: ["x"], y: ["y"], cells: ["Cells across"],
  width: ["Width", "pixels"], height: ["Height", "pixels"], frames: ["Frames", "25 a second"], time: ["Time", "seconds"],
};
const kLabels = {
  sum: "Fractal", noise: "Noise", metric: "Metric", shape: "Shape", hash: "Hash", file: "Save as", blend: "Combined", scale: "Scale",
};
const kJumps = { Layers: "heading-layers", Shape: "heading-noise", Colours: "heading-colours", Code: "heading-code", File: "heading-file" };
const kNotes = {
  fast: "Floats are the fastest. They are within a few millionths of the exact value.",
  fixed: "Integers have the same bits on every GPU and in C++, with any driver.",
};

function labels(table) {
  return Object.fromEntries(Object.entries(table).map(([name, { label }]) => [name, label]));
}

export class Controls {
  // `change` takes the chosen settings, {name: value}, and the number of their layer; `look` the name of a look; `replace` a state with
  // other layers, and a sentence on it; `say` a sentence alone. `chose` is called when the panel shows another layer.
  constructor(library, { change, chose, look, replace, say }) {
    this.library = library;
    this.change = change;
    this.language = "glsl";
    this.kind = "function";
    this.state = undefined;
    this.layer = 0; // the number of the one that the panel shows
    this.typed = undefined; // the field whose text nobody has entered yet
    const choose = (layer) => {
      this.layer = layer;
      chose();
    };
    this.layers = new LayerList({
      choose,
      change,
      replace: (state, layer, said) => {
        this.layer = layer;
        replace(state, said);
      },
    });
    this.stops = new StopList((colours) => this.paint(colours), say);
    for (const place of document.querySelectorAll("[data-rows]"))
      place.replaceWith(...place.dataset.rows.split(" ").map((name) => element("div", { className: "row", id: `row-${name}` })));
    for (const [name, table] of Object.entries(kSelects)) this.makeSelect(name, table);
    for (const [name, setting] of Object.entries(kSliders)) this.makeSlider(name, ...setting);
    for (const [name, table] of Object.entries(kChoices)) this.makeChoices(name, table);
    for (const [name, words] of Object.entries(kNumbers)) this.makeNumber(name, ...words);
    for (const [name, about] of Object.entries(kAbout)) {
      byId(`row-${name}`).append(element("small", { id: `about-${name}`, textContent: about }));
      byId(name).setAttribute("aria-describedby", `about-${name}`);
    }
    this.makeSwatches();
    this.makeLanguages();
    this.makeJumps();
    this.makeLocks();
    const names = Object.keys(kLooks);
    for (const [at, name] of names.entries()) {
      const dot = element("i");
      dot.style.backgroundPositionX = `${(100 * at) / (names.length - 1)}%`; // of pictures beside each other
      byId("looks").append(
        element("button", { type: "button", className: "quiet", onclick: () => look(name) }, dot, name),
      );
    }
    byId("more-looks").addEventListener("click", () => {
      byId("more-looks").ariaPressed = String(byId("looks").classList.toggle("all"));
    });
    byId("whole").addEventListener("change", () => this.showCode());
    byId("kind").addEventListener("change", () => this.chooseKind(byId("kind").value));
    byId("panel").addEventListener("submit", (event) => event.preventDefault());
  }

  makeSelect(name, table) {
    const select = element("select", { id: name });
    byId(`row-${name}`).append(element("label", { htmlFor: name, id: `label-${name}`, textContent: kLabels[name] }), select);
    select.append(...Object.entries(table).map(([value, label]) => new Option(label, value)));
    select.addEventListener("change", () => this.change({ [name]: parsed(name, select.value) }));
  }

  makeSlider(name, label, step, min = kSettings[name].from, max = kSettings[name].to) {
    const row = byId(`row-${name}`);
    row.classList.add("slider");
    const input = element("input", { type: "range", id: name, min, max, step });
    row.append(
      element("label", { htmlFor: name, id: `label-${name}`, textContent: label }),
      input,
      element("output", { htmlFor: name, id: `of-${name}` }),
    );
    input.addEventListener("input", () => this.change({ [name]: Number(input.value) }));
  }

  makeChoices(name, table) {
    for (const [value, label] of Object.entries(table)) {
      const input = element("input", { type: "radio", name, value, id: `${name}-${value}` });
      input.addEventListener("change", () => this.change({ [name]: name === "dimensions" ? Number(value) : value }));
      byId(name).append(element("label", {}, input, label));
    }
  }

  // The browser counts up and down by the arrows, and states what is wrong with a text that is no number of the setting.
  makeNumber(name, label, small) {
    const { from = -2147483648, to = 2147483648, whole } = kSettings[name];
    const input = element("input", { id: name, type: "number", min: from, max: to, step: whole ? 1 : "any", required: true });
    const words = small ? [`${label} `, element("small", { textContent: small })] : [label];
    byId(`row-${name}`).append(element("label", { htmlFor: name }, ...words), input);
    input.addEventListener("input", () => (this.typed = name));
    input.addEventListener("change", () => {
      if (!input.reportValidity()) return;
      this.typed = undefined;
      this.change({ [name]: parsed(name, input.value) });
    });
    // A wrong text stays until something else is shown.
    input.addEventListener("blur", () => {
      this.typed = undefined;
      if (input.validity.valid) this.show(this.state);
    });
  }

  makeSwatches() {
    for (const [value, { label }] of Object.entries(kTints)) {
      const input = element("input", { type: "radio", name: "map", value, id: `map-${value}` });
      input.setAttribute("aria-label", label);
      input.addEventListener("change", () => this.paint({ map: value }));
      const swatch = element("label", { title: label }, input);
      if (!kMaps[value]?.stops) swatch.append(element("span", { textContent: label }));
      else swatch.style.background = gradientOf({ map: value });
      byId("map").append(swatch);
    }
  }

  // Colours of the layer that the panel shows, if it can have its own, or of the picture.
  paint(colours) {
    const names = uses(this.state, this.layer).tint ? { map: "tint", stops: "tints" } : { map: "map", stops: "stops" };
    this.change(Object.fromEntries(Object.entries(colours).map(([name, value]) => [names[name], value])));
  }

  makeLanguages() {
    const select = byId("language");
    select.append(...Object.entries(kLanguages).map(([language, label]) => new Option(label, language)));
    select.addEventListener("change", () => this.chooseLanguage(select.value));
    this.chooseLanguage(this.language);
  }

  chooseLanguage(language) {
    this.language = byId("language").value = language;
    this.showUncopied();
    const kinds = kKinds[language];
    const options = Object.entries(kinds).map(([kind, { label }]) => new Option(label, kind));
    byId("kind").replaceChildren(...options);
    byId("row-kind").hidden = options.length === 1;
    this.chooseKind(Object.hasOwn(kinds, this.kind) ? this.kind : "function");
  }

  // A lock at each setting that "Surprise me" would change.
  makeLocks() {
    this.locked = new Set();
    for (const name of kLockable) {
      const row = byId(`row-${name}`) ?? byId(name).closest(".row, section");
      const words = row.querySelector("label, legend, h2").firstChild.textContent.trim();
      const lock = element("button", { type: "button", className: "lock", ariaPressed: "false", ariaLabel: `Keep ${words}` });
      lock.addEventListener("click", () => {
        if (!this.locked.delete(name)) this.locked.add(name);
        lock.ariaPressed = String(this.locked.has(name));
      });
      row.classList.add("lockable");
      row.append(lock);
    }
    byId("locks").addEventListener("click", () => {
      const shown = byId("sheet").classList.toggle("with-locks");
      byId("locks").ariaPressed = String(shown);
    });
  }

  // Buttons that lead to the sections of the panel.
  makeJumps() {
    for (const [label, heading] of Object.entries(kJumps)) {
      const target = byId(heading);
      const onclick = () => {
        byId("sheet").scrollTop = target.offsetTop - 12;
        target.focus({ preventScroll: true });
      };
      target.tabIndex = -1;
      byId("jumps").append(element("button", { type: "button", textContent: label, onclick }));
    }
  }

  chooseKind(kind) {
    this.kind = kind;
    this.showUncopied();
    byId("kind").value = kind;
    const optional = kind === "function" && ["glsl", "hlsl", "wgsl"].includes(this.language);
    byId("choose-whole").hidden = !optional;
    byId("note-code").hidden = optional;
    byId("note-code").textContent =
      { cpp: "It needs include/ and glsl/ of the library.", python: "", bake: "" }[this.language] ?? "The text has all that it calls.";
    this.showCode();
  }

  get copying() {
    return [this.library, this.language, this.state, this.kind, byId("whole").checked];
  }

  get code() {
    return exportedText(...this.copying);
  }

  showCode() {
    if (!this.state) return;
    const { head, library: inside, code } = exported(...this.copying);
    const kilobytes = Math.ceil((inside.join("\n").length + 1) / 1000);
    const hint = inside.length ? [`// ${inside.length} lines of the library, ${kilobytes} kB`, ""] : [];
    const lines = [...head, ...hint, ...code];
    const text = lines.join("\n");
    if (this.shownCode === text) return;
    this.shownCode = text;
    byId("code").replaceChildren(
      ...lines.flatMap((line) => {
        const [, text, remark] = /^(.*?)(\/\/.*)?$/.exec(line);
        return [text, ...(remark ? [element("span", { className: "remark", textContent: remark })] : []), "\n"];
      }),
    );
  }

  // The text for people to copy that the browser did not; without a text there is none.
  showUncopied(text) {
    byId("uncopied").hidden = text === undefined;
    if (text === undefined) return;
    byId("text-uncopied").value = text;
    byId("text-uncopied").focus();
    byId("text-uncopied").select();
  }

  // The sliders of where a layer counts go as far as the values that decide it.
  showEnds(least, greatest) {
    const [low, high] = [Math.floor(least * 20) / 20, Math.ceil(greatest * 20) / 20];
    for (const [id, ends] of [["from", [low, high]], ["soft", [low - high, high - low]]])
      [byId(id).min, byId(id).max] = ends;
    this.show(this.state);
  }

  markLook() {
    const look = lookOf(this.state);
    for (const button of byId("looks").children) button.ariaPressed = String(button.textContent === look);
  }

  show(whole) {
    this.state = whole;
    this.layer = Math.min(this.layer, whole.layers.length - 1);
    this.layers.show(whole, this.layer);
    const used = uses(whole, this.layer);
    const state = settingsOf(whole, this.layer);
    if (used.ease) {
      Object.assign(state, easeOf(state));
      Object.assign(used, { from: true, soft: true, weight: false, offset: false });
    }
    const noises = noisesOf(state.sum);
    byId("heading-noise").textContent = whole.layers.length > 1 ? `Noise of layer ${this.layer + 1}` : "Noise";
    const isMix = used.blend && state.blend === "mix";
    byId("label-weight").textContent = isMix ? "Its part" : "Weight";
    byId("about-weight").textContent = isMix ? "How much of the layer the mixture has." : kAbout.weight;
    for (const option of byId("noise").options) option.hidden = option.disabled = !noises.includes(option.value) && !kNoises[option.value].shape;
    byId("label-noise").textContent = state.sum === "none" ? "Noise" : "of noise";
    for (const name of Object.keys(kSelects)) byId(name).value = state[name];
    const dimensions = dimensionsOf(state);
    for (const input of byId("dimensions").querySelectorAll("input"))
      input.disabled = !dimensions.includes(Number(input.value));
    for (const view of ["sphere", "cube"])
      byId(`view-${view}`).disabled = !dimensions.some((number) => number > 2);
    const colours = used.tint ? { map: state.tint, stops: state.tints } : state;
    byId("heading-colours").textContent = used.tint ? `Colours where layer ${this.layer + 1} counts` : "Colours";
    byId("map-none").parentElement.hidden = !used.tint;
    byId(`map-${colours.map}`).checked = true;
    for (const name of Object.keys(kChoices)) {
      const chosen = byId(`${name}-${state[name]}`);
      if (chosen) chosen.checked = true;
    }
    for (const name of Object.keys(kSliders)) {
      const input = byId(name);
      if (name === "tilt") input.min = isSolid(state) ? kSettings.tilt.from : kLeastTilt;
      if (name === "strength") input.max = kSums[state.sum].strength?.most ?? kSettings.strength.to;
      if (name === "lacunarity") input.step = state.period ? 1 : 0.01;
      for (const [end, best] of [["min", Math.min], ["max", Math.max]]) if (used[name]) input[end] = best(input[end], state[name]);
      input.value = state[name];
      byId(`of-${name}`).textContent = name === "octaves" ? state[name] : state[name].toFixed(2);
    }
    for (const name of Object.keys(kNumbers)) {
      if (name === this.typed) continue; // a playing picture must not take it away
      const input = byId(name);
      const text = typeof state[name] === "bigint" ? positionText(state[name]) : String(state[name]);
      if (input.value !== text) input.value = text;
    }
    for (const name of Object.keys(kSettings)) {
      const row = byId(`row-${name}`);
      if (row) row.hidden = !used[name];
    }
    byId("row-stops").hidden = colours.map !== "own";
    this.stops.show(colours);
    byId("map-own").parentElement.style.background = gradientOf({ map: "own", stops: colours.stops });
    byId("note-noise").textContent = (state.sum === "none" ? kNoises[state.noise] : kSums[state.sum]).about;
    byId("note-arithmetic").textContent = kNotes[state.arithmetic];
    const { label, note } = kFiles[state.file];
    byId("note-file").textContent = note;
    byId("save").textContent = `Save ${label.split(/\W/)[0]}`;
    byId("save").title = `Save ${label}`;
    // Relief is beside its view.
    const before = byId(state.view === "terrain" ? "row-tilt" : "row-file");
    if (before.nextElementSibling.id !== "row-steep") before.after(byId("row-steep"));
    this.showCode();
  }
}
