// Writes words.vectors: the numbers of the most frequent words, made small. Takes
// a minute and 2 GB of memory, and always writes the same bytes.
// The format stands in adapters/nlu/learning/word_vectors.hpp.
//
//   node cut.mjs VECTORS.json words.vectors

import { readFileSync, writeFileSync } from "node:fs";

const mostWords = 40_000;
// Words that are taken for the centres of groups, and how often they are moved.
const centreWords = 10_000;
const rounds = 8;
const groupCount = 64;
const smallerGroupCount = 512;
// A word that is as frequent as this counts half.
const halfFrequency = 1e-3;
// How frequent the first word is, roughly; the others by their rank.
const highestFrequency = 0.1;

// FNV-1a, 64 bits.
function hashOf(word) {
  let hash = 0xcbf29ce484222325n;
  for (const byte of Buffer.from(word))
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  return hash;
}

function unit(vector) {
  const length = Math.hypot(...vector) || 1;
  return Float32Array.from(vector, (number) => number / length);
}

function closest(vector, centres) {
  let best = 0;
  let most = -Infinity;
  centres.forEach((centre, at) => {
    let product = 0;
    for (let number = 0; number < centre.length; ++number)
      product += centre[number] * vector[number];
    if (product > most) [best, most] = [at, product];
  });
  return best;
}

// The group of each vector, from 1 on, of `count` at most: k-means by the angle.
function groups(vectors, count) {
  const some = vectors.slice(0, centreWords);
  const stride = Math.ceil(some.length / count);
  let centres = some.filter((_, at) => at % stride === 0);
  for (let round = 0; round < rounds; ++round) {
    const sums = centres.map((centre) => new Float32Array(centre.length));
    for (const vector of some) {
      const sum = sums[closest(vector, centres)];
      for (let at = 0; at < sum.length; ++at) sum[at] += vector[at];
    }
    centres = sums.map(unit);
  }
  return vectors.map((vector) => closest(vector, centres) + 1);
}

function record(word, rank, vector, group, smallerGroup) {
  const largest = Math.max(...vector.map(Math.abs));
  const frequency = highestFrequency / (rank + 1);
  const weight = halfFrequency / (halfFrequency + frequency);
  const bytes = Buffer.alloc(16 + vector.length);
  bytes.writeBigUInt64LE(hashOf(word), 0);
  bytes.writeFloatLE((weight * largest) / 127, 8);
  bytes.writeUInt16LE(group, 12);
  bytes.writeUInt16LE(smallerGroup, 14);
  vector.forEach((number, at) =>
    bytes.writeInt8(Math.round((number / largest) * 127), 16 + at),
  );
  return bytes;
}

const [from, to] = process.argv.slice(2);
const { words, vectors, dimensions } = JSON.parse(readFileSync(from, "utf8"));
const kept = words
  .filter((word) => /^[a-z][a-z'-]*$/.test(word))
  .slice(0, mostWords);
const units = kept.map((word) => unit(vectors[word].slice(0, dimensions)));
const large = groups(units, groupCount);
const small = groups(units, smallerGroupCount);
const records = kept
  .map((word, at) => record(word, at, units[at], large[at], small[at]))
  .sort((left, right) =>
    Number(left.readBigUInt64LE() > right.readBigUInt64LE()) * 2 - 1,
  );
const header = Buffer.alloc(16);
header.write("PARLOURW");
header.writeUInt32LE(records.length, 8);
header.writeUInt32LE(dimensions, 12);
writeFileSync(to, Buffer.concat([header, ...records]));
