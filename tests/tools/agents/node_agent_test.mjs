// The agent for Node.js: the examples of the protocol, its delivery over
// connections that lose what they carry, and a whole agent beside a platform
// that breaks every connection.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import net from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { setTimeout as wait } from "node:timers/promises";
import tls from "node:tls";

import {
  Agent, Link, LineReader, MAX_MESSAGE_BYTES, Message, Payload, Refused,
  WireError, framesOf, lineOf, parameterOf, readFrames, valueOf,
} from "../../../tools/agents/node/parlour_agent.mjs";

const ROOT = new URL("../../../", import.meta.url);
// JSON.parse rounds large numbers: these are read as texts first.
const VECTORS = JSON.parse(
  readFileSync(new URL("adapters/agents/vectors/messages.json", ROOT), "utf8")
    .replace(/: ([0-9]{16,})/g, ': "$1"'));

function messageIn({ payload, ...described }) {
  const message = new Message(described);
  if (typeof message.number === "string")
    message.number = BigInt(message.number);
  if (payload)
    message.payload = new Payload(
      payload.format, Buffer.from(payload.hex, "hex"), payload.position);
  return message;
}

function lineIn({ line }) {
  return Buffer.from(line.includes("\n") ? line : line + "\n");
}

// Messages, and the kinds of errors.
function readAll(reader, data) {
  reader.add(data);
  const found = [];
  for (;;) {
    try {
      const message = reader.next();
      if (message === undefined) return found;
      found.push(message);
    } catch (error) {
      if (!(error instanceof WireError)) throw error;
      found.push(error.kind);
      if (error.closes) return found;
    }
  }
}

function refuses(kind) {
  return (error) => error instanceof WireError && error.kind === kind;
}

