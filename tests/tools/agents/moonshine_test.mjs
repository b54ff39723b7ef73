// Tests of tools/agents/moonshine that need no weights: a toy model says what
// may come next.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Detector } from "../../../tools/agents/moonshine/detector.mjs";
import { END } from "../../../tools/agents/moonshine/model.mjs";
import {
  OUTSIDE, readModel,
} from "../../../tools/agents/moonshine/domain_model.mjs";
import {
  Guidance, Language,
} from "../../../tools/agents/moonshine/language.mjs";
import { Levels } from "../../../tools/agents/moonshine/levels.mjs";
import {
  FrameReader, samples,
} from "../../../tools/agents/moonshine/protocol.mjs";
import { repeatsItself } from "../../../tools/agents/moonshine/recogniser.mjs";
import { search } from "../../../tools/agents/moonshine/search.mjs";
import {
  NOTHING, Steering,
} from "../../../tools/agents/moonshine/steering.mjs";
import { Turns } from "../../../tools/agents/moonshine/turns.mjs";

// -- protocol

const frame = (head, payload = "") =>
  Buffer.from(`${JSON.stringify(head)}\n${payload}`);

test("frames come in pieces", () => {
  const bytes = Buffer.concat([
    frame({ type: "audio", bytes: 4 }, "abcd"), frame({ type: "finish" })]);
  const reader = new FrameReader();
  const frames = [...bytes].flatMap((byte) => reader.add(Buffer.of(byte)));
  assert.deepEqual(frames.map(({ head }) => head.type), ["audio", "finish"]);
  assert.equal(frames[0].payload.toString(), "abcd");
});

test("what is no frame is refused", () => {
  for (const bytes of ["hello\n", "null\n", "7\n", "x".repeat(5000),
    '{"bytes":1000000000}\n', '{"bytes":-1}\n', '{"bytes":"4"}\n'])
    assert.throws(
      () => new FrameReader().add(Buffer.from(bytes)), Error, bytes);
});

test("samples are numbers up to 1", () => {
  assert.deepEqual([...samples(Buffer.from([0, 128, 0, 64, 9]))], [-1, 0.5]);
});

// -- steering: tokens from 100 on begin words

const steering = (...phrases) =>
  new Steering(phrases.map((tokens) => ({ tokens, bonus: 1 })),
    (token) => token >= 100);

const place = (steered, tokens) =>
  tokens.reduce((at, token) => steered.follow(at, token), NOTHING);

test("a phrase earns a bonus for each token", () => {
  const steered = steering([100, 1, 101]);
  assert.equal(steered.hoped(place(steered, [100, 1])), 2);
  assert.equal(steered.final(place(steered, [100, 1])), 0);
  assert.equal(steered.final(place(steered, [100, 1, 101])), 3);
  assert.equal(steered.hoped(place(steered, [100, 1, 101, 102])), 3);
});

test("it is lost where the text leaves the phrase", () => {
  const steered = steering([100, 1, 101]);
  assert.equal(steered.hoped(place(steered, [100, 2])), 0);
  assert.equal(steered.hoped(place(steered, [100, 1, 102])), 0);
});

test("a phrase begins and ends with a word", () => {
  const steered = steering([1, 2], [100, 1]);
  assert.equal(steered.hoped(place(steered, [1, 2])), 0);
  assert.equal(steered.hoped(place(steered, [100, 1, 5])), 0);
});

test("a longer phrase does not earn twice", () => {
  const steered = steering([100], [100, 101], [101]);
  assert.equal(steered.final(place(steered, [100, 101])), 2);
  assert.equal(steered.final(place(steered, [100, 101, 100])), 3);
});

test("a name earns more than another phrase", () => {
  const steered = new Steering(
    [{ tokens: [100, 101], bonus: 1 }, { tokens: [100], bonus: 3 }],
    (token) => token >= 100);
  assert.equal(steered.final(place(steered, [100])), 3);
  assert.equal(steered.final(place(steered, [100, 101])), 4);
});

// -- the domain model: tokens of a few words

// As it is sent: rows of [word, probability, left], and what is below each.
function sent(words, pairs, triples) {
  const log = (one) => Math.log(one);
  const texts = Buffer.from(words.map(([text]) => `${text}\n`).join(""));
  const padded = Buffer.concat(
    [texts, Buffer.alloc((4 - texts.length % 4) % 4, "\n")]);
  const numbers = (...all) => Buffer.from(Uint32Array.from(all).buffer);
  const floats = (all) => Buffer.from(Float32Array.from(all).buffer);
  const at = (text) => words.findIndex(([one]) => one === text);
  const begins = (above, rows, isBelow) => [...above, null].map((one, i) =>
    rows.filter((row) => above.findIndex((up) => isBelow(row, up)) < i).length);
  const order = (above, rows, isBelow) => Buffer.concat([
    numbers(...begins(above, rows, isBelow)),
    numbers(...rows.map(([row]) => at(row.split(" ").at(-1)))),
    floats(rows.map(([, probability]) => log(probability)))]);
  const behind = ([row], [up]) => row.startsWith(`${up} `);
  return Buffer.concat([
    numbers(words.length, pairs.length, triples.length, padded.length), padded,
    floats(words.map(([, probability]) => log(probability))),
    floats(words.map(([,, left]) => log(left))),
    order(words, pairs, behind), floats(pairs.map(([,, left]) => log(left))),
    order(pairs, triples, behind)]);
}

