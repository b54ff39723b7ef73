#!/usr/bin/env python3
"""The agent in Python: the examples of the protocol, its delivery over
connections that lose what they carry, and a whole agent beside a platform that
breaks every connection."""

import json
import logging
import pathlib
import random
import socket
import ssl
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools/agents/python"))

import parlour_agent  # noqa: E402
from parlour_agent import Agent, Link, LineReader, Message, Payload, \
    Refused, WireError  # noqa: E402

logging.getLogger("parlour_agent").setLevel(logging.CRITICAL)

VECTORS = json.loads(
    (ROOT / "adapters/agents/vectors/messages.json").read_text("utf-8"))


def message_in(described):
    described = dict(described)
    payload = described.pop("payload", None)
    if payload:
        payload = Payload(payload["format"], bytes.fromhex(payload["hex"]),
                          payload.get("position"))
    return Message(payload=payload, **described)


def line_in(example):
    line = example["line"]
    return (line if "\n" in line else line + "\n").encode()


def read_all(reader, data):
    """Messages, and the kinds of errors."""
    reader.add(data)
    found = []
    while True:
        try:
            message = reader.next()
        except WireError as error:
            found.append(error.kind)
            if error.closes:
                return found
            continue
        if message is None:
            return found
        found.append(message)


class Wire(unittest.TestCase):
    def test_writes_and_reads_the_examples(self):
        for example in VECTORS["messages"]:
            message = message_in(example["message"])
            with self.subTest(example["name"]):
                self.assertEqual(parlour_agent.line_of(message),
                                 line_in(example))
                self.assertEqual(read_all(LineReader(), line_in(example)),
                                 [message])
                frames = [frame.encode() for frame in example["frames"]]
                self.assertEqual(parlour_agent.frames_of(message), frames)
                self.assertEqual(parlour_agent.read_frames(frames), message)

    def test_reads_what_is_written_otherwise(self):
        for example in VECTORS["readable"]:
            with self.subTest(example["name"]):
                self.assertEqual(read_all(LineReader(), line_in(example)),
                                 [message_in(example["message"])])

    def test_answers_mistakes(self):
        for example in VECTORS["errors"]:
            reader = LineReader()
            reader.add(line_in(example))
            with self.subTest(example["name"]):
                with self.assertRaises(WireError) as raised:
                    reader.next()
                self.assertEqual(raised.exception.kind, example["error"])
                self.assertEqual(raised.exception.closes,
                                 example["error"] in parlour_agent.CLOSING
                                 or example.get("closes", False))

        for example in VECTORS["frame_errors"]:
            frames = [frame.encode() for frame in example["frames"]]
            with self.subTest(example["name"]), \
                    self.assertRaises(WireError) as raised:
                parlour_agent.read_frames(frames)
            self.assertEqual(raised.exception.kind, example["error"])

    def test_goes_on_behind_a_malformed_message_and_its_payload(self):
        data = b"binary;n=x,,X,Y,f,5\nbeat\ntext,,X,\xff\nbeat;n=1\n"
        self.assertEqual(read_all(LineReader(), data),
                         ["malformed", "malformed", Message("beat", number=1)])

    def test_a_payload_of_unknown_length_is_never_read_as_lines(self):
        for wrong in (b"binary,,X,Y,f,five", b'binary,,X,Y,"f,5',
                      b"binary,,X,\xff,f,5", b"binary"):
            self.assertEqual(read_all(LineReader(), wrong + b"\nbeat\n"),
                             ["malformed"], wrong)

    def test_reads_what_may_leave_however_long_its_line(self):
        most = parlour_agent.MAX_MESSAGE_BYTES
        message = Message(parameters=["\n" * (most - 100)])
        self.assertEqual(
            read_all(LineReader(), parlour_agent.line_of(message)), [message])
        message.parameters = ["x" * most]
        with self.assertRaises(WireError):
            parlour_agent.line_of(message)
        line = f"text,,X,Y,{message.parameters[0]},x\n"
        self.assertEqual(read_all(LineReader(), line.encode()), ["oversized"])

    def test_leaves_room_for_numbers(self):
        message = Message(session="s" * 1000)
        parlour_agent.fields_of(message)
        with self.assertRaises(WireError):
            parlour_agent.check_writable(message)

    def test_reads_byte_by_byte(self):
        data = b"".join(line_in(example) for example in VECTORS["messages"])
        reader, found = LineReader(), []
        for at in range(len(data)):
            found += read_all(reader, data[at:at + 1])
        self.assertEqual(found, read_all(LineReader(), data))

    def test_parameters_keep_their_types(self):
        for value in (None, True, 7, -2.5, "text", "\x01J1", "", [1, ["two"]],
                      {"x": 1.5}):
            parameter = parlour_agent.parameter_of(value)
            self.assertEqual(parlour_agent.value_of(parameter), value)
        with self.assertRaises(ValueError):
            parlour_agent.parameter_of(float("nan"))


