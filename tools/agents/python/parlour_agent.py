"""An agent of the dialogue platform Parlour: a robot, a sensor or any other
program that takes part in conversations from a process of its own.

    from parlour_agent import Agent

    robot = Agent("Robot", "lines://127.0.0.1:5671")

    @robot.on("Goto")
    def go(message):
        drive_to(message.parameters[0])
        robot.answer(message, "Arrived", message.parameters[0])

    robot.run()

This file is all that an agent needs. It speaks both transports of the
platform: `lines://host:port` needs nothing but Python, `zmq://host:port` needs
pyzmq (Debian: python3-zmq). The protocol is adapters/agents/PROTOCOL.md.

Nothing that an agent sends is lost and nothing arrives twice while both
processes live, however often the connection breaks; the agent connects again
by itself. With a store that holds across a crash of the agent, too. Handlers are called one after the other, on a thread of their own:
they may take their time, fire events and ask.
"""

import collections
import dataclasses
import itertools
import json
import logging
import os
import queue
import re
import secrets
import selectors
import socket
import ssl
import threading
import time
import zlib

try:
    import fcntl
except ImportError:  # not on this system: nothing locks a store there
    fcntl = None

MAX_MESSAGE_BYTES = 1 << 20
MAX_PARAMETERS = 64
MAX_ATTRIBUTE_BYTES = 1024
# Escapes and doubled quotation marks make a line longer than its message.
MAX_LINE_BYTES = 2 * MAX_MESSAGE_BYTES + 2 * MAX_ATTRIBUTE_BYTES
MAX_MALFORMED = 10  # in a row
MAX_NUMBER = (1 << 63) - 1
NEVER_MS = 1 << 30  # 12 days: longer than any connection waits
NEWEST_VERSION = OLDEST_VERSION = 1  # of the protocol, that this file speaks
KINDS = ("text", "binary", "hello", "welcome", "ack", "beat", "error", "bye")
PROTOCOL = b"parlour/1"
NUMBERS = {"n": "number", "a": "acknowledged", "w": "window",
           "c": "correlation", "d": "deadline"}
