"""Converts Rasa's financial-demo to an application, and its test stories to
lines for the runner.

A form becomes a topic. A rule that answers an intent by actions becomes a
reaction that leaves the topics alone. The user is asked before a form is
changed, and asked (resume="ask") before an interrupted form is resumed. Every
action is spoken by its Rasa name, so that it can be compared."""

import re

import yaml

import application
from application import element, literal

# Milliseconds that the user listens after each turn.
LISTENS = 3000

# The intents that concern the conversation itself, with the generic acts of the
# language that they correspond to.
GENERIC = {"affirm": "confirm", "deny": "deny", "goodbye": "bye",
           "greet": "greet", "help": "help", "thankyou": "thank"}
NOT_UNDERSTOOD = {"out_of_scope", "nlu_fallback"}

# The custom actions that ask before forms are switched, and the phrases of the
# engine that correspond to actions.
SWITCH_ASK = "action_switch_forms_ask"
SWITCH_YES = "action_switch_forms_affirm"
SWITCH_NO = "action_switch_forms_deny"
PHRASES = {"resume": "action_switch_back_ask", "cancelled": "utter_ask_whatelse",
           "acknowledge": "utter_ok", "bye": "utter_goodbye",
           "no_match": "utter_out_of_scope"}

# A marked value in an utterance: [words](entity) or [words]{attributes}.
ENTITY = re.compile(r'\[([^\]]+)\](?:\((\w[\w-]*)\)|\{([^}]*)\})')


def name(text):
    """Converts a Rasa name to a name of the script language."""
    return text.replace("-", "_")


def listed(value):
    return value if isinstance(value, list) else [value]


class Domain:
    """The forms, the intents that begin them, the actions that submit them, and
    the actions that answer other intents."""

    def __init__(self, folder):
        domain = load(folder / "domain.yml")
        self.forms = {form: [name(slot) for slot in made["required_slots"]]
                      for form, made in domain["forms"].items()}
        self.begins = {}   # intent -> form
        self.answers = {}  # intent -> actions
        self.submits = {}  # form -> action
        for rule in load(folder / "data/rules/rules.yml")["rules"]:
            self._read(rule["steps"])

    def _read(self, steps):
        intents = [step["intent"] for first in steps
                   for step in first.get("or", [first]) if "intent" in step]
        actions = [step["action"] for step in steps if "action" in step]
        for intent in intents:
            if actions[0] in self.forms:
                self.begins[intent] = actions[0]
            else:
                self.answers[intent] = actions
        if not intents and actions[0] in self.forms:
            self.submits[actions[0]] = actions[-1]


def load(file):
    return yaml.safe_load(file.read_text(encoding="utf-8"))


# -- the application -----------------------------------------------------------

def question(form, slot):
    return f"{form}: {slot}?"


def topic(domain, form):
    slots = [line for slot in domain.forms[form]
             for line in element("slot", {
                 "name": slot, "type": "Functional", "confirm": "never",
                 "question": question(form, slot)})]
    said = element("speak", {"param": domain.submits[form]})
    return element("topic", {"name": form, "resume": "ask"},
                   [*slots, *element("completed", {}, said)])


def switch(domain):
    """Asks for confirmation if the user wants another form while one is
    open."""
    wanted = []
    for form in domain.forms:
        wanted += element("if", {"cond": f"wanted == {literal(form)}"},
                          element("activate", {"topic": form}))
    yes = [*element("speak", {"param": SWITCH_YES}), *wanted]
    no = element("speak", {"param": SWITCH_NO})
    ask = [*element("var", {"name": "wanted", "expr": "_LPARAM1.topic"}),
           "<consume/>",
           *element("confirm", {"question": SWITCH_ASK},
                    [*element("yes", {}, yes), *element("no", {}, no)])]
    other = ("_TOPIC != unknown and _LPARAM1.topic != unknown "
             "and _LPARAM1.topic != _TOPIC")
    return element("inform", {}, element("if", {"cond": other}, ask))