def connected_link():
    link = Link("aa")
    link.connect(["incarnation=bb"], 0.0)
    return link


class Delivery(unittest.TestCase):
    def test_loses_nothing_and_repeats_nothing(self):
        for seed in range(20):
            self.deliver(random.Random(seed))

    def deliver(self, chance, wanted=200):
        links = [Link("aa"), Link("bb")]
        received = [[], []]
        now, sent, connected = 0.0, 0, False

        def carry(source, target):
            cut = chance.random() < 0.1
            for message in links[source].output(now):
                if cut and chance.random() < 0.3:
                    return False
                if chance.random() < 0.05:
                    continue
                if links[target].receive(message, now):
                    received[target].append(message.command)
                    links[target].handed_on(message)
            return True

        while min(map(len, received)) < wanted:
            self.assertLess(now, 1e6)
            now += chance.random() * 0.4
            for _ in range(min(chance.randrange(20), wanted - sent)):
                sent += 1
                for link in links:
                    self.assertTrue(link.send(Message(command=str(sent))))
            if not connected:
                hellos = [link.introduction() for link in links]
                for link, hello in zip(links, reversed(hellos)):
                    link.connect(hello, now)
            connected = (carry(0, 1) and carry(1, 0)
                         and all(link.alive(now) for link in links))
            if not connected:
                for link in links:
                    link.disconnect()
        expected = [str(number) for number in range(1, wanted + 1)]
        self.assertEqual(received, [expected, expected])

    def test_the_window_of_a_message_replaces_that_of_the_hello(self):
        link = connected_link()
        for _ in range(10):
            link.send(Message())
        link.receive(Message("ack", acknowledged=0, window=4), 0.0)
        self.assertEqual(len(link.output(0.0)), 4)

    def test_notices_that_the_last_was_lost_although_all_goes_on(self):
        link, said = connected_link(), []
        link.send(Message())
        link.output(0.0)  # lost
        for number in range(1, 11):
            message = Message(command="Go", number=number)
            self.assertTrue(link.receive(message, number * 0.3))
            link.handed_on(message)
            said += link.output(number * 0.3 + 0.06)
        self.assertIn(("beat", 1), [(one.kind, one.number) for one in said])

    def test_a_withdrawn_message_counts_and_means_nothing(self):
        link = connected_link()
        self.assertFalse(link.receive(Message(number=1), 0.0))
        self.assertIn("seen=bb:1", link.introduction())
        self.assertTrue(link.receive(Message(command="Go", number=2), 0.0))

    def test_only_what_was_handed_on_counts_as_seen(self):
        link = connected_link()
        messages = [Message(command="Go", number=number) for number in (1, 2, 3)]
        for message in messages:
            self.assertTrue(link.receive(message, 0.0))
        link.handed_on(messages[2])
        link.handed_on(messages[0])
        self.assertIn("seen=bb:1", link.introduction())
        link.handed_on(messages[1])
        self.assertIn("seen=bb:3", link.introduction())

    def test_what_was_received_of_another_process_counts_no_more(self):
        link = connected_link()
        old, new = Message(command="Go", number=1), Message(command="Go", number=1)
        link.receive(old, 0.0)
        link.connect(["incarnation=cc"], 0.0)
        link.receive(new, 0.0)
        link.handed_on(old)
        self.assertIn("seen=cc:0", link.introduction())

    def test_begins_afresh_with_who_has_forgotten_it(self):
        for seen in ("seen=aa:0", "seen=cc:1", ""):
            link = connected_link()
            for command in ("a", "b"):
                link.send(Message(command=command))
            link.output(0.0)
            link.receive(Message(command="Go", number=1), 0.0)
            link.receive(Message("ack", acknowledged=1), 0.0)
            link.connect(["incarnation=bb", seen], 0.0)
            self.assertEqual([(one.command, one.number)
                              for one in link.output(0.0)], [("b", 1)])
            self.assertTrue(link.receive(Message(command="Go", number=1), 0.0))

    def test_refuses_what_nobody_may_say(self):
        for message, kind in (
                (Message("ack", acknowledged=1), "malformed"),
                (Message(command="Go", number=101), "flood")):
            with self.assertRaises(WireError) as raised:
                connected_link().receive(message, 0.0)
            self.assertEqual(raised.exception.kind, kind)

    def test_an_acknowledgement_behind_a_late_gap_counts(self):
        link = connected_link()
        link.send(Message())
        link.output(0.0)
        link.receive(Message("ack", acknowledged=0, gap=True), 0.0)
        link.receive(Message("ack", acknowledged=1), 0.0)
        self.assertEqual(link.waiting, 0)


