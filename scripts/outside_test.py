#!/usr/bin/python3
"""outside_test.py BUILD_FOLDER: packages of somebody else (examples/), built and run against a devel space and an
install space of this project; and the install space by itself."""

import concurrent.futures
import contextlib
import glob
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from surroundings import REPOSITORY, bare, compiler_cache, run, sourced, succeed

PACKAGES = ("example_arena_object", "example_controller", "example_engine", "example_python_controller", "example_robot",
            "example_rule", "example_sensor", "example_visualisation")
EXPERIMENT = os.path.join(REPOSITORY, "examples/together.xml")
ROBOTS = os.path.join(REPOSITORY, "examples/example_robot/e_pucks.xml")
LANTERNS = os.path.join(REPOSITORY, "examples/example_arena_object/lantern.xml")
CONFORMANCE = os.path.join(REPOSITORY, "examples/example_robot/conformance.xml")
SENSOR_ANGLES = (-0.3008, -0.8008, -math.pi / 2, -2.644, 2.6392, math.pi / 2, 0.7992, 0.2992)  # of the e-puck [rad]
OUTPUTS = ("walked.txt", "waited.txt", "table.txt")
LAUNCH = ["roslaunch", "swarmanoid_experiments", "run.launch", "rviz:=false", "real_time_factor:=0"]
BUILD_FOLDER = ""


def read(name):
    with open(name) as file:
        return file.read()


def walked_lines(last_tick):
    """What the odometer writes: the patrol's leg takes 20 ticks, its turn 10."""
    way_a_tick = 5.0 * 0.029 * 0.1  # wheels [rad/s], their radius [m], tick [s]
    travelled = 0.0
    lines = ["0 0.000000\n"]
    for tick in range(1, last_tick + 1):
        travelled += way_a_tick if (tick - 1) % 30 < 20 else 0.0
        lines.append(f"{tick} {travelled:.6f}\n")
    return lines


class OutsideTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="swarmanoid_outside_")
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.bare = bare(os.path.join(cls.folder, "home"))
        cls.installed = os.path.join(cls.folder, "installed")
        succeed(["cmake", "--install", BUILD_FOLDER, "--prefix", cls.installed], cls.bare)

    # --- packages of somebody else

    def build_package(self, name, space, folder):
        """Copies a package, builds it against a space of this project, and installs it."""
        source = os.path.join(folder, "src", name)
        build = os.path.join(folder, "build", name)
        shutil.copytree(os.path.join(REPOSITORY, "examples", name), source)
        succeed(["cmake", "-S", source, "-B", build, f"-DCMAKE_PREFIX_PATH={space}",
                 f"-DCMAKE_INSTALL_PREFIX={folder}/installed", "-DSWARMANOID_WARNINGS_AS_ERRORS=ON",
                 *compiler_cache()], self.bare)
        succeed(["cmake", "--build", build], self.bare)
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
        """The schema of all that is installed accepts the experiments of all packages, and knows what these bring."""
        with open(file, "w") as opened:
            opened.write(succeed(["swarmanoid", "schema"], environment))
        experiments = sorted(glob.glob(os.path.join(REPOSITORY, "examples/*/*.xml")))
        experiments = [name for name in experiments if "<ahss-config>" in read(name)] + [EXPERIMENT]
        self.assertIn(os.path.join(REPOSITORY, "examples/example_sensor/compass.xml"), experiments)
        succeed(["xmllint", "--noout", "--schema", file, *experiments], environment)
        with open(os.path.join(REPOSITORY, "examples/example_sensor/compass.xml")) as opened:
            text = opened.read()
        with open(LANTERNS) as opened:
            lanterns = opened.read()
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

    def check_robot(self, environment, out):
        """A robot by its description: it is listed, and diffuses in each engine without touching walls or leaving its pen."""
        listed = succeed(["swarmanoid", "list", "entity"], environment)
        self.assertIn("\n  e_puck: A small wheeled robot with infrared sensors all around.\n", listed)
        text = read(ROBOTS).replace("<e_puck", "<e_pick").replace("</e_puck", "</e_pick")
        changed = out + ".xml"
        with open(changed, "w") as file:
            file.write(text)
        code, _, errors = run(["swarmanoid", "validate", changed], environment)
        self.assertEqual(2, code)
        self.assertIn("did you mean 'e_puck'?", errors)
        result = json.loads(succeed(["swarmanoid", "run", ROBOTS, "--out", out, "--quiet"], environment))
        self.assertEqual(600, result["ticks"])
        ways = {}
        pens = {"a": (0.0, 1.0), "b": (1.05, 2.05), "c": (2.1, 3.1)}
        with open(os.path.join(out, "e_pucks.txt")) as file:
            rows = [line.split("\t") for line in file if "Epuck" in line]
        for row in rows:
            name, x, y = row[2], float(row[3]), float(row[4])
            low, high = pens[name[0]]
            self.assertTrue(low + 0.034 < x < high - 0.034 and 0.034 < y < 0.966, row)
            ways.setdefault(name, []).append((x, y))
        self.assertEqual(15, len(ways))
        for name, places in ways.items():
            way = sum(math.dist(a, b) for a, b in zip(places, places[1:]))
            self.assertGreater(way, 1.0, f"{name}: 60 s at 0.08 m/s, less the time of turns")
            self.assertLess(way, 4.9, name)
        with open(CONFORMANCE) as file:
            text = file.read()
        for engine in ("kinematics2d", "dynamics2d", "dynamics3d"):
            with open(changed, "w") as file:
                file.write(text.replace("dynamics3d", engine))
            verdict = json.loads(succeed(["swarmanoid", "run", changed, "--quiet"], environment))
            self.assertEqual({"e": "passed"}, verdict["metrics"], engine)
        return result["state_hash"]

    def check_arena_object(self, environment, out):
        """An arena object: four lanterns, in an engine and out of the robot's way; each file says in which library they are."""
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

    @contextlib.contextmanager
    def beside(self, command, environment):
        """A program that runs beside the test, and gets a Ctrl-C if it is still there at the end."""
        program = subprocess.Popen(command, env=environment, text=True, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            yield program
        finally:
            if program.poll() is None:
                program.send_signal(signal.SIGINT)
            program.communicate(timeout=60)

    def check_run_under_ros(self, environment, headless_out, out):
        """The same under ROS: the controllers are nodelets of their own packages, and the files are the same."""
        with self.beside([*LAUNCH, f"experiment:={EXPERIMENT}", f"out:={out}", "paused:=true"], environment) as launch:
            self.wait_for_space(launch, environment)
            maps = self.maps_of_manager(launch.pid)
            for library in ("libpatrol_nodelet.so", "libface_north_nodelet.so", "libcompass.so", "libcarousel.so",
                            "libodometer.so"):
                self.assertIn(library, maps)
            self.resume(launch, environment, "finished after 69 ticks")
        for name in OUTPUTS:
            with open(os.path.join(headless_out, name)) as first, open(os.path.join(out, name)) as second:
                self.assertEqual(first.read(), second.read(), name)

    def check_robot_under_ros(self, environment, headless_out, out):
        """Its devices have topics, as those of the suite's robots, and it goes the same ways."""
        with self.beside([*LAUNCH, f"experiment:={ROBOTS}", f"out:={out}", "paused:=true", "device_topics:=all"],
                         environment) as launch:
            self.wait_for_space(launch, environment)
            with self.beside(["rostopic", "echo", "-n", "1", "/b_3/proximity/angles"], environment) as echo:
                while echo.poll() is None:  # topics of devices are there after the first tick
                    succeed(["rosservice", "call", "/space/step", "1"], environment)
                angles = next(json.loads(line) for line in echo.stdout if line.startswith("["))  # after warnings
            self.assertEqual(len(SENSOR_ANGLES), len(angles))
            for expected, angle in zip(SENSOR_ANGLES, angles):
                self.assertAlmostEqual(expected, angle, places=5)
            topics = succeed(["rostopic", "list"], environment).split()
            for robot in (f"{pen}_{i}" for pen in "abc" for i in range(1, 6)):
                for topic in ("proximity", "cmd_vel", "leds/command", "leds/state"):
                    self.assertIn(f"/{robot}/{topic}", topics)
            self.resume(launch, environment, "finished after 600 ticks")
        with open(f"{headless_out}/e_pucks.txt") as first, open(f"{out}/e_pucks.txt") as second:
            self.assertEqual(first.read(), second.read())

    def check_mock_robot(self, environment):
        """Its mock drivers, and its controller on them: it goes to the wall ahead, 0.3 m away, and turns before it."""
        folder = os.path.dirname(ROBOTS)
        drivers = ["roslaunch", "swarmanoid_hosts", "mock_robot.launch", "robot:=e", "type:=e_puck",
                   "devices:=differential_drive leds proximity", f"world:={folder}/config/mock_world.yaml"]
        host = ["roslaunch", "swarmanoid_hosts", "robot.launch", "robot:=e", "controller:=diffusion", "provider:=topics",
                f"configuration:={folder}/config/diffusion.yaml"]
        with self.beside(drivers, environment) as mock:
            while run(["rosservice", "type", "/e_drivers/get_loggers"], environment)[0] != 0:  # the drivers' master is there
                self.assertIsNone(mock.poll(), "the drivers have ended")
                time.sleep(0.2)
            with self.beside(host, environment) as controller:
                ahead, turned = self.watch_mock_robot(controller, environment)
        self.assertTrue(0.15 < ahead < 0.3 - 0.035, ahead)
        self.assertGreater(turned, 0.1)

    def watch_mock_robot(self, controller, environment):
        """@return how far ahead it went, and how far it turned (the sine of half the angle), after a minute at the latest"""
        end = time.monotonic() + 60
        ahead, turned = 0.0, 0.0
        while (ahead < 0.15 or turned < 0.1) and time.monotonic() < end:
            self.assertIsNone(controller.poll(), "the controller has ended")
            code, printed, _ = run(["timeout", "5", "rostopic", "echo", "-n", "1", "-p", "/e/ground_truth/odom/pose/pose"], environment)
            if code == 0:
                values = dict(zip(*(line.split(",") for line in printed.split())))
                ahead = max(ahead, float(values["field.position.x"]))
                turned = max(turned, abs(float(values["field.orientation.z"])))
        return ahead, turned

    def resume(self, launch, environment, end):
        succeed(["rosservice", "call", "/space/resume"], environment)
        output, _ = launch.communicate(timeout=60)
        self.assertEqual(0, launch.returncode, output)
        self.assertIn(end, output)

    def wait_for_space(self, launch, environment):
        """Its services are there when all nodelets are."""
        while run(["rosservice", "call", "/space/pause"], environment)[0] != 0:
            self.assertIsNone(launch.poll(), "roslaunch has ended")
            time.sleep(0.2)

    def maps_of_manager(self, launch_pid):
        """Files that the nodelet manager started by a roslaunch has in memory."""
        for status in glob.glob("/proc/[0-9]*/status"):
            folder = os.path.dirname(status)
            try:
                with open(status) as text, open(folder + "/cmdline") as command:
                    if f"\nPPid:\t{launch_pid}\n" in text.read() and "\0manager\0" in command.read():
                        with open(folder + "/maps") as maps:
                            return maps.read()
            except FileNotFoundError:
                continue  # a process that has just ended
        raise AssertionError("there is no nodelet manager")

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
        """Debugging information may name sources; nothing that is read while running may."""
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
