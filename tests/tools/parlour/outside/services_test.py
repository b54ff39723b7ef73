#!/usr/bin/env python3
"""The receptionist with its weather and its short messages over HTTP: two names
in its settings change, its script stays. The services are servers of the test's
own."""

import http.server
import json
import os
import pathlib
import queue
import re
import shutil
import ssl
import subprocess
import sys
import threading
import unittest
import urllib.parse
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import PROGRAM, ProgramCase  # noqa: E402

RECEPTIONIST = (pathlib.Path(__file__).parents[4] / "config" / "apps" /
                "receptionist")
WAIT = 60  # seconds; only a test that fails waits so long
SERVICES = """<component name="Forecasts" plugin="HTTPService">
    <option name="rules" value="services/weather.xml"/>
  </component>
  <component name="Gateway" plugin="HTTPService">
    <option name="rules" value="services/sms.xml"/>
  </component>
"""


class Service(http.server.ThreadingHTTPServer):
    """Answers by `answer(request)`, which returns a status and what becomes
    JSON; None: closes the connection. Keeps what it was asked."""

    daemon_threads = True

    def __init__(self, answer, context=None):
        super().__init__(("127.0.0.1", 0), Handler)
        if context:
            self.socket = context.wrap_socket(self.socket, server_side=True)
        self.answer = answer
        self.asked = []
        threading.Thread(target=self.serve_forever, daemon=True).start()

    @property
    def address(self):
        return f"http://127.0.0.1:{self.server_port}"


class Handler(http.server.BaseHTTPRequestHandler):

    def handle_it(self):
        url = urllib.parse.urlsplit(self.path)
        self.url = url.path
        self.query = dict(urllib.parse.parse_qsl(url.query))
        self.body = self.rfile.read(int(self.headers["Content-Length"] or 0))
        self.server.asked.append(self)
        answer = self.server.answer(self)
        self.close_connection = True
        if answer is None:
            return
        status, value = answer
        body = json.dumps(value).encode()
        self.send_response(status)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    do_GET = do_POST = handle_it

    def log_message(self, *_):
        pass


def weather(request):
    if request.headers["X-Api-Key"] != "geheim":
        return 401, {}
    if request.query["place"] == "Atlantis":
        return 404, {}
    return 200, {"summary": "Sunny all day.", "temperature": {"now": 31}}


