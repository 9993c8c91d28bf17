#!/usr/bin/python3
"""must_not_compile_test.py COMPILER OPTIONS...: the lines with a comment `error:` in must_not_compile/*.cpp, and no others, have that
error."""

import collections
import pathlib
import re
import subprocess
import sys
import unittest

EXPECTED = re.compile(r"// (.+): error: (.+)$")
COMPILER = []


def errors_by_line(file, with_errors):
    """@return the errors of the compiler, by the line of the file that they come from, also if they are in an included file"""
    done = subprocess.run([*COMPILER, f"-DWITH_ERRORS={int(with_errors)}", "-fsyntax-only", "-fno-diagnostics-show-caret", file],
                          capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"})
    found = collections.defaultdict(str)
    line = None
    for text in done.stderr.splitlines():
        place = re.search(re.escape(file.name) + r":(\d+):", text)
        line = int(place.group(1)) if place else line
        if "error: " in text:
            found[line] += text.split("error: ", 1)[1] + "\n"
    return dict(found)


class MustNotCompileTest(unittest.TestCase):
    def test_each_line_has_its_error(self):
        files = sorted((pathlib.Path(__file__).parent / "must_not_compile").glob("*.cpp"))
        self.assertTrue(files)
        for file in files:
            self.assertEqual(errors_by_line(file, False), {}, file.name)
            expected = {number: EXPECTED.search(line) for number, line in enumerate(file.read_text().splitlines(), 1)
                        if EXPECTED.search(line)}
            self.assertGreaterEqual(len(expected), 8)
            found = errors_by_line(file, True)
            self.assertEqual(sorted(found), sorted(expected), f"lines of {file.name} with errors: {found}")
            for number, what in expected.items():
                with self.subTest(what.group(1)):
                    self.assertRegex(found[number], what.group(2))


if __name__ == "__main__":
    COMPILER += sys.argv[1:]
    del sys.argv[1:]
    unittest.main(verbosity=2)
