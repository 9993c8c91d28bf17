"""Checks of outside_test.py for robots defined by a description: the e-puck (examples/example_robot), and the TurtleBot3."""

import json
import math
import os
import time

from outside_ros import LAUNCH, RosChecks, beside
from surroundings import REPOSITORY, read, run, succeed

ROBOTS = os.path.join(REPOSITORY, "examples/example_robot/e_pucks.xml")
CONFORMANCE = os.path.join(REPOSITORY, "examples/example_robot/conformance.xml")
SQUARE = os.path.join(REPOSITORY, "examples/example_turtlebot3/square.xml")
SENSOR_ANGLES = (-0.3008, -0.8008, -math.pi / 2, -2.644, 2.6392, math.pi / 2, 0.7992, 0.2992)  # of the e-puck [rad]


def square_with_slip(side, slip):
    """@return distance from the start after a square whose sides and turns are all shorter by the fraction `slip`, and the
    angle missing to a full turn [rad]"""
    x = y = heading = 0.0
    for _ in range(4):
        x += (1 - slip) * side * math.cos(heading)
        y += (1 - slip) * side * math.sin(heading)
        heading += (1 - slip) * math.pi / 2
    return math.hypot(x, y), 2 * math.pi - heading


class RobotChecks(RosChecks):
    """A test case with installed or built examples in an environment."""

    def check_robot(self, environment, out):
        """A robot by description is listed, and diffuses in each engine without touching walls or leaving its pen."""
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
        text = read(CONFORMANCE)
        for engine in ("kinematics2d", "dynamics2d", "dynamics3d"):
            with open(changed, "w") as file:
                file.write(text.replace("dynamics3d", engine))
            verdict = json.loads(succeed(["swarmanoid", "run", changed, "--quiet"], environment))
            self.assertEqual({"e": "passed"}, verdict["metrics"], engine)
        return result["state_hash"]

    def run_square(self, environment, out, *options):
        """@return metrics of the rule, and the positions along the path"""
        result = json.loads(succeed(["swarmanoid", "run", SQUARE, "--out", out, "--quiet", "--force", *options], environment))
        self.assertEqual([], result["failed_controllers"])
        with open(os.path.join(out, "square.txt")) as file:
            places = [tuple(float(number) for number in line.split("\t")[3:5]) for line in file if "Burger" in line]
        return {name.split(".")[1]: value for name, value in result["metrics"].items()}, places

    def check_turtlebot(self, environment, out):
        """A TurtleBot3 drives a square of 1 m: exactly by odometry, and with the error predicted by geometry if wheels slip."""
        self.assertIn("\n  turtlebot3_burger: A TurtleBot3 Burger: two wheels and a caster.\n",
                      succeed(["swarmanoid", "list", "entity"], environment))
        measured, places = self.run_square(environment, out)
        for name in ("odometry_error", "from_start", "heading_error"):
            self.assertLess(measured[name], 1e-3, f"{name} of dynamics2d")
        for corner in ((0.5, 0.5), (1.5, 0.5), (1.5, 1.5), (0.5, 1.5)):
            self.assertLess(min(math.dist(corner, place) for place in places), 1e-3, corner)
        speeds = [math.dist(one, other) / 0.1 for one, other in zip(places, places[1:])]
        self.assertAlmostEqual(0.2, max(speeds), places=3)
        slip, drive = 0.02, "controllers.square.actuators.differential_drive"
        measured, _ = self.run_square(environment, out, *(
            f"--set={drive}.{option}" for option in ("implementation=slipping", f"slip_left={slip}", f"slip_right={slip}",
                                                     "slip_noise=0")))
        from_start, heading_error = square_with_slip(1.0, slip)
        self.assertAlmostEqual(from_start, measured["from_start"], places=3)
        self.assertAlmostEqual(from_start, measured["odometry_error"], places=3, msg="it believes that it is back")
        self.assertAlmostEqual(heading_error, measured["heading_error"], places=3)

    def check_robot_under_ros(self, environment, headless_out, out):
        """The robot's devices have topics, as those of the suite's robots, and it takes the same paths as without ROS."""
        with beside([*LAUNCH, f"experiment:={ROBOTS}", f"out:={out}", "paused:=true", "device_topics:=all"],
                         environment) as launch:
            self.wait_for_space(launch, environment)
            with beside(["rostopic", "echo", "-n", "1", "/b_3/proximity/angles"], environment) as echo:
                while echo.poll() is None:  # topics of devices exist after the first tick
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
        self.assertEqual(read(f"{headless_out}/e_pucks.txt"), read(f"{out}/e_pucks.txt"))

    def check_mock_robot(self, environment):
        """The robot's controller in a process of its own: it drives towards the wall, 0.3 m ahead, and turns before it."""
        folder = os.path.dirname(ROBOTS)
        drivers = ["roslaunch", "swarmanoid_experiments", "mock_robot.launch", "robot:=e", f"place:={folder}/mock_robot.xml"]
        host = ["roslaunch", "swarmanoid_hosts", "robot.launch", "robot:=e", "controller:=diffusion", "provider:=topics",
                f"configuration:={folder}/config/diffusion.yaml"]
        with beside(drivers, environment) as mock:
            while run(["rosservice", "type", "/e_drivers/get_loggers"], environment)[0] != 0:  # waits for the drivers' master
                self.assertIsNone(mock.poll(), "the drivers have ended")
                time.sleep(0.2)
            with beside(host, environment) as controller:
                ahead, turned = self.watch_mock_robot(controller, environment)
        self.assertTrue(0.15 < ahead < 0.3 - 0.035, ahead)
        self.assertGreater(turned, 0.1)

    def watch_mock_robot(self, controller, environment):
        """@return distance ahead, and turn (sine of half the angle), after at most a minute"""
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
