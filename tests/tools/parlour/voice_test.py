"""A conversation by voice: `parlour run --voice` hears a sound file and writes
another. What it hears was spoken by the same program before."""

import unittest

from voice_case import RATE, VoiceCase, samples_of


class VoiceTest(VoiceCase):

    def test_a_question_is_heard_and_answered(self):
        question = self.speech("please open the window")
        self.assertGreater(len(question), RATE)  # more than a second
        self.assertGreater(max(question), 1000)  # and to be heard
        heard = self.write_sound(
            "heard.wav", self.silence(3) + question + self.silence(2))
        spoken = self.folder / "answer.wav"
        out, err = self.talk(self.desk(), heard, spoken, "--trace")
        self.assertIn("SphinxASR.RecognitionResult", err)
        self.assertEqual(out, ["Hello.", "I open the window."])
        self.assertGreater(max(samples_of(spoken)), 1000)


if __name__ == "__main__":
    unittest.main()
