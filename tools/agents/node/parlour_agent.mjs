// An agent of the dialogue platform Parlour: a robot, a sensor or any other
// program that takes part in conversations from a process of its own.
//
//     import { Agent } from "./parlour_agent.mjs";
//
//     const robot = new Agent("Robot", "lines://127.0.0.1:5671");
//     robot.on("Goto", async (message) => {
//       await driveTo(message.parameters[0]);
//       await robot.answer(message, "Arrived", [message.parameters[0]]);
//     });
//     robot.start();
//
// This file is all that an agent needs. It speaks both transports of the
// platform: `lines://host:port` needs nothing but Node.js, `zmq://host:port`
// needs the package zeromq (`npm install zeromq`). The protocol is
// adapters/agents/PROTOCOL.md.
//
// Nothing that an agent sends is lost and nothing arrives twice while both
// processes live, however often the connection breaks; the agent connects
// again by itself. Handlers begin in the order of the messages; who returns a
// promise does not hold up the next. A handler must not keep the process busy
// for long: Node.js has one thread, and a silent agent counts as offline.

import { randomBytes, randomInt } from "node:crypto";
import net from "node:net";
import tls from "node:tls";

export const MAX_MESSAGE_BYTES = 1 << 20;
export const MAX_PARAMETERS = 64;
export const MAX_ATTRIBUTE_BYTES = 1024;
// Escapes and doubled quotation marks make a line longer than its message.
const MAX_LINE_BYTES = 2 * MAX_MESSAGE_BYTES + 2 * MAX_ATTRIBUTE_BYTES;
const MAX_MALFORMED = 10; // in a row
const MAX_NUMBER = (1n << 63n) - 1n;
const NEVER = 2 ** 30; // milliseconds: longer than any connection waits
// Of the protocol, that this file speaks.
const NEWEST_VERSION = 1;
const OLDEST_VERSION = 1;
const KINDS = new Set([
  "text", "binary", "hello", "welcome", "ack", "beat", "error", "bye",
]);
const PROTOCOL = "parlour/1";
const NUMBERS = new Map([
  ["n", "number"], ["a", "acknowledged"], ["w", "window"],
  ["c", "correlation"], ["d", "deadline"],
]);
const CLOSING = new Set([
  "oversized", "version", "identity", "replaced", "flood",
]);

// -- messages (PROTOCOL 1) ----------------------------------------------------

// What is wrong with a message; `kind` as in PROTOCOL 5.
export class WireError extends Error {
  losesTrack = false; // what follows cannot be told from the rest of it

  constructor(kind, sentence) {
    super(sentence);
    this.name = "WireError";
    this.kind = kind;
  }

  // Whether the connection ends with it.
  get closes() {
    return this.losesTrack || CLOSING.has(this.kind);
  }
}

function malformed(sentence) {
  return new WireError("malformed", sentence);
}

function oversized(sentence) {
  return new WireError("oversized", sentence);
}

// Bytes that travel with a message; their place among the parameters.
export class Payload {
  constructor(format = "", bytes = Buffer.alloc(0), position = undefined) {
    this.format = format;
    this.bytes = bytes;
    this.position = position;
  }
}

// What an agent and the platform say to each other. Numbers are Numbers where
// these are exact, else BigInts.
export class Message {
  constructor(said = {}) {
    this.kind = "text";
    this.session = "";
    this.sinks = [];
    this.number = undefined;
    this.acknowledged = undefined;
    this.window = undefined;
    this.correlation = undefined;
    this.deadline = undefined; // milliseconds
    this.gap = false;
    this.time = undefined; // milliseconds since 1970
    this.component = "";
    this.command = "";
    this.parameters = []; // texts
    this.payload = undefined;
    Object.assign(this, said);
  }

  // The parameters as values: JSON ones are decoded.
  values() {
    return this.parameters.map(valueOf);
  }
}

// A value as a parameter: texts as they are, all else as JSON.
export function parameterOf(value) {
  if (typeof value === "string" && !value.startsWith("\x01")) return value;
  if (typeof value === "bigint") return `\x01J${value}`;
  if (typeof value === "number" && !Number.isFinite(value))
    throw new TypeError(`${value} is no number of JSON`);
  return "\x01J" + (JSON.stringify(value) ?? "null");
}

// The value of a parameter.
export function valueOf(parameter) {
  return parameter.startsWith("\x01J")
    ? JSON.parse(parameter.slice(2)) : parameter;
}

// A number of PROTOCOL 1.3.
export function numberOf(text, what) {
  const number = /^[0-9]+$/.test(text) ? BigInt(text) : -1n;
  if (number < 0n || number > MAX_NUMBER)
    throw malformed(`${what} is no number: '${text.slice(0, 32)}'`);
  return number <= Number.MAX_SAFE_INTEGER ? Number(number) : number;
}

