#!/usr/bin/env python3
"""The pages of docs/reference/devices/ contain what the code says of the suite's devices, and the law of each device."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "scripts"))
import device_pages  # noqa: E402  found through the line above

WHISTLE = "# whistle\n\nActuator. Makes a noise.\n\n- Robot: any\n- Struct: `Whistle` of `my_robots/whistle.hpp`\n"
COMMAND = "make pages"


class PagesOfTheSuiteTest(unittest.TestCase):
    def test_they_are_as_the_code_says(self):
        build = pathlib.Path(shutil.which("swarmanoid")).resolve().parents[2]
        said = subprocess.run(["swarmanoid", "describe"], check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        descriptions = device_pages.by_device(said)
        self.assertGreaterEqual(len(descriptions), 20)
        wrong = device_pages.problems(descriptions, device_pages.PAGES, f"scripts/device_pages.py --build {build}")
        self.assertEqual([], wrong, "\n" + "\n".join(wrong))


class WriterTest(unittest.TestCase):
    """Tests with one device that is not in the suite."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.page = self.folder / "whistle.md"

    def problems(self, description=WHISTLE):
        return device_pages.problems(device_pages.by_device(description), self.folder, COMMAND)

    def rewrite(self, description=WHISTLE):
        return device_pages.rewrite(device_pages.by_device(description), self.folder)

    def write_law(self):
        self.page.write_text(self.page.read_text() + "\nAs loud as its field says.\n\n## Topics\n")

    def assert_one_problem(self, start, *contained, description=WHISTLE):
        wrong = self.problems(description)
        self.assertEqual(1, len(wrong), wrong)
        self.assertTrue(wrong[0].startswith(start), wrong[0])
        for text in contained:
            self.assertIn(text, wrong[0])

    def test_what_the_program_prints_is_taken_apart(self):
        both = device_pages.by_device("# bell\n\nSensor.\n\n## Implementation `default`\n\n" + WHISTLE)
        self.assertEqual({"bell": "# bell\n\nSensor.\n\n## Implementation `default`\n", "whistle": WHISTLE}, both)

    def test_a_device_without_a_page_gets_one_that_lacks_its_law(self):
        self.assert_one_problem(f"{self.page}: not there", COMMAND)
        self.assertEqual([self.page], self.rewrite())
        self.assert_one_problem(f"{self.page}: found nothing under '## Law'")
        self.write_law()
        self.assertEqual([], self.problems())
        self.assertEqual([], self.rewrite(), "nothing is left to write")

    def test_the_header_is_a_link_into_the_sources(self):
        self.rewrite()
        self.assertIn("\n- Struct: `Whistle` of [`my_robots/whistle.hpp`](../../../src/my_robots/include/my_robots/whistle.hpp)\n",
                      self.page.read_text())

    def test_what_the_code_says_anew_is_written_and_the_law_stays(self):
        self.rewrite()
        self.write_law()
        louder = WHISTLE.replace("a noise", "much noise")
        self.assert_one_problem(f"{self.page}: found other than what the code says", COMMAND, "-Actuator. Makes a noise.",
                                "+Actuator. Makes much noise.", description=louder)
        before = self.page.read_text()
        self.assertEqual([self.page], self.rewrite(louder))
        self.assertEqual(before.replace("a noise", "much noise"), self.page.read_text())
        self.assertEqual([], self.problems(louder))

    def test_a_second_implementation_changes_no_page(self):
        quiet = "\n## Implementation `quiet`\n\nQuiet.\n\n{}- Engines: none\n"
        loud = "\n## Implementation `loud`\n\nLoud.\n"
        self.rewrite(WHISTLE + quiet.format(""))
        self.write_law()
        default = quiet.format("- The default: an experiment that names none means this one\n")
        for both in (default + loud, loud + default):
            self.assertEqual([], self.problems(WHISTLE + both))
            self.assertEqual([], self.rewrite(WHISTLE + both))

    def test_an_engine_more_changes_no_page(self):
        loud = "\n## Implementation `loud`\n\nLoud.\n\n- Engines: {}\n"
        self.rewrite(WHISTLE + loud.format("`one`"))
        self.write_law()
        self.assertNotIn("`one`", self.page.read_text())
        self.assertEqual([], self.problems(WHISTLE + loud.format("`one`, `two`")))

    def test_a_page_of_no_device_is_told_of(self):
        self.rewrite()
        self.write_law()
        (self.folder / "trumpet.md").write_text("")
        self.assert_one_problem(f"{self.folder / 'trumpet.md'}: found no device 'trumpet'")

    def test_a_page_without_the_comments_is_told_of_and_not_touched(self):
        self.page.write_text("# whistle\n\n## Law\n\nIt whistles.\n")
        self.assertEqual([], self.rewrite())
        self.assert_one_problem(f"{self.page}: found no part from the code", COMMAND)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
