// The neural network that tells speech from other sounds: how likely each piece
// of 32 ms is speech. Each stream has a state of its own.
import fs from "node:fs";
import path from "node:path";

import { packages } from "./model.mjs";

const WEIGHTS = "@ricky0123/vad-web/dist/silero_vad_v6.onnx";
const PIECE = 512; // samples
// The end of the piece before is heard, too.
const CONTEXT = 64;
const STATE = [2, 1, 128];
const RATE = 16_000n;
// The one that was heard longest ago gives way.
const MOST_STREAMS = 128;

export class Detector {
  static async load(folder) {
    const { require, find } = packages(folder);
    const file = find(WEIGHTS).find((place) => fs.existsSync(place));
    if (!file)
      throw new Error(`the package of ${WEIGHTS} is missing`);
    const runtime = require("onnxruntime-node");
    const session = await runtime.InferenceSession.create(path.resolve(file), {
      intraOpNumThreads: 1, interOpNumThreads: 1, logSeverityLevel: 3,
    });
    return new Detector(runtime, (inputs) => session.run(inputs));
  }

  // `run(inputs)` is the network.
  constructor(runtime, run) {
    this.runtime = runtime;
    this.run = run;
    this.rate = new runtime.Tensor("int64", BigInt64Array.of(RATE), []);
    this.streams = new Map();
  }

  // How likely each piece is speech that is complete now.
  async add(stream, samples) {
    const one = this.stream(stream);
    const heard = joined(one.held, samples);
    const likely = [];
    let at = CONTEXT;
    for (; at + PIECE <= heard.length; at += PIECE)
      likely.push(await this.judge(one, heard.slice(at - CONTEXT, at + PIECE)));
    one.held = heard.slice(at - CONTEXT);
    return likely;
  }

  forget(stream) {
    this.streams.delete(stream);
  }

  stream(name) {
    const { Tensor } = this.runtime;
    const one = this.streams.get(name) ?? {
      held: new Float32Array(CONTEXT),
      state: new Tensor("float32", new Float32Array(256), STATE),
    };
    this.streams.delete(name);
    this.streams.set(name, one);
    if (this.streams.size > MOST_STREAMS)
      this.streams.delete(this.streams.keys().next().value);
    return one;
  }

  async judge(one, heard) {
    const input = new this.runtime.Tensor("float32", heard, [1, heard.length]);
    const { output, stateN } = await this.run(
      { input, state: one.state, sr: this.rate });
    one.state = stateN;
    return output.data[0];
  }
}

function joined(one, other) {
  const all = new Float32Array(one.length + other.length);
  all.set(one);
  all.set(other, one.length);
  return all;
}
