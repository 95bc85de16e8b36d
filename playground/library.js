// The library inside the page: the text of glsl/hashnoise/, with which the page draws, and the pieces that tools/pick
// writes, which are copied.

export class Library {
  // version; glsl: {file: [line, ...]} without comments; `unpack` makes the pieces of the languages of this name.
  constructor({ version, glsl }, unpack) {
    this.version = version;
    this.glsl = glsl;
    this.unpack = unpack;
    this.loading = {}; // promises
    this.pieces = {}; // {shading, cpu}, which the page has after its first picture
  }

  async load(name) {
    this.loading[name] ??= this.unpack(name).then((pieces) => (this.pieces[name] = pieces));
    await this.loading[name];
  }

  // The texts of these functions in a shading language, and of their helpers.
  texts(names, language, { arithmetic, hash, dimensions }) {
    return this.pieces.shading.texts(names, language, arithmetic, hash, dimensions);
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
}
