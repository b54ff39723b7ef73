"""VoiceCase: for tests that talk with the program by sound files. What it hears
was spoken by the program itself."""

import array
import os
import pathlib
import pty
import signal
import subprocess
import sys
import time
import wave

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from program_case import PROGRAM, ProgramCase  # noqa: E402

VDEV = pathlib.Path(PROGRAM).parent.parent / "lib/vdev.so"
RATE = 16000
WAIT = 240  # seconds; only a test that fails waits so long
# How much faster than the clock sound devices of our own are.
SPEED = 10
# The same of sound files, where the pace is not what is tested.
FAST = 4
# Seconds of silence in files that are so fast, in which the robot says a few
# words to their end, also where it is slow, as with sanitizers.
AMPLE = 16


def samples_of(path):
    with wave.open(str(path)) as file:
        assert (file.getframerate(), file.getnchannels()) == (RATE, 1)
        return array.array("h", file.readframes(file.getnframes()))


class VoiceCase(ProgramCase):

    def write_sound(self, name, samples):
        path = self.folder / name
        with wave.open(str(path), "wb") as file:
            file.setnchannels(1)
            file.setsampwidth(2)
            file.setframerate(RATE)
            file.writeframes(samples.tobytes())
        return path

    def silence(self, seconds):
        return array.array("h", bytes(int(2 * RATE * seconds)))

    def application(self, name, speech, grammar="", topic="", plugins=(),
                    components="", pace=1):
        """One that says something when it begins. Its sound files are heard and
        written so much faster than the clock."""
        if pace != 1:
            components += "".join(f"""
                <component name="{each}" scope="seat">
                  <option name="pace" value="{pace}"/>
                </component>""" for each in ("FileMicrophone", "FileSpeaker"))
            plugins = [*plugins, "FileMicrophone", "FileSpeaker"]
        more = "".join(f"<Plugin>{plugin}</Plugin>" for plugin in plugins)
        self.write(f"{name}/settings.xml", f"""
            <settings name="{name}" start="Begin">
              <Plugins>
                <Plugin>GrammarNLU</Plugin><Plugin>PhraseNLG</Plugin>
                <Plugin>SphinxASR</Plugin><Plugin>FliteTTS</Plugin>{more}
              </Plugins>
              {components}
              <Scripts><Script>{name}.xml</Script></Scripts>
            </settings>""")
        self.write(f"{name}/{name}.xml", f"""
            <dialogue>
              <include href="parlour:pipeline"/>
              <state name="Begin">
                <Entrance><speak param="{speech}"/></Entrance>
              </state>
              {topic}
            </dialogue>""")
        if grammar:
            self.write(f"{name}/orders.jsgf", grammar)
        return str(self.folder / name)

    def desk(self, plugins=(), components="", pace=1):
        """One that opens windows and doors."""
        return self.application(
            "desk", "Hello.", """#JSGF V1.0;
            grammar orders;
            public <order> = [please] open the <thing>
              {topic=Opening} {act=inform};
            <thing> = (window | door | red box) {Thing};
            """, """
            <grammar name="orders" file="orders.jsgf"/>
            <topic name="Opening">
              <slot name="Thing" type="Functional" question="What?"/>
              <completed><speak param="I open the {this.Thing}."/></completed>
            </topic>""", plugins, components, pace)

    def talk(self, application, heard, spoken, *options):
        """Returns what was shown, line by line."""
        run = self.begin(
            "run", application, "--voice", "--microphone", str(heard),
            "--speaker", str(spoken), "--data", str(self.folder / "data"),
            *options, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)
        out, err = run.communicate(timeout=WAIT)
        self.assertEqual(run.returncode, 0, err)
        return out.splitlines(), err

    def speech(self, text, *options):
        """A text, spoken by a voice that recognisers like."""
        path = self.folder / "spoken.wav"
        subprocess.run([PROGRAM, "say", text, "--component", "FliteTTS",
                        "-o", str(path), *options], stdout=subprocess.DEVNULL,
                       timeout=WAIT, check=True)
        return samples_of(path)

    # -- sound devices of our own

    def devices(self, speed=SPEED, **faults):
        """Devices of these names, with these faults, that are faster than the
        clock. They capture what say() says, and silence."""
        if not VDEV.exists():
            self.skipTest("the tests were built without ALSA")
        entries = "".join(f"""
            pcm.{name} {{
              type vdev file "{self.folder}/{name}.raw" lines "yes"
              gone "{self.folder}/{name}.gone"
              pulled "{self.folder}/{name}.pulled"
              taken "{self.folder}/taken" blocked "{self.folder}/blocked"
              rate "{RATE}" channels "1" format "S16_LE" speed "{speed}"
              faults "{fault}" }}""" for name, fault in faults.items())
        return {**os.environ, "ALSA_CONFIG_PATH": str(self.write(
            "asound.conf", f'pcm_type.vdev {{ lib "{VDEV}" }}{entries}'))}

    def say(self, samples, name="ear"):
        """The device hears this from now on, once it has heard the last."""
        file = self.folder / f"{name}.raw"
        deadline = time.monotonic() + WAIT
        while file.exists():
            self.assertLess(time.monotonic(), deadline, "nobody listens")
            os.sched_yield()
        beside = file.with_suffix(".next")
        beside.write_bytes(samples.tobytes())
        beside.rename(file)

    def begin_talk(self, application, environment, *options):
        """Starts a conversation by the devices `ear` and `mouth`, with a trace."""
        return self.begin(
            "run", application, "--voice", "--trace", "--microphone", "ear",
            "--speaker", "mouth", "--data", str(self.folder / "data"), *options,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, cwd=self.folder, env=environment)

    def seen_until(self, run, *words):
        """Reads what is traced up to a line with all these words."""
        seen = []
        for line in run.stderr:
            seen.append(line)
            if all(word in line for word in words):
                return line
            if "Session.Ended()" in line:
                break
        self.fail(f"not seen: {words}\n" + "".join(seen))

    def ask(self, run, samples, word):
        """Says this, again if it is misheard, until the word is recognised."""
        for _ in range(3):
            self.say(samples)
            line = self.seen_until(run, ".Re", "[session]")
            while not ("RecognitionResult(" in line or "Rejected(" in line):
                line = self.seen_until(run, ".Re", "[session]")
            if word in line:
                return
        self.fail(f"not heard: {word}")

    def all_seen(self, run, words):
        """Reads what is traced until each of these has been seen."""
        while words:
            line = self.seen_until(run)
            words = {word for word in words if word not in line}

    def on_terminal(self, *arguments):
        """Starts the program on a terminal, which it returns; it is killed if it
        outlives the test."""
        child, terminal = pty.fork()
        if child == 0:
            os.environ["NO_COLOR"] = "1"
            os.execv(PROGRAM, [PROGRAM, *arguments])
        self.child = child
        self.addCleanup(self.end_of_child, signal.SIGKILL)
        screen = open(terminal, "r+b", buffering=0)
        self.addCleanup(screen.close)
        return screen

    def end_of_child(self, number=0):
        child, self.child = self.child, 0
        if not child:
            return None
        if number:
            os.kill(child, number)
        _, status = os.waitpid(child, 0)
        return os.waitstatus_to_exitcode(status)
