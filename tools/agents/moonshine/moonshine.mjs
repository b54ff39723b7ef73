// Hears English speech, offline. Speaks the protocol of README.md on standard
// input and output until the input ends.
//
//     node moonshine.mjs               for MoonshineASR, which starts it
//     node moonshine.mjs --detect      for SileroVAD: where speech is
//     node moonshine.mjs FILE.wav …    prints what is said in these files
//                                      (16,000 samples a second, one channel)
//
// --network base|tiny: which network hears.
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

import { Detector } from "./detector.mjs";
import { FrameReader, samples } from "./protocol.mjs";
import { Recogniser } from "./recogniser.mjs";
import { Turns } from "./turns.mjs";

const say = (head) => process.stdout.write(`${JSON.stringify(head)}\n`);

const here = path.dirname(fileURLToPath(import.meta.url));
const { values: options, positionals: files } = parseArgs({
  allowPositionals: true,
  options: { detect: { type: "boolean" }, network: { type: "string" } },
});
const load = () => Recogniser.load(here, options.network);

const phrases = (payload) =>
  payload.toString("utf8").split("\n").filter(Boolean);

// The commands of the protocol, once the network is loaded.
async function recognising() {
  const recogniser = await load();
  const turns = new Turns(
    (heard, how) => recogniser.recognise(heard, how), say);
  let model = [];
  return {
    // In parts.
    language: ({ more, rejects }, payload) => {
      model.push(payload);
      if (more)
        return;
      recogniser.speak(Buffer.concat(model), rejects);
      model = [];
    },
    words: ({ names }, payload) =>
      recogniser.steer(phrases(payload), names ?? 0),
    narrow: (head, payload) => turns.narrow(
      head, recogniser.narrowed(phrases(payload), head.names ?? 0)),
    audio: (head, payload) => turns.audio(head, samples(payload)),
    finish: (head) => turns.finish(head),
    cancel: (head) => turns.cancel(head),
  };
}

// One piece after the other.
async function detecting() {
  const detector = await Detector.load(here);
  let before = Promise.resolve();
  const then = (work) => { before = before.then(work); };
  return {
    detect: ({ turn }, payload) => then(async () => {
      const likely = await detector.add(turn, samples(payload));
      say({ type: "speech", turn, likely });
    }),
    cancel: ({ turn }) => then(() => detector.forget(turn)),
  };
}

function end(reason) {
  say({ type: "failed", reason });
  process.exitCode = 1;
  process.stdin.destroy();
}

async function serve(prepare) {
  const began = performance.now();
  const known = await prepare();
  const reader = new FrameReader();
  process.stdin.on("data", (bytes) => {
    try {
      for (const { head, payload } of reader.add(bytes))
        known[head.type]?.(head, payload);
    } catch (error) {
      end(`what it is told cannot be read: ${error.message}`);
    }
  });
  process.stdin.on("end", () => process.exit());
  say({ type: "ready", milliseconds: Math.round(performance.now() - began) });
}

async function transcribe() {
  const recogniser = await load();
  for (const file of files) {
    // The header of a plain WAV file has 44 bytes.
    const heard = samples(fs.readFileSync(file).subarray(44));
    const result = await recogniser.recognise(
      heard, { careful: true, isOver: () => false });
    console.log(JSON.stringify({ file, ...result }));
  }
}

process.on("unhandledRejection", (error) => {
  say({ type: "failed", reason: String(error?.message ?? error) });
  process.exit(1);
});
await (options.detect ? serve(detecting) :
  files.length ? transcribe() : serve(recognising));
