#!/usr/bin/env python3
"""Makes the trial of spoken names (tests/adapters/nlu/trials): names of people who
are on a list of staff and of strangers from the same population, said by
synthetic voices in several ways, and what recognisers that know none of the
names have heard.

    spoken_names.py PART FOLDER    PART: training, choosing or final

FOLDER gets staff.txt, and heard.tsv with a line for each sentence: who was
meant (empty: a stranger), how it was said, what was said, who listened, what
was heard. Needs espeak-ng and flite, pocketsphinx_continuous, and Node.js with
the packages of tools/agents/moonshine. Each part has voices and random numbers
of its own; the final part has names of its own, too.
"""

import array
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import wave

import generate_receptionist
import receptionist_names
import spoken_population

STAFF = 600

# Seed, names known and strangers that are said, and voices.
PARTS = {
    "training": (11, 160, 100, ["flite rms", "espeak en-gb 150"]),
    "choosing": (22, 160, 100, ["flite slt", "espeak en-us 160"]),
    "final": (33, 260, 160, ["flite awb", "espeak en-gb-scotland 150",
                             "espeak en-us-nyc 140"]),
}

CARRIERS = ["I am here to meet {}.", "I have an appointment with {}.",
            "I would like to see {}.", "{}."]

# How Singaporeans say pinyin, in spellings that English voices read so. They
# are taken in this order, at the beginning and at the end of a syllable.
BEGINNINGS = [("zh", "j"), ("x", "sh"), ("q", "ch"), ("z", "dz"),
              ("c(?!h)", "ts")]
ENDINGS = [("iang", "ee ahng"), ("uang", "wahng"), ("iong", "ee oong"),
           ("ian", "ee en"), ("uan", "wen"), ("iao", "ee ow"),
           ("ang", "ahng"), ("eng", "ung"), ("ong", "oong"), ("uai", "why"),
           ("ia", "ee ah"), ("ie", "ee eh"), ("iu", "ee oh"), ("ui", "way"),
           ("ue", "weh"), ("uo", "waw"), ("ao", "ow"), ("ei", "ay"),
           ("ai", "y"), ("ou", "oh"), ("en", "un"), ("an", "ahn"),
           ("hi", "er"), ("zi", "zer"), ("e", "er")]
# Syllables that only pinyin has.
PINYIN = set("""
    bao cai dan fei feng guo hao hua hui jia jian jie jing jun kai lei li lin
    min ping qi qian qing rui rong shi shu wei wen xia xiang xiao xin xiu xuan
    xue yan yang yi ying yong yu yuan yue yun ze zhen zhi zi xu zhang zhao zhou
    zheng zhu xie qiu guan yu sheng xiu zi ning ting shan ling
""".split())


def as_said(word):
    """The word in a spelling that English voices read as it is said."""
    lower = word.lower()
    if lower not in PINYIN:
        return {"Ng": "ung", "Sng": "sung", "s/o": "son of",
                "d/o": "daughter of"}.get(word, word)
    for written, said in BEGINNINGS:
        lower = re.sub("^" + written, said, lower)
    for written, said in ENDINGS:
        if lower.endswith(written) and len(lower) > len(written):
            return lower[:-len(written)] + said
    return lower


def is_link(word):
    return word in ("bin", "binte", "binti", "s/o", "d/o")


class Sayer:
    """Says names in different ways."""

    def __init__(self, staff, draw):
        self._draw = draw
        self._staff = [set(name.split()) for name in staff]

    def _means_one(self, words):
        return sum(set(words) <= name for name in self._staff) == 1

    def way(self, name, known):
        """How it is said, and the words."""
        words = name.split()
        kind = self._draw.below(20)
        if kind < 3 and len(words) > 1 and not any(map(is_link, words)):
            turn = 1 if len(words) < 4 else 2
            return "reordered", words[turn:] + words[:turn]
        if kind < 7 and known and len(words) > 2:
            part = words[:2] if self._draw.chance(0.5) else words[1:]
            part = [word for word in part if not is_link(word)]
            if self._means_one(part):
                return "partial", part
        if kind < 9:
            title = self._draw.one_of(["Mister", "Missus", "Doctor", "Miss"])
            return "titled", [title] + words
        if kind < 11:
            return "spelt", words + [", " + " ".join(words[0].upper()) + ","]
        if kind < 12:
            return "merged", words
        return "whole", words


