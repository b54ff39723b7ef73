"""The conversation of the paper's Table I, and others like it, as conversations of
a copy of the receptionist."""

import pathlib
import shutil

RECEPTIONIST = (pathlib.Path(__file__).resolve().parents[4] /
                "config/apps/receptionist")

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


def receptionist(folder, conversations):
    """A copy of the receptionist with these conversations alone, for SphinxASR."""
    copy = folder / "receptionist"
    shutil.copytree(RECEPTIONIST, copy)
    shutil.rmtree(copy / "dialogues")
    (copy / "dialogues").mkdir()
    for number, lines in enumerate(conversations):
        host = lines[0].split("to meet ")[1]
        (copy / f"dialogues/{number}.txt").write_text("\n".join((
            "R: Good morning, how can I help you?",
            f"U: {lines[0]}",
            f"U: {lines[1]}",
            "R~ .*",
            f"U: {lines[2]}",
            "R~ .*",
            "R: What's the time of your appointment?",
            f"U: {lines[3]}",
            f"R: Just a moment. I will call {host}",
            "")), encoding="utf-8")
    settings = copy / "settings.xml"
    text = settings.read_text(encoding="utf-8")
    settings.write_text(
        text.replace("</Plugins>", "<Plugin>SphinxASR</Plugin></Plugins>"),
        encoding="utf-8")
    return copy
