#!/usr/bin/python3
"""robot_test.py BUILD: the workspace of a robot's computer. Builds only the four packages for robots, checks that they do not depend
on or link parts of a simulator, and runs controllers of that workspace on robots that the simulator of the build folder BUILD has."""

import glob
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import xml.etree.ElementTree

from surroundings import REPOSITORY, bare, compiler_cache, sourced, succeed

PACKAGES = ("swarmanoid_controllers", "swarmanoid_hosts", "swarmanoid_interface", "swarmanoid_msgs")
# dependencies of a simulator: engines, readers of robot models, threads, viewers, its own packages
SIMULATOR = re.compile(r"\bode\b|libode|box2d|urdf|tbb|xxhash|rviz|gazebo|swarmanoid_(?!hosts|interface|controllers|msgs)", re.I)
CONTROLLERS = {"footbot": "footbot_retrieval", "eyebot": "eyebot_retrieval", "handbot": "climbing"}
TIMEOUT = 60.0  # [s]
BUILD = os.path.abspath(sys.argv[1])


class Program:
    """A program that keeps running, with its output."""

    def __init__(self, command, environment):
        self._process = subprocess.Popen(command, env=environment, cwd=environment["HOME"], text=True,
                                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self._lines = []
        self._reader = threading.Thread(target=lambda: self._lines.extend(iter(self._process.stdout.readline, "")))
        self._reader.start()

    def output(self):
        return "".join(list(self._lines))

    def is_running(self):
        return self._process.poll() is None

    def end(self):
        """Ends the program by SIGINT, like Ctrl-C. @return its exit code"""
        if self.is_running():
            self._process.send_signal(signal.SIGINT)
        code = self._process.wait(TIMEOUT)
        self._reader.join()
        self._process.stdout.close()
        return code


def dependencies(package):
    """Dependencies in a package.xml, without those for tests."""
    root = xml.etree.ElementTree.parse(package).getroot()
    return {element.text for element in root if element.tag.endswith("depend") and element.tag != "test_depend"}


class RobotTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="swarmanoid_robot_")
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.bare = bare(os.path.join(cls.folder, "home"))
        for package in PACKAGES:
            shutil.copytree(os.path.join(REPOSITORY, "src", package), os.path.join(cls.folder, "src", package))
        cls.build = os.path.join(cls.folder, "build")
        source = os.path.join(cls.folder, "src")
        shutil.copy("/usr/share/catkin/cmake/toplevel.cmake", os.path.join(source, "CMakeLists.txt"))
        succeed(["cmake", "-S", source, "-B", cls.build, "-G", "Ninja", "-DPYTHON_EXECUTABLE=/usr/bin/python3",
                 "-DPython3_EXECUTABLE=/usr/bin/python3", "-DCATKIN_ENABLE_TESTING=OFF", "-DCMAKE_UNITY_BUILD=ON",
                 "-DCMAKE_CXX_FLAGS_RELEASE=-DNDEBUG",  # without optimisation: compiles faster, and is fast enough for real time
                 f"-DCATKIN_DEVEL_PREFIX={cls.folder}/devel", *compiler_cache()], cls.bare)
        succeed(["cmake", "--build", cls.build, "-j2"], cls.bare, timeout=1200)
        cls.environment = sourced(cls.bare, f"{cls.folder}/devel/setup.bash")
        cls.simulator = sourced(cls.bare, f"{BUILD}/devel/setup.bash")

    def test_no_simulator_is_named(self):
        for package in PACKAGES:
            named = dependencies(os.path.join(self.folder, "src", package, "package.xml"))
            self.assertEqual([], sorted(filter(SIMULATOR.search, named)), package)
        with open(os.path.join(self.build, "CMakeCache.txt")) as cache:
            found = re.findall(r"^(\w+)_DIR:PATH=(?!.*-NOTFOUND)(.*)$", cache.read(), re.M)
        self.assertIn("roscpp", dict(found), "the cache says which packages were found")
        self.assertEqual([], [name for name, _ in found if SIMULATOR.search(name)])

    def test_no_simulator_is_linked(self):
        for name in ("libode.so.8", "libbox2d.so.2", "libtbb.so.12", "liburdfdom_model.so.3", "libswarmanoid_space.so"):
            self.assertTrue(SIMULATOR.search(name), name)
        libraries = glob.glob(f"{self.folder}/devel/lib/*.so")
        self.assertGreaterEqual(len(libraries), 2 + 1 + 2 * 8)
        for file in libraries:
            linked = succeed(["ldd", file], self.environment)
            self.assertNotIn("not found", linked, file)
            names = re.findall(r"^\s*(\S+)", linked, re.M)
            self.assertEqual([], list(filter(SIMULATOR.search, map(os.path.basename, names))), file)

    # --- controllers on simulated robots

    def odometry(self, robot):
        """The position of a robot [m]."""
        output = succeed(["timeout", "20", "rostopic", "echo", "-n1", f"/{robot}/ground_truth/odom/pose/pose/position"],
                         self.environment)
        return {name: float(value) for name, value in re.findall(r"^([xyz]): (\S+)$", output, re.M)}

    def reading(self, topic):
        return succeed(["timeout", "20", "rostopic", "echo", "-n1", topic], self.environment)

    def wait_for(self, is_so, host):
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            if is_so():
                return
            self.assertTrue(host.is_running(), host.output())
            time.sleep(0.2)
        self.fail("it never happens\n" + host.output())

    def check(self, kind, happens):
        """Starts robot and controller, waits for the expected event, and ends the controller."""
        robot = kind + "_1"
        share = f"{self.folder}/src/swarmanoid_controllers/config"
        drivers = Program(["roslaunch", "swarmanoid_experiments", "mock_robot.launch", f"robot:={robot}", f"type:={kind}"],
                          self.simulator)
        self.addCleanup(drivers.end)
        host = Program(["roslaunch", "--wait", "swarmanoid_hosts", "robot.launch", f"robot:={robot}", "provider:=topics",
                        f"controller:={CONTROLLERS[kind]}", f"configuration:={share}/{CONTROLLERS[kind]}.yaml"],
                       self.environment)
        try:
            self.wait_for(lambda: f"{robot}: running" in host.output(), host)
            self.wait_for(lambda: happens(robot), host)
        finally:
            code = host.end()
        self.assertEqual(0, code, host.output())
        self.assertIn(f"{robot}: ended", host.output(), "it was stopped safely")
        return robot

    def test_footbot_drives_to_the_prey_and_grips_it(self):
        robot = self.check("footbot", lambda name: "True" in self.reading(f"/{name}/gripper/state/gripping"))
        position = self.odometry(robot)
        self.assertGreater(abs(position["x"]) + abs(position["y"]), 0.3)
        speed = float(self.reading(f"/{robot}/ground_truth/odom/twist/twist/linear/x").split()[0])
        self.assertLess(abs(speed), 1e-3, "it stands")

    def test_eyebot_flies_over_the_prey_and_comes_down_in_the_end(self):
        robot = self.check("eyebot", lambda name: self.odometry(name)["x"] > 0.7)
        self.assertLess(self.odometry(robot)["z"], 0.1)

    def test_handbot_climbs(self):
        robot = self.check("handbot", lambda name: self.odometry(name)["z"] > 0.3)
        self.assertIn("attached: True", self.reading(f"/{robot}/rope/state"), "it does not fall when its host ends")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
