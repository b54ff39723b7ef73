// agent.mjs ADDRESS MESSAGES PAUSE: the agent's side of the soak test in
// Node.js, the same as agent.py.

import { Agent, Payload } from "../../../tools/agents/node/parlour_agent.mjs";

const WINDOW = 500;
const CONFIRM_EVERY = 50;
const [address, messages, pause] = process.argv.slice(2);
const total = Number(messages);
Agent.RETRY_AFTER = Number(pause) * 1000;

// The same as in numbers.hpp.
function filler(number) {
  return "x".repeat(number % 97) + (number % 10 ? "" : '",\\\r\n é ');
}

function fillerValue(number) {
  const text = filler(number);
  return number % 64 ? text : new Payload("text/plain", Buffer.from(text));
}

const arrived = new Uint8Array(total + 1);
const seen = { received: 0, duplicates: 0, altered: 0, out_of_order: 0 };
let last = 0;
let confirmed = 0;
let next = 1;

const robot = new Agent("Robot", address, { log: () => {} });

function sendMore() {
  for (; next <= Math.min(total, confirmed + WINDOW); ++next)
    robot.fire("Number", [`${next}`, fillerValue(next)]);
}

function count(number) {
  arrived[number] = 1;
  seen.out_of_order += number === last + 1 ? 0 : 1;
  last = number;
  ++seen.received;
}

robot.on("Number", ({ parameters: [digits, text], payload }) => {
  const number = Number(digits);
  if (!(number > 0 && number <= total) ||
      (payload ? payload.bytes.toString() : text) !== filler(number))
    ++seen.altered;
  else if (arrived[number]) ++seen.duplicates;
  else count(number);
  if (seen.received % CONFIRM_EVERY === 0 || seen.received === total)
    robot.fire("Confirm", [`${seen.received}`]);
});
robot.on("Confirm", ({ parameters: [digits] }) => {
  confirmed = Math.max(confirmed, Number(digits));
  sendMore();
});
robot.on("Stop", () => { robot.stop(); });

robot.start();
sendMore();
await robot.ended;
console.log(JSON.stringify({ ...seen, missing: total - seen.received }));
