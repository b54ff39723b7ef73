"""Writes the folder of an application: settings.xml, one script, and the tables
that its queries use. It is an ordinary application: `parlour check` accepts
it."""

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

# The user's turns arrive as acts in place of words, so that only the dialogue
# engine is tested, and not the understanding.
ACTS = """  <handler name="Acts">
    <messages><component>
      <ASR>
        <RecognitionResult><fire param="_LPARAM1"/></RecognitionResult>
      </ASR>
    </component></messages>
  </handler>
"""


def quoted(text):
    """The text as the value of an attribute, in quotation marks."""
    return '"' + escape(text, {'"': "&quot;"}) + '"'


def literal(text):
    """The text as a string literal of the script language."""
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def element(name, attributes, children=()):
    """The lines of an element. `children` are the lines of its content, which
    are indented."""
    head = "".join([f"<{name}"] + [f" {key}={quoted(value)}"
                                   for key, value in attributes.items()])
    if not children:
        return [head + "/>"]
    return [head + ">"] + ["  " + line for line in children] + [f"</{name}>"]


def write(folder, name, topics, schema):
    """Writes the application. `topics` are the lines of the script, and
    `schema` the statements that create its tables."""
    folder.mkdir(parents=True, exist_ok=True)
    script = "\n".join("  " + line for line in topics)
    (folder / "settings.xml").write_text(
        SETTINGS.format(name=quoted(name)), encoding="utf-8")
    (folder / "topics.xml").write_text(
        f"<dialogue>\n{ACTS}\n{script}\n</dialogue>\n", encoding="utf-8")
    (folder / "schema.sql").write_text("\n".join(schema) + "\n",
                                       encoding="utf-8")
