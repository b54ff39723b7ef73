"""What goes wrong while people talk, or is exchanged, leaves a conversation that
goes on: a microphone that is unplugged, a speaker that hangs, a recogniser that
is killed, a voice that is replaced in the middle of a sentence."""

import os
import pathlib
import shutil
import signal
import unittest

from voice_case import VoiceCase

PACKAGES = (pathlib.Path(__file__).resolve().parents[4] /
            "tools/agents/moonshine/node_modules")


def has_ears():
    return PACKAGES.exists() and shutil.which("node")


class VoiceGoesOnTest(VoiceCase):

    def test_a_microphone_is_unplugged_and_put_back(self):
        window = self.speech("please open the window")
        door = self.speech("please open the door")
        run = self.begin_talk(self.desk(), self.devices(ear="", mouth=""))
        self.seen_until(run, "Speaker.Finished(1")
        self.ask(run, window, "window")
        self.write("ear.pulled", "")
        self.seen_until(run, "Microphone.Failed")
        (self.folder / "ear.gone").unlink()
        self.ask(run, door, "door")
        self.seen_until(run, "I open the door.")

    # The device is opened anew, and no sentence is lost.
    def test_a_speaker_hangs(self):
        run = self.begin_talk(self.desk(), self.devices(
            ear="", mouth="hang@3200"))
        self.seen_until(run, "Speaker.Finished(1")
        self.ask(run, self.speech("please open the window"), "window")
        self.seen_until(run, "Speaker.Finished(", "I open the window.")
        run.stdin.write("please open the door\n")
        run.stdin.flush()
        self.seen_until(run, "I open the door.")

    def children(self, run, name):
        """The processes of a component, as Linux shows them."""
        found = []
        for entry in pathlib.Path("/proc").glob("[0-9]*/stat"):
            try:
                parent = entry.read_text().rsplit(")", 1)[1].split()[1]
                line = (entry.parent / "cmdline").read_bytes().decode()
            except (OSError, IndexError):
                continue
            if int(parent) == run.pid and name in line:
                found.append(int(entry.parent.name))
        return found

    def test_a_recogniser_is_killed(self):
        window = self.speech("please open the window")
        desk = self.desk(components="""
            <component name="SphinxASR" host="process"/>""")
        run = self.begin_talk(desk, self.devices(ear="", mouth=""))
        self.seen_until(run, "Speaker.Finished(1")
        self.ask(run, window, "window")
        [process] = self.children(run, "SphinxASR")
        os.kill(process, signal.SIGKILL)
        self.seen_until(run, "ComponentFailed", "SphinxASR")
        self.seen_until(run, "ComponentUp", "SphinxASR")
        self.ask(run, self.speech("please open the door"), "door")
        self.seen_until(run, "I open the door.")

    # What was said before is lost; the conversation goes on.
    def test_a_neural_recogniser_is_killed_in_a_sentence(self):
        if not has_ears():
            self.skipTest("`tools/dependencies ears` has not been called")
        desk = self.desk()
        settings = pathlib.Path(desk) / "settings.xml"
        settings.write_text(settings.read_text(encoding="utf-8").replace(
            "SphinxASR", "MoonshineASR"), encoding="utf-8")
        run = self.begin_talk(desk, self.devices(1, ear="", mouth=""))
        self.seen_until(run, "The recogniser is ready")
        window = self.speech("please open the window")
        self.say(window)
        self.seen_until(run, "Endpointer.TurnStarted")
        [process] = self.children(run, "moonshine.mjs")
        os.kill(process, signal.SIGKILL)
        self.seen_until(run, "ComponentFailed", "MoonshineASR")
        self.seen_until(run, "The recogniser is ready")
        self.say(self.silence(1) + self.speech("please open the door"))
        self.seen_until(run, "I open the door.")

    # By a script, while the robot speaks.
    def test_a_voice_and_a_recogniser_are_replaced(self):
        question = self.speech("please open the window")
        desk = self.application(
            "desk", "Hello, while I say this, somebody changes my voice.",
            """#JSGF V1.0;
            grammar orders;
            public <order> = [please] open the <thing>
              {topic=Opening} {act=inform};
            <thing> = (window | door | red box) {Thing};
            """, """
            <grammar name="orders" file="orders.jsgf"/>
            <topic name="Opening">
              <slot name="Thing" type="Functional" question="What?"/>
              <completed><speak param="I open the {this.Thing}."/></completed>
            </topic>
            <handler name="Change">
              <messages><component><Speaker><Started>
                <if cond="not changed">
                  <set name="changed" expr="true"/>
                  <load plugin="EspeakTTS" name="FliteTTS"/>
                  <load plugin="SphinxASR" name="SphinxASR"/>
                </if>
              </Started></Speaker></component></messages>
            </handler>
            <var name="changed" expr="false"/>""")
        run = self.begin_talk(desk, self.devices(ear="", mouth=""))
        # The new voice says what the old one had still to say.
        self.all_seen(run, {"System.ComponentUp(FliteTTS, TTS)",
                            "System.ComponentUp(SphinxASR, ASR)",
                            "broken off: Hello, while I say this",
                            "Speaker.Finished(2"})
        self.ask(run, question, "window")
        self.seen_until(run, "released: I open the window.")
        self.seen_until(run, "Speaker.Finished(", "I open the window.")

    # Nothing else in the application knows who hears and who speaks.
    def test_another_name_in_the_settings_is_another_component(self):
        desk = self.desk(components="""
            <component name="Ears" plugin="SphinxASR"/>""")
        settings = pathlib.Path(desk) / "settings.xml"
        text = settings.read_text(encoding="utf-8")
        settings.write_text(
            text.replace("<Plugin>SphinxASR</Plugin>", "")
                .replace("FliteTTS", "EspeakTTS"), encoding="utf-8")
        run = self.begin_talk(desk, self.devices(ear="", mouth=""))
        self.seen_until(run, "EspeakTTS.Mark")
        self.seen_until(run, "Speaker.Finished(1")
        self.ask(run, self.speech("please open the window"), "window")
        self.seen_until(run, "released: I open the window.")
        self.seen_until(run, "Speaker.Finished(", "I open the window.")


if __name__ == "__main__":
    unittest.main()
