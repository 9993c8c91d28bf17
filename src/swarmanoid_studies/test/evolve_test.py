#!/usr/bin/python3
"""The program `swarmanoid evolve`: the same genotypes, to the last bit, with any workers, also if processes are killed."""

import csv
import io
import json
import random
import subprocess
import time
import unittest

from commands import CONTROLLER_FAILED, INTERRUPTED, PATIENCE_S, CommandsTest, workers_of

SPEED, THRESHOLD = "controllers.pc.parameters.speed", "controllers.pc.parameters.threshold"
STUDY = f"""<study>
  <experiment>phototaxis</experiment>
  <overrides><set path="framework.maxclock">401</set></overrides>
  <genotype>
    <gene path="{SPEED}" minimum="0" maximum="0.3"/>
    <gene path="{THRESHOLD}" minimum="0" maximum="2"/>
  </genotype>
  <fitness seeds="1..3"><minimise metric="lamps.distance"/></fitness>
  <optimiser><cma_es><generations>6</generations></cma_es></optimiser>
</study>
"""
GENERATIONS = 6
FAILS = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>20</maxclock></framework>
  <controllers>
    <failing_controller id="fc" library="failing_controller">
      <actuators><footbot_wheels/></actuators>
      <parameters><fail_at>3</fail_at></parameters>
    </failing_controller>
  </controllers>
  <arena size="3,3,2" optimization="2D">
    <light id="lamp"><position>1, 2, 1</position><orientation>0, 0, 0</orientation></light>
    <footbot id="fb"><position>1, 1, 0</position><orientation>0, 0, 0</orientation><controller>fc</controller></footbot>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
  <rules><switching_lamp id="lamps"><lamp>lamp</lamp></switching_lamp></rules>
</ahss-config>
"""
STUDY_THAT_FAILS = """<study>
  <experiment>fails.xml</experiment>
  <genotype><gene path="rules.lamps.intensity" minimum="1" maximum="2"/></genotype>
  <fitness seeds="1..2"><minimise metric="lamps.distance"/></fitness>
  <optimiser><ga><generations>2</generations><population>8</population></ga></optimiser>
