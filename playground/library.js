// The library inside the page: the text of glsl/hashnoise/, the definitions of its translation to WGSL, and what
// tools/pick writes of functions.

// In the page both are JSON, gzipped and written as base64 (tools/playground).
export async function unpacked(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return JSON.parse(await new Response(stream).text());
}

export class Library {
  // version; glsl: {file: [line, ...]} without comments; wgsl: {definitions: [{name, text, needs}], settings:
  // {"fast lattice": [numbers of definitions]}}.
  constructor(data) {
    this.version = data.version;
    this.glsl = data.glsl;
    this.definitions = data.wgsl.definitions;
    this.settings = data.wgsl.settings;
    this.modules = new Map();
    this.picks = { lines: [], texts: {} }; // tools/lib/ship/playground/picks.py; the page has them after its first picture
  }

  // The lines that a command of tools/pick writes. Nothing for one that the page does not have.
  picked(command) {
    const spans = this.picks.texts[command] ?? [];
    const lines = spans.flatMap((place, at) => (at % 2 ? [] : this.picks.lines.slice(place, place + spans[at + 1])));
    return lines.map((line) => line.replace("{command}", command));
  }

  // The lines of these files and of all that they include, each once and where it is first included: what
  // tools/pick whole --strip writes.
  lines(files) {
    const done = new Set();
    const flattened = (file) => {
      if (done.has(file)) return [];
      done.add(file);
      return this.glsl[file].flatMap((line) => {
        const included = /^#include "([^"]+)"$/.exec(line);
        return included ? flattened(included[1]) : [line];
      });
    };
    return files.flatMap(flattened);
  }

  // The definitions of WGSL with these settings, by name.
  module(arithmetic, hash) {
    const key = `${arithmetic} ${hash}`;
    if (!this.modules.has(key)) {
      const definitions = this.settings[key].map((number) => this.definitions[number]);
      this.modules.set(key, new Map(definitions.map((definition) => [definition.name, definition])));
    }
    return this.modules.get(key);
  }

  // The texts of these definitions and of all that they need, in the order of the library.
  wgsl(names, { arithmetic, hash }) {
    const module = this.module(arithmetic, hash);
    const needed = new Set();
    const need = (name) => {
      if (needed.has(name)) return;
      needed.add(name);
      module.get(name).needs.forEach(need);
    };
    names.forEach(need);
    return [...module.values()].filter(({ name }) => needed.has(name)).map(({ text }) => text);
  }
}
