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
    def test_each_robot_is_clean(self):
        files = sorted((PACKAGE / "urdf").glob("*.urdf"))
        self.assertLessEqual({"eyebot", "footbot", "handbot"}, {file.stem for file in files})
        for file in files:
            with self.subTest(robot=file.stem):
                result = run("check_urdf", str(file))  # it prints many errors but exits with 0
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
                self.assertEqual(result.stderr, "")
                self.assertIn("root Link: base_link", result.stdout)

    def test_files_are_what_the_generator_writes(self):
        result = run(sys.executable, str(PACKAGE / "scripts" / "make_urdf.py"), "--check")
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
