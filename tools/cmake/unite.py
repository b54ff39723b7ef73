"""Chooses which sources are compiled together (Unite.cmake).

    python3 unite.py LIMIT LIST

Each line of the file LIST is "TARGET SOURCE". Prints "TARGET NUMBER SOURCE" for
each source that is compiled with others; sources of the same target and number,
at most LIMIT, are one piece. One process serves all targets, so that it reads
each header once. Two sources come into one piece
only if neither, nor a header that it includes, mentions what the other keeps to
itself: names in unnamed namespaces, macros, and namespaces that it opens for all
that follows. A function counts where its name is declared or called: a variable or
a member of that name hides it anyway. So each means the same as if it were compiled
alone, and may have helpers called like those of another source. One that opens an
enumeration for all that follows has no company.
"""

import re
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TEXT = re.compile(
    r"""R"(\w*)\(.*?\)\1" | //[^\n]* | /\*.*?\*/
      | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])+'""", re.S | re.X)
# Not a member, nor a name of a class or a namespace that is given.
WORD = re.compile(r"(?<![\w.:])(?<!->)[A-Za-z_]\w*")
CALL = re.compile(WORD.pattern + r"(?=\s*\()")
BRACE = re.compile(r"[{}]")
INCLUDE = re.compile(r'^#include "(.*\.hpp)"', re.M)
NAMESPACE = re.compile(r"\bnamespace [\w:]+\s*\{")
UNNAMED = re.compile(r"\bnamespace\s*\{")
MACRO = re.compile(r"#\s*define\s+(\w+)")
OPENED = re.compile(r"^using namespace (\S+);", re.M)
OPENED_ENUM = re.compile(r"^using enum ", re.M)
TYPE = re.compile(r"\b(?:struct|class|enum|union|concept)\s+(?:class\s+)?(\w+)")
ALIAS = re.compile(r"\busing (\w+) =")
NOTHING_NEW = re.compile(r"\s*(using|static_assert|namespace|friend)\b")
FUNCTION = re.compile(r"(?<![\w:~])(\w+)\s*\(")
VARIABLE = re.compile(r"(\w+)\s*(\[[^\]]*\]\s*)*(=.*)?$", re.S)
MEMBER = re.compile(r"\)\s*(const|noexcept)\b")
TEMPLATE = re.compile(r"template\s*<[^<>]*>")
OPERATOR = re.compile(r"\boperator\b")
# Macros of GoogleTest, which look like functions.
SHARED = re.compile(r"(TYPED_)?TEST(_\w+)?$|\w*INSTANTIATE_\w+$|MATCHER\w*$")


def bare(code):
    """The code without comments, texts and characters."""
    return TEXT.sub(lambda found: " " if found[0][0] == "/" else "0", code)


def statements(code, begin):
    """The statements of the namespace that begins there, without the bodies of
    functions and classes."""
    depth, outer, at = 1, [], begin
    for brace in BRACE.finditer(code, begin):
        if depth == 1:
            outer.append(code[at:brace.start()])
        depth += 1 if brace[0] == "{" else -1
        at = brace.end()
        if depth == 0:
            break
    return ";".join(outer).split(";")


class Names:
    """Functions, and all else that has a name."""

    def __init__(self, functions=(), others=()):
        self.functions, self.others = set(functions), set(others)

    def add(self, names):
        self.functions |= names.functions
        self.others |= names.others

    def all(self):
        return self.functions | self.others


def declared(statement):
    """The names that a statement of a namespace declares."""
    statement = TEMPLATE.sub("", statement)
    kind = TYPE.search(statement) or ALIAS.search(statement)
    if kind:
        return Names(others=[kind[1]])
    if NOTHING_NEW.match(statement):
        return Names()
    if OPERATOR.search(statement):
        return Names(others=["operator"])
    names = Names(functions=FUNCTION.findall(statement))
    variable = VARIABLE.search(statement.strip())
    if variable and not MEMBER.search(statement):
        names.others.add(variable[1])
    return names


def names_in(kind, code):
    """What the namespaces of this kind declare."""
    names = Names()
    for namespace in kind.finditer(code):
        for statement in statements(code, namespace.end()):
            names.add(declared(statement))
    return names


@cache
def included(path):
    """The headers that a header includes itself."""
    header = ROOT / path
    return INCLUDE.findall(header.read_text("utf-8")) if header.exists() else []


def with_theirs(headers):
    """The headers and all that they include."""
    found, waiting = set(), list(headers)
    while waiting:
        header = waiting.pop()
        if header not in found:
            found.add(header)
            waiting += included(header)
    return found


@cache
def header_names(path):
    """What the header declares for all. A class hides what is outside of it by what
    it declares itself."""
    if not (ROOT / path).exists():
        return set()
    code = bare((ROOT / path).read_text("utf-8"))
    return names_in(NAMESPACE, code).all()


def own_names(code):
    """What the source keeps to itself."""
    names = names_in(UNNAMED, code)
    names.others.update(MACRO.findall(code))
    names.others.update(name for name in OPENED.findall(code)
                        if not name.endswith("literals"))
    names.functions = {name for name in names.functions
                       if not SHARED.match(name)}
    return names


class Piece:
    """Sources, what they keep to themselves, and what they mention and call."""

    def __init__(self, source, own, words, calls, is_alone):
        self.sources = [source]
        self.own, self.words, self.calls = own, words, calls
        self.is_alone = is_alone

    def add(self, other):
        self.sources += other.sources
        self.own.add(other.own)
        self.words |= other.words
        self.calls |= other.calls

    def hides_from(self, other):
        return (self.own.others.isdisjoint(other.words)
                and self.own.functions.isdisjoint(other.calls))

    def takes(self, other, limit):
        return (not self.is_alone and not other.is_alone
                and len(self.sources) + len(other.sources) <= limit
                and self.hides_from(other) and other.hides_from(self))


def joined(pieces, limit):
    """Each piece is added to the first before it that takes it."""
    result = []
    for piece in pieces:
        for earlier in result:
            if earlier.takes(piece, limit):
                earlier.add(piece)
                break
        else:
            result.append(piece)
    return result


def read(source):
    text = Path(source).read_text("utf-8")
    code = bare(text)
    own = own_names(code)
    headers = with_theirs(INCLUDE.findall(text))
    known = own.all().union(*map(header_names, headers))
    return Piece(source, own,
                 known.union(WORD.findall(code), OPENED.findall(code)),
                 known.union(CALL.findall(code), TYPE.findall(code)),
                 is_alone=OPENED_ENUM.search(code) is not None)


def united(sources, limit):
    """The pieces: first of each folder by itself, so that a change in one
    folder rarely changes the pieces of others; then what is left of them."""
    folders = {}
    for source in sources:
        folders.setdefault(Path(source).parent, []).append(read(source))
    return joined([piece for pieces in folders.values()
                   for piece in joined(pieces, limit)], limit)


def targets(lines):
    """The sources of each target."""
    found = {}
    for line in lines:
        target, source = line.split(" ", 1)
        found.setdefault(target, []).append(source)
    return found


def choice(lines, limit):
    """What is printed for these lines of the list."""
    return [f"{target} {number} {source}"
            for target, sources in targets(lines).items()
            for number, piece in enumerate(united(sources, limit))
            for source in piece.sources if len(piece.sources) > 1]


if __name__ == "__main__":
    listed = Path(sys.argv[2]).read_text("utf-8").splitlines()
    print("\n".join(choice(listed, int(sys.argv[1]))))