ATTRIBUTE_CHARACTERS = frozenset(
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.:")
CLOSING = ("oversized", "version", "identity", "replaced", "flood")
_log = logging.getLogger("parlour_agent")


# -- messages (PROTOCOL 1) ----------------------------------------------------

class WireError(Exception):
    """What is wrong with a message; `kind` as in PROTOCOL 5. Who `loses_track`
    cannot tell what follows from the rest of this message."""

    def __init__(self, kind, sentence, loses_track=False):
        super().__init__(sentence)
        self.kind = kind
        self.loses_track = loses_track

    @property
    def closes(self):
        """Whether the connection ends with it."""
        return self.loses_track or self.kind in CLOSING


@dataclasses.dataclass
class Payload:
    """Bytes that travel with a message; their place among the parameters."""
    format: str = ""
    bytes: bytes = b""
    position: int = None


@dataclasses.dataclass
class Message:
    """What an agent and the platform say to each other."""
    kind: str = "text"
    session: str = ""
    sinks: list = dataclasses.field(default_factory=list)
    number: int = None
    acknowledged: int = None
    window: int = None
    correlation: int = None
    deadline: int = None  # milliseconds
    gap: bool = False
    time: int = None  # milliseconds since 1970
    component: str = ""
    command: str = ""
    parameters: list = dataclasses.field(default_factory=list)  # texts
    payload: Payload = None

    def values(self):
        """The parameters as Python values: JSON ones are decoded."""
        return [value_of(parameter) for parameter in self.parameters]


def parameter_of(value):
    """A value as a parameter: texts as they are, all else as JSON."""
    if isinstance(value, str) and not value.startswith("\x01"):
        return value
    return "\x01J" + json.dumps(value, ensure_ascii=False, allow_nan=False,
                                separators=(",", ":"))


def value_of(parameter):
    """The value of a parameter."""
    if not parameter.startswith("\x01J"):
        return parameter
    return json.loads(parameter[2:])


def number_of(text, what):
    """A number of PROTOCOL 1.3."""
    digits = text.lstrip("0") or "0" if text else ""
    if not (digits.isascii() and digits.isdigit()) or len(digits) > 19 \
            or int(digits) > MAX_NUMBER:
        raise WireError("malformed", f"{what} is no number: '{text[:32]}'")
    return int(digits)


def _attributes(message):
    head = message.kind
    if message.session:
        head += ";s=" + _checked(message.session)
    for sink in message.sinks:
        head += ";k=" + _checked(sink)
    for letter, name in NUMBERS.items():
        number = getattr(message, name)
        if number is not None:
            head += f";{letter}={number}"
    if message.payload and message.payload.position is not None:
        head += f";p={message.payload.position}"
    if message.gap:
        head += ";g=1"
    if len(head) > MAX_ATTRIBUTE_BYTES:
        raise WireError("oversized", "too many attributes")
    return head


def _checked(value):
    if not value or not ATTRIBUTE_CHARACTERS.issuperset(value):
        raise WireError("malformed",
                        f"'{value}' holds what an attribute cannot hold")
    return value


def fields_of(message):
    """All fields but the payload's bytes."""
    if len(message.parameters) > MAX_PARAMETERS:
        raise WireError("oversized", "too many parameters")
    fields = [_attributes(message),
              "" if message.time is None else str(message.time),
              message.component, message.command, *message.parameters]
    if message.payload:
        fields.append(message.payload.format)
    elif not message.parameters:
        while len(fields) > 1 and not fields[-1]:
            fields.pop()
    _check_size(fields, len(message.payload.bytes) if message.payload else 0)
    return fields


def _check_size(fields, payload_bytes):
    size = sum(len(field.encode()) for field in fields) + payload_bytes
    if size > MAX_MESSAGE_BYTES:
        raise WireError("oversized", "the message is too long")


def check_writable(message):
    """Raises where a message could never be written: it would hold up all that
    is behind it. Its numbers are given later, and as long as they can be."""
    fields_of(dataclasses.replace(message, number=MAX_NUMBER,
                                  acknowledged=MAX_NUMBER))


def message_of(fields, payload=b""):
    """The message of these fields; trusts nothing."""
    message = Message()
    position = _read_head(fields[0], message)
    if len(fields) > 1 and fields[1]:
        message.time = number_of(fields[1], "the time")
    message.component = fields[2] if len(fields) > 2 else ""
    message.command = fields[3] if len(fields) > 3 else ""
    message.parameters = list(fields[4:])
    if message.kind == "binary":
        if not message.parameters:
            raise WireError("malformed",
                            "a binary message has its payload's format")
        message.payload = Payload(message.parameters.pop(), payload, position)
        if position is not None and position > len(message.parameters):
            raise WireError("malformed", "the payload's position is beyond "
                                         "the parameters")
    if len(message.parameters) > MAX_PARAMETERS:
        raise WireError("oversized", "too many parameters")
    _check_size(fields[2:], len(payload))
    return message


def _read_head(field, message):
    if len(field.encode()) > MAX_ATTRIBUTE_BYTES:
        raise WireError("oversized", "too many attributes")
    kind, *attributes = field.split(";")
    if kind not in KINDS:
        raise WireError("unknown", f"there is no kind '{kind[:32]}'")
    message.kind = kind
    position = None
    seen = set()
    for attribute in attributes:
        letter, value = attribute[:1], attribute[2:]
        if attribute[1:2] != "=":
            raise WireError("malformed", "an attribute is letter=value, not "
                                         f"'{attribute[:32]}'")
        _checked(value)
        if letter == "k":
            message.sinks.append(value)
            continue
        if letter in seen:
            raise WireError("malformed", f"{letter} occurs twice")
        seen.add(letter)
        if letter == "s":
            message.session = value
        elif letter == "g":
            message.gap = value == "1"
        elif letter == "p":
            position = number_of(value, "p")
        elif letter in NUMBERS:
            setattr(message, NUMBERS[letter], number_of(value, letter))
    return position


# -- lines (PROTOCOL 2.1, 2.2) ------------------------------------------------

_ESCAPES = {"n": "\n", "r": "\r", "\\": "\\"}


def _field_text(field):
    quoted = ("," in field or '"' in field
              or field[:1] in (" ", "\t") or field[-1:] in (" ", "\t"))
    text = field.replace("\\", "\\\\").replace("\n", "\\n") \
                .replace("\r", "\\r").replace('"', '""')
    return f'"{text}"' if quoted else text


def line_of(message):
    """The bytes of a message's line, its end and its payload."""
    fields = [_field_text(field) for field in fields_of(message)]
    if not message.payload:
        return (",".join(fields) + "\n").encode()
    fields.append(str(len(message.payload.bytes)))
    return (",".join(fields) + "\n").encode() + message.payload.bytes


def _unescaped(text):
    if "\\" not in text:
        return text
    plain, rest = "", iter(text)
    for character in rest:
        if character == "\\":
            escaped = next(rest, "")
            if escaped not in _ESCAPES:
                raise WireError("malformed", "a backslash is followed by n, r "
                                             "or a backslash")
            character = _ESCAPES[escaped]
        plain += character
    return plain


def _fields_in(line):
    fields, at = [], 0
    while True:
        if line.startswith('"', at):
            end = at + 1
            while True:
                end = line.find('"', end)
                if end < 0:
                    raise WireError("malformed",
                                    "a quotation mark is not closed")
                if line[end + 1:end + 2] != '"':
                    break
                end += 2
            field, at = line[at + 1:end].replace('""', '"'), end + 1
            if at < len(line) and line[at] != ",":
                raise WireError("malformed", "a comma must follow a closing "
                                             "quotation mark")
        else:
            end = line.find(",", at)
            end = len(line) if end < 0 else end
            field, at = line[at:end], end
            if '"' in field:
                raise WireError("malformed", "a quotation mark stands within "
                                             "a field")
        fields.append(_unescaped(field))
        if len(fields) > MAX_PARAMETERS + 6:
            raise WireError("oversized", "too many fields")
        if at >= len(line):
            return fields
        at += 1


class LineReader:
    """Bytes as they arrive, to messages; trusts nothing."""

    def __init__(self):
        self._held = bytearray()
        self._scanned = 0  # no line ends before it
        self._fields = None  # of a message whose payload is to come
        self._wanted = 0

    def add(self, data):
        self._held += data

    def next(self):
        """The next message, or None where more bytes are needed. Raises a
        WireError for what cannot be read, and goes on behind it unless the
        error closes the connection."""
        while True:
            if self._fields is not None:
                return self._payload()
            line = self._line()
            if line is None:
                return None
            line = line.removesuffix(b"\r")
            if not line:
                continue
            fields = self._fields_of(line)
            if fields is not None:
                return message_of(fields)

    def _fields_of(self, line):
        """None where a payload is awaited. Without its length (PROTOCOL 2.2)
        its bytes would be read as lines."""
        try:
            fields = _fields_in(_text_of(line, "the line"))
            if not _is_binary(fields[0]):
                return fields
            self._wanted = number_of(fields.pop(), "a payload's length")
        except WireError as error:
            head = re.split(b'[,"]', line.removeprefix(b'"'), maxsplit=1)[0]
            error.loses_track = _is_binary(head.decode(errors="replace"))
            raise
        if self._wanted > MAX_MESSAGE_BYTES:
            raise WireError("oversized", "the payload is too long")
        self._fields = fields
        return None

    def _line(self):
        end = self._held.find(b"\n", self._scanned)
        if (len(self._held) if end < 0 else end) > MAX_LINE_BYTES:
            raise WireError("oversized", "the line is too long")
        self._scanned = len(self._held) if end < 0 else 0
        return None if end < 0 else self._take(end + 1)[:-1]

    def _payload(self):
        """A malformed message's payload is taken, too: it is no line."""
        if len(self._held) < self._wanted:
            return None
        fields, self._fields = self._fields, None
        return message_of(fields, self._take(self._wanted))

    def _take(self, size):
        taken = bytes(self._held[:size])
        del self._held[:size]
        return taken


def _is_binary(head):
    return head == "binary" or head.startswith("binary;")


def _text_of(data, what):
    try:
        return data.decode()
    except UnicodeDecodeError:
        raise WireError("malformed", f"{what} is not UTF-8") from None


# -- frames (PROTOCOL 2.3) ----------------------------------------------------

def frames_of(message):
    """The frames of a message, as bytes."""
    frames = [PROTOCOL, *(field.encode() for field in fields_of(message))]
    if message.payload:
        frames.append(message.payload.bytes)
    return frames


def read_frames(frames):
    """The message of these frames; trusts nothing."""
    if not frames or frames[0] != PROTOCOL:
        raise WireError("version", "the first frame is not parlour/1")
    fields, payload = list(frames[1:]), b""
    if not fields:
        raise WireError("malformed", "the message has no fields")
    if len(fields) > 1 and _is_binary(fields[0].decode(errors="replace")):
        payload = fields.pop()
    return message_of([_text_of(field, "a field") for field in fields],
                      payload)


# -- what outlives the process (PROTOCOL 4.9) ---------------------------------

class Store:
    """What an agent must not forget when its process dies, in a file: a
    snapshot, then a line for each change. A line is written at once, and what
    a killed process has left of its last line does not count. The lines
    outlive the process, not a failure of the computer. One process at a time
    can have a store. Raises OSError where the file cannot be used."""

    MAX_BYTES = 16 << 20  # of changes: then it begins anew

    def __init__(self, path):
        self._path = os.fspath(path)
        self._lock = open(self._path + ".lock", "w", encoding="ascii")
        try:
            if fcntl is not None:
                fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            self._lock.close()
            raise BlockingIOError(
                f"another process uses the store {self._path}") from error
        self._file = None  # not before begin()
        self._size = 0

    def load(self):
        """The snapshot and the changes since, as dictionaries; [] where there
        is no file yet. Raises ValueError."""
        try:
            with open(self._path, "rb") as file:
                *lines, rest = file.read().split(b"\n")
        except FileNotFoundError:
            return []
        found = [self._read(line, at) for at, line in enumerate(lines, 1)]
        if not found:
            raise ValueError(f"{self._path} is no store: '{rest[:32]!r}'")
        return found

    def _read(self, line, at):
        check, _, text = line.partition(b" ")
        if check != self._check(text):
            raise ValueError(f"{self._path}:{at}: the store is damaged. "
                             "Remove it, and the agent begins afresh")
        return json.loads(text)

    @staticmethod
    def _check(text):
        return b"%08x" % zlib.crc32(text)

    def _line(self, change):
        text = json.dumps(change, separators=(",", ":")).encode()
        return self._check(text) + b" " + text + b"\n"

    def begin(self, snapshot):
        """Replaces all that was written."""
        beside = self._path + "~"
        with open(beside, "wb", buffering=0) as file:
            file.write(self._line(snapshot))
        os.replace(beside, self._path)
        if self._file is not None:
            self._file.close()
        self._file = open(self._path, "ab", buffering=0)
        self._size = 0

    def add(self, change):
        """False: it has grown long and wants to begin anew."""
        line = self._line(change)
        self._size += self._file.write(line)
        return self._size < self.MAX_BYTES

    def close(self):
        if self._file is not None:
            self._file.close()
        self._lock.close()


def _stored(message):
    return line_of(message).decode("latin-1")


def _restored(text):
    reader = LineReader()
    reader.add(text.encode("latin-1"))
    return reader.next()


# -- delivery (PROTOCOL 4) ----------------------------------------------------

class Link:
    """One side of the promise that nothing is lost and nothing arrives twice.
    It outlives connections, and with a store its process. Knows no socket and
    no clock; times are seconds."""

    WINDOW = 100
    MAX_WAITING = 1000
    MAX_WAITING_BYTES = 4 << 20
    ACK_AFTER = 0.05  # and told within 0.05 more
    BEAT_AFTER = 1.0
    OFFLINE_AFTER = 3.0

    def __init__(self, incarnation, store=None):
        self.incarnation = incarnation
        # Not from 1: an answer to an earlier process must not answer this one.
        self.first_correlation = 1 + secrets.randbelow(1 << 47)
        self.last_correlation = self.first_correlation - 1
        self._store = store
        self.connected = False
        self._peer = ""
        self._peer_window = self.WINDOW
        self._outbox = collections.deque()  # messages after _acknowledged
        self._outbox_bytes = 0
        self._sent = 0  # of the outbox, on this connection
        self._acknowledged = 0
        self._last_sent = 0  # of this numbering, on whichever connection
        self._received = 0
        self._handed_on = 0
        self._pending = {}  # after _handed_on; None where it is handed on
        self._told = 0
        self._gap = False
        self._gap_is_told = False
        self._heard = self._said = self._since = 0.0
        self._number_said = 0.0  # when the peer was told of the last number
        if store is not None:
            self._restore(store.load())

    # What was kept may have been sent, and what was sent may have arrived.
    def _restore(self, changes):
        for change in changes:
            if "incarnation" in change:
                self.incarnation = change["incarnation"]
                self._peer = change["peer"]
                self.first_correlation = change["first_correlation"]
                self.last_correlation = change["last_correlation"]
                self._acknowledged = change["acknowledged"]
            for message in map(_restored, change["sent"]):
                self._outbox_bytes += self._weight(message)
                self._outbox.append(message)
                if message.sinks:
                    self.last_correlation = max(self.last_correlation,
                                                message.correlation or 0)
            self._last_sent = self._acknowledged + len(self._outbox)
            self._acknowledge(change["acknowledged"])
            self._received = self._handed_on = change["handled"]
        self._told = self._handed_on
        self._keep_all()

    def _keep_all(self):
        if self._store is not None:
            self._store.begin({
                "incarnation": self.incarnation, "peer": self._peer,
                "first_correlation": self.first_correlation,
                "last_correlation": self.last_correlation,
                "acknowledged": self._acknowledged,
                "handled": self._handed_on,
                "sent": [_stored(message) for message in self._outbox]})

    def _keep(self, sent=()):
        """Before any of it is told to the peer."""
        if self._store is not None and not self._store.add({
                "acknowledged": self._acknowledged,
                "handled": self._handed_on,
                "sent": [_stored(message) for message in sent]}):
            self._keep_all()

    def introduction(self):
        """What this side's hello says, as parameters."""
        said = [f"incarnation={self.incarnation}", f"window={self.WINDOW}"]
        if self._peer:
            said.append(f"seen={self._peer}:{self._handed_on}")
        return said

    def connect(self, parameters, now):
        """The other side's hello or welcome has arrived. False: it has
        received more than this side knows to have sent, whose store is too
        old; hello is to be said again, in another incarnation. Raises a
        WireError."""
        said = dict(parameter.partition("=")[::2] for parameter in parameters)
        window = number_of(said.get("window", str(self.WINDOW)), "window")
        seen, _, number = said.get("seen", "").partition(":")
        number = number_of(number, "seen") if seen else 0
        peer = said.get("incarnation", "")
        if seen == self.incarnation and number > self._last_sent:
            self.incarnation, self._peer = secrets.token_hex(8), ""
            self._begin_afresh()
            self._keep_all()
            return False
        # Who has forgotten this side, or what it acknowledged, begins afresh.
        same = bool(peer) and peer == self._peer \
            and seen == self.incarnation \
            and self._acknowledged <= number <= self._last_sent
        if not same:
            self._begin_afresh()
        self._peer = peer
        self._peer_window = max(window, 1)
        self._sent = 0
        if same:
            self._acknowledge(number)
        else:
            self._keep_all()
        self.connected = True
        self._gap = self._gap_is_told = False
        self._heard = self._said = self._number_said = now
        return True

    def _begin_afresh(self):
        self._acknowledged = self._last_sent = 0
        self._received = self._handed_on = self._told = 0
        self._pending.clear()
        for number, message in enumerate(self._outbox, 1):
            message.number = number

    def disconnect(self):
        self.connected = False

    def send(self, message):
        """False where the outbox is full."""
        if not self._add([message]):
            return False
        self._keep([message])
        return True

    @classmethod
    def has_room(cls, messages, count=0, size=0):
        """In an outbox that holds so much already."""
        return count + len(messages) <= cls.MAX_WAITING and \
            size + sum(map(cls._weight, messages)) <= cls.MAX_WAITING_BYTES

    def _add(self, messages):
        if not self.has_room(messages, len(self._outbox), self._outbox_bytes):
            return False
        for message in messages:
            message.number = self._acknowledged + len(self._outbox) + 1
            self._outbox_bytes += self._weight(message)
            self._outbox.append(message)
        return True

    @property
    def waiting(self):
        """How many messages are not acknowledged yet."""
        return len(self._outbox)

    def heard(self, now):
        """Something has arrived, be it part of a message."""
        self._heard = now

    def receive(self, message, now):
        """True: the message is to be handed on, then handed_on() called.
        Raises a WireError."""
        self._heard = now
        if message.acknowledged is not None:
            self._take_acknowledgement(message)
        if message.kind in ("text", "binary"):
            return message.number is None or self._take_new(message, now)
        if message.kind == "beat" and message.number is not None:
            self._gap = self._gap or message.number > self._received
        return False

    def _take_new(self, message, now):
        """A withdrawn message counts, and means nothing else (PROTOCOL 4.8)."""
        if not self._take_numbered(message, now):
            return False
        if message.command:
            return True
        self.handed_on(message)
        return False

    def handed_on(self, message, said=()):
        """The message is with its receiver, who has said this: both is kept at
        once. False where the outbox is full."""
        if not self._add(said):
            return False
        before = self._handed_on
        self._mark(message)
        if said or self._handed_on != before:
            self._keep(said)
        return True

    def _mark(self, message):
        """What was received before a process at the other end was replaced
        counts no more."""
        if message.number is None or \
                self._pending.get(message.number) is not message:
            return
        self._pending[message.number] = None
        while self._pending.get(self._handed_on + 1, self) is None:
            self._handed_on += 1
            del self._pending[self._handed_on]

    def output(self, now):
        """What is to be written now, in this order."""
        if not self.connected:
            return []
        out = []
        while self._sent < min(len(self._outbox), self._peer_window):
            out.append(self._with_acknowledgement(self._outbox[self._sent]))
            self._sent += 1
        self._last_sent = max(self._last_sent,
                              self._acknowledged + self._sent)
        if out:
            self._number_said = now
        if self._gap or self._ack_is_due(now):
            out.append(self._own_ack())
        if self._beat_is_due(out, now):
            out.append(self._with_acknowledgement(Message(
                "beat", number=self._acknowledged + self._sent or None)))
            self._number_said = now
        if out:
            self._said = now
        return out

    def farewell(self):
        """What this side says last."""
        return [self._own_ack(), Message("bye")]

    def alive(self, now):
        """False: the other side was silent for too long."""
        return not self.connected or now - self._heard < self.OFFLINE_AFTER

    def _take_acknowledgement(self, message):
        if message.acknowledged > self._last_sent:
            raise WireError("malformed", "acknowledges what was never sent")
        self._acknowledge(message.acknowledged)
        if message.window is not None:
            self._peer_window = max(message.window, 1)
        if message.gap:
            self._sent = 0  # from the first that is missing

    def _take_numbered(self, message, now):
        number = message.number
        if number <= self._received:  # the acknowledgement may have been lost
            self._told = max(min(self._told, number - 1), 0)
            return False
        if number > self._handed_on + self.WINDOW:
            raise WireError("flood", "more messages came than the window "
                                     "allows")
        if number != self._received + 1:
            self._gap = self._gap or not self._gap_is_told
            self._gap_is_told = True
            return False
        self._gap_is_told = False
        self._received = number
        self._pending[number] = message
        if self._handed_on == self._told:
            self._since = now
        return True

    def _acknowledge(self, number):
        while self._acknowledged < number and self._outbox:
            self._outbox_bytes -= self._weight(self._outbox.popleft())
            self._acknowledged += 1
            self._sent = max(self._sent - 1, 0)

    def _ack_is_due(self, now):
        behind = self._handed_on - self._told
        return behind >= self.WINDOW // 2 or \
            behind > 0 and now - self._since >= self.ACK_AFTER

    def _beat_is_due(self, out, now):
        """Also where acknowledgements alone are said: they do not tell the
        last number, so that the loss of the last message would not be
        noticed."""
        return not out and now - self._said >= self.BEAT_AFTER or \
            self._sent > 0 and now - self._number_said >= self.BEAT_AFTER

    def _own_ack(self):
        own = self._with_acknowledgement(Message("ack", gap=self._gap))
        own.acknowledged = self._handed_on  # also 0: nothing has arrived
        self._gap = False
        return own

    def _with_acknowledgement(self, message):
        message = dataclasses.replace(message)
        if self._handed_on:
            message.acknowledged = self._handed_on
        self._told = self._handed_on
        return message

    @staticmethod
    def _weight(message):
        texts = [message.component, message.command, *message.parameters]
        size = sum(len(text.encode()) for text in texts)
        return size + (len(message.payload.bytes) if message.payload else 0)


# -- transports ---------------------------------------------------------------

class _Lines:
    """A connection that carries lines. Reads and writes without waiting."""

    tells_of_bytes = True  # its socket is readable only where bytes came
    READS = 16  # at once, so that writing has its turn

    def __init__(self, host, port, tls, deadline):
        self.socket = socket.create_connection((host, port), deadline)
        try:
            if tls is not None:
                self.socket = tls.wrap_socket(self.socket,
                                              server_hostname=host)
            self.socket.setblocking(False)
            self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        except BaseException:
            self.socket.close()
            raise
        self._reader = LineReader()
        self._unsent = bytearray()

    def write(self, message):
        self._unsent += line_of(message)
        self.flush()

    def flush(self):
        """Raises ConnectionError where the connection is gone."""
        while self._unsent:
            try:
                sent = self.socket.send(self._unsent)
            except (BlockingIOError, ssl.SSLWantReadError,
                    ssl.SSLWantWriteError):
                return
            except OSError as error:
                raise ConnectionError(str(error)) from error
            del self._unsent[:sent]

    @property
    def wants_to_write(self):
        return bool(self._unsent)

    @property
    def is_congested(self):
        """What is not sent yet would only grow."""
        return len(self._unsent) > Link.MAX_WAITING_BYTES

    @property
    def has_more(self):
        return isinstance(self.socket, ssl.SSLSocket) and \
            self.socket.pending() > 0

    def read(self):
        """Yields what has arrived: messages and WireErrors."""
        for _ in range(self.READS):
            try:
                data = self.socket.recv(1 << 16)
            except (BlockingIOError, ssl.SSLWantReadError,
                    ssl.SSLWantWriteError):
                return
            except OSError as error:
                raise ConnectionError(str(error)) from error
            if not data:
                raise ConnectionError("the platform closed the connection")
            self._reader.add(data)
            while True:
                try:
                    message = self._reader.next()
                except WireError as error:
                    message = error
                if message is None:
                    break
                yield message

    def close(self):
        self.socket.close()


class _Frames:
    """A connection by ZeroMQ, with the same methods."""

    tells_of_bytes = False
    wants_to_write = is_congested = False

    def __init__(self, host, port, keys):
        import zmq  # only who connects this way needs it
        self._zmq = zmq
        self._dealer = zmq.Context.instance().socket(zmq.DEALER)
        try:
            self._dealer.linger = 500
            # By itself ZeroMQ would connect again without a hello. Told never
            # to (-1), it ends its pipe while a message is half read, and
            # aborts the process ("!_more").
            self._dealer.reconnect_ivl = NEVER_MS
            self._monitor = self._dealer.get_monitor_socket(
                zmq.EVENT_DISCONNECTED | zmq.EVENT_CLOSED)
            self._dealer.ipv6 = ":" in host
            if keys is not None:
                self._dealer.curve_publickey, self._dealer.curve_secretkey, \
                    self._dealer.curve_serverkey = \
                    (key.encode() for key in keys)
            host = f"[{host}]" if ":" in host else host
            self._dealer.connect(f"tcp://{host}:{port}")
        except zmq.ZMQError as error:
            self._dealer.close()
            raise ConnectionError(str(error)) from error
        self.socket = self._dealer.fd

    def write(self, message):
        try:
            self._dealer.send_multipart(frames_of(message),
                                        self._zmq.DONTWAIT)
        except self._zmq.Again:
            pass  # missed by the receiver, and sent again
        except self._zmq.ZMQError as error:
            raise ConnectionError(str(error)) from error

    def flush(self):
        pass

    @property
    def has_more(self):
        """Its descriptor tells only of changes."""
        return bool(self._dealer.events & self._zmq.POLLIN)

    def read(self):
        while self.has_more:
            try:
                frames = self._dealer.recv_multipart(self._zmq.DONTWAIT)
            except self._zmq.ZMQError as error:
                raise ConnectionError(str(error)) from error
            try:
                message = read_frames(frames)
            except WireError as error:
                message = error
            yield message
        if self._monitor.events & self._zmq.POLLIN:
            self._dealer.linger = 0  # what it says now means nothing
            raise ConnectionError("the connection was closed")

    def close(self):
        self._dealer.disable_monitor()
        self._monitor.close()
        self._dealer.close()


# -- the agent ----------------------------------------------------------------

class Refused(Exception):
    """A message was not sent, or a request ended without an answer: `kind` is
    Timeout, Offline or the command of an error."""

    def __init__(self, kind, sentence=""):
        super().__init__(sentence or kind)
        self.kind = kind


class Agent:
    """A remote agent.

    name       as the application's settings declare it
    address    "lines://host:port" or "zmq://host:port"
    roles      roles that it fills, for the platform's information
    token      its secret, for lines off loopback
    tls        an ssl.SSLContext for lines under TLS
    keys       (own public, own secret, platform's public) for ZeroMQ's CURVE
    store      the path of a file, for an agent that goes on after a crash: what
               a handler fires leaves with the record that it has ended, and a
               handler that was under way is called again with its message

    Methods may be called from any thread. Handlers run on the thread of run(),
    or on one that start() makes; the connection has a thread of its own. What
    goes wrong is told to the logger "parlour_agent".
    """

    RETRY_AFTER = 0.5
    CONNECT_WITHIN = 5.0
    WELCOME_WITHIN = 3.0
    STOP_WITHIN = 2.0

    def __init__(self, name, address, roles=(), token="", tls=None, keys=None,
                 store=None):
        self.name = name
        self._transport, _, place = address.partition("://")
        host, _, port = place.rpartition(":")
        if self._transport not in ("lines", "zmq") or not port.isdigit() \
                or not host:
            raise ValueError("an address is lines://host:port or "
                             f"zmq://host:port, not {address}")
        if self._transport == "zmq":
            import zmq  # noqa: F401 -- now rather than on another thread
        self._host, self._port = host.removeprefix("[").removesuffix("]"), \
            int(port)
        self._roles, self._token = tuple(roles), token
        self._tls, self._keys = tls, keys
        self._handlers = {}
        self._store = None if store is None else Store(store)
        self._link = Link(secrets.token_hex(8), self._store)
        self._online_at = time.monotonic()  # or when it began
        self._fires = None  # of the handler that is under way, with a store
        self._handling = None  # its thread
        self._changed = threading.Condition()  # guards _link and _ended
        self._ended = False
        self._messages = queue.SimpleQueue()  # for handlers; None at the end
        self._requests = {}
        self._correlations = itertools.count(self._link.last_correlation + 1)
        self._connection = None
        self._welcomed = False
        self._malformed = 0  # in a row
        self._over = threading.Event()
        self._stop_by = None
        self._refusal = None
        self._logged = {}
        self._threads = []
        self._wake_read, self._wake_write = socket.socketpair()
        self._wake_read.setblocking(False)
        self._wake_write.setblocking(False)
        self.online = threading.Event()

    # -- what an agent does ---------------------------------------------------

    def on(self, command):
        """A decorator: the function is called with each message of this
        command; "*" for those that have no function of their own."""
        def remember(function):
            self._handlers[command] = function
            return function
        return remember

    def fire(self, command, *values, session="", correlation=None):
        """An event. Waits while too much is unacknowledged, so that nothing
        is lost."""
        self._send(Message(component=self.name, command=command,
                           session=session, correlation=correlation), values)

    def answer(self, message, command, *values):
        """An event that answers a message: of its session and correlation."""
        self.fire(command, *values, session=message.session,
                  correlation=message.correlation)

    def request(self, sink, command, *values, session="", timeout=5.0):
        """Asks another component. Returns its answer, a Message, or raises
        Refused."""
        end = time.monotonic() + timeout
        answers = queue.SimpleQueue()
        correlation = next(self._correlations)
        self._requests[correlation] = answers
        try:
            self._send(Message(component=self.name, command=command,
                               session=session, sinks=[sink],
                               correlation=correlation,
                               deadline=int(timeout * 1000)), values, end)
            answer = answers.get(timeout=max(end - time.monotonic(), 0))
        except queue.Empty:
            raise Refused("Timeout") from None
        finally:
            self._requests.pop(correlation, None)
        if isinstance(answer, Refused):
            raise answer
        return answer

    def start(self):
        """Runs on threads of its own."""
        self._start(self._work)
        self._start(self._handle)
        return self

    def run(self):
        """Calls the handlers on this thread until stop(). Raises Refused where
        the platform will not have this agent."""
        self._start(self._work)
        try:
            self._handle()
        finally:
            self.stop()
        if self._refusal:
            raise self._refusal

    def stop(self):
        """Says goodbye once all is acknowledged, after two seconds at most."""
        self._over.set()
        self._wake()
        for thread in self._threads:
            if thread is not threading.current_thread():
                thread.join(self.CONNECT_WITHIN)

    # -- what leaves ----------------------------------------------------------

    def _send(self, message, values, end=None):
        for value in values:
            self._add(message, value, len(values))
        check_writable(message)
        if end is None and self._fires is not None and \
                threading.current_thread() is self._handling:
            self._fire_later(message)
            return
        with self._changed:
            while self._ended or not self._link.send(message):
                if self._ended:
                    raise Refused("Offline", "the agent was stopped")
                left = None if end is None else end - time.monotonic()
                if left is not None and left <= 0:
                    raise Refused("Timeout", "too much is unacknowledged")
                self._changed.wait(left)
        self._wake()

    def _fire_later(self, message):
        """With what else the handler fires, all of which waits at once."""
        if not Link.has_room([*self._fires, message]):
            raise Refused("Limit", "a handler has fired too much")
        self._fires.append(message)

    @staticmethod
    def _add(message, value, count):
        if not isinstance(value, Payload):
            message.parameters.append(parameter_of(value))
            return
        if message.payload:
            raise ValueError("a message has at most one payload")
        place = len(message.parameters)
        message.kind = "binary"
        message.payload = dataclasses.replace(
            value, position=place if place < count - 1 else None)

    def _wake(self):
        try:
            self._wake_write.send(b"!")
        except OSError:
            pass  # it is awake, or over

    # -- the connection's thread ----------------------------------------------

    def _start(self, work):
        thread = threading.Thread(target=work, daemon=True)
        self._threads.append(thread)
        thread.start()

    def _work(self):
        try:
            while not self._is_over():
                try:
                    self._connect()
                    while not self._is_over():
                        self._turn()
                except OSError as error:  # a ConnectionError is one
                    self._say("lost", f"{self.name} is not connected: {error}")
                    self._disconnect()
                    self._pause()
            self._say_goodbye()
        finally:
            self._end()

    def _is_over(self):
        if not self._over.is_set():
            return False
        now = time.monotonic()
        if self._stop_by is None:
            self._stop_by = now + self.STOP_WITHIN
        return now >= self._stop_by or not self._link.waiting

    def _pause(self):
        if self._over.wait(self.RETRY_AFTER) and not self._is_over():
            time.sleep(self.RETRY_AFTER / 5)

    def _connect(self):
        self._connection = (
            _Lines(self._host, self._port, self._tls, self.CONNECT_WITHIN)
            if self._transport == "lines"
            else _Frames(self._host, self._port, self._keys))
        with self._changed:
            parameters = [f"version={NEWEST_VERSION}",
                          f"oldest={OLDEST_VERSION}",
                          *self._link.introduction(), "json=1"]
        if self._roles:
            parameters.append("roles=" + " ".join(self._roles))
        if self._token:
            parameters.append("token=" + self._token)
        self._connection.write(Message("hello", component=self.name,
                                       command="Hello",
                                       parameters=parameters))
        self._said_hello = time.monotonic()

    def _disconnect(self):
        if self._connection:
            self._connection.close()
            self._connection = None
        self._welcomed = False
        self._malformed = 0
        self.online.clear()
        with self._changed:
            if self._link.connected:
                self._online_at = time.monotonic()
            self._link.disconnect()
        # Who returns soon still gets the answers.
        if self._ended or \
                time.monotonic() - self._online_at >= Link.OFFLINE_AFTER:
            for answers in list(self._requests.values()):
                answers.put(Refused("Offline"))

    def _say_goodbye(self):
        if not self._welcomed:
            return
        try:
            for message in self._link.farewell():
                self._connection.write(message)
        except ConnectionError:
            pass  # it is gone already

    def _end(self):
        with self._changed:
            self._ended = True
            self._changed.notify_all()
        self._disconnect()
        self._messages.put(None)
        self._wake_read.close()
        self._wake_write.close()

    def _turn(self):
        """Waits for something to happen, at most 50 ms, and deals with it."""
        came = self._wait(0 if self._connection.has_more else 0.05)
        now = time.monotonic()
        if came and self._connection.tells_of_bytes:
            with self._changed:
                self._link.heard(now)
        for message in self._connection.read():
            self._arrived(message)
        self._flush()
        if not self._link.alive(now) or not self._welcomed and \
                now - self._said_hello >= self.WELCOME_WITHIN:
            raise ConnectionError("the platform is silent")

    def _wait(self, seconds):
        """Whether the connection has become readable."""
        with selectors.DefaultSelector() as selector:
            events = selectors.EVENT_READ
            if self._connection.wants_to_write:
                events |= selectors.EVENT_WRITE
            connection = selector.register(self._connection.socket, events)
            selector.register(self._wake_read, selectors.EVENT_READ)
            ready = selector.select(seconds)
        try:
            self._wake_read.recv(4096)
        except BlockingIOError:
            pass
        return (connection.fd, selectors.EVENT_READ) in \
            [(key.fd, events & selectors.EVENT_READ) for key, events in ready]

    def _flush(self):
        self._connection.flush()
        if self._connection.is_congested:
            return
        with self._changed:
            output = self._link.output(time.monotonic())
        for message in output:
            self._connection.write(message)

    # -- what arrives ---------------------------------------------------------

    def _arrived(self, message):
        try:
            if isinstance(message, WireError):
                raise message
            self._take(message)
            self._malformed = 0
        except WireError as error:
            self._tell(error)

    def _tell(self, error):
        """PROTOCOL 5. Nobody is told before the welcome."""
        self._say(error.kind, f"{self.name} cannot take a message: {error}")
        if self._welcomed:
            self._connection.write(Message(
                "error", component=self.name, command=error.kind,
                parameters=[str(error)]))
        self._malformed += 1
        if error.closes or self._malformed >= MAX_MALFORMED:
            raise ConnectionError(str(error))

    def _take(self, message):
        if message.kind == "welcome":
            self._check_version(message)
            with self._changed:
                if not self._link.connect(message.parameters,
                                          time.monotonic()):
                    raise ConnectionError("the platform knows of messages "
                                          "that were never sent")
                self._changed.notify_all()
            self._welcomed = True
            self.online.set()
        elif message.kind == "bye":
            raise ConnectionError("the platform said goodbye")
        elif message.kind == "error":
            self._take_error(message)
        elif self._welcomed:
            with self._changed:
                deliver = self._link.receive(message, time.monotonic())
                self._changed.notify_all()
            if deliver:
                self._hand_on(message)

    def _check_version(self, welcome):
        """PROTOCOL 3.2: to connect again would help nobody."""
        said = dict(parameter.partition("=")[::2]
                    for parameter in welcome.parameters)
        version = number_of(said.get("version", "1"), "version")
        if OLDEST_VERSION <= version <= NEWEST_VERSION:
            return
        sentence = f"the agent speaks versions {OLDEST_VERSION} to " \
            f"{NEWEST_VERSION}, and the platform welcomes it in " \
            f"version {version}"
        self._welcomed = True  # so that it is told
        self._end_for_good("version", sentence)
        raise WireError("version", sentence)

    def _end_for_good(self, kind, sentence):
        self._refusal = Refused(kind, sentence)
        self._stop_by = 0.0  # to connect again would help nobody
        self._over.set()

    def _take_error(self, message):
        kind, sentence = message.command, " ".join(message.parameters)
        answers = self._requests.get(message.correlation)
        if answers:
            answers.put(Refused(kind, sentence))
            return
        self._say(kind, f"the platform refuses {self.name}: {kind}: "
                        f"{sentence}")
        if kind in ("identity", "version", "replaced"):
            self._end_for_good(kind, sentence)
        if kind in CLOSING or kind == "unknown":
            raise ConnectionError(sentence)

    def _hand_on(self, message):
        if self._is_answer(message):
            answers = self._requests.get(message.correlation)
            if answers:
                # So the platform says that nobody answers (PROTOCOL 4.7).
                answers.put(
                    Refused("refused", " ".join(message.parameters))
                    if (message.component, message.command) ==
                    ("Parlour", "Failed") else message)
            with self._changed:
                self._link.handed_on(message)
        elif message.number is not None or \
                self._messages.qsize() < Link.MAX_WAITING:
            self._messages.put(message)
        else:  # nothing was promised of it
            self._say("dropped", f"{self.name} is too slow: a message without "
                                 "a number is dropped")

    def _is_answer(self, message):
        """Also a late one, which nobody waits for any more."""
        return not message.sinks and message.correlation is not None and \
            0 <= message.correlation - self._link.first_correlation < 1 << 32

    def _say(self, kind, sentence):
        """To the log: of each kind once a second at most, the same once a
        minute."""
        said, at = self._logged.get(kind, ("", 0.0))
        now = time.monotonic()
        if not said or now - at >= (60.0 if said == sentence else 1.0):
            self._logged[kind] = sentence, now
            _log.warning("%s", sentence)

    # -- the handlers' thread -------------------------------------------------

    def _handle(self):
        self._handling = threading.current_thread()
        while True:
            message = self._messages.get()
            if message is None or self._ended:
                break
            self._fires = None if self._store is None else []
            handler = self._handlers.get(message.command,
                                         self._handlers.get("*"))
            if handler is not None:
                self._call(handler, message)
            self._finish(message)
        if self._store is not None:
            with self._changed:
                self._store.close()

    def _finish(self, message):
        """A handler has ended. What it has fired waits for the outbox."""
        said, self._fires = self._fires or [], None
        with self._changed:
            while not self._link.handed_on(message, said):
                if self._ended:
                    return  # the next process handles it again
                self._changed.wait()
        if said:
            self._wake()

    def _call(self, handler, message):
        """A handler's mistake ends one message."""
        try:
            handler(message)
        except Exception as error:
            _log.warning("%s: %s", message.command, error, exc_info=True)
            try:
                self.answer(message, "Failed",
                            f"{type(error).__name__}: {error}")
            except Refused:
                pass  # the agent was stopped
