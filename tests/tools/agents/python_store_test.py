#!/usr/bin/env python3
"""The store of the agent in Python: what a process leaves to the next."""

import logging
import pathlib
import random
import sys
import tempfile
import threading
import unittest

from python_agent_test import Platform

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools/agents/python"))

from parlour_agent import Agent, Link, Message, Payload, Refused, \
    Store  # noqa: E402

logging.getLogger("parlour_agent").setLevel(logging.CRITICAL)


class StoreCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "store"
        self.store = None

    def tearDown(self):
        self.die()

    def die(self):
        """As a process does: nothing is said, and the file is closed."""
        if self.store:
            self.store.close()
            self.store = None

    def link(self):
        """That of the next process."""
        self.die()
        self.store = Store(self.path)
        return Link("aa", self.store)

    def connected(self, said=("incarnation=bb",)):
        link = self.link()
        link.connect(list(said), 0.0)
        return link


class Keeping(StoreCase):
    def test_the_next_process_goes_on(self):
        link = self.connected()
        for command in ("a", "b", "c"):
            self.assertTrue(link.send(Message(command=command)))
        link.send(Message("binary", payload=Payload("f", b"\x00\xff\n")))
        link.output(0.0)
        link.receive(Message("ack", acknowledged=1), 0.0)
        order = Message(command="Go", number=1)
        self.assertTrue(link.receive(order, 0.0))
        self.assertTrue(link.handed_on(order, [Message(command="Gone")]))
        self.assertTrue(link.receive(Message(command="Go", number=2), 0.0))

        later = self.link()
        self.assertEqual(later.introduction(),
                         ["incarnation=aa", "window=100", "seen=bb:1"])
        self.assertTrue(later.connect(["incarnation=bb", "seen=aa:2"], 1.0))
        said = later.output(1.0)
        self.assertEqual([(one.command, one.number) for one in said[:3]],
                         [("c", 3), ("", 4), ("Gone", 5)])
        self.assertEqual(said[1].payload, Payload("f", b"\x00\xff\n"))
        self.assertFalse(later.receive(order, 1.0))
        self.assertTrue(later.receive(Message(command="Go", number=2), 1.0))

    def test_beginning_afresh_is_kept(self):
        link = self.connected()
        for command in ("a", "b"):
            link.send(Message(command=command))
        link.output(0.0)
        link.receive(Message("ack", acknowledged=1), 0.0)
        link.connect(["incarnation=cc"], 0.0)
        later = self.connected(["incarnation=cc", "seen=aa:0"])
        self.assertEqual([(one.command, one.number)
                          for one in later.output(0.0)], [("b", 1)])

    def test_part_of_a_last_line_does_not_count(self):
        self.connected().send(Message(command="a"))
        whole = self.path.read_bytes()
        self.store.add({"acknowledged": 0, "handled": 0, "sent": []})
        self.die()
        partly = self.path.read_bytes()
        for end in range(len(whole), len(partly)):
            self.path.write_bytes(partly[:end])
            self.assertEqual(self.link().waiting, 1)

    def test_a_damaged_store_is_told_with_its_place(self):
        self.connected().send(Message(command="a"))
        self.die()
        lines = self.path.read_bytes().split(b"\n")
        self.path.write_bytes(b"\n".join([lines[0], lines[1][:-2], b""]))
        with self.assertRaisesRegex(ValueError, "store:2: .*damaged.*Remove"):
            self.link()
        self.path.write_bytes(b"something else")
        with self.assertRaisesRegex(ValueError, "no store"):
            self.link()

    def test_one_process_at_a_time(self):
        self.link()
        with self.assertRaisesRegex(BlockingIOError, "another process"):
            Store(self.path)

    def test_does_not_grow_without_end(self):
        link = self.connected()
        self.store.MAX_BYTES = 10_000
        for number in range(1, 2000):
            link.send(Message(command="Step", parameters=["x" * 100]))
            link.output(0.0)
            link.receive(Message("ack", acknowledged=number), 0.0)
            self.assertLess(self.path.stat().st_size, 20_000)
        self.assertEqual(self.link().waiting, 1)

    def test_who_has_received_more_than_the_store_knows_begins_afresh(self):
        self.connected().send(Message(command="a"))
        later = self.link()
        self.assertFalse(later.connect(["incarnation=bb", "seen=aa:7"], 0.0))
        self.assertNotIn("incarnation=aa", later.introduction())
        self.assertEqual(later.waiting, 1)
        known = later.incarnation
        self.assertEqual(self.link().incarnation, known)

    def test_an_answer_to_an_earlier_process_answers_nothing(self):
        link = self.connected()
        first = link.last_correlation + 1
        link.send(Message(command="Ask", sinks=["Clock"], correlation=first))
        later = self.link()
        self.assertEqual(later.first_correlation, link.first_correlation)
        self.assertEqual(later.last_correlation, first)

    def test_each_message_has_its_effect_once_however_often_it_dies(self):
        for seed in range(10):
            self.live_and_die(random.Random(seed))
            self.die()
            self.path.unlink()

    def live_and_die(self, chance, wanted=100):
        """The agent says for each message of the platform one of its own."""
        platform, heard = Link("bb"), []
        for number in range(wanted):
            platform.send(Message(command=str(number)))
        agent, deaths, now = None, 0, 0.0
        while len(heard) < wanted:
            if agent is None:
                agent = self.link()
                hellos = platform.introduction(), agent.introduction()
                agent.connect(hellos[0], now)
                platform.connect(hellos[1], now)
            now += 0.1
            dies = chance.random() < 0.3
            for message in platform.output(now)[:chance.randrange(20)]:
                if agent.receive(message, now):
                    if dies and chance.random() < 0.2:
                        break  # while its handler is under way
                    agent.handed_on(message, [Message(command=message.command)])
            for message in agent.output(now)[:chance.randrange(20)]:
                if platform.receive(message, now):
                    heard.append(message.command)
                    platform.handed_on(message)
            if dies:
                agent, deaths = None, deaths + 1
                platform.disconnect()
        self.assertEqual(heard, [str(number) for number in range(wanted)])
        self.assertGreater(deaths, 3)


