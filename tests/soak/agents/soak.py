#!/usr/bin/env python3
"""Proves that remote agents lose nothing and get nothing twice (docs/agents.md,
"What is promised"): numbered messages each way between a platform and an agent,
while a proxy between them cuts, freezes and resets their connections, or while
the agent is killed again and again and goes on from its store.

    tests/soak/agents/soak.py [--programs build/release/bin] [--agent python]
        [--transport lines] [--messages 1000000] [--cuts 200] [--seed 1]

Exit status 1: something was lost, repeated or altered, or there were too few
cuts. The last line has all figures."""

import argparse
import json
import pathlib
import queue
import random
import subprocess
import sys
import tempfile
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
# What a number and its acknowledgement take on their way, about.
BYTES_EACH = 110
# Those mishaps of the proxy that end a connection.
CUTS = ("reset", "close", "half-open", "refused")
WELL = {"missing": 0, "duplicates": 0, "altered": 0}


def start(*command, **options):
    return subprocess.Popen([str(word) for word in command], text=True,
                            stdout=subprocess.PIPE, **options)


def python_with(module):
    """An interpreter that has this module."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", f"import {module}"],
                          capture_output=True, check=False).returncode == 0:
            return python
    return None


class Soak:
    def __init__(self, options):
        self.options = options
        self.kills = 0
        self.chance = random.Random(options.seed)
        self.figures = vars(options).copy()
        self.figures["programs"] = str(options.programs)

    def run(self):
        """The figures, with the reasons why they are not well."""
        with tempfile.TemporaryDirectory() as folder, \
                tempfile.TemporaryFile("w+") as self.said:
            self.store = pathlib.Path(folder) / "store"
            self.platform = start(
                self.options.programs / "soak_platform",
                self.options.messages, self.options.transport,
                max(self.options.messages // (2 * self.options.cuts), 1))
            port = self.platform.stdout.readline().strip().rpartition(":")[2]
            # Who still runs then is told: the figures of the platform are
            # missing.
            watch = threading.Timer(self.options.patience, self.platform.kill)
            watch.start()
            try:
                if self.options.agent == "stored":
                    self.kill_again_and_again(port)
                else:
                    self.cut_again_and_again(port)
            finally:
                watch.cancel()
                self.platform.kill()
                self.platform.wait()
            self.said.seek(0)
            self.figures["wrong"] = list(self.complaints())
        return self.figures

    def cut_again_and_again(self, port):
        mean = self.options.messages * 2 * BYTES_EACH / (2 * self.options.cuts)
        proxy = start(sys.executable, HERE / "proxy.py", port, mean,
                      self.options.seed, stdin=subprocess.PIPE)
        agent = self.agent(proxy.stdout.readline().strip())
        try:
            for _ in self.progress():
                pass
            if "platform" in self.figures:
                self.figures["agent_side"] = json.loads(agent.communicate()[0])
            self.figures["proxy"] = json.loads(proxy.communicate("")[0])
        finally:
            for process in (agent, proxy):
                process.kill()
                process.wait()

    def progress(self):
        """A line each time that the platform has received some more, until it
        has ended. What it has said while nobody listened is skipped."""
        lines = queue.SimpleQueue()
        threading.Thread(target=self.read, args=[lines], daemon=True).start()
        while line := lines.get():
            yield line
            while not lines.empty():
                if lines.get() is None:
                    return

    def read(self, lines):
        with self.platform.stdout as said:
            for line in said:
                if line.startswith("{"):
                    self.figures["platform"] = json.loads(line)
                else:
                    lines.put(line)
        lines.put(None)

    def agent(self, port, *store):
        options = self.options
        if options.agent == "cpp":
            return start(options.programs / "soak_agent", port,
                         options.messages, stderr=self.said)
        scheme = "zmq" if options.transport == "zeromq" else "lines"
        python = python_with("zmq") if scheme == "zmq" else sys.executable
        program = ["node", HERE / "agent.mjs"] if options.agent == "node" \
            else [python, "-B", HERE / "agent.py"]
        return start(*program, f"{scheme}://127.0.0.1:{port}", options.messages,
                     options.pause, *store, stderr=self.said)

    def kill_again_and_again(self, port):
        """Each process of the agent goes on where the former was killed."""
        agent = self.agent(port, self.store)
        try:
            for _ in self.progress():
                if agent.poll() is not None:
                    raise RuntimeError("the agent has ended by itself")
                time.sleep(self.chance.uniform(0, 0.01))
                agent.kill()
                agent.wait()
                self.kills += 1
                agent = self.agent(port, self.store)
        finally:
            agent.kill()
            agent.wait()
        self.figures["kills"] = self.kills

    def complaints(self):
        for side in ("platform", "agent_side"):
            for name, wanted in WELL.items():
                if self.figures.get(side, WELL)[name] != wanted:
                    yield f"{side}: {name}"
        if "platform" not in self.figures:
            yield f"not done after {self.options.patience} s"
            yield from self.said.read().splitlines()[-20:]
            return
        if self.figures["platform"]["out_of_order"]:
            yield "platform: out of order"
        # What was refused to its author is sent again later.
        if not self.figures["platform"]["refused"] and \
                self.figures.get("agent_side", {}).get("out_of_order"):
            yield "agent: out of order"
        cuts = self.kills + sum(self.figures.get("proxy", {}).get(kind, 0)
                                for kind in CUTS)
        self.figures["cut"] = cuts
        if cuts < self.options.at_least:
            yield f"only {cuts} cuts"


def options_of(arguments):
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", type=pathlib.Path,
                        default=HERE.parents[2] / "build/release/bin",
                        help="where soak_platform and soak_agent are")
    parser.add_argument("--agent", choices=("cpp", "python", "node", "stored"),
                        default="python",
                        help="stored: in Python, killed instead of cut off")
    parser.add_argument("--transport", choices=("lines", "zeromq"),
                        default="lines")
    parser.add_argument("--messages", type=int, default=1_000_000)
    parser.add_argument("--cuts", type=int, default=200,
                        help="about half of those that come by chance")
    parser.add_argument("--at-least", type=int, default=100,
                        help="fewer cuts prove nothing")
    parser.add_argument("--patience", type=float, default=3600,
                        help="seconds after which it has failed")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--pause", type=float, default=0.5,
                        help="seconds before an agent reconnects, but in C++")
    return parser.parse_args(arguments)


def main():
    figures = Soak(options_of(sys.argv[1:])).run()
    print(json.dumps(figures))
    return 1 if figures["wrong"] else 0


if __name__ == "__main__":
    sys.exit(main())
