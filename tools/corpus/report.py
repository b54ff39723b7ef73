"""Reports a run: the figures, the bars, and the faults by kind. If the data
contradicts itself about a slot, faults in this slot are counted separately from
that turn of the dialogue on: they say nothing about the engine."""

import collections

from sgd_dialogue import RULES

# The share of turns after which all slots must be right.
ACCURACY = 0.99
# The kinds of faults after which the dialogue cannot go on.
DEAD_ENDS = ("silent", "endless", "unasked")


class Outcome:
    """The counts, faults and time of a run; the base of both reports."""

    def __init__(self):
        self.counts = collections.Counter()
        self.faults = []
        self.seconds = 0.0

    def add(self, results):
        self.counts.update(results.counts)
        self.faults += results.faults
        self.seconds += results.seconds

    def of(self, *kinds):
        return [fault for fault in self.faults if fault.kind in kinds]

    def show_faults(self, faults):
        for fault in faults:
            place = " ".join(filter(None, (fault.dialogue, fault.turn,
                                           fault.topic, fault.slot)))
            print(f"{fault.kind}: {place}: wanted '{fault.wanted}', "
                  f"found '{fault.found}'")

    def show_ends(self):
        print(f"crashes          {len(self.of('crash'))}, "
              f"errors of scripts {len(self.of('error'))}")
        print(f"dead ends        {len(self.of(*DEAD_ENDS))}")
        print(f"time             {self.seconds:.1f} s, "
              f"{self.counts['turns'] / max(self.seconds, 1e-9):,.0f} turns/s")


class Sgd(Outcome):
    """The report about the Schema-Guided Dialogue data."""

    def __init__(self):
        super().__init__()
        self.contradictions = []
        self.copied = 0

    def read(self, dialogues):
        for dialogue in dialogues:
            self.contradictions += dialogue.contradictions
            self.copied += dialogue.copied

    def contradicted(self):
        """Maps (dialogue, service, slot) to the turn of the first
        contradiction."""
        first = {}
        for found in self.contradictions:
            key = found.dialogue, found.service, found.slot
            first[key] = min(found.turn, first.get(key, found.turn))
        return first

    def own(self, kind):
        """The faults that no contradiction of the data explains."""
        first = self.contradicted()
        never = float("inf")
        return [fault for fault in self.of(kind) if int(fault.turn) <
                first.get((fault.dialogue, fault.topic, fault.slot), never)]

    def accuracy(self, faults):
        wrong = {(fault.dialogue, fault.turn) for fault in faults}
        return 1 - len(wrong) / self.counts["turns"]

    def passes(self):
        return (self.accuracy(self.of("wrong")) >= ACCURACY
                and not self.own("lost")
                and not self.of("crash", "error", *DEAD_ENDS))

    def show_list(self):
        self.show_faults(fault for fault in self.faults
                         if fault.kind not in ("wrong", "lost"))
        self.show_faults(self.own("wrong") + self.own("lost"))
        for found in self.contradictions:
            print(f"contradiction: {found.dialogue} {found.turn} "
                  f"{found.service} {found.slot}: {RULES[found.rule]}")

    def show(self):
        counts = self.counts
        lost = {(fault.dialogue, fault.turn) for fault in self.own("lost")}
        print(f"dialogues        {counts['dialogues']:,}")
        print(f"user turns       {counts['turns']:,} "
              f"({counts['states']:,} states of services, "
              f"{counts['slots']:,} slots with a value)")
        print(f"right turns      {self.accuracy(self.of('wrong')):.4%} "
              f"(bar {ACCURACY:.0%}); {self.accuracy(self.own('wrong')):.4%} "
              "where the data does not contradict itself")
        print(f"returns          {counts['returns'] - len(lost):,} "
              f"of {counts['returns']:,} with their slots")
        self.show_ends()
        print(f"given by state   {self.copied:,} values that were said "
              "elsewhere in the dialogue")
        print(f"contradictions   {len(self.contradictions):,}")
        rules = collections.Counter(found.rule
                                    for found in self.contradictions)
        for rule, sentence in RULES.items():
            print(f"  {rules[rule]:6,}  {sentence}")


class Stories(Outcome):
    """The report about the stories of financial-demo, which have no
    contradictions: every fault is the engine's."""

    def passed(self):
        failed = {fault.dialogue for fault in self.faults}
        return self.counts["dialogues"] - len(failed)

    def passes(self):
        return not self.faults

    def show_list(self):
        self.show_faults(self.faults)

    def show(self):
        print(f"stories          {self.passed()} "
              f"of {self.counts['dialogues']}")
        lost = {fault.dialogue for fault in self.of("lost")}
        print(f"returns          {self.counts['returns'] - len(lost)} "
              f"of {self.counts['returns']} with their slots")
        self.show_ends()
