#!/usr/bin/env python3
"""Tests of tools/words/cut.mjs: a small file of vectors, read back."""

import json
import math
import pathlib
import shutil
import struct
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
NODE = shutil.which("node")

VECTORS = {
    "the": [1.0, 1.0, 0.0],
    ",": [1.0, 0.0, 0.0],
    "taxi": [0.0, 3.0, 4.0],
    "Taxi": [1.0, 0.0, 0.0],
    "cab": [0.0, 3.1, 3.9],
    "o'clock": [2.0, 0.0, -1.0],
}


def hash_of(word):
    made = 0xCBF29CE484222325
    for byte in word.encode():
        made = (made ^ byte) * 0x100000001B3 % 2**64
    return made


@unittest.skipUnless(NODE, "node is not installed: it is untested")
class Cut(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder, "source.json")
            made = pathlib.Path(folder, "words.vectors")
            # The numbers of a word are followed by others, which are left out.
            source.write_text(json.dumps({
                "dimensions": 3, "words": list(VECTORS),
                "vectors": {word: vector + [9.5, 7]
                            for word, vector in VECTORS.items()}}))
            subprocess.run([NODE, ROOT / "tools/words/cut.mjs", source, made],
                           timeout=60, check=True)
            cls.bytes = made.read_bytes()

    def records(self):
        return [struct.unpack_from("<QfHH3b", self.bytes, 16 + at * 19)
                for at in range(4)]

    def record(self, word):
        return next(one for one in self.records() if one[0] == hash_of(word))

    def test_keeps_words_of_small_letters(self):
        self.assertEqual(self.bytes[:8], b"PARLOURW")
        self.assertEqual(struct.unpack_from("<II", self.bytes, 8), (4, 3))
        self.assertEqual(len(self.bytes), 16 + 4 * 19)
        hashes = [one[0] for one in self.records()]
        self.assertEqual(hashes, sorted(map(hash_of, ("the", "taxi", "cab",
                                                      "o'clock"))))

    def test_keeps_the_direction_of_a_vector(self):
        self.assertEqual(self.record("taxi")[4:], (0, 95, 127))
        self.assertEqual(self.record("o'clock")[4:], (127, 0, -63))

    def test_frequent_words_count_less(self):
        def length(word):
            _, step, _, _, *numbers = self.record(word)
            return step * math.hypot(*numbers)
        self.assertLess(length("the"), length("taxi"))
        self.assertLess(length("taxi"), length("o'clock"))
        self.assertLess(length("o'clock"), 1)

    def test_each_word_has_its_groups(self):
        for one in self.records():
            self.assertGreater(one[2], 0)
            self.assertGreater(one[3], 0)


if __name__ == "__main__":
    unittest.main()
