// The colours of a map: of one of the ten, or of people's own.
import { kMaps } from "./tables.js";

const kEntries = 256;
const kWhole = 100; // the place of the last colour in a map of one's own
const kFewest = 2;
export const kMostStops = 8;

// ---------------------------------------------------------------------------------------------------------------------
// A map of one's own, as a link has it: "0-000000_40-e8695a_100-ffffff" are places in percent, each with its colour.

const written = (stops) => stops.map(({ place, colour }) => `${place}-${colour}`).join("_");
export const stopsOf = (text) =>
  text.split("_").map((stop) => {
    const [place, colour] = stop.split("-");
    return { place: Number(place), colour };
  });

// The stops as they can be, in the order of their places; nothing for a text that is none.
export function possibleStops(text) {
  if (!/^\d{1,3}-[\da-f]{6}(_\d{1,3}-[\da-f]{6})+$/i.test(text)) return undefined;
  const stops = stopsOf(text.toLowerCase()).sort((one, other) => one.place - other.place);
  return stops.length <= kMostStops && stops.at(-1).place <= kWhole ? written(stops) : undefined;
}

// The stops of one of the ten.
export function stopsOfMap(map) {
  const step = kWhole / (kMaps[map].stops.length - 1);
  return written(kMaps[map].stops.map((colour, at) => ({ place: Math.round(at * step), colour })));
}

// The stops with this one somewhere else or of another colour. It stays between its neighbours, so that no row of the
// panel changes its place while somebody holds it.
export function withStop(text, at, { place, colour }) {
  const stops = stopsOf(text);
  const [least, most] = [stops[at - 1]?.place ?? 0, stops[at + 1]?.place ?? kWhole];
  if (place !== undefined) stops[at].place = Math.min(Math.max(Math.round(place), least), most);
  if (colour !== undefined) stops[at].colour = colour;
  return written(stops);
}

// The stops with one more in the middle of the widest gap, in the colour that the map has there; and which one it is.
export function withAnotherStop(text) {
  const stops = stopsOf(text);
  if (stops.length === kMostStops) return { text, at: undefined };
  const ends = [...stops.map(({ place }) => place), kWhole];
  const gaps = ends.map((end, at) => end - (ends[at - 1] ?? 0));
  const at = gaps.indexOf(Math.max(...gaps));
  const place = Math.round(ends[at] - gaps[at] / 2);
  const parts = colourAt(rampOf({ map: "own", stops: text }), place).map((part) => part.toString(16).padStart(2, "0"));
  stops.splice(at, 0, { place, colour: parts.join("") });
  return { text: written(stops), at };
}

export function withoutStop(text, at) {
  const stops = stopsOf(text);
  return stops.length > kFewest ? written(stops.filter((_, number) => number !== at)) : text;
}

export const canLoseStop = (text) => stopsOf(text).length > kFewest;

// ---------------------------------------------------------------------------------------------------------------------
// {whole, stops}: each stop has its place, from 0 to `whole`, and the text of its colour.
export function rampOf({ map, stops }) {
  if (map === "own") return { whole: kWhole, stops: stopsOf(stops) };
  const colours = kMaps[map].stops;
  return { whole: colours.length - 1, stops: colours.map((colour, place) => ({ place, colour })) };
}

// Whether two stops have one place.
export const hasEdge = ({ map, stops }) => map === "own" && stopsOf(stops).some(({ place }, at, all) => at > 0 && place === all[at - 1].place);

export const partsOfColour = (colour) => [0, 2, 4].map((at) => parseInt(colour.slice(at, at + 2), 16));

// Where two stops have one place, the later one begins.
function colourAt({ stops }, place) {
  const after = stops.findIndex((stop) => stop.place > place);
  const below = stops[after < 0 ? stops.length - 1 : Math.max(after - 1, 0)];
  const above = after < 0 ? below : stops[after];
  const part = above.place > below.place ? (place - below.place) / (above.place - below.place) : 0;
  const [from, to] = [below, above].map(({ colour }) => partsOfColour(colour));
  return from.map((value, at) => Math.round(value + (to[at] - value) * part));
}

// The 256 colours of a map, of four bytes each.
export function paletteOf(state) {
  const ramp = rampOf(state);
  const bytes = new Uint8Array(4 * kEntries);
  for (let i = 0; i < kEntries; ++i)
    bytes.set([...colourAt(ramp, (i / (kEntries - 1)) * ramp.whole), 255], 4 * i);
  return bytes;
}

// The colours of several maps behind each other.
export const palettesOf = (maps) => Uint8Array.from(maps.flatMap((map) => [...paletteOf(map)]));

export function gradientOf(state) {
  const { whole, stops } = rampOf(state);
  const list = stops.map(({ place, colour }) => `#${colour} ${Number(((place / whole) * 100).toFixed(2))}%`);
  return `linear-gradient(90deg, ${list.join(", ")})`;
}
