#!/usr/bin/python3
"""A controller on another host that commands its robot over standard topics; the link is cut during a run: the robot stops
by itself, and continues when the link is restored."""

import pathlib
import time
import unittest

from rosgraph_msgs.msg import Log
from swarmanoid_msgs.msg import Event, WorldState

from space_client import Collector, Space
from two_hosts_case import TwoHostsCase

EXPERIMENT = pathlib.Path(__file__).resolve().parent / "topics.xml"
CUT = 2.0  # [s]
CONFIGURATION = """
robot_type: footbot
rate: 10
sensors: [footbot_proximity]
actuators: [footbot_wheels]
sensor_timeout: 0.5
"""
COMMANDED = "commands come over topics"
SILENT = "no more commands over topics, the robot stops"


class TwoHostsTopicsTest(TwoHostsCase):
    """Master, the simulated robot and this test are on host a, its controller is on host b."""

    def wait_for_event(self, text):
        event = self.events.wait_for(lambda event: event.entity == "fb_2" and event.text == text)
        self.assertIsNotNone(event, text)
        self.events.clear()
        return event

    def place(self):
        self.worlds.clear()
        world = self.worlds.wait_for(lambda _: True)
        position = world.poses[world.names.index("fb_2")].position
        return position.x, position.y

    def test_the_robot_stops_while_the_link_is_cut(self):
        configuration = self.folder / "fb_2.yaml"
        configuration.write_text(CONFIGURATION)
        self.launch(self.hosts.a, "run.launch", experiment=EXPERIMENT, allow_remote_files="true", rviz="false", paused="true",
                    real_time_factor=1, on_end="stay")
        space = Space()
        self.events = Collector("/space/events", Event)
        self.worlds = Collector("/space/world_state", WorldState)
        logs = Collector("/rosout", Log)
        self.events.wait_for_publisher()
        self.worlds.wait_for_publisher()
        self.launch(self.hosts.b, "robot.launch", robot="fb_2", controller="diffusion", provider="topics",
                    configuration=configuration)
        self.addCleanup(self.hosts.join)
        space.resume()
        self.wait_for_event(COMMANDED)
        start = self.place()
        time.sleep(1.0)
        self.assertNotEqual(start, self.place())

        self.hosts.cut()
        cut = time.monotonic()
        self.wait_for_event(SILENT)
        self.assertLess(time.monotonic() - cut, CUT)
        stopped = self.place()
        time.sleep(max(0.0, cut + CUT - time.monotonic()))
        self.assertEqual(stopped, self.place())

        self.hosts.join()
        self.wait_for_event(COMMANDED)
        time.sleep(0.5)
        self.assertNotEqual(stopped, self.place())
        # the host's view of the cut, which reaches the log when the link is restored
        self.assertIsNotNone(logs.wait_for(lambda log: "footbot_proximity" in log.msg and log.level >= Log.WARN),
                             [log.msg for log in logs.messages()])


if __name__ == "__main__":
    unittest.main(verbosity=2, warnings="ignore")  # of sockets that rospy leaves open
