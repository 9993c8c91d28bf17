#!/usr/bin/env python3
"""The program `swarmanoid`: exit codes, options, summaries, and files after errors."""

import json
import pathlib
import re
import unittest
import xml.etree.ElementTree

from program_world import BAD_INPUT, CONTROLLER_FAILED, FINISHED, STOPPED, WORLD, ProgramTest, table_of

FIELDS = ["version", "math_library", "experiment", "overrides", "seed", "ticks", "finished", "success", "metrics",
          "failed_controllers", "overflows", "wall_s", "real_time_factor", "robot_ticks_per_s", "state_hash"]
PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs/reference/program.md"
CROWD = "".join(f'<cylindric_prey id="prey_{i}"><position>3, {3 + 0.5 * i}, 0</position><orientation>0, 0, 0</orientation>'
                "<radius>0.05</radius><height>0.1</height></cylindric_prey>" for i in range(3))


class RunTest(ProgramTest):
    def test_a_summary_has_the_documented_fields(self):
        summary = self.run_world()
        self.assertEqual(list(summary), FIELDS)
        self.assertEqual(summary["experiment"], "world")
        self.assertEqual((summary["seed"], summary["ticks"], summary["finished"]), (1, 20, True))
        self.assertIsNone(summary["success"])
        self.assertEqual((summary["metrics"], summary["failed_controllers"]), ({}, []))
        self.assertEqual((summary["overrides"], summary["overflows"]), ([], {}))
        self.assertEqual("swarmanoid " + summary["version"] + "\n", self.call("--version").stdout)
        page = PAGE.read_text()
        for field in FIELDS:
            self.assertIn(f"| `{field}` |", page)
        self.assertRegex(summary["state_hash"], "^[0-9a-f]{16}$")
        self.assertAlmostEqual(summary["real_time_factor"], 2.0 / summary["wall_s"], delta=1e-3 / summary["wall_s"])
        self.assertAlmostEqual(summary["robot_ticks_per_s"], 20 / summary["wall_s"], delta=1e-2 / summary["wall_s"])

    def test_an_experiment_that_fails_at_its_task_is_finished_all_the_same(self):
        done = self.call("run", "object_retrieval", "--ticks", 5, "--quiet")
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertIn('"success":false', done.stdout)
        self.assertIn('"prey_in_nest":""', done.stdout)

    def test_a_failing_controller_is_named_and_the_run_goes_on(self):
        summary = self.run_world(fail_at=3, code=CONTROLLER_FAILED)
        self.assertEqual((summary["ticks"], summary["finished"]), (20, True))
        self.assertEqual(summary["failed_controllers"], [{"robot": "fb", "tick": 3, "reason": "told to, \ufffd"}])
        self.assertEqual(len((self.out / "table.txt").read_text().splitlines()), 3 + 21 * 2)

    def test_the_seed_is_the_file_s_or_the_option_s(self):
        hashes = []
        for options in ([], ["--seed", 1], ["--seed", 18446744073709551615], ["--set", "framework.random_seed=7"]):
            done = self.call("run", "diffusion", "--ticks", 3, "--quiet", *options)
            self.assertEqual(done.returncode, FINISHED, done.stderr)
            hashes.append(re.search('"seed":(\\d+).*"state_hash":"(.*)"', done.stdout).groups())
        self.assertEqual([seed for seed, _ in hashes], ["1", "1", "18446744073709551615", "7"])
        self.assertEqual(hashes[0], hashes[1])
        self.assertEqual(len(set(hashes)), 3)

    def test_threads_change_nothing(self):
        hashes = set()
        for threads in (1, 2, 4):
            done = self.call("run", "diffusion", "--ticks", 50, "--quiet", "--threads", threads)
            hashes.add(re.search('"state_hash":"(.*)"', done.stdout).group(1))
        self.assertEqual(len(hashes), 1)

    def test_set_replaces_what_the_file_says(self):
        summary = self.run_world("--set", "framework.maxclock=7", "--set", "controllers.fc.parameters.fail_at=2",
                                 code=CONTROLLER_FAILED)
        self.assertEqual(summary["ticks"], 7)
        self.assertEqual(summary["failed_controllers"][0]["tick"], 2)
        self.assertEqual(self.run_world("--set", "framework.maxclock=7", "--ticks", 9)["ticks"], 9)

    def test_the_summary_says_what_replaced_the_file_s_values(self):
        summary = self.run_world("--ticks", 9, "--set", "framework.maxclock=7", "--seed", 5, "--threads", 2, "--set",
                                 "controllers.fc.parameters.fail_at=-2")
        self.assertEqual(summary["overrides"], ["--set framework.maxclock=7", "--set controllers.fc.parameters.fail_at=-2",
                                                "--seed 5", "--ticks 9", "--threads 2"])

    def test_a_camera_that_overflows_is_told_of_once_and_counted(self):
        camera = "</actuators><sensors><footbot_camera><max_blobs>2</max_blobs></footbot_camera></sensors>"
        text = WORLD.replace("</actuators>", camera).replace("</arena>", CROWD + "</arena>")
        done = self.call("run", self.world(text=text, visualisations=""))
        self.assertEqual(done.returncode, FINISHED, done.stderr)
        self.assertEqual(json.loads(done.stdout)["overflows"], {"footbot_camera": {"robots": 1, "readings": 20}})
        self.assertEqual(done.stderr.count("fb: footbot_camera: more than 2 blobs in sight in tick 0"), 1)
        self.assertEqual(done.stderr.count("more than 2 blobs"), 1)

    def test_hashes_are_those_of_every_state(self):
        summary = self.run_world("--hashes", "hashes.txt")
        lines = (self.folder / "hashes.txt").read_text().splitlines()
        self.assertEqual([line.split()[0] for line in lines], [str(tick) for tick in range(21)])
        self.assertEqual(lines[-1].split()[1], summary["state_hash"])

    def test_without_quiet_the_progress_goes_to_the_error_stream(self):
        done = self.call("run", self.world(visualisations=""))
        lines = done.stderr.splitlines()
        self.assertRegex(lines[0], r"^world \[####\.{36}\] 2 of at most 20 ticks, 0\.2 s simulated, "
                                   r"\d+ ticks/s, about \d+ s left$")
        self.assertRegex(lines[-1], r"\] 20 of at most 20 ticks, 2\.0 s simulated, \d+ ticks/s$")
        self.assertEqual(done.stdout.count("\n"), 1)

    def test_an_existing_out_folder_is_used(self):
        self.out.mkdir()
        (self.out / "mine.txt").write_text("kept")
        self.run_world()
        self.assertTrue(table_of(self.out / "table.txt", self).startswith("#clock\t"))
        self.assertEqual((self.out / "mine.txt").read_text(), "kept")


