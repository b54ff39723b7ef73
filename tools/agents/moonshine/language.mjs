// The domain model: which words follow each other in what the application's
// users say. Texts score by it, word after word and already within a word, by
// the likeliest of the words that begin so. Words that it lacks are possible
// and cost what its unlikeliest words cost.

import { OUTSIDE } from "./domain_model.mjs";

const WORD = "\u2581"; // stands for the space before a word
const NO_PIECE = { text: "", startsWord: false };

// How much it counts beside the network, in natural logarithms of
// probabilities; chosen by measuring.
const WEIGHT = 0.4;
const LEAST = -9;
// For each word, so that texts of few words have no advantage.
const EACH_WORD = 3;

// As words are compared: "Don't" is "dont", "É" is "e".
const plain = (text) => text.normalize("NFD").toLowerCase()
  .replace(/[^\p{L}\p{N}]/gu, "");

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
  // `pieces`: the text of each token.
  constructor(
    model, pieces, { weight = WEIGHT, least = LEAST, each = EACH_WORD } = {}) {
    this.pieces = pieces.map(
      (piece) => ({ text: plain(piece), startsWord: piece.startsWith(WORD) }));
    this.model = model;
    this.weight = weight;
    this.least = least;
    this.each = each;
    this.start = { behind: model.start, word: "", kept: 0 };
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
    if (isFigure(place.word))
      return this.went(place, OUTSIDE, -this.each);
    const word = this.model.number(SAID[place.word] ?? place.word);
    return this.went(
      place, word, this.model.probability(place.behind, word));
  }

  went({ behind, kept }, word, log) {
    return {
      behind: this.model.behind(behind, word), word: "",
      kept: kept + this.scored(log),
    };
  }

  // The score of a text that goes on.
  hoped(place) {
    if (!place.word || isFigure(place.word))
      return place.kept;
    return place.kept +
      this.scored(this.model.likeliest(place.behind, place.word));
  }

  // The score of a text that ends here. A number may end with each figure: to
  // go on must not be worth more than to end.
  final(place) {
    const end = this.ended(place);
    if (isFigure(place.word))
      return end.kept;
    return end.kept + this.weight *
      Math.max(this.model.probability(end.behind, this.model.end), this.least);
  }
}
