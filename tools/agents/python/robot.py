#!/usr/bin/env python3
"""An example: a robot that walks, takes things and says so.

    tools/agents/python/robot.py [NAME [ADDRESS [SECONDS FOR EACH ORDER]]]

It is called Porter, as the butler's is, and connects to lines://127.0.0.1:5671
unless told otherwise. It fills the role Robot: see `parlour plugin roles Robot`.
"""

import sys
import threading

from parlour_agent import Agent


class Robot:
    """Carries out one order at a time; the next one, or Stop, ends it."""

    def __init__(self, name, address, seconds):
        self.agent = Agent(name, address, roles=["Robot"])
        self.seconds = seconds
        self.order = None
        self.timer = None
        for command, event in (("Goto", "Arrived"), ("Grasp", "Grasped")):
            self.agent.on(command)(
                lambda message, event=event: self.begin(message, event))
        self.agent.on("Stop")(lambda message: self.end("stopped"))
        self.agent.on("Release")(lambda message: print("lets go", flush=True))
        self.agent.on("Say")(lambda message: print(
            "says:", *message.values(), flush=True))

    def begin(self, message, event):
        """Orders take time; the robot goes on listening meanwhile."""
        self.end("another order came")
        print("begins:", message.command, *message.values(), flush=True)
        self.order = message
        self.timer = threading.Timer(self.seconds, self.finish,
                                     [message, event])
        self.timer.start()

    def finish(self, message, event):
        """The order is done, unless it was ended in the same moment."""
        if self.order is message:
            self.order = None
            self.agent.answer(message, event, *message.values())

    def end(self, reason):
        """Ends the current order without success."""
        order, self.order = self.order, None
        if order:
            self.timer.cancel()
            self.agent.answer(order, "Failed", reason)


def main():
    given = dict(enumerate(sys.argv))
    name = given.get(1, "Porter")
    address = given.get(2, "lines://127.0.0.1:5671")
    robot = Robot(name, address, float(given.get(3, 1.0)))
    robot.agent.start()
    print(name, "connects to", address, flush=True)
    try:
        robot.agent.online.wait()
        print(name, "is connected", flush=True)
        threading.Event().wait()
    except KeyboardInterrupt:
        robot.agent.stop()


if __name__ == "__main__":
    main()
