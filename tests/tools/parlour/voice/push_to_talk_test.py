"""A conversation in which a key begins and ends the turns: `parlour run --voice
--push-to-talk`, with a named pipe as the input device, and on a terminal."""

import os
import signal
import struct
import subprocess
import termios
import unittest

from voice_case import WAIT, VoiceCase

SPACE = 57  # as the kernel counts keys
# How much faster than the clock sound is. Keys are pressed in its silence.
PACE = 3


class PushToTalkTest(VoiceCase):

    def setUp(self):
        super().setUp()
        self.asked = self.silence(3) + self.speech("please open the window")
        # Whoever is not ready for the first takes the next.
        self.heard = self.write_sound(
            "heard.wav", self.asked * 4 + self.silence(3))
        self.arguments = (
            "run", self.desk(pace=PACE), "--voice",
            "--microphone", str(self.heard),
            "--speaker", str(self.folder / "answer.wav"),
            "--data", str(self.folder / "data"), "--trace")

    def held_while_something_is_said(self, lines, key):
        """Presses the key when the robot has greeted and the detector hears no
        speech, and releases it when it has heard some; returns all that was
        shown."""
        shown = ""
        is_greeted = is_speech = False
        held = None
        for line in lines:
            shown += line
            is_greeted |= "Speaker.Finished" in line
            if "VAD.SpeechStarted" in line:
                is_speech = True
            elif "VAD.SpeechEnded" in line:
                is_speech = False
                if held:
                    held = False
                    key(False)
            elif line.startswith("output") and "I open the window" in line:
                break
            if held is None and is_greeted and not is_speech:
                held = True
                key(True)
        return shown

    def test_a_key_of_an_input_device(self):
        device = self.folder / "event3"
        os.mkfifo(device)
        run = self.begin(*self.arguments, f"--push-to-talk={device}",
                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True)
        with open(device, "wb", buffering=0) as keyboard:
            shown = self.held_while_something_is_said(
                run.stderr, lambda pressed: keyboard.write(
                    struct.pack("llHHi", 0, 0, 1, SPACE, pressed)))
            out, _ = run.communicate(timeout=WAIT)
        self.assertEqual(run.returncode, 0)
        self.assertEqual(out.splitlines(), ["Hello.", "I open the window."])
        self.assertIn("KeyPushToTalk.Pressed", shown)
        self.assertIn("KeyPushToTalk.Released", shown)
        self.assertIn("KeyEndpointer.TurnEnded", shown)

    # Nobody presses it, so nothing is a turn, whatever the detector hears.
    def test_without_the_key_nothing_is_heard(self):
        device = self.folder / "event3"
        os.mkfifo(device)
        out, err = self.talk(self.arguments[1], self.heard,
                             self.folder / "answer.wav", "--trace",
                             f"--push-to-talk={device}")
        self.assertIn("VAD.SpeechStarted", err)
        self.assertNotIn("TurnStarted", err)
        self.assertEqual(out, ["Hello."])

    def test_a_key_of_the_terminal(self):
        # The sound ends the conversation, too: not before Ctrl-C does.
        self.write_sound("heard.wav", self.asked * 4 + self.silence(120))
        screen = self.on_terminal(*self.arguments, "--push-to-talk")
        shown = self.held_while_something_is_said(
            self.lines(screen), lambda _: screen.write(b" "))
        screen.write(b"\x03")  # Ctrl-C
        for _ in self.lines(screen):
            pass
        self.assertEqual(self.end_of_child(), 130, shown)
        self.assertIn("a key begins your turn and ends it: space", shown)
        self.assertIn("KeyEndpointer.TurnEnded", shown)
        self.assertIn("I open the window.", shown)

    # No line is edited while a key takes the terminal.
    def test_a_key_that_the_settings_name(self):
        screen = self.on_terminal("run", self.keyed(), "--data",
                                  str(self.folder / "data"))
        shown = self.greeted(screen)
        screen.write(b"\x03")
        for line in self.lines(screen):
            shown += line
        self.assertEqual(self.end_of_child(), 130, shown)
        self.assertIn("a key begins your turn and ends it: k", shown)

    # The second signal ends the program, whatever it does just then.
    def test_the_terminal_is_left_as_it_was(self):
        screen = self.on_terminal("run", self.keyed(), "--data",
                                  str(self.folder / "data"))
        self.greeted(screen)
        while self.shows_what_is_typed(screen):
            os.sched_yield()
        for number in (signal.SIGINT, signal.SIGTERM):
            os.kill(self.child, number)
        for _ in self.lines(screen):
            pass
        self.assertIn(self.end_of_child(), (130, -signal.SIGTERM))
        self.assertTrue(self.shows_what_is_typed(screen))

    def shows_what_is_typed(self, screen):
        return bool(termios.tcgetattr(screen)[3] & termios.ECHO)

    def keyed(self):
        return self.desk(components='<component name="Key" plugin="KeyPushToTalk">'
                         '<option name="key" value="k"/></component>')

    def greeted(self, screen):
        shown = ""
        for line in self.lines(screen):
            shown += line
            if "Hello." in line:
                break
        return shown

    def lines(self, screen):
        """Until the program has ended."""
        try:
            for line in iter(screen.readline, b""):
                yield line.decode(errors="replace")
        except OSError:  # the other side is closed
            pass


if __name__ == "__main__":
    unittest.main()
