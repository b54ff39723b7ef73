#!/usr/bin/env python3
"""Plays adapters/agents/vectors/exchanges.json with an agent in each language,
in a process of its own: all must behave in the same way."""

import concurrent.futures
import csv
import json
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import threading
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
EXCHANGES = json.loads((ROOT / "adapters/agents/vectors/exchanges.json")
                       .read_text("utf-8"))["exchanges"]
PROGRAMS = pathlib.Path(os.environ.get("PARLOUR_PROGRAM", "")).parent
WAIT = 20  # seconds; only a test that fails waits so long


NODE = ["node", HERE / "conformance_agent.mjs"]
PYTHON = [sys.executable, "-B", HERE / "conformance_agent.py"]
AGENTS = {"C++": [PROGRAMS / "conformance_agent"], "Python": PYTHON}
if shutil.which("node"):
    AGENTS["Node.js"] = NODE


def has_zeromq():
    try:
        import zmq  # noqa: F401
        return True
    except ImportError:
        return False


def node_has_zeromq():
    return shutil.which("node") and subprocess.run(
        ["node", "-e", "import('zeromq').catch(() => process.exit(1))"],
        cwd=ROOT / "tools/agents/node", check=False,
        capture_output=True).returncode == 0


# -- lines, read independently of the agents ----------------------------------

def fields_of(line):
    """Those of RFC 4180, with the escapes of PROTOCOL 2.1."""
    fields = next(csv.reader([line], strict=True))
    return [re.sub(r"\\(.)", lambda found: {"n": "\n", "r": "\r"}.get(
        found[1], found[1]), field) for field in fields]


class Heard:
    """A message; its attributes are pairs, in the order of their letters."""

    def __init__(self, fields, payload=None):
        head, *attributes = fields[0].split(";")
        self.kind, self.payload = head, payload
        self.attributes = sorted(one.partition("=")[::2] for one in attributes)
        self.component, self.command, *self.parameters = \
            [*fields[2:], "", ""] if len(fields) < 4 else fields[2:]

    def get(self, letter):
        return dict(self.attributes).get(letter)

    def without(self, *letters):
        return [one for one in self.attributes if one[0] not in letters]

    def __repr__(self):
        return f"{self.kind}{self.attributes} {self.component}." \
            f"{self.command}{self.parameters} {self.payload!r}"


def fits(heard, wanted):
    """A wanted * stands for any value."""
    def same(one, other):
        return len(one) == len(other) and all(
            mine == theirs or theirs == "*" for mine, theirs in zip(one, other))
    return (heard.kind, heard.command, heard.payload) == \
        (wanted.kind, wanted.command, wanted.payload) and \
        heard.component == wanted.component and \
        same([name for name, _ in heard.without("a")],
             [name for name, _ in wanted.without("a")]) and \
        same([value for _, value in heard.without("a")],
             [value for _, value in wanted.without("a")]) and \
        same(heard.parameters, wanted.parameters)


class Failure(Exception):
    """What the agent did instead."""


class ByLines:
    """The platform's end of one connection after the other."""

    def __init__(self):
        # Keeps the port while nobody listens: else another exchange might get
        # it, and then this one's agent comes there.
        self.reserved = self.bound(0)
        self.port = self.reserved.getsockname()[1]
        self.listen()
        self.connection = None
        self.held = b""

    @staticmethod
    def bound(port):
        bound = socket.socket()
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEPORT, 1)
        bound.bind(("127.0.0.1", port))
        return bound

    def listen(self):
        self.listener = self.bound(self.port)
        self.listener.listen()
        self.listener.settimeout(WAIT)

    @property
    def address(self):
        return f"lines://127.0.0.1:{self.port}"

    def accept(self):
        self.hang_up()
        self.connection, _ = self.listener.accept()
        self.connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.held = b""

    def say(self, line, payload, slowly):
        data = line.encode() + b"\n" + (payload or "").encode()
        for piece in ([data[at:at + 1] for at in range(len(data))]
                      if slowly else [data]):
            self.connection.sendall(piece)

    def hear(self, seconds=WAIT):
        """The next message; None where there is none in time."""
        until = time.monotonic() + seconds
        line = self.take(lambda: self.held.find(b"\n") + 1, until)
        if line is None:
            return None
        fields = fields_of(line[:-1].decode())
        if not fields[0].startswith("binary"):
            return Heard(fields)
        size = int(fields.pop())
        return Heard(fields, self.take(
            lambda: len(self.held) >= size and size, until, size).decode())

    def take(self, end, until, least=1):
        while least and not end():
            self.connection.settimeout(max(until - time.monotonic(), 0.001))
            try:
                data = self.connection.recv(1 << 16)
            except TimeoutError:
                return None
            if not data:
                raise ConnectionError("the agent has closed the connection")
            self.held += data
        size = end() or 0
        taken, self.held = self.held[:size], self.held[size:]
        return taken

    def cut(self):
        self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER,
                                   struct.pack("ii", 1, 0))
        self.hang_up()

    def gone(self):
        try:
            while self.hear():
                pass
        except OSError:
            return
        raise Failure("the agent did not close the connection")

    def away(self, seconds):
        self.listener.close()
        self.cut()
        time.sleep(seconds)  # it is the real time that the agent measures
        self.listen()

    def hang_up(self):
        if self.connection:
            self.connection.close()
            self.connection = None

    def nobody_comes(self):
        self.listener.settimeout(0.1)
        try:
            self.accept()
        except TimeoutError:
            return
        raise Failure("it connected again")

    def close(self):
        self.hang_up()
        self.listener.close()
        self.reserved.close()


