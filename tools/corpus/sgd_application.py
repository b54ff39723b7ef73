"""Converts a schema of the Schema-Guided Dialogue data to an application. Each
service becomes a topic. A service with a transactional intent becomes a task,
which is completed when its call has succeeded; any other service only looks
things up and becomes an enquiry."""

import application
from application import element, literal

# The slot that holds the intent of the user.
INTENT = "wish"
CALLS = ["create table call (service text not null, intent text not null);"]


def transactional(service):
    return [intent for intent in service["intents"]
            if intent["is_transactional"]]


def inputs(service):
    """The slots that a call of any intent takes, in the order of the schema."""
    named = {slot for intent in service["intents"]
             for slot in [*intent["required_slots"], *intent["optional_slots"]]}
    return [slot for slot in service["slots"] if slot["name"] in named]


def required(service):
    """The slots that at least one intent requires."""
    return {slot for intent in service["intents"]
            for slot in intent["required_slots"]}


def functional(service):
    """The slots that are required by every intent whose call ends the topic."""
    intents = transactional(service) or service["intents"]
    return set.intersection(*(set(intent["required_slots"])
                              for intent in intents))


def defaults(intent):
    """The values of optional slots that the user does not give. "dontcare"
    stands for no value."""
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
    """The reaction to "yes": fills optional slots with their defaults and calls
    the service. If the call fails, the topic stays open."""
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
    """Asks for a slot that this intent requires and other intents do not. If
    none is missing, asks for confirmation of the call."""
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
    """The reaction of a task to filled slots: proposes the call of the wanted
    intent, or asks what is wanted."""
    lines = [f'<ask slot="{INTENT}"/>']
    for intent in transactional(service):
        is_it = f"this.{INTENT} == {literal(intent['name'])}"
        lines = element("if", {"cond": is_it}, [
            *propose(service, intent), *element("else", {}, lines)])
    return element("filled", {}, lines)


def query(service):
    """The query of an enquiry, by all slots that are known."""
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


# Questions about something that was found ("what is its address?") change no
# slot, so one sentence answers them all.
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
