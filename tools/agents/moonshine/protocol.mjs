// The frames of the protocol (README.md): a line of JSON and, if it names
// `bytes`, that many bytes behind it.

const LONGEST_LINE = 4096;
const LONGEST_PAYLOAD = 1 << 20;

export class FrameReader {
  held = Buffer.alloc(0);
  head = null;

  // The frames that are complete now: [{head, payload}]. Throws if the bytes
  // are no frames; the stream cannot be read further then.
  add(bytes) {
    this.held = this.held.length ? Buffer.concat([this.held, bytes]) : bytes;
    const frames = [];
    for (let frame = this.next(); frame; frame = this.next())
      frames.push(frame);
    return frames;
  }

  next() {
    this.head ??= this.readHead();
    if (!this.head || this.held.length < this.head.bytes)
      return null;
    const { head } = this;
    const payload = this.held.subarray(0, head.bytes);
    this.held = this.held.subarray(head.bytes);
    this.head = null;
    return { head, payload };
  }

  readHead() {
    const end = this.held.indexOf(10);
    if ((end < 0 ? this.held.length : end) > LONGEST_LINE)
      throw new Error("a line is too long");
    if (end < 0)
      return null;
    const head = JSON.parse(this.held.toString("utf8", 0, end));
    this.held = this.held.subarray(end + 1);
    if (head === null || typeof head !== "object")
      throw new Error("a line is no object");
    head.bytes ??= 0;
    if (!Number.isInteger(head.bytes) || head.bytes < 0 ||
        head.bytes > LONGEST_PAYLOAD)
      throw new Error(`a payload of ${head.bytes} bytes`);
    return head;
  }
}

// 16 bit samples as numbers from -1 to 1.
export function samples(payload) {
  const count = payload.length >> 1;
  const numbers = new Float32Array(count);
  for (let i = 0; i < count; ++i)
    numbers[i] = payload.readInt16LE(2 * i) / 32768;
  return numbers;
}