const pieces = ["", "", "\u2581I", "\u2581see", "\u2581sea", "\u2581Dr",
  ".", "\u25815", "\u2581s", "ea"];
const domain = readModel(sent(
  [["i", 0.1, 0.3], ["see", 0.1, 0.3], ["sea", 0.01, 1], ["doctor", 0.01, 1],
    ["</s>", 0.1, 1], ["<s>", 0, 0.5]],
  [["i see", 0.8, 0.6], ["<s> i", 0.4, 0.2]],
  [["<s> i see", 0.9]]));
const model = new Language(domain, pieces);
const said = (...tokens) =>
  tokens.reduce((at, token) => model.follow(at, token), model.start);

test("a model is read as it is sent", () => {
  const near = (found, wanted) =>
    assert.ok(Math.abs(found - Math.log(wanted)) < 1e-6);
  const [i, see, sea] = ["i", "see", "sea"].map((word) => domain.number(word));
  const behind = domain.behind(domain.start, i);
  near(domain.probability(behind, see), 0.9);
  near(domain.probability(behind, sea), 0.2 * 0.3 * 0.01);
  near(domain.probability(domain.start, i), 0.4);
  near(domain.probability(domain.start, see), 0.5 * 0.1);
  near(domain.likeliest(behind, "se"), 0.9);
  near(domain.likeliest(domain.start, "se"), 0.5 * 0.1);
  assert.equal(domain.number("seal"), OUTSIDE);
  assert.equal(domain.probability(behind, OUTSIDE), -Infinity);
  assert.equal(domain.likeliest(behind, "x"), -Infinity);
  assert.throws(() => readModel(Buffer.from("too few bytes")));
});

test("words that follow each other score higher", () => {
  assert.ok(model.final(said(2, 3)) > model.final(said(2, 4)));
  assert.ok(model.final(said(3)) > model.final(said(4)));
});

test("a word that has begun is the likeliest one", () => {
  assert.equal(model.hoped(said(2, 8)), model.hoped(said(2, 3)));
  assert.equal(model.final(said(2, 8, 9)), model.final(said(2, 4)));
});

test("what the model has in words may be written otherwise", () => {
  const outside = new Language(readModel(sent([], [], [])), pieces);
  assert.ok(model.final(said(5, 6)) >
    outside.final(outside.follow(outside.start, 5)));
  assert.equal(model.hoped(said(7)), 0); // a figure
});

test("model and words guide together", async () => {
  const guidance = new Guidance(steering([3]), model);
  const at = guidance.follow(guidance.start, 3);
  assert.equal(guidance.final(at),
    model.final(said(3)) + steering([3]).final(place(steering([3]), [3])));
  assert.ok(guidance.wanted(guidance.start).has(3));
});

test("what repeats itself is no speech", () => {
  for (const text of ["the the the the the", "of the world of the world of " +
    "the world", "I know, I know, I know, I know."])
    assert.ok(repeatsItself(text), text);
  for (const text of ["no no no", "nine nine nine nine nine nine", "5 5 5 5 5",
    "one two one two one two", "is there a bank and is there a bank", ""])
    assert.ok(!repeatsItself(text), text);
});

// -- search: texts with their probabilities; every other token is unlikely

const VOCABULARY = 200;

function toyModel(texts) {
  const logits = (beginnings) => Float32Array.from(beginnings.flatMap(
    (beginning) => {
      const chances = Array(VOCABULARY).fill(1e-9);
      for (const { tokens, chance } of texts)
        if (beginning.every((token, i) => tokens[i] === token))
          chances[tokens[beginning.length] ?? END] += chance;
      return chances.map(Math.log);
    }));
  const state = (beginnings) => ({
    width: beginnings.length, beginnings, logits: logits(beginnings),
  });
  return {
    begin: async () => state([[]]),
    extend: async (from, parents, tokens) => state(parents.map(
      (parent, i) => [...from.beginnings[parent], tokens[i]])),
  };
}

const found = (model, steered, more) => search(
  model, null, { steering: steered, width: 4, most: 10, ...more });

const texts = [
  { tokens: [100, 101], chance: 0.5 }, { tokens: [100, 102], chance: 0.3 },
  { tokens: [103], chance: 0.2 },
];

