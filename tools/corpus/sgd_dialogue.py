"""Converts an annotated dialogue of the Schema-Guided Dialogue data to lines
for the runner. The engine gets the user's acts as they are annotated. The
system's turns only tell what "yes" and "that one" refer to. The annotated state
is the result that the engine must reach by itself.

Where the annotated state does not follow from what was said, the data
contradicts itself (RULES). Such slots are reported separately."""

import collections

from sgd_application import INTENT, defaults, inputs, required, transactional

# Milliseconds that the user listens after a turn. In this time the engine
# resumes an unfinished topic.
LISTENS = 3000

# The kinds of contradictions in the data, with a sentence for the report.
RULES = {
    "dropped": "the state loses a value that nobody took back",
    "changed": "the state changes a value that nobody spoke of",
    "chosen": "an optional value of a chosen offer replaces the user's, which "
              "it does not in other services",
    "unheard": "the state does not take a value that the user gave",
    "unsourced": "the state has a value that nobody has said",
    "unlisted": "a value is none of those that the schema lists",
    "incomplete": "a call is agreed to that lacks what the schema requires",
}

Contradiction = collections.namedtuple(
    "Contradiction", "dialogue turn service slot rule")


class Wordings:
    """The ways to write a value. The data has a spoken and a canonical form of
    each, and one form may belong to several values."""

    def __init__(self, dialogue):
        self._canonical = collections.defaultdict(set)
        self._spoken = collections.defaultdict(set)
        for turn in dialogue["turns"]:
            for frame in turn["frames"]:
                for action in frame["actions"]:
                    self._learn(action)

    def _learn(self, action):
        for value, canonical in zip(action["values"],
                                    action["canonical_values"]):
            self._canonical[value].add(canonical)
            self._spoken[canonical].add(value)

    def of(self, values):
        """All ways to write these values, beginning with the first value."""
        canonical = {other for value in values
                     for other in [value, *self._canonical[value]]}
        spoken = {other for value in canonical for other in self._spoken[value]}
        rest = (canonical | spoken) - {values[0]}
        return [values[0], *sorted(rest)]

    def same(self, one, other):
        return bool(set(self.of(one)) & set(self.of(other)))


class Service:
    """The state of one service in one dialogue."""

    def __init__(self, schema):
        self.name = schema["service_name"]
        self.inputs = {slot["name"]: slot for slot in inputs(schema)}
        self.required = required(schema)
        self.is_task = bool(transactional(schema))
        self.intents = {intent["name"]: intent for intent in schema["intents"]}
        self.state = {}    # as annotated at the last turn of the user
        self.system = []   # the actions of the last turn of the system
        self.offers = {}   # the last offer, by slot
        self.done = False  # the system has reported success

    def hear_system(self, actions):
        self.system = actions
        offers = {action["slot"]: action["values"][:1] for action in actions
                  if action["act"] == "OFFER"}
        self.offers = offers or self.offers
        self.done = self.done or self.system_did("NOTIFY_SUCCESS")

    def system_did(self, act):
        return any(action["act"] == act for action in self.system)

    def proposed(self, act):
        return {action["slot"]: action["values"] for action in self.system
                if action["act"] == act and len(action["values"]) == 1}

    def begins_anew(self, actions):
        """Whether the user wants something new after the last call has
        succeeded."""
        return self.is_task and self.done and any(
            action["act"] in ("INFORM_INTENT", "AFFIRM_INTENT")
            for action in actions)


class Reading:
    """The meaning of the user's actions for one service in one turn: values,
    and a yes or a no."""

    def __init__(self, service, frame):
        self.service = service
        self.frame = frame
        self.kinds = {action["act"] for action in frame["actions"]}
        self.given = {}  # slot -> values
        self.confirms = self.denies = self.agrees = False
        # In the data a search never begins anew: earlier values still hold.
        self.goes_on = bool(service.state)
        for action in frame["actions"]:
            reader = getattr(self, "_" + action["act"].lower(), None)
            if reader:
                reader(action)

    def _inform(self, action):
        self.given[action["slot"]] = action["values"]

    def _inform_intent(self, action):
        self.given[INTENT] = action["values"]

    def _affirm_intent(self, _):
        self.given.update({INTENT: values for values in
                           self.service.proposed("OFFER_INTENT").values()})

    def _select(self, action):
        if action["slot"]:
            self._inform(action)
        else:
            self._take(self.service.offers, self.service.required)

    def _affirm(self, _):
        self.confirms = self.service.system_did("CONFIRM")
        if self.confirms:
            return
        self._take(self.service.proposed("REQUEST"), self.service.inputs)
        if self.service.system_did("NOTIFY_FAILURE"):
            self.agrees = True
            self._take(self.service.offers, self.service.inputs)

    def _negate(self, _):
        self.denies = self.service.system_did("CONFIRM")

    def _take(self, values, wanted):
        """Adds values that the system named and the user accepted."""
        for slot in values:
            if slot in wanted:
                self.given.setdefault(slot, values[slot])

    def assumed(self):
        """The defaults that a confirmed call uses."""
        intent = self.service.intents.get(self.frame["state"]["active_intent"])
        return defaults(intent) if intent and self.confirms else {}

    def lacks(self):
        """The slots that the confirmed call requires and that have no value."""
        intent = self.service.intents[self.frame["state"]["active_intent"]]
        return set(intent["required_slots"]) - set(self.service.state)


