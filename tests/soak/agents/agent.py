#!/usr/bin/env python3
"""The agent's side of the soak test in Python:

    agent.py ADDRESS MESSAGES PAUSE [STORE]

It sends the numbers from 1 to MESSAGES, takes as many from the platform, and
prints as JSON what has become of them. With a STORE it keeps nothing in its
memory, since it is killed again and again: it sends each number back, and the
platform counts."""

import json
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools/agents/python"))

from parlour_agent import Agent, Payload  # noqa: E402

WINDOW = 500
CONFIRM_EVERY = 50


def filler(number):
    """The same as in numbers.hpp."""
    return "x" * (number % 97) + ("\",\\\r\n é " if number % 10 == 0 else "")


def filler_value(number):
    text = filler(number)
    return Payload("text/plain", text.encode()) if number % 64 == 0 else text


def filler_in(message):
    if message.payload:
        return message.payload.bytes.decode()
    return message.parameters[1]


class Counter:
    """The same as in agent.cpp."""

    def __init__(self, agent, total):
        self.agent, self.total = agent, total
        self.arrived = bytearray(total + 1)
        self.count = self.duplicates = self.altered = self.out_of_order = 0
        self.last = self.confirmed = 0
        self.next = 1
        agent.on("Number")(self.take)
        agent.on("Confirm")(self.take_confirmed)

    def take(self, message):
        number = int(message.parameters[0])
        if not 0 < number <= self.total or filler_in(message) != \
                filler(number):
            self.altered += 1
        elif self.arrived[number]:
            self.duplicates += 1
        else:
            self.arrived[number] = 1
            self.out_of_order += number != self.last + 1
            self.last = number
            self.count += 1
        if self.count % CONFIRM_EVERY == 0 or self.count == self.total:
            self.agent.fire("Confirm", str(self.count))

    def take_confirmed(self, message):
        self.confirmed = max(self.confirmed, int(message.parameters[0]))
        self.send_more()

    def send_more(self):
        while self.next <= min(self.total, self.confirmed + WINDOW):
            self.agent.fire("Number", str(self.next), filler_value(self.next))
            self.next += 1

    def figures(self):
        return {"received": self.count, "missing": self.total - self.count,
                "duplicates": self.duplicates, "altered": self.altered,
                "out_of_order": self.out_of_order}


def main():
    address, total, pause, *store = sys.argv[1:]

    class Quick(Agent):
        RETRY_AFTER = float(pause)

    agent = Quick("Robot", address, **({"store": store[0]} if store else {}))
    agent.on("Stop")(lambda message: agent.stop())
    if store:
        agent.on("Number")(lambda message: agent.fire(
            "Echo", message.parameters[0],
            filler_value(int(message.parameters[0]))))
        agent.run()
        return
    counter = Counter(agent, int(total))
    counter.send_more()
    agent.run()
    print(json.dumps(counter.figures()), flush=True)


if __name__ == "__main__":
    main()
