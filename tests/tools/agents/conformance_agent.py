#!/usr/bin/env python3
"""conformance_agent.py ADDRESS [fires]: the agent of
adapters/agents/vectors/exchanges.json in Python."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools/agents/python"))

from parlour_agent import Agent, Refused  # noqa: E402

robot = Agent("Robot", sys.argv[1], roles=["Robot"])


def values_of(message):
    values = message.values()
    if message.payload:
        place = message.payload.position
        values.insert(len(values) if place is None else place, message.payload)
    return values


@robot.on("Echo")
def echo(message):
    robot.answer(message, "Echoed", *values_of(message))


@robot.on("Count")
def count(message):
    for number in range(1, int(message.parameters[0]) + 1):
        robot.fire("Step", str(number))


@robot.on("Ask")
def ask(message):
    sink, command, timeout = message.parameters
    try:
        answer = robot.request(sink, command, timeout=int(timeout) / 1000)
        robot.fire("Outcome", answer.command, *answer.values())
    except Refused as refused:
        robot.fire("Outcome", refused.kind.lower())


@robot.on("Stop")
def stop(message):
    robot.stop()


if "fires" in sys.argv:
    robot.fire("Started")
try:
    robot.run()
    print("ended stopped")
except Refused as refused:
    print("ended", refused.kind)