class Dialogue:
    """The lines and contradictions of one dialogue. `copied` counts the values
    that were taken from the state, because no act of this turn gives them."""

    def __init__(self, dialogue, schemas):
        self.name = dialogue["dialogue_id"]
        self.turns = dialogue["turns"]
        self.wordings = Wordings(dialogue)
        self.services = {name: Service(schemas[name])
                         for name in dialogue["services"]}
        self.heard = set()  # every value that somebody has said
        self.touched = []   # services in the order of the acts
        self.lines = [("dialogue", self.name)]
        self.contradictions = []
        self.copied = 0
        for number, turn in enumerate(self.turns):
            read = self._user if turn["speaker"] == "USER" else self._system
            read(number, turn)

    def _system(self, _, turn):
        for frame in turn["frames"]:
            self.services[frame["service"]].hear_system(frame["actions"])
            self._hear(frame["actions"])

    def _hear(self, actions):
        self.heard |= {value for action in actions
                       for value in [*action["values"],
                                     *action["canonical_values"]]}

    def _user(self, number, turn):
        self.lines.append(("turn", number))
        readings = [Reading(self.services[frame["service"]], frame)
                    for frame in turn["frames"]]
        for reading in readings:
            self._hear(reading.frame["actions"])
            self._judge(number, reading)
        for reading in readings:
            self._return(reading)
            self._calls(number, reading)
        for reading in readings:
            self._acts(reading)
        self._say_rest(readings)
        for reading in readings:
            self._state(reading)

    # -- the state against what was said --------------------------------------

    def _judge(self, number, reading):
        """Records how the new state contradicts what was said, and makes it
        the state of the service."""
        service, frame = reading.service, reading.frame
        if service.begins_anew(frame["actions"]):
            service.state, service.done = {}, False
        new = frame["state"]["slot_values"]
        for slot in sorted(set(new) | set(service.state) | set(reading.given)):
            if slot != INTENT:
                rule = self._rule(reading, slot, new.get(slot))
                if rule:
                    self.contradictions.append(Contradiction(
                        self.name, number, service.name, slot, rule))
        service.state = new

    def _rule(self, reading, slot, new):
        """The rule that the state of this slot breaks, or None. A value that
        was said elsewhere in the dialogue is added to the given ones."""
        old = reading.service.state.get(slot)
        given = reading.given.get(slot)
        if given and self._unlisted(reading.service, slot, given):
            return "unlisted"
        if given:
            return None if new and self.wordings.same(given, new) else "unheard"
        if old:
            return self._kept(reading, slot, old, new)
        if slot in reading.assumed():
            return "incomplete" if reading.lacks() else None
        if not set(self.wordings.of(new)) & self.heard:
            return "unsourced"
        reading.given[slot] = new
        self.copied += 1
        return None

    def _kept(self, reading, slot, old, new):
        """As _rule, for a slot with a value of which nobody spoke in this
        turn."""
        if not new:
            return "dropped"
        if self.wordings.same(old, new):
            return None
        offered = reading.service.offers.get(slot)
        chosen = "SELECT" in reading.kinds and offered
        return ("chosen" if chosen and self.wordings.same(offered, new)
                else "changed")

    def _unlisted(self, service, slot, given):
        definition = service.inputs.get(slot)
        listed = definition and definition["is_categorical"] and {
            value.lower()
            for value in [*definition["possible_values"], "dontcare"]}
        return listed and not listed & {
            value.lower() for value in self.wordings.of(given)}

    # -- lines ----------------------------------------------------------------

    def _return(self, reading):
        """Notes that the user returns to a service after another one."""
        name = reading.service.name
        if not (reading.given or reading.confirms or reading.denies):
            return
        if name in self.touched[:-1] and self.touched[-1] != name:
            self.lines.append(("returns", name))
        if self.touched[-1:] != [name]:
            self.touched.append(name)

    def _calls(self, number, reading):
        """Tells the runner whether a confirmed call succeeds. The next turn of
        the system shows it."""
        outcome = "succeed"
        for frame in self.turns[number + 1]["frames"]:
            if frame["service"] == reading.service.name and any(
                    action["act"] == "NOTIFY_FAILURE"
                    for action in frame["actions"]):
                outcome = "fail"
        if reading.confirms or reading.agrees:
            self.lines.append(("calls", outcome))

    def _acts(self, reading):
        if reading.confirms or reading.denies:
            self._act("confirm" if reading.confirms else "deny",
                      reading.service.name)
        if reading.given:
            self._act("inform", reading.service.name,
                      "yes" if reading.goes_on else "no")
            self.lines += [("slot", slot, values[0])
                           for slot, values in reading.given.items()]
        if reading.agrees:  # the engine asks once more
            self.lines.append(("say",))
            self._act("confirm", reading.service.name)
        if reading.kinds & {"REQUEST", "REQUEST_ALTS"}:
            self._act("request", reading.service.name)

    def _say_rest(self, readings):
        """Adds a goodbye or thanks. A turn without any act becomes thanks,
        since the user must say something."""
        kinds = set().union(*(reading.kinds for reading in readings))
        if "GOODBYE" in kinds:
            self._act("bye", "")
        elif "THANK_YOU" in kinds or not self._said_something(readings):
            self._act("thank", "")
        self.lines += [("say",), ("wait", LISTENS)]

    @staticmethod
    def _said_something(readings):
        return any(reading.given or reading.confirms or reading.denies
                   or reading.kinds & {"REQUEST", "REQUEST_ALTS"}
                   for reading in readings)

    def _act(self, kind, topic, elliptical="no"):
        self.lines.append(("act", kind, topic, elliptical))

    def _state(self, reading):
        self.lines.append(("state", reading.service.name))
        self.lines.append(("is", INTENT, "*"))
        for slot, values in sorted(reading.service.state.items()):
            self.lines.append(("is", slot, *self._ways(values)))

    def _ways(self, values):
        return list(dict.fromkeys(way for value in values
                                  for way in self.wordings.of([value])))
