"""Writes an application's folder: settings, one script, the tables that its
queries name. What is written is ordinary: `parlour check` takes it."""

from xml.sax.saxutils import escape

SETTINGS = """<settings name={name}>
  <Plugins>
    <Plugin>SQLiteDatabase</Plugin>
  </Plugins>
  <component name="SQLiteDatabase">
    <option name="file" value="corpus.db"/>
    <option name="schema" value="schema.sql"/>
  </component>
  <Scripts>
    <Script>topics.xml</Script>
  </Scripts>
</settings>
"""

# What the user does comes as acts, not as words.
ACTS = """  <handler name="Acts">
    <messages><component>
      <ASR>
        <RecognitionResult><fire param="_LPARAM1"/></RecognitionResult>
      </ASR>
    </component></messages>
  </handler>
"""


def quoted(text):
    """As an attribute's value."""
    return '"' + escape(text, {'"': "&quot;"}) + '"'


def literal(text):
    """As a string of the script language."""
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def element(name, attributes, children=()):
    """The lines of an element, its children's lines indented."""
    head = "".join([f"<{name}"] + [f" {key}={quoted(value)}"
                                   for key, value in attributes.items()])
    if not children:
        return [head + "/>"]
    return [head + ">"] + ["  " + line for line in children] + [f"</{name}>"]


def write(folder, name, topics, schema):
    """`topics`: the lines of the script; `schema`: SQL statements."""
    folder.mkdir(parents=True, exist_ok=True)
    script = "\n".join("  " + line for line in topics)
    (folder / "settings.xml").write_text(
        SETTINGS.format(name=quoted(name)), encoding="utf-8")
    (folder / "topics.xml").write_text(
        f"<dialogue>\n{ACTS}\n{script}\n</dialogue>\n", encoding="utf-8")
    (folder / "schema.sql").write_text("\n".join(schema) + "\n",
                                       encoding="utf-8")