function checkAttribute(value) {
  if (!/^[A-Za-z0-9_.:-]+$/.test(value))
    throw malformed(`'${value.slice(0, 32)}' holds what an attribute cannot`);
  return value;
}

function headOf(message) {
  let head = message.kind;
  if (message.session) head += ";s=" + checkAttribute(message.session);
  for (const sink of message.sinks) head += ";k=" + checkAttribute(sink);
  for (const [letter, name] of NUMBERS)
    if (message[name] !== undefined) head += `;${letter}=${message[name]}`;
  if (message.payload?.position !== undefined)
    head += `;p=${message.payload.position}`;
  if (message.gap) head += ";g=1";
  if (head.length > MAX_ATTRIBUTE_BYTES)
    throw oversized("too many attributes");
  return head;
}

// All fields but the payload's bytes.
export function fieldsOf(message) {
  if (message.parameters.length > MAX_PARAMETERS)
    throw oversized("too many parameters");
  const fields = [
    headOf(message), message.time === undefined ? "" : `${message.time}`,
    message.component, message.command, ...message.parameters,
  ];
  if (message.payload) fields.push(message.payload.format);
  else if (!message.parameters.length)
    while (fields.length > 1 && !fields.at(-1)) fields.pop();
  checkSize(fields, message.payload?.bytes.length ?? 0);
  return fields;
}

function checkSize(fields, payloadBytes) {
  const size = fields.reduce(
    (sum, field) => sum + Buffer.byteLength(field), payloadBytes);
  if (size > MAX_MESSAGE_BYTES) throw oversized("the message is too long");
}

// Raises where a message could never be written: it would hold up everything
// behind it. Its numbers are given later and are as long as they can be.
function checkWritable(message) {
  fieldsOf(new Message(
    { ...message, number: MAX_NUMBER, acknowledged: MAX_NUMBER }));
}

// The message of these fields; trusts nothing.
export function messageOf(fields, payloadBytes = Buffer.alloc(0)) {
  const message = new Message();
  const position = readHead(fields[0], message);
  if (fields[1]) message.time = numberOf(fields[1], "the time");
  message.component = fields[2] ?? "";
  message.command = fields[3] ?? "";
  message.parameters = fields.slice(4);
  if (message.kind === "binary") takePayload(message, payloadBytes, position);
  if (message.parameters.length > MAX_PARAMETERS)
    throw oversized("too many parameters");
  checkSize(fields.slice(2), payloadBytes.length);
  return message;
}

function takePayload(message, bytes, position) {
  if (!message.parameters.length)
    throw malformed("a binary message has its payload's format");
  message.payload = new Payload(message.parameters.pop(), bytes, position);
  if (position > message.parameters.length)
    throw malformed("the payload's position is beyond the parameters");
}

function readHead(field, message) {
  if (Buffer.byteLength(field) > MAX_ATTRIBUTE_BYTES)
    throw oversized("too many attributes");
  const [kind, ...attributes] = field.split(";");
  if (!KINDS.has(kind))
    throw new WireError("unknown", `there is no kind '${kind.slice(0, 32)}'`);
  message.kind = kind;
  const seen = new Set();
  let position;
  for (const attribute of attributes) {
    const letter = attribute[0];
    if (attribute[1] !== "=")
      throw malformed("an attribute is letter=value, not " +
                      `'${attribute.slice(0, 32)}'`);
    const value = checkAttribute(attribute.slice(2));
    if (letter !== "k" && seen.has(letter))
      throw malformed(`${letter} occurs twice`);
    seen.add(letter);
    if (letter === "p") position = numberOf(value, "p");
    else setAttribute(message, letter, value);
  }
  return position;
}

function setAttribute(message, letter, value) {
  if (letter === "k") message.sinks.push(value);
  else if (letter === "s") message.session = value;
  else if (letter === "g") message.gap = value === "1";
  else if (NUMBERS.has(letter))
    message[NUMBERS.get(letter)] = numberOf(value, letter);
}

function decode(bytes, what) {
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true })
      .decode(bytes);
  } catch {
    throw malformed(`${what} is not UTF-8`);
  }
}

// -- lines (PROTOCOL 2.1, 2.2) ------------------------------------------------

const ESCAPED = { "\n": "\\n", "\r": "\\r", "\\": "\\\\", '"': '""' };
const UNESCAPED = { "\\n": "\n", "\\r": "\r", "\\\\": "\\" };

