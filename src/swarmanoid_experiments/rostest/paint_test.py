#!/usr/bin/python3
"""The paint service on the floor of the trail experiment: interventions, events, and markers of that colour."""

import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import Point
from swarmanoid_msgs.msg import Event, Intervention
from visualization_msgs.msg import MarkerArray

from space_client import Collector, Space


def blue_cells(array):
    """Returns the positions of blue cells in the markers."""
    return [(round(point.x, 6), round(point.y, 6)) for marker in array.markers if marker.ns == "paint"
            for point, color in zip(marker.points, marker.colors) if color.b == 1.0]


class PaintTest(unittest.TestCase):
    def setUp(self):
        self.space = Space()
        self.space.restart()

    def test_discs_are_painted_one_after_the_other(self):
        events = Collector("/space/events", Event)
        interventions = Collector("/space/interventions", Intervention)
        markers = Collector("/space/markers", MarkerArray)
        for collector in (events, interventions, markers):
            collector.wait_for_publisher()
        answer = self.space.paint_floor([Point(1.51, 2.49, 0.0), Point(3.31, 0.27, 0.0)], 0.0, "blue", 0.5)
        self.assertEqual((True, 2, 0), (answer.success, answer.count, answer.tick), answer.message)
        answer = self.space.paint_floor([Point(2.0, 1.0, 0.0), Point(4.5, 1.0, 0.0)], 0.1, "red", 1.0)
        self.assertEqual((False, 1), (answer.success, answer.count))
        self.assertEqual("position: found 4.5, 1, allowed: in the arena, from 0, 0 to 4, 3", answer.message)
        self.assertTrue(self.space.step(1).success)
        for place, color in (("1.51, 2.49", "blue"), ("3.31, 0.27", "blue"), ("2, 1", "red")):
            with self.subTest(place=place):
                self.assertIsNotNone(events.wait_for(lambda each: each.text == "paint at " + place))
                self.assertIsNotNone(interventions.wait_for(
                    lambda each: each.kind == "paint" and f'position="{place}"' in each.text and f'color="{color}"' in each.text))
        self.assertIsNotNone(markers.wait_for(lambda array: blue_cells(array) == [(1.51, 2.49), (3.31, 0.27)]))

    def test_a_call_paints_up_to_its_limit_of_cells(self):
        """The floor has 200 x 150 cells, and a disc of 10 m covers them all: 559 of them fit into 2^24 cells."""
        answer = self.space.paint_floor([Point(2.0, 1.5, 0.0)] * 561, 10.0, "blue", 0.5)
        self.assertEqual((False, 559), (answer.success, answer.count), answer.message)
        self.assertEqual("found 16800000 cells in the squares around the discs, allowed: at most 16777216 in one call", answer.message)


if __name__ == "__main__":
    rospy.init_node("paint_test")
    rostest.rosrun("swarmanoid_experiments", "paint", PaintTest, sys.argv)
