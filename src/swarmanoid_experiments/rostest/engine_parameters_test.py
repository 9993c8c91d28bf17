#!/usr/bin/python3
"""Engines under ROS: their diagnostics, and parameters that change live through the client of dynamic_reconfigure."""

import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure import DynamicReconfigureCallbackException
from dynamic_reconfigure.client import Client
from dynamic_reconfigure.msg import Config
from swarmanoid_msgs.msg import Event

from space_client import TIMEOUT, Collector, Space

ENGINE = "/space/engines/space"
FILE = {"iterations": 50, "gravity": 9.81, "friction": 0.5, "treel_friction": 0.9, "restitution": 0.0,
        "grip_strength": 50.0, "suction_strength": 30.0, "rope_strength": 80.0, "rope_drag": 0.0,
        "magnet_strength": 60.0}


def values(config):
    return {name: value for name, value in config.items() if name not in ("groups", "last_error")}


class EngineParametersTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()
        cls.client = Client(ENGINE, timeout=TIMEOUT)
        cls.events = Collector("/space/events", Event)
        cls.updates = Collector(ENGINE + "/parameter_updates", Config)
        for collector in (cls.events, cls.updates):
            collector.wait_for_publisher()

    def setUp(self):
        self.space.restart()
        self.client.update_configuration(FILE)
        self.events.clear()

    def test_description_is_what_the_engine_says(self):
        described = {p["name"]: p for p in self.client.get_parameter_descriptions(timeout=TIMEOUT)}
        self.assertEqual(set(FILE) | {"last_error"}, set(described))
        self.assertEqual((0.0, 100.0, 9.81), tuple(described["gravity"][key] for key in ("min", "max", "default")))
        self.assertEqual("Downwards along z. [m/s2]", described["gravity"]["description"])
        self.assertEqual("int", described["iterations"]["type"])
        self.assertEqual(FILE, values(self.client.update_configuration({})), "what it has now, not what came as an update before")

    def test_a_change_is_an_intervention_of_the_next_tick_and_a_reset_takes_it_back(self):
        self.space.step(3)
        answer = self.client.update_configuration({"gravity": 3.5, "grip_strength": 20.0})
        self.assertEqual({**FILE, "gravity": 3.5, "grip_strength": 20.0}, values(answer))
        self.space.step(1)
        event = self.events.wait_for(lambda e: e.kind == Event.INTERVENTION and "gravity" in e.text)
        self.assertIsNotNone(event)
        self.assertEqual(("dynamics3d 'space': gravity from 9.81 to 3.5", 4), (event.text, event.tick))
        self.updates.clear()
        self.space.restart()
        self.assertIsNotNone(self.updates.wait_for(
            lambda c: {d.name: d.value for d in c.doubles}["gravity"] == 9.81), "nobody reports the reset")

    def test_what_is_out_of_range_is_refused_as_a_whole(self):
        with self.assertRaises(DynamicReconfigureCallbackException):
            self.client.update_configuration({"friction": 1.0, "gravity": -1.0})
        self.space.step(1)
        self.assertIsNone(self.events.wait_for(lambda e: e.kind == Event.INTERVENTION, timeout=0.5))
        self.assertEqual(FILE, values(self.client.update_configuration({})))

    def test_a_client_learns_why_it_was_refused(self):
        self.updates.clear()
        reason = "gravity: found '-1', allowed: a number from 0 to 100 (0, or at least 1e-09)"
        with self.assertRaises(DynamicReconfigureCallbackException) as refused:
            self.client.update_configuration({"gravity": -1.0})
        self.assertIn(reason, str(refused.exception.__context__).replace("\\", ""))
        update = self.updates.wait_for(lambda c: reason in {s.name: s.value for s in c.strs}["last_error"])
        self.assertIsNotNone(update, "it is not in the update that user interfaces show")
        self.assertEqual(9.81, {d.name: d.value for d in update.doubles}["gravity"])
        answer = self.client.update_configuration({"gravity": 5.0, "last_error": "sent back by a client"})
        self.assertEqual((5.0, ""), (answer["gravity"], answer["last_error"]))

    def test_diagnostics_have_a_status_of_the_engine(self):
        self.space.step(5)
        arrays = Collector("/diagnostics", DiagnosticArray)
        array = arrays.wait_for(lambda a: any(s.name == ENGINE[1:] + ": engine" and
                                              any(v.key == "steps" and v.value == "50" for v in s.values)
                                              for s in a.status))
        self.assertIsNotNone(array)
        status = next(s for s in array.status if s.name == ENGINE[1:] + ": engine")
        self.assertEqual("works", status.message)
        values = {value.key: value.value for value in status.values}
        self.assertEqual(("dynamics3d", "0", "10"), (values["kind"], values["mirrors"], values["steps a tick"]))
        self.assertEqual("0", values["steps left to the iterative solver"])


if __name__ == "__main__":
    rospy.init_node("engine_parameters_test", anonymous=True)
    rostest.rosrun("swarmanoid_experiments", "engine_parameters", EngineParametersTest, sys.argv)
