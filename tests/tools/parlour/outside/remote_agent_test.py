"""The butler and its robot in two processes: `parlour run` with the agents of
tools/agents."""

import pathlib
import queue
import re
import shutil
import signal
import subprocess
import sys
import threading
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import ProgramCase  # noqa: E402

AGENTS = pathlib.Path(__file__).parents[4] / "tools" / "agents"
sys.path.insert(0, str(AGENTS / "python"))
sys.dont_write_bytecode = True
import parlour_agent  # noqa: E402
WAIT = 60  # seconds; only a test that fails waits so long


class Lines:
    """The lines of a stream, read on a thread, so that a test can wait for
    one."""

    def __init__(self, stream):
        self._lines = queue.SimpleQueue()
        self._seen = []
        threading.Thread(target=self._read, args=[stream], daemon=True).start()

    def _read(self, stream):
        for line in stream:
            self._lines.put(line.rstrip("\n"))
        self._lines.put(None)

    def has_any(self):
        """Whether a line comes within a moment."""
        try:
            self._seen.append(self._lines.get(timeout=0.2))
        except queue.Empty:
            return False
        return True

    def find(self, pattern):
        """The first match in a line that was not looked at before."""
        while True:
            try:
                line = self._lines.get(timeout=WAIT)
            except queue.Empty:
                line = None
            if line is None:
                raise AssertionError(
                    f"no line has '{pattern}': {self._seen[-20:]}")
            self._seen.append(line)
            if found := re.search(pattern, line):
                return found

    def last(self):
        """The line that was looked at last."""
        return self._seen[-1]

    def rest(self):
        """All lines to the end of the stream."""
        while (line := self._lines.get(timeout=WAIT)) is not None:
            self._seen.append(line)
        return self._seen


