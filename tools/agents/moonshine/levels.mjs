// How loud a turn was, piece by piece, and so which part of it was spoken. The
// network was trained on speech without long silences: it often hears nothing
// where much silence surrounds a short answer.

// What is louder than so much of the loudest piece is speech …
const PART_OF_PEAK = 0.03;
// … if there is noise, which is softer than most pieces, than more of it …
const NOISE_PERCENTILE = 0.2;
const TIMES_NOISE = 12;
const PART_IN_NOISE = 0.12;
// … and in much noise, than so many times that: other people, who stand behind,
// are no louder. All chosen by measuring.
const TIMES_MUCH_NOISE = 3;
// But this part of the loudest piece is speech whatever the noise: a turn
// without pauses keeps its soft sounds.
const SURELY = 0.35;
// What is quieter was not said into a microphone.
const QUIETEST = 0.0005;
// What stays around speech, in samples; chosen by measuring. With less, the
// network writes more than was said.
const MARGIN_BEFORE = 2400;
const MARGIN_BEHIND = 3200;

export class Levels {
  pieces = []; // {level, end}
  length = 0;
  peak = 0;
  known = null; // what spoken() has returned, until there is more

  add(samples) {
    let sum = 0;
    for (const one of samples)
      sum += one * one;
    const level = Math.sqrt(sum / Math.max(1, samples.length));
    this.known = null;
    this.length += samples.length;
    this.pieces.push({ level, end: this.length });
    this.peak = Math.max(this.peak, level);
  }

  noise() {
    const levels = Float64Array.from(this.pieces, ({ level }) => level).sort();
    return levels[Math.floor(NOISE_PERCENTILE * (levels.length - 1))] ?? 0;
  }

  // The part that was spoken, as positions of samples, and where the speech
  // itself ends.
  spoken() {
    return this.known ??= this.find();
  }

  find() {
    const noise = this.noise();
    const least = Math.max(QUIETEST, Math.min(this.peak * SURELY,
      Math.max(this.peak * PART_OF_PEAK,
        Math.min(this.peak * PART_IN_NOISE, noise * TIMES_NOISE),
        noise * TIMES_MUCH_NOISE)));
    const isLoud = ({ level }) => level >= least;
    const first = this.pieces.findIndex(isLoud);
    const last = this.pieces.findLastIndex(isLoud);
    if (first < 0)
      return { from: 0, to: 0, end: 0 };
    const start = first > 0 ? this.pieces[first - 1].end : 0;
    const { end } = this.pieces[last];
    return {
      from: Math.max(0, start - MARGIN_BEFORE),
      to: Math.min(this.length, end + MARGIN_BEHIND), end,
    };
  }
}