class ServicesTest(ProgramCase):

    def serve(self, answer, context=None):
        service = Service(answer, context)
        self.addCleanup(service.server_close)
        self.addCleanup(service.shutdown)
        return service

    def with_services(self, forecasts, gateway):
        """The receptionist with other names in its settings."""
        self.app = self.folder / "receptionist"
        shutil.copytree(RECEPTIONIST, self.app)
        settings = self.app / "settings.xml"
        text = settings.read_text(encoding="utf-8")
        for name in ("LogSMS", "LogWeather"):
            self.assertIn(f"<Plugin>{name}</Plugin>", text)
            text = text.replace(f"<Plugin>{name}</Plugin>", "")
        text = re.sub('<component name="LogWeather">.*?</component>', SERVICES,
                      text, count=1, flags=re.S)
        settings.write_text(text, encoding="utf-8")
        self.environment = dict(
            os.environ, WEATHER_URL=forecasts, WEATHER_KEY="geheim",
            SMS_URL=gateway, SMS_TOKEN="streng")

    def talk(self, *turns, start="2026-11-21 09:00"):
        """What the robot says to these turns, and what it logs."""
        done = subprocess.run(
            [PROGRAM, "run", str(self.app), "--text", "--clock", start,
             "--data", str(self.folder / "data")],
            input="".join(turn + "\n\n" for turn in turns), encoding="utf-8",
            env=self.environment, capture_output=True, timeout=WAIT)
        self.assertEqual(done.returncode, 0, done.stderr)
        for secret in ("geheim", "streng"):
            self.assertNotIn(secret, done.stdout + done.stderr)
        return done.stdout, done.stderr

    def lines(self, robot, stream):
        """A queue of the lines that a running program writes."""
        lines = queue.SimpleQueue()
        reader = threading.Thread(
            target=lambda: [lines.put(line) for line in stream])
        reader.start()
        # The other way round: killed first, then waited for.
        self.addCleanup(reader.join)
        self.addCleanup(robot.wait)
        self.addCleanup(robot.kill)
        return lines

    def find(self, pattern, lines):
        """The first match in a line to come."""
        while True:
            if found := re.search(pattern, lines.get(timeout=WAIT)):
                return found

    def test_the_weather_comes_from_the_service(self):
        forecasts = self.serve(weather)
        self.with_services(forecasts.address, "http://127.0.0.1:9")
        said, _ = self.talk("how is the weather in Changi?",
                            "and in Atlantis?")
        self.assertIn("Sunny all day. It has 31 degrees in Changi.", said)
        self.assertIn("I am sorry, I have no weather report for that.", said)
        self.assertEqual(forecasts.asked[0].query,
                         {"place": "Changi", "when": "today"})

    @unittest.skipUnless(shutil.which("openssl"), "openssl is not installed")
    def test_a_certificate_is_always_checked(self):
        for name, is_right in (("IP:127.0.0.1", True),
                               ("DNS:other.example", False)):
            key, certificate = self.folder / "key.pem", self.folder / "ca.pem"
            subprocess.run(
                ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes",
                 "-subj", "/CN=test", "-addext", f"subjectAltName={name}",
                 "-keyout", key, "-out", certificate, "-days", "2"],
                check=True, capture_output=True)
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(certificate, key)
            forecasts = self.serve(weather, context)
            address = forecasts.address.replace("http:", "https:")
            self.with_services(address, "http://127.0.0.1:9")
            said, _ = self.talk("how is the weather in Changi?")
            self.assertIn("I have no weather report", said)
            self.assertEqual(forecasts.asked, [])
            shutil.copy(certificate, self.app / "ca.pem")
            settings = self.app / "settings.xml"
            settings.write_text(settings.read_text(encoding="utf-8").replace(
                '<option name="rules" value="services/weather.xml"/>',
                '<option name="rules" value="services/weather.xml"/>'
                '<option name="ca" value="ca.pem"/>'), encoding="utf-8")
            said, _ = self.talk("how is the weather in Changi?")
            with self.subTest(name=name):
                self.assertEqual("31 degrees in Changi" in said, is_right, said)
            shutil.rmtree(self.app)

    def test_a_service_that_stumbles_is_asked_again(self):
        def stumble(request):
            return (weather(request) if len(request.server.asked) > 2
                    else (503, {}) if len(request.server.asked) == 1 else None)

        forecasts = self.serve(stumble)
        self.with_services(forecasts.address, "http://127.0.0.1:9")
        said, _ = self.talk("how is the weather in Changi?")
        self.assertIn("Sunny all day. It has 31 degrees in Changi.", said)
        self.assertEqual(len(forecasts.asked), 3)

    def test_the_plate_number_goes_out_once(self):
        gateway = self.serve(lambda _: (201, {"id": "a1"}))
        self.with_services("http://127.0.0.1:9", gateway.address)
        said, _ = self.talk("Book a taxi to Raffles Place for 6pm",
                            "my number is 81234567")
        self.assertIn("Your taxi to Raffles Place is booked for 6pm.", said)
        plate = re.search(r"plate number is (\w+)", said)[1]
        self.assertEqual(len(gateway.asked), 1)
        request = gateway.asked[0]
        self.assertEqual(request.headers["Authorization"], "Bearer streng")
        message = json.loads(request.body)
        self.assertEqual(message["to"], "81234567")
        self.assertIn(plate, message["text"])

    def test_a_message_that_may_have_gone_out_is_not_repeated(self):
        gateway = self.serve(lambda _: None)
        self.with_services("http://127.0.0.1:9", gateway.address)
        said, _ = self.talk("Book a taxi to Raffles Place for 6pm",
                            "my number is 81234567")
        self.assertIn("I could not send you the plate number.", said)
        self.assertEqual(len(gateway.asked), 1)

    def test_in_real_time_the_conversation_waits_for_nobody(self):
        forecasts = self.serve(weather)
        self.with_services(forecasts.address, "http://127.0.0.1:9")
        robot = self.begin("run", str(self.app), "--text", "--data",
                           str(self.folder / "data"), env=self.environment,
                           stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True)
        said = self.lines(robot, robot.stdout)
        robot.stdin.write("how is the weather in Changi?\n\n")
        robot.stdin.flush()
        self.find("31 degrees in Changi", said)
        robot.stdin.close()
        self.assertEqual(robot.wait(WAIT), 0)

    def test_a_report_of_a_service_reaches_the_conversation(self):
        self.write("app/settings.xml", """<settings name="app" start="Desk">
          <Plugins><Plugin>GrammarNLU</Plugin><Plugin>PhraseNLG</Plugin></Plugins>
          <component name="Gateway" plugin="HTTPService">
            <option name="rules" value="services/sms.xml"/>
            <option name="listen" value="127.0.0.1:0"/>
            <option name="token" value="${INBOX_TOKEN}"/>
          </component>
          <Scripts><Script>app.xml</Script></Scripts></settings>""")
        self.write("app/services/sms.xml", """<service><webhook path="/inbox">
          <on has="/from"><event name="Received">
            <param value="{/from}"/><param value="{/text}"/></event></on>
          </webhook></service>""")
        self.write("app/app.xml", """<dialogue>
          <include href="parlour:pipeline"/>
          <state name="Desk"><Entrance><speak param="Hello."/></Entrance></state>
          <handler name="Inbox"><messages><component>
            <Session><Started>
              <subscribe source="Gateway" command="Received"/>
            </Started></Session>
            <Gateway><Received>
              <speak param="{_LPARAM1} writes: {_LPARAM2}"/>
            </Received></Gateway>
          </component></messages></handler></dialogue>""")
        robot = self.begin(
            "run", str(self.folder / "app"), "--text", "--data",
            str(self.folder / "data"),
            env=dict(os.environ, INBOX_TOKEN="streng"), stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        said, notes = self.lines(robot, robot.stdout), self.lines(
            robot, robot.stderr)
        address = self.find(r"heard at (http://\S+)", notes)[1]
        self.find("Hello", said)
        report = urllib.request.Request(
            address + "/inbox?token=streng",
            json.dumps({"from": "Ann", "text": "I am late"}).encode())
        with urllib.request.urlopen(report, timeout=WAIT) as answer:
            self.assertEqual(answer.status, 204)
        self.find("Ann writes: I am late", said)
        robot.stdin.close()
        self.assertEqual(robot.wait(WAIT), 0)

    def test_samples_answer_in_tests(self):
        self.with_services("http://127.0.0.1:9", "http://127.0.0.1:9")
        shutil.rmtree(self.app / "dialogues")
        (self.app / "dialogues").mkdir()
        (self.app / "dialogues" / "weather.txt").write_text(
            "R: Good morning, how can I help you?\n"
            "U: how is the weather in Changi?\n"
            "R: Showers in the afternoon. It has 29 degrees in Changi.\n"
            "U: and in Atlantis?\n"
            "R: I am sorry, I have no weather report for that.\n",
            encoding="utf-8")
        done = subprocess.run([PROGRAM, "test", "-q", str(self.app)],
                              encoding="utf-8", capture_output=True,
                              timeout=WAIT)
        self.assertIn("1 of 1 conversations passed", done.stdout, done.stderr)

    def test_mistakes_in_rules_are_reported_with_their_place(self):
        self.with_services("http://127.0.0.1:9", "http://127.0.0.1:9")
        rules = self.app / "services" / "weather.xml"
        rules.write_text(rules.read_text(encoding="utf-8").replace(
            "{/summary}", "{/sumary}"), encoding="utf-8")
        done = subprocess.run([PROGRAM, "check", str(self.app)],
                              encoding="utf-8", capture_output=True,
                              env=self.environment, timeout=WAIT)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(
            done.stdout + done.stderr,
            r"services/weather.xml:\d+:1: error: this sample does not fit its "
            r"rule: 127.0.0.1:9 answered without /sumary")


if __name__ == "__main__":
    unittest.main()
