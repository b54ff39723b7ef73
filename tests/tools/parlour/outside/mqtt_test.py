#!/usr/bin/env python3
"""The smart home with the devices of an MQTT server: in the settings, LogDevices
becomes MQTTDevices; the script stays. Skipped if mosquitto is missing."""

import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from mqtt_home import SERVER, WAIT, Home, Server  # noqa: E402
from program_case import PROGRAM, ProgramCase  # noqa: E402
from remote_agent_test import Lines  # noqa: E402

SMART_HOME = pathlib.Path(__file__).parents[4] / "config/apps/smart-home"


@unittest.skipUnless(SERVER, "there is no mosquitto")
class MQTTTest(ProgramCase):

    def setUp(self):
        super().setUp()
        self.server = Server(self.folder)
        self.server.start()
        self.addCleanup(self.server.kill)
        self.home = self.new_home()

    def new_home(self):
        home = Home(self.server.port)
        self.addCleanup(home.close)
        for room in ("kitchen", "living room", "bedroom", "hall"):
            home.add_lamp(room)
        home.add_heating("kitchen", 18, 18.04)
        home.add_heating("living room", 20, 21)
        home.add_lock()
        home.add_bell()
        return home

    def application(self, **options):
        """The smart home with one name changed, and where the server is."""
        copy = self.folder / "app"
        shutil.copytree(SMART_HOME, copy)
        settings = copy / "settings.xml"
        text = settings.read_text(encoding="utf-8")
        self.assertEqual(text.count("LogDevices"), 2)
        options = {"host": "127.0.0.1", "port": self.server.port,
                   "pause": "10ms", "answer-timeout": "8s", **options}
        more = "".join(f'<option name="{name}" value="{value}"/>'
                       for name, value in options.items())
        text = text.replace("LogDevices", "MQTTDevices").replace(
            '<option name="devices" value="devices.tsv"/>',
            f'<option name="devices" value="devices.tsv"/>{more}')
        settings.write_text(text, encoding="utf-8")
        return copy

    def run_home(self, **options):
        self.program = self.begin(
            "run", str(self.application(**options)), "--text", "--data",
            str(self.folder / "data"), stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.program.wait)
        self.addCleanup(self.program.kill)
        self.said = Lines(self.program.stdout)
        self.notes = Lines(self.program.stderr)

    def say(self, words):
        self.program.stdin.write(words + "\n\n")
        self.program.stdin.flush()

    def end(self):
        self.program.stdin.close()
        self.assertEqual(self.program.wait(WAIT), 0)

    def test_turns_lights_on_and_off(self):
        self.run_home()
        self.say("turn on the kitchen light")
        self.assertEqual(self.home.next_command(),
                         ("zigbee2mqtt/kitchen lamp/set", '{"state":"ON"}'))
        self.said.find("^The light in the kitchen is on.$")
        self.say("and in the living room?")
        self.assertEqual(self.home.next_command()[0],
                         "zigbee2mqtt/living room lamp/set")
        self.said.find("^The light in the living room is on.$")
        # Somebody presses the switch on the wall; the heating answers later.
        self.home.publish("zigbee2mqtt/kitchen lamp", '{"state": "OFF"}')
        self.say("set the heating in the kitchen to 21 degrees")
        self.said.find("^I heat the kitchen to 21 degrees.$")
        self.say("is the light on in the kitchen")
        self.said.find("^The light in the kitchen is off.$")
        self.say("how warm is it in the kitchen")
        self.said.find("^It is 18 degrees in the kitchen.$")
        self.end()

    def test_says_that_a_lamp_does_not_answer(self):
        self.run_home(**{"answer-timeout": "2s", "settle": "50ms"})
        self.home.deaf.add("zigbee2mqtt/kitchen lamp/set")
        self.say("turn on the kitchen light")
        self.said.find("I am sorry, I cannot switch the light in the kitchen")
        self.notes.find("The lamp in the kitchen does not answer")
        self.home.publish("zigbee2mqtt/bedroom lamp/availability",
                          '{"state": "offline"}')
        self.say("turn on the bedroom light")
        self.said.find("I am sorry, I cannot switch the light in the bedroom")
        self.notes.find("The lamp in the bedroom does not answer")
        self.end()

    def test_the_door_is_open_when_it_says_so(self):
        self.run_home()
        self.home.deaf.add("front/set")
        self.say("open the door")
        self.assertEqual(self.home.next_command(), ("front/set", "UNLOCK"))
        self.home.publish("front/state", "UNLOCKED")
        self.said.find("^The door is open.$")
        self.end()

    def test_somebody_rings(self):
        self.run_home()
        self.say("is the light on in the kitchen")
        self.said.find("is off")
        self.home.ring()
        self.said.find("Somebody is at the door. Shall I open")
        self.say("yes")
        self.assertEqual(self.home.next_command(), ("front/set", "UNLOCK"))
        self.said.find("^The door is open.$")
        self.end()

    def test_bears_a_server_that_goes_and_comes(self):
        self.run_home()
        self.say("turn on the kitchen light")
        self.said.find("^The light in the kitchen is on.$")
        self.server.kill()
        self.notes.find("cannot be reached")
        self.say("turn off the kitchen light")
        self.said.find("I am sorry, I cannot switch the light in the kitchen")
        self.server.start()
        self.home = self.new_home()
        self.notes.find("connected to the MQTT server")
        self.notes.find("devices are known")
        self.say("turn off the kitchen light")
        self.said.find("^The light in the kitchen is off.$")
        self.end()

    def test_holds_conversations_without_a_server(self):
        self.server.kill()
        application = self.application()
        for path in (application / "dialogues").glob("*.txt"):
            if path.name not in ("lights.txt", "which-room.txt"):
                path.unlink()
        done = subprocess.run([PROGRAM, "test", "--quiet", str(application)],
                              capture_output=True, text=True, timeout=WAIT,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_checks_without_a_server(self):
        self.server.kill()
        done = subprocess.run([PROGRAM, "check", str(self.application())],
                              capture_output=True, text=True, timeout=WAIT,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("0 errors, 0 warnings", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
