"""The receptionist's conversation of the paper's Table I, held by voice: the
second remark cuts into the robot's question. All turns are understood: over sound
devices at their own pace and ten times faster, and in virtual time, where four
more visitors ask for other hosts, floors and hours."""

import pathlib
import shutil
import subprocess
import unittest

from program_case import PROGRAM
from voice_case import VoiceCase

RECEPTIONIST = (pathlib.Path(__file__).resolve().parents[3] /
                "config/apps/receptionist")
# Speech that belongs to a question cuts in so long after its first sound, in
# seconds.
BEFORE_CUT = 0.6

TABLE_ONE = (
    "I am David from Comptec to meet Dr. Jeffery Ho.",
    "By the way, is there any coffee shop on this second floor?",
    "How about food court?", "10:30am.")
OTHERS = (
    ("I am Michael from Comptec to meet Dr. Irene Low.",
     "By the way, is there any restaurant on this third floor?",
     "How about bookshop?", "11am."),
    ("I am Helen from Comptec to meet Ms. Audrey Koh.",
     "By the way, is there any bank on this fourth floor?",
     "How about coffee shop?", "2:30pm."),
    ("I am Peter from Comptec to meet Ms. Amanda Chua.",
     "By the way, is there any pharmacy on this second floor?",
     "How about restaurant?", "9:45am."),
    ("I am Linda from Comptec to meet Ms. Shirley Yeo.",
     "By the way, is there any bookshop on this third floor?",
     "How about food court?", "4:15pm."))


class VoiceTableOneTest(VoiceCase):

    def receptionist(self, conversations):
        """A copy with these conversations alone."""
        copy = self.folder / "receptionist"
        shutil.copytree(RECEPTIONIST, copy)
        shutil.rmtree(copy / "dialogues")
        for number, lines in enumerate(conversations):
            host = lines[0].split("to meet ")[1]
            self.write(f"receptionist/dialogues/{number}.txt", f"""
                R: Good morning, how can I help you?
                U: {lines[0]}
                U: {lines[1]}
                R~ .*
                U: {lines[2]}
                R~ .*
                R: What's the time of your appointment?
                U: {lines[3]}
                R: Just a moment. I will call {host}
                """)
        settings = copy / "settings.xml"
        text = settings.read_text(encoding="utf-8")
        settings.write_text(
            text.replace("</Plugins>", "<Plugin>SphinxASR</Plugin></Plugins>"),
            encoding="utf-8")
        return copy

    def test_in_virtual_time(self):
        copy = self.receptionist((TABLE_ONE, *OTHERS))
        run = subprocess.run(
            [PROGRAM, "test", str(copy), "--voice", "--told"],
            capture_output=True, text=True, check=False, timeout=280)
        # A question that was cut is asked in other words the next time, so not
        # all answers are those of the conversation by text.
        self.assertIn(run.returncode, (0, 1), run.stderr)
        score = run.stdout.splitlines()[-1].split()
        self.assertEqual(score[8:10], ["15", "100.0"], run.stdout)

    def test_at_the_pace_of_a_sound_device(self):
        self.hold(speed=1)

    def test_ten_times_faster(self):
        self.hold(speed=10)

    def hold(self, speed):
        """Recorded speech is misheard at times, as the device's pace varies:
        the conversation is held again then, once."""
        try:
            self.hold_once(speed)
        except AssertionError:
            self.folder = self.folder / "again"
            self.folder.mkdir()
            self.hold_once(speed)

    def hold_once(self, speed):
        devices = self.devices(speed, ear="", mouth="")
        lines = [self.speech(line, "--voice", "rms") for line in TABLE_ONE]
        run = self.begin_talk(
            str(self.receptionist([TABLE_ONE])), devices, "--seed", "1")
        self.seen_until(run, "Speaker.Finished(1")
        self.say(lines[0])
        self.seen_until(run, "output", "released: What's the time")
        self.seen_until(run, "Speaker.Started(")
        # Ten times faster the question is over after a sixth of a second, and a
        # busy machine may be late.
        self.say(self.silence(BEFORE_CUT if speed == 1 else 0) + lines[1])
        if speed == 1:
            self.seen_until(run, "output", "broken off: What's the time")
        self.seen_until(run, "output", "released: No, however, there are two "
                        "coffee shops on the first floor, namely, Starbucks "
                        "Coffee and Ya Kun Toastwich.")
        self.seen_until(run, "Speaker.Finished(")
        self.say(lines[2])
        self.seen_until(run, "output", "released: There is one food court named "
                        "Food Chain food court at basement one.")
        self.seen_until(run, "output", "Appointment: released: ")
        self.seen_until(run, "Speaker.Finished(")
        self.say(lines[3])
        # It may be too late for that today.
        self.seen_until(run, "FrameInfo({topic: Appointment", "10:30")


if __name__ == "__main__":
    unittest.main()