function fieldText(field) {
  const text = field.replace(/[\n\r\\"]/g, (character) => ESCAPED[character]);
  return /[,"]|^[ \t]|[ \t]$/.test(field) ? `"${text}"` : text;
}

// The bytes of a message's line, its end and its payload.
export function lineOf(message) {
  const fields = fieldsOf(message).map(fieldText);
  const bytes = message.payload?.bytes;
  if (bytes) fields.push(`${bytes.length}`);
  const line = Buffer.from(fields.join(",") + "\n");
  return bytes ? Buffer.concat([line, bytes]) : line;
}

function unescaped(text) {
  return text.replace(/\\[^]?/g, (escape) => {
    if (!(escape in UNESCAPED))
      throw malformed("a backslash is followed by n, r or a backslash");
    return UNESCAPED[escape];
  });
}

// Where the quoted field ends that begins at `at`: behind its last mark.
function endOfQuoted(line, at) {
  let end = at + 1;
  for (;; end += 2) {
    end = line.indexOf('"', end);
    if (end < 0) throw malformed("a quotation mark is not closed");
    if (line[end + 1] !== '"') break;
  }
  if (end + 1 < line.length && line[end + 1] !== ",")
    throw malformed("a comma must follow a closing quotation mark");
  return end + 1;
}

function endOfPlain(line, at) {
  const comma = line.indexOf(",", at);
  const end = comma < 0 ? line.length : comma;
  if (line.slice(at, end).includes('"'))
    throw malformed("a quotation mark stands within a field");
  return end;
}

function fieldsIn(line) {
  const fields = [];
  for (let at = 0; ; ++at) { // the comma
    const quoted = line[at] === '"';
    const end = (quoted ? endOfQuoted : endOfPlain)(line, at);
    fields.push(unescaped(quoted
      ? line.slice(at + 1, end - 1).replaceAll('""', '"')
      : line.slice(at, end)));
    if (fields.length > MAX_PARAMETERS + 6)
      throw oversized("too many fields");
    if (end >= line.length) return fields;
    at = end;
  }
}

// Bytes as they arrive, to messages; trusts nothing.
export class LineReader {
  #held = Buffer.alloc(0);
  #scanned = 0; // no line ends before it
  #fields = undefined; // of a message whose payload is to come
  #wanted = 0;

  add(data) {
    this.#held = this.#held.length ? Buffer.concat([this.#held, data]) : data;
  }

  // The next message, or undefined where more bytes are needed. Throws a
  // WireError for what cannot be read, and goes on behind it unless the error
  // closes the connection.
  next() {
    for (;;) {
      if (this.#fields) return this.#payload();
      let line = this.#line();
      if (line === undefined) return undefined;
      if (line.at(-1) === 0x0d) line = line.subarray(0, -1);
      if (!line.length) continue;
      const fields = this.#fieldsOf(line);
      if (fields) return messageOf(fields);
    }
  }

  // Undefined where a payload is awaited. Without its length (PROTOCOL 2.2) its
  // bytes would be read as lines.
  #fieldsOf(line) {
    let fields;
    try {
      fields = fieldsIn(decode(line, "the line"));
      if (!isBinary(fields[0])) return fields;
      this.#wanted = numberOf(fields.pop(), "a payload's length");
    } catch (error) {
      error.losesTrack =
        isBinary(line.toString("latin1").replace(/^"/, "").split(/[,"]/)[0]);
      throw error;
    }
    if (this.#wanted > MAX_MESSAGE_BYTES)
      throw oversized("the payload is too long");
    this.#fields = fields;
    return undefined;
  }

  #line() {
    const end = this.#held.indexOf(0x0a, this.#scanned);
    if ((end < 0 ? this.#held.length : end) > MAX_LINE_BYTES)
      throw oversized("the line is too long");
    this.#scanned = end < 0 ? this.#held.length : 0;
    return end < 0 ? undefined : this.#take(end + 1).subarray(0, end);
  }

  // A malformed message's payload is taken, too: it is no line.
  #payload() {
    if (this.#held.length < this.#wanted) return undefined;
    const fields = this.#fields;
    this.#fields = undefined;
    return messageOf(fields, Buffer.from(this.#take(this.#wanted)));
  }

  #take(size) {
    const taken = this.#held.subarray(0, size);
    this.#held = this.#held.subarray(size);
    return taken;
  }
}

function isBinary(head) {
  return head === "binary" || head.startsWith("binary;");
}

// -- frames (PROTOCOL 2.3) ----------------------------------------------------

// The frames of a message, as bytes.
export function framesOf(message) {
  const frames = [PROTOCOL, ...fieldsOf(message)]
    .map((field) => Buffer.from(field));
  if (message.payload) frames.push(message.payload.bytes);
  return frames;
}

// The message of these frames; trusts nothing.
export function readFrames(frames) {
  if (!frames.length || !Buffer.from(PROTOCOL).equals(frames[0]))
    throw new WireError("version", `the first frame is not ${PROTOCOL}`);
  const fields = frames.slice(1);
  if (!fields.length) throw malformed("the message has no fields");
  const binary = isBinary(fields[0].toString()) && fields.length > 1;
  const payload = binary ? fields.pop() : undefined;
  return messageOf(fields.map((field) => decode(field, "a field")), payload);
}

// -- delivery (PROTOCOL 4) ----------------------------------------------------

// One side of the promise that nothing is lost and nothing arrives twice. It
// outlives connections. Knows no socket and no clock; times are milliseconds.
export class Link {
  static WINDOW = 100;
  static MAX_WAITING = 1000;
  static MAX_WAITING_BYTES = 4 << 20;
  static ACK_AFTER = 50; // and told within 50 more
  static BEAT_AFTER = 1000;
  static OFFLINE_AFTER = 3000;

  connected = false;
  #peer = "";
  #peerWindow = Link.WINDOW;
  #outbox = []; // messages after #acknowledged
  #outboxBytes = 0;
  #sent = 0; // of the outbox, on this connection
  #acknowledged = 0;
  #lastSent = 0; // of this numbering, on whichever connection
  #received = 0;
  #handedOn = 0;
  #told = 0;
  #gap = false;
  #gapIsTold = false;
  #heard = 0;
  #said = 0;
  #numberSaid = 0; // when the peer was told of the last number
  #since = 0;

  constructor(incarnation) {
    this.incarnation = incarnation;
  }

  // What this side's hello says, as parameters.
  introduction() {
    const said = [`incarnation=${this.incarnation}`, `window=${Link.WINDOW}`];
    if (this.#peer) said.push(`seen=${this.#peer}:${this.#handedOn}`);
    return said;
  }

  // The other side's hello or welcome has arrived. False: it has received more
  // than was ever sent; hello is to be said again, in another incarnation.
  // Throws a WireError.
  connect(parameters, now) {
    const said = new Map(parameters.map((parameter) => {
      const equals = (parameter + "=").indexOf("=");
      return [parameter.slice(0, equals), parameter.slice(equals + 1)];
    }));
    const window = numberOf(said.get("window") ?? `${Link.WINDOW}`, "window");
    const [seen, seenNumber = ""] = (said.get("seen") ?? "").split(":");
    const number = seen ? numberOf(seenNumber, "seen") : 0;
    const peer = said.get("incarnation") ?? "";
    if (seen === this.incarnation && number > this.#lastSent) {
      this.incarnation = newIncarnation();
      this.#peer = "";
      this.#beginAfresh();
      return false;
    }
    // Who has forgotten this side, or what it acknowledged, begins afresh.
    const same = peer !== "" && peer === this.#peer &&
      seen === this.incarnation && number >= this.#acknowledged;
    if (!same) this.#beginAfresh();
    this.#peer = peer;
    this.#peerWindow = Math.max(Number(window), 1);
    this.#sent = 0;
    if (same) this.#forget(number);
    this.connected = true;
    this.#gap = this.#gapIsTold = false;
    this.#heard = this.#said = this.#numberSaid = now;
    return true;
  }

  disconnect() {
    this.connected = false;
  }

  // False where the outbox is full.
  send(message) {
    const size = weight(message);
    if (this.#outbox.length >= Link.MAX_WAITING ||
        this.#outboxBytes + size > Link.MAX_WAITING_BYTES)
      return false;
    message.number = this.#acknowledged + this.#outbox.length + 1;
    this.#outboxBytes += size;
    this.#outbox.push(message);
    return true;
  }

  // How many messages are not acknowledged yet.
  get waiting() {
    return this.#outbox.length;
  }

  // Something has arrived, be it part of a message.
  heard(now) {
    this.#heard = now;
  }

  // True: the message is to be handed on, then handedOn() called if it has a
  // number. Throws a WireError.
  receive(message, now) {
    this.#heard = now;
    if (message.acknowledged !== undefined) this.#takeAcknowledgement(message);
    if (message.kind === "text" || message.kind === "binary")
      return message.number === undefined || this.#takeNew(message, now);
    if (message.kind === "beat" && message.number > this.#received)
      this.#gap = true;
    return false;
  }

  // A withdrawn message counts, and means nothing else (PROTOCOL 4.8).
  #takeNew(message, now) {
    if (!this.#takeNumbered(message.number, now)) return false;
    if (message.command) return true;
    this.handedOn();
    return false;
  }

  handedOn() {
    this.#handedOn = Math.min(this.#handedOn + 1, this.#received);
  }

  // What is to be written now, in this order.
  output(now) {
    if (!this.connected) return [];
    const out = [];
    while (this.#sent < Math.min(this.#outbox.length, this.#peerWindow))
      out.push(this.#acknowledging(this.#outbox[this.#sent++]));
    this.#lastSent =
      Math.max(this.#lastSent, this.#acknowledged + this.#sent);
    if (out.length) this.#numberSaid = now;
    if (this.#gap || this.#ackIsDue(now)) out.push(this.#ownAck());
    if (this.#beatIsDue(out, now)) {
      out.push(this.#ownBeat());
      this.#numberSaid = now;
    }
    if (out.length) this.#said = now;
    return out;
  }

  // What this side says last.
  farewell() {
    return [this.#ownAck(), new Message({ kind: "bye" })];
  }

  // False: the other side was silent for too long.
  alive(now) {
    return !this.connected || now - this.#heard < Link.OFFLINE_AFTER;
  }

  #beginAfresh() {
    this.#acknowledged = this.#lastSent = 0;
    this.#received = this.#handedOn = this.#told = 0;
    this.#outbox.forEach((message, at) => { message.number = at + 1; });
  }

  #takeAcknowledgement(message) {
    if (message.acknowledged > this.#lastSent)
      throw malformed("acknowledges what was never sent");
    this.#forget(message.acknowledged);
    if (message.window !== undefined)
      this.#peerWindow = Math.max(Number(message.window), 1);
    if (message.gap) this.#sent = 0; // from the first that is missing
  }

  #takeNumbered(number, now) {
    if (number <= this.#received) { // the acknowledgement may have been lost
      this.#told = Math.max(Math.min(this.#told, number - 1), 0);
      return false;
    }
    if (number > this.#handedOn + Link.WINDOW)
      throw new WireError("flood", "more came than the window allows");
    if (number !== this.#received + 1) {
      this.#gap ||= !this.#gapIsTold;
      this.#gapIsTold = true;
      return false;
    }
    this.#gapIsTold = false;
    this.#received = number;
    if (this.#handedOn === this.#told) this.#since = now;
    return true;
  }

  #forget(number) {
    while (this.#acknowledged < number && this.#outbox.length) {
      this.#outboxBytes -= weight(this.#outbox.shift());
      this.#acknowledged += 1;
      this.#sent = Math.max(this.#sent - 1, 0);
    }
  }

  #ackIsDue(now) {
    const behind = this.#handedOn - this.#told;
    return behind >= Link.WINDOW / 2 ||
      behind > 0 && now - this.#since >= Link.ACK_AFTER;
  }

  // Also where acknowledgements alone are said: they do not tell the last
  // number, so that the loss of the last message would not be noticed.
  #beatIsDue(out, now) {
    return !out.length && now - this.#said >= Link.BEAT_AFTER ||
      this.#sent > 0 && now - this.#numberSaid >= Link.BEAT_AFTER;
  }

  #ownAck() {
    const ack = this.#acknowledging({ kind: "ack", gap: this.#gap });
    ack.acknowledged = this.#handedOn; // also 0: nothing has arrived
    this.#gap = false;
    return ack;
  }

  #ownBeat() {
    return this.#acknowledging({
      kind: "beat", number: this.#acknowledged + this.#sent || undefined,
    });
  }

  #acknowledging(said) {
    const message = new Message(said);
    if (this.#handedOn) message.acknowledged = this.#handedOn;
    this.#told = this.#handedOn;
    return message;
  }
}

function weight(message) {
  const texts = [message.component, message.command, ...message.parameters];
  return texts.reduce((sum, text) => sum + Buffer.byteLength(text),
                      message.payload?.bytes.length ?? 0);
}

// -- transports ---------------------------------------------------------------

// A connection that carries lines. Tells `events`: opened(), heard(),
// arrived(message or WireError), lost(reason).
class Lines {
  #socket;
  #events;

  constructor(host, port, options, events) {
    this.#events = events;
    this.#socket = options.tls
      ? tls.connect({ ...options.tls, host, port })
      : net.connect({ host, port });
    const reader = new LineReader();
    let reason = "the platform closed the connection";
    this.#socket.setNoDelay(true);
    this.#socket.on(options.tls ? "secureConnect" : "connect",
                    () => this.#events?.opened());
    this.#socket.on("data", (data) => this.#take(reader, data));
    this.#socket.on("error", (error) => { reason = error.message; });
    this.#socket.on("close", () => this.#events?.lost(reason));
  }

  // What is not sent yet would only grow.
  get isCongested() {
    return this.#socket.writableLength > Link.MAX_WAITING_BYTES;
  }

  write(message) {
    if (this.#socket.writable) this.#socket.write(lineOf(message));
  }

  // What was written still leaves. Nothing is told any more.
  close() {
    this.#events = undefined;
    this.#socket.end();
    setTimeout(() => this.#socket.destroy(), 500).unref();
  }

  #take(reader, data) {
    this.#events?.heard();
    reader.add(data);
    while (this.#events) {
      const message = attempt(() => reader.next());
      if (message === undefined) return;
      this.#events.arrived(message);
    }
  }
}

// A connection by ZeroMQ, with the same methods.
class Frames {
  isCongested = false;
  #dealer;
  #events;

  constructor(host, port, options, events) {
    this.#events = events;
    this.#open(host, port, options).catch(
      (error) => this.#events?.lost(error.message));
  }

  async write(message) {
    const frames = framesOf(message);
    try {
      await this.#dealer?.send(frames);
    } catch {
      // What the socket cannot take is missed and sent again.
    }
  }

  close() {
    this.#events = undefined;
    this.#dealer?.close();
  }

  async #open(host, port, { keys }) {
    const { Dealer } = await import("zeromq").catch((error) => {
      throw new Error(`zmq:// needs \`npm install zeromq\`: ${error.message}`);
    });
    if (!this.#events) return;
    const [publicKey, secretKey, serverKey] = keys ?? [];
    // By itself ZeroMQ would connect again without a hello. Told never to (-1),
    // it ends its pipe while a message is half read, and aborts the process.
    this.#dealer = new Dealer({
      linger: 500, sendTimeout: 0, reconnectInterval: NEVER,
      ipv6: host.includes(":"),
      ...(keys && { curvePublicKey: publicKey, curveSecretKey: secretKey,
                    curveServerKey: serverKey }),
    });
    for (const end of ["disconnect", "close"])
      this.#dealer.events.on(end, () => this.#lost());
    this.#dealer.connect(
      `tcp://${host.includes(":") ? `[${host}]` : host}:${port}`);
    this.#events.opened();
    for await (const frames of this.#dealer) {
      this.#events?.heard();
      this.#events?.arrived(attempt(() => readFrames(frames)));
    }
  }

  #lost() {
    if (!this.#events) return; // it was closed here
    this.#dealer.linger = 0; // what it says now means nothing
    this.#events.lost("the connection was closed");
  }
}

// What a reader gives, or its WireError.
function attempt(read) {
  try {
    return read();
  } catch (error) {
    if (error instanceof WireError) return error;
    throw error;
  }
}

// -- the agent ----------------------------------------------------------------

// A message was not sent, or a request ended without an answer: `kind` is
// Timeout, Offline, Limit or the command of an error.
export class Refused extends Error {
  constructor(kind, sentence = kind) {
    super(sentence);
    this.name = "Refused";
    this.kind = kind;
  }
}

// A remote agent.
//
// name      as the application's settings declare it
// address   "lines://host:port" or "zmq://host:port"
// options   roles   roles that it fills, for the platform's information
//           token   its secret, for lines off loopback
//           tls     options of node's tls.connect, for lines under TLS
//           keys    [own public, own secret, platform's public], for CURVE
//           log     told what goes wrong, as a sentence; absent: console.error
export class Agent {
  static RETRY_AFTER = 500;
  static CONNECT_WITHIN = 5000;
  static WELCOME_WITHIN = 3000;
  static STOP_WITHIN = 2000;
  static TICK = 50;
  static MAX_FIRES = 1000; // that wait for the outbox

  #open; // makes a connection that tells these events
  #options;
  #handlers = new Map();
  #link = new Link(newIncarnation());
  #connection;
  #openedAt;
  #triedAt = -Infinity;
  #welcomed = false;
  #onlineAt = now(); // or when it began
  #malformed = 0; // in a row
  #fires = []; // what waits for the outbox
  #requests = new Map();
  // Not from 1: an answer to an earlier process must not answer this one.
  #firstCorrelation = randomInt(2 ** 47);
  #lastCorrelation = this.#firstCorrelation;
  #timer;
  #stopBy;
  #logged = new Map(); // the last sentence of each kind, and when
  #online = settled();
  #ended = settled();

  constructor(name, address, options = {}) {
    const [, transport, bracketed, plain, port] =
      /^(lines|zmq):\/\/(?:\[(.+)\]|([^:]+)):(\d+)$/.exec(address) ?? [];
    if (!transport)
      throw new TypeError("an address is lines://host:port or " +
                          `zmq://host:port, not ${address}`);
    const Transport = transport === "lines" ? Lines : Frames;
    this.name = name;
    this.#options = { roles: [], token: "", log: console.error, ...options };
    this.#open = (events) => new Transport(
      bracketed ?? plain, Number(port), this.#options, events);
  }

  // -- what an agent does -----------------------------------------------------

  // The function is called with each message of this command; "*" for those
  // that have no function of their own. It may return a promise.
  on(command, handler) {
    this.#handlers.set(command, handler);
    return this;
  }

  // An event. The promise is kept once the event is in the outbox, so that it
  // cannot be lost; waits while too much is unacknowledged. Refused("Limit")
  // where too many wait already.
  async fire(command, values = [], { session = "", correlation } = {}) {
    await this.#send({ component: this.name, command, session, correlation },
                     values);
  }

  // An event that answers a message: of its session and correlation.
  answer(message, command, values = []) {
    const { session, correlation } = message;
    return this.fire(command, values, { session, correlation });
  }

  // Asks another component. Gives its answer, a Message, or throws Refused.
  // `timeout` in milliseconds.
  async request(sink, command, values = [],
                { session = "", timeout = 5000 } = {}) {
    const correlation = ++this.#lastCorrelation;
    const ending = settled();
    this.#requests.set(correlation, ending);
    const timer = setTimeout(
      () => ending.reject(new Refused("Timeout")), timeout);
    this.#send(
      { component: this.name, command, session, sinks: [sink], correlation,
        deadline: Math.trunc(timeout) }, values, correlation,
    ).catch(ending.reject);
    try {
      return await ending.promise;
    } finally {
      clearTimeout(timer);
      this.#requests.delete(correlation);
      this.#fires = this.#fires.filter((fire) => fire.request !== correlation);
    }
  }

  // Connects, and again whenever the connection breaks.
  start() {
    this.#timer ??= setInterval(() => this.#tick(), Agent.TICK);
    this.#tick();
    return this;
  }

  // Says goodbye once all is acknowledged, after two seconds at most.
  async stop() {
    if (!this.#timer) this.#end();
    this.#stopBy ??= now() + Agent.STOP_WITHIN;
    await this.#ended.promise;
  }

  // Kept when the agent has ended: by stop(), or by a Refused where the
  // platform will not have it.
  get ended() {
    return this.#ended.promise;
  }

  get isOnline() {
    return this.#welcomed;
  }

  // Kept as soon as the platform has welcomed the agent for the first time.
  get online() {
    return this.#online.promise;
  }

  // -- its connection ---------------------------------------------------------

  #tick() {
    // Who returns soon still gets the answers.
    if (!this.#welcomed && now() - this.#onlineAt >= Link.OFFLINE_AFTER)
      this.#endRequests();
    if (this.#isOver()) this.#end();
    else if (this.#connection) this.#checkAlive();
    else if (now() - this.#triedAt >= Agent.RETRY_AFTER) this.#connect();
  }

  #isOver() {
    return this.#stopBy !== undefined &&
      (now() >= this.#stopBy ||
       !this.#link.waiting && !this.#fires.length);
  }

  #connect() {
    this.#triedAt = now();
    this.#openedAt = undefined;
    const current = (action) => (...told) => {
      if (this.#connection === connection) action(...told);
    };
    const connection = this.#open({
      opened: current(() => this.#hello()),
      heard: current(() => this.#link.heard(now())),
      arrived: current((message) => this.#arrived(message)),
      lost: current((reason) => this.#lost(reason)),
    });
    this.#connection = connection;
  }

  #hello() {
    this.#openedAt = now();
    const { roles, token } = this.#options;
    const parameters = [
      `version=${NEWEST_VERSION}`, `oldest=${OLDEST_VERSION}`,
      ...this.#link.introduction(), "json=1",
    ];
    if (roles.length) parameters.push("roles=" + roles.join(" "));
    if (token) parameters.push("token=" + token);
    this.#connection.write(new Message(
      { kind: "hello", component: this.name, command: "Hello", parameters }));
  }

  #checkAlive() {
    if (this.#openedAt === undefined) {
      if (now() - this.#triedAt >= Agent.CONNECT_WITHIN)
        this.#lost("the platform cannot be reached");
    } else if (!this.#link.alive(now()) || !this.#welcomed &&
               now() - this.#openedAt >= Agent.WELCOME_WITHIN)
      this.#lost("the platform is silent");
    else this.#flush();
  }

  #lost(reason) {
    this.#log("lost", `${this.name} is not connected: ${reason}`);
    this.#disconnect();
  }

  #disconnect() {
    this.#connection?.close();
    this.#connection = undefined;
    if (this.#welcomed) this.#onlineAt = now();
    this.#welcomed = false;
    this.#malformed = 0;
    this.#link.disconnect();
  }

  #endRequests() {
    for (const request of this.#requests.values())
      request.reject(new Refused("Offline"));
  }

  #end(reason) {
    clearInterval(this.#timer);
    this.#timer = undefined;
    if (this.#welcomed)
      for (const message of this.#link.farewell())
        this.#connection.write(message);
    this.#disconnect();
    this.#endRequests();
    this.#stopBy = -Infinity;
    for (const fire of this.#fires.splice(0))
      fire.reject(new Refused("Offline", "the agent was stopped"));
    this.#ended.resolve(reason);
  }

  // -- what leaves ------------------------------------------------------------

  async #send(said, values, request = undefined) {
    const message = messageWith(said, values);
    if (this.#stopBy === -Infinity)
      throw new Refused("Offline", "the agent was stopped");
    const sent = settled();
    if (!this.#fires.length && this.#link.send(message)) sent.resolve();
    else if (this.#fires.length >= Agent.MAX_FIRES)
      sent.reject(new Refused("Limit", "too much is unacknowledged"));
    else this.#fires.push({ message, request, ...sent });
    this.#flush();
    await sent.promise;
  }

  #flush() {
    while (this.#fires.length && this.#link.send(this.#fires[0].message))
      this.#fires.shift().resolve();
    if (!this.#connection || this.#connection.isCongested) return;
    for (const message of this.#link.output(now()))
      this.#connection.write(message);
  }

  // -- what arrives -----------------------------------------------------------

  #arrived(message) {
    try {
      if (message instanceof WireError) throw message;
      this.#take(message);
      this.#malformed = 0;
    } catch (error) {
      if (!(error instanceof WireError)) throw error;
      this.#tell(error);
    }
  }

  // PROTOCOL 5. Nobody is told before the welcome.
  #tell(error) {
    this.#log(error.kind, `${this.name} cannot take a message: ` +
                          error.message);
    if (this.#welcomed) this.#writeError(error.kind, error.message);
    if (error.closes || ++this.#malformed >= MAX_MALFORMED)
      this.#lost(error.message);
  }

  #writeError(kind, sentence) {
    this.#connection.write(new Message(
      { kind: "error", component: this.name, command: kind,
        parameters: [sentence] }));
  }

  #take(message) {
    if (message.kind === "welcome") this.#welcome(message);
    else if (message.kind === "bye") this.#lost("the platform said goodbye");
    else if (message.kind === "error") this.#takeError(message);
    else if (this.#welcomed) this.#receive(message);
  }

  // PROTOCOL 3.2: to connect again would help nobody.
  #checkVersion(welcome) {
    const said = welcome.parameters.find((one) => one.startsWith("version="));
    const version = numberOf(said?.slice("version=".length) ?? "1", "version");
    if (version >= OLDEST_VERSION && version <= NEWEST_VERSION) return true;
    const sentence = `the agent speaks versions ${OLDEST_VERSION} to ` +
      `${NEWEST_VERSION}, and the platform welcomes it in version ${version}`;
    this.#writeError("version", sentence);
    this.#end(new Refused("version", sentence));
    return false;
  }

  #welcome(message) {
    if (!this.#checkVersion(message)) return;
    if (!this.#link.connect(message.parameters, now())) {
      this.#lost("the platform knows of messages that were never sent");
      return;
    }
    this.#welcomed = true;
    this.#online.resolve();
    this.#flush();
  }

  #receive(message) {
    const connection = this.#connection;
    if (this.#link.receive(message, now())) {
      this.#handOn(message);
      if (message.number !== undefined) this.#link.handedOn();
    }
    if (this.#connection === connection) this.#flush();
  }

  #takeError(message) {
    const sentence = message.parameters.join(" ");
    const request = this.#requests.get(message.correlation);
    if (request) {
      request.reject(new Refused(message.command, sentence));
      return;
    }
    this.#log(message.command,
              `the platform refuses ${this.name}: ${message.command}: ` +
              sentence);
    if (["identity", "version", "replaced"].includes(message.command))
      this.#end(new Refused(message.command, sentence)); // would not help
    else if (CLOSING.has(message.command) || message.command === "unknown")
      this.#lost(sentence);
  }

  #handOn(message) {
    if (this.#isAnswer(message)) {
      const request = this.#requests.get(message.correlation);
      // So the platform says that nobody answers (PROTOCOL 4.7).
      if (message.component === "Parlour" && message.command === "Failed")
        request?.reject(
          new Refused("refused", message.parameters.join(" ")));
      else request?.resolve(message);
      return;
    }
    const handler =
      this.#handlers.get(message.command) ?? this.#handlers.get("*");
    if (handler) this.#call(handler, message);
  }

  // Also a late one, which nobody waits for any more.
  #isAnswer({ sinks, correlation }) {
    return !sinks.length && correlation > this.#firstCorrelation &&
      correlation <= this.#lastCorrelation;
  }

  // A handler's mistake ends one message.
  async #call(handler, message) {
    try {
      await handler(message);
    } catch (error) {
      const sentence = `${error?.name}: ${error?.message}`;
      this.#log("Failed", `${message.command}: ${sentence}`);
      await this.answer(message, "Failed", [sentence]).catch(() => {});
    }
  }

  // Of each kind once a second at most, the same once a minute.
  #log(kind, sentence) {
    const { said, at } = this.#logged.get(kind) ?? { at: -Infinity };
    if (now() - at < (said === sentence ? 60_000 : 1000)) return;
    this.#logged.set(kind, { said: sentence, at: now() });
    this.#options.log(sentence);
  }
}

function messageWith(said, values) {
  if (!Array.isArray(values))
    throw new TypeError("the values of a message are a list");
  const message = new Message(said);
  values.forEach((value, at) => {
    if (!(value instanceof Payload)) {
      message.parameters.push(parameterOf(value));
      return;
    }
    if (message.payload)
      throw new TypeError("a message has at most one payload");
    message.kind = "binary";
    message.payload = new Payload(
      value.format, Buffer.from(value.bytes),
      at + 1 < values.length ? at : undefined);
  });
  checkWritable(message);
  return message;
}

function newIncarnation() {
  return randomBytes(8).toString("hex");
}

// Heartbeats must not jump with the wall clock.
function now() {
  return performance.now();
}

// A promise with its ends. Nobody has to wait for it.
function settled() {
  const ends = {};
  ends.promise = new Promise((resolve, reject) => {
    ends.resolve = resolve;
    ends.reject = reject;
  });
  return ends;
}
