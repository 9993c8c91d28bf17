#!/usr/bin/env python3
"""`swarmanoid rerun` repeats a recorded run from a folder or a bag, compares each tick, and forks it."""

import json
import os
import shutil
import signal
import subprocess
import time
import unittest

import rosbag
import rospy

from program_world import BAD_INPUT, CONTROLLER_FAILED, FINISHED, INTERRUPTED, STOPPED, TABLE, ProgramTest

DIFFERS = 1
DONE = """<interventions>
  <delete tick="3" entity="wall"/>
  <move tick="5" entity="fb"><position>7, 0.7, 0</position><orientation>0, 0, 45</orientation></move>
</interventions>
"""


class RerunTest(ProgramTest):
    def record(self, *options, **world):
        """Records the small experiment in `done`. @return its summary"""
        (self.folder / "done.xml").write_text(DONE)
        return self.run_world("--record", self.folder / "done", "--interventions", self.folder / "done.xml", *options, **world)

    def rerun(self, *arguments, code=FINISHED):
        done = self.call("rerun", *arguments)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def wait_for_hashes(self):
        """Waits until the record of a run in progress has some thousands of hashes."""
        hashes = self.folder / "done/hashes.txt"
        until = time.monotonic() + 30
        while time.monotonic() < until and not (hashes.exists() and hashes.stat().st_size > 100000):
            time.sleep(0.05)

    def forget(self, *names):
        """Removes the run's input files, and moves the record elsewhere."""
        for name in ("world.xml", "done.xml", *names):
            (self.folder / name).unlink()
        shutil.rmtree(self.out)
        (self.folder / "far").mkdir()
        return shutil.move(str(self.folder / "done"), str(self.folder / "far/away"))

    def test_a_folder_needs_nothing_else(self):
        summary = self.record("--seed", 18446744073709551615, "--set", "arena.bounded=true", "--ticks", 17)
        files = {file.name for file in (self.folder / "done").iterdir()}
        self.assertEqual(files, {"record.xml", "experiment.xml", "interventions.xml", "hashes.txt", "result.json"})
        self.assertEqual(json.loads((self.folder / "done/result.json").read_text()), summary)
        table = (self.out / "table.txt").read_text()
        self.assertIn("with arena.bounded=true\n", table)
        folder = self.forget()
        before = sorted(self.folder.rglob("*"))
        done = self.rerun(folder)
        self.assertEqual((done.stdout, done.stderr), ("each of 17 ticks has the state of the recorded run\n", ""))
        self.assertEqual(sorted(self.folder.rglob("*")), before, "the table of the visualisation is removed")
        done = self.rerun(folder, "--out", self.folder / "again", "--hashes", "hashes.txt", "--threads", 2,
                          "--save-interventions", "again.xml")
        self.assertEqual((self.folder / "hashes.txt").read_text(), (self.folder / "far/away/hashes.txt").read_text())
        self.assertEqual((self.folder / "again.xml").read_text(), (self.folder / "far/away/interventions.xml").read_text())
        self.assertEqual((self.folder / "again/table.txt").read_text(), table)

    def test_images_come_from_the_record(self):
        self.call("run", "rough_terrain", "--ticks", 12, "--quiet", "--record", "done", "--out", "out")
        self.assertEqual(len(list((self.folder / "done/files").iterdir())), 1)
        self.assertEqual(self.rerun("done").stdout, "each of 12 ticks has the state of the recorded run\n")
        run = self.call("run", "done/experiment.xml", "--ticks", 12, "--quiet", "--hashes", "h.txt", "--out", "out2")
        self.assertEqual(run.returncode, FINISHED, run.stderr)
        self.assertEqual((self.folder / "h.txt").read_text(), (self.folder / "done/hashes.txt").read_text())

    def test_a_bag_needs_nothing_else(self):
        self.record("--bag", self.folder / "run.bag")
        self.forget()
        self.assertEqual(self.rerun("run.bag").stdout, "each of 20 ticks has the state of the recorded run\n")
        self.assertEqual(self.rerun("run.bag", "--until", 4).stdout, "each of 4 ticks has the state of the recorded run\n")
        self.assertIn("found no run 1, allowed: 0", self.rerun("run.bag", "--run", 1, code=BAD_INPUT).stderr)

    def test_a_bag_with_every_third_state_is_compared_in_these(self):
        every = '<rosbag_recorder id="b"><file>run.bag</file><every>3</every></rosbag_recorder>'
        self.run_world(visualisations=every)
        self.assertEqual(self.rerun(self.out).stdout, "7 states, one in 3 ticks and the last after 18, are those of the recorded run\n")

    def test_interventions_of_a_bag_are_played(self):
        self.record("--bag", self.folder / "run.bag")
        self.run_world("--interventions", self.folder / "run.bag", "--hashes", self.folder / "again.txt", visualisations="")
        self.assertEqual((self.folder / "again.txt").read_text(), (self.folder / "done/hashes.txt").read_text())

    def test_the_first_tick_that_differs_is_named(self):
        self.record()
        hashes = self.folder / "done/hashes.txt"
        lines = hashes.read_text().splitlines()
        found = lines[12].split()[1]
        lines[12] = "12 0123456789abcdef"
        hashes.write_text("\n".join(lines) + "\n")
        self.assertEqual(self.rerun("done", code=DIFFERS).stdout,
                         f"first difference: tick 11, state hash 0123456789abcdef | {found}\n")
        self.rerun("done", "--until", 11)

    def test_a_fork_parts_in_its_tick(self):
        self.record()
        done = self.rerun("done", "--until", 8, "--set", "arena.fb.controller.source=none", "--set", "framework.maxclock=30",
                          "--hashes", "fork.txt", "--save-interventions", "fork.xml")
        verdict, summary = done.stdout.splitlines()
        self.assertEqual(verdict, "each of 8 ticks has the state of the recorded run")
        summary = json.loads(summary)
        self.assertEqual(summary["ticks"], 30)
        self.assertEqual(summary["overrides"], ["--until 8", "--set arena.fb.controller.source=none",
                                                "--set framework.maxclock=30"])
        recorded = (self.folder / "done/hashes.txt").read_text().splitlines()
        fork = (self.folder / "fork.txt").read_text().splitlines()
        self.assertEqual(fork[:9], recorded[:9])
        self.assertNotEqual(fork[9], recorded[9])
        self.assertIn('<command_source tick="8" robot="fb" source="none"/>', (self.folder / "fork.xml").read_text())

    def test_another_seed_holds_from_its_tick_on(self):
        self.call("run", "diffusion", "--ticks", 20, "--quiet", "--record", "done", "--out", "out",
                  "--set", "controllers.diffusion.sensors.footbot_proximity.noise=0.1")
        done = self.rerun("done", "--until", 10, "--hashes", "fork.txt", "--seed", 9)
        self.assertEqual(json.loads(done.stdout.splitlines()[1])["seed"], 9)
        recorded = (self.folder / "done/hashes.txt").read_text().splitlines()
        fork = (self.folder / "fork.txt").read_text().splitlines()
        self.assertEqual((len(fork), fork[:11]), (21, recorded[:11]))
        self.assertEqual([i for i in range(11, 21) if fork[i] == recorded[i]], [])

    def test_what_cannot_change_in_the_middle_is_refused_with_what_can(self):
        self.record()
        can = ("allowed in the middle of a run: framework.maxclock, engines.ENGINE.PARAMETER of a parameter that may change "
               "while it runs, arena.ENTITY.PROPERTY, arena.ROBOT.controller.source")
        for setting, reason in (
                ("framework.clocktick=20", f"--set framework.clocktick: found a value that is read when a run begins, {can}"),
                ("engines.ground.subclock=2", "--set engines.ground.subclock: found 'subclock', which is no parameter of "
                                              f"kinematics2d that may change, {can}"),
                ("engines.air.gravity=2", f"--set engines.air.gravity: found no engine 'air', {can}"),
                ("arena.fb.controller.source=topics",
                 "--set arena.fb.controller.source: found 'topics', allowed: controller, none"),
                ("framework.maxclock=7", "--set framework.maxclock: found 7, allowed: from 8 on, which --until says")):
            with self.subTest(setting=setting):
                self.assert_refused(reason, "rerun", "done", "--until", 8, "--set", setting)
        self.assert_refused("--seed: found no --until, allowed: --until TICK, from which on it holds",
                            "rerun", "done", "--seed", 3)
        self.assert_refused("--until: found 21, allowed: from 0 to 20, where the record ends",
                            "rerun", "done", "--until", 21)

    def test_other_versions_and_libraries_are_warnings(self):
        self.record()
        file = self.folder / "done/record.xml"
        text = file.read_text()
        head, _, tail = text.partition('<library name="libfailing_controller.so" hash="')
        self.assertTrue(tail, text)
        old = tail[:16]
        file.write_text(head.replace('version="', 'version="0.') + '<library name="libfailing_controller.so" hash="' +
                        "0" * 16 + tail[16:])
        lines = self.rerun("done").stderr.splitlines()
        self.assertRegex(lines[0], r"^swarmanoid: warning: recorded with the version 0\.\S+, made again with \S+$")
        self.assertEqual(lines[1], "swarmanoid: warning: recorded with another libfailing_controller.so: its hash was "
                         f"{'0' * 16}, and is {old}")

    def test_a_run_in_which_a_controller_failed_is_made_again(self):
        self.record(fail_at=4, code=CONTROLLER_FAILED)
        self.assertEqual(self.rerun("done").stdout, "each of 20 ticks has the state of the recorded run\n")

    def test_a_run_that_was_stopped_is_made_again_up_to_there(self):
        plan = '<interventions><delete tick="2" entity="wall"/><delete tick="7" entity="gone"/></interventions>'
        (self.folder / "plan.xml").write_text(plan)
        self.run_world("--record", self.folder / "done", "--interventions", self.folder / "plan.xml", code=STOPPED)
        self.assertEqual(self.rerun("done").stdout, "each of 7 ticks has the state of the recorded run\n")

    def test_a_run_that_was_interrupted_is_made_again_up_to_there(self):
        process = subprocess.Popen(["swarmanoid", "run", self.world(maxclock=1000000000, visualisations=""), "--quiet",
                                    "--record", "done"], cwd=self.folder, stdout=subprocess.PIPE, encoding="utf-8")
        self.wait_for_hashes()
        process.send_signal(signal.SIGINT)
        summary = json.loads(process.communicate(timeout=30)[0])
        self.assertEqual(process.returncode, INTERRUPTED)
        done = self.rerun("done")
        self.assertEqual((done.stdout, done.stderr),
                         (f"each of {summary['ticks']} ticks has the state of the recorded run\n", ""))

    def test_a_killed_run_is_made_again_as_far_as_it_is_recorded(self):
        process = subprocess.Popen(["swarmanoid", "run", self.world(maxclock=1000000000, visualisations=""), "--quiet",
                                    "--record", "done"], cwd=self.folder, stdout=subprocess.DEVNULL)
        self.wait_for_hashes()
        process.send_signal(signal.SIGKILL)
        process.wait()
        done = self.rerun("done", "--until", 500)
        self.assertEqual(done.stdout, "each of 500 ticks has the state of the recorded run\n")
        self.assertRegex(done.stderr, r"^swarmanoid: warning: the run has no result: it was killed, or is not over; what there "
                         r"is ends with tick \d+\n$")

    def test_damaged_records_are_refused_with_the_file(self):
        self.record()
        hashes = self.folder / "done/hashes.txt"
        text = hashes.read_text()
        hashes.write_text("".join(line + "\n" for line in text.splitlines()[:15]))
        self.assert_refused("done/hashes.txt: found state hashes up to tick 14, allowed: up to tick 20, as result.json has it",
                            "rerun", "done")
        hashes.unlink()
        self.assert_refused("done/hashes.txt: cannot be read", "rerun", "done")
        hashes.write_text(text)
        (self.folder / "done/result.json").write_text("ticks: 20")
        self.assert_refused("done/result.json: found no JSON object with 'ticks', allowed: the summary of the run",
                            "rerun", "done")
        (self.folder / "done/result.json").unlink()
        os.mkfifo(self.folder / "done/result.json")
        self.assert_refused("done/result.json: is a pipe or a device, allowed: a file", "rerun", "done")
        (self.folder / "done/result.json").unlink()
        with open(self.folder / "done/result.json", "w") as endless:
            endless.truncate(1 << 40)
        self.assert_refused("done/result.json: found a file without an end in sight, allowed: at most 268435456 characters", "rerun", "done")
        os.mkdir(self.folder / "empty")
        self.assert_refused("empty: found no record.xml and 0 bags in this folder, allowed: a folder of `swarmanoid run "
                            "--record`, or one with one bag", "rerun", "empty")
        (self.folder / "text.bag").write_text("text")
        self.assertRegex(self.rerun("text.bag", code=BAD_INPUT).stderr, r"^swarmanoid: text\.bag: cannot be read: ")

    def test_what_is_read_is_never_replaced(self):
        self.record("--bag", "run.bag", "--ticks", 9)
        for arguments in (("run.bag", "--until", 3, "--bag", "run.bag"), ("done", "--until", 3, "--hashes", "done/hashes.txt"),
                          ("done", "--until", 3, "--save-interventions", "done/interventions.xml")):
            done = self.rerun(*arguments, "--force", code=BAD_INPUT)
            self.assertIn("which this run reads", done.stderr)
        for run in ("run.bag", "done"):
            self.assertEqual(self.rerun(run).stdout, "each of 9 ticks has the state of the recorded run\n")

    def test_what_is_there_is_not_replaced_unless_that_is_wanted(self):
        self.record()
        self.assert_refused("--record: found '" + str(self.folder / "done/record.xml") + "', which is there already, allowed: "
                            "another name, or --force to replace it",
                            "run", self.world(visualisations=""), "--record", "done")
        self.record()

    def edit_interventions(self, old, new):
        file = self.folder / "done/interventions.xml"
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new))

    def test_an_intervention_that_is_refused_stops_it(self):
        self.record()
        self.edit_interventions('tick="5" entity="fb"', 'tick="5" entity="gone"')
        done = self.rerun("done", code=STOPPED)
        self.assertEqual(done.stdout, "")
        self.assertIn("stopped in tick 5, up to which each has the state of the recorded run: ", done.stderr)
        self.assertIn("interventions.xml:3: <move> is refused in tick 5: there is no entity 'gone'", done.stderr)

    def test_an_intervention_that_is_refused_in_a_fork_stops_it(self):
        self.record()
        self.edit_interventions('tick="5" entity="fb"', 'tick="5" entity="gone"')
        done = self.rerun("done", "--until", 4, "--set", "arena.fb.controller.source=none", code=STOPPED)
        verdict, summary = done.stdout.splitlines()
        self.assertEqual(verdict, "each of 4 ticks has the state of the recorded run")
        summary = json.loads(summary)
        self.assertEqual((summary["ticks"], summary["finished"]), (5, False))
        self.assertTrue(done.stderr.startswith("swarmanoid: stopped in tick 5: "), done.stderr)
        self.assertIn("interventions.xml:3: <move> is refused in tick 5: there is no entity 'gone'", done.stderr)

    def test_robots_that_others_commanded_are_refused_with_their_names(self):
        (self.folder / "plan.xml").write_text('<interventions><command_source tick="7" robot="fb" source="none"/></interventions>')
        self.run_world("--record", self.folder / "done", "--interventions", self.folder / "plan.xml")
        self.edit_interventions('source="none"', 'source="topics"')
        record = self.folder / "done/record.xml"
        record.write_text(record.read_text().replace('open="false"', 'open="true"'))
        self.assert_refused("done: found robots that other processes commanded (fb), whose commands are not in the record; "
                            "allowed: robots with controllers in the simulator's process", "rerun", "done")
        self.edit_interventions('source="topics"', 'source="controller"')
        self.assertEqual(self.rerun("done", "--until", 7).stdout, "each of 7 ticks has the state of the recorded run\n")

    def test_a_folder_may_have_the_record_in_it(self):
        self.record()
        (self.folder / "all").mkdir()
        (self.folder / "done").rename(self.folder / "all/record")
        self.assertEqual(self.rerun("all").stdout, "each of 20 ticks has the state of the recorded run\n")
        self.assert_refused("--run: found a folder, which has one run, allowed: a bag", "rerun", "all", "--run", 0)

    def test_of_a_bag_with_resets_any_run_is_made_again(self):
        self.record("--bag", self.folder / "first.bag", "--ticks", 11)
        self.run_world("--bag", self.folder / "second.bag", "--seed", 5)
        with rosbag.Bag(str(self.folder / "both.bag"), "w") as both:
            for number, name in enumerate(("first.bag", "second.bag")):
                with rosbag.Bag(str(self.folder / name)) as bag:
                    for topic, message, stamp in bag.read_messages():
                        if hasattr(message, "run"):
                            message.run = number
                        both.write(topic, message, stamp + rospy.Duration(100 * number))
        for options, ticks in (((), 20), (("--run", 0), 11), (("--run", 1), 20)):
            self.assertEqual(self.rerun("both.bag", *options).stdout, f"each of {ticks} ticks has the state of the recorded run\n")
        self.assertIn("found no run 2, allowed: ", self.rerun("both.bag", "--run", 2, code=BAD_INPUT).stderr)

    def test_visualisations_of_the_experiment_end_the_run_again(self):
        self.record(visualisations=TABLE, maxclock=3)
        self.assertEqual(self.rerun("done").stdout, "each of 3 ticks has the state of the recorded run\n")


if __name__ == "__main__":
    unittest.main()