test("the likeliest texts are found, best first", async () => {
  const best = await found(toyModel(texts), steering());
  assert.deepEqual(best.slice(0, 3).map(({ tokens }) => tokens),
    [[100, 101], [100, 102], [103]]);
  assert.deepEqual(best[0].chances.map((chance) => chance.toFixed(2)),
    ["0.80", "0.63", "1.00"]);
});

test("steering prefers the application's words", async () => {
  const best = await found(toyModel(texts), steering([102]));
  assert.deepEqual(best[0].tokens, [100, 102]);
});

test("what cannot be said is not written", async () => {
  const best = await found(toyModel(texts), steering(),
    { isSaid: (token) => token !== 101 });
  assert.deepEqual(best[0].tokens, [100, 102]);
});

test("that nothing was said must be sure", async () => {
  const nothing = (chance) => toyModel(
    [{ tokens: [], chance }, { tokens: [100], chance: 1 - chance }]);
  const [unsure] = await found(nothing(0.8), steering());
  assert.deepEqual(unsure.tokens, [100]);
  const [sure] = await found(nothing(0.95), steering());
  assert.deepEqual(sure.tokens, []);
});

test("a text has an end", async () => {
  const endless = toyModel([{ tokens: Array(1000).fill(100), chance: 1 }]);
  const [best] = await found(endless, steering());
  assert.equal(best.tokens.length, 10);
});

test("a search is given up", async () => {
  assert.equal(
    await found(toyModel(texts), steering(), { isOver: () => true }), null);
});

// -- levels: which part was spoken

const tone = (seconds, level) => Float32Array.from(
  { length: seconds * 16_000 }, (_, i) => level * Math.sin(i / 5));

function levelsOf(...parts) {
  const levels = new Levels();
  for (const part of parts)
    for (let at = 0; at < part.length; at += 320)
      levels.add(part.subarray(at, at + 320));
  return levels;
}

test("silence around speech is not spoken", () => {
  const noise = tone(1, 0.01);
  const { from, to, end } = levelsOf(noise, tone(1, 0.5), noise).spoken();
  assert.deepEqual([from, end, to], [16_000 - 2400, 32_000, 32_000 + 3200]);
});

test("speech in loud noise is heard whole", () => {
  const noise = tone(1, 0.2);
  const { from, to } = levelsOf(noise, tone(1, 0.5), noise).spoken();
  assert.deepEqual([from, to], [0, 48_000]);
});

test("who speaks behind is not spoken to the robot, but for a pause", () => {
  for (const [pause, level] of [[0.5, 0.05], [0.1, 0.15]]) {
    const behind = tone(1, level);
    const { from, end } =
      levelsOf(tone(pause, 0.001), behind, tone(1, 0.5), behind).spoken();
    const begin = (pause + 1) * 16_000;
    assert.deepEqual([from, end], [begin - 2400, begin + 16_000]);
  }
});

test("where it is quiet, soft first and last sounds are spoken", () => {
  for (const level of [0.02, 0.07]) {
    const silence = tone(1, 0.001);
    const soft = tone(0.3, level);
    const { from, end } =
      levelsOf(silence, soft, tone(1, 0.5), soft, silence).spoken();
    assert.deepEqual([from, end], [16_000 - 2400, 41_600]);
  }
});

test("there may be nothing at all", () => {
  const nothing = { from: 0, to: 0, end: 0 };
  assert.deepEqual(new Levels().spoken(), nothing);
  assert.deepEqual(levelsOf(tone(1, 0)).spoken(), nothing);
});

// -- turns

// Recognises only when it is told to.
function desk() {
  const said = [];
  const waiting = [];
  const turns = new Turns((heard, how) => new Promise((done) => {
    waiting.push({ how, heard, done: (result) => done(result) });
  }), (head) => said.push(head));
  const next = async (result = { text: "hello" }) => {
    while (waiting.length === 0)
      await new Promise(setImmediate);
    waiting.shift().done(result);
    await new Promise(setImmediate);
  };
  return { turns, said, waiting, next };
}

const second = tone(1, 0.5);

test("a turn has partial results and a result", async () => {
  const { turns, said, next } = desk();
  turns.audio({ turn: 1 }, second);
  await next();
  turns.finish({ turn: 1 });
  await next();
  assert.deepEqual(said, [
    { type: "partial", turn: 1, text: "hello" },
    { type: "result", turn: 1, text: "hello" }]);
  assert.equal(turns.turns.size, 0);
});

test("a turn may be narrowed", async () => {
  const { turns, waiting, next } = desk();
  turns.narrow({ turn: 1 }, "narrow");
  turns.audio({ turn: 1 }, second);
  turns.audio({ turn: 2 }, second);
  assert.equal(waiting[0].how.steering, "narrow");
  await next();
  turns.finish({ turn: 2 });
  assert.equal(waiting[0].how.steering, undefined);
  await next();
});

