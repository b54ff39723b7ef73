// A 3-gram model as it is sent (README.md): words in a tree, below each word
// those that were said behind it, below each of these what was said behind both.
// Words are numbers; their probabilities are natural logarithms.

// The number of a word that it lacks.
export const OUTSIDE = -1;

// Arrays lie one behind the other. Throws if there are fewer bytes than they say.
export function readModel(bytes) {
  // Numbers must begin at whole ones.
  const { buffer } = new Uint8Array(bytes);
  let at = 0;
  const next = (kind, count) => {
    const array = new kind(buffer, at, count);
    at += array.byteLength;
    return array;
  };
  const [words, pairs, triples, size] = next(Uint32Array, 4);
  const texts = Buffer.from(next(Uint8Array, size)).toString("utf8");
  const below = (above, count) => ({
    begins: next(Uint32Array, above + 1),
    words: next(Uint32Array, count),
    values: next(Float32Array, count),
  });
  const of = {
    texts: texts.split("\n").slice(0, words),
    values: next(Float32Array, words),
    left: next(Float32Array, words),
  };
  const two = below(words, pairs);
  two.left = next(Float32Array, pairs);
  return new DomainModel(of, two, below(pairs, triples));
}

// A place in it is what was said before: {last, pair}, the number of the last
// word and of the last two, OUTSIDE if it does not have them.
export class DomainModel {
  // By the numbers of words and pairs: the likeliest word for each beginning of
  // a word.
  byWord = new Map();
  byPair = new Map();

  constructor(words, pairs, triples) {
    this.words = words;
    this.pairs = pairs;
    this.triples = triples;
    this.numbers = new Map(words.texts.map((text, i) => [text, i]));
    this.end = this.number("</s>");
    this.start = { last: this.number("<s>"), pair: OUTSIDE };
    this.anywhere = beginnings(words.texts, words.values);
  }

  number(word) {
    return this.numbers.get(word) ?? OUTSIDE;
  }

  // The place behind one more word.
  behind({ last }, word) {
    return { last: word, pair: find(this.pairs, last, word) };
  }

  // Of this word there; -Infinity for one that it lacks.
  probability({ last, pair }, word) {
    if (word === OUTSIDE)
      return -Infinity;
    const three = find(this.triples, pair, word);
    if (three !== OUTSIDE)
      return this.triples.values[three];
    const two = find(this.pairs, last, word);
    if (two !== OUTSIDE)
      return this.left(this.pairs, pair) + this.pairs.values[two];
    return this.left(this.pairs, pair) + this.left(this.words, last) +
      this.words.values[word];
  }

  // Of the likeliest word there that begins so.
  likeliest({ last, pair }, part) {
    const afterTwo = this.left(this.pairs, pair);
    const afterOne = afterTwo + this.left(this.words, last);
    return Math.max(
      this.begun(this.byPair, this.triples, pair, part),
      afterTwo + this.begun(this.byWord, this.pairs, last, part),
      afterOne + (this.anywhere.get(part) ?? -Infinity));
  }

  left({ left }, index) {
    return index === OUTSIDE ? 0 : left[index];
  }

  begun(known, order, above, part) {
    if (above === OUTSIDE)
      return -Infinity;
    let all = known.get(above);
    if (!all) {
      const [from, to] = [order.begins[above], order.begins[above + 1]];
      const texts = Array.from(
        order.words.subarray(from, to), (word) => this.words.texts[word]);
      known.set(
        above, all = beginnings(texts, order.values.subarray(from, to)));
    }
    return all.get(part) ?? -Infinity;
  }
}

// The row of a word below this one.
function find({ begins, words }, above, word) {
  if (above === OUTSIDE || word === OUTSIDE)
    return OUTSIDE;
  let from = begins[above];
  let to = begins[above + 1];
  while (from < to) {
    const middle = (from + to) >> 1;
    if (words[middle] < word)
      from = middle + 1;
    else
      to = middle;
  }
  return from < begins[above + 1] && words[from] === word ? from : OUTSIDE;
}

// The best value of those that begin so.
function beginnings(texts, values) {
  const all = new Map();
  texts.forEach((text, i) => {
    for (let length = 1; length <= text.length; ++length) {
      const part = text.slice(0, length);
      if (!(all.get(part) >= values[i]))
        all.set(part, values[i]);
    }
  });
  return all;
}
