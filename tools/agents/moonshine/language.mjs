// The domain model: which words follow each other in what the application's
// users say. Texts score by it, word after word and already within a word, by
// the likeliest of the words that begin so. Words that it lacks are possible
// and cost what its unlikeliest words cost.

const WORD = "\u2581"; // stands for the space before a word
const NO_PIECE = { text: "", startsWord: false };
const OUTSIDE = "\u0000"; // a word that it lacks

// How much it counts beside the network, in natural logarithms of
// probabilities; chosen by measuring.
const WEIGHT = 0.4;
const LEAST = -9;
// For each word, so that texts of few words have no advantage.
const EACH_WORD = 3;

// As words are compared: "Don't" is "dont".
const plain = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}]/gu, "");

// Numbers may be said wherever they are, in figures or one by one.
export const FIGURES = new Set(["zero", "oh", "one", "two", "three", "four",
  "five", "six", "seven", "eight", "nine", "double", "triple"]);
const isFigure = (word) => FIGURES.has(word) || /\d/.test(word);

// Words that the network writes shorter than the model, which has what is said.
const SAID = { dr: "doctor", mr: "mister", mrs: "missus" };

// The application's words and the model together, as one steering.
export class Guidance {
  constructor(steering, language) {
    this.steering = steering;
    this.language = language;
    this.start = { preferred: steering.start, said: language.start };
  }

  wanted({ preferred }) {
    return this.steering.wanted(preferred);
  }
  follow({ preferred, said }, token) {
    return {
      preferred: this.steering.follow(preferred, token),
      said: this.language.follow(said, token),
    };
  }
  hoped({ preferred, said }) {
    return this.steering.hoped(preferred) + this.language.hoped(said);
  }
  final({ preferred, said }) {
    return this.steering.final(preferred) + this.language.final(said);
  }
}

export class Language {
  // A 3-gram model in the ARPA format; `pieces`: the text of each token.
  constructor(
    arpa, pieces, { weight = WEIGHT, least = LEAST, each = EACH_WORD } = {}) {
    this.pieces = pieces.map(
      (piece) => ({ text: plain(piece), startsWord: piece.startsWith(WORD) }));
    this.weight = weight;
    this.least = least;
    this.each = each;
    // By context, "" for none: how much what is not in it counts, and what
    // follows it.
    this.contexts = new Map();
    this.read(arpa);
    this.start = { before: "<s>", last: "<s>", word: "", kept: 0 };
  }

  read(arpa) {
    let order = 0;
    for (const line of arpa.split("\n")) {
      const section = /^\\(\d)-grams:/.exec(line);
      if (section)
        order = Number(section[1]);
      else if (order && line && !line.startsWith("\\"))
        this.add(line.split(/[ \t]/), order);
    }
  }

  add([log, ...rest], order) {
    const words = rest.slice(0, order).map(
      (word) => word.startsWith("<") ? word : plain(word));
    const context = this.context(words.slice(0, -1).join(" "));
    const value = Number(log) * Math.LN10;
    const word = words.at(-1);
    const known = context.words.get(word);
    if (known === undefined || known < value)
      context.words.set(word, value);
    if (rest.length > order)
      this.context(words.join(" ")).backOff = Number(rest[order]) * Math.LN10;
  }

  context(name) {
    let found = this.contexts.get(name);
    if (!found)
      this.contexts.set(name,
        found = { backOff: 0, words: new Map(), beginnings: null });
    return found;
  }

  // The likeliest word of a context for each beginning of a word.
  beginnings(context) {
    if (context.beginnings)
      return context.beginnings;
    const all = context.beginnings = new Map();
    for (const [word, value] of context.words)
      for (let length = 1; length <= word.length; ++length) {
        const part = word.slice(0, length);
        if (!(all.get(part) >= value))
          all.set(part, value);
      }
    return all;
  }

  // The logarithm of the probability of a word, or of the likeliest one that
  // begins so.
  probability({ before, last }, word, isBeginning) {
    let backOff = 0;
    let best = -Infinity;
    for (const name of [`${before} ${last}`, last, ""]) {
      const context = this.contexts.get(name);
      if (!context)
        continue;
      const words = isBeginning ? this.beginnings(context) : context.words;
      const found = words.get(word);
      if (found !== undefined)
        best = Math.max(best, found + backOff);
      if (best > -Infinity && !isBeginning)
        break;
      backOff += context.backOff;
    }
    return best;
  }

  scored(log) {
    return this.weight * (Math.max(log, this.least) + this.each);
  }

  // The place after one more token.
  follow(place, token) {
    const { text, startsWord } = this.pieces[token] ?? NO_PIECE;
    if (!startsWord)
      return text ? { ...place, word: place.word + text } : place;
    return { ...this.ended(place), word: text };
  }

  // The place behind its word.
  ended(place) {
    if (!place.word)
      return place;
    // A number stands for words that are written in figures.
    const isNumber = isFigure(place.word);
    const word = SAID[place.word] ?? place.word;
    const log = isNumber ? -this.each : this.probability(place, word, false);
    return {
      before: place.last, word: "",
      last: log > -Infinity && !isNumber ? word : OUTSIDE,
      kept: place.kept + this.scored(log),
    };
  }

  // The score of a text that goes on.
  hoped(place) {
    if (!place.word || isFigure(place.word))
      return place.kept;
    return place.kept +
      this.scored(this.probability(place, place.word, true));
  }

  // The score of a text that ends here. A number may end with each figure: to
  // go on must not be worth more than to end.
  final(place) {
    const end = this.ended(place);
    if (isFigure(place.word))
      return end.kept;
    return end.kept + this.weight *
      Math.max(this.probability(end, "</s>", false), this.least);
  }
}
