// Steering: texts that contain the application's words score higher. The words
// are a tree of tokens; a text that is on its way along a branch gets a bonus
// for each token, which it keeps at the end of the branch, where a word ends,
// and loses where it leaves the branch before that.

// Bounds what one hypothesis follows at a time.
const MOST_BRANCHES = 8;

export const NOTHING = { kept: 0, ways: [] };

export class Steering {
  start = NOTHING;

  // `phrases`: [{tokens, bonus}], the bonus of each token in natural logarithms
  // of a probability; `startsWord(token)`: whether a word begins with it or it
  // is punctuation.
  constructor(phrases, startsWord) {
    this.startsWord = startsWord;
    this.root = { next: new Map(), ends: false };
    for (const phrase of phrases)
      this.add(phrase);
  }

  add({ tokens, bonus }) {
    let node = this.root;
    for (const token of tokens) {
      if (!node.next.has(token))
        node.next.set(token, { next: new Map(), ends: false, bonus: 0 });
      node = node.next.get(token);
      node.bonus = Math.max(node.bonus, bonus);
    }
    if (node !== this.root)
      node.ends = true;
  }

  // The tokens that may get a bonus after this place.
  wanted({ ways }) {
    const tokens = new Set(this.root.next.keys());
    for (const { node } of ways)
      for (const token of node.next.keys())
        tokens.add(token);
    return tokens;
  }

  // The place after one more token.
  follow(place, token) {
    if (!this.startsWord(token))
      return { kept: place.kept, ways: this.steps(place.ways, token, 0) };
    const earned = this.earned(place);
    const ways = this.steps(place.ways, token, earned);
    const first = this.root.next.get(token);
    if (first)
      ways.push({ node: first, worth: first.bonus });
    return { kept: place.kept + earned, ways: ways.slice(0, MOST_BRANCHES) };
  }

  // The branches that go on with the token. `earned` was kept meanwhile: a
  // longer phrase is not to earn it again.
  steps(ways, token, earned) {
    const on = [];
    for (const { node, worth } of ways) {
      const next = node.next.get(token);
      if (next)
        on.push({ node: next, worth: worth - earned + next.bonus });
    }
    return on;
  }

  // What is earned if a word ends here: by the longest phrase that ends here.
  earned({ ways }) {
    return Math.max(0, ...ways.map(
      ({ node, worth }) => node.ends ? worth : 0));
  }

  // The bonus of a text that goes on.
  hoped({ kept, ways }) {
    return kept + Math.max(0, ...ways.map(({ worth }) => worth));
  }

  // The bonus of a text that ends here.
  final(place) {
    return place.kept + this.earned(place);
  }
}