class Platform:
    """Accepts one agent at a time, notes what it says, and closes the
    connection after each `breaks_after` messages."""

    def __init__(self, breaks_after=1 << 30, tls=None):
        self.link = Link("99")
        self.heard = []
        self.raw = []  # messages of every kind
        self.changed = threading.Condition()
        self.accepted = self.hellos = 0
        self.may_answer = threading.Event()
        self.may_answer.set()
        self._breaks_after = breaks_after
        self._tls = tls
        self._orders = []  # bytes to be written as they are
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address = "lines://127.0.0.1:%d" % \
            self._listener.getsockname()[1]
        threading.Thread(target=self._work, daemon=True).start()

    def wait_for(self, count):
        self.until(lambda: len(self.heard) >= count)
        return list(self.heard)

    def until(self, condition):
        with self.changed:
            if not self.changed.wait_for(condition, 20):
                raise AssertionError("nothing came of it")

    def write(self, data):
        self._orders.append(data)

    def _work(self):
        while True:
            connection, _ = self._listener.accept()
            self.accepted += 1
            try:
                if self._tls:
                    connection = self._tls.wrap_socket(connection,
                                                       server_side=True)
                with connection:
                    connection.settimeout(0.05)
                    self._serve(connection)
            except OSError:
                pass  # the agent is gone
            self.link.disconnect()

    def _serve(self, connection):
        reader, taken, now = LineReader(), 0, 0.0
        while taken < self._breaks_after:
            now += 0.05
            try:
                data = connection.recv(4096)
            except TimeoutError:
                data = None
            if data == b"":
                return
            for message in read_all(reader, data or b""):
                taken += self._take(message, connection, now)
                if message.kind == "bye" or taken >= self._breaks_after:
                    return
            while self._orders:
                connection.sendall(self._orders.pop(0))
            for message in self.link.output(now):
                connection.sendall(parlour_agent.line_of(message))

    def _take(self, message, connection, now):
        with self.changed:
            self.raw.append(message)
            self.changed.notify_all()
        if message.kind == "hello":
            self.hellos += 1
            self.link.connect(message.parameters, now)
            connection.sendall(parlour_agent.line_of(Message(
                "welcome", component="Parlour", command="Welcome",
                parameters=self.link.introduction())))
        elif self.link.receive(message, now):
            self._hand_on(message)
            self.link.handed_on(message)
            return 1
        with self.changed:
            self.changed.notify_all()  # acknowledged, it may be
        return 0

    def _hand_on(self, message):
        if message.sinks:  # a request: answered
            self.may_answer.wait(20)
            self.link.send(Message(
                component="Clock", command="Time", parameters=["noon"],
                correlation=message.correlation))
        with self.changed:
            self.heard.append([message.command, *message.values()])
            self.changed.notify_all()


