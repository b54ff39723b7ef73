"""A Schema-Guided Dialogue schema as an application: a service is a topic. One
with a transactional intent is a task that is over when its call succeeded;
one that only looks things up is an enquiry."""

import application
from application import element, literal

INTENT = "wish"
CALLS = ["create table call (service text not null, intent text not null);"]


def transactional(service):
    return [intent for intent in service["intents"]
            if intent["is_transactional"]]


def inputs(service):
    """What a call of any intent takes, in the order of the schema."""
    named = {slot for intent in service["intents"]
             for slot in [*intent["required_slots"], *intent["optional_slots"]]}
    return [slot for slot in service["slots"] if slot["name"] in named]


def required(service):
    """What a call of some intent cannot do without."""
    return {slot for intent in service["intents"]
            for slot in intent["required_slots"]}


def functional(service):
    """What each call needs that ends the topic."""
    intents = transactional(service) or service["intents"]
    return set.intersection(*(set(intent["required_slots"])
                              for intent in intents))


def defaults(intent):
    """What is taken where the user says nothing; "dontcare" is no value."""
    return {slot: value for slot, value in intent["optional_slots"].items()
            if value != "dontcare"}


def values(names):
    return element("cardinality", {"type": "set"},
                   [f"<value>{application.escape(name)}</value>"
                    for name in names])


def slot(definition, is_functional):
    attributes = {
        "name": definition["name"],
        "type": "Functional" if is_functional else "Informational",
        "question": definition["description"] + "?"}
    children = []
    if definition["is_categorical"]:
        children = values([*definition["possible_values"], "dontcare"])
    return element("slot", attributes, children)


def intent_slot(service):
    question = "What would you like me to do?"
    return element("slot", {"name": INTENT, "question": question},
                   values([intent["name"] for intent in service["intents"]]))


def call(service, intent):
    """The user has said yes: optional slots take their defaults, the service
    is called; where it refuses, the topic stays open."""
    lines = []
    for name, value in defaults(intent).items():
        assign = element("set", {"name": f"this.{name}",
                                 "expr": literal(value)})
        lines += element("if", {"cond": f"this.{name} == unknown"}, assign)
    names = f"{literal(service['service_name'])}, {literal(intent['name'])}"
    lines += ["<try>"]
    lines += element("connectdb", {"name": "service", "param": "",
                                   "write": "true"})
    lines += element("querydb", {
        "db": "service", "args": names,
        "param": "insert into call (service, intent) values (?, ?)"})
    lines += element("speak", {"param": "It is done."})
    again = element("speak", {"param": "I am sorry, that cannot be done."})
    lines += element("catch", {}, [*again, f'<ask slot="{INTENT}"/>'])
    return [*lines, "</try>"]


def propose(service, intent):
    """All is known that this intent needs: yes or no?"""
    told = [f"{{this.{name}}}" for name in intent["required_slots"]]
    question = f"{intent['description']}: {', '.join(told)}?"
    ask = element("confirm", {"question": question},
                  [*element("yes", {}, call(service, intent)),
                   f'<no><ask slot="{INTENT}"/></no>'])
    for name in intent["required_slots"]:
        if name not in functional(service):
            ask = element("if", {"cond": f"this.{name} == unknown"}, [
                f'<ask slot="{name}"/>', *element("else", {}, ask)])
    return ask


def filled(service):
    lines = [f'<ask slot="{INTENT}"/>']
    for intent in transactional(service):
        is_it = f"this.{INTENT} == {literal(intent['name'])}"
        lines = element("if", {"cond": is_it}, [
            *propose(service, intent), *element("else", {}, lines)])
    return element("filled", {}, lines)


def query(service):
    by = [line for slot in inputs(service)
          for line in element("by", {"slot": slot["name"],
                                     "column": column(slot["name"])})]
    select = f"select found from {table(service)}"
    return element("query", {"source": "db", "param": select}, by)


def table(service):
    return service["service_name"].lower()


def column(name):
    return "of_" + name.lower()


def topic(service):
    is_task = bool(transactional(service))
    must = functional(service)
    children = [line for definition in inputs(service)
                for line in slot(definition, definition["name"] in must)]
    children += intent_slot(service)
    children += filled(service) if is_task else query(service)
    return element("topic", {"name": service["service_name"],
                             "kind": "task" if is_task else "enquiry"},
                   children)


def tables(service):
    columns = ["found text", *(f"{column(slot['name'])} text"
                               for slot in inputs(service))]
    return f"create table {table(service)} ({', '.join(columns)});"


# What the user asks about a thing that was found changes no slot.
QUESTIONS = """<handler name="Questions">
  <messages><component>
    <Dialogue>
      <request><speak param="Let me see."/><consume/></request>
    </Dialogue>
  </component></messages>
</handler>""".splitlines()


def write(folder, schema):
    topics = [line for service in schema for line in [*topic(service), ""]]
    looked_up = [tables(service) for service in schema
                 if not transactional(service)]
    application.write(folder, "sgd", topics + QUESTIONS, CALLS + looked_up)
