"""Controllers that misbehave, with each action in each phase of their lives (../test/misbehaving)."""

import json
import pathlib
import re
import signal
import sys

import program

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "test"))
from misbehaving_world import ROBOTS, world  # noqa: E402  pylint: disable=wrong-import-position

PHASES = ("load", "factory", "init", "step", "destroy", "destructor", "unload")
FROM_ENVIRONMENT = ("load", "factory", "unload")  # before or after the parameters exist
WATCHDOG = 3.0  # [s]
# Uncatchable, or outside the call: the process may end in the way of the action.
BEYOND_REACH = {"raise_kill", "segv_on_another_thread", "throw_on_another_thread", "underscore_exit_0", "spoil_heap"}
SIGNALS_OF_ITS_OWN = {"raise_int": signal.SIGINT, "raise_term": signal.SIGTERM, "raise_pipe": signal.SIGPIPE}


def actions():
    """Returns the names in the table of actions.cpp."""
    text = (pathlib.Path(__file__).resolve().parents[1] / "test/misbehaving/actions.cpp").read_text()
    return re.findall(r'^ *\{"(\w+)",', text, re.MULTILINE)


class Controllers:
    """Each case is a phase and an action."""

    def __init__(self):
        self._cases = [(phase, action) for action in actions() for phase in PHASES]
        self.count = len(self._cases)

    def run(self, _, folder, number):
        phase, action = self._cases[number % self.count]
        environment = {"MISBEHAVING": f"{phase} {action}"} if phase in FROM_ENVIRONMENT else {}
        (folder / "case.xml").write_text(world("never" if environment else phase, action))
        ending = program.run(["run", "case.xml", "--quiet", "--out", folder / "out", "--watchdog", WATCHDOG], folder, environment)
        trouble = self._trouble(phase, action, ending)
        if not trouble and action not in BEYOND_REACH:
            trouble = self._lost(ending.output, folder / "out/table.txt")
        return f"{action} in {phase}", ending, trouble

    @staticmethod
    def _lost(summary, table):
        """Checks that the table has the ticks of the summary: a line for each robot, before the first tick and after each."""
        if not summary.strip():
            return ""
        ticks = json.loads(summary)["ticks"]
        whole = table.read_bytes().split(b"\n")[:-1]
        lines = sum(not line.startswith(b"#") for line in whole)
        return "" if lines == (ticks + 1) * len(ROBOTS) else f"{ticks} ticks were run, and {lines} lines are in the table"

    @staticmethod
    def _trouble(phase, action, ending):
        trouble = ending.trouble()
        if not trouble or action in BEYOND_REACH:
            return "" if ending.seconds <= program.LONGEST else trouble
        if phase == "unload" and ending.output.strip() and ending.seconds <= program.LONGEST:
            return ""  # all results are written; the library's behaviour at the end of the process does not matter
        if action in SIGNALS_OF_ITS_OWN and ending.code == -SIGNALS_OF_ITS_OWN[action]:
            return ""
        return trouble