class RemoteAgentTest(ProgramCase):

    def run_butler(self, *options):
        self.run_application("butler", *options)

    def run_application(self, name, *options):
        butler = self.begin(
            "run", name, "--text", "--agents", "127.0.0.1:0",
            "--data", str(self.folder), *options, stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.end_first(butler)
        self.butler = butler
        self.said = Lines(butler.stdout)
        self.notes = Lines(butler.stderr)
        port = self.notes.find(r"agents connect at tcp://127.0.0.1:(\d+)")[1]
        self.address = f"lines://127.0.0.1:{port}"

    def end_first(self, process):
        """Before its streams are closed, as a thread reads them."""
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)

    def begin_robot(self, *command):
        robot = subprocess.Popen([*command, "Porter", self.address, "0.1"],
                                 stdout=subprocess.PIPE, text=True)
        self.addCleanup(robot.stdout.close)
        self.end_first(robot)
        lines = Lines(robot.stdout)
        lines.find("is connected")
        return robot, lines

    def begin_python_robot(self):
        return self.begin_robot(sys.executable, "-B",
                                AGENTS / "python" / "robot.py")

    def say(self, *turns):
        """Each turn ends at an empty line."""
        for turn in turns:
            self.butler.stdin.write(turn + "\n\n")
        self.butler.stdin.flush()

    def end(self):
        self.butler.stdin.close()
        self.assertEqual(self.butler.wait(WAIT), 0)

    def fetch_an_apple(self, robot_lines):
        self.say("bring the apple to the study")
        self.said.find("Shall I bring the apple from the kitchen")
        self.say("yes")
        robot_lines.find("begins: Goto kitchen")
        robot_lines.find("begins: Grasp apple")
        robot_lines.find("begins: Goto study")
        self.said.find("Here I am with the apple")
        self.say("yes")
        robot_lines.find("lets go")

    def test_a_robot_in_python_fetches_and_carries(self):
        self.run_butler()
        _, lines = self.begin_python_robot()
        self.said.find("What can I get for you")
        self.fetch_an_apple(lines)
        self.end()

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_a_robot_in_node_fetches_and_carries(self):
        self.run_butler()
        _, lines = self.begin_robot("node", AGENTS / "node" / "robot.mjs")
        self.fetch_an_apple(lines)
        self.end()

    def test_a_plugin_fetches_and_carries_in_a_process_of_its_own(self):
        self.run_butler()
        robot = self.begin("agent", "LogRobot", "--name", "Porter",
                           "--connect", self.address.replace("lines", "tcp"),
                           "--option", "travel=50ms", "--option", "grip=50ms",
                           stderr=subprocess.PIPE, text=True)
        self.end_first(robot)
        Lines(robot.stderr).find("connected")
        self.say("bring the apple to the study")
        self.said.find("Shall I bring the apple")
        self.say("yes")
        self.said.find("Here I am with the apple")
        self.end()

    def test_a_robot_that_dies_on_the_way_is_missed_and_goes_on(self):
        self.run_butler()
        robot, lines = self.begin_python_robot()
        self.say("bring the apple to the study")
        self.said.find("Shall I bring")
        robot.send_signal(signal.SIGSTOP)  # it does not answer the order
        self.say("yes")
        self.said.find("on my way")
        robot.kill()
        self.said.find("I have lost the robot")
        _, lines = self.begin_python_robot()
        self.said.find("The robot is back")
        lines.find("begins: Grasp apple")
        self.said.find("Here I am with the apple")
        self.end()

    def test_a_robot_that_comes_later_is_waited_for(self):
        self.run_butler()
        self.say("bring the apple to the study")
        self.said.find("Shall I bring")
        self.say("yes")
        self.said.find("I have lost the robot")
        _, lines = self.begin_python_robot()
        self.said.find("The robot is back")
        lines.find("begins: Grasp apple")
        self.end()

    def test_a_sensor_opens_a_conversation(self):
        self.write("lobby/settings.xml", """
            <settings name="lobby" start="Welcome">
              <agents><agent name="Door" roles="Devices"/></agents>
              <Scripts><Script>lobby.xml</Script></Scripts>
              <sessions closes-after="50ms"/>
            </settings>""")
        self.write("lobby/lobby.xml", """
            <dialogue>
              <routes>
                <open source="Door" command="State" if="_LPARAM3 == 'open'"/>
              </routes>
              <state name="Welcome">
                <Entrance><speak param="Hello."/></Entrance>
              </state>
              <handler name="Visitor"><messages><component>
                <Door><State><speak param="In the {_LPARAM2}!"/></State></Door>
              </component></messages></handler>
            </dialogue>""")
        self.run_application(str(self.folder / "lobby"))
        door = parlour_agent.Agent("Door", self.address)
        door.start()
        self.addCleanup(door.stop)
        self.said.find("Hello.")
        while not self.said.has_any():  # until that conversation is over
            door.fire("State", "door", "hall", "closed")
            door.fire("State", "door", "hall", "open")
        self.assertEqual(self.said.last(), "Hello.")
        self.said.find("In the hall!")
        self.end()

    def test_an_agent_asks_and_the_program_ends_while_it_is_connected(self):
        self.run_butler()
        self.said.find("What can I get for you")
        porter = parlour_agent.Agent("Porter", self.address)
        porter.start()
        self.addCleanup(porter.stop)
        self.assertTrue(porter.online.wait(WAIT))
        with self.assertRaises(parlour_agent.Refused) as refused:
            porter.request("Nobody", "Help")
        self.assertIn("Nobody", str(refused.exception))
        self.end()

    def test_a_tap_hears_what_robot_and_script_say(self):
        self.run_butler("--taps", "127.0.0.1:0")
        port = self.notes.find(r"taps connect at tcp://127.0.0.1:(\d+)")[1]
        tap = self.begin("tap", "--connect", f"127.0.0.1:{port}",
                         "Porter.", "ASR.", "Script.Goto",
                         stdout=subprocess.PIPE, text=True)
        self.end_first(tap)
        heard = Lines(tap.stdout)
        _, lines = self.begin_python_robot()
        while not heard.has_any():  # it takes a moment to connect
            self.say("hello")
        self.fetch_an_apple(lines)
        heard.find(r"ASR.RecognitionResult\(bring the apple")
        heard.find(r"Script.Goto\(kitchen\)")
        heard.find(r"Porter.Arrived\(kitchen\)")
        self.end()
        tap.send_signal(signal.SIGINT)
        self.assertEqual(tap.wait(WAIT), 130)


if __name__ == "__main__":
    unittest.main()
