#!/usr/bin/env node
// An example: a robot that walks, takes things and says so.
//
//     node tools/agents/node/robot.mjs [NAME [ADDRESS [SECONDS FOR EACH ORDER]]]
//
// It is called Porter, as the butler's is, and connects to
// lines://127.0.0.1:5671 unless told otherwise. It fills the role Robot: see
// `parlour plugin roles Robot`.

import { setTimeout as wait } from "node:timers/promises";
import { Agent } from "./parlour_agent.mjs";

const [name = "Porter", address = "lines://127.0.0.1:5671", seconds = "1"] =
  process.argv.slice(2);
const robot = new Agent(name, address, { roles: ["Robot"] });

// It carries out one order at a time; the next one, or Stop, ends it.
let order = null;

// Orders take time; the robot goes on listening meanwhile.
function takesTime(event) {
  return async (message) => {
    await end("another order came");
    console.log("begins:", message.command, ...message.values());
    order = message;
    await wait(Number(seconds) * 1000);
    if (order !== message) return; // it was ended
    order = null;
    await robot.answer(message, event, message.values());
  };
}

// Ends the current order without success.
async function end(reason) {
  const ended = order;
  order = null;
  if (ended) await robot.answer(ended, "Failed", [reason]);
}

robot.on("Goto", takesTime("Arrived"));
robot.on("Grasp", takesTime("Grasped"));
robot.on("Stop", () => end("stopped"));
robot.on("Release", () => console.log("lets go"));
robot.on("Say", (message) => console.log("says:", ...message.values()));

robot.start();
console.log(name, "connects to", address);
robot.online.then(() => console.log(name, "is connected"));
process.once("SIGINT", () => robot.stop());
