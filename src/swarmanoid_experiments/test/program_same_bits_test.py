#!/usr/bin/env python3
"""One result on any x86-64: all installed experiments end in the same state, with and without the FMA instructions of this
processor. With them, the C library's sine, cosine and similar functions would differ in the last bit."""

import json
import os
import re
import subprocess
import time
import unittest

TUNABLES = "GLIBC_TUNABLES"
HIDDEN = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"
IS_LONG = os.environ.get("SWARMANOID_LONG_TESTS") == "1"
SEEDS = range(1, 11) if IS_LONG else range(1, 3)
TICKS = 1000 if IS_LONG else 300  # climbing and conformance differed within a hundred


def can_fuse():
    with open("/proc/cpuinfo") as file:
        flags = re.search("^flags.*", file.read(), re.M)
    return flags is not None and {"fma", "avx2"} <= set(flags.group().split())


def run(*arguments, tunables=None):
    """@return summary of a run in an environment with these tunables"""
    environment = {name: value for name, value in os.environ.items() if name != TUNABLES}
    if tunables is not None:
        environment[TUNABLES] = tunables
    done = subprocess.run(["swarmanoid", "run", *map(str, arguments), "--quiet"], timeout=300, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, encoding="utf-8", env=environment, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def experiments():
    listed = subprocess.run(["swarmanoid", "list", "experiment"], stdout=subprocess.PIPE, encoding="utf-8", check=True)
    return listed.stdout.split()[1:]  # below a heading


@unittest.skipUnless(can_fuse(), "this processor has no FMA, so there is nothing to hide")
class SameBitsTest(unittest.TestCase):
    def test_experiments_end_in_one_state_with_and_without_fma(self):
        names = experiments()
        self.assertIn("climbing", names)
        for name in names:
            for seed in SEEDS:
                with self.subTest(experiment=name, seed=seed):
                    arguments = (name, "--seed", seed, "--ticks", TICKS)
                    self.assertEqual(run(*arguments)["state_hash"], run(*arguments, tunables=HIDDEN)["state_hash"])

    def test_the_summary_names_the_library_and_it_is_the_same_in_any_environment(self):
        for tunables in (None, "", HIDDEN, "glibc.malloc.check=0", "glibc.cpu.hwcaps=-AVX2_Usable"):
            with self.subTest(tunables=tunables):
                self.assertRegex(run("diffusion", "--ticks", 1, tunables=tunables)["math_library"],
                                 r"^glibc 2\.\d+, any x86-64$")

    def test_the_program_is_replaced_by_itself_and_not_by_a_child(self):
        """Signals, time limits and process lists refer to the process that was started."""
        environment = {name: value for name, value in os.environ.items() if name != TUNABLES}
        process = subprocess.Popen(["swarmanoid", "run", "diffusion", "--ticks", "1000000000", "--quiet"],
                                   stdout=subprocess.PIPE, env=environment)
        try:
            until = time.monotonic() + 20
            while b"-FMA4" not in self.read(process.pid, "environ"):
                self.assertLess(time.monotonic(), until, "it goes on as it was started")
                time.sleep(0.01)
            self.assertEqual(self.read(process.pid, "comm"), b"swarmanoid\n")
            self.assertEqual(self.read(process.pid, "cmdline").split(b"\0")[0], b"swarmanoid")
        finally:
            process.kill()
            process.communicate()

    @staticmethod
    def read(pid, what):
        with open(f"/proc/{pid}/{what}", "rb") as file:
            return file.read()


if __name__ == "__main__":
    unittest.main()
