// The functions that pictures call, as tools/pick writes them in each language: as pieces, from which a picture takes those
// that it needs (tools/lib/ship/playground/picks.py).

const kShading = ["glsl", "hlsl", "metal", "godot", "wgsl"];
// The languages that have their functions by other names than C.
const kNamed = {
  rust: (name) => name.replace(/^hn_/, ""),
  java: (name) => camel(name.replace(/^hn_/, "")),
  javascript: (name) => camel(name.replace(/^hn_/, "")),
  csharp: (name) => pascal(name.replace(/^hn_/, "")),
  go: (name) => pascal(name.replace(/^hn_/, "")),
};
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const pascal = (name) => camel(`_${name}`);

// The content of a text in the page: JSON, packed by zlib, in base 64.
export async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).json();
}

export class Library {
  // pieces: [name, text, name, text, ...]; shells: {language: [first lines, last lines]}; modules: {"glsl fast lattice 2":
  // [how much further a piece is than the one before]}.
  constructor(version, { pieces, shells, modules }) {
    this.version = version;
    this.pieces = pieces;
    this.shells = shells;
    this.modules = modules;
    this.words = new Map(); // of pieces, by their texts
  }

  wordsOf(text) {
    if (!this.words.has(text)) this.words.set(text, new Set(text.match(/[A-Za-z_]\w*/g)));
    return this.words.get(text);
  }

  module(language, { arithmetic, hash, dimensions }) {
    let number = 0;
    return this.modules[[language, arithmetic, hash, dimensions].join(" ")].map((step) => {
      number += step;
      return { name: this.pieces[2 * number], text: this.pieces[2 * number + 1] };
    });
  }

  // The texts of these functions and of all that they need. Calls within shading languages are read from the text in WGSL,
  // which has no overloads; the modules of one setting have the same pieces in the same order.
  texts(names, language, setting) {
    const own = this.module(language, setting);
    const read = kShading.includes(language) ? this.module("wgsl", setting) : own;
    const called = kShading.includes(language) ? read.map(({ text, name }) => nameInWgsl(text) ?? name) : own.map(({ name }) => name);
    const numbers = new Map(called.map((name, at) => [name, at]));
    const needed = new Set();
    const need = (at) => {
      if (at === undefined || needed.has(at)) return;
      needed.add(at);
      for (const word of this.wordsOf(read[at].text)) need(numbers.get(word));
    };
    for (const name of names) {
      const at = numbers.get((kNamed[language] ?? String)(name));
      if (at === undefined) throw new Error(`There is no ${name} in ${language}.`);
      need(at);
    }
    return own.filter((_, at) => needed.has(at)).map(({ text }) => text);
  }
}

const nameInWgsl = (text) => /^(?:fn|struct) (\w+)/.exec(text)?.[1];

export const named = (language, name) => (kNamed[language] ?? String)(name);
