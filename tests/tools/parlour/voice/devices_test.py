"""`parlour devices`: what it lists and tries, with ALSA's null device and the
device of tests/adapters/audio/vdev, and what it says where there is none."""

import pathlib
import subprocess
import unittest

from voice_case import PROGRAM, ProgramCase

VDEV = pathlib.Path(PROGRAM).parent.parent / "lib/vdev.so"


class DevicesTest(ProgramCase):

    def devices(self, configuration, *arguments):
        file = self.write("asound.conf", configuration)
        return subprocess.run(
            [PROGRAM, "devices", *arguments], capture_output=True, text=True,
            timeout=60, check=False, env={"ALSA_CONFIG_PATH": str(file)})

    def virtual(self, *arguments):
        if not VDEV.exists():
            self.skipTest("the tests were built without ALSA")
        return self.devices(f"""
            pcm_type.vdev {{ lib "{VDEV}" }}
            pcm.default {{
              type vdev file "{self.folder}/sound" gone "{self.folder}/gone"
              blocked "{self.folder}/blocked" rate "16000" channels "1"
              format "S16_LE" speed "1.2" faults ""
              hint {{ show on description "A device for tests" }} }}""",
            *arguments)

    def test_none(self):
        told = self.devices("")
        self.assertEqual(told.returncode, 1)
        self.assertIn("microphones: none\nspeakers: none\nrecognisers",
                      told.stdout)
        self.assertIn("--microphone FILE.wav", told.stderr)

    def test_a_list(self):
        told = self.virtual()
        self.assertEqual(told.returncode, 0, told)
        line = f"  {'default':<36} A device for tests\n"
        self.assertIn("microphones (--microphone NAME):\n" + line, told.stdout)
        self.assertIn("speakers (--speaker NAME):\n" + line, told.stdout)

    # What the speaker plays is what the microphone hears: one file.
    def test_a_tone_is_played_and_heard(self):
        told = self.virtual("--test", "--seconds", "1")
        self.assertEqual(told.returncode, 0, told)
        self.assertIn("speaker default: a tone of one second", told.stdout)
        self.assertIn("microphone default: speak for 1 s", told.stdout)
        self.assertRegex(told.stdout, r"\[#+ *\]  -2\d dB\n")
        self.assertRegex(told.stdout, r"level -2\d dB, peak -20 dB: that is")

    def test_silence_is_told(self):
        told = self.devices("pcm.default { type null }", "--test",
                            "--seconds", "1")
        self.assertEqual(told.returncode, 1, told)
        self.assertIn("nothing was heard: is the microphone muted",
                      told.stdout)

    def test_no_such_device(self):
        told = self.devices("", "--test", "--microphone", "hw:9",
                            "--speaker", "hw:8")
        self.assertEqual(told.returncode, 1)
        self.assertIn('"hw:9" cannot be used: there is no such', told.stderr)
        self.assertIn('"hw:8" cannot be used: there is no such', told.stderr)


if __name__ == "__main__":
    unittest.main()
