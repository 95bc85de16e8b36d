// The stops of a map of one's own: a row for each, with its colour and its place.
import { byId, element } from "./elements.js";
import { canLoseStop, kMostStops, stopsOf, stopsOfMap, withAnotherStop, withoutStop, withStop } from "./palette.js";

export class StopList {
  // `change` takes settings, and `say` a sentence.
  constructor(change, say) {
    this.change = (stops) => change({ stops });
    this.say = say;
    this.rows = Array.from({ length: kMostStops }, (_, at) => this.made(at));
    byId("stops").append(...this.rows.map(({ row }) => row));
    byId("add-stop").addEventListener("click", () => {
      const { text, at } = withAnotherStop(this.text);
      if (at === undefined) return;
      this.change(text);
      this.rows[at].place.focus();
      say(`There are ${stopsOf(text).length} stops.`);
    });
    byId("edit-map").addEventListener("click", () => {
      change({ map: "own", stops: stopsOfMap(this.map) });
      this.rows[0].picked.focus();
    });
  }

  made(at) {
    const name = `stop ${at + 1}`;
    const set = (stop) => this.change(withStop(this.text, at, stop));
    const picked = element("input", { type: "color", id: `picked-${at + 1}`, ariaLabel: `Colour of ${name}` });
    picked.addEventListener("input", () => set({ colour: picked.value.slice(1) }));
    const place = element("input", {
      type: "range", id: `place-${at + 1}`, min: 0, max: 100, step: 1, ariaLabel: `Place of ${name}`,
    });
    place.addEventListener("input", () => set({ place: Number(place.value) }));
    const label = `Remove ${name}`;
    const remove = element("button", {
      type: "button", className: "quiet", id: `remove-stop-${at + 1}`, textContent: "×", ariaLabel: label,
      title: label,
    });
    remove.addEventListener("click", () => this.remove(at));
    return { row: element("li", { hidden: true }, picked, place, remove), picked, place, remove };
  }

  remove(at) {
    if (!canLoseStop(this.text)) return;
    this.change(withoutStop(this.text, at));
    const { length } = stopsOf(this.text);
    this.rows[Math.min(at, length - 1)].place.focus();
    this.say(`Stop ${at + 1} is removed.`);
  }

  show({ map, stops }) {
    this.map = map;
    this.text = stops;
    byId("edit-map").hidden = map === "own" || map === "none";
    const shown = stopsOf(stops);
    byId("add-stop").ariaDisabled = String(shown.length === kMostStops);
    for (const [at, { row, picked, place, remove }] of this.rows.entries()) {
      row.hidden = at >= shown.length;
      if (row.hidden) continue;
      picked.value = `#${shown[at].colour}`;
      place.value = shown[at].place;
      place.setAttribute("aria-valuetext", `${shown[at].place} %`);
      remove.ariaDisabled = String(!canLoseStop(stops));
    }
  }
}
