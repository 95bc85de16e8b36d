// Input that moves the picture: pointers, fingers, a wheel and keys.
import { byId, element } from "./elements.js";
import { isTurned } from "./model.js";

const kKeyTurn = 25; // pixels of a drag that a key turns terrain or a solid by

export function listen(page, canvas) {
  const fingers = new Map();
  const middle = () => {
    const all = [...fingers.values()];
    return {
      x: all.reduce((sum, { x }) => sum + x, 0) / all.length,
      y: all.reduce((sum, { y }) => sum + y, 0) / all.length,
    };
  };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener("pointermove", (event) => {
    page.pointer = { x: event.clientX, y: event.clientY };
    if (fingers.has(event.pointerId)) {
      const [before, wide] = [page.fromMiddle(middle()), spread()];
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const after = page.fromMiddle(middle());
      const way = [after[0] - before[0], after[1] - before[1]];
      if (isTurned(page.state) && fingers.size === 1) page.turn(...way);
      else page.pan(...way);
      if (wide > 0 && spread() > 0) page.zoom(wide / spread(), after);
    }
    page.probe().catch(() => {});
  });
  for (const type of ["pointerup", "pointercancel"])
    canvas.addEventListener(type, (event) => fingers.delete(event.pointerId));
  canvas.addEventListener("pointerleave", () => {
    page.pointer = page.probed = undefined;
    page.describe();
  });
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      page.zoom(
        2 ** ((event.deltaY * lines) / (event.ctrlKey ? 100 : 300)),
        page.fromMiddle({ x: event.clientX, y: event.clientY }),
      );
    },
    { passive: false },
  );
  canvas.addEventListener("dblclick", (event) =>
    page.zoom(0.5, page.fromMiddle({ x: event.clientX, y: event.clientY })),
  );
  canvas.addEventListener("keydown", (event) => press(page, event));
  // A lost context is taken again when the browser gives it back.
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => page.restored());
}

// Anywhere on the page. A text that nobody has entered yet is the browser's.
export function undoing(page, event) {
  const { target } = event;
  const key = event.key.toLowerCase();
  if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== "z" && key !== "y")) return;
  if (target.id && target.id === page.controls.typed) return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) page.redo();
  else page.undo();
}

// The keys that the page lists. All but the last four want the focus on the picture.
const kKeys = {
  "Arrows": "move the picture; rotate and tilt terrain and solids. Shift: farther, or another place",
  "+ and −": "change the scale",
  "Home": "go back to the origin",
  "Space": "play, stop",
  "R": "another seed",
  "S": "surprise me",
  "H": "hide or show the settings",
  "?": "this list",
  "Ctrl+Z, Ctrl+Shift+Z": "undo a change, redo it",
};
export const listKeys = (table) =>
  table.append(
    ...Object.entries(kKeys).map(([keys, effect]) =>
      element("tr", {}, element("th", { scope: "row", textContent: keys }), element("td", { textContent: effect })),
    ),
  );

// Keys that work wherever nobody types.
export function anywhere(page, event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
  if (event.target.closest("input[type=number], select, textarea, dialog")) return;
  const actions = { s: () => page.randomize(), h: () => page.fold(), "?": () => byId("keys-list").showModal() };
  const action = actions[event.key.toLowerCase()];
  if (!action) return;
  event.preventDefault();
  action();
}

function press(page, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  // Whole pixels, so that the picture is the same one, moved.
  const step = Math.round(page.size[0] * (event.shiftKey ? 0.5 : 0.08));
  const turns = isTurned(page.state) && !event.shiftKey;
  const move = (right, up) =>
    turns ? page.turn(right * kKeyTurn, up * kKeyTurn) : page.pan(-right * step, -up * step);
  const actions = {
    ArrowLeft: () => move(-1, 0),
    ArrowRight: () => move(1, 0),
    ArrowUp: () => move(0, 1),
    ArrowDown: () => move(0, -1),
    "+": () => page.zoom(2 ** -0.25),
    "=": () => page.zoom(2 ** -0.25),
    "-": () => page.zoom(2 ** 0.25),
    Home: () => page.home(),
    " ": () => page.play(!page.playing),
    r: () => page.roll(),
    R: () => page.roll(),
  };
  const action = actions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}
