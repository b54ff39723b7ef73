"""What `parlour run --voice` says where it cannot hear or speak: a device that
cannot be opened ends the run at its start, and one that is unplugged later is
waited for."""

import os
import subprocess
import unittest

from voice_case import VDEV, WAIT, VoiceCase


class VoiceStartTest(VoiceCase):

    def setUp(self):
        super().setUp()
        self.app = self.application("desk", "Hello.")
        self.environment = {**os.environ}
        self.devices("")

    def devices(self, configuration):
        self.environment["ALSA_CONFIG_PATH"] = str(
            self.write("asound.conf", configuration))

    def virtual(self, rate="16000", faults=""):
        if not VDEV.exists():
            self.skipTest("the tests were built without ALSA")
        self.devices(f"""
            pcm_type.vdev {{ lib "{VDEV}" }}
            pcm.default {{
              type vdev file "{self.folder}/sound" gone "{self.folder}/gone"
              taken "{self.folder}/taken" blocked "{self.folder}/blocked"
              rate "{rate}" channels "1" format "S16_LE" speed "1"
              faults "{faults}" }}""")

    def run_voice(self, *options, **more):
        return self.begin("run", self.app, "--voice", "--data",
                          str(self.folder / "data"), *options,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, env=self.environment, cwd=self.folder,
                          **more)

    def refused(self, *options):
        """Returns what is said; nothing else may have happened."""
        run = self.run_voice(*options, stdin=subprocess.DEVNULL)
        out, err = run.communicate(timeout=WAIT)
        self.assertEqual((run.returncode, out), (1, ""), err)
        self.assertIn("is not started: it cannot talk by voice. parlour "
                      "devices lists what there is", err)
        self.assertIn("--microphone FILE.wav --speaker FILE.wav "
                      "(docs/speech.md)", err)
        return err

    def test_no_sound_device(self):
        err = self.refused()
        for name in ("AlsaMicrophone", "AlsaSpeaker"):
            self.assertIn(f'error: {name}: the sound device "default" cannot '
                          "be used: there is no such sound device", err)

    def test_no_such_device(self):
        heard = self.write_sound("heard.wav", self.silence(1))
        err = self.refused("--microphone", str(heard), "--speaker", "hw:9")
        self.assertIn('AlsaSpeaker: the sound device "hw:9" cannot be used: '
                      "there is no such", err)
        self.assertNotIn("Microphone:", err)

    def test_a_device_that_is_taken(self):
        self.virtual()
        self.write("taken", "")
        self.assertIn("another program uses it", self.refused())

    def test_a_rate_that_nobody_can_use(self):
        self.virtual(rate="2000")
        self.assertIn("none of its formats can be used: 4,000 to 384,000",
                      self.refused())

    def test_files_that_cannot_be_used(self):
        heard = self.write_sound("heard.wav", self.silence(1))
        none = self.folder / "none.wav"
        self.assertIn("FileMicrophone: " + str(none),
                      self.refused("--microphone", "none.wav",
                                   "--speaker", "spoken.wav"))
        self.write("text.wav", "this is no sound")
        self.assertIn("FileMicrophone: ",
                      self.refused("--microphone", "text.wav",
                                   "--speaker", "spoken.wav"))
        self.write("file", "")
        self.assertIn("FileSpeaker: ",
                      self.refused("--microphone", str(heard),
                                   "--speaker", "file/spoken.wav"))

    def test_no_such_key(self):
        files = ("--microphone", str(self.write_sound("heard.wav",
                                                      self.silence(1))),
                 "--speaker", "spoken.wav")
        self.assertIn(
            'KeyPushToTalk: the input device "nowhere" cannot be used: there '
            "is no such device", self.refused(*files,
                                              "--push-to-talk=nowhere"))

    # A kiosk goes on.
    def test_a_device_that_is_unplugged_is_waited_for(self):
        self.virtual(faults="unplug@16000")
        run = self.run_voice("--trace", stdin=subprocess.PIPE)

        def seen_until(words):
            for line in run.stderr:
                if words in line:
                    return
            self.fail(f"not seen: {words}")

        seen_until("Microphone.Failed")
        (self.folder / "gone").unlink()
        seen_until("The microphone works again.")
        run.terminate()
        run.communicate(timeout=WAIT)
        self.assertEqual(run.returncode, 0)


if __name__ == "__main__":
    unittest.main()