def text_of(way, words, draw):
    said = " ".join(word if word.startswith(",") else as_said(word)
                    for word in words)
    return draw.one_of(CARRIERS).format(said)


def speak(text, voice, path):
    """Writes a WAV file of 16,000 samples a second."""
    kind, *how = voice.split()
    raw = path + ".raw.wav"
    if kind == "flite":
        subprocess.run(["flite", "-voice", how[0], "-t", text, "-o", raw],
                       check=True)
    else:
        subprocess.run(["espeak-ng", "-v", how[0], "-s", how[1], "-w", raw,
                        text], check=True)
    resample(raw, path)
    os.remove(raw)


def resample(source, target):
    """To 16,000 samples a second, by straight lines, with silence around."""
    with wave.open(source) as sound:
        rate = sound.getframerate()
        data = memoryview(sound.readframes(sound.getnframes())).cast("h")
    made = [0] * 6000
    for at in range(int(len(data) * 16000 / rate) - 1):
        place = at * rate / 16000
        first = int(place)
        if first + 1 < len(data):
            made.append(int(data[first] + (data[first + 1] - data[first])
                            * (place - first)))
    made += [0] * 6000
    with wave.open(target, "wb") as sound:
        sound.setnchannels(1)
        sound.setsampwidth(2)
        sound.setframerate(16000)
        sound.writeframes(memoryview(
            array.array("h", made)).tobytes())


def moonshine(program, paths):
    """What the network hears without any words of an application."""
    done = subprocess.run(["node", program, *paths], check=True,
                          stdout=subprocess.PIPE, text=True)
    return [json.loads(line)["text"] for line in done.stdout.splitlines()]


def sphinx(paths):
    """What PocketSphinx hears with its model of general English."""
    heard = []
    for path in paths:
        done = subprocess.run(["pocketsphinx_continuous", "-infile", path,
                               "-logfn", "/dev/null"], check=True,
                              stdout=subprocess.PIPE, text=True)
        heard.append(" ".join(done.stdout.split()))
    return heard


def merge(heard, draw):
    """Writes two neighbours near the end as one word, as people type."""
    words = heard.split()
    if len(words) < 2:
        return heard
    at = len(words) - 2 - draw.below(min(2, len(words) - 1))
    words[at:at + 2] = [words[at] + words[at + 1].lower()]
    return " ".join(words)


def people(part, draw):
    """Names that differ in the set of their words."""
    seen, names = set(), []
    while True:
        name = (spoken_population.name(draw) if part == "final" else
                receptionist_names.name(draw.one_of(["male", "female"]), draw))
        key = frozenset(name.split())
        if key not in seen:
            seen.add(key)
            names.append(name)
            yield name


def main(part, folder):
    seed, known, strangers, voices = PARTS[part]
    draw = generate_receptionist.Draw(seed)
    source = people(part, draw)
    staff = [next(source) for _ in range(STAFF)]
    others = [next(source) for _ in range(strangers)]
    sayer = Sayer(staff, draw)
    chosen = [(name, name) for name in
              (staff[STAFF * at // known] for at in range(known))]
    rows = []
    for meant, name in chosen + [("", name) for name in others]:
        way, words = sayer.way(name, bool(meant))
        listener = "sphinx" if draw.chance(0.3) else "moonshine"
        rows.append([meant, way, name, listener, text_of(way, words, draw),
                     voices[len(rows) % len(voices)]])
    program = os.environ.get("MOONSHINE") or str(
        pathlib.Path(__file__).parent.parent / "agents/moonshine/moonshine.mjs")
    with tempfile.TemporaryDirectory() as place:
        heard = {}
        for listener, hear in (("moonshine", lambda paths: moonshine(
                program, paths)), ("sphinx", sphinx)):
            mine = [at for at, row in enumerate(rows) if row[3] == listener]
            for at in mine:
                speak(rows[at][4], rows[at][5], f"{place}/{at}.wav")
            texts = hear([f"{place}/{at}.wav" for at in mine])
            heard.update(zip(mine, texts))
    out = pathlib.Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    (out / "staff.txt").write_text("".join(name + "\n" for name in staff))
    with open(out / "heard.tsv", "w") as table:
        for at, (meant, way, name, listener, _, _) in enumerate(rows):
            text = merge(heard[at], draw) if way == "merged" else heard[at]
            print(meant, way, name, listener, text, sep="\t", file=table)


if __name__ == "__main__":
    main(*sys.argv[1:])
