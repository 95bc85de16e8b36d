// How layers become one value, step by step, in any language.

// Steps, each a name and its value, for the layers that are shown; the name of the value; and for each layer with colours of
// its own how much it counts. `calls` are the values of the layers. `words` has what the language calls things:
//   name(kind, at): of the value so far, "v", and of a part, "m", at a layer
//   numbers(at): the weight and the offset of a layer; ease(at): from which value on it counts, in how wide an edge, and
//     the reciprocal of that
//   product(a, b), stepped(value), result(value): with integers each value is a whole number of steps, and a product is
//     computed in integers, while sums are exact in floats; so no compiler can round one in another way
//   part(value): from 0 to 1; lower(a, b), higher(a, b)
//   slope(v, at): how steep it is below a layer
export function combined(shown, calls, words) {
  const { product, stepped, result, part, isExact } = words;
  const steps = [];
  const masks = [];
  let [v, mask] = [];
  const set = (kind, at, value) => {
    steps.push([words.name(kind, at), value]);
    return words.name(kind, at);
  };
  // So much of the way from v to a value.
  const mixed = (share, value) => `${v} + ${product(share, isExact ? `${stepped(value)} - ${v}` : `(${value} - ${v})`)}`;
  // How much a layer counts by a value. With integers the edge is cut first, since a product of large factors has no room.
  const eased = (x, at, falls) => {
    const [from, width, rate] = words.ease(at);
    const above = falls ? `${from} - ${x}` : `${x} - ${from}`;
    return part(product(isExact ? words.lower(words.higher(above, words.zero), width) : `(${above})`, rate));
  };
  for (const [at, { blend, weighted, moved, tinted, soft }] of shown.entries()) {
    const [weight, offset] = words.numbers(at);
    const own = weighted ? product(weight, stepped(calls[at])) : stepped(calls[at]);
    const remapped = moved ? `${own} + ${offset}` : own;
    const isChanged = weighted || moved;
    if (v === undefined) {
      v = set("v", at, isChanged ? result(remapped) : remapped);
      continue;
    }
    // How much the layer counts; nothing for one that is combined in another way.
    const counts = (x) => (soft ? eased(x, at, soft < 0) : part(`${product(weight, x)} + ${offset}`));
    const share = {
      mix: () => weight,
      mask: () => (soft ? counts(own) : part(remapped)),
      height: () => counts(v),
      slope: () => counts(words.slope(v, at)),
    }[blend]?.();
    const isMask = blend === "mask";
    const named = isMask || (tinted && words.hasTints) ? set("m", at, share) : share;
    if (tinted && words.hasTints) {
      const count = blend === "mix" ? part(named) : named;
      masks.push(mask && !isMask ? product(mask, count) : count);
    }
    if (isMask) {
      mask = named;
      continue;
    }
    const next = {
      add: () => `${v} + ${remapped}`,
      multiply: () => product(v, !isChanged ? remapped : isExact ? stepped(remapped) : `(${remapped})`),
      min: () => words.lower(v, remapped),
      max: () => words.higher(v, remapped),
    }[blend]?.() ?? mixed(named, calls[at]);
    v = set("v", at, result(mask ? mixed(mask, next) : next));
    mask = undefined;
  }
  return { steps, v, masks };
}