class RefusalTest(ProgramTest):
    def test_files_that_are_not_there_or_are_none(self):
        done = self.call("run", "difusion")
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        self.assertRegex(done.stderr, "^swarmanoid: difusion: found neither such a file nor an installed experiment of "
                                      "that name; installed: .*; did you mean 'diffusion'\\?\n$")
        launched = self.call("launch", "difusion")
        self.assertEqual((launched.returncode, launched.stdout, launched.stderr), (BAD_INPUT, "", done.stderr))
        launched = self.call("launch", "")
        self.assertEqual((launched.returncode, launched.stdout), (BAD_INPUT, ""))
        self.assertRegex(launched.stderr, "^swarmanoid: found neither such a file nor an installed experiment of that name; "
                                          "installed: .*\n$")
        file = self.world(text="<ahss-config>\n</ahss>")
        self.assert_refused(file + ":2: found no well-formed XML: Opening and ending tag mismatch: ahss-config line 1 and ahss",
                            "run", file)

    def test_mistakes_in_the_file_leave_no_out_folder(self):
        file = self.world(maxclock=0)
        self.assert_refused(file + ":2: maxclock: found '0', allowed: a whole number from 1 to 1e+15",
                            "run", file, "--out", self.out)
        # detected only while the world is built
        overlapping = self.world()
        self.assert_refused(overlapping + ":11: block 'wall' in engine 'ground': overlaps 'fb'",
                            "run", overlapping, "--out", self.out / "deep", "--set", "arena.wall.position=2,3,0.25")

    def test_out_that_cannot_be_a_folder(self):
        file = self.world()
        (self.folder / "taken").write_text("")
        self.assert_refused("--out: cannot make the folder 'taken': Not a directory", "run", file, "--out", "taken")
        self.assert_refused("--out: cannot make the folder '/dev/null/x': Not a directory",
                            "run", file, "--out", "/dev/null/x")

    def test_files_that_cannot_be_written(self):
        self.assert_refused(self.world() + ":15: text_render 'table': cannot write nowhere/table.txt: No such file or directory",
                            "run", self.world(),
                            "--set", "visualisations.table.file=nowhere/table.txt")
        done = self.call("run", self.world(visualisations=""), "--bag", "/nowhere/run.bag")
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        self.assertIn("cannot write", done.stderr)

    def test_malformed_settings(self):
        file = self.world()
        for setting, message in (
                ("maxclock", "--set: found 'maxclock', allowed: path=value"),
                ("=5", "--set: found '=5', allowed: path=value"),
                ("maxclock=5", "--set maxclock: allowed: section.name, such as framework.maxclock"),
                ("framework..maxclock=5",
                 "--set framework..maxclock: allowed: section.name, such as framework.maxclock"),
                ("framework.maxclock=many",
                 "--set framework.maxclock: maxclock: found 'many', allowed: a whole number from 1 to 1e+15")):
            self.assert_refused(message, "run", file, "--set", setting)
        done = self.call("run", file, "--set", "framwork.maxclock=5")
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("did you mean 'framework'?", done.stderr)
        done = self.call("run", file, "--set", "framework.maxclok=5")
        self.assertEqual(done.returncode, BAD_INPUT)
        self.assertIn("did you mean 'maxclock'?", done.stderr)

    def test_wrong_usage(self):
        file = self.world()
        for arguments in ([], ["walk"], ["run"], ["run", file, "--sed", "1"], ["run", file, "--seed", "-1"],
                          ["run", file, "--seed", "1.5"], ["run", file, "--seed", "18446744073709551616"],
                          ["run", file, "--ticks", "0"], ["run", file, "--ticks", "-5"], ["run", file, "--ticks", "x"],
                          ["run", file, "--threads", "0"], ["run", file, "--threads", "1000000"], ["run", file, file]):
            done = self.call(*arguments)
            self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""), arguments)
            self.assertNotEqual(done.stderr, "")
        self.assertEqual(self.call("--help").returncode, FINISHED)
        self.assertEqual(self.call("run", "--help").returncode, FINISHED)


