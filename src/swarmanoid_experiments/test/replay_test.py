#!/usr/bin/env python3
"""Controllers recorded by the program `swarmanoid` repeat their commands in the program `replay`; changed ones do not."""

import json
import os
import shutil
import subprocess
import unittest

from program_world import BAD_INPUT, CONTROLLER_FAILED, FINISHED, WORLD, ProgramTest

EQUAL, DIFFERS = 0, 1
ROBOTS = ("eb", "fb_1", "fb_2", "fb_3")


def replay_program():
    return shutil.which("catkin_find") and subprocess.run(
        ["catkin_find", "--first-only", "--libexec", "swarmanoid_recording", "replay"],
        stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout.strip()


class ReplayTest(ProgramTest):
    def record(self, experiment, *options, robots="all", code=FINISHED):
        done = self.call("run", experiment, "--quiet", "--force", "--bag", "run.bag", "--record-controllers", robots, *options)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout)

    def replay(self, *arguments, code=EQUAL, environment=None):
        done = subprocess.run([replay_program(), "run.bag", *map(str, arguments)], cwd=self.folder, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", errors="replace",
                              check=False, env=environment)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout if code != BAD_INPUT else done.stderr

    def test_all_robots_of_a_retrieval_do_the_same_again(self):
        summary = self.record("object_retrieval", "--seed", 3)
        self.assertTrue(summary["success"])
        ticks = summary["ticks"]
        self.assertEqual(self.replay(), "".join(f"{robot}: all {ticks} ticks are equal\n" for robot in ROBOTS))
        self.assertEqual(self.call("run", "object_retrieval", "--seed", 3, "--quiet").stdout.split("state_hash")[1],
                         '":"' + summary["state_hash"] + '"}\n')

    def test_the_mathematics_are_those_of_the_run_in_any_environment(self):
        """With the functions that the C library selects by itself on processors with FMA, fb_1 differs in tick 571."""
        ticks = self.record("object_retrieval", "--seed", 4)["ticks"]
        without = {name: value for name, value in os.environ.items() if name != "GLIBC_TUNABLES"}
        self.assertEqual(self.replay("--robot", "fb_1", environment=without), f"fb_1: all {ticks} ticks are equal\n")

    def test_a_changed_parameter_shows_where_it_first_matters(self):
        self.record("object_retrieval", "--ticks", 50, robots="fb_2 eb")
        self.assertEqual(self.replay("--robot", "fb_2", "--parameters", "speed=0.15"),
                         "fb_2: all 50 ticks are equal\n")
        output = self.replay("--robot", "fb_2", "--parameters", "speed=0.145", code=DIFFERS)
        self.assertRegex(output, r"\Afb_2: \d+ of 50 ticks are equal\n"
                                 r"first difference: fb_2, tick 0, 0\.000 s\n"
                                 r"  footbot_wheels \(f8 f8\)\n"
                                 r"    left: recorded 5\.1724137931034475, replayed 4\.999999999999999\n"
                                 r"    right: recorded 5\.1724137931034475, replayed 4\.999999999999999\n"
                                 r"  readings\n"
                                 r"    footbot_proximity: [^\n]*\n"
                                 r"    footbot_camera: [^\n]*\n"
                                 r"    footbot_gripper_state: false\n"
                                 r"  debug values\n"
                                 r"    state: Search for Laser\n\Z")

    def test_a_failing_controller_fails_again(self):
        self.record(self.world(fail_at=3), code=CONTROLLER_FAILED)
        self.assertEqual(self.replay(), "fb: all 4 ticks are equal\n")
        self.assertEqual(self.replay("--parameters", "fail_at=7", code=DIFFERS),
                         "fb: 3 of 4 ticks are equal\n"
                         "first difference: fb, tick 3, 0.300 s\n"
                         "  the controller: recorded failed: told to, \ufffd, replayed stepped\n"
                         "    replayed footbot_wheels: 1 1\n")

    def test_another_controller_takes_its_place(self):
        self.record(self.world())
        output = self.replay("--controller", "swarmanoid_controllers/diffusion", code=BAD_INPUT)
        self.assertIn("replay: robot 'fb' (footbot) has no ", output)
        self.assertIn("library 'nobody': found no libnobody.so in ", self.replay("--controller", "nobody", code=BAD_INPUT))

    def test_a_table_of_what_was_recorded(self):
        self.record(self.world())
        self.assertEqual(self.replay("--print", "--from", 2, "--to", 3),
                         "#robot\ttick\ttime [s]\tkind\tname\tvalues\n"
                         "fb\t2\t0.200\tcommand\tfootbot_wheels\t1 1\n"
                         "fb\t3\t0.300\tcommand\tfootbot_wheels\t1 1\n")

    def test_bad_input_is_refused_with_what_there_is(self):
        self.record(self.world(), "--ticks", 5)
        self.assertEqual(self.replay("--robot", "fa", code=BAD_INPUT),
                         "replay: run.bag: found no recorded controller of 'fa', there are: fb; did you mean 'fb'?\n")
        self.assertEqual(self.replay("--from", 7, "--to", 3, code=BAD_INPUT),
                         "replay: --from: found 7, allowed: at most --to, 3\n")
        self.assertEqual(self.replay("--from", 5, code=BAD_INPUT),
                         "replay: --from, --to: found no tick in this range, allowed: 0 to 4\n")
        self.assert_refused(str(self.folder / "world.xml") + ": controllers of rosbag_recorder: found 'fa', allowed: "
                            "all, none, fb; did you mean 'fb'?",
                            "run", self.folder / "world.xml", "--quiet", "--force", "--bag", "no.bag", "--record-controllers", "fa")

    def test_a_wrong_parameter_is_blamed_on_where_it_was_given(self):
        self.record(self.world(), "--ticks", 5)
        unknown = "'failat' is not known in <parameters>; allowed: fail_at, talks; did you mean 'fail_at'?\n"
        malformed = "fail_at: found 'soon', allowed: a whole number\n"
        file = self.folder / "other.yaml"
        file.write_text("# other values\nfail_at: 3\nfailat: 3\n")
        self.assertEqual(self.replay("--parameters", file, code=BAD_INPUT), f"replay: {file}:3: {unknown}")
        file.write_text("\nfail_at: soon\n")
        self.assertEqual(self.replay("--parameters", "fail_at=1", "--parameters", file, code=BAD_INPUT),
                         f"replay: {file}:2: {malformed}")
        self.assertEqual(self.replay("--parameters", "failat=3", code=BAD_INPUT),
                         f"replay: --parameters failat: {unknown}")
        self.assertEqual(self.replay("--parameters", "fail_at=soon", code=BAD_INPUT),
                         f"replay: --parameters fail_at: {malformed}")

    def test_nothing_is_recorded_unless_asked_for(self):
        self.record(self.world(), robots="none")
        self.assertIn("run.bag: found no recorded controller, expected topics such as", self.replay(code=BAD_INPUT))

    def test_the_experiment_file_asks_for_it_too(self):
        recorder = ('<rosbag_recorder id="bag"><file>run.bag</file>'
                    '<controllers>fb</controllers></rosbag_recorder>')
        done = self.call("run", self.world(visualisations=recorder, text=WORLD), "--quiet")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertEqual(self.replay(), "fb: all 20 ticks are equal\n")


if __name__ == "__main__":
    unittest.main()
