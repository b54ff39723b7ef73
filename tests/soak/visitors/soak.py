#!/usr/bin/env python3
"""Visitors talk with `parlour serve` for hours while the application is loaded
again, each time with another script, and the processes of its components are
killed. At the end each answer must have been right and the server's memory the
same as after half of the time. Conversations that depend on the hour, or on who
came before, are left out by --conversations."""

import argparse
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

CLOCK = "2026-11-21 09:00"
# Components that no conversation asks for anything that must be answered.
KILLED = ["LogWeather", "LogTraffic"]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def in_processes(application, folder):
    """A copy of the application, with some components in processes of their
    own."""
    copy = pathlib.Path(folder) / pathlib.Path(application).name
    shutil.copytree(application, copy)
    settings = copy / "settings.xml"
    text = settings.read_text()
    for name in KILLED:
        text, times = re.subn(f'<component name="{name}"',
                              rf'\g<0> host="process"', text)
        if times != 1:
            raise RuntimeError(f"{settings} has no component {name}")
    settings.write_text(text)
    return copy


def with_function(script, name):
    """A script that differs from another one by a function which nobody calls."""
    end = script.rindex("</dialogue>")
    return (f'{script[:end]}  <function name="{name}">\n    <return expr="1"/>\n'
            f'  </function>\n{script[end:]}')


def children_of(process):
    found = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
            if int(fields[1]) == process:
                words = (stat.parent / "cmdline").read_bytes().split(b"\0")
                found[words[2].decode()] = int(stat.parent.name)
        except (OSError, IndexError):
            continue
    return found


def kibibytes(process):
    status = pathlib.Path(f"/proc/{process}/status").read_text()
    return int(re.search(r"VmRSS:\s+(\d+)", status)[1])


class Soak:

    def __init__(self, options, folder):
        self.options = options
        self.application = in_processes(options.application, folder)
        self.script = self.application / f"{self.application.name}.xml"
        self.text = self.script.read_text()
        journal = pathlib.Path(folder) / "journal"
        self.journal = ["--journal", str(journal)] if options.journal else []
        self.port = free_port()
        self.log = pathlib.Path(folder) / "log"
        # Where the server is found: no other run of this application is.
        self.environment = {**os.environ, "XDG_RUNTIME_DIR": str(folder)}
        self.reloads = self.kills = 0
        self.memory = []  # seconds, KiB
        self.failures = []
        self.over = threading.Event()

    def serve(self):
        self.server = subprocess.Popen(
            [self.options.program, "serve", str(self.application), "--rehearsed",
             "--clock", CLOCK, "--sessions", "20000", "--seed", "1", "--port",
             str(self.port), *self.journal],
            stdout=subprocess.PIPE, stderr=self.log.open("wb"),
            env=self.environment)
        if b"is served at" not in self.server.stdout.readline():
            raise RuntimeError("the server does not start:\n" +
                               self.log.read_text())

    def visit(self):
        return subprocess.Popen(
            [self.options.program, "load", str(self.application), "--to",
             f"127.0.0.1:{self.port}", "--clock", CLOCK, "--visitors", "2000",
             "--rate", str(self.options.rate), "--duration",
             f"{self.options.seconds:.0f}s", "--conversations",
             ",".join(self.options.conversations)], stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True)

    def every(self, seconds, action):
        def run():
            while not self.over.wait(seconds):
                try:
                    action()
                except Exception as error:  # told at the end
                    self.failures.append(f"{action.__name__}: {error}")
        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        return thread

    def load_again(self):
        self.script.write_text(
            with_function(self.text, f"unused_{self.reloads % 2}"))
        done = subprocess.run(
            [self.options.program, "reload", str(self.application)],
            capture_output=True, text=True, timeout=60, check=False,
            env=self.environment)
        if done.returncode != 0:
            raise RuntimeError(done.stdout + done.stderr)
        self.reloads += 1

    def kill(self):
        processes = children_of(self.server.pid)
        name = KILLED[self.kills % len(KILLED)]
        if name in processes:
            os.kill(processes[name], signal.SIGKILL)
            self.kills += 1

    def measure(self):
        self.memory.append((time.monotonic() - self.begin,
                            kibibytes(self.server.pid)))

    def run(self):
        self.serve()
        self.begin = time.monotonic()
        visitors = self.visit()
        self.measure()
        threads = [self.every(self.options.reload_every, self.load_again),
                   self.every(self.options.kill_every, self.kill),
                   self.every(self.options.seconds / 120, self.measure)]
        told, _ = visitors.communicate()
        self.over.set()
        for thread in threads:
            thread.join()
        self.server.send_signal(signal.SIGTERM)
        self.failures += judge(told, self.memory, self.options.seconds)
        if self.server.wait(60) != 0:
            self.failures.append("the server ended with an error")
        return told


def at(memory, seconds):
    return min(memory, key=lambda one: abs(one[0] - seconds))[1]


def judge(told, memory, seconds):
    """What is wrong with what `parlour load` has told, and with the memory."""
    failures = []
    if not re.search(r"^0 wrong answers, 0 errors$", told, re.M):
        failures.append("visitors: " + told)
    early, late = at(memory, seconds / 2), at(memory, seconds)
    # The database is in memory and keeps each visitor.
    if late > early * 1.1:
        failures.append(f"memory: {early} KiB, later {late} KiB")
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("application")
    parser.add_argument("--conversations", nargs="+", default=["table-1"])
    parser.add_argument("--seconds", type=float, default=3600)
    parser.add_argument("--rate", type=float, default=50,
                        help="conversations that begin in a second")
    parser.add_argument("--journal", action="store_true",
                        help="the server keeps one, in a temporary folder")
    parser.add_argument("--reload-every", type=float, default=60)
    parser.add_argument("--kill-every", type=float, default=20)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        soak = Soak(options, folder)
        told = soak.run()
        print(told)
        for second, size in soak.memory[::12]:
            print(f"{second:8.0f} s {size:10} KiB")
        print(f"{soak.reloads} reloads, {soak.kills} processes killed, "
              f"{soak.log.read_text().count(chr(10))} lines in the log")
        for failure in soak.failures:
            print("FAILED", failure)
    return 1 if soak.failures else 0


if __name__ == "__main__":
    sys.exit(main())
