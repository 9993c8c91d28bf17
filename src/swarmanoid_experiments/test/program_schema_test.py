#!/usr/bin/env python3
"""`swarmanoid schema` describes all installed plugins, and with --suite only those of this project."""

import pathlib
import shutil
import subprocess
import unittest

from program_world import FINISHED, ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[3]
EXPERIMENTS = sorted((ROOT / "src/swarmanoid_experiments/experiments").glob("*.xml"))
ROBOT = ROOT / "examples/example_robot"


class SchemaTest(ProgramTest):
    def schema(self, *options):
        done = self.call("schema", *options)
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))
        return done.stdout

    def refusal(self, schema, experiment):
        """@return message of xmllint about the text of an experiment, empty if it is valid"""
        (self.folder / "schema.xsd").write_text(schema)
        (self.folder / "case.xml").write_text(experiment)
        done = subprocess.run(["xmllint", "--noout", "--schema", "schema.xsd", "case.xml"], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return "" if done.returncode == 0 else done.stderr

    def test_it_knows_what_installed_libraries_bring(self):
        schema, suite = self.schema(), self.schema("--suite")
        self.assertGreater(len(EXPERIMENTS), 5)
        for file in EXPERIMENTS:
            self.assertEqual(self.refusal(schema, file.read_text()), "", file)
        text = (ROOT / "src/swarmanoid_experiments/experiments/object_retrieval.xml").read_text()
        named = text.replace(' library="retrieval_monitor"', "")
        self.assertNotEqual(named, text)
        self.assertRegex(self.refusal(schema, named), "retrieval_monitor.*'library' is required")
        self.assertEqual(self.refusal(suite, named), "", "the suite alone does not know it")
        self.assertIn('name="rosbag_recorder"', suite)
        for name in ("diffusion", "retrieval_monitor"):
            self.assertIn(f'name="{name}"', schema)
            self.assertNotIn(f'name="{name}"', suite)

    def test_it_knows_installed_robots(self):
        text = (ROBOT / "e_pucks.xml").read_text()
        suite = self.schema("--suite")
        self.assertIn("e_puck", self.refusal(self.schema(), text))
        shutil.copytree(ROBOT, self.folder / "share/example_robot")
        self.put_before_prefixes()
        self.assertEqual(self.refusal(self.schema(), text), "")
        self.assertEqual(self.schema("--suite"), suite)

    def test_a_library_that_cannot_be_loaded_is_told_of_and_the_rest_described(self):
        before, suite = self.schema(), self.schema("--suite")
        declared = self.folder / "share/swarmanoid/plugins"
        declared.mkdir(parents=True)
        (declared / "gone").write_text("my_package\n")
        self.put_before_prefixes()
        done = self.call("schema")
        self.assertEqual((done.returncode, done.stdout), (FINISHED, before))
        warning = "swarmanoid: warning: package my_package: library 'gone': found no libgone.so in "
        self.assertTrue(done.stderr.startswith(warning), done.stderr)
        self.assertEqual(self.schema("--suite"), suite)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