class OtherCommandsTest(ProgramTest):
    def test_validate_says_what_is_in_the_file_and_writes_nothing(self):
        file = self.world()
        before = sorted(self.folder.rglob("*"))
        done = self.call("validate", file)
        self.assertEqual((done.returncode, done.stdout), (FINISHED, file + ": valid, 2 entities, 1 robots\n"))
        self.assertEqual(sorted(self.folder.rglob("*")), before)
        self.assert_refused(file + ":11: block 'wall' in engine 'ground': overlaps 'fb'",
                            "validate", file, "--set", "arena.wall.position=2,3,0.25")

    def test_validate_without_libraries_runs_no_code_of_others(self):
        library = str(self.folder / "libthere_is_none.so")
        odometer = f'<odometer id="o" library="{library}"><what>it likes</what></odometer>'
        file = self.world(text=WORLD.replace("failing_controller\"", library + "\""), visualisations=odometer)
        self.assertEqual(self.call("validate", file).returncode, BAD_INPUT, "it is not there")
        valid = f"{file}: valid as far as can be told without {library}"
        self.assertEqual(self.call("validate", "--no-libraries", file).stdout, valid + ", 2 entities, 1 robots\n")
        # the parts without a library are checked nevertheless
        self.assert_refused(file + ":11: block 'wall' in engine 'ground': overlaps 'fb'", "validate", "--no-libraries", file,
                            "--set", "arena.wall.position=2,3,0.25")
        file = self.world(text=WORLD.replace("<footbot_wheels/>", "<footbot_wheel/>"), visualisations=odometer)
        done = self.call("validate", "--no-libraries", file)
        self.assertEqual((done.returncode, done.stdout), (BAD_INPUT, ""))
        self.assertIn("did you mean 'footbot_wheels'?", done.stderr)

    def test_validate_without_libraries_builds_what_it_can(self):
        library = str(self.folder / "libthere_is_none.so")
        for old, new in (("<kinematics2d ", f'<carousel library="{library}" '),
                         ("<block ", f'<crate library="{library}" '),
                         ("</arena>", f'</arena><rules><shift id="s" library="{library}"/></rules>'),
                         ("</actuators>", f'</actuators><sensors><compass library="{library}"/></sensors>'),
                         ("<footbot_wheels/>", f'<footbot_wheels library="{library}"><implementation>slow</implementation>'
                                               "</footbot_wheels>")):
            text = WORLD.replace(old, new)
            text = text.replace("</block>", "</crate>") if "<crate" in text else text
            file = self.world(text=text, visualisations="")
            done = self.call("validate", "--no-libraries", file)
            self.assertEqual(done.returncode, FINISHED, done.stderr)
            self.assertTrue(done.stdout.startswith(f"{file}: valid as far as can be told without {library}, failing_controller"))
        self.assertEqual(self.call("validate", "--no-libraries", self.world(text=WORLD.replace(
            'failing_controller id="fc" library="failing_controller"', 'failing_controller id="fc"'))).returncode, FINISHED)

    def test_schema_is_xml_and_names_the_devices(self):
        done = self.call("schema")
        self.assertEqual(done.returncode, FINISHED)
        root = xml.etree.ElementTree.fromstring(done.stdout)
        self.assertEqual(root.tag, "{http://www.w3.org/2001/XMLSchema}schema")
        self.assertIn('"footbot_proximity"', done.stdout)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
