// From samples to text: the model, the search and the words, put together.
import fs from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { readModel } from "./domain_model.mjs";
import { FIGURES, Guidance, Language } from "./language.mjs";
import { Model, packages } from "./model.mjs";
import { mostTokens, search } from "./search.mjs";
import { Steering } from "./steering.mjs";

const WEIGHTS = "@usefulsensors/moonshine-js/dist/model";
// base hears better; tiny takes two thirds of its time and less memory.
const NETWORK = "base";
const TOKENIZER = "llama-tokenizer-js/llama-tokenizer.js";
// Hypotheses at a time for a careful result and for others.
const WIDTH = 4;
const PARTIAL_WIDTH = 1;
// For each token of a name and of another phrase, in natural logarithms of a
// probability; chosen by measuring.
const NAME_BONUS = 2.5;
const PHRASE_BONUS = 1.0;
// The same where nothing else is expected.
const NARROW_NAME_BONUS = 3.5;
const NARROW_WORD_BONUS = 2.0;
// The last words that turns were narrowed to.
const MOST_NARROW = 8;
// Less than this is no speech, in seconds.
const SHORTEST = 0.1;
const RATE = 16_000;
const WORD = "\u2581"; // stands for the space before a word

export class Recogniser {
  narrow = new Map();

  static async load(folder, network = NETWORK) {
    const { require, find } = packages(folder);
    const wanted = `${WEIGHTS}/${network}/quantized`;
    const weights = find(wanted).find((place) => fs.existsSync(place));
    if (!weights)
      throw new Error(`the network ${wanted} is missing`);
    const recogniser = new Recogniser();
    recogniser.model = await Model.load(require("onnxruntime-node"), weights);
    const file = find(TOKENIZER).find((place) => fs.existsSync(place));
    recogniser.tokenizer = (await import(pathToFileURL(file))).default;
    recogniser.isSaid = recogniser.tokenizer.vocabById.map(isEnglish);
    recogniser.steer([], 0);
    return recogniser;
  }

  // The domain model (README.md), of which turns that are not narrowed know;
  // `rejects`: what it finds too unlikely is not said to the application.
  speak(model, rejects = false) {
    this.rejects = rejects;
    this.language = new Language(
      readModel(model), this.tokenizer.vocabById);
    this.guide();
  }

  guide() {
    this.guidance = this.language
      ? new Guidance(this.steering, this.language) : this.steering;
  }

  // The words towards which it is steered, as they are written: first so many
  // names and other values, then what else is said.
  steer(phrases, names) {
    const before = this.encoded;
    this.encoded = new Map();
    const weighted = phrases.map((phrase, i) => ({
      tokens: this.encode(phrase, before),
      bonus: i < names ? NAME_BONUS : PHRASE_BONUS,
    }));
    this.steering = new Steering(weighted, (token) => this.startsWord(token));
    this.guide();
  }

  // The steering of a turn in which only these are expected.
  narrowed(phrases, names) {
    const key = `${names}\n${phrases.join("\n")}`;
    const known = this.narrow.get(key);
    if (known)
      return known;
    if (this.narrow.size >= MOST_NARROW)
      this.narrow.delete(this.narrow.keys().next().value);
    const weighted = phrases.map((phrase, i) => ({
      tokens: this.tokenizer.encode(phrase, false, true),
      bonus: i < names ? NARROW_NAME_BONUS : NARROW_WORD_BONUS,
    }));
    const made = new Steering(weighted, (token) => this.startsWord(token));
    this.narrow.set(key, made);
    return made;
  }

  // Most phrases are the same as before, and to encode them takes time.
  encode(phrase, before) {
    const tokens =
      before?.get(phrase) ?? this.tokenizer.encode(phrase, false, true);
    this.encoded.set(phrase, tokens);
    return tokens;
  }

