"""The receptionist's conversation of the paper's Table I, held by voice: the
second remark cuts into the robot's question. All turns are understood over sound
devices at their own pace and ten times faster."""

import unittest

from table_one import TABLE_ONE, receptionist
from voice_case import VoiceCase

# Speech that belongs to a question cuts in so long after its first sound, in
# seconds.
BEFORE_CUT = 0.6


class VoiceTableOneTest(VoiceCase):

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
            str(receptionist(self.folder, [TABLE_ONE])), devices, "--seed", "1")
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
