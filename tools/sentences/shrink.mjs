// Writes sentences.encoder: a network that turns sentences into numbers, a byte
// for each of its weights. Always writes the same bytes. The format stands in
// adapters/nlu/encoder/sentence_encoder.hpp.
//
//   node shrink.mjs FOLDER sentences.encoder
//
// FOLDER has the network as the npm package ships it: model.json says what its
// weights are called and which files have them, vocab.json the pieces of words.

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [from, to] = process.argv.slice(2);
const network = JSON.parse(readFileSync(join(from, "model.json"), "utf8"));
const [manifest] = network.weightsManifest;
const bytes = Buffer.concat(
  manifest.paths.map((path) => readFileSync(join(from, path))),
);

// Name to { shape, numbers }; each number takes four bytes.
const weights = new Map();
let at = 0;
for (const { name, shape, dtype, quantization } of manifest.weights) {
  if (quantization || !["int32", "float32"].includes(dtype))
    throw new Error(`${name} has numbers of another kind`);
  const count = shape.reduce((product, size) => product * size, 1);
  const read = (each) =>
    dtype === "int32"
      ? bytes.readInt32LE(at + 4 * each)
      : bytes.readFloatLE(at + 4 * each);
  weights.set(name, { shape, numbers: Array.from({ length: count }, (_, each) => read(each)) });
  at += 4 * count;
}
if (at !== bytes.length) throw new Error("the files have more than the weights");

// The only weight whose name has all of these parts.
function weight(...parts) {
  const found = [...weights.keys()].filter((name) =>
    parts.every((part) => name.includes(part)),
  );
  if (found.length !== 1)
    throw new Error(`${found.length} weights are called ${parts.join(" … ")}`);
  return weights.get(found[0]);
}

const written = [];

function number(value) {
  const made = [];
  for (; value >= 0x80; value = Math.floor(value / 0x80))
    made.push((value % 0x80) | 0x80);
  written.push(Buffer.from([...made, value]));
}

function block(buffer) {
  number(buffer.length);
  written.push(buffer);
}

function floats(numbers) {
  block(Buffer.from(Float32Array.from(numbers).buffer));
}

function table(rows) {
  const steps = rows.map((row) => {
    const largest = row.reduce((most, one) => Math.max(most, Math.abs(one)), 0);
    return largest / 127 || 1;
  });
  number(rows.length);
  number(rows[0].length);
  floats(steps);
  block(
    Buffer.from(
      Int8Array.from(
        rows.flatMap((row, each) => row.map((one) => Math.round(one / steps[each]))),
      ).buffer,
    ),
  );
}

// The rows of a matrix with `width` columns.
function rowsOf(numbers, width) {
  return Array.from({ length: numbers.length / width }, (_, row) =>
    numbers.slice(row * width, (row + 1) * width),
  );
}

// Its columns; so many come out of the layer.
function columnsOf({ numbers }, outputs) {
  const rows = rowsOf(numbers, outputs);
  return Array.from({ length: outputs }, (_, column) =>
    rows.map((row) => row[column]),
  );
}

function dense(matrix, added) {
  table(columnsOf(matrix, added.numbers.length));
  floats(added.numbers);
}

function norm(...parts) {
  floats(weight(...parts, "layer_norm_scale").numbers);
  floats(weight(...parts, "layer_norm_bias").numbers);
}

function layer(name) {
  const attention = `${name}/TransformerLayer/MultiheadAttention/`;
  const dimensions = weight(attention + "qkv_transform_single/bias");
  const head = weight(attention + "split_heads/split_last_dimension/Reshape/shape/3");
  number(dimensions.numbers.length / 3 / head.numbers[0]);
  norm(`${name}/TransformerLayer/layer_prepostprocess`);
  dense(weight(attention + "qkv_transform_single/kernel"), dimensions);
  const out = weight(attention + "output_transform_single/bias");
  dense(weight(attention + "output_transform_single/kernel"), out);
  if (out.numbers.length !== dimensions.numbers.length / 3)
    dense(
      weight(`${name}/TransformerLayer/dense/kernel`),
      weight(`${name}/TransformerLayer/dense/bias`),
    );
  norm(`${name}/TransformerLayer/FFN/layer_prepostprocess`);
  for (const step of ["conv1", "conv2"])
    dense(
      weight(`${name}/TransformerLayer/FFN/${step}/Tensordot/Reshape_1`),
      weight(`${name}/TransformerLayer/FFN/${step}/bias`),
    );
}

written.push(Buffer.from("PARLOURS"));
const pieces = JSON.parse(readFileSync(join(from, "vocab.json"), "utf8"));
number(pieces.length);
for (const [text] of pieces) block(Buffer.from(text));
floats(pieces.map(([, score]) => score));
const meanings = weight("Embeddings_en");
table(rowsOf(meanings.numbers, meanings.shape[1]).slice(0, pieces.length));
const layers = ["Layer_0", "Layer_1"];
number(layers.length);
layers.forEach(layer);
dense(weight("tanh_layer_0/weights"), weight("tanh_layer_0/bias"));
writeFileSync(to, Buffer.concat(written));
