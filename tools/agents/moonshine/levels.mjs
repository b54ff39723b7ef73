// How loud a turn was, piece by piece, and so which part of it was spoken. The
// network was trained on speech without long silences: it often hears nothing
// where much silence surrounds a short answer.

// What is louder than so much of the loudest piece is speech …
const PART_OF_PEAK = 0.12;
// … and than so many times the noise: what is softer than most pieces. Other
// people, who stand behind, are no louder; all chosen by measuring.
const TIMES_NOISE = 3;
const NOISE_PERCENTILE = 0.2;
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

  add(samples) {
    let sum = 0;
    for (const one of samples)
      sum += one * one;
    const level = Math.sqrt(sum / Math.max(1, samples.length));
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
    const least = Math.max(QUIETEST, Math.min(this.peak * SURELY,
      Math.max(this.peak * PART_OF_PEAK, this.noise() * TIMES_NOISE)));
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
