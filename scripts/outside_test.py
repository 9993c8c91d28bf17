#!/usr/bin/python3
"""outside_test.py BUILD_FOLDER: external packages (examples/), built and run against a devel space and an install space of
this project; and the install space by itself."""

import concurrent.futures
import glob
import json
import math
import os
import re
import shutil
import sys
import tempfile
import unittest

from outside_robot import RobotChecks
from outside_ros import LAUNCH, beside
from surroundings import REPOSITORY, bare, compiler_cache, read, run, sourced, succeed, with_another_python

PACKAGES = ("example_arena_object", "example_controller", "example_engine", "example_python_controller", "example_robot",
            "example_rule", "example_sensor", "example_turtlebot3", "example_visualisation")
EXPERIMENT = os.path.join(REPOSITORY, "examples/together.xml")
LANTERNS = os.path.join(REPOSITORY, "examples/example_arena_object/lantern.xml")
OUTPUTS = ("walked.txt", "waited.txt", "table.txt")
BUILD_FOLDER = ""


def walked_lines(last_tick):
    """Expected lines of the odometer: the patrol's leg takes 20 ticks, its turn 10."""
    way_a_tick = 5.0 * 0.029 * 0.1  # wheels [rad/s], their radius [m], tick [s]
    travelled = 0.0
    lines = ["0 0.000000\n"]
    for tick in range(1, last_tick + 1):
        travelled += way_a_tick if (tick - 1) % 30 < 20 else 0.0
        lines.append(f"{tick} {travelled:.6f}\n")
    return lines


