"""Speaks the protocol of tools/agents/moonshine, and misbehaves on request: the
file `mode` beside it says how."""

import json
import pathlib
import sys
import time

MODE = (pathlib.Path(sys.argv[0]).parent / "mode").read_text()
INPUT, OUTPUT = sys.stdin.buffer, sys.stdout.buffer


def say(**head):
    OUTPUT.write(json.dumps(head).encode() + b"\n")
    OUTPUT.flush()


def for_ever():
    while True:
        time.sleep(60)


def misbehave_at_once():
    if MODE == "refuses":
        say(type="failed", reason="there is no model")
    elif MODE == "exits":
        print("out of luck", file=sys.stderr)
        sys.exit(3)
    elif MODE == "is never ready":
        for_ever()
    say(type="ready")
    if MODE == "does not read":
        for_ever()


def misbehave(turn):
    if MODE == "dies":
        sys.exit(4)
    elif MODE == "talks nonsense":
        OUTPUT.write(b"Traceback\n\0\xff\n")
        OUTPUT.flush()
    elif MODE == "never ends a line":
        while True:
            OUTPUT.write(b"x" * 65536)
    elif MODE == "answers others":
        say(type="result", turn=turn + 1000, text="wrong", confidence=1)
        say(type="rejected", turn=-1, reason="wrong")


def answer(turn, samples):
    misbehave(turn)
    if MODE == "hangs":
        return
    if samples < 320:
        say(type="rejected", turn=turn, reason="No words were heard.")
        return
    say(type="result", turn=turn, text=f"{samples} samples at 5 p.m.",
        confidence=0.75, words=[{"text": "a.m.", "confidence": 0.75}],
        alternatives=[{"text": "p.m.", "confidence": 0.5}])


def detect(turn, streams, payload):
    """What is loud is speech."""
    misbehave(turn)
    if MODE == "hangs":
        return
    held = streams.get(turn, b"") + payload
    pieces = [held[at:at + 1024] for at in range(0, len(held) - 1023, 1024)]
    streams[turn] = held[1024 * len(pieces):]
    say(type="speech", turn=turn,
        likely=[float(any(piece)) for piece in pieces])


def main():
    misbehave_at_once()
    turns = {}
    for line in INPUT:
        head = json.loads(line)
        payload = INPUT.read(head.get("bytes", 0))
        turn = head.get("turn")
        if head["type"] == "words":
            print("words:", payload.decode().replace("\n", ";"),
                  file=sys.stderr, flush=True)
        elif head["type"] == "narrow":
            print("narrow:", payload.decode().replace("\n", ";"),
                  file=sys.stderr, flush=True)
        elif head["type"] == "audio":
            turns[turn] = turns.get(turn, 0) + len(payload) // 2
            say(type="partial", turn=turn, text=f"{turns[turn]} so far")
        elif head["type"] == "finish":
            answer(turn, turns.pop(turn, 0))
        elif head["type"] == "detect":
            detect(turn, turns, payload)
        elif head["type"] == "cancel":
            print("cancelled", file=sys.stderr, flush=True)


main()