class ByZeroMQ:
    """The same by a ROUTER. It cannot cut a connection, nor see that one is
    closed: but whoever connects again has another name."""

    def __init__(self):
        import zmq
        self.zmq = zmq
        self.router = zmq.Context.instance().socket(zmq.ROUTER)
        self.router.linger = 0
        self.address = "zmq://127.0.0.1:%d" % \
            self.router.bind_to_random_port("tcp://127.0.0.1")
        self.name = None
        self.held = []

    def accept(self, seconds=WAIT):
        former, until = self.name, time.monotonic() + seconds
        while self.router.poll(max(until - time.monotonic(), 0) * 1000):
            name, *frames = self.router.recv_multipart()
            if name != former:
                self.name, self.held = name, [frames]
                return
        raise ConnectionError("the agent does not come")

    def say(self, line, payload, _):
        fields = fields_of(line)
        if payload is not None:
            fields[-1] = payload  # instead of its length
        self.router.send_multipart(
            [self.name, b"parlour/1", *(one.encode() for one in fields)])

    def hear(self, seconds=WAIT):
        until = time.monotonic() + seconds
        while not self.held:
            if not self.router.poll(max(until - time.monotonic(), 0) * 1000):
                return None
            name, *frames = self.router.recv_multipart()
            if name == self.name:
                self.held.append(frames)
        protocol, *fields = (one.decode() for one in self.held.pop(0))
        if protocol != "parlour/1":
            raise Failure(f"its first frame is {protocol}")
        is_binary = fields[0].startswith("binary")
        payload = fields.pop() if is_binary else None
        return Heard(fields, payload)

    def gone(self):
        pass

    def nobody_comes(self):
        try:
            self.accept(0.1)
        except ConnectionError:
            return
        raise Failure("it connected again")

    def close(self):
        self.router.close()