def answers(domain):
    """The reactions to intents that begin no form. A generic intent has an
    element of its own, any other arrives as a `request` with its topic."""
    reactions, asked = [], []
    for intent, actions in sorted(domain.answers.items()):
        said = [line for action in actions
                for line in element("speak", {"param": action})]
        kind = GENERIC.get(intent)
        if kind in PHRASES or intent in NOT_UNDERSTOOD:
            continue
        if kind:
            reactions += element(kind, {}, [*said, "<consume/>"])
        else:
            is_it = f"_LPARAM1.topic == {literal(intent)}"
            asked += element("if", {"cond": is_it}, [*said, "<consume/>"])
    return reactions + element("request", {}, asked)


def write(folder, domain):
    reactions = element("Dialogue", {}, [*switch(domain), *answers(domain)])
    handler = element("handler", {"name": "Rules"},
                      element("messages", {},
                              element("component", {}, reactions)))
    phrases = element("phrases", {}, [
        f'<phrase act="{act}">{words}</phrase>'
        for act, words in PHRASES.items()])
    topics = [line for form in domain.forms
              for line in [*topic(domain, form), ""]]
    application.write(folder, "financial-demo", topics + handler + phrases,
                      ["create table unused (id integer);"])


# -- a story -------------------------------------------------------------------

def entities(text):
    """Maps each slot that is marked in an utterance to its value."""
    found = {}
    for words, entity, described in ENTITY.findall(text or ""):
        known = yaml.safe_load("{" + described + "}") if described else {}
        found[name(known.get("entity", entity))] = str(
            known.get("value", words))
    return found


class Story:
    """Converts the steps of a story to lines. Where the story shows that a form
    was filled but not by which words, the user answers the form's questions."""

    def __init__(self, story, domain):
        self.domain = domain
        self.steps = story["steps"]
        self.lines = [("dialogue", story["story"])]
        self.form = None    # the active form
        self.left = set()   # forms that were interrupted
        self.turns = 0
        for at, step in enumerate(self.steps):
            after = self.steps[at + 1] if at + 1 < len(self.steps) else {}
            for kind in ("intent", "action", "active_loop", "slot_was_set"):
                if kind in step:
                    getattr(self, "_" + kind)(step, after)

    def _intent(self, step, _):
        intent = step["intent"]
        self.turns += 1
        self.lines.append(("turn", self.turns))
        given = entities(step.get("user"))
        if intent in self.domain.begins:
            form = self.domain.begins[intent]
            if self.form and form != self.form:
                self.left.add(self.form)
            self._inform(form, given)
        elif intent == "inform":
            self._inform(self.form, given)
        elif intent in GENERIC:
            self._act(GENERIC[intent], "")
        elif intent not in NOT_UNDERSTOOD:
            self._act("request", intent)
        self._say()

    def _inform(self, form, given):
        self._act("inform", form)
        self.lines += [("slot", slot, value) for slot, value in given.items()
                       if slot in self.domain.forms[form]]

    def _act(self, kind, topic_name):
        self.lines.append(("act", kind, topic_name, "no"))

    def _say(self):
        self.lines += [("say",), ("wait", LISTENS)]

    def _action(self, step, _):
        action = step["action"]
        if action not in self.domain.forms:
            self.lines.append(("said", action))
            return
        self.form = action
        self.lines.append(("topic", action))
        if action in self.left:  # an interrupted form goes on
            self.left.discard(action)
            self.lines.append(("keeps", action))

    def _active_loop(self, step, after):
        if step["active_loop"] is None:
            self.lines += [("fill", self.form), ("wait", LISTENS)]
            self.form = None
        elif "intent" in after:  # one answer, then another intent
            self.lines += [("topic", self.form), ("answer", self.form)]

    def _slot_was_set(self, step, _):
        for slots in listed(step["slot_was_set"]):
            for slot, value in slots.items():
                if slot == "requested_slot" and value:
                    self.lines.append(
                        ("said", question(self.form, name(value))))
                elif self.form and value and self._is_asked(name(slot)):
                    self._inform(self.form, {name(slot): str(value)})
                    self._say()

    def _is_asked(self, slot):
        return slot in self.domain.forms[self.form]


def stories(folder, domain):
    for story in load(folder / "tests/test_stories.yml")["stories"]:
        yield Story(story, domain)