class WholeAgent(unittest.TestCase):
    def test_keeps_its_promise_over_broken_connections(self):
        platform = Platform(breaks_after=7)
        robot = Agent("Robot", platform.address).start()
        self.addCleanup(robot.stop)
        for number in range(50):
            robot.fire("Step", number)
        self.assertEqual(platform.wait_for(50),
                         [["Step", number] for number in range(50)])
        self.assertGreater(platform.hellos, 5)

    def test_answers_commands_and_asks(self):
        platform = Platform()
        robot = Agent("Robot", platform.address)

        @robot.on("Goto")
        def go(message):
            robot.answer(message, "Arrived", *message.values())

        @robot.on("Fall")
        def fall(message):
            raise RuntimeError("over the cable")

        robot.start()
        self.addCleanup(robot.stop)
        self.assertTrue(robot.online.wait(10))
        self.assertEqual(
            robot.request("Clock", "Ask", timeout=10).parameters, ["noon"])
        for command in ("Goto", "Fall", "Dance"):
            platform.link.send(Message(component="Robot", command=command,
                                       parameters=["lobby"]))
        self.assertEqual(
            platform.wait_for(3)[1:],
            [["Arrived", "lobby"], ["Failed", "RuntimeError: over the cable"]])

    def start(self, platform):
        robot = Agent("Robot", platform.address).start()
        self.addCleanup(robot.stop)
        self.assertTrue(robot.online.wait(10))
        return robot

    def test_a_handler_may_take_its_time_and_ask(self):
        platform = Platform()
        robot = self.start(platform)

        @robot.on("Goto")
        def go(message):
            time.sleep(3.5)  # longer than silence may last
            robot.answer(message, "Arrived",
                         *robot.request("Clock", "Ask", timeout=10).values())

        platform.link.send(Message(component="Robot", command="Goto"))
        self.assertEqual(platform.wait_for(2), [["Ask"], ["Arrived", "noon"]])
        self.assertEqual(platform.hellos, 1)

    def test_a_late_answer_is_nobody_s_command(self):
        platform = Platform()
        robot = self.start(platform)
        came = []
        robot.on("*")(lambda message: came.append(message.command))
        platform.may_answer.clear()
        with self.assertRaises(Refused):
            robot.request("Clock", "Ask", timeout=0.0)
        platform.may_answer.set()
        platform.wait_for(1)
        platform.link.send(Message(command="Stop"))
        platform.until(lambda: not platform.link.waiting)
        self.assertEqual(came, ["Stop"])

    def test_a_mistake_of_the_platform_does_not_end_the_agent(self):
        platform = Platform()
        robot = self.start(platform)
        platform.write(b"ack;a=77\nshout\n")
        platform.until(lambda: [one.command for one in platform.raw
                                if one.kind == "error"]
                       == ["malformed", "unknown"])
        platform.write(b"text;n=5000,,X,Y\n")  # a flood
        platform.until(lambda: platform.hellos == 2)
        robot.fire("Step")
        self.assertEqual(platform.wait_for(1), [["Step"]])

    def test_does_not_connect_anew_where_it_was_replaced(self):
        platform = Platform()
        platform.write(b"error,,Parlour,replaced,you are two\n")
        robot = Agent("Robot", platform.address)
        with self.assertRaises(Refused) as raised:
            robot.run()
        self.assertEqual(raised.exception.kind, "replaced")
        with self.assertRaises(Refused):
            robot.fire("Step")

    def test_does_not_storm_a_platform_that_closes_at_once(self):
        platform = Platform(breaks_after=0)
        robot = Agent("Robot", platform.address).start()
        self.addCleanup(robot.stop)
        time.sleep(1.2)
        self.assertIn(platform.accepted, range(2, 5))

    def test_says_goodbye_once_all_is_acknowledged(self):
        platform = Platform()
        robot = self.start(platform)
        robot.fire("Step", Payload("image/png", b"ab"), 1)
        robot.stop()
        platform.until(lambda: platform.raw[-1].kind == "bye")
        self.assertEqual(platform.heard, [["Step", 1]])
        self.assertEqual([one.payload for one in platform.raw if one.payload],
                         [Payload("image/png", b"ab", 0)])

    def test_a_slow_message_is_no_silence(self):
        platform = Platform()
        robot = self.start(platform)
        said = threading.Event()
        robot.on("Say")(lambda message: said.set())
        platform.link.output = lambda now: []
        for piece in (b"text,,Robot", b",Say,a", b"b", b"c"):
            platform.write(piece)
            time.sleep(1.0)
        platform.write(b"d\n")
        self.assertTrue(said.wait(10))
        self.assertEqual(platform.hellos, 1)

    @unittest.skipUnless(shutil.which("openssl"), "openssl is not installed")
    def test_speaks_under_tls(self):
        with tempfile.TemporaryDirectory() as folder:
            certificate, key = folder + "/certificate", folder + "/key"
            subprocess.run(
                ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes",
                 "-keyout", key, "-out", certificate, "-days", "2", "-subj",
                 "/CN=localhost", "-addext", "subjectAltName=IP:127.0.0.1"],
                check=True, capture_output=True)
            server = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            server.load_cert_chain(certificate, key)
            trusting = ssl.create_default_context(cafile=certificate)
        platform = Platform(breaks_after=20, tls=server)
        robot = Agent("Robot", platform.address, tls=trusting).start()
        self.addCleanup(robot.stop)
        for number in range(50):
            robot.fire("Step", number, "x" * 20000)
        self.assertEqual([one[1] for one in platform.wait_for(50)],
                         list(range(50)))
        wary = Agent("Robot", platform.address,
                     tls=ssl.create_default_context()).start()
        self.addCleanup(wary.stop)
        self.assertFalse(wary.online.wait(1.0))

    def test_a_request_ends(self):
        robot = Agent("Robot", "lines://127.0.0.1:1").start()
        self.addCleanup(robot.stop)
        with self.assertRaises(Refused):
            threading.Thread(target=robot.stop).start()
            robot.request("Clock", "Ask", timeout=0.2)

    def test_addresses_are_checked(self):
        for address in ("127.0.0.1:5", "tcp://127.0.0.1:5", "lines://host"):
            with self.assertRaises(ValueError):
                Agent("Robot", address)