class OutsideTest(RobotChecks):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="swarmanoid_outside_")
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.bare = bare(os.path.join(cls.folder, "home"))
        cls.another_python = with_another_python(cls.bare, os.path.join(cls.folder, "another_python"))
        cls.installed = os.path.join(cls.folder, "installed")
        succeed(["cmake", "--install", BUILD_FOLDER, "--prefix", cls.installed], cls.bare)

    # --- external packages

    def build_package(self, name, space, folder):
        """Copies a package, builds it against a space of this project, and installs it."""
        source = os.path.join(folder, "src", name)
        build = os.path.join(folder, "build", name)
        shutil.copytree(os.path.join(REPOSITORY, "examples", name), source)
        succeed(["cmake", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={space}",
                 f"-DCMAKE_INSTALL_PREFIX={folder}/installed", "-DSWARMANOID_WARNINGS_AS_ERRORS=ON",
                 *compiler_cache()], self.another_python)
        succeed(["cmake", "--build", build], self.another_python)
        return build

    def build_examples(self, space, folder):
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            builds = list(pool.map(lambda name: self.build_package(name, space, folder), PACKAGES))
        for name in ("example_controller", "example_sensor"):
            written = os.path.join(folder, "src", name, "controller_nodelets.xml")
            committed = os.path.join(REPOSITORY, "examples", name, "controller_nodelets.xml")
            with open(written) as new, open(committed) as old:
                self.assertEqual(new.read(), old.read(), "commit controller_nodelets.xml")
        return builds

    def check_run_headless(self, environment, out):
        """The experiment of all examples, without ROS."""
        share = environment["CMAKE_PREFIX_PATH"].split(":")
        schema = [s for s in (f"{p}/share/swarmanoid_experiments/experiment.xsd" for p in share) if os.path.exists(s)]
        succeed(["xmllint", "--noout", "--schema", schema[0], EXPERIMENT], environment)
        self.check_schema(environment, out + ".xsd")
        succeed(["swarmanoid", "validate", EXPERIMENT], environment)
        listed = succeed(["swarmanoid", "list"], environment)
        for library, package in (("patrol", "example_controller"), ("carousel", "example_engine"),
                                 ("compass", "example_sensor"), ("lantern", "example_arena_object"),
                                 ("odometer", "example_visualisation"), ("relocation", "example_rule")):
            self.assertIn(f'      in library="{library}" of {package}\n', listed)
        result = json.loads(succeed(["swarmanoid", "run", EXPERIMENT, "--out", out, "--quiet"], environment))
        self.assertTrue(result["finished"])
        self.assertEqual(69, result["ticks"], "the goal is reached in the third leg")
        self.assertAlmostEqual(0.7105, result["metrics"]["walked_m"])
        self.assertEqual(6, result["metrics"]["wandering.moves"], "after ticks 10, 20, ... 60")

        with open(os.path.join(out, "walked.txt")) as file:
            self.assertEqual(walked_lines(69), file.readlines())
        with open(os.path.join(out, "waited.txt")) as file:
            waited = [float(line.split()[1]) for line in file]
        self.assertEqual(0.0, waited[5], "it waits for what is on the carousel, which its sensor sees")
        self.assertGreater(waited[-1], 0.1, "and then goes")
        with open(os.path.join(out, "table.txt")) as file:
            rows = [line.split("\t") for line in file]
        last = {row[2]: [float(value) for value in row[3:]] for row in rows if row[0] == "69"}
        angle = math.pi + 6.9 * math.radians(9.0)
        self.assertAlmostEqual(5.0 + math.cos(angle), last["rider"][0], places=4)
        self.assertAlmostEqual(4.0 + math.sin(angle), last["rider"][1], places=4)
        self.assertAlmostEqual(90.0, last["scout"][5], places=2)
        return result

    def check_schema(self, environment, file):
        """The schema of the installed packages accepts the experiments of all packages, and has their plugins."""
        with open(file, "w") as opened:
            opened.write(succeed(["swarmanoid", "schema"], environment))
        experiments = sorted(glob.glob(os.path.join(REPOSITORY, "examples/*/*.xml")))
        experiments = [name for name in experiments if "<ahss-config>" in read(name)] + [EXPERIMENT]
        self.assertIn(os.path.join(REPOSITORY, "examples/example_sensor/compass.xml"), experiments)
        succeed(["xmllint", "--noout", "--schema", file, *experiments], environment)
        text, lanterns = read(os.path.join(REPOSITORY, "examples/example_sensor/compass.xml")), read(LANTERNS)
        for source, old, new, refusal in (
                (text, '<compass library="compass">', "<compass>", "'library' is required"),
                (text, "<noise>2</noise>", "<noise>200</noise>", "maxInclusive"),
                (text, "<noise>2</noise>", "<nois>2</nois>", "not expected"),
                (lanterns, '<lantern id="dim" library="lantern">', '<lantern id="dim">', "'library' is required"),
                (lanterns, "<intensity>5</intensity>", "<intensity>5000</intensity>", "maxInclusive")):
            self.assertIn(old, source)
            changed = file + ".xml"
            with open(changed, "w") as opened:
                opened.write(source.replace(old, new))
            code, _, errors = run(["xmllint", "--noout", "--schema", file, changed], environment)
            self.assertEqual(3, code, errors)
            self.assertIn(refusal, errors)

    def check_arena_object(self, environment, out):
        """An arena object: four lanterns, in an engine and out of the robot's way; each file names their library."""
        result = json.loads(succeed(["swarmanoid", "run", LANTERNS, "--out", out, "--quiet"], environment))
        self.assertEqual(100, result["ticks"])
        self.assertIn(": valid, 9 entities, 1 robots", succeed(["swarmanoid", "validate", LANTERNS], environment))
        unchecked = succeed(["swarmanoid", "validate", "--no-libraries", LANTERNS], environment)
        self.assertIn(": valid as far as can be told without diffusion, lantern; not built", unchecked)
        for old, new, refusal in (
                ('<lantern id="bright" library="lantern">', '<lantern id="bright" library="lanterns">', "library 'lanterns'"),
                ("<intensity>5</intensity>", "<intensity>-5</intensity>", "intensity: found '-5', allowed: a number from 0 to"),
                ("<lantern id=\"bright\" library=\"lantern\">", "<lantrn id=\"bright\" library=\"lantern\">",
                 "did you mean 'lantern'?")):
            text = read(LANTERNS).replace(old, new)
            if "<lantrn" in text:
                text = text.replace("</lantern>", "</lantrn>", 1)
            changed = out + ".xml"
            with open(changed, "w") as file:
                file.write(text)
            code, _, errors = run(["swarmanoid", "validate", changed], environment)
            self.assertEqual(2, code, errors)
            self.assertIn(refusal, errors)
        return result["state_hash"]

    def check_run_under_ros(self, environment, headless_out, out):
        """Same as check_run_headless under ROS: controllers are nodelets of their own packages, and the files are equal."""
        with beside([*LAUNCH, f"experiment:={EXPERIMENT}", f"out:={out}", "paused:=true"], environment) as launch:
            self.wait_for_space(launch, environment)
            maps = self.maps_of_manager(launch.pid)
            for library in ("libpatrol_nodelet.so", "libface_north_nodelet.so", "libcompass.so", "libcarousel.so",
                            "libodometer.so"):
                self.assertIn(library, maps)
            self.resume(launch, environment, "finished after 69 ticks")
        for name in OUTPUTS:
            with open(os.path.join(headless_out, name)) as first, open(os.path.join(out, name)) as second:
                self.assertEqual(first.read(), second.read(), name)

    def check_examples(self, space, folder, use_installed):
        builds = self.build_examples(space, folder)
        if use_installed:
            for build in builds:
                succeed(["cmake", "--install", build], self.bare)
            environment = sourced(self.bare, f"{folder}/installed/setup.bash")
        else:
            environment = sourced(self.bare, *(f"{build}/devel/setup.bash" for build in builds))
        headless_out = os.path.join(folder, "headless")
        ros_out = os.path.join(folder, "ros")
        result = self.check_run_headless(environment, headless_out)
        robots_hash = self.check_robot(environment, os.path.join(folder, "robots"))
        self.check_turtlebot(environment, os.path.join(folder, "square"))
        lanterns_hash = self.check_arena_object(environment, os.path.join(folder, "lanterns"))
        self.check_run_under_ros(environment, headless_out, ros_out)
        self.check_robot_under_ros(environment, os.path.join(folder, "robots"), os.path.join(folder, "robots_ros"))
        self.check_mock_robot(environment)
        return result["state_hash"], robots_hash, lanterns_hash

    def test_examples_build_and_run_against_devel_and_install_space(self):
        hashes = set()
        devel = os.path.join(BUILD_FOLDER, "devel")
        for name, space, use_installed in (("devel", devel, False), ("install", self.installed, True)):
            with self.subTest(name):
                hashes.add(self.check_examples(space, os.path.join(self.folder, name), use_installed))
        self.assertEqual(1, len(hashes), "one experiment, one result")

    def test_what_is_not_there_is_named(self):
        code, _, errors = run(["swarmanoid", "validate", EXPERIMENT],
                              sourced(self.bare, f"{self.installed}/setup.bash"))
        self.assertEqual(2, code)
        self.assertIn("together.xml:9: library 'patrol': found no libpatrol.so in", errors)

    # --- independence of the first python3 in PATH

    def test_every_package_chooses_the_python_of_ros_before_it_looks_for_catkin(self):
        files = [name for part in ("src", "examples") for name in glob.glob(os.path.join(REPOSITORY, part, "*/CMakeLists.txt"))]
        files += glob.glob(os.path.join(REPOSITORY, "docs/**/*.md"), recursive=True)
        looking = [name for name in files if re.search(r"^find_package\(catkin", read(name), re.M)]
        self.assertGreater(len(looking), 25)
        for name in looking:
            text = read(name)
            for count, search in enumerate(re.finditer(r"^find_package\(catkin", text, re.M), 1):
                choices = re.findall(r"^set\(PYTHON_EXECUTABLE /usr/bin/python3 CACHE FILEPATH .*\)$", text[:search.start()], re.M)
                self.assertEqual(count, len(choices), f"{name}: one before each")  # a page may contain several files

    def test_a_package_is_configured_alone_where_another_python_is_first(self):
        """As by `catkin build`: a package of the suite that generates code by Python, and a template; all others begin alike, see
        above."""
        for folder in ("src/swarmanoid_msgs", "examples/example_controller"):
            with self.subTest(folder):
                build = os.path.join(self.folder, "alone", os.path.basename(folder))
                succeed(["cmake", "-S", os.path.join(REPOSITORY, folder), "-B", build, f"-DCMAKE_PREFIX_PATH={BUILD_FOLDER}/devel"],
                        self.another_python)
                self.assertIn("PYTHON_EXECUTABLE:FILEPATH=/usr/bin/python3", read(os.path.join(build, "CMakeCache.txt")))

    # --- the install space by itself

    def test_install_space_runs_by_itself(self):
        environment = sourced(self.bare, f"{self.installed}/setup.bash")
        self.assertNotIn(BUILD_FOLDER, " ".join(environment.values()))
        result = json.loads(succeed(["swarmanoid", "run", "object_retrieval", "--seed", "1", "--quiet"],
                                    environment, self.folder))
        self.assertTrue(result["success"])
        output = succeed([*LAUNCH, "max_ticks:=50"], environment, timeout=60)
        self.assertIn("after 50 ticks", output)
        module = succeed(["/usr/bin/python3", "-c", "import swarmanoid_python; print(swarmanoid_python.__file__)"],
                         environment)
        self.assertTrue(module.startswith(self.installed), module)

    def test_install_space_does_not_know_where_it_was_built(self):
        """Only debugging information may name sources; files that are read at run time may not."""
        for folder, _, names in os.walk(self.installed):
            for name in names:
                path = os.path.join(folder, name)
                if name.endswith(".pyc"):
                    continue
                with open(path, "rb") as file:
                    content = file.read()
                is_program = content.startswith(b"\x7fELF")
                self.assertFalse(not is_program and BUILD_FOLDER.encode() in content, f"{path} names {BUILD_FOLDER}")
                if is_program:
                    dynamic = succeed(["readelf", "-d", path], self.bare)
                    self.assertIsNone(re.search(r"R(UN)?PATH.*" + re.escape(BUILD_FOLDER), dynamic), path)


if __name__ == "__main__":
    BUILD_FOLDER = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