class WholeAgent(StoreCase):
    def robot(self, platform):
        robot = Agent("Robot", platform.address, store=self.path)
        self.addCleanup(robot.stop)
        return robot

    def test_what_a_handler_fires_leaves_when_it_ends(self):
        platform = Platform()
        robot = self.robot(platform)
        began, may_end = threading.Event(), threading.Event()

        @robot.on("Goto")
        def go(message):
            robot.answer(message, "Arrived")
            robot.fire("Tired")
            began.set()
            may_end.wait(20)

        robot.start()
        self.assertTrue(robot.online.wait(10))
        platform.link.send(Message(component="Robot", command="Goto"))
        self.assertTrue(began.wait(10))
        robot.fire("Seen")  # of another thread: at once
        self.assertEqual(platform.wait_for(1), [["Seen"]])
        may_end.set()
        self.assertEqual(platform.wait_for(3),
                         [["Seen"], ["Arrived"], ["Tired"]])

    def test_a_handler_cannot_fire_more_than_can_wait(self):
        platform = Platform()
        robot = self.robot(platform)
        refused = threading.Event()

        @robot.on("Goto")
        def go(message):
            try:
                for _ in range(Link.MAX_WAITING + 1):
                    robot.fire("Step")
            except Refused as error:
                if error.kind == "Limit":
                    refused.set()

        robot.start()
        platform.link.send(Message(component="Robot", command="Goto"))
        self.assertTrue(refused.wait(10))
        platform.wait_for(Link.MAX_WAITING)

    def test_goes_on_where_it_has_stopped(self):
        platform = Platform()
        robot = self.robot(platform).start()
        robot.fire("Step", 1)
        platform.wait_for(1)
        robot.stop()
        later = self.robot(platform).start()
        later.fire("Step", 2)
        self.assertEqual(platform.wait_for(2), [["Step", 1], ["Step", 2]])
        hellos = [one.parameters[0] for one in platform.raw
                  if one.kind == "hello"]
        self.assertEqual(hellos, hellos[:1] * 2)


if __name__ == "__main__":
    unittest.main()
