#!/usr/bin/python3
"""Reports: numbers computed by hand, texts, and pictures without overlaps."""

import io
import pathlib
import tempfile
import unittest
import warnings

import numpy
from matplotlib import image
from swarmanoid_studies import plots, statistics
from swarmanoid_studies.identity_fields import Identity
from swarmanoid_studies.mistakes import BadInput
from swarmanoid_studies.report import write_report
from swarmanoid_studies.results_file import Columns, line_of
from swarmanoid_studies.results_table import read_results

IDENTITY = Identity("gap", "0.1.0+abc", "glibc 2.36, any x86-64", "12345678")


class ReportTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written(self, paths, metrics, rows):
        """@param rows values of the paths, seed, metrics"""
        columns = Columns(paths, metrics)
        lines = [line_of(columns.names())]
        for *values, seed, numbers in rows:
            lines.append(line_of([*IDENTITY, *values, seed, None, 7, 0.25, "00ff00ff00ff00ff", "", "[]", *numbers]))
        (self.folder / "runs.csv").write_bytes(b"".join(lines))
        return str(self.folder / "runs.csv")

    def grid(self, metrics=("m.x",), seeds=8):
        return self.written(("a.b",), metrics, [(value, seed, [place + 0.1 * seed * place for place in range(len(metrics))]
                                                 if value == "1" else [seed * 0.5] * len(metrics))
                                                for value in ("1", "2", "10") for seed in range(1, seeds + 1)])

    def test_p_is_corrected_by_holm(self):
        self.assertEqual(statistics.holm([]), [])
        self.assertEqual(statistics.holm([0.03]), [0.03])
        # 3 * 0.01; 2 * 0.0125 would be less than the corrected smaller p, so 0.03 again; 1 * 0.5
        self.assertEqual(statistics.holm([0.5, 0.01, 0.0125]), [0.5, 0.03, 0.03])
        self.assertEqual(statistics.holm([0.6, 0.7]), [1.0, 1.0])

    def test_pairs_are_of_one_seed_and_all_tests_of_the_report_are_corrected_together(self):
        file = self.written(("a.b", "a.c"), ("m.x", "m.y"), [(b, c, seed, [seed + 10.0 * (b == "2") + (c == "y"), 1.0])
                                                             for b in ("1", "2") for c in ("x", "y") for seed in (9, 3, 7)])
        found = statistics.comparisons(read_results(file))
        self.assertEqual(list(found), [("m.x", "a.b"), ("m.x", "a.c"), ("m.y", "a.b"), ("m.y", "a.c")])
        pair, = found["m.x", "a.b"]
        self.assertEqual((pair.first, pair.second, pair.pairs, pair.difference, pair.p), ("1", "2", 6, 10.0, 0.03125))
        self.assertEqual(pair.corrected, 4 * 0.03125)
        self.assertEqual(found["m.x", "a.c"][0].difference, 1.0)
        self.assertEqual((found["m.y", "a.b"][0].p, found["m.y", "a.b"][0].corrected), (1.0, 1.0))

    def test_names_of_any_kind_are_columns(self):
        for name in ('"l.comma,', "a$b_c^.x", "\u6c49.x", "l" * 500 + ".x", "<b>.x", "%s.x"):
            with self.subTest(name):
                file = self.grid((name,))
                self.assertEqual(read_results(file).columns.metrics, (name,))
                for report in ("a.png", "a.html"):
                    write_report(file, str(self.folder / report))

    def test_mistakes_are_reported_with_their_line(self):
        text = pathlib.Path(self.grid()).read_text()
        for old, new, message in (("m.x\n", "a.b\n", "1: found the column 'a.b' 2 times, allowed: once"),
                                  (",3,,7,", ",three,,7,", "4: seed: found 'three', allowed: a whole number from 0 to "
                                   "18446744073709551615"),
                                  (",3,,7,", ",3,maybe,7,", "4: success: found 'maybe', allowed: true, false, or nothing"),
                                  (",3,,7,0.25", ",3,,7,", "4: wall_s: found '', allowed: a number from 0 on"),
                                  (",3,,7,0.25,00ff", ",3,,7,0.25,00fg", "4: state_hash: found '00fg00ff00ff00ff', allowed: 16 hexadecimal "
                                   "digits, or nothing"),
                                  (",3,,7,", ",2,,7,", "4: found a run a second time, allowed: once"),
                                  (",3,,7,", ",3,7,", "4: found 12 values, allowed: 13")):
            (self.folder / "bad.csv").write_text(text.replace(old, new, 1))
            with self.assertRaises(BadInput) as caught:
                read_results(str(self.folder / "bad.csv"))
            self.assertEqual(str(caught.exception), f"{self.folder}/bad.csv:{message}")

    def test_libraries_do_not_warn_on_the_terminal(self):
        file = self.written(("a.b",), ("m.x", "m.y"), [(value, seed, [float(seed == 1) * (value == "2"), 1e308 * (-1) ** seed])
                                                       for value in ("1", "2") for seed in range(1, 4)])
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for report in ("a.png", "a.html"):
                write_report(file, str(self.folder / report))

    def test_the_title_of_a_picture_has_room_of_its_own(self):
        for metrics in (1, 2, 16):
            results = read_results(self.grid(tuple(f"m.x{i}" for i in range(metrics))))
            dark = {title: image.imread(io.BytesIO(plots.all_pictures(results, title)))[..., :3].min(axis=2) < 0.5
                    for title in ("", "gap: 24 runs, 8 seeds")}
            height = int(0.5 * 110)   # pixels of the title
            without, with_title = dark.values()
            self.assertEqual(without.shape, with_title.shape)
            self.assertFalse(without[:height].any(), "something of a plot is where the title is")
            self.assertTrue(with_title[:height].any())
            numpy.testing.assert_array_equal(without[height:], with_title[height:], "the title is over a plot")


if __name__ == "__main__":
    unittest.main()
