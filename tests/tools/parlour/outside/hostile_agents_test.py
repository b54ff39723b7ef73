"""`parlour run` among peers that mean harm: an honest robot is served all the
time, nothing that the others say reaches the script, the log tells of them
sparingly, and the memory does not grow with what they send."""

import concurrent.futures
import os
import pathlib
import random
import re
import socket
import struct
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import ProgramCase  # noqa: E402
from remote_agent_test import Lines  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).parents[4] /
                       "tools/agents/python"))

from parlour_agent import Agent  # noqa: E402

SETTINGS = """<settings name="hall" start="Hall">
  <Scripts><Script>hall.xml</Script></Scripts>
  <agents>
    <agent name="Porter" roles="Robot" token="secret"/>
    <agent name="Sensor" roles="Robot"/>
  </agents>
</settings>
"""
SCRIPT = """<dialogue>
  <handler name="Turn">
    <messages>
      <component>
        <ASR><RecognitionResult>
          <post module="Porter" command="Goto">
            <param expr="_LPARAM1"/>
          </post>
        </RecognitionResult></ASR>
        <Robot><Arrived><speak param="At {_LPARAM1}."/></Arrived></Robot>
      </component>
    </messages>
  </handler>
  <state name="Hall">
    <Entrance><speak param="Hello."/></Entrance>
    <Online><agent name="Porter"><speak param="Porter is here."/></agent></Online>
  </state>
</dialogue>
"""
# What a script would hear if it were taken.
LIE = b"text;n=1,,Porter,Arrived,nowhere\ntext,,Porter,Arrived,nowhere\n"
MEBIBYTE = 1 << 20
# What parlour may take for itself, whatever is sent: 8 MiB for each of those
# who do not read, and 2 MiB for each that does not end its line. A sanitizer
# keeps what was given back, and takes its time.
SANITIZED = "LSAN_OPTIONS" in os.environ
MAX_GROWTH = (1000 if SANITIZED else 100) * MEBIBYTE
MANY = 1 if SANITIZED else 20


class Hostile:
    """One peer after the other, each with a connection of its own."""

    def __init__(self, port, seed):
        self.port, self.chance = port, random.Random(seed)

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), 30)

    def say(self, *pieces):
        """Until the platform has closed the connection, or all is said and it
        has answered something."""
        with self.connect() as peer:
            try:
                for piece in pieces:
                    peer.sendall(piece)
                return peer.recv(1 << 16)
            except OSError:
                return b""

    def malformed(self):
        for _ in range(MANY):
            self.say(self.chance.randbytes(50_000) + b"\n" * 10, LIE)

    def truncated(self):
        for _ in range(5 * MANY):
            whole = b"hello,,Porter,Hello,token=secret2\n" + LIE
            with self.connect() as peer:
                peer.sendall(whole[:self.chance.randrange(len(whole))])

    def oversized(self):
        for _ in range(MANY):
            self.say(b"text,,Porter,Arrived," + b"x" * (3 * MEBIBYTE))
            self.say(b"binary,,Porter,Arrived,f,99999999\n", LIE)

    def flooding(self):
        """As an agent that needs no token."""
        for flood in (b"text;n=1001,,Sensor,Sensed\n",
                      b"beat\n" * 10_000 * MANY,
                      b"hello,,Sensor,Hello,roles=Taxi\n" * 1000 * MANY,
                      b"text,,Sensor,Sensed,x\n" * 2500 * MANY,
                      b"shout\n" * 1000 * MANY):
            self.say(b"hello,,Sensor,Hello\n", flood)

    def replaying(self):
        for _ in range(MANY):
            self.say(b"hello,,Sensor,Hello,incarnation=aa\n",
                     b"text;n=1,,Sensor,Sensed\n" * 1000)

    def impersonating(self):
        for token in (b"", b",token=guess", b",token="):
            self.say(b"hello,,Porter,Hello" + token + b"\n", LIE)
        for _ in range(2 * MANY):
            self.say(b"hello,,Sensor,Hello\n", LIE)

    def half_open(self):
        """Gone without a word."""
        for _ in range(2 * MANY):
            peer = self.connect()
            peer.sendall(b"hello,,Sensor,Hello,incarnation=%08x\n" %
                         self.chance.getrandbits(32))
            peer.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER,
                            struct.pack("ii", 1, 0))
            peer.close()

    def slow(self):
        """Half a hello for ever, a byte at a time. The platform gives up."""
        with self.connect() as peer:
            peer.settimeout(1.0)
            for byte in b"hello,,Porter,Hello,token=secret":
                try:
                    peer.sendall(bytes([byte]))
                    if said := peer.recv(1 << 16):
                        return said
                except TimeoutError:
                    pass
                except OSError:
                    return b""
        raise AssertionError("half a hello was waited for")

    def deaf(self):
        """Does not read the answers to what it says."""
        for _ in range(1 + MANY // 10):
            with self.connect() as peer:
                peer.settimeout(10)
                try:
                    while True:
                        peer.sendall(b"shout\nbeat\n" * 5000)
                except OSError:
                    pass


KINDS = ("malformed", "truncated", "oversized", "flooding", "replaying",
         "impersonating", "half_open", "slow", "deaf")


class HostileAgentsTest(ProgramCase):
    def start(self):
        self.write("app/settings.xml", SETTINGS)
        self.write("app/hall.xml", SCRIPT)
        self.parlour = self.begin(
            "run", str(self.folder / "app"), "--text", "--agents",
            "127.0.0.1:0", "--data", str(self.folder / "data"),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.parlour.wait)
        self.addCleanup(self.parlour.kill)
        self.said = Lines(self.parlour.stdout)
        self.notes = Lines(self.parlour.stderr)
        port = int(self.notes.find(
            r"agents connect at tcp://127.0.0.1:(\d+)")[1])
        self.said.find("^Hello")
        return port

    def robot(self, port):
        robot = Agent("Porter", f"lines://127.0.0.1:{port}", roles=["Robot"],
                      token="secret")
        robot.on("Goto")(lambda message: robot.answer(
            message, "Arrived", *message.parameters))
        self.addCleanup(robot.stop)
        robot.start()
        self.said.find("^Porter is here")  # nothing reaches it before

    def memory(self):
        text = pathlib.Path(f"/proc/{self.parlour.pid}/status").read_text()
        return int(re.search(r"VmHWM:\s+(\d+)", text)[1]) * 1024

    def go(self, place):
        self.parlour.stdin.write(f"{place}\n\n")
        self.parlour.stdin.flush()
        found = self.said.find("^At (.*)\\.")
        self.assertEqual(found[1], place)  # and nowhere else

    def test_goes_on_among_them(self):
        port = self.start()
        self.robot(port)
        self.go("home")
        before = self.memory()
        with concurrent.futures.ThreadPoolExecutor(len(KINDS)) as pool:
            peers = {kind: pool.submit(getattr(Hostile(port, seed), kind))
                     for seed, kind in enumerate(KINDS)}
            trips = 0
            while not all(peer.done() for peer in peers.values()):
                trips += 1
                self.go(f"room {trips}")
        for kind, peer in peers.items():
            with self.subTest(kind):
                peer.result()
        self.go("home")
        self.assertLess(self.memory() - before, MAX_GROWTH)
        self.parlour.stdin.close()
        self.assertEqual(self.parlour.wait(60), 0)
        lines = self.notes.rest()
        told = [line for line in lines if "agent " in line]
        self.assertGreater(len(told), 3)
        self.assertLess(len(lines), 500, lines[:20])


if __name__ == "__main__":
    unittest.main()
