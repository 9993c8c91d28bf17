#!/usr/bin/env python3
"""Tests of the scripts that check the sources, and of the measure of overlaps in figures of crowds."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import numpy
import check_prose
import tidy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "figures"))
import footbot_bodies  # noqa: E402


def rotation(seed):
    """@return a random rotation matrix"""
    basis, _ = numpy.linalg.qr(numpy.random.default_rng(seed).normal(size=(3, 3)))
    return basis * numpy.sign(numpy.linalg.det(basis))


class DepthsTest(unittest.TestCase):
    EXACT = 1e-9  # m

    def depth(self, turn, apart, axis_b=(0, 0, 1)):
        """@return depth of a body along z and another one, both rotated"""
        return footbot_bodies.depths(numpy.zeros((1, 3)), (turn @ [0, 0, 1])[None], (turn @ apart)[None], (turn @ axis_b)[None])[0]

    def test_parallel_bodies_part_sideways_or_along_their_axes(self):
        for seed in range(20):
            tilt = 0.05 * seed  # rad, about a horizontal axis of any direction
            lean = numpy.array([[numpy.cos(tilt), 0, numpy.sin(tilt)], [0, 1, 0], [-numpy.sin(tilt), 0, numpy.cos(tilt)]])
            angle = 0.7 * seed
            apart = numpy.array([0.16 * numpy.cos(angle), 0.16 * numpy.sin(angle), 0.02])
            with self.subTest(tilt=tilt, angle=angle):
                self.assertAlmostEqual(0.17 - 0.16, self.depth(lean, apart), delta=self.EXACT)

    def test_crossed_bodies_part_across_both(self):
        for seed in range(10):
            self.assertAlmostEqual(0.17 - 0.15, self.depth(rotation(seed), numpy.array([0, 0.15, 0]), (1, 0, 0)), delta=self.EXACT)

    def test_bodies_apart_have_a_negative_depth(self):
        self.assertAlmostEqual(-0.03, self.depth(numpy.eye(3), numpy.array([0.12, 0.16, 0])), delta=self.EXACT)


class ProseTest(unittest.TestCase):
    def words(self, name, text):
        return [(line + prose.count("\n", 0, found.start()), found.group().lower())
                for line, prose in check_prose.prose_of(pathlib.Path(name), text) for found in check_prose.WORD.finditer(prose)]

    def test_comments_count_and_strings_do_not(self):
        self.assertEqual([(2, "whoever")], self.words("a.cpp", 'say("whoever // nobody");\n/// Whoever asks.\nint whoever = 0;\n'))
        self.assertEqual([(1, "likewise")], self.words("a.py", '"""Likewise."""\nwords = ["nobody"]\n'))
        self.assertEqual([(2, "told")], self.words("a.sh", "echo told\n# told\n"))

    def test_code_of_pages_does_not_count(self):
        self.assertEqual([(4, "nobody")], self.words("a.md", "```\nnobody\n```\nnobody, but `nobody`\n\n    nobody\n"))

    def test_a_phrase_may_go_on_in_the_next_line(self):
        self.assertEqual(1, len(self.words("a.hpp", "/// Moves what\n/// is near.\n")))


class TidyTest(unittest.TestCase):
    CODE = 'int a = 1;  // one\nconst char* b = "// no comment";\n'

    def test_comments_and_layout_are_no_code(self):
        self.assertEqual(tidy.code_of(self.CODE), tidy.code_of('/* one */ int a\n = 1;\nconst char* b = "// no comment";'))

    def test_includes_are_no_code(self):
        self.assertEqual(tidy.code_of(self.CODE), tidy.code_of('#include "a.hpp"\n#include <string>\n' + self.CODE))

    def test_a_source_that_only_moved_has_not_changed(self):
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(tidy, "ROOT", pathlib.Path(folder)):
            def git(*arguments, **environment):
                subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *arguments], cwd=folder, check=True,
                               capture_output=True, env={**os.environ, **environment})

            git("init")
            for name in ("moved", "changed", "kept"):
                (tidy.ROOT / f"{name}.cpp").write_text(f'#include "{name}.hpp"\nint {name}() {{ return 1; }}\n' * 20)
            git("add", ".")
            git("commit", "-m", "before", GIT_COMMITTER_DATE="2001-01-01T00:00:00Z")
            (tidy.ROOT / "new_place").mkdir()
            git("mv", "moved.cpp", "new_place/moved.cpp")
            for name, old, new in (("new_place/moved", "moved.hpp", "other.hpp"), ("changed", "return 1", "return 2")):
                file = tidy.ROOT / f"{name}.cpp"
                file.write_text(file.read_text().replace(old, new))
            git("add", ".")
            git("commit", "-m", "after")
            self.assertEqual({"changed.cpp"}, tidy.changed_since("2002-01-01"))

    def test_values_texts_and_disabled_checks_are(self):
        for other in ('int a = 2;  // one\nconst char* b = "// no comment";\n',
                      'int a = 1;  // one\nconst char* b = "// a comment";\n',
                      'int a = 1;  // NOLINT\nconst char* b = "// no comment";\n'):
            self.assertNotEqual(tidy.code_of(self.CODE), tidy.code_of(other))


if __name__ == "__main__":
    unittest.main(verbosity=2)
