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
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let at = 0; at < bytes.length; ++at) bytes[at] = letters.charCodeAt(at); // from() takes three times as long
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).json();
}

class Piece {
  constructor(lines, at, end) {
    Object.assign(this, { name: lines[at].slice(1), lines, at, end });
  }

  // It is made when somebody needs it: all of them are 7 MB.
  get text() {
    return (this.made ??= `${this.lines.slice(this.at + 1, this.end).join("\n")}\n`);
  }
}

// The pieces of a text. A line "~name" begins one, and "~12 3" stands for the three lines that are twelve lines back.
function piecesOf(text) {
  const lines = [];
  const begins = [];
  for (const line of text.split("\n")) {
    const back = line[0] === "~" ? parseInt(line.slice(1)) : 0;
    if (!back) lines.push(line);
    else for (let count = Number(line.split(" ")[1]); count > 0; --count) lines.push(lines[lines.length - back]);
  }
  for (let at = 0; at < lines.length; ++at) if (lines[at][0] === "~") begins.push(at);
  return begins.map((at, number) => new Piece(lines, at, begins[number + 1]));
}

export class Library {
  // pieces: the text of piecesOf(); shells: {language: [first lines, last lines]}; modules: {"glsl fast lattice 2": [how much
  // further a piece is than the one before]}.
  constructor(version, { pieces, shells, modules }) {
    this.version = version;
    this.pieces = piecesOf(pieces);
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
      return this.pieces[number];
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
