"""Controllers that misbehave, each in its way in each phase of its life (../test/misbehaving)."""

import pathlib
import re
import sys

import program

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "test"))
from misbehaving_world import world  # noqa: E402  pylint: disable=wrong-import-position

PHASES = ("load", "factory", "init", "step", "destroy", "destructor", "unload")
FROM_ENVIRONMENT = ("load", "factory", "unload")  # before there are parameters, or after them
WATCHDOG = 3.0  # [s]
# What nobody can catch, or what is done beside the call: the process may end as it was made to.
BEYOND_REACH = {"raise_kill", "segv_on_another_thread", "throw_on_another_thread", "underscore_exit_0", "default_signals",
                "free_twice", "spoil_heap", "close_output", "all_memory", "fork"}
SIGNALS_OF_ITS_OWN = {"raise_int", "raise_term", "raise_pipe"}


def deeds():
    """As the table of deeds.cpp has them."""
    text = (pathlib.Path(__file__).resolve().parents[1] / "test/misbehaving/deeds.cpp").read_text()
    return re.findall(r'^ *\{"(\w+)",', text, re.MULTILINE)


class Controllers:
    """Each case is a phase and a deed."""

    def __init__(self):
        self._cases = [(phase, deed) for deed in deeds() for phase in PHASES]
        self.count = len(self._cases)

    def run(self, _, folder, number):
        phase, deed = self._cases[number % self.count]
        environment = {"MISBEHAVING": f"{phase} {deed}"} if phase in FROM_ENVIRONMENT else {}
        (folder / "case.xml").write_text(world("never" if environment else phase, deed))
        ending = program.run(["run", "case.xml", "--quiet", "--out", folder / "out", "--watchdog", WATCHDOG], folder, environment)
        return f"{deed} in {phase}", ending, self._trouble(phase, deed, ending)

    @staticmethod
    def _trouble(phase, deed, ending):
        trouble = ending.trouble()
        if not trouble or deed in BEYOND_REACH:
            return "" if ending.seconds <= program.LONGEST else trouble
        if phase == "unload" and ending.output.strip():
            return ""  # all is done and said; what a library does when the process ends is its own
        return trouble
