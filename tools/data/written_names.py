#!/usr/bin/env python3
"""Makes the trial of written names (tests/adapters/nlu/trials): names of people
who are on a list of staff and of strangers from the same population, in several
ways (`spoken_names.Sayer`), with up to two words spelt as somebody does who has
only heard them.

    written_names.py PART FOLDER    PART: choosing or final

FOLDER gets staff.txt and heard.tsv, as from `spoken_names`. The final part has
random numbers and people of its own.
"""

import pathlib
import re
import sys

import generate_receptionist
import spoken_names

STAFF = 600
STRANGERS = 500
SEEDS = {"choosing": 44, "final": 55}

# A pattern at the end, the beginning or anywhere, and what is written for it.
RULES = """
    ^zh j|^x sh|^q ch|^ng$ ung|^ng$ eng|^ph f|^que kwe|^hw w|hui$ hooey
    hui$ hway|wei$ way|mei$ may|lei$ lay|ui$ wee|oh$ o|ow$ ou|ee$ y|ee i|oo u
    ua$ wa|iang$ yang|ian$ ien|ing$ in|eng$ ung|ong$ oong|ay$ ei|y$ ie|i$ ee
    th t|ck k|^c(?=[aou]) k|^k(?=[aou]) c|^je ge|^ge je|ph f|v w|ll l|nn n|ss s
    tt t|ah$ a|a$ ah|sh s|mm m|d$ t|t$ d|k$ g|z s|bh b|dh d|kh k|aa a|ey$ y
    er ar|or er|ie y|ou oo|an$ en|en$ an|in$ een|m$ n|n$ ng|j dj|l r|ew$ iu
    iu$ iew|iew yu|u$ oo|ai y|kh h|sw su|tz z|ya ia|e$ +
"""
RULES = [tuple(rule.split()) for line in RULES.strip().splitlines()
         for rule in line.split("|")]
CARRIERS = ["I am here to meet {}", "i have an appointment with {}",
            "i would like to see {} please", "{}", "it's {}"]
TITLES = ("Mister", "Missus", "Doctor", "Miss")


def by_ear(word, draw):
    lower = word.lower()
    if draw.chance(0.25):
        said = spoken_names.as_said(word).replace(" ", "").lower()
        if said != lower and "/" not in word:
            return said
    fitting = [rule for rule in RULES if re.search(rule[0], lower)]
    if not fitting:
        return lower
    written, heard = draw.one_of(fitting)
    return re.sub(written, heard.replace("+", ""), lower, count=1)


def with_noise(words, noise, draw):
    places = [at for at, word in enumerate(words)
              if not spoken_names.is_link(word) and word not in TITLES
              and not word.startswith(",")]
    for _ in range(min(noise, len(places))):
        at = places.pop(draw.below(len(places)))
        words[at] = by_ear(words[at], draw)


def written(way, words, draw):
    words = [{"s/o": "son of", "d/o": "daughter of"}.get(word, word)
             .replace(",", "").strip() for word in words]
    if way == "merged" and len(words) > 1:
        at = draw.below(len(words) - 1)
        words[at:at + 2] = [words[at] + words[at + 1].lower()]
    if draw.chance(0.1):
        words.insert(draw.below(len(words)), draw.one_of(["er", "um", "uh"]))
    return draw.one_of(CARRIERS).format(" ".join(words).lower())


def main(part, folder):
    draw = generate_receptionist.Draw(SEEDS[part])
    source = spoken_names.people(part, draw)
    staff = [next(source) for _ in range(STAFF)]
    others = [next(source) for _ in range(STRANGERS)]
    sayer = spoken_names.Sayer(staff, draw)
    out = pathlib.Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    (out / "staff.txt").write_text("".join(name + "\n" for name in staff))
    with open(out / "heard.tsv", "w") as table:
        for meant, name in ([(name, name) for name in staff] +
                            [("", name) for name in others]):
            way, words = sayer.way(name, bool(meant))
            noise = draw.one_of([0, 1, 1, 2, 2])
            with_noise(words, noise, draw)
            print(meant, f"{way}{noise}", name, "ear",
                  written(way, words, draw), sep="\t", file=table)


if __name__ == "__main__":
    main(*sys.argv[1:])
