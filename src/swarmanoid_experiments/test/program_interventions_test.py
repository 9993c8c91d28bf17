#!/usr/bin/env python3
"""`swarmanoid run --interventions` applies the interventions of a file, and `--save-interventions` writes such a file."""

import pathlib
import re
import textwrap
import unittest

from program_world import BAD_INPUT, FINISHED, STOPPED, ProgramTest

DOCS = pathlib.Path(__file__).resolve().parents[3] / "docs"

FILE = """<interventions experiment="world" seed="1">
  <delete tick="3" entity="wall"/>
  <spawn tick="5" engines="ground">
    <footbot id="late"><position>4, 3.1, 0</position><orientation>0, 0, 33.3</orientation><controller>fc</controller></footbot>
  </spawn>
  <move tick="5" entity="fb"><position>7, 0.7, 0</position><orientation>0, 0, 45</orientation></move>
  <command_source tick="9" robot="fb" source="none"/>
</interventions>
"""


class InterventionsTest(ProgramTest):
    def write(self, text=FILE, name="done.xml"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def hashes(self, *arguments, name="hashes.txt", **world):
        summary = self.run_world("--hashes", self.folder / name, *arguments, **world)
        return summary, [line.split()[1] for line in (self.folder / name).read_text().splitlines()]

    def test_what_was_done_can_be_done_again_from_what_was_saved(self):
        _, plain = self.hashes()
        first, done = self.hashes("--interventions", self.write(), "--save-interventions", self.folder / "saved.xml")
        self.assertEqual(done[:4], plain[:4], "before the first one")
        self.assertNotEqual(done[4], plain[4], "tick 3 makes the state of line 4")
        self.assertEqual(first["ticks"], 20)
        saved = (self.folder / "saved.xml").read_text()
        self.assertRegex(saved, r'^<interventions experiment="world" seed="1">\n  <delete tick="3" entity="wall"/>\n')
        self.assertIn('  <spawn tick="5" engines="ground">\n    <footbot id="late">\n      <position>4, 3.1, 0</position>\n', saved)
        self.assertIn('<controller>fc</controller>', saved)
        self.assertTrue(saved.endswith('  <command_source tick="9" robot="fb" source="none"/>\n</interventions>\n'), saved)
        second, again = self.hashes("--interventions", self.folder / "saved.xml", "--save-interventions",
                                    self.folder / "saved again.xml")
        self.assertEqual(again, done)
        self.assertEqual(second["state_hash"], first["state_hash"])
        self.assertEqual((self.folder / "saved again.xml").read_text(), saved)

    def test_a_run_in_which_nothing_was_done_has_a_file_that_says_so(self):
        self.run_world("--save-interventions", self.folder / "saved.xml")
        self.assertEqual((self.folder / "saved.xml").read_text(),
                         '<interventions experiment="world" seed="1">\n</interventions>\n')

    def test_one_that_is_refused_ends_the_run_with_the_reason(self):
        file = self.write('<interventions>\n<delete tick="2" entity="wall"/>\n<delete tick="4" entity="wall"/>\n</interventions>')
        done = self.call("run", self.world(), "--quiet", "--out", self.out, "--interventions", file)
        self.assertEqual(done.returncode, STOPPED, done.stderr)
        self.assertEqual(done.stderr, f"swarmanoid: stopped in tick 4: {file}:3: <delete> is refused in tick 4: there is no "
                                      "entity 'wall'\n")
        self.assertIn('"ticks":4', done.stdout.replace(" ", ""))

    def test_nobody_waits_for_a_participant_that_cannot_come(self):
        file = self.write('<interventions><command_source tick="2" robot="fb" source="remote"/></interventions>')
        done = self.call("run", self.world(), "--quiet", "--out", self.out, "--interventions", file)
        self.assertEqual(done.returncode, STOPPED, done.stderr)
        self.assertIn("'fb' cannot be commanded by remote: no process elsewhere can answer here, that needs ROS\n", done.stderr)

    def test_nobody_is_spawned_whom_nobody_can_command(self):
        for source, reason in (("remote", "no process elsewhere can answer here"), ("topics", "nobody listens to topics here")):
            file = self.write(f'''<interventions>
<spawn tick="2">
<footbot id="late"><position>4, 3.1, 0</position><orientation>0, 0, 0</orientation><controller source="{source}">fc</controller></footbot>
</spawn>
</interventions>''')
            done = self.call("run", self.world(visualisations=""), "--quiet", "--interventions", file)
            self.assertEqual(done.returncode, STOPPED, done.stderr)
            self.assertIn(f"{file}:3: 'late' cannot be commanded by {source}: {reason}, that needs ROS\n", done.stderr)

    def test_mistakes_in_the_file_are_bad_input(self):
        file = self.write('<interventions>\n<delte tick="2" entity="wall"/>\n</interventions>')
        self.assert_refused(f"{file}:2: found tag 'delte', allowed: spawn, delete, move, handover, engine_parameters, "
                            "command_source, property, paint, fault; did you mean 'delete'? (in <interventions>)",
                            "run", self.world(), "--interventions", file, "--out", self.out)
        done = self.call("run", self.world(), "--all-interventions")
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("--interventions", done.stderr)

    def test_the_file_that_is_played_is_not_written(self):
        file = self.write()
        self.assert_refused(f"--save-interventions: found '{file}', which this run reads, allowed: another name",
                            "run", self.world(visualisations=""), "--interventions", file, "--save-interventions", file, "--force")
        self.assertEqual(file.read_text(), FILE)

    def test_what_is_strange_is_a_warning(self):
        file = self.write('<interventions experiment="other" seed="8"><delete tick="20" entity="wall"/></interventions>')
        done = self.call("run", self.world(visualisations=""), "--quiet", "--interventions", file)
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertEqual(done.stderr.splitlines(), [
            f"swarmanoid: warning: {file}: recorded with the experiment 'other', played into 'world'",
            f"swarmanoid: warning: {file}: recorded with the seed 8, played into a run with the seed 1",
            f"swarmanoid: warning: {file}:1: 1 intervention from tick 20 on will not be played, the run ends after 20 ticks"])

    def test_what_rules_asked_for_is_played_if_that_is_wanted(self):
        file = self.write('<interventions><delete tick="2" by="rule \'x\' (y)" entity="wall"/></interventions>')
        _, plain = self.hashes()
        _, left_out = self.hashes("--interventions", file)
        self.assertEqual(left_out, plain)
        _, played = self.hashes("--interventions", file, "--all-interventions")
        self.assertEqual(played[:3], plain[:3])
        self.assertNotEqual(played[3], plain[3])

    def test_the_visualisation_of_an_experiment_file_writes_the_same(self):
        file = self.write()
        self.run_world("--interventions", file, "--save-interventions", self.folder / "saved.xml",
                       visualisations='<intervention_recorder id="r"><file>r.xml</file></intervention_recorder>')
        self.assertEqual((self.out / "r.xml").read_text(), (self.folder / "saved.xml").read_text())

    def test_the_listing_of_the_page_can_be_read(self):
        page = (DOCS / "reference/intervention_file.md").read_text()
        listing = re.search(r"^    <interventions.*?^    </interventions>$", page, re.M | re.S)
        done = self.call("run", "object_retrieval", "--ticks", 1, "--quiet", "--interventions",
                         self.write(textwrap.dedent(listing.group())))
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertIn("on will not be played, the run ends after 1 ticks", done.stderr)


if __name__ == "__main__":
    unittest.main()
