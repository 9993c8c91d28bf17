#!/usr/bin/python3
"""Pause, step, resume, reset, and interventions between ticks."""

import sys
import threading
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import Point, PoseStamped
from rosgraph_msgs.msg import Clock
from swarmanoid_msgs.msg import DeviceError, EntityPose, EntitySpecification, Event, RunResult, TextParameter, WorldState
from swarmanoid_msgs.srv import ResetRequest
from visualization_msgs.msg import MarkerArray

from space_client import Collector, Space


def pose(x, y, frame="world"):
    result = PoseStamped()
    result.header.frame_id = frame
    result.pose.position.x = x
    result.pose.position.y = y
    result.pose.orientation.w = 1.0
    return result


def footbot(name, x, y, **more):
    return EntitySpecification(name=name, type="footbot", engines=["ground"], controller="fc", pose=pose(x, y), **more)


class ServicesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.space = Space()
        cls.states = Collector("/space/world_state", WorldState)
        cls.clocks = Collector("/clock", Clock)
        cls.events = Collector("/space/events", Event)
        for collector in (cls.states, cls.clocks, cls.events):
            collector.wait_for_publisher()

    def setUp(self):
        self.run_number = self.space.restart().run
        self.states.clear()
        self.clocks.clear()
        self.events.clear()

    def state_after(self, tick):
        state = self.states.wait_for(lambda s: s.tick == tick and s.run == self.run_number)
        self.assertIsNotNone(state, f"no world state of tick {tick}")
        return state

    def test_step_answers_when_the_ticks_are_complete(self):
        answer = self.space.step(5)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(5, answer.tick)
        self.assertEqual(answer.stamp, self.state_after(5).header.stamp)
        self.assertIsNotNone(self.clocks.wait_for(lambda c: c.clock == answer.stamp), "the clock is not up to date")
        self.assertEqual(7, self.space.step(2).tick)

    def test_nothing_moves_while_paused(self):
        tick = self.space.step(1).tick
        time.sleep(0.3)
        self.assertEqual(tick + 1, self.space.step(1).tick)

    def test_every_tick_is_published(self):
        self.space.step(20)
        self.state_after(20)
        ticks = [s.tick for s in self.states.messages() if s.run == self.run_number]
        self.assertEqual(list(range(1, 21)), [tick for tick in ticks if tick > 0])

    def test_who_comes_while_it_is_paused_sees_the_present_state(self):
        self.space.step(3)
        stamp = self.state_after(3).header.stamp
        late = Collector("/space/markers", MarkerArray)  # without an earlier subscriber in this process
        markers = late.wait_for(lambda array: True).markers
        self.assertEqual({stamp}, {marker.header.stamp for marker in markers})

    def test_step_refuses_nonsense(self):
        answer = self.space.step(0)
        self.assertFalse(answer.success)
        self.assertEqual("ticks: found 0, allowed: at least 1", answer.message)

    def test_pause_resume_and_toggle_say_what_they_did(self):
        self.assertEqual("it was not running", self.space.pause().message)
        self.space.reset(scope=0)
        self.assertEqual("resumed", self.space.toggle_pause().message)
        self.space.pause()
        self.space.reset(scope=0)
        self.assertEqual("resumed", self.space.resume().message)

    def test_a_pause_ends_a_long_step(self):
        answers = []
        self.space.restart()
        stepping = threading.Thread(target=lambda: answers.append(self.space.step(10**6)))
        stepping.start()
        time.sleep(0.02)
        self.assertTrue(self.space.pause().success)
        stepping.join(10.0)
        self.assertFalse(answers[0].success)
        self.assertIn("before all of them were made", answers[0].message)

    def test_reset_repeats_the_run_and_keeps_time_rising(self):
        before = self.space.step(30)
        first = self.state_after(30)
        self.run_number = self.space.reset(scope=0).run
        after = self.space.step(30)
        self.assertEqual(first.state_hash, self.state_after(30).state_hash)
        self.assertGreater(after.stamp, before.stamp)

    def test_reset_with_another_seed_is_another_run(self):
        self.space.step(30)
        first = self.state_after(30)
        self.run_number = self.space.reset(scope=0, seed=2).run
        self.space.step(30)
        self.assertNotEqual(first.state_hash, self.state_after(30).state_hash)
        self.space.reset(scope=0, seed=1)

    def test_an_empty_reset_keeps_the_seed(self):
        self.assertEqual("reset, seed 2", self.space.reset(scope=0, seed=2).message)
        self.assertEqual("reset, seed 2 as before; zero_seed: true for the seed 0",
                         self.space.reset(ResetRequest()).message)
        self.assertEqual("reset, seed 1", self.space.reset(scope=0, seed=1).message)

    def test_a_reset_to_seed_0_is_asked_for_in_its_own_field(self):
        self.assertEqual("reset, seed 0", self.space.reset(scope=0, zero_seed=True).message)
        self.assertEqual("reset, seed 0 as before; zero_seed: true for the seed 0",
                         self.space.reset(ResetRequest()).message, "it is kept like any other")
        answer = self.space.reset(scope=0, zero_seed=True, seed=3)
        self.assertEqual((False, "zero_seed: found true beside seed 3, allowed: one of them"),
                         (answer.success, answer.message))
        self.space.reset(scope=0, seed=1)

    def test_reset_may_rewind_time(self):
        self.space.step(10)
        self.assertEqual(rospy.Time(1), self.space.reset(scope=7).stamp)
        self.assertFalse(self.space.reset(scope=2).success)

    def test_spawned_moved_and_deleted(self):
        self.space.step(1)
        answer = self.space.spawn([footbot("fb_9", 4.5, 4.5)])
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(1, answer.tick)
        self.space.step(1)
        self.assertIn("fb_9", self.state_after(2).names)
        self.assertIsNotNone(self.events.wait_for(lambda e: e.kind == Event.SPAWNED and e.entity == "fb_9"))

        answer = self.space.move([EntityPose("fb_9", pose(0.4, 4.4))])
        self.assertTrue(answer.success, answer.message)
        self.space.step(1)
        state = self.state_after(3)
        self.assertAlmostEqual(0.4, state.poses[state.names.index("fb_9")].position.x, delta=0.03)

        self.assertTrue(self.space.delete(["fb_9"]).success)
        self.space.step(1)
        self.assertNotIn("fb_9", self.state_after(4).names)
        self.assertTrue(self.space.spawn([footbot("fb_9", 4.5, 4.5)]).success, "a name is free after its entity")

    def test_handed_over(self):
        def engine_of(name, state):
            return state.engines[state.names.index(name)]

        lonely = footbot("fb_9", 4.5, 4.5)
        lonely.engines = []
        self.assertTrue(self.space.spawn([lonely]).success)
        self.space.step(1)
        state = self.state_after(1)
        self.assertEqual(("", "ground"), (engine_of("fb_9", state), engine_of("fb_1", state)))
        answer = self.space.handover(["fb_9", "fb_1"], "ground")  # fb_1 is already there
        self.assertTrue(answer.success, answer.message)
        self.assertEqual((2, 1), (answer.count, answer.tick))
        self.space.step(1)
        self.assertEqual("ground", engine_of("fb_9", self.state_after(2)))
        event = self.events.wait_for(lambda e: e.kind == Event.HANDED_OVER)
        self.assertEqual(("fb_9", "from no engine to ground"), (event.entity, event.text))
        self.assertIsNotNone(self.events.wait_for(lambda e: e.kind == Event.INTERVENTION and e.entity == "fb_9"))

    def test_a_handover_that_cannot_be_changes_nothing(self):
        self.space.step(5)
        before = self.state_after(5)
        answer = self.space.handover(["fb_1", "fb_2"], "sky")
        self.assertFalse(answer.success)
        self.assertEqual(0, answer.count)
        self.assertIn("footbot 'fb_1' cannot be handed over to engine 'sky': found at z = 0", answer.message)
        self.assertIn("did you mean 'fb_1'?", self.space.handover(["fb_11"], "ground").message)
        self.assertIn("there are: ground, sky", self.space.handover(["fb_1"], "gruond").message)
        self.space.step(1)
        after = self.state_after(6).state_hash
        self.run_number = self.space.reset(scope=0).run
        self.space.step(6)
        self.assertEqual(before.state_hash, self.state_after(5).state_hash)
        self.assertEqual(after, self.state_after(6).state_hash)

    def test_a_property_is_set(self):
        def color_after(tick):
            state = self.state_after(tick)
            color = state.colors[state.names.index("prey_yellow")]
            return color.r, color.g, color.b

        self.space.step(1)
        self.assertEqual((1.0, 1.0, 0.0), color_after(1))
        answer = self.space.set_property(["prey_yellow"], "color", "0, 0, 255")
        self.assertTrue(answer.success, answer.message)
        self.assertEqual((1, 1), (answer.count, answer.tick))
        self.space.step(1)
        self.assertEqual((0.0, 0.0, 1.0), color_after(2))
        event = self.events.wait_for(lambda e: e.kind == Event.INTERVENTION)
        self.assertEqual(("prey_yellow", "color from yellow to blue"), (event.entity, event.text))
        answer = self.space.set_property(["prey_yellow", "fb_1"], "colour", "red")
        self.assertEqual((False, 0), (answer.success, answer.count))
        self.assertEqual("cylindric_prey 'prey_yellow': found the property 'colour', allowed: color; did you mean 'color'?",
                         answer.message)

    def test_a_floor_that_takes_no_paint_is_not_painted(self):
        answer = self.space.paint_floor([Point(1.0, 1.0, 0.0)], 0.1, "black", 0.5)
        self.assertEqual((False, 0), (answer.success, answer.count))
        self.assertEqual("found paint for the floor, allowed: in an arena with <floor_paint>", answer.message)

    def test_a_device_breaks_and_is_mended(self):
        def x_after(tick):
            state = self.state_after(tick)
            return state.poses[state.names.index("fb_1")].position.x

        self.space.step(1)
        dead = DeviceError(kind="dead")
        answer = self.space.set_fault(["fb_1"], "footbot_wheels", [dead])
        self.assertTrue(answer.success, answer.message)
        self.assertEqual((1, 1), (answer.count, answer.tick))
        self.space.step(1)
        x = x_after(2)
        self.space.step(9)
        self.assertEqual(x, x_after(11))
        event = self.events.wait_for(lambda e: e.kind == Event.INTERVENTION)
        self.assertEqual(("fb_1", "footbot_wheels: dead"), (event.entity, event.text))
        answer = self.space.set_fault(["fb_1", "prey_yellow"], "footbot_wheels", [])
        self.assertEqual((False, 1), (answer.success, answer.count))
        self.assertEqual("there is no robot 'prey_yellow' with a controller", answer.message)
        self.space.step(10)
        self.assertNotEqual(x, x_after(21))
        noise = DeviceError(kind="gaussian", field="lft", parameters=[TextParameter("deviation", "0.1")])
        answer = self.space.set_fault(["fb_1"], "footbot_wheels", [noise])
        self.assertIn("did you mean 'left'?", answer.message)
        noise.parameters[0].name = "devation"
        answer = self.space.set_fault(["fb_1"], "footbot_wheels", [noise])
        self.assertIn("did you mean 'deviation'?", answer.message)

    def test_a_robot_is_inspected_without_a_topic_of_its_own(self):
        self.space.step(7)
        state = self.state_after(7)
        answer = self.space.inspect(name="fb_1")
        self.assertTrue(answer.success, answer.message)
        place = state.names.index("fb_1")
        self.assertEqual(("paused", 7, self.run_number, state.header.stamp, 0.0),
                         (answer.state, answer.tick, answer.run, answer.stamp, answer.target_real_time_factor))
        self.assertEqual(("footbot", state.engines[place], state.poses[place], state.twists[place], ""),
                         (answer.type, answer.engine, answer.pose, answer.twist, answer.gripped))
        self.assertEqual(("fc", "controller", ""), (answer.controller, answer.command_source, answer.failure))
        devices = {device.type: device for device in answer.devices}
        kinds = [device.is_actuator for device in answer.devices]
        self.assertEqual(sorted(kinds), kinds, "sensors first")
        wheels, proximity = devices["footbot_wheels"], devices["footbot_proximity"]
        self.assertEqual((True, ["left", "right"], ["rad/s", "rad/s"]), (wheels.is_actuator, wheels.names, wheels.units))
        self.assertGreater(sum(abs(value) for value in wheels.values), 0.0, "it stands still")
        self.assertEqual((False, 24), (proximity.is_actuator, len(proximity.values)))
        self.assertEqual(["value[0]", "value[23]"], [proximity.names[0], proximity.names[23]])

        preys = self.space.inspect(name="prey_yellow")
        self.assertEqual((True, "cylindric_prey", "", []), (preys.success, preys.type, preys.controller, preys.devices))
        nobody = self.space.inspect(name="fb_11")
        self.assertEqual((False, "paused", 7), (nobody.success, nobody.state, nobody.tick))
        self.assertIn("there is no entity 'fb_11'; did you mean 'fb_1'?", nobody.message)
        run = self.space.inspect()
        self.assertEqual((True, "", "", []), (run.success, run.name, run.type, run.devices))
        self.assertEqual("fb_1", self.space.inspect(near=state.poses[place].position, within=0.01).name)

    def test_the_real_time_factor_changes_while_it_runs(self):
        def tick():
            return self.space.inspect().tick

        answer = self.space.set_real_time_factor(1e-7)
        self.assertEqual((False, "real_time_factor: found 1e-07, allowed: 0, or a number from 1e-06 to 1000000"),
                         (answer.success, answer.message))
        try:
            self.assertTrue(self.space.set_real_time_factor(0.5).success)
            self.assertEqual(0.5, self.space.inspect().target_real_time_factor)
            start = time.monotonic()
            self.space.resume()
            while tick() < 4:  # 0.2 s each, the first one at once
                time.sleep(0.01)
            self.assertGreater(time.monotonic() - start, 0.55)
            self.assertEqual("running", self.space.inspect().state)
        finally:
            self.space.pause()
            self.assertEqual("as fast as possible", self.space.set_real_time_factor(0.0).message)

    def test_reset_undoes_interventions(self):
        self.space.spawn([footbot("fb_9", 4.5, 4.5)])
        self.space.delete(["prey_yellow"])
        self.run_number = self.space.reset(scope=0).run
        self.space.step(1)
        names = self.state_after(1).names
        self.assertNotIn("fb_9", names)
        self.assertIn("prey_yellow", names)

    def test_bad_requests_are_refused_with_a_reason(self):
        def refusal(answer):
            self.assertFalse(answer.success)
            return answer.message

        self.assertIn("did you mean 'footbot'?", refusal(self.space.spawn(
            [EntitySpecification(name="a", type="footbt", pose=pose(1, 1))])))
        self.assertIn("letters, digits and _", refusal(self.space.spawn([footbot("/a", 4.5, 4.5)])))
        self.assertIn("exists already", refusal(self.space.spawn([footbot("fb_1", 4.5, 4.5)])))
        self.assertIn("overlaps", refusal(self.space.spawn([footbot("a", 4.0, 1.5)])))
        twice = footbot("a", 4.5, 4.5)
        twice.engines = ["ground", "ground"]
        self.assertEqual("spawned 'a': found the entity 'a' twice in the engine 'ground', allowed: once",
                         refusal(self.space.spawn([twice])))
        self.assertIn("position: found '4.5, 1e+40, 0', allowed: in the arena, from 0, 0, 0 to ",
                      refusal(self.space.spawn([footbot("a", 4.5, 1e40)])))
        self.assertIn("position: found '-1, 1, 0', allowed: in the arena",
                      refusal(self.space.move([EntityPose("fb_1", pose(-1, 1))])))
        prey = EntitySpecification(name="a", type="cylindric_prey", engines=["ground"], pose=pose(4.5, 4.5))
        prey.parameters = [TextParameter("radius", "0.1"), TextParameter("height", "0.1"), TextParameter("mass", "1"),
                           TextParameter("mass", "2")]
        self.assertEqual("spawned 'a': found a second 'mass' of a cylindric_prey, allowed: one",
                         refusal(self.space.spawn([prey])))
        prey.parameters = [TextParameter("radius", "1e-9"), TextParameter("height", "0.1")]
        self.assertEqual("spawned 'a': radius: found '1e-9', allowed: a number from 0.0001 to 10000",
                         refusal(self.space.spawn([prey])))
        self.assertIn("'map'", refusal(self.space.move([EntityPose("fb_1", pose(1, 1, "map"))])))
        self.assertIn("there is no entity 'nobody'", refusal(self.space.delete(["nobody"])))
        self.assertIn("does not have", refusal(self.space.spawn(
            [EntitySpecification(name="a", type="eyebot", engines=["sky"], controller="fc", pose=pose(1, 1))])))

    def test_the_first_that_is_refused_ends_the_list(self):
        answer = self.space.spawn([footbot("fb_7", 4.5, 4.5), footbot("fb_7", 4.5, 4.5), footbot("fb_8", 0.4, 4.5)])
        self.assertFalse(answer.success)
        self.assertEqual(1, answer.count)

    def test_a_finished_run_says_so_until_it_is_reset(self):
        results = Collector("/space/result", RunResult)
        answer = self.space.step(6000)
        self.assertFalse(answer.success)
        self.assertEqual("the run finished before all of them were made", answer.message)
        result = results.wait_for(lambda r: r.run == self.run_number)
        self.assertTrue(result.finished)
        self.assertEqual(answer.tick, result.ticks)
        self.assertFalse(self.space.resume().success)
        self.assertTrue(self.space.reset(scope=0).success)
        self.assertTrue(self.space.step(1).success)


if __name__ == "__main__":
    rospy.init_node("services_test")
    rostest.rosrun("swarmanoid_experiments", "services", ServicesTest, sys.argv)
