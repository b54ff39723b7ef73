"""A conversation by voice: `parlour run --voice` hears a sound file and writes
another. What it hears was spoken by the same program before."""

import json
import socket
import threading
import unittest

from voice_case import AMPLE, FAST, RATE, VoiceCase, samples_of


class Spotter(threading.Thread):
    """A server of wake words that finds one at this position, in ms."""

    def __init__(self, position):
        super().__init__(daemon=True)
        self.position = position
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]

    def run(self):
        while True:
            try:
                connection, _ = self.listener.accept()
            except OSError:
                return  # closed
            threading.Thread(
                target=self.serve, args=(connection,), daemon=True).start()

    def serve(self, connection):
        is_found = False
        with connection, connection.makefile("rwb") as file:
            for line in file:
                header = json.loads(line)
                file.read(header.get("payload_length", 0))
                if header["type"] == "describe":
                    answer = {"type": "info", "data": {"wake": [{}]}}
                elif (header["type"] == "audio-chunk" and not is_found
                      and header["data"]["timestamp"] >= self.position):
                    is_found = True
                    answer = {"type": "detection", "data": {
                        "name": "house", "timestamp": self.position}}
                else:
                    continue
                file.write(json.dumps(answer).encode() + b"\n")
                file.flush()


class VoiceTest(VoiceCase):

    def test_a_question_is_heard_and_answered(self):
        question = self.speech("please open the window")
        self.assertGreater(len(question), RATE)  # more than a second
        self.assertGreater(max(question), 1000)  # and to be heard
        heard = self.write_sound(
            "heard.wav", self.silence(3) + question + self.silence(2))
        spoken = self.folder / "answer.wav"
        out, err = self.talk(self.desk(pace=FAST), heard, spoken, "--trace")
        self.assertIn("SphinxASR.RecognitionResult", err)
        self.assertEqual(out, ["Hello.", "I open the window."])
        self.assertGreater(max(samples_of(spoken)), 1000)

    def test_it_sleeps_until_a_word_is_said(self):
        question = self.speech("please open the window")
        first = self.silence(AMPLE) + question + self.silence(2)
        spotter = Spotter(len(first) * 1000 // RATE)
        self.addCleanup(spotter.listener.close)
        spotter.start()
        desk = self.desk(["SpeechEndpointer", "WyomingWake"], f"""
            <component name="SpeechEndpointer" scope="seat">
              <option name="sleeps-after" value="1s"/>
            </component>
            <component name="WyomingWake">
              <option name="address" value="127.0.0.1:{spotter.port}"/>
            </component>""", FAST)
        heard = self.write_sound(
            "heard.wav", first + self.silence(0.5) + question +
            self.silence(AMPLE) + question + self.silence(2))
        out, err = self.talk(desk, heard, self.folder / "answer.wav", "--trace")
        # It may answer whoever it speaks to, and is asleep then, woken once,
        # and awake while it answers; the third question is said too late.
        self.assertEqual(out, ["Hello.", "I open the window."])
        self.assertEqual(err.count("KeywordSpotter.Keyword") +
                         err.count("WyomingWake.Keyword"), 1)
        self.assertEqual(err.count("ASR.RecognitionResult"), 1, err)


if __name__ == "__main__":
    unittest.main()
