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
        self.section = f"{self.page}, section 'whistle'"

    def problems(self, description=WHISTLE):
        return device_pages.problems(device_pages.by_device(description), self.folder, COMMAND)

    def rewrite(self, description=WHISTLE):
        return device_pages.rewrite(device_pages.by_device(description), self.folder)

    def write_law(self):
        self.page.write_text(self.page.read_text() + "\nAs loud as its field says.\n\n### Topics\n")

    def assert_one_problem(self, start, *contained, description=WHISTLE):
        wrong = self.problems(description)
        self.assertEqual(1, len(wrong), wrong)
        self.assertTrue(wrong[0].startswith(start), wrong[0])
        for text in contained:
            self.assertIn(text, wrong[0])

    def test_what_the_program_prints_is_taken_apart(self):
        both = device_pages.by_device("# bell\n\nSensor.\n\n## Implementation `default`\n\n" + WHISTLE)
        self.assertEqual({"bell": "# bell\n\nSensor.\n\n## Implementation `default`\n", "whistle": WHISTLE}, both)

    def test_a_device_without_a_section_gets_one_that_lacks_its_law(self):
        self.assert_one_problem(f"{self.folder}: found no section 'whistle'", COMMAND)
        self.assertEqual([self.page], self.rewrite())
        self.assert_one_problem(f"{self.section}: found nothing under '### Law'")
        self.write_law()
        self.assertEqual([], self.problems())
        self.assertEqual([], self.rewrite(), "nothing is left to write")

    def test_a_new_section_is_added_to_a_page_of_its_name(self):
        both = WHISTLE + "# flute\n\nActuator. Plays.\n"
        self.rewrite()
        self.write_law()
        self.page.rename(self.folder / "flute.md")
        before = (self.folder / "flute.md").read_text()
        self.assertEqual([self.folder / "flute.md"], self.rewrite(both))
        self.assertTrue((self.folder / "flute.md").read_text().startswith(before))
        self.assert_one_problem(f"{self.folder / 'flute.md'}, section 'flute': found nothing under '### Law'", description=both)

    def test_sections_are_found_in_any_page_and_text_outside_them_stays(self):
        both = WHISTLE + "\n# bell\n\nSensor. Rings.\n\n## Implementation `default`\n\nIt rings.\n"
        intro = "# Sounds\n\nWhistles and bells.\n\n"
        page = self.folder / "sounds.md"
        sections = [f"{device_pages.BEGIN}\n## {name}\n\n{device_pages.END}\n### Law\n\nThat of {name}.\n" for name in ("whistle", "bell")]
        page.write_text(intro + "\n".join(sections))
        self.assertEqual([page], self.rewrite(both))
        self.assertEqual([], self.problems(both))
        text = page.read_text()
        self.assertTrue(text.startswith(intro + device_pages.BEGIN), text)
        self.assertIn(f"\nThat of whistle.\n\n{device_pages.BEGIN}\n## bell\n\nSensor. Rings.\n\n### Implementation `default`\n", text)
        self.assertTrue(text.endswith("\n### Law\n\nThat of bell.\n"), text)

    def test_the_header_is_a_link_into_the_sources(self):
        self.rewrite()
        self.assertIn("\n- Struct: `Whistle` of [`my_robots/whistle.hpp`](../../../src/my_robots/include/my_robots/whistle.hpp)\n",
                      self.page.read_text())

    def test_what_the_code_says_anew_is_written_and_the_law_stays(self):
        self.rewrite()
        self.write_law()
        louder = WHISTLE.replace("a noise", "much noise")
        self.assert_one_problem(f"{self.section}: found other than what the code says", COMMAND, "-Actuator. Makes a noise.",
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

    def test_a_page_of_no_device_is_reported(self):
        self.rewrite()
        self.write_law()
        trumpet = self.folder / "trumpet.md"
        trumpet.write_text("")
        self.assert_one_problem(f"{trumpet}: found no section of a device")
        trumpet.write_text("# trumpet\n\n## trumpet\n\n### Law\n")
        self.assert_one_problem(f"{trumpet}, section 'trumpet': found no device 'trumpet'")

    def test_a_second_section_of_a_device_is_reported(self):
        self.rewrite()
        self.write_law()
        copy = self.folder / "z.md"
        shutil.copy(self.page, copy)
        self.assert_one_problem(f"{copy}, section 'whistle': found another one in {self.page}")

    def test_a_section_without_the_comments_is_reported_and_not_touched(self):
        for text in ("## whistle\n\n### Law\n\nIt whistles.\n", f"{device_pages.BEGIN}\n## whistle\n\n### Law\n\nIt whistles.\n",
                     f"## whistle\n{device_pages.END}\n### Law\n\nIt whistles.\n"):
            with self.subTest(text):
                self.page.write_text(text)
                self.assertEqual([], self.rewrite())
                self.assertEqual(text, self.page.read_text())
                self.assert_one_problem(f"{self.section}: found no part from the code", COMMAND)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
