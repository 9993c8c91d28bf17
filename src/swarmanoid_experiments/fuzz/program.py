"""Runs the program `swarmanoid` once, within limits, and reports the problem with its end, if any."""

import json
import os
import re
import shutil
import signal
import subprocess
import threading
import time

import sandbox

LONGEST = 20.0  # [s]
PATIENCE = 10.0  # [s] after which a run is interrupted: slow runs that are not stuck end then
MOST_MEMORY = 2 * 2**30  # [bytes]
FINISHED, BAD_INPUT, CONTROLLER_FAILED, STOPPED, INTERRUPTED = 0, 2, 3, 4, 130
ALLOWED = (FINISHED, BAD_INPUT, CONTROLLER_FAILED, STOPPED, INTERRUPTED)
# bounded, because controllers write lines of a million letters
REASON = re.compile(r"swarmanoid: .{8,}|^[^:\n]{1,300}: controller failed( in tick \d+.*)?: .+", re.MULTILINE)
SANITIZER = re.compile(r"ERROR: AddressSanitizer|runtime error:|WARNING: ThreadSanitizer")


class Ending:
    """The end of a process."""

    def __init__(self, code, seconds, memory, output, errors):
        self.code, self.seconds, self.memory, self.output, self.errors = code, seconds, memory, output, errors

    def trouble(self):
        """Returns a problem that no run may have, or nothing."""
        return self.trouble_of_process(self.errors) or (self._trouble_of_summary() if self.code == FINISHED else "")

    def trouble_of_process(self, said, reason=REASON, longest=LONGEST):
        """The same for any command. @param said: text with its reasons"""
        if self.code < 0:
            return f"signal {-self.code}, after {self.seconds:.0f} s"
        if self.code not in ALLOWED:
            return f"exit code {self.code}"
        if self.seconds > longest:
            return f"{self.seconds:.0f} s"
        if self.memory > MOST_MEMORY:
            return f"{self.memory / 2**30:.1f} GB"
        if SANITIZER.search(said):
            return "a sanitizer reports"
        if self.code not in (FINISHED, INTERRUPTED) and not reason.search(said):
            return f"exit code {self.code} without a reason"
        return ""

    def _trouble_of_summary(self):
        try:
            summary = json.loads(self.output)
        except ValueError:
            return "no summary"
        return "" if summary["finished"] else "a summary that is not finished"


def run(arguments, folder, environment=None, patience=PATIENCE, longest=LONGEST):
    """@param arguments of `swarmanoid` @param folder where it runs @param patience, longest: [s]"""
    output, errors = folder / "output.txt", folder / "errors.txt"
    start = time.monotonic()
    with open(output, "wb") as standard_output, open(errors, "wb") as standard_error:
        process = subprocess.Popen([shutil.which("swarmanoid"), *map(str, arguments)], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=standard_output, stderr=standard_error, start_new_session=True,
                                   preexec_fn=sandbox.prepare, env=dict(os.environ, **(environment or {})))
        slow = threading.Timer(patience, process.send_signal, [signal.SIGINT])
        stuck = threading.Timer(longest, process.kill)
        slow.start()
        stuck.start()
        _, status, usage = os.wait4(process.pid, 0)
        slow.cancel()
        stuck.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.monotonic() - start
    return Ending(process.returncode, seconds, usage.ru_maxrss * 1024, output.read_text(errors="replace"),
                  errors.read_text(errors="replace"))
