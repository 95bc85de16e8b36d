// The library inside the page: the pieces that tools/pick writes, with which the page draws, and which are copied.

export class Library {
  constructor(version) {
    this.version = version;
    this.pieces = {}; // {shading, cpu}; the page has the second behind its first picture
  }

  // The texts of these functions in a shading language, and of their helpers.
  texts(names, language, { arithmetic, hash, dimensions }) {
    return this.pieces.shading.texts(names, language, arithmetic, hash, dimensions);
  }
}
