// The turns that are being spoken or recognised, of several conversations, and
// in which order they get the processor: one at a time; what is finished goes
// before what is still being spoken, and who has waited longest goes first.

import { Levels } from "./levels.mjs";

// Of one turn; what comes later is not heard.
const LONGEST_TURN = 30; // seconds
// MoonshineASR has no more at a time.
const MOST_TURNS = 128;
const RATE = 16_000;
// A partial result when so much more was spoken, in seconds, and only if
// computing it takes no larger part of the time than this; what is computed in
// advance is not bounded so.
const PARTIAL_EVERY = 0.4;
const PARTIAL_SHARE = 0.3;
// After a pause of so many seconds the turn may be over: its result is computed
// in advance.
const PAUSE = 0.1;
// So much more speech, in seconds, is worth another try.
const MORE = 0.3;
// The same part was spoken if its borders moved by less, in samples.
const SAME = 1600;

export class Turns {
  // `recognise(samples, {careful, isOver, steering?})` gives a result, or null once
  // isOver(); `say(head)` sends it.
  constructor(recognise, say) {
    this.recognise = recognise;
    this.say = say;
    this.turns = new Map(); // by number
    this.isBusy = false;
    this.round = 0;
  }

  audio({ turn }, samples) {
    const one = this.turns.get(turn) ?? this.open(turn);
    const room = LONGEST_TURN * RATE - one.length;
    if (room > 0 && !one.isFinished) {
      const heard = samples.subarray(0, room);
      one.pieces.push(heard);
      one.levels.add(heard);
      one.length += heard.length;
    }
    this.work();
  }

  // What is expected in the turn alone.
  narrow({ turn }, steering) {
    (this.turns.get(turn) ?? this.open(turn)).steering = steering;
  }

  open(turn) {
    if (this.turns.size >= MOST_TURNS)
      this.cancel({ turn: this.turns.keys().next().value });
    const one = {
      turn, pieces: [], levels: new Levels(), length: 0, shown: 0, free: 0,
      round: 0, prepared: null, wasCareful: false,
      isFinished: false, isOver: false,
    };
    this.turns.set(turn, one);
    return one;
  }

  finish({ turn }) {
    const one = this.turns.get(turn) ?? this.open(turn);
    one.isFinished = true;
    one.round = ++this.round;
    this.work();
  }

  cancel({ turn }) {
    const one = this.turns.get(turn);
    if (one)
      one.isOver = true;
    this.turns.delete(turn);
  }

  async work() {
    if (this.isBusy)
      return;
    this.isBusy = true;
    for (let one = this.next(); one; one = this.next())
      await this.serve(one);
    this.isBusy = false;
  }

  // Finished turns first, in their order; of the others the one that was served
  // longest ago.
  next() {
    const due = [...this.turns.values()].filter((one) =>
      one.isFinished || this.wantsPartial(one));
    due.sort((a, b) => b.isFinished - a.isFinished || a.round - b.round);
    return due[0];
  }

  wantsPartial(one) {
    if (mayBeOver(one) && isPrepared(one))
      return false;
    // In noise pauses come and go: only the first is waited for so eagerly, and
    // those after more speech.
    if (mayBeOver(one) && (!one.wasCareful || saidMore(one)))
      return true;
    return one.length - one.shown >= PARTIAL_EVERY * RATE &&
      performance.now() >= one.free;
  }

  async serve(one) {
    one.round = ++this.round;
    const final = one.isFinished;
    one.shown = one.length;
    const result = final && isPrepared(one)
      ? one.prepared.result : await this.compute(one, final);
    if (one.isOver || !result)
      return;
    if (final)
      this.turns.delete(one.turn);
    this.tell(one, final, result);
  }

  async compute(one, final) {
    const careful = final || mayBeOver(one);
    const spoken = one.levels.spoken();
    const began = performance.now();
    // A partial result is given up for a turn that is finished meanwhile, and for
    // the careful one that is due after a pause.
    const isOver = () => one.isOver || !careful && mayBeOver(one) ||
      !final && [...this.turns.values()].some(
        (other) => other.isFinished && !(careful && other === one));
    const result = await this.recognise(
      joined(one).subarray(spoken.from, spoken.to),
      { careful, isOver, steering: one.steering });
    const took = performance.now() - began;
    one.free = performance.now() + took * (1 / PARTIAL_SHARE - 1);
    // A careful one that was broken off is tried again.
    if (!careful || result)
      one.wasCareful = careful;
    if (careful && result)
      one.prepared = { spoken, result };
    return result;
  }

  tell({ turn }, final, result) {
    if (final && result.text)
      this.say({ type: "result", turn, ...result });
    else if (final)
      this.say({ type: "rejected", turn, reason: "No words were heard." });
    else if (result.text)
      this.say({ type: "partial", turn, text: result.text });
  }
}

const mayBeOver = (one) =>
  one.length - one.levels.spoken().end >= PAUSE * RATE;

const saidMore = ({ levels, prepared }) => prepared !== null &&
  levels.spoken().end - prepared.spoken.end >= MORE * RATE;

function isPrepared({ levels, prepared }) {
  const { from, end } = levels.spoken();
  return prepared !== null && Math.abs(prepared.spoken.from - from) < SAME &&
    Math.abs(prepared.spoken.end - end) < SAME;
}

function joined(one) {
  if (one.pieces.length > 1) {
    const all = new Float32Array(one.length);
    let at = 0;
    for (const piece of one.pieces) {
      all.set(piece, at);
      at += piece.length;
    }
    one.pieces = [all];
  }
  return one.pieces[0] ?? new Float32Array(0);
}
