// The neural network: an encoder that turns samples into a sequence of vectors,
// and a decoder that says for each beginning of a text what may come next. The
// decoder works on several beginnings (a beam) at a time.
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const HEADS = 8; // of attention, in each model of the family
const PARTS = ["key", "value"];

export const START = 1;
export const END = 2;

// Where its packages are: in the folder `node_modules` of this one.
export function packages(folder) {
  const from = createRequire(pathToFileURL(path.join(folder, "package.json")));
  const find = (name) => from.resolve.paths(name)
    .map((place) => path.join(place, name));
  return { require: from, find };
}

// What the decoder's inputs and outputs are called.
function decoderNames(inputs) {
  const layers = inputs.filter((name) => name.endsWith(".decoder.key")).length;
  const names = (prefix, of) =>
    Array.from({ length: layers }, (_, layer) =>
      PARTS.map((part) => `${prefix}.${layer}.${of}.${part}`)).flat();
  return {
    past: names("past_key_values", "decoder"),
    pastHeard: names("past_key_values", "encoder"),
    present: names("present", "decoder"),
    presentHeard: names("present", "encoder"),
  };
}

export class Model {
  static async load(runtime, folder) {
    // One thread: two cores are shared with everything else, and a second
    // thread saves little for utterances of some seconds.
    const options = {
      intraOpNumThreads: 1, interOpNumThreads: 1, logSeverityLevel: 3,
    };
    const open = (file) =>
      runtime.InferenceSession.create(path.join(folder, file), options);
    const model = new Model();
    model.runtime = runtime;
    model.encoder = await open("encoder_model.onnx");
    model.decoder = await open("decoder_model_merged.onnx");
    model.names = decoderNames(model.decoder.inputNames);
    return model;
  }

  // What was heard: to be given to begin().
  async encode(samples) {
    const input = this.floats(samples, [1, samples.length]);
    return (await this.encoder.run({ input_values: input })).last_hidden_state;
  }

  // The beginning of all texts. A state belongs to `width` texts of the same
  // length, whose next tokens are scored in `logits`, one row each.
  async begin(heard) {
    const { past, pastHeard, present, presentHeard } = this.names;
    const nothing = this.floats(
      new Float32Array(0), [0, HEADS, 1, eachOf(heard) / HEADS]);
    const empty = {};
    for (const name of [...past, ...pastHeard])
      empty[name] = nothing;
    const output = await this.decode([START], heard, empty, false);
    return {
      width: 1, length: 1, heard, logits: output.logits.data,
      said: present.map((name) => output[name].data),
      listened: presentHeard.map((name) => output[name]),
    };
  }

  // The state of the texts that go on: each is the `parents[i]`th of `state`
  // with tokens[i] behind it.
  async extend(state, parents, tokens) {
    const width = tokens.length;
    const listened = this.spread(state.listened, state.width, width);
    const heard = this.spread([state.heard], state.width, width)[0];
    const each = eachOf(heard);
    const before = {};
    const dims = [width, HEADS, state.length, each / HEADS];
    this.names.past.forEach((name, i) => {
      before[name] = this.floats(
        choose(state.said[i], parents, state.length * each), dims);
    });
    this.names.pastHeard.forEach((name, i) => { before[name] = listened[i]; });
    const output = await this.decode(tokens, heard, before, true);
    return {
      width, length: state.length + 1, heard, listened,
      logits: output.logits.data,
      said: this.names.present.map((name) => output[name].data),
    };
  }

  async decode(tokens, heard, past, goesOn) {
    const { Tensor } = this.runtime;
    return this.decoder.run({
      input_ids: new Tensor(
        "int64", BigInt64Array.from(tokens, BigInt), [tokens.length, 1]),
      encoder_hidden_states: heard,
      use_cache_branch: new Tensor("bool", [goesOn], [1]),
      ...past,
    });
  }

  // All texts have heard the same: their copies are made anew only if their
  // number changes.
  spread(tensors, from, to) {
    if (from === to)
      return tensors;
    return tensors.map((tensor) => {
      const dims = [to, ...tensor.dims.slice(1)];
      const each = tensor.data.length / from;
      return this.floats(choose(tensor.data, Array(to).fill(0), each), dims);
    });
  }

  floats(data, dims) {
    return new this.runtime.Tensor("float32", data, dims);
  }
}

// The numbers of one position in one layer.
const eachOf = (heard) => heard.dims.at(-1);

// The blocks of `data` at these indices, each of `size` numbers.
function choose(data, indices, size) {
  if (indices.length === 1 && data.length === size)
    return data;
  const chosen = new Float32Array(indices.length * size);
  indices.forEach((index, i) => chosen.set(
    data.subarray(index * size, (index + 1) * size), i * size));
  return chosen;
}
