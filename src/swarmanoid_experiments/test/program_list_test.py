#!/usr/bin/env python3
"""`swarmanoid list` prints all names of the schema and the reference page, and every installed plugin."""

import pathlib
import re
import unittest
import xml.etree.ElementTree

from program_world import BAD_INPUT, FINISHED, ProgramTest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs/reference/experiment_file.md"
HEADINGS = ["experiment", "framework", "controller", "sensor", "actuator", "error", "arena", "entity", "engine",
            "arena_physics", "rule", "visualisation", "realism"]
XSD = "{http://www.w3.org/2001/XMLSchema}"


def words(text):
    return set(re.findall(r"\w+", text))


class ListTest(ProgramTest):
    def list(self, *kind):
        done = self.call("list", *kind)
        self.assertEqual((done.returncode, done.stderr), (FINISHED, ""))
        return done.stdout

    def test_every_heading_can_be_asked_for(self):
        everything = self.list()
        self.assertEqual([line for line in everything.splitlines() if not line.startswith(" ")], HEADINGS)
        self.assertEqual("".join(self.list(heading) for heading in HEADINGS), everything)
        self.assertEqual(self.list("experiment"),
                         "experiment\n  aggregation\n  battery_foraging\n  chain_formation\n  charging\n  climbing\n  conformance\n"
                         "  diffusion\n  emergent_taxis\n  evolved_retrieval\n  eyebot_flocking\n  flocking\n  foraging\n  gap\n  group_pull\n"
                         "  neural_aggregation\n  neural_phototaxis\n  object_retrieval\n  phototaxis\n  predators\n"
                         "  rough_terrain\n  shelf_retrieval\n  trail\n  two_spot_foraging\n")
        sensors = self.list("sensor")
        self.assertIn("  footbot_proximity (polynomial, default): ", sensors)
        self.assertNotIn("footbot_wheels", sensors)
        self.assertIn("  typical: sensor eyebot_pressure: Bosch Sensortec BMP085, ", self.list("realism"))
        self.assert_refused("list: found 'sensors', allowed: " + ", ".join(HEADINGS) + "; did you mean 'sensor'?",
                            "list", "sensors")

    def test_no_name_of_the_schema_is_missing(self):
        listed = words(self.list())
        schema = xml.etree.ElementTree.fromstring(self.call("schema").stdout)
        names = {node.get("name") for kind in ("element", "attribute") for node in schema.iter(XSD + kind)} - {None}
        self.assertGreater(len(names), 80)
        self.assertEqual(names - listed - {"ahss-config"}, set())
        choices = {node.get("value") for node in schema.iter(XSD + "enumeration")}
        self.assertEqual(choices - listed, set())

    def test_no_name_of_the_page_s_tables_is_missing(self):
        listed = words(self.list())
        text = PAGE.read_text()
        text = text[:text.index("## Names of the thesis")]
        names = set()
        for row in re.findall(r"^\| (.*) \|$", text, re.M):
            names |= set(re.findall(r"`(\w+)`", row))
        self.assertGreater(len(names), 100)
        self.assertEqual(names - listed, set())

    def test_the_installed_controllers_are_named_with_their_packages(self):
        controllers = self.list("controller")
        sources = (ROOT / "src/swarmanoid_controllers").rglob("*.cpp")
        labels = {label for file in sources for label in re.findall(r'REGISTER_CONTROLLER\(.*"(\w+)"\)', file.read_text())}
        self.assertIn("diffusion", labels)
        for label in labels:
            self.assertIn(f'\n  {label}\n      in library="{label}" of swarmanoid_controllers\n', controllers)

    def test_plugins_that_need_a_library_say_which(self):
        visualisations = self.list("visualisation")
        self.assertRegex(visualisations,
                         '  retrieval_monitor: .*\n      in library="retrieval_monitor" of swarmanoid_experiments\n')
        for name in ("text_render: .*\n      file", "opengl_render: .*\n      window_size", "rosbag_recorder: .*\n      file",
                     "trajectory_recorder: .*\n      file"):
            self.assertRegex(visualisations, "  " + name)

    def test_a_library_that_cannot_be_loaded_is_told_of_and_the_rest_listed(self):
        before = self.list()
        declared = self.folder / "share/swarmanoid/plugins"
        declared.mkdir(parents=True)
        (declared / "gone").write_text("my_package\n")
        (declared / "broken").write_text("my_package\n")
        (self.folder / "lib").mkdir()
        (self.folder / "lib/libbroken.so").write_text("no library")
        self.put_before_prefixes()
        done = self.call("list")
        self.assertEqual((done.returncode, done.stdout), (FINISHED, before))
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 2, done.stderr)
        warning = "^swarmanoid: warning: package my_package: "
        self.assertRegex(lines[0], warning + "library 'broken' cannot be loaded: .*too short")
        self.assertRegex(lines[1], warning + "library 'gone': found no libgone.so in ")

    def test_only_the_suite_s_packages_have_libraries_that_are_loaded_for_every_experiment(self):
        declared = self.folder / "share/swarmanoid/plugins"
        declared.mkdir(parents=True)
        self.put_before_prefixes()
        for package, code in (("my_package", FINISHED), ("swarmanoid_more", BAD_INPUT)):
            (declared / "gone").write_text(f"{package}\nloaded always\n")
            done = self.call("schema", "--suite")
            self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, "^swarmanoid: package swarmanoid_more: library 'gone': found no libgone.so in ")


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