  startsWord(token) {
    const piece = this.tokenizer.vocabById[token] ?? WORD;
    return piece.startsWith(WORD) || !/^[\p{L}\p{N}']/u.test(piece);
  }

  // {text, confidence, alternatives, words}, or null once isOver() says so.
  // `steering` is that of a narrowed turn.
  async recognise(samples, { careful, isOver, steering = this.guidance }) {
    if (samples.length < SHORTEST * RATE)
      return { text: "" };
    const heard = await this.model.encode(samples);
    if (isOver())
      return null;
    const texts = await search(this.model, heard, {
      steering, width: careful ? WIDTH : PARTIAL_WIDTH,
      most: mostTokens(samples.length / RATE), isOver,
      plainPiece: (token) => this.plainPiece(token),
      isSaid: (token) => this.isSaid[token],
    });
    if (!texts)
      return null;
    const said = texts.filter((one) => !this.repeats(one));
    return this.result(
      said.length && careful && this.rejects && !fits(said[0]) ? [] : said);
  }

  // Texts that differ in nothing else are the same.
  plainPiece(token) {
    return (this.tokenizer.vocabById[token] ?? "").toLowerCase()
      .replace(/[^\p{L}\p{N}\u2581]/gu, "");
  }

  // The network repeats itself where it hears voices that nobody could
  // understand.
  repeats({ tokens }) {
    return repeatsItself(this.tokenizer.decode(tokens, false, true));
  }

  result(texts) {
    if (texts.length === 0)
      return { text: "" };
    const [best, ...others] = texts.map((one) => this.told(one));
    const seen = new Set([best.text]);
    const alternatives = others.filter(
      ({ text }) => text && !seen.has(text) && seen.add(text));
    return {
      ...best,
      alternatives: alternatives.map(
        ({ text, confidence }) => ({ text, confidence })),
    };
  }

  told({ tokens, chances }) {
    const text = this.tokenizer.decode(tokens, false, true).trim();
    return {
      text, confidence: rounded(Math.min(...chances)),
      words: this.words(tokens, chances),
    };
  }

  // Each word with the least probability of its tokens.
  words(tokens, chances) {
    const words = [];
    tokens.forEach((token, i) => {
      const piece = this.tokenizer.vocabById[token] ?? "";
      if (piece.startsWith(WORD) || words.length === 0)
        words.push({ tokens: [], confidence: 1 });
      const word = words.at(-1);
      word.tokens.push(token);
      word.confidence = Math.min(word.confidence, chances[i]);
    });
    return words.map(({ tokens: of, confidence }) => ({
      text: this.tokenizer.decode(of, false, true).trim(),
      confidence: rounded(confidence),
    })).filter(({ text }) => text);
  }
}

// A text for each of whose tokens domain model and preferred words take away so
// much, in natural logarithms of a probability, is about something else; chosen
// by measuring. Names and short answers may be unknown.
const LEAST_FIT = -1;
const SHORT = 8; // tokens
const fits = ({ tokens, sum, score }) =>
  tokens.length < SHORT || score - sum >= LEAST_FIT * tokens.length;

// Whether words are said again and again at once: "the the the the", "of the
// world of the world of the world". Figures may be, and a few short words are.
export function repeatsItself(text) {
  const words = text.toLowerCase().split(/[^\p{L}\p{N}']+/u).filter(Boolean);
  for (let size = 1; size <= 4; ++size)
    for (let from = 0; from + size <= words.length; ++from) {
      const unit = words.slice(from, from + size);
      if (unit.some((word) => FIGURES.has(word) || /\d/.test(word)))
        continue;
      let times = 1;
      while (unit.every(
        (word, i) => words[from + times * size + i] === word))
        ++times;
      if (times >= (size === 1 ? 5 : 3))
        return true;
    }
  return false;
}

// Other alphabets, control characters and single bytes are what the network
// writes where it is lost.
const isEnglish = (piece) => !/^<.+>$/.test(piece) &&
  /^[\u2581\p{Script=Latin}\p{N}\p{P}\p{Sc}+=]+$/u.test(piece);

const rounded = (chance) => Math.round(chance * 1000) / 1000;