</study>
"""


class EvolveTest(CommandsTest):
    def setUp(self):
        super().setUp()
        self.study = self.folder / "study.xml"
        self.study.write_text(STUDY)

    def evolve(self, folder, *options, **expected):
        return self.call("evolve", "study.xml", "--out", folder, "--quiet", *options, **expected)

    whole = {}  # results of the study, made once

    def uninterrupted(self):
        if not self.whole:
            self.evolve("whole", "--jobs", 2)
            self.whole.update(self.made("whole"))
        return self.whole

    def made(self, folder):
        """All files that depend only on the study."""
        return {name: (self.folder / folder / name).read_bytes() for name in ("checkpoint.json", "generations.csv", "best.xml")}

    def test_genotypes_are_the_same_with_any_workers(self):
        summary = self.evolve("two", "--jobs", 2)
        expected = self.made("two")
        for jobs in (1, 4):
            self.evolve(f"of_{jobs}", "--jobs", jobs)
            self.assertEqual(self.made(f"of_{jobs}"), expected)
        self.assertEqual((self.folder / "two/fitness.png").read_bytes()[:4], b"\x89PNG")
        self.assertEqual((summary["runs_with_failed_controllers"], summary["first_failures"]), (0, []))
        best, = summary["best"]
        self.assert_all_files_say_what_they_are_of(expected, best["genes"])
        values = [generation["values"] for generation in json.loads(expected["checkpoint.json"])["generations"]]
        self.assertEqual(len(values), GENERATIONS)
        self.assertEqual(best["values"]["lamps.distance"], min(value[0] for generation in values for value in generation))
        self.assert_the_best_is_an_experiment("two/best.xml", best["values"]["lamps.distance"])

    def assert_all_files_say_what_they_are_of(self, made, genes):
        """Checks version, fingerprint, seeds and overrides in all files."""
        checkpoint = json.loads(made["checkpoint.json"])
        self.assertEqual((checkpoint["seeds"], checkpoint["overrides"]), ([1, 2, 3], {"framework.maxclock": "401"}))
        version, fingerprint = checkpoint["version"], checkpoint["fingerprint"]
        first = next(csv.DictReader(io.StringIO(made["generations.csv"].decode())))
        self.assertEqual((first["version"], first["fingerprint"], first["seeds"]), (version, fingerprint, "1 2 3"))
        self.assertIn("framework.maxclock=401", json.loads(first["overrides"]))
        comment = made["best.xml"].decode().partition("-->")[0]
        values = (f"{path}={value!r}" for path, value in genes.items())
        for text in (version, fingerprint, "Seeds: 1 2 3.", "framework.maxclock=401", *values):
            self.assertIn(text, comment)

    def assert_the_best_is_an_experiment(self, file, expected):
        metrics = []
        for seed in (1, 2, 3):
            done = subprocess.run(["swarmanoid", "run", file, "--seed", str(seed), "--quiet"], cwd=self.folder, check=True,
                                  stdout=subprocess.PIPE, text=True)
            metrics.append(json.loads(done.stdout)["metrics"]["lamps.distance"])
        self.assertAlmostEqual(sum(metrics) / 3, expected, delta=1e-12)

    def test_killed_processes_do_not_change_the_genotypes(self):
        chance = random.Random(int(time.time()))
        expected = self.uninterrupted()
        options = ("study.xml", "--out", "killed", "--quiet", "--jobs", 2)
        program = self.start("evolve", *options)
        self.wait_for_lines("killed/checkpoint.json", 1, program)
        chance.choice(workers_of(program)).kill()
        generation = (self.folder / "killed/checkpoint.json").read_bytes().count(b"genotypes")
        end = time.monotonic() + 60
        while (self.folder / "killed/checkpoint.json").read_bytes().count(b"genotypes") == generation:
            self.assertLess(time.monotonic(), end, "no generation comes after a worker was killed")
            time.sleep(0.01)
        self.kill(program)
        self.evolve("killed", "--jobs", 1, "--resume")
        self.assertEqual(self.made("killed"), expected)

    def test_goes_on_to_more_generations(self):
        self.evolve("parts", "--jobs", 2, "--generations", 2)
        self.evolve("parts", "--jobs", 2, "--resume")
        self.assertEqual(self.made("parts"), self.uninterrupted())

    def test_the_picture_is_made_anew_after_each_generation(self):
        program = self.start("evolve", "study.xml", "--out", "live", "--quiet", "--jobs", 1, "--generations", 100)
        pictures = []
        end = time.monotonic() + 60
        while len(pictures) < 3:
            self.assertLess(time.monotonic(), end, "the picture does not change")
            self.assertIsNone(program.poll(), "the program has ended")
            path = self.folder / "live/fitness.png"
            if path.exists() and path.read_bytes() not in pictures:
                pictures.append(path.read_bytes())
                self.assertEqual(pictures[-1][:4], b"\x89PNG")
                self.assertEqual(pictures[-1][-8:-4], b"IEND", "it is there as a whole")
            time.sleep(0.01)
        program.terminate()
        program.communicate(timeout=PATIENCE_S)

    def test_controllers_that_fail_are_named_and_the_exit_code_says_it(self):
        (self.folder / "fails.xml").write_text(FAILS)
        self.study.write_text(STUDY_THAT_FAILS)
        program = self.start("evolve", "study.xml", "--out", "run", "--quiet", "--jobs", 2)
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual(program.returncode, CONTROLLER_FAILED)
        summary = json.loads(output)
        self.assertEqual(summary["runs_with_failed_controllers"], 32)
        reason = "1 controllers failed, first fb in tick 3: told to, "
        first = [f"generation 1, genotype {i // 2}, seed {1 + i % 2}: {reason}" for i in range(10)]
        self.assertEqual([line[:len(first[0])] for line in summary["first_failures"]], first)
        lines = errors.splitlines()
        self.assertEqual(lines[0], "swarmanoid: controllers failed in 32 runs, the first of them:")
        self.assertEqual([line[:2 + len(first[0])] for line in lines[1:]], [f"  {line}" for line in first])
        self.evolve("run", "--resume", "--generations", 2, code=CONTROLLER_FAILED)

    def test_several_objectives_have_a_front(self):
        text = STUDY.replace('<minimise metric="lamps.distance"/>',
                             '<minimise metric="lamps.distance"/><maximise metric="lamps.distance_before_switch"/>')
        text = text.replace("<cma_es><generations>6</generations></cma_es>",
                            "<nsga2><generations>3</generations><population>8</population></nsga2>")
        self.study.write_text(text)
        summary = self.evolve("front", "--jobs", 2)
        self.assertEqual([best["file"] for best in summary["best"]],
                         [f"front/front_{i}.xml" for i in range(1, len(summary["best"]) + 1)])
        distances = [best["values"]["lamps.distance"] for best in summary["best"]]
        self.assertEqual(distances, sorted(distances))

    def test_an_interrupt_keeps_whole_generations(self):
        program = self.start("evolve", "study.xml", "--out", "run", "--quiet", "--jobs", 2)
        self.wait_for_lines("run/checkpoint.json", 1, program)
        program.terminate()
        output, errors = program.communicate(timeout=PATIENCE_S)
        self.assertEqual((program.returncode, errors), (INTERRUPTED, "swarmanoid: interrupted; --resume goes on\n"))
        self.assertTrue((self.folder / "run/best.xml").exists())

    def test_bad_input_is_reported_in_one_line_and_leaves_nothing_behind(self):
        self.assert_refused("found the study 'studi.xml', allowed: neural_aggregation, neural_phototaxis, object_retrieval, "
                            "phototaxis", "evolve", "studi.xml")
        self.assert_refused("--generations: found 0, allowed: 1 to 1000000", "evolve", "study.xml", "--generations", "0")
        self.study.write_text(STUDY.replace("lamps.distance", "lamp.distance"))
        self.assert_refused("study.xml:8: found the metric 'lamp.distance', allowed: lamps.distance, "
                            "lamps.distance_before_switch, lamps.switches", "evolve", "study.xml")
        self.study.write_text(STUDY.replace('maximum="2"', 'maximum="20"'))
        program = self.start("evolve", "study.xml")
        _, errors = program.communicate(timeout=PATIENCE_S)
        self.assertRegex(errors, f"^swarmanoid: study.xml:6: --set {THRESHOLD}: .*found '?20.0'?, allowed: .*\n$")

    def test_another_study_is_not_continued(self):
        self.evolve("run", "--jobs", 2, "--generations", 1)
        self.study.write_text(STUDY.replace("1..3", "1..2"))
        self.assert_refused("run/checkpoint.json: seeds: found [1, 2, 3], allowed: [1, 2], as now", "evolve", "study.xml",
                            "--out", "run", "--resume")
        self.assert_refused("run/checkpoint.json: found a file, allowed: another --out, --resume to continue it, or --force to "
                            "replace it", "evolve", "study.xml", "--out", "run")


if __name__ == "__main__":
    unittest.main()
