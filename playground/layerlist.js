// The list of layers: which of them the panel shows, and what becomes of the list.
import { byId, element } from "./elements.js";
import { detailsOf, kMostLayers, tintedLayers, titleOf, withLayer, withMoved, withoutLayer } from "./model.js";
import { gradientOf } from "./palette.js";

export class LayerList {
  // `choose` takes the number of a layer; `change` takes settings of one and its number; `replace` takes a state with
  // another list, the layer that is chosen then, and a sentence.
  constructor({ choose, change, replace }) {
    this.replace = replace;
    this.rows = Array.from({ length: kMostLayers }, (_, at) => this.made(at, choose, change));
    byId("layers").append(...this.rows.map(({ row }) => row));
    byId("add-layer").addEventListener("click", () => {
      const number = this.state.layers.length;
      if (number < kMostLayers) replace(withLayer(this.state), number, `There are ${number + 1} layers.`);
    });
  }

  made(at, choose, change) {
    const chosen = element("input", { type: "radio", name: "layer", id: `layer-${at + 1}` });
    chosen.addEventListener("change", () => choose(at));
    const [title, details, tint] = [element("span"), element("small"), element("i")];
    const on = element("input", { type: "checkbox", id: `on-${at + 1}`, ariaLabel: `Layer ${at + 1} is shown` });
    on.addEventListener("change", () => change({ on: Number(on.checked) }, at));
    const button = (id, textContent, ariaLabel, onclick) =>
      element("button", { type: "button", className: "quiet", id, textContent, ariaLabel, title: ariaLabel, onclick });
    const up = button(`up-${at + 1}`, "↑", `Move layer ${at + 1} up`, () => this.moveUp(at));
    const remove = button(`remove-${at + 1}`, "×", `Remove layer ${at + 1}`, () => this.remove(at));
    const row = element(
      "li",
      { hidden: true },
      element("label", { className: "layer" }, chosen, element("span", {}, title, details), tint),
      element("label", { className: "shown" }, on),
      up,
      remove,
    );
    return { row, chosen, title, details, tint, on, up };
  }

  moveUp(at) {
    if (at === 0) return;
    this.replace(withMoved(this.state, at, at - 1), at - 1, `It is layer ${at} now.`);
    byId(`up-${at}`).focus();
  }

  remove(at) {
    const next = Math.max(at - 1, 0);
    this.replace(withoutLayer(this.state, at), next, `Layer ${at + 1} is removed. Undo takes it back.`);
    (this.state.layers.length > 1 ? this.rows[next].chosen : byId("add-layer")).focus();
  }

  show(state, number) {
    this.state = state;
    const { layers } = state;
    const tinted = tintedLayers(state);
    byId("layers").hidden = layers.length === 1;
    byId("add-layer").ariaDisabled = String(layers.length === kMostLayers);
    for (const [at, { row, chosen, title, details, tint, on, up }] of this.rows.entries()) {
      row.hidden = at >= layers.length;
      if (row.hidden) continue;
      chosen.checked = at === number;
      on.checked = Boolean(layers[at].on);
      title.textContent = titleOf(layers[at]);
      details.textContent = detailsOf(layers[at], at);
      tint.hidden = !tinted.includes(layers[at]);
      tint.style.background = tint.hidden ? "" : gradientOf({ map: layers[at].tint, stops: layers[at].tints });
      up.ariaDisabled = String(at === 0);
    }
  }
}
