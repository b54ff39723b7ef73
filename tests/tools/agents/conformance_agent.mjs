// conformance_agent.mjs ADDRESS [fires]: the agent of
// adapters/agents/vectors/exchanges.json in Node.js.

import { Agent } from "../../../tools/agents/node/parlour_agent.mjs";

const robot = new Agent("Robot", process.argv[2],
                        { roles: ["Robot"], log: () => {} });

function valuesOf(message) {
  const values = message.values();
  if (message.payload)
    values.splice(message.payload.position ?? values.length, 0,
                  message.payload);
  return values;
}

robot.on("Echo",
         (message) => robot.answer(message, "Echoed", valuesOf(message)));
robot.on("Count", async (message) => {
  for (let number = 1; number <= Number(message.parameters[0]); ++number)
    await robot.fire("Step", [`${number}`]);
});
robot.on("Ask", async (message) => {
  const [sink, command, timeout] = message.parameters;
  try {
    const answer =
      await robot.request(sink, command, [], { timeout: Number(timeout) });
    await robot.fire("Outcome", [answer.command, ...answer.values()]);
  } catch (refused) {
    await robot.fire("Outcome", [refused.kind.toLowerCase()]);
  }
});
robot.on("Stop", () => { robot.stop(); });

if (process.argv.includes("fires")) robot.fire("Started");
robot.start();
console.log("ended", (await robot.ended)?.kind ?? "stopped");
