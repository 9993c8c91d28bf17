"""Figures of robustness: thousands of malformed inputs, sanitizers, and coverage of the tests."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

from table import ROOT

EXPERIMENTS = ROOT / "src/swarmanoid_experiments"
FILES, IMAGES, FRAMES, CALLS = 10_000, 1_200, 1_000, 2_000
# The suite handles signals itself, and some tests raise them; an unexpected signal ends its test.
NO_SIGNALS = "handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigill=0:handle_sigfpe=0:use_sigaltstack=0"
SANITIZERS = {"address,undefined": {"ASAN_OPTIONS": f"detect_leaks=0:{NO_SIGNALS}", "UBSAN_OPTIONS": "print_stacktrace=1"},
              "thread": {"TSAN_OPTIONS": f"suppressions={ROOT / 'scripts/figures/thread_sanitizer.supp'}:{NO_SIGNALS}"}}
TICKS = 100  # per experiment with a sanitizer
# experiments have few robots; this crowd fills several blocks, so that several threads work
CROWD, CROWD_TICKS = 4000, 25
CROWDED = ("--set", f"arena.distribute.quantity={CROWD}", "--set", "arena.size=20,20,1", "--set", "arena.distribute.maximum=19.8,19.8,0")
REPORT = re.compile(r"ERROR: \w+Sanitizer|WARNING: ThreadSanitizer|runtime error: ")


def _last_line(text):
    lines = text.strip().splitlines()
    return lines[-1] if lines else "did not run"


def fuzzers(table, build):
    for subject, cases, what in (("files", FILES, f"{FILES:,} fuzzed files"), ("images", IMAGES, f"{IMAGES:,} fuzzed images"),
                                 ("controllers", None, "all kinds of misbehaving controllers"),
                                 ("launched_controllers", None, "all kinds of misbehaving controllers, under roslaunch")):
        done = subprocess.run([sys.executable, EXPERIMENTS / "fuzz/fuzz.py", subject, *(["--cases", str(cases)] if cases else [])],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            print(done.stderr[-8000:], file=sys.stderr)
        table.add(what, "no crash, no hang over 20 s, at most 2 GB, an exit code of the page, a reason",
                  _last_line(done.stdout or done.stderr), done.returncode == 0)
    program = build / "devel/lib/swarmanoid_experiments/swarmanoid_experiments_frame_fuzz_test"
    done = subprocess.run([program], capture_output=True, text=True, env=dict(os.environ, FUZZED_FRAMES=str(FRAMES)), check=False)
    table.add(f"{FRAMES:,} fuzzed frames each way", "the space goes on, robots stop with a reason", _last_line(done.stdout),
              done.returncode == 0)
    done = subprocess.run([sys.executable, EXPERIMENTS / "rostest/service_fuzz_test.py"], capture_output=True, text=True, check=False,
                          env=dict(os.environ, FUZZED_CALLS=str(CALLS)))
    if done.returncode != 0:
        print(done.stdout[-4000:], done.stderr[-8000:], file=sys.stderr)
    counts = [line for line in done.stdout.splitlines() if " refused, " in line]
    table.add(f"{CALLS:,} fuzzed service calls", "each is answered within 20 s, with a reason if refused; the space lives on",
              "; ".join(counts) or "did not run", done.returncode == 0)


class InstrumentedBuild:
    """The suite with all unit tests, built with other flags in a temporary folder."""

    def __init__(self, *options):
        self._folder = tempfile.TemporaryDirectory(prefix="swarmanoid_instrumented_")
        self.path = self._folder.name
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        for command in (["cmake", *launcher, *options, "-S", ROOT, "-B", self.path, "-G", "Ninja", "-DBUILD_TESTS_IN_ALL=ON"],
                        ["cmake", "--build", self.path, "-j2"]):
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode != 0:
                raise RuntimeError(done.stdout[-3000:] + done.stderr[-3000:])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._folder.cleanup()

    def run(self, *command, environment=None):
        """Runs a command in the devel space. @return exit code and all output"""
        shell = ["bash", "-c", f'source {self.path}/devel/setup.bash && exec "$@"', "bash", *map(str, command)]
        done = subprocess.run(shell, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", cwd=self.path,
                              env=dict(os.environ, **(environment or {})), check=False)
        return done.returncode, done.stdout

    def unit_tests(self, environment=None):
        """Runs all unit tests except those that count allocations, since sanitizers allocate. @return summary, and all output"""
        _, output = self.run("ctest", "-R", "_gtest_", "-E", "allocation", "--verbose", "--timeout", "3600",
                             environment=environment)
        words = re.findall(r"^\d+% tests passed.*$", output, re.M)
        return words[0] if words else "did not run", output


def sanitizers(table):
    experiments = [*sorted((EXPERIMENTS / "experiments").glob("*.xml")), EXPERIMENTS / "rostest/turret.xml",
                   EXPERIMENTS / "test/data/good.xml"]
    runs = [*((experiment, TICKS) for experiment in experiments), (EXPERIMENTS / "experiments/diffusion.xml", CROWD_TICKS, *CROWDED)]
    for kind, environment in SANITIZERS.items():
        # -O1 -g1 compiles in less than half the time of full optimisation, and keeps assertions
        with InstrumentedBuild(f"-DSWARMANOID_SANITIZE={kind}", "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O1 -g1") as build:
            words, output = build.unit_tests(environment)
            failed = 0
            for experiment, ticks, *options in runs:
                code, text = build.run("swarmanoid", "run", experiment, "--ticks", ticks, "--threads", 2, "--quiet", *options,
                                       environment=environment)
                failed += code != 0
                output += text
        reports = REPORT.findall(output)
        if reports or failed:
            print("\n".join(line for line in output.splitlines() if REPORT.search(line) or "SUMMARY" in line)[-8000:], file=sys.stderr)
        table.add(f"unit tests, {len(experiments)} experiments of {TICKS} ticks and {CROWD:,} crowded footbots of {CROWD_TICKS}, with two "
                  f"threads, under the sanitizers {kind}",
                  "no report", f"{words}; {failed} experiments failed; {len(reports)} reports",
                  not reports and failed == 0 and words.startswith("100%"))


def coverage(table):
    # -O1: without optimisation crowds in engines take an hour; merged lines count as run if one of them is run. Counters are
    # atomic, since threads share them; otherwise some become negative, which gcovr reports as an error
    with InstrumentedBuild("-DCMAKE_CXX_FLAGS=-O1 -g1 --coverage -fprofile-update=atomic", "-DCMAKE_BUILD_TYPE=None") as build:
        words, _ = build.unit_tests()
        code, text = build.run("gcovr", "--root", ROOT, "--filter", f"{ROOT}/src/.*/(src|include)/", "--exclude", ".*/test.*",
                               "--gcov-ignore-parse-errors", "--json-summary-pretty", "--print-summary", build.path)
        start = text.find("{")
        facts = json.loads(text[start:text.rfind("}") + 1]) if code == 0 and start >= 0 else None
    said = (f"{facts['line_percent']} % of {facts['line_total']:,} lines, {facts['function_percent']} % of functions; {words}"
            if facts else f"not measured: {text[-200:]}")
    table.add("lines that unit tests alone run, without those with a master", "reported", said, None)
