#!/usr/bin/env python3
"""Each robot's URDF is valid and equals the generator's output."""
import pathlib
import subprocess
import sys
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parent.parent


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False)


class UrdfTest(unittest.TestCase):
    def expect_clean(self, robot):
        # check_urdf prints many errors but exits with 0
        result = run("check_urdf", str(PACKAGE / "urdf" / f"{robot}.urdf"))
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stderr, "")
        self.assertIn("root Link: base_link", result.stdout)

    def test_footbot_is_clean(self):
        self.expect_clean("footbot")

    def test_eyebot_is_clean(self):
        self.expect_clean("eyebot")

    def test_handbot_is_clean(self):
        self.expect_clean("handbot")

    def test_files_are_what_the_generator_writes(self):
        result = run(sys.executable, str(PACKAGE / "scripts" / "make_urdf.py"), "--check")
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
