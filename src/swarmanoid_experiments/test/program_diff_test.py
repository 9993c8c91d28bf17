#!/usr/bin/env python3
"""`swarmanoid diff` names the tick and the fields in which recorded runs diverge, or reports that they are equal."""

import re
import unittest

import rosbag

from program_world import BAD_INPUT, FINISHED, WORLD, ProgramTest

EQUAL, DIFFERS = 0, 1
ALL = ("--record-state", "--record-controllers", "all")


class DiffTest(ProgramTest):
    def record(self, bag, *options, experiment="object_retrieval", what=ALL):
        done = self.call("run", experiment, "--quiet", "--bag", bag, *what, *options)
        self.assertEqual(done.returncode, FINISHED, done.stderr)

    def diff(self, *arguments, code=EQUAL):
        done = self.call("diff", *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout if code != BAD_INPUT else done.stderr

    def test_two_runs_of_one_seed_are_equal_with_any_number_of_threads(self):
        self.record("a.bag", "--ticks", 40, "--threads", 1)
        self.record("b.bag", "--ticks", 40, "--threads", 2)
        self.assertRegex(self.diff("a.bag", "b.bag"),
                         r"^equal: 41 ticks, \d{4,} fields of all named state, \d{4,} bytes of readings and commands\n$")

    def test_another_seed_differs_from_the_first_tick(self):
        self.record("a.bag", "--ticks", 3)
        self.record("b.bag", "--ticks", 3, "--seed", 9)
        first, *fields = self.diff("a.bag", "b.bag", code=DIFFERS).splitlines()
        self.assertIn(first, ("first difference: before the first tick", "first difference: tick 0"))
        self.assertTrue(fields)

    def test_what_differs_first_is_named_first(self):
        """Slower robots differ in their commands before they differ in their positions."""
        radius = 0.029  # [m] of a wheel
        self.record("a.bag", "--ticks", 9, experiment="diffusion")
        self.record("b.bag", "--ticks", 9, "--set", "controllers.diffusion.parameters.speed=0.06", experiment="diffusion")
        lines = self.diff("a.bag", "b.bag", code=DIFFERS).splitlines()
        self.assertEqual(lines[0], "first difference: tick 0")
        self.assertEqual(lines[1], f"  fb_1/command footbot_wheels/left: {0.1 / radius!r} | {0.06 / radius!r}")
        more = self.diff("a.bag", "b.bag", "--fields", 1000, code=DIFFERS)
        self.assertRegex(more, r"\n  fb_\d+/pose/position/[xy]: \S+ \| \S+\n")
        self.assertNotIn("/reading ", more)
        self.assertNotIn("more fields", more)

    def test_a_property_is_named_with_its_entity(self):
        lamp = '<light id="lamp"><position>9, 9, 1</position><orientation>0, 0, 0</orientation></light></arena>'
        world = self.world(visualisations="", text=WORLD.replace("</arena>", lamp))
        self.record("a.bag", "--ticks", 2, experiment=world, what=("--record-state",))
        self.record("b.bag", "--ticks", 2, "--set", "arena.lamp.intensity=0.25", experiment=world, what=("--record-state",))
        self.assertEqual(self.diff("a.bag", "b.bag", code=DIFFERS),
                         "first difference: before the first tick\n  lamp/property/intensity: 1 | 0.25\n")

    def test_a_run_that_ends_before_the_other_differs(self):
        self.record("a.bag", "--ticks", 5)
        self.record("b.bag", "--ticks", 7)
        self.assertEqual(self.diff("a.bag", "b.bag", code=DIFFERS),
                         "first difference: tick 5 is in b.bag alone; before it all is equal\n")

    def test_bags_without_all_state_are_compared_as_far_as_they_go(self):
        self.record("a.bag", "--ticks", 5, what=())
        self.record("b.bag", "--ticks", 5)
        done = self.call("diff", "a.bag", "b.bag")
        self.assertEqual(done.returncode, DIFFERS)
        self.assertRegex(done.stdout, r"^first difference: tick 0\n  \w+/reading \S+: not recorded \| ")
        self.record("c.bag", "--ticks", 5, what=())
        done = self.call("diff", "a.bag", "c.bag")
        self.assertEqual(done.returncode, EQUAL)
        self.assertRegex(done.stdout, r"^equal: 6 ticks, \d+ fields of the world state\n$")
        self.assertEqual(done.stderr, "not compared: joints, LEDs, attachments, properties; readings and commands; record both runs "
                         "with --record-state and --record-controllers all\n")

    def test_every_field_of_the_world_state_is_in_the_named_state(self):
        self.record("a.bag", "--ticks", 2)
        with rosbag.Bag(str(self.folder / "a.bag")) as bag:
            states = [message for _, message, _ in bag.read_messages("/space/named_state")]
            world = next(message for _, message, _ in bag.read_messages("/space/world_state"))
        self.assertEqual([state.tick for state in states], [0, 1, 2])
        names = states[0].names
        values = dict(zip(names, list(states[0].numbers) + list(states[0].texts)))
        self.assertEqual(len(values), len(names), "no name twice")
        self.assertEqual(states[1].names, [], "names as before are not said again")
        for name, pose, twist, engine in zip(world.names, world.poses, world.twists, world.engines):
            self.assertEqual(values[f"{name}/pose/position/x"], pose.position.x)
            self.assertEqual(values[f"{name}/pose/orientation/w"], pose.orientation.w)
            self.assertEqual(values[f"{name}/twist/angular/z"], twist.angular.z)
            if f"{name}/engine" in values:
                self.assertEqual(values[f"{name}/engine"], engine)
        quantities = {re.sub(r"/\d+", "/N", name.split("/", 1)[1]) for name in names}
        for quantity in ("gripped", "led/N/red", "joint/turret/angle", "joint/turret/effort", "color/N/red", "outside"):
            self.assertIn(quantity, quantities)

    def test_folders_with_one_bag_are_runs(self):
        for name in ("a", "b"):
            (self.folder / name).mkdir()
            self.record(f"{name}/run.bag", "--ticks", 2)
        self.assertIn("equal: 3 ticks", self.diff("a", "b"))
        (self.folder / "b/second.bag").write_bytes((self.folder / "b/run.bag").read_bytes())
        self.assertEqual(self.diff("a", "b", code=BAD_INPUT), "swarmanoid: b: found 2 bags in this folder, allowed: one\n")

    def test_other_files_are_refused(self):
        (self.folder / "text.bag").write_text("text")
        self.assertRegex(self.diff("text.bag", "text.bag", code=BAD_INPUT), r"^swarmanoid: text\.bag: cannot be read: ")
        self.assertIn("RUN2 is required", self.diff("text.bag", code=BAD_INPUT))


if __name__ == "__main__":
    unittest.main()
