#!/usr/bin/env python3
"""Kills `parlour serve --journal FOLDER --strict` at random instants while
visitors book tables, and starts it again. At the end each visitor must have
heard exactly what he would have heard without, each booking must stand in the
database once, and the journal must lead to the same words again."""

import argparse
import asyncio
import contextlib
import json
import os
import pathlib
import random
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time

APP = pathlib.Path(__file__).parent / "desk"
PATIENCE = 60  # seconds, for one answer


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Server:
    """The platform, killed and started again by kill()."""

    def __init__(self, program, folder, strict):
        self.folder = pathlib.Path(folder)
        self.port = free_port()
        self.command = [
            program, "serve", str(APP), "--port", str(self.port), "--data",
            str(self.folder / "data"), "--journal", str(self.folder / "kept"),
            "--sessions", "100000", "--linger", "10m",
            *(["--strict"] if strict else [])]
        self.log = open(self.folder / "log", "wb")
        self.starts = []  # seconds until it served again
        self.process = None

    def start(self):
        begin = time.monotonic()
        self.process = subprocess.Popen(self.command, stdout=subprocess.PIPE,
                                        stderr=self.log)
        line = self.process.stdout.readline()
        if b"is served at" not in line:
            self.process.wait()
            raise RuntimeError("the server does not start:\n" +
                               (self.folder / "log").read_text())
        self.starts.append(time.monotonic() - begin)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()
        self.process.stdout.close()

    def stop(self):
        self.process.send_signal(signal.SIGTERM)
        code = self.process.wait(timeout=120)
        self.process.stdout.close()
        return code

    def close(self):
        if self.process and self.process.poll() is None:
            self.kill()
        self.log.close()


class Visitor:
    """Books so many tables, over as many connections as it takes."""

    def __init__(self, number, bookings, port, pause):
        self.name = f"v{number}"
        self.port = port
        self.pause = pause
        self.turns, self.expected = [], []
        for i in range(bookings):
            guest, people = f"{self.name}-{i}", str(1 + (number + i) % 9)
            self.turns += [f"book {guest}", people]
            self.expected += [[f"For how many, {guest}?"],
                              [f"Booked {guest} for {people}."]]
        self.heard = [[] for _ in self.turns]
        self.session, self.done, self.output = "", 0, 0
        self.connections = 0
        self.faults = []
        self.finished = False

    def guests(self):
        return [turn[5:] for turn in self.turns[::2]]

    async def visit(self):
        while not self.finished:
            try:
                reader, writer = await asyncio.open_connection("127.0.0.1",
                                                               self.port)
            except OSError:
                await asyncio.sleep(0.05)
                continue
            self.connections += 1
            with contextlib.suppress(OSError, asyncio.IncompleteReadError):
                await self.talk(reader, writer)
            writer.close()
            with contextlib.suppress(OSError):
                await writer.wait_closed()

    async def talk(self, reader, writer):
        async def send(message):
            writer.write(json.dumps(message).encode() + b"\n")
            await writer.drain()

        async def read():
            line = await asyncio.wait_for(reader.readline(), PATIENCE)
            if not line:
                raise OSError("the connection is gone")
            if not line.startswith(b"{"):
                raise OSError("said hello so late that it is a person")
            return json.loads(line)

        hello = {"type": "hello", "version": 1}
        if self.session:
            hello |= {"session": self.session, "turn": self.done,
                      "output": self.output}
        await send(hello)
        welcome = await read()
        if welcome["type"] != "welcome":
            self.faults.append(f"not welcome: {welcome}")
            self.finished = True
            return
        if self.session and welcome["lost"]:
            self.faults.append(f"something is lost: {welcome}")
        self.session = welcome["session"]
        taken = welcome["turn"]
        if taken < self.done:
            self.faults.append(f"turn {self.done} was done, now {taken}")
        while self.output == 0:  # it is greeted first
            self.take(await read())
        while self.done < len(self.turns):
            number = self.done + 1
            if number > taken:
                if self.pause:
                    await asyncio.sleep(random.random() * self.pause)
                await send({"type": "turn", "turn": number,
                            "say": self.turns[number - 1]})
                taken = number
            while self.done < number:
                self.take(await read())
        self.finished = True
        await send({"type": "end"})
        while (await read())["type"] != "end":
            pass

    def take(self, message):
        if message["type"] == "done":
            self.done = max(self.done, message["turn"])
        elif message["type"] == "say":
            if message["output"] <= self.output:
                return  # repeated
            self.output = message["output"]
            if message["turn"] > 0:
                self.heard[message["turn"] - 1].append(message["text"])
        else:
            self.faults.append(f"told {message}")
            if message["type"] == "end":
                self.finished = True
                raise OSError("the session is over")

    def judge(self):
        if self.heard != self.expected:
            wrong = next(i for i, (a, b) in
                         enumerate(zip(self.heard, self.expected)) if a != b)
            self.faults.append(f"turn {wrong + 1}: heard {self.heard[wrong]}, "
                               f"not {self.expected[wrong]}")
        return [f"{self.name}: {fault}" for fault in self.faults]


