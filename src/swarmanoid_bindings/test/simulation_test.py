#!/usr/bin/python3
"""Runs in Python compared with the same runs by the program `swarmanoid`."""

import concurrent.futures
import gc
import json
import os
import resource
import subprocess
import tempfile
import unittest

import numpy
import swarmanoid

MOST_KIB = 2048  # maximum growth of memory in total

WRITES_A_TABLE = """<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>3</maxclock></framework>
  <arena size="2,2,1" optimization="2D">
    <block id="wall"><position>1,1,0.1</position><orientation>0,0,0</orientation><size>1,1,0.2</size></block>
  </arena>
  <visualisations><text_render id="table"><file>poses.txt</file></text_render></visualisations>
</ahss-config>"""


def program(experiment, *options):
    """The summary of a run by the program."""
    done = subprocess.run(["swarmanoid", "run", experiment, "--quiet", *options], stdout=subprocess.PIPE, check=True,
                          text=True, cwd=tempfile.gettempdir())
    return json.loads(done.stdout.splitlines()[-1])



class SimulationTest(unittest.TestCase):
    def test_makes_the_runs_of_the_program(self):
        for experiment, seed, ticks in (("diffusion", 5, 70), ("foraging", 2, 130), ("climbing", 3, 40)):
            with self.subTest(experiment), tempfile.TemporaryDirectory() as folder:
                expected = program(experiment, "--seed", str(seed), "--ticks", str(ticks), "--out", folder)
                result = swarmanoid.Simulation(experiment, seed=seed, ticks=ticks).run()
                self.assertEqual(result["state_hash"], expected["state_hash"])
                self.assertEqual(result["metrics"], expected["metrics"])
                self.assertEqual((result["ticks"], result["seed"]), (ticks, seed))

    def test_overrides_are_those_of_the_program(self):
        expected = program("diffusion", "--ticks", "30", "--set", "controllers.dc.parameters.speed=0.23")
        simulation = swarmanoid.Simulation("diffusion", ticks=30, overrides={"controllers.dc.parameters.speed": 0.23})
        self.assertEqual(simulation.run()["state_hash"], expected["state_hash"])

    def test_ends_when_the_run_is_over(self):
        simulation = swarmanoid.Simulation("diffusion", ticks=12)
        self.assertEqual(simulation.tick(5), 5)
        self.assertFalse(simulation.finished)
        self.assertEqual(simulation.tick(100), 7)
        self.assertTrue(simulation.finished)
        self.assertEqual(simulation.tick(), 0)
        self.assertEqual(simulation.ticks, 12)
        self.assertAlmostEqual(simulation.time, 1.2)

    def test_begins_anew(self):
        simulation = swarmanoid.Simulation("diffusion", seed=4)
        simulation.tick(20)
        first = simulation.state_hash
        simulation.reset()
        self.assertEqual((simulation.ticks, simulation.seed), (0, 4))
        simulation.tick(20)
        self.assertEqual(simulation.state_hash, first)
        simulation.reset(seed=9)
        simulation.tick(20)
        other = swarmanoid.Simulation("diffusion", seed=9)
        other.tick(20)
        self.assertEqual(simulation.state_hash, other.state_hash)
        self.assertNotEqual(simulation.state_hash, first)

    def test_poses_and_twists_are_those_of_the_robots(self):
        simulation = swarmanoid.Simulation("diffusion", seed=6)
        simulation.tick(3)
        before = simulation.robots.poses
        simulation.tick()
        robots = simulation.robots
        self.assertEqual(robots.poses.shape, (100, 7))
        self.assertEqual(robots.names[:2], ["fb_1", "fb_2"])
        self.assertEqual(set(robots.types), {"footbot"})
        self.assertEqual(simulation.entities.poses.shape, (104, 7))  # and four walls
        # robots without contact have moved by their velocity times the tick of 0.1 s
        moved = robots.poses[:, :3] - before[:, :3]
        free = numpy.abs(robots.twists[:, 5]) < 1e-12
        self.assertGreater(free.sum(), 50)
        numpy.testing.assert_allclose(moved[free], 0.1 * robots.twists[free, :3], atol=1e-12)
        numpy.testing.assert_allclose(numpy.linalg.norm(robots.poses[:, 3:], axis=1), 1.0, atol=1e-12)

    def test_mistakes_say_where(self):
        with self.assertRaises(swarmanoid.ExperimentError) as caught:
            swarmanoid.Simulation(text="<ahss-config>\n<framewrk/>\n</ahss-config>")
        self.assertEqual((caught.exception.file, caught.exception.line), ("<text>", 2))
        self.assertIn("did you mean 'framework'?", str(caught.exception))
        with self.assertRaisesRegex(swarmanoid.ExperimentError, "did you mean 'diffusion'?"):
            swarmanoid.Simulation("difusion")
        with self.assertRaisesRegex(TypeError, "either an experiment"):
            swarmanoid.Simulation("diffusion", text="<ahss-config/>")
        with self.assertRaises(ValueError):
            swarmanoid.Simulation("diffusion", overrides={"framework.maxclock": -1})

    def test_robots_are_of_their_moment(self):
        simulation = swarmanoid.Simulation("diffusion")
        robots = simulation.robots
        proximity = robots.readings["footbot_proximity"]
        simulation.tick()
        for look in (lambda: robots.poses, lambda: proximity.value, lambda: robots.readings["footbot_proximity"]):
            with self.assertRaisesRegex(RuntimeError, "an earlier tick"):
                look()

    def test_outlives_what_is_left_of_it(self):
        robots = swarmanoid.Simulation("diffusion").robots
        gc.collect()
        self.assertEqual(robots.poses.shape, (100, 7))

    def test_writes_only_with_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                swarmanoid.Simulation(text=WRITES_A_TABLE).run()
                self.assertEqual(os.listdir(folder), [])
                with swarmanoid.Simulation(text=WRITES_A_TABLE, out="results") as simulation:
                    simulation.run()
                with self.assertRaisesRegex(swarmanoid.ExperimentError, "poses.txt.* or force to replace it"):
                    swarmanoid.Simulation(text=WRITES_A_TABLE, out="results")
                with swarmanoid.Simulation(text=WRITES_A_TABLE, out="results", force=True) as simulation:
                    simulation.run()
                outside = WRITES_A_TABLE.replace("poses.txt", "../poses.txt")
                with self.assertRaisesRegex(swarmanoid.ExperimentError, "allowed: a file in .*, or write_anywhere"):
                    swarmanoid.Simulation(text=outside, out="results")
                swarmanoid.Simulation(text=outside, out="results", write_anywhere=True).close()
                self.assertEqual(sorted(os.listdir(folder)), ["poses.txt", "results"])
            finally:
                os.chdir(before)
            with open(os.path.join(folder, "results", "poses.txt")) as table:
                self.assertEqual(sum(not line.startswith("#") for line in table), 4)

    def test_arguments_are_held_to_the_bounds_of_the_file(self):
        for arguments, message in (({"threads": 0}, "threads: found '0', allowed: a whole number from 1 to 1024"),
                                   ({"threads": -5}, "threads: found '-5', allowed: a whole number from 1 to 1024"),
                                   ({"threads": 100_000}, "threads: found '100000', allowed: a whole number from 1 to 1024"),
                                   ({"ticks": 0}, "ticks: found '0', allowed: a whole number from 1 to "),
                                   ({"ticks": -1}, "ticks: found '-1', allowed: a whole number from 1 to ")):
            with self.subTest(arguments=arguments), self.assertRaisesRegex(swarmanoid.ExperimentError, f"^{message}"):
                swarmanoid.Simulation("diffusion", **arguments)

    def test_threads_make_the_same_runs_at_the_same_time(self):
        def state_hash(run):
            experiment, seed = run
            return swarmanoid.Simulation(experiment, seed=seed, ticks=60).run()["state_hash"]

        # on two engines, one of them Box2D
        runs = [(experiment, seed) for seed in (1, 2, 3) for experiment in ("diffusion", "group_pull")]
        alone = [state_hash(run) for run in runs]
        self.assertGreater(len(set(alone)), 3)
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertEqual(list(pool.map(state_hash, runs)), alone)

    def test_its_record_is_what_it_is_made_of(self):
        simulation = swarmanoid.Simulation("phototaxis", overrides={"controllers.pc.parameters.speed": 0.12})
        record = simulation.record
        self.assertIn("<speed>0.12</speed>", record["text"])
        self.assertEqual(list(record["libraries"]), ["libphototaxis.so"])
        again = swarmanoid.Simulation(text=record["text"])
        again.tick(20)
        simulation.tick(20)
        self.assertEqual(again.state_hash, simulation.state_hash)
        terrain = swarmanoid.Simulation("rough_terrain").record
        (name, content), = terrain["files"].items()
        self.assertIn(f"<file>{name}</file>", terrain["text"])
        self.assertEqual(content[:4], b"\x89PNG")

    def test_gives_its_memory_back(self):
        def make(count):
            for _ in range(count):
                swarmanoid.Simulation("diffusion", overrides={"arena.distribute.quantity": 20}).tick(2)
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

        make(40)
        before = make(40)
        self.assertLess(make(400) - before, MOST_KIB)


if __name__ == "__main__":
    unittest.main()
