"""A house for tests: an MQTT server (mosquitto) on a free port, and devices that
announce themselves and obey. Client is a small MQTT client, version 3.1.1."""

import json
import pathlib
import queue
import shutil
import socket
import struct
import subprocess
import threading

WAIT = 60  # seconds; only a test that fails waits so long
SERVER = shutil.which("mosquitto", path="/usr/sbin:/usr/bin")
CONNECT, CONNACK, PUBLISH, PUBACK, SUBSCRIBE, SUBACK = 1, 2, 3, 4, 8, 9


def text(value):
    data = value.encode()
    return struct.pack("!H", len(data)) + data


class Client:
    """What is published is confirmed by the server before publish() returns.
    What comes is given to `heard`, on a thread of the client."""

    def __init__(self, port, heard=None):
        self._heard = heard
        self._socket = socket.create_connection(("127.0.0.1", port), WAIT)
        self._socket.settimeout(None)
        self._stream = self._socket.makefile("rb")
        self._number = 0
        self._receipts = queue.SimpleQueue()
        self._send(CONNECT << 4, text("MQTT") + b"\x04\x02\0\0" + text(""))
        threading.Thread(target=self._read, daemon=True).start()
        self._wait(CONNACK)

    def publish(self, topic, payload, retain=False):
        self.tell(topic, payload, retain)
        self._wait(PUBACK)

    def tell(self, topic, payload, retain=False):
        """Publishes without waiting, so that it may be called by `heard`."""
        self._number += 1
        self._send(PUBLISH << 4 | 2 | retain, text(topic) +
                   struct.pack("!H", self._number) + payload.encode())

    def subscribe(self, topic):
        self._number += 1
        self._send(SUBSCRIBE << 4 | 2,
                   struct.pack("!H", self._number) + text(topic) + b"\x01")
        self._wait(SUBACK)

    def close(self):
        self._socket.shutdown(socket.SHUT_RDWR)
        self._stream.close()
        self._socket.close()

    def _wait(self, kind):
        while self._receipts.get(timeout=WAIT) != kind:
            pass

    def _send(self, head, body):
        size, length = bytearray(), len(body)
        while True:
            size.append(length & 127 | (128 if length > 127 else 0))
            length >>= 7
            if not length:
                break
        self._socket.sendall(bytes([head]) + size + body)

    def _read(self):
        try:
            while head := self._stream.read(1):
                size = shift = 0
                while True:
                    byte = self._stream.read(1)[0]
                    size |= (byte & 127) << shift
                    shift += 7
                    if byte < 128:
                        break
                self._take(head[0], self._stream.read(size))
        except (OSError, ValueError, IndexError):
            pass  # the test or the server has closed the connection

    def _take(self, head, body):
        if head >> 4 != PUBLISH:
            self._receipts.put(head >> 4)
            return
        end = 2 + struct.unpack("!H", body[:2])[0]
        topic, start = body[2:end].decode(), end
        if head & 6:
            self._send(PUBACK << 4, body[end:end + 2])
            start += 2
        if self._heard:
            self._heard(topic, body[start:].decode())


class Server:
    """mosquitto, on the same port each time it is started."""

    def __init__(self, folder):
        self._settings = pathlib.Path(folder) / "mosquitto.conf"
        self.port = None
        self._process = None

    def start(self):
        for _ in range(20):  # another program may take the port
            if self.port is None:
                with socket.create_server(("127.0.0.1", 0)) as free:
                    self.port = free.getsockname()[1]
            self._settings.write_text(
                f"user root\npersistence false\nallow_anonymous true\n"
                f"log_dest stderr\nlistener {self.port} 127.0.0.1\n",
                encoding="utf-8")
            self._process = subprocess.Popen(
                [SERVER, "-c", self._settings], stderr=subprocess.PIPE)
            with self._process.stderr as log:
                if any(b" running" in line for line in log):
                    return
            self.kill()
            self.port = None
        raise RuntimeError("mosquitto does not start")

    def kill(self):
        if self._process:
            self._process.kill()
            self._process.wait()
            self._process = None


class Home:
    """Devices that obey, unless they are in `deaf`; `commands` has what they
    were told, as (topic, payload)."""

    def __init__(self, port):
        self.commands = queue.SimpleQueue()
        self.deaf = set()
        self._obey = {}  # by topic: from a payload to the state's topic and text
        self._client = Client(port, self._heard)

    def close(self):
        self._client.close()

    def _heard(self, topic, payload):
        self.commands.put((topic, payload))
        if topic in self._obey and topic not in self.deaf:
            self._client.tell(*self._obey[topic](payload), True)

    def next_command(self):
        return self.commands.get(timeout=WAIT)

    def publish(self, topic, payload):
        self._client.publish(topic, payload, True)

    def ring(self):
        self._client.publish("bell", "ON")
        self._client.publish("bell", "OFF")

    def announce(self, kind, name, message):
        self._client.publish(f"homeassistant/{kind}/{name}/config",
                             json.dumps(message), True)

    def add_lamp(self, room):
        """As Zigbee2MQTT announces it: the room is in its name."""
        base = f"zigbee2mqtt/{room} lamp"
        self.announce("light", room.replace(" ", "_"), {
            "schema": "json", "name": None, "state_topic": base,
            "command_topic": base + "/set",
            "availability": [{"topic": base + "/availability",
                              "value_template": "{{ value_json.state }}"}],
            "device": {"name": f"{room} lamp"}})
        self._serve(base + "/set", lambda payload: (base, payload))
        self.publish(base, '{"state": "OFF", "brightness": 254}')

    def add_heating(self, room, degrees, warmth):
        base = f"heating/{room}"
        self.announce("climate", room.replace(" ", "_"), {
            "~": base, "temp_cmd_t": "~/set", "temp_stat_t": "~",
            "temp_stat_tpl": "{{ value_json.target }}", "curr_temp_t": "~",
            "curr_temp_tpl": "{{ value_json.now | float | round(1) }}",
            "min_temp": 5, "max_temp": 30, "dev": {"sa": room.title()}})
        self._serve(base + "/set", lambda payload: (
            base, json.dumps({"target": float(payload), "now": warmth})))
        self.publish(base, json.dumps({"target": degrees, "now": warmth}))

    def add_lock(self):
        self.announce("lock", "front", {
            "~": "front", "stat_t": "~/state", "cmd_t": "~/set",
            "dev": {"name": "Front door", "sa": "Hall"}})
        self._serve("front/set", lambda payload: ("front/state",
                                                  payload + "ED"))
        self.publish("front/state", "LOCKED")

    def add_bell(self):
        self.announce("binary_sensor", "bell", {
            "name": "Doorbell", "stat_t": "bell", "dev": {"sa": "Hall"}})
        self.publish("bell", "OFF")

    def _serve(self, topic, obey):
        self._obey[topic] = obey
        self._client.subscribe(topic)
