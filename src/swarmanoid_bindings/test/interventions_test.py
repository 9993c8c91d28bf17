#!/usr/bin/python3
"""Interventions in a running world from Python, and the messages of rejected ones."""

import math
import pickle
import unittest

import numpy
import swarmanoid
from swarmanoid import (Delete, Disc, ErrorModel, HandOver, Move, Paint, SetCommandSource, SetEngineParameters, SetFault,
                        SetProperty, Spawn)


def pose_of(simulation, name):
    entities = simulation.entities
    return entities.poses[entities.names.index(name)]


class InterventionsTest(unittest.TestCase):
    def refused(self, simulation, message, intervention):
        before = simulation.state_hash
        with self.assertRaisesRegex(swarmanoid.InterventionError, message):
            simulation.apply(intervention)
        self.assertEqual(simulation.state_hash, before)

    def test_moves(self):
        simulation = swarmanoid.Simulation("phototaxis")
        simulation.apply(Move("fb_1", (3.5, 2.0, 0), heading=math.pi / 2))
        numpy.testing.assert_allclose(pose_of(simulation, "fb_1"), [3.5, 2, 0, 0, 0, math.sqrt(0.5), math.sqrt(0.5)])
        simulation.apply(Move("fb_1", numpy.array([3.5, 0.5, 0.0]), orientation=(0, 0, 1, 0)))
        numpy.testing.assert_array_equal(pose_of(simulation, "fb_1"), [3.5, 0.5, 0, 0, 0, 1, 0])
        simulation.tick()
        self.assertIn({"kind": "moved", "entity": "fb_1", "other": "", "text": ""}, simulation.events)
        self.assertEqual([what for asked_by, what in simulation.interventions if not asked_by],
                         [Move("fb_1", (3.5, 2.0, 0), heading=math.pi / 2), Move("fb_1", (3.5, 0.5, 0), (0, 0, 1, 0))])
        self.refused(simulation, "^move is refused: there is no entity 'fb_9'", Move("fb_9", (1, 1, 0)))
        self.refused(simulation, "move is refused: .*position: found '9, 1, 0'", Move("fb_1", (9, 1, 0)))
        x, y, _ = pose_of(simulation, "fb_2")[:3]
        self.refused(simulation, "move is refused: footbot 'fb_1' in engine 'ground': overlaps 'fb_2'", Move("fb_1", (x, y, 0)))

    def test_spawns_and_deletes(self):
        simulation = swarmanoid.Simulation("phototaxis", seed=3)
        simulation.apply(Spawn("footbot", "newcomer", (1, 1, 0), heading=1.0, engines=["ground"], controller="pc"))
        simulation.apply(Spawn("block", "pillar", (4, 2, 0.1), parameters={"size": (0.2, 0.3, 0.2)}))
        self.assertEqual(simulation.robots.names[-1], "newcomer")
        simulation.tick(5)
        self.assertGreater(numpy.linalg.norm(pose_of(simulation, "newcomer")[:2] - [1, 1]), 0.01)
        robots = simulation.robots
        simulation.apply(Delete("newcomer"))
        with self.assertRaisesRegex(RuntimeError, "an earlier tick"):
            robots.poses
        self.assertEqual(simulation.robots.names, ["fb_1", "fb_2", "fb_3", "fb_4"])
        self.refused(simulation, "delete is refused: there is no entity 'newcomer'", Delete("newcomer"))
        self.refused(simulation, "spawn is refused: spawned 'pillar': an entity 'pillar' exists already",
                     Spawn("block", "pillar", (1, 2, 0.1), parameters={"size": (0.2, 0.3, 0.2)}))
        self.refused(simulation, "spawn is refused: .*found 'footbit', allowed: .*did you mean 'footbot'", Spawn("footbit", "a", (1, 1, 0)))
        self.refused(simulation, "found the id 'pd', allowed: pc", Spawn("footbot", "a", (1, 1, 0), controller="pd"))
        self.refused(simulation, "parameter of a block: found 'siz', allowed: .*size",
                     Spawn("block", "b", (1, 2, 0.1), parameters={"siz": 1}))

    def test_robots_of_a_controller_in_python_come_and_go(self):
        seen = []
        simulation = swarmanoid.Simulation("phototaxis", controllers={"pc": lambda robots: seen.append(robots.names)})
        simulation.tick()
        simulation.apply(Spawn("footbot", "fb_5", (1, 1, 0), engines=["ground"], controller="pc"))
        simulation.apply(Delete("fb_2"))
        simulation.apply(SetCommandSource("fb_3", "none"))
        simulation.tick()
        self.assertEqual(seen, [["fb_1", "fb_2", "fb_3", "fb_4"], ["fb_1", "fb_4", "fb_5"]])

    def test_sets_properties_and_parameters(self):
        simulation = swarmanoid.Simulation("phototaxis")
        simulation.apply(SetProperty("east", "intensity", 50))
        numpy.testing.assert_array_equal(simulation.entities.property("intensity")[-6:], [1, 50] + [numpy.nan] * 4)
        self.refused(simulation, "property is refused: .*'intensty'.*did you mean 'intensity'", SetProperty("east", "intensty", 1))
        pull = swarmanoid.Simulation("group_pull")
        pull.apply(SetEngineParameters("ground", {"contact_friction": 0.2}))
        pull.tick()
        self.assertTrue(any("contact_friction from" in event["text"] for event in pull.events), pull.events)
        self.refused(pull, "engine_parameters is refused: .*has no parameter 'contact_fricton'.*did you mean 'contact_friction'",
                     SetEngineParameters("ground", {"contact_fricton": 0.2}))

    def test_paints(self):
        simulation = swarmanoid.Simulation("trail")
        clean = simulation.state_hash
        simulation.apply(Paint([Disc((2, 1), 0.1, "red"), Disc((2, 2), 0, (0, 0, 255), strength=0.5)]))
        self.assertNotEqual(simulation.state_hash, clean)
        self.refused(simulation, "paint is refused: disc 2: radius: found -1", Paint([Disc((2, 1), 0.1, "red"), Disc((2, 1), -1, "red")]))
        self.refused(swarmanoid.Simulation("diffusion"), "allowed: in an arena with <floor_paint>", Paint([Disc((2, 1), 0.1, "red")]))

    def test_hands_over(self):
        simulation = swarmanoid.Simulation("shelf_retrieval")
        simulation.apply(HandOver("fb_1", "space"))
        simulation.tick()
        self.assertIn("fb_1", [event["entity"] for event in simulation.events if event["kind"].startswith("hand")])
        self.refused(simulation, "handover is refused: .*'spac'", HandOver("fb_1", "spac"))

    def test_breaks_and_mends_devices(self):
        simulation = swarmanoid.Simulation("diffusion")
        simulation.apply(SetFault("fb_7", "footbot_proximity", [ErrorModel("bias", parameters={"offset": 0.25})]))
        simulation.tick()
        value = simulation.robots.readings["footbot_proximity"].value
        self.assertTrue((value[6] >= 0.25).all())
        self.assertTrue((value[5] == 0).any())
        simulation.apply(SetFault("fb_7", "footbot_proximity"))
        simulation.tick()
        self.assertTrue((simulation.robots.readings["footbot_proximity"].value[6] == 0).any())
        self.refused(simulation, "fault is refused: .*found the device 'footbot_proximty'.*did you mean",
                     SetFault("fb_7", "footbot_proximty"))
        self.refused(simulation, "fault is refused: .*'biass'", SetFault("fb_7", "footbot_proximity", [ErrorModel("biass")]))

    def test_what_is_no_intervention_is_refused(self):
        simulation = swarmanoid.Simulation("diffusion")
        with self.assertRaisesRegex(TypeError, "found 7, allowed: an intervention, such as Move"):
            simulation.apply(7)
        for message, make in ((r"position: found \(1, 2\), allowed: 3 finite numbers", lambda: Move("a", (1, 2))),
                              (r"position: found \(1, 2, nan\), allowed", lambda: Move("a", (1, 2, math.nan))),
                              ("position: found 'abc', allowed", lambda: Move("a", "abc")),
                              ("orientation: found .*that is not 0", lambda: Move("a", (1, 2, 0), (0, 0, 0, 0))),
                              ("color: found 'reddish'", lambda: Disc((1, 1), 0.1, "reddish")),
                              ("source: found 'me', allowed: controller", lambda: SetCommandSource("a", "me"))):
            with self.assertRaisesRegex(ValueError, message):
                make()
        with self.assertRaisesRegex(TypeError, "found orientation beside heading"):
            Move("a", (1, 2, 0), (0, 0, 0, 1), heading=1)

    def test_is_not_applied_in_a_tick_or_once_closed(self):
        simulation = swarmanoid.Simulation("diffusion", controllers={"dc": lambda robots: simulation.apply(Delete("fb_1"))})
        with self.assertRaisesRegex(RuntimeError, "is making ticks"):
            simulation.tick()
        simulation.close()
        with self.assertRaisesRegex(RuntimeError, "is closed"):
            simulation.apply(Delete("fb_1"))

    def test_values_are_read_as_they_are_made(self):
        self.assertEqual(repr(Move("fb_1", (1, 2.5, 0))),
                         "Move(entity='fb_1', position=(1.0, 2.5, 0.0), orientation=(0.0, 0.0, 0.0, 1.0))")
        self.assertEqual(repr(Paint([Disc((2, 1), 0.1, (255, 0, 0))])),
                         "Paint(discs=(Disc(position=(2.0, 1.0), radius=0.1, color='red', strength=1.0),))")
        values = [Move("a", (1, 2, 0), heading=0.5), Delete("a"), HandOver("a", "b"), SetCommandSource("a", "none"),
                  SetProperty("a", "b", True), SetEngineParameters("a", {"b": 0.5}), Paint([Disc((2, 1), 0.1, "red")]),
                  SetFault("a", "b", [ErrorModel("bias", "value", {"value": 1}, from_tick=3)]),
                  Spawn("block", "b", (1, 2, 0.1), parameters={"size": (0.2, 0.3, 0.2)}, color="red")]
        for value in values:
            with self.subTest(value):
                self.assertEqual(pickle.loads(pickle.dumps(value)), value)
                self.assertEqual(eval(repr(value), vars(swarmanoid)), value)
                self.assertEqual(len({value, pickle.loads(pickle.dumps(value))}), 1)
                self.assertTrue(type(value).__doc__)
        self.assertNotEqual(values[0], Move("b", (1, 2, 0), heading=0.5))
        self.assertNotEqual(values[0], values[1])
        with self.assertRaises(AttributeError):
            values[0].entity = "b"


if __name__ == "__main__":
    unittest.main()