test("a result is computed in advance when a pause comes", async () => {
  const { turns, said, waiting, next } = desk();
  turns.audio({ turn: 1 }, second);
  await next({ text: "hel" });
  turns.audio({ turn: 1 }, tone(0.2, 0.001));
  assert.equal(waiting[0].how.careful, true);
  await next();
  turns.audio({ turn: 1 }, tone(0.2, 0.001));
  turns.finish({ turn: 1 });
  assert.equal(waiting.length, 0);
  assert.deepEqual(said.map(({ type, text }) => [type, text]),
    [["partial", "hel"], ["partial", "hello"], ["result", "hello"]]);
});

test("what is said after a pause is not forgotten", async () => {
  const { turns, said, next } = desk();
  turns.audio({ turn: 1 }, second);
  await next({ text: "hel" });
  turns.audio({ turn: 1 }, tone(0.2, 0.001));
  await next();
  turns.audio({ turn: 1 }, tone(0.2, 0.5));
  turns.finish({ turn: 1 });
  await next({ text: "hello again" });
  assert.equal(said.at(-1).text, "hello again");
});

test("a pause after more speech is worth another result", async () => {
  const { turns, waiting, next } = desk();
  const speaks = async (seconds) => {
    turns.audio({ turn: 1 }, tone(seconds, 0.5));
    while (waiting.length)
      await next();
  };
  const isComputedAfterPause = () => {
    turns.audio({ turn: 1 }, tone(0.15, 0.001));
    return waiting.length === 1 && waiting[0].how.careful;
  };
  await speaks(1);
  assert.ok(isComputedAfterPause());
  await next();
  await speaks(0.1);
  assert.ok(!isComputedAfterPause());
  await speaks(0.35);
  assert.ok(isComputedAfterPause());
});

test("a pause breaks off a partial result", async () => {
  const { turns, waiting, next } = desk();
  turns.audio({ turn: 1 }, second);
  const { how } = waiting[0];
  assert.ok(!how.isOver());
  turns.audio({ turn: 1 }, tone(0.15, 0.001));
  assert.ok(how.isOver());
  await next(null);
  assert.ok(!waiting[0].how.isOver());
});

test("nothing said is rejected", async () => {
  const { turns, said, next } = desk();
  turns.finish({ turn: 1 });
  await next({ text: "" });
  assert.equal(said[0].type, "rejected");
});

test("finished turns come first, in their order", async () => {
  const { turns, said, waiting, next } = desk();
  turns.audio({ turn: 1 }, second);
  turns.audio({ turn: 2 }, second);
  turns.audio({ turn: 3 }, second);
  turns.finish({ turn: 3 });
  turns.finish({ turn: 2 });
  assert.equal(waiting[0].how.isOver(), true); // the partial result of 1
  await next(null);
  await next();
  await next();
  assert.deepEqual(said.map(({ type, turn }) => [type, turn]),
    [["result", 3], ["result", 2]]);
});

test("a cancelled turn is not answered", async () => {
  const { turns, said, waiting, next } = desk();
  turns.audio({ turn: 1 }, second);
  turns.finish({ turn: 1 });
  turns.cancel({ turn: 1 });
  assert.equal(waiting[0].how.isOver(), true);
  await next();
  assert.deepEqual(said, []);
});

test("turns are bounded in length and number", async () => {
  const { turns } = desk();
  for (let i = 0; i < 40; ++i)
    turns.audio({ turn: 0 }, second);
  assert.equal(turns.turns.get(0).length, 30 * 16_000);
  for (let turn = 1; turn < 500; ++turn)
    turns.audio({ turn }, second);
  assert.equal(turns.turns.size, 128);
});

// -- detector

test("a stream is judged in pieces, each with the end of the one before", async () => {
  class Tensor {
    constructor(type, data, dims) { Object.assign(this, { type, data, dims }); }
  }
  const heard = [];
  const detector = new Detector({ Tensor }, ({ input }) => {
    heard.push(input.data);
    return { output: { data: [0.5] }, stateN: "next" };
  });
  const ramp = Float32Array.from({ length: 1100 }, (_, i) => i);
  assert.deepEqual(await detector.add(1, ramp.subarray(0, 500)), []);
  assert.deepEqual(await detector.add(2, ramp.subarray(0, 500)), []);
  assert.deepEqual(await detector.add(1, ramp.subarray(500)), [0.5, 0.5]);
  assert.equal(heard[1].length, 576);
  assert.equal(heard[1][0], 448);
  assert.equal(heard[1][64], 512);
  detector.forget(1);
  assert.deepEqual(await detector.add(1, ramp.subarray(0, 500)), []);
});