class Play:
    """One exchange with one agent."""

    def __init__(self, exchange, command, platform=ByLines):
        self.exchange, self.command = exchange, command
        self.platform = platform()
        self.known = {"incarnation": "", "n": ""}
        self.unread = []

    def run(self):
        agent = subprocess.Popen(
            [*self.command, self.platform.address,
             *(["fires"] if self.exchange.get("fires") else [])],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.agent = agent
        try:
            for at, step in enumerate(self.exchange["steps"], 1):
                try:
                    self.take(step)
                except (Failure, OSError) as error:
                    return f"step {at}, {step}: {error}"
        finally:
            agent.kill()
            agent.wait()
            agent.stdout.close()
            self.platform.close()
        return "well"

    def take(self, step):
        verb = next(iter(step))
        getattr(self, verb)(step[verb], step)

    def filled(self, text):
        return re.sub(r"\{(\w+)\}", lambda found: self.known[found[1]], text)

    # -- what the platform does -----------------------------------------------

    def say(self, lines, step):
        for line in [lines] if isinstance(lines, str) else lines:
            self.platform.say(self.filled(line), step.get("payload"),
                              self.exchange.get("slowly"))

    def welcome(self, said, step):
        self.say("welcome,1732178400123,Parlour,Welcome,version=1,"
                 + ",".join(["incarnation=99", *said]), step)

    def cut(self, _, step):
        self.platform.cut()

    def away(self, milliseconds, step):
        self.platform.away(milliseconds / 1000)

    # -- what the agent must do -----------------------------------------------

    def hello(self, wanted, step):
        self.platform.accept()
        hello = self.platform.hear()
        if hello is None or (hello.kind, hello.component, hello.command) != \
                ("hello", "Robot", "Hello"):
            raise Failure(f"it said {hello}")
        said = dict(one.partition("=")[::2] for one in hello.parameters)
        for one in wanted:
            key, _, value = self.filled(one).partition("=")
            if key.startswith("-") and key[1:] in said or \
                    not key.startswith("-") and \
                    (key not in said or value not in ("*", said[key])):
                raise Failure(f"it said {hello}")
        if not re.fullmatch("[0-9a-f]{16}", said["incarnation"]) or \
                step.get("renewed") and \
                said["incarnation"] == self.known["incarnation"]:
            raise Failure(f"it said {hello}")
        self.known["incarnation"] = said["incarnation"]

    def hear(self, wanted, step):
        for line in [wanted] if isinstance(wanted, str) else wanted:
            wish = Heard(fields_of(self.filled(line)), step.get("payload"))
            heard = self.next_message()
            if not heard or not fits(heard, wish):
                raise Failure(f"instead of {line} it said {heard}")
            self.known["n"] = heard.get("c") or self.known["n"]

    def next_message(self, seconds=WAIT):
        until = time.monotonic() + seconds
        while heard := self.platform.hear(max(until - time.monotonic(), 0)):
            if heard.get("a"):
                self.known["a"] = heard.get("a")
            if heard.kind not in ("ack", "beat"):
                return heard
        return None

    def hear_own(self, wanted, step):
        wish = Heard(fields_of(wanted))
        until = time.monotonic() + WAIT
        while heard := self.platform.hear(max(until - time.monotonic(), 0)):
            if heard.kind == wish.kind and \
                    set(wish.attributes) <= set(heard.attributes):
                return
            if heard.kind not in ("ack", "beat"):
                raise Failure(f"instead of {wanted} it said {heard}")
        raise Failure("it said nothing")

    def acknowledges(self, number, step):
        until = time.monotonic() + WAIT
        while self.known.get("a") != str(number):
            heard = self.platform.hear(max(until - time.monotonic(), 0))
            if not heard:
                raise Failure("it acknowledged nothing")
            if heard.kind not in ("ack", "beat"):
                raise Failure(f"it said {heard}")
            self.known["a"] = heard.get("a") or self.known.get("a")
        del self.known["a"]

    def quiet(self, milliseconds, step):
        if heard := self.next_message(milliseconds / 1000):
            raise Failure(f"it said {heard}")

    def gone(self, _, step):
        self.platform.gone()

    def ended(self, reason, step):
        try:
            said = self.agent.communicate(timeout=WAIT)[0].strip()
        except subprocess.TimeoutExpired:
            raise Failure("it has not ended") from None
        if said != f"ended {reason}":
            raise Failure(f"it {said}")
        self.platform.nobody_comes()


def needs_lines(exchange):
    return "lines" in exchange.get("transports", []) or any(
        verb in step for step in exchange["steps"] for verb in ("cut", "away"))


class Conformance(unittest.TestCase):
    def play(self, exchanges, agents, platform):
        def run(*arguments):  # a socket of ZeroMQ belongs to one thread
            return Play(*arguments).run()
        with concurrent.futures.ThreadPoolExecutor(12) as pool:
            plays = [(language, exchange["name"],
                      pool.submit(run, exchange, command, platform))
                     for exchange in exchanges
                     for language, command in agents.items()]
        for language, name, play in plays:
            with self.subTest(language=language, exchange=name):
                self.assertEqual(play.result(), "well")

    def test_all_agents_behave_in_the_same_way(self):
        self.play(EXCHANGES, AGENTS, ByLines)

    @unittest.skipUnless(has_zeromq(), "pyzmq is not installed")
    def test_and_so_they_do_by_zeromq(self):
        agents = {"Python": PYTHON}
        if node_has_zeromq():
            agents["Node.js"] = NODE
        self.play([exchange for exchange in EXCHANGES
                   if not needs_lines(exchange)], agents, ByZeroMQ)

    def test_each_exchange_names_rules_that_there_are(self):
        protocol = (ROOT / "adapters/agents/PROTOCOL.md").read_text("utf-8")
        for exchange in EXCHANGES:
            for rule in exchange["rules"]:
                self.assertRegex(protocol, rf"(?m)^(\*\*|## ){rule}\b")


if __name__ == "__main__":
    # Where this interpreter has no pyzmq, that of the system may have it.
    if not has_zeromq() and os.access("/usr/bin/python3", os.X_OK) and \
            os.path.realpath(sys.executable) != \
            os.path.realpath("/usr/bin/python3"):
        os.execv("/usr/bin/python3", ["/usr/bin/python3", "-B", *sys.argv])
    unittest.main()
