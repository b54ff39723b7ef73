"""What goes wrong while people talk, or is exchanged, leaves a conversation that
goes on: a microphone that is unplugged, a speaker that hangs, a recogniser that
is killed, a voice that is replaced in the middle of a sentence."""

import os
import pathlib
import signal
import subprocess
import unittest

from program_case import PROGRAM
from voice_case import RATE, VoiceCase, samples_of

VDEV = pathlib.Path(PROGRAM).parent.parent / "lib/vdev.so"


class VoiceGoesOnTest(VoiceCase):

    def begin_talk(self, application, *options, **more):
        return self.begin(
            "run", application, "--voice", "--trace", "--data",
            str(self.folder / "data"), *options, stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            cwd=self.folder, **more)

    def seen_until(self, run, *words):
        """Reads what is traced up to a line with all these words."""
        seen = []
        for line in run.stderr:
            seen.append(line)
            if all(word in line for word in words):
                return line
        self.fail(f"not seen: {words}\n" + "".join(seen))

    def devices(self, **faults):
        """A sound device of our own for each name, with these faults."""
        if not VDEV.exists():
            self.skipTest("the tests were built without ALSA")
        entries = "".join(f"""
            pcm.{name} {{
              type vdev file "{self.folder}/{name}.raw"
              gone "{self.folder}/{name}.gone"
              taken "{self.folder}/taken" blocked "{self.folder}/blocked"
              rate "{RATE}" channels "1" format "S16_LE" speed "1"
              faults "{fault}" }}""" for name, fault in faults.items())
        return {**os.environ, "ALSA_CONFIG_PATH": str(self.write(
            "asound.conf", f'pcm_type.vdev {{ lib "{VDEV}" }}{entries}'))}

    # The question is asked twice, before and after.
    def test_a_microphone_is_unplugged_and_put_back(self):
        first = (self.silence(3) + self.speech("please open the window") +
                 self.silence(3))
        again = self.silence(2) + self.speech("please open the door")
        (self.folder / "ear.raw").write_bytes((first + again).tobytes())
        run = self.begin_talk(
            self.desk(), "--microphone", "ear", "--speaker", "mouth.wav",
            env=self.devices(ear=f"unplug@{len(first)}"))
        self.seen_until(run, "ASR.RecognitionResult", "window")
        self.seen_until(run, "Microphone.Failed")
        (self.folder / "ear.gone").unlink()
        self.seen_until(run, "ASR.RecognitionResult", "door")
        self.seen_until(run, "I open the door.")

    # The device is opened anew, and no sentence is lost.
    def test_a_speaker_hangs(self):
        heard = self.write_sound(
            "heard.wav", self.silence(4) +
            self.speech("please open the window") + self.silence(60))
        run = self.begin_talk(
            self.desk(), "--microphone", str(heard), "--speaker", "mouth",
            env=self.devices(mouth="hang@3200"))
        self.seen_until(run, "Speaker.Finished(1")
        self.seen_until(run, "Speaker.Finished(2", "I open the window.")
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
        question = self.speech("please open the window")
        # Asked until a new recogniser hears it.
        again = self.silence(10) + self.speech("please open the door")
        heard = self.write_sound(
            "heard.wav", self.silence(5) + question + again * 4 +
            self.silence(60))
        desk = self.desk(components="""
            <component name="SphinxASR" host="process"/>""")
        run = self.begin_talk(desk, "--microphone", str(heard), "--speaker",
                              "mouth.wav")
        self.seen_until(run, "ASR.RecognitionResult", "window")
        [process] = self.children(run, "SphinxASR")
        os.kill(process, signal.SIGKILL)
        self.seen_until(run, "ComponentFailed", "SphinxASR")
        self.seen_until(run, "ASR.RecognitionResult", "door")
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
        heard = self.write_sound(
            "heard.wav", self.silence(18) + question + self.silence(3))
        spoken = self.folder / "mouth.wav"
        out, err = self.talk(desk, heard, spoken, "--trace")
        for name in ("FliteTTS, TTS", "SphinxASR, ASR"):
            self.assertIn(f"System.ComponentUp({name})", err)
        # The new voice says what the old one had still to say.
        self.assertIn("broken off: Hello, while I say this", err)
        self.assertIn("Script.Speak(", err[err.index("broken off: "):])
        self.assertEqual(out[-1], "I open the window.", err)
        self.assertGreater(max(samples_of(spoken)[-3 * RATE:]), 1000)

    # Nothing else in the application knows who hears and who speaks.
    def test_another_name_in_the_settings_is_another_component(self):
        heard = self.write_sound(
            "heard.wav", self.silence(4) +
            self.speech("please open the window") + self.silence(3))
        desk = self.desk(components="""
            <component name="Ears" plugin="SphinxASR"/>""")
        settings = pathlib.Path(desk) / "settings.xml"
        text = settings.read_text(encoding="utf-8")
        settings.write_text(
            text.replace("<Plugin>SphinxASR</Plugin>", "")
                .replace("FliteTTS", "EspeakTTS"), encoding="utf-8")
        out, err = self.talk(desk, heard, self.folder / "a.wav", "--trace")
        self.assertEqual(out, ["Hello.", "I open the window."], err)
        self.assertIn("Ears.RecognitionResult", err)
        self.assertIn("EspeakTTS.Mark", err)
        self.assertNotIn("FliteTTS", err)


if __name__ == "__main__":
    unittest.main()
