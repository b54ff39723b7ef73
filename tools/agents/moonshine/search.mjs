// Beam search: of all texts the likeliest ones, with the bonus of the steering,
// and the probability of each of their tokens.
import { END } from "./model.mjs";

// No more than this is said in a second; the model repeats itself for ever when
// it hears nothing.
const TOKENS_A_SECOND = 6.5;
const LEAST_TOKENS = 6;
// A text whose score is so much lower than the best one's is given up.
const HOPELESS = 10;
// More than steering adds to a token at once: one that is less likely than the
// best by this and the above need not be looked at. They are thousands.
const MOST_BONUS = 6;
// The network often finds it likely that nothing was said where a short answer
// was: it is believed only if it is as sure as this.
const SURE_OF_NOTHING = 0.9;

export const mostTokens = (seconds) =>
  Math.ceil(seconds * TOKENS_A_SECOND) + LEAST_TOKENS;

// The texts, best first: [{tokens, chances, score}]. `chances` are the
// probabilities of the tokens, as steered, and of the end.
export async function search(model, heard, { steering, width, most, isOver, plainPiece, isSaid = () => true }) {
  let state = await model.begin(heard);
  let beam = [{ tokens: [], chances: [], sum: 0, place: steering.start, text: "" }];
  const done = [];
  for (let length = 0; length < most; ++length) {
    if (isOver?.())
      return null;
    const next = candidates(state, beam, { steering, width, isSaid });
    beam = [];
    const parents = [];
    const seen = new Set();
    for (const one of next) {
      if (one.token === END) {
        done.push(finished(one, steering));
        continue;
      }
      const text = one.from.text + (plainPiece?.(one.token) ?? "");
      if (plainPiece) {
        if (seen.has(text))
          continue;
        seen.add(text);
      }
      beam.push({ ...grown(one), text });
      parents.push(one.row);
      if (beam.length === width)
        break;
    }
    if (beam.length === 0 || isDecided(done, beam, steering))
      break;
    state = await model.extend(
      state, parents, beam.map((one) => one.tokens.at(-1)));
  }
  for (const one of beam)
    done.push({ ...one, score: one.sum + steering.final(one.place) });
  return done.sort((a, b) => b.score - a.score).slice(0, width);
}

// Whether no text that goes on can overtake a finished one.
const isDecided = (done, beam, steering) => done.some((one) => beam.every(
  (other) => other.sum + steering.hoped(other.place) < one.score));

function finished({ from, log, chance }, steering) {
  const sum = from.sum + log;
  return {
    tokens: from.tokens, chances: [...from.chances, chance], sum,
    score: sum + steering.final(from.place),
  };
}

const grown = ({ from, token, log, chance, place }) => ({
  tokens: [...from.tokens, token], chances: [...from.chances, chance],
  sum: from.sum + log, place,
});

// The probability of a token with its bonus, against all others without one.
function steered(log, bonus) {
  const raised = Math.exp(log + Math.max(0, bonus));
  return raised / (raised + 1 - Math.exp(log));
}

// The best ways in which the texts of the beam may go on, best first: the
// likeliest tokens that can be said and those which the steering wants.
function candidates(state, beam, { steering, width, isSaid }) {
  const size = state.logits.length / state.width;
  const all = [];
  beam.forEach((from, row) => {
    const logits = state.logits.subarray(row * size, (row + 1) * size);
    const total = logSum(logits);
    const best = likeliest(logits, 2 * width, isSaid);
    const tokens = new Set(best);
    const least = logits[best[0]] - HOPELESS - MOST_BONUS;
    for (const token of steering.wanted(from.place))
      if (logits[token] >= least)
        tokens.add(token);
    for (const token of tokens) {
      const log = logits[token] - total;
      const ends = token === END;
      const place = ends ? from.place : steering.follow(from.place, token);
      const bonus = ends ? steering.final(place) : steering.hoped(place);
      if (ends && from.tokens.length === 0 && log < Math.log(SURE_OF_NOTHING))
        continue;
      all.push({ from, row, token, place, log, score: from.sum + log + bonus,
        chance: steered(log, bonus - steering.hoped(from.place)) });
    }
  });
  all.sort((a, b) => b.score - a.score);
  return all.slice(0, 2 * width)
    .filter(({ score }) => score > all[0].score - HOPELESS);
}

// Terms that cannot change the sum are left out.
function logSum(logits) {
  let most = -Infinity;
  for (const one of logits)
    if (one > most)
      most = one;
  let sum = 0;
  for (const one of logits)
    if (one > most - 15)
      sum += Math.exp(one - most);
  return most + Math.log(sum);
}

function likeliest(logits, count, isSaid) {
  const best = [];
  let least = -Infinity;
  for (let token = 0; token < logits.length; ++token) {
    if (best.length === count && logits[token] <= least)
      continue;
    if (token !== END && !isSaid(token))
      continue;
    let at = best.length;
    while (at > 0 && logits[best[at - 1]] < logits[token])
      --at;
    best.splice(at, 0, token);
    if (best.length > count)
      best.pop();
    least = logits[best.at(-1)];
  }
  return best;
}