// The same numbers for the same seed: a linear congruential generator.
function randomOf(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

// -- messages -----------------------------------------------------------------

test("writes and reads the examples", () => {
  for (const example of VECTORS.messages) {
    const message = messageIn(example.message);
    const frames = example.frames.map((frame) => Buffer.from(frame));
    assert.deepEqual(lineOf(message), lineIn(example), example.name);
    assert.deepEqual(readAll(new LineReader(), lineIn(example)), [message]);
    assert.deepEqual(framesOf(message), frames, example.name);
    assert.deepEqual(readFrames(frames), message, example.name);
  }
});

test("reads what is written otherwise", () => {
  for (const example of VECTORS.readable)
    assert.deepEqual(readAll(new LineReader(), lineIn(example)),
                     [messageIn(example.message)], example.name);
});

test("answers mistakes", () => {
  for (const example of VECTORS.errors) {
    const reader = new LineReader();
    reader.add(lineIn(example));
    assert.throws(() => reader.next(), (error) =>
      refuses(example.error)(error) &&
      (error.closes === true) ===
        (new WireError(example.error).closes || example.closes === true),
    example.name);
  }
  for (const { name, frames, error } of VECTORS.frame_errors)
    assert.throws(() => readFrames(frames.map((frame) => Buffer.from(frame))),
                  refuses(error), name);
});

test("reads byte by byte", () => {
  const data = Buffer.concat(VECTORS.messages.map(lineIn));
  const reader = new LineReader();
  const found = [];
  for (let at = 0; at < data.length; ++at)
    found.push(...readAll(reader, data.subarray(at, at + 1)));
  assert.deepEqual(found, readAll(new LineReader(), data));
});

test("goes on behind a malformed message and its payload", () => {
  const data = Buffer.from(
    "binary;n=x,,X,Y,f,5\nbeat\ntext,,X,\xff\nbeat;n=1\n", "latin1");
  assert.deepEqual(
    readAll(new LineReader(), data),
    ["malformed", "malformed", new Message({ kind: "beat", number: 1 })]);
});

test("a payload of unknown length is never read as lines", () => {
  for (const wrong of ["binary,,X,Y,f,five", 'binary,,X,Y,"f,5',
                       "binary,,X,\xff,f,5", "binary"])
    assert.deepEqual(
      readAll(new LineReader(), Buffer.from(wrong + "\nbeat\n", "latin1")),
      ["malformed"], wrong);
});

test("a message that may leave can be read, however long its line", () => {
  const message = new Message(
    { parameters: ["\n".repeat(MAX_MESSAGE_BYTES - 100)] });
  assert.deepEqual(readAll(new LineReader(), lineOf(message)), [message]);
  message.parameters = ["x".repeat(MAX_MESSAGE_BYTES)];
  assert.throws(() => lineOf(message), refuses("oversized"));
  const line = `text,,X,Y,${message.parameters[0]},x\n`;
  assert.deepEqual(readAll(new LineReader(), Buffer.from(line)),
                   ["oversized"]);
});

test("parameters keep their types", () => {
  for (const value of [null, true, 7, -2.5, "text", "\x01J1", "",
                       [1, ["two"]], { x: 1.5 }])
    assert.deepEqual(valueOf(parameterOf(value)), value);
  assert.equal(parameterOf(2n ** 62n), "\x01J4611686018427387904");
  assert.throws(() => parameterOf(NaN), TypeError);
});

// -- delivery -----------------------------------------------------------------

function text(number) {
  return new Message({ command: "Go", number });
}

test("loses nothing and repeats nothing", () => {
  for (let seed = 0; seed < 20; ++seed) deliver(randomOf(seed));
});

function deliver(chance, wanted = 200) {
  const links = [new Link("aa"), new Link("bb")];
  const received = [[], []];
  let now = 0;
  let sent = 0;
  let connected = false;
  const carry = (source, target) => {
    const cut = chance() < 0.1;
    for (const message of links[source].output(now)) {
      if (cut && chance() < 0.3) return false;
      if (chance() < 0.05) continue;
      if (links[target].receive(message, now)) {
        received[target].push(message.command);
        links[target].handedOn();
      }
    }
    return true;
  };
  while (received.some((got) => got.length < wanted)) {
    assert.ok(now < 1e9);
    now += chance() * 400;
    for (let more = chance() * 20; more > 0 && sent < wanted; --more) {
      sent += 1;
      for (const link of links)
        assert.ok(link.send(new Message({ command: `${sent}` })));
    }
    if (!connected) {
      const hellos = links.map((link) => link.introduction());
      links.forEach((link, at) => link.connect(hellos[1 - at], now));
    }
    connected = carry(0, 1) && carry(1, 0) &&
      links.every((link) => link.alive(now));
    if (!connected) links.forEach((link) => link.disconnect());
  }
  const expected = Array.from({ length: wanted }, (_, at) => `${at + 1}`);
  assert.deepEqual(received, [expected, expected]);
}

function connectedLink() {
  const link = new Link("aa");
  link.connect(["incarnation=bb"], 0);
  return link;
}

test("the window of a message replaces that of the hello", () => {
  const link = connectedLink();
  for (let number = 0; number < 10; ++number) link.send(new Message());
  link.receive(new Message({ kind: "ack", acknowledged: 0, window: 4 }), 0);
  assert.equal(link.output(0).length, 4);
});

test("a withdrawn message counts and means nothing", () => {
  const link = connectedLink();
  assert.equal(link.receive(new Message({ number: 1 }), 0), false);
  assert.equal(link.receive(new Message({ command: "Go", number: 2 }), 0),
               true);
});

test("the loss of the last message is noticed although all goes on", () => {
  const link = connectedLink();
  link.send(new Message());
  link.output(0); // lost
  const said = [];
  for (let at = 1; at <= 10; ++at) {
    assert.ok(link.receive(text(at), at * 300));
    link.handedOn();
    said.push(...link.output(at * 300 + 60));
  }
  assert.ok(said.some(({ kind, number }) => kind === "beat" && number === 1));
});

test("only what was handed on counts as seen", () => {
  const link = connectedLink();
  link.receive(text(1), 0);
  link.receive(text(2), 0);
  link.handedOn();
  assert.ok(link.introduction().includes("seen=bb:1"));
});

test("begins afresh with who has forgotten it", () => {
  for (const seen of ["seen=aa:0", "seen=cc:1", ""]) {
    const link = connectedLink();
    for (const command of ["a", "b"]) link.send(new Message({ command }));
    link.output(0);
    link.receive(text(1), 0);
    link.receive(new Message({ kind: "ack", acknowledged: 1 }), 0);
    link.connect(["incarnation=bb", seen], 0);
    assert.deepEqual(link.output(0).map((one) => [one.command, one.number]),
                     [["b", 1]]);
    assert.ok(link.receive(text(1), 0));
  }
});

test("who has received what was never sent meets another incarnation", () => {
  const link = connectedLink();
  assert.equal(link.connect(["incarnation=bb", "seen=aa:7"], 0), false);
  assert.notEqual(link.incarnation, "aa");
  assert.equal(link.connect(["incarnation=bb", "seen=aa:7"], 0), true);
});

test("a slow message is no silence", () => {
  const link = connectedLink();
  link.heard(2500);
  assert.ok(link.alive(5000));
  assert.ok(!link.alive(5500));
});

test("refuses what nobody may say", () => {
  const ack = new Message({ kind: "ack", acknowledged: 1 });
  assert.throws(() => connectedLink().receive(ack, 0), refuses("malformed"));
  assert.throws(() => connectedLink().receive(text(101), 0),
                refuses("flood"));
  assert.throws(() => connectedLink().receive(text(2n ** 62n), 0),
                refuses("flood"));
});

// -- a whole agent ------------------------------------------------------------

// Accepts agents, notes what they say, and closes each connection after so
// many messages.
class Platform {
  link = new Link("99");
  heard = [];
  raw = []; // messages of every kind
  hellos = 0;
  isMute = false; // it says nothing

  static async open(breaksAfter = Infinity, secrets = undefined) {
    const platform = new Platform();
    const serve = (socket) => platform.serve(socket, breaksAfter);
    platform.server = secrets
      ? tls.createServer(secrets, serve) : net.createServer(serve);
    await new Promise((done) => platform.server.listen(0, "127.0.0.1", done));
    platform.address = `lines://127.0.0.1:${platform.server.address().port}`;
    platform.timer = setInterval(() => platform.flush(), 50);
    after(() => platform.close());
    return platform;
  }

  close() {
    clearInterval(this.timer);
    this.server.close();
    this.socket?.destroy();
  }

  serve(socket, breaksAfter) {
    const reader = new LineReader();
    let taken = 0;
    this.socket = socket;
    socket.on("error", () => {});
    socket.on("close", () => {
      if (this.socket === socket) this.link.disconnect();
    });
    socket.on("data", (data) => {
      for (const message of readAll(reader, data)) {
        if (taken >= breaksAfter) return;
        if (this.take(message) && ++taken >= breaksAfter) socket.destroy();
      }
      this.flush();
    });
  }

  take(message) {
    this.raw.push(message);
    if (message.kind === "hello") {
      this.hellos += 1;
      this.link.connect(message.parameters, performance.now());
      this.write(new Message(
        { kind: "welcome", component: "Parlour", command: "Welcome",
          parameters: this.link.introduction() }));
      return false;
    }
    if (!this.link.receive(message, performance.now())) return false;
    if (message.sinks.length) // a request: answered
      this.link.send(new Message(
        { component: "Clock", command: "Time", parameters: ["noon"],
          correlation: message.correlation }));
    this.heard.push([message.command, ...message.values()]);
    this.link.handedOn();
    return true;
  }

  write(message) {
    if (this.socket?.writable) this.socket.write(lineOf(message));
  }

  flush() {
    if (this.isMute) return;
    for (const message of this.link.output(performance.now()))
      this.write(message);
  }
}

async function until(condition) {
  for (let turn = 0; turn < 1000 && !condition(); ++turn) await wait(20);
  assert.ok(condition());
}

function agentAt(address, options) {
  const agent = new Agent("Robot", address, { log: () => {}, ...options });
  after(() => { agent.stop(); });
  return agent;
}

test("keeps its promise over broken connections", async () => {
  const platform = await Platform.open(7);
  const robot = agentAt(platform.address).start();
  for (let number = 0; number < 50; ++number)
    await robot.fire("Step", [number]);
  await until(() => platform.heard.length >= 50);
  assert.deepEqual(platform.heard,
                   Array.from({ length: 50 }, (_, at) => ["Step", at]));
  assert.ok(platform.hellos > 5);
});

// A certificate of its own for 127.0.0.1, or undefined without openssl.
function newCertificate() {
  const folder = mkdtempSync(join(tmpdir(), "agent-"));
  after(() => rmSync(folder, { recursive: true }));
  const [cert, key] = ["cert", "key"].map((name) => join(folder, name));
  const made = spawnSync("openssl", [
    "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", key, "-out",
    cert, "-days", "2", "-subj", "/CN=localhost", "-addext",
    "subjectAltName=IP:127.0.0.1"]);
  return made.status === 0
    ? { cert: readFileSync(cert), key: readFileSync(key) } : undefined;
}

test("speaks under TLS, with whom it trusts", async (context) => {
  const secrets = newCertificate();
  if (!secrets) return context.skip("openssl is not installed");
  const platform = await Platform.open(20, secrets);
  const robot = agentAt(platform.address, { tls: { ca: secrets.cert } });
  robot.start();
  for (let number = 0; number < 50; ++number)
    await robot.fire("Step", [number, "x".repeat(20000)]);
  await until(() => platform.heard.length >= 50);
  assert.deepEqual(platform.heard.map(([, number]) => number),
                   Array.from({ length: 50 }, (_, at) => at));
  const hellos = platform.hellos;
  await robot.stop();
  const wary = agentAt(platform.address, { tls: {} }).start();
  await wait(700);
  assert.equal(wary.isOnline, false);
  assert.equal(platform.hellos, hellos);
});

test("answers commands and asks", async () => {
  const platform = await Platform.open();
  const robot = agentAt(platform.address);
  robot.on("Goto", (message) =>
    robot.answer(message, "Arrived", message.values()));
  robot.on("Fall", async () => { throw new Error("over the cable"); });
  robot.on("Ask", async (message) => { // a handler may wait for an answer
    const answer = await robot.request("Clock", "Ask");
    await robot.answer(message, "Asked", answer.values());
  });
  robot.start();
  await robot.online;
  assert.deepEqual((await robot.request("Clock", "Ask")).parameters, ["noon"]);
  for (const command of ["Goto", "Fall", "Dance", "Ask"])
    platform.link.send(new Message({ component: "Robot", command,
                                     parameters: ["lobby"] }));
  await until(() => platform.heard.length >= 5);
  assert.deepEqual(platform.heard.slice(1).sort(), [
    ["Arrived", "lobby"], ["Ask"], ["Asked", "noon"],
    ["Failed", "Error: over the cable"],
  ]);
});

test("payloads keep their place", async () => {
  const platform = await Platform.open();
  const robot = agentAt(platform.address).start();
  await robot.fire("Seen", [1, new Payload("image/png", Buffer.from("ab")), 2]);
  await until(() => platform.heard.length);
  const { kind, payload } = platform.raw.at(-1);
  assert.deepEqual([kind, payload],
                   ["binary", new Payload("image/png", Buffer.from("ab"), 1)]);
});

test("says goodbye once all is acknowledged", async () => {
  const platform = await Platform.open();
  const robot = agentAt(platform.address).start();
  await robot.fire("Step");
  await robot.stop();
  await until(() => platform.raw.at(-1)?.kind === "bye");
  assert.deepEqual(platform.heard, [["Step"]]);
  await assert.rejects(robot.fire("Step"), { kind: "Offline" });
});

test("a late answer is nobody's command", async () => {
  const platform = await Platform.open();
  const robot = agentAt(platform.address).start();
  await robot.online;
  const came = [];
  robot.on("*", (message) => came.push(message.command));
  platform.isMute = true;
  await assert.rejects(robot.request("Clock", "Ask", [], { timeout: 50 }),
                       { kind: "Timeout" });
  assert.equal(platform.heard.length, 1);
  platform.isMute = false;
  platform.link.send(new Message({ command: "Stop" }));
  await until(() => !platform.link.waiting);
  assert.deepEqual(came, ["Stop"]);
});

test("a mistake of the platform does not end the agent", async () => {
  const platform = await Platform.open();
  const robot = agentAt(platform.address).start();
  await robot.online;
  platform.write(new Message({ kind: "ack", acknowledged: 77 }));
  platform.socket.write("shout\n");
  await until(() =>
    platform.raw.filter(({ kind }) => kind === "error").length >= 2);
  platform.write(text(5000)); // a flood: the agent connects anew
  await until(() => platform.hellos === 2);
  await robot.fire("Step");
  await until(() => platform.heard.length);
});

test("does not connect anew where it was replaced", async () => {
  const platform = await Platform.open();
  const robot = agentAt(platform.address).start();
  await robot.online;
  platform.write(new Message({ kind: "error", command: "replaced" }));
  assert.equal((await robot.ended).kind, "replaced");
  await wait(700);
  assert.equal(platform.hellos, 1);
});

test("what cannot be taken is refused to its author", async () => {
  const robot = agentAt("lines://127.0.0.1:1");
  const fires = Array.from(
    { length: Link.MAX_WAITING + Agent.MAX_FIRES + 1 },
    () => robot.fire("Step").then(() => "sent", ({ kind }) => kind));
  assert.equal(await fires.at(-1), "Limit");
  assert.equal(await fires[0], "sent");
  await robot.stop();
  assert.equal(await fires.at(-2), "Offline");
  await assert.rejects(agentAt("lines://h:1").fire("Step", "lobby"),
                       TypeError);
});

test("a request ends", async () => {
  const robot = agentAt("lines://127.0.0.1:1");
  await assert.rejects(robot.request("Clock", "Ask", [], { timeout: 50 }),
                       (error) => error instanceof Refused &&
                         error.kind === "Timeout");
});

test("addresses are checked", () => {
  for (const address of ["127.0.0.1:5", "tcp://127.0.0.1:5", "lines://host"])
    assert.throws(() => new Agent("Robot", address), TypeError);
});