class ZeroMQPlatform(Platform):
    """The same by a ROUTER under CURVE; closes no connection."""

    def __init__(self):
        import zmq
        self.link = Link("99")
        self.heard, self.raw, self.hellos = [], [], 0
        self.changed = threading.Condition()
        self.public, secret = zmq.curve_keypair()
        self._router = zmq.Context.instance().socket(zmq.ROUTER)
        self._router.linger = 0
        self._router.curve_server, self._router.curve_secretkey = True, secret
        self.address = "zmq://127.0.0.1:%d" % \
            self._router.bind_to_random_port("tcp://127.0.0.1")
        threading.Thread(target=self._work, daemon=True).start()

    def _work(self):
        self._name = None
        while True:
            if self._router.poll(50):
                self._name, *frames = self._router.recv_multipart()
                self._take(parlour_agent.read_frames(frames), self,
                           time.monotonic())
            for message in self.link.output(time.monotonic()):
                self._write(message)

    def _write(self, message):
        self._router.send_multipart(
            [self._name, *parlour_agent.frames_of(message)])

    def sendall(self, line):
        reader = LineReader()
        reader.add(line)
        self._write(reader.next())


def has_zmq():
    try:
        import zmq
        return zmq.has("curve")
    except ImportError:
        return False


@unittest.skipUnless(has_zmq(), "pyzmq is not installed")
class ByZeroMQ(unittest.TestCase):
    def test_speaks_by_zeromq(self):
        import zmq
        platform = ZeroMQPlatform()
        robot = Agent("Robot", platform.address, keys=(
            *(key.decode() for key in zmq.curve_keypair()),
            platform.public.decode()))
        self.addCleanup(robot.stop)

        @robot.on("Goto")
        def go(message):
            robot.answer(message, "Arrived", *message.values())

        robot.start()
        self.assertTrue(robot.online.wait(10))
        robot.fire("Seen", 1, Payload("image/png", b"ab"))
        self.assertEqual(
            robot.request("Clock", "Ask", timeout=10).parameters, ["noon"])
        platform.link.send(Message(component="Robot", command="Goto",
                                   parameters=["lobby"]))
        self.assertEqual(platform.wait_for(3),
                         [["Seen", 1], ["Ask"], ["Arrived", "lobby"]])
        self.assertEqual([one.payload for one in platform.raw if one.payload],
                         [Payload("image/png", b"ab")])


if __name__ == "__main__":
    unittest.main()