async def hold(options, server, visitors):
    async def kill_again_and_again():
        kills = 0
        while kills < options.kills and not all(v.finished for v in visitors):
            await asyncio.sleep(random.uniform(*options.between))
            await asyncio.to_thread(server.kill)
            await asyncio.to_thread(server.start)
            kills += 1
            if sys.stderr.isatty():
                done = sum(v.done for v in visitors)
                print(f"\r{kills} kills, {done} turns", end="",
                      file=sys.stderr)
        return kills

    talking = [asyncio.create_task(visitor.visit()) for visitor in visitors]
    kills = await kill_again_and_again()
    await asyncio.wait_for(asyncio.gather(*talking), options.patience)
    return kills


def bookings_in(folder):
    with contextlib.closing(sqlite3.connect(folder / "data/desk.db")) as base:
        return [row[0] for row in base.execute("select guest from booking")]


def judge(options, server, visitors):
    faults = [fault for visitor in visitors for fault in visitor.judge()]
    wanted = sorted(guest for v in visitors for guest in v.guests())
    found = sorted(bookings_in(server.folder))
    if found != wanted:
        twice = len(found) - len(set(found))
        missing = len(set(wanted) - set(found))
        faults.append(f"the database has {len(found)} of {len(wanted)} "
                      f"bookings: {twice} twice, {missing} missing")
    if options.replay:
        again = subprocess.run(
            [options.program, "replay", str(APP), str(server.folder / "kept")],
            capture_output=True, text=True, check=False)
        if again.returncode != 0:
            faults.append("the replay differs: " + again.stdout[-300:] +
                          again.stderr[-300:])
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="the program parlour")
    parser.add_argument("--visitors", type=int, default=500)
    parser.add_argument("--bookings", type=int, default=20, help="of each")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--between", type=float, nargs=2, default=(0.05, 1.0),
                        metavar=("FROM", "TO"), help="seconds between kills")
    parser.add_argument("--pause", type=float, default=0.0,
                        help="at most so many seconds before a turn")
    parser.add_argument("--seed", type=int, default=None)
    parser.add_argument("--patience", type=float, default=600,
                        help="seconds after the last kill")
    parser.add_argument("--relaxed", action="store_true",
                        help="without --strict: answers may be lost")
    parser.add_argument("--replay", action="store_true",
                        help="repeat all conversations at the end")
    parser.add_argument("--folder", help="kept afterwards; else a temporary one")
    options = parser.parse_args()
    random.seed(options.seed)
    folder = options.folder or tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    server = Server(options.program, folder, not options.relaxed)
    try:
        server.start()
        visitors = [Visitor(i, options.bookings, server.port, options.pause)
                    for i in range(options.visitors)]
        begin = time.monotonic()
        kills = asyncio.run(hold(options, server, visitors))
        seconds = time.monotonic() - begin
        code = server.stop()
        faults = judge(options, server, visitors)
        if code != 0:
            faults.append(f"the server ended with {code}")
    finally:
        server.close()
        if not options.folder:
            shutil.rmtree(folder, ignore_errors=True)
    turns = sum(len(v.turns) for v in visitors)
    print(f"{len(visitors)} visitors, {turns} turns, {kills} kills in "
          f"{seconds:.0f} s; served again after at most "
          f"{max(server.starts):.2f} s; {len(faults)} faults")
    for fault in faults[:20]:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
