#!/usr/bin/python3
"""Some hundreds of unusual inputs, and the program's reaction to them: see ../fuzz."""

import os
import pathlib
import re
import subprocess
import sys
import unittest

FUZZ = pathlib.Path(__file__).resolve().parents[1] / "fuzz/fuzz.py"
REFUSED = "fuzz: refused as root"


class FuzzTest(unittest.TestCase):
    def fuzz(self, subject, cases):
        """@return count of each exit code"""
        done = subprocess.run([sys.executable, FUZZ, subject, "--cases", str(cases)], text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        if done.stderr.startswith(REFUSED):
            self.skipTest(done.stderr.strip())
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        print(done.stdout.strip())
        return {int(code): int(count) for code, count in re.findall(r"(\d+): (\d+)", done.stdout)}

    def test_files(self):
        codes = self.fuzz("files", int(os.environ.get("FUZZED_FILES", 300)))
        self.assertGreater(codes[0], 30, "hardly anything is run")
        self.assertGreater(codes[2], 30, "hardly anything is refused")

    def test_images(self):
        codes = self.fuzz("images", int(os.environ.get("FUZZED_IMAGES", 100)))
        self.assertGreater(codes[0], 10, "hardly anything is run")
        self.assertGreater(codes[2], 10, "hardly anything is refused")

    def test_controllers(self):
        codes = self.fuzz("controllers", int(os.environ.get("FUZZED_CONTROLLERS", 60)))
        self.assertGreater(codes[3], 10, "hardly any fails")

    def test_launched_controllers(self):
        self.fuzz("launched_controllers", int(os.environ.get("FUZZED_LAUNCHES", 6)))


if __name__ == "__main__":
    unittest.main()
