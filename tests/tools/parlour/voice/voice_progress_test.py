"""What a terminal shows while somebody talks by voice: what the run is doing, and
how loud it is. Without a terminal there is none of it."""

import unittest

from voice_case import FAST, VoiceCase

DOING = (b"loading the recogniser", b"listening    [", b"speaking     [",
         b"hearing you  [", b"thinking     [")


class VoiceProgressTest(VoiceCase):

    def setUp(self):
        super().setUp()
        self.heard = self.write_sound(
            "heard.wav", self.silence(3) +
            self.speech("please open the window") + self.silence(3))
        self.spoken = self.folder / "answer.wav"

    def shown_until(self, screen, words):
        shown = b""
        while words not in shown:
            shown += screen.read(4096)
        return shown

    def begin_on_terminal(self, *options):
        return self.on_terminal(
            "run", self.desk(), "--voice", "--microphone", str(self.heard),
            "--speaker", str(self.spoken), "--data",
            str(self.folder / "data"), *options)

    def test_beside_what_is_typed(self):
        screen = self.begin_on_terminal()
        shown = self.shown_until(screen, b"I open the window.")
        for words in DOING:
            self.assertIn(words, shown)
        self.assertIn(b" dB > ", shown)  # the prompt
        screen.write(b"\x04")  # Ctrl-D
        self.shown_until_the_end(screen)
        self.assertEqual(self.end_of_child(), 0)

    def test_below_bare_lines(self):
        screen = self.begin_on_terminal("--text")
        shown = self.shown_until(screen, b"I open the window.")
        for words in DOING:
            self.assertIn(b"\r\x1b[K" + words, shown)
        screen.write(b"\x03")  # Ctrl-C
        rest = self.shown_until_the_end(screen)
        self.assertEqual(self.end_of_child(), 130)
        self.assertFalse(rest.endswith(b" dB"), rest)

    def shown_until_the_end(self, screen):
        shown = b""
        try:
            while more := screen.read(4096):
                shown += more
        except OSError:  # the other side is closed
            pass
        return shown

    def test_not_without_a_terminal(self):
        out, err = self.talk(self.desk(pace=FAST), self.heard, self.spoken)
        self.assertEqual(out, ["Hello.", "I open the window."])
        self.assertNotIn("listening", err)
        self.assertNotIn("\r", err)


if __name__ == "__main__":
    unittest.main()
