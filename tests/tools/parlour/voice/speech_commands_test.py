"""`parlour say` speaks into files and to a device, and `parlour listen` tells
what is heard in them."""

import json
import os
import subprocess
import unittest

from voice_case import PROGRAM, RATE, VDEV, WAIT, VoiceCase, samples_of


class SpeechCommandsTest(VoiceCase):

    def call(self, *arguments, status=0, configuration=""):
        environment = {**os.environ, "ALSA_CONFIG_PATH": str(
            self.write("asound.conf", configuration))}
        told = subprocess.run(
            [PROGRAM, *arguments], capture_output=True, text=True,
            timeout=WAIT, check=False, env=environment, cwd=self.folder)
        self.assertEqual(told.returncode, status, told)
        return told.stdout if status == 0 else told.stderr

    def test_say_writes_a_file(self):
        said = self.call("say", "please open the window", "-o", "said.wav")
        self.assertRegex(said, r"^said.wav: 1\.\d\d s\n$")
        samples = samples_of(self.folder / "said.wav")
        self.assertGreater(len(samples), RATE)
        self.assertGreater(max(samples), 1000)
        self.call("say", "hello", "--voice", "de", "-o", "said.flac")
        self.assertEqual((self.folder / "said.flac").read_bytes()[:4],
                         b"fLaC")

    def test_say_has_other_voices(self):
        for component, voice in (("EspeakTTS", "en-gb"), ("FliteTTS", "rms"),
                                 ("FliteTTS", "slt")):
            self.call("say", "hello", "--component", component, "--voice",
                      voice, "-o", f"{voice}.wav")
        self.assertNotEqual(samples_of(self.folder / "rms.wav"),
                            samples_of(self.folder / "slt.wav"))

    def test_say_speaks_to_a_device(self):
        if not VDEV.exists():
            self.skipTest("the tests were built without ALSA")
        self.call("say", "hello", configuration=f"""
            pcm_type.vdev {{ lib "{VDEV}" }}
            pcm.default {{
              type vdev file "{self.folder}/sound" gone "{self.folder}/gone"
              blocked "{self.folder}/blocked" rate "16000" channels "1"
              format "S16_LE" speed "1.2" faults "" }}""")
        self.assertGreater((self.folder / "sound").stat().st_size, RATE // 2)

    def test_say_tells_what_is_wrong(self):
        self.assertIn("there is no such sound device",
                      self.call("say", "hello", status=1))
        self.assertIn("EspeakTTS: espeak-ng has no voice 'nobody'",
                      self.call("say", "hello", "--voice", "nobody", status=1))
        self.assertIn("none/x.wav: cannot be written: No such file",
                      self.call("say", "hello", "-o", "none/x.wav", status=1))

    def test_listen_tells_what_is_heard(self):
        self.write_sound("heard.wav", self.silence(1) +
                         self.speech("please open the window") +
                         self.silence(1))
        heard = self.call("listen", self.desk(), "heard.wav")
        for words in ("heard.wav: ", "  speech 1.", "  turn 1 1.",
                      "by SphinxASR\n", "    heard        please open the "
                      "window", "    confidence   ", "    by grammar   please "
                      "open the window\n", "    by words ", "    understood   {topic: Opening"):
            self.assertIn(words, heard)
        self.assertNotIn("    why ", heard)
        why = self.call("listen", str(self.folder / "desk"), "heard.wav",
                        "--why")
        self.assertIn("    word         window", why)
        self.assertIn("    why          tokens ", why)

    def test_listen_writes_json(self):
        self.write_sound("heard.wav", self.silence(1) +
                         self.speech("please open the window") + self.silence(1))
        self.write_sound("quiet.wav", self.silence(1))
        heard, quiet = json.loads(self.call("listen", self.desk(), "--json",
                                            "heard.wav", "quiet.wav"))
        self.assertIn("open the window", heard["turns"][0]["text"])
        self.assertIn("Thing", heard["turns"][0]["acts"][0])
        self.assertEqual(quiet["speech"], [])

    def test_listen_goes_on_after_a_file_that_is_no_sound(self):
        self.write("text.wav", "this is no sound")
        self.write_sound("quiet.wav", self.silence(1))
        desk = self.desk()
        self.assertIn("text.wav", self.call("listen", desk, "text.wav",
                                            status=1))
        ended = subprocess.run([PROGRAM, "listen", desk, "text.wav",
                                "quiet.wav"], capture_output=True, text=True,
                               timeout=WAIT, check=False, cwd=self.folder)
        self.assertIn("no speech was found", ended.stdout)


if __name__ == "__main__":
    unittest.main()
