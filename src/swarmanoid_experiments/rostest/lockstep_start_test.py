#!/usr/bin/python3
"""A space with a remotely commanded robot waits in its first tick: a participant for the robot can register, however the
run was started, and all services of the space answer in the meantime.

LOCKSTEP_STARTS=20 starts each installed experiment that many times, in turn at all paces; by default some of them start once."""

import contextlib
import os
import signal
import threading
import time
import unittest

import rosgraph
import rospy
from std_srvs.srv import Trigger
from swarmanoid_msgs.srv import Delete, Reset, SetCommandSource, Step

from participants import Participant
from roslaunch_process import LAUNCH_FOLDER, RoslaunchTest

STARTS = int(os.environ.get("LOCKSTEP_STARTS", 0))
PATIENCE = 20.0  # [s] of wall time for each answer
PACES = [(factor, paused) for factor in (0, 1, 10) for paused in ("false", "true")]
# experiment: robot, its controller
REMOTE = {"aggregation": ("fb_1", "aggregation"), "battery_foraging": ("fb_1", "footbot_battery_foraging"),
          "chain_formation": ("fb_1", "chain_formation"), "charging": ("fb_1", "footbot_charging"),
          "climbing": ("hb_1", "climbing"), "conformance": ("hb", "conformance"), "diffusion": ("fb_1", "diffusion"),
          "emergent_taxis": ("fb_1", "emergent_taxis"), "evolved_retrieval": ("eb", "eyebot_retrieval"),
          "eyebot_flocking": ("eb_1", "eyebot_flocking"), "flocking": ("fb_1", "flocking"),
          "foraging": ("fb_1", "footbot_foraging"), "gap": ("fb_3", "chain"), "group_pull": ("fb_7", "pulling"),
          "neural_aggregation": ("fb_1", "recurrent_network"), "neural_phototaxis": ("fb_1", "feed_forward_network"),
          "object_retrieval": ("eb", "eyebot_retrieval"), "phototaxis": ("fb_1", "phototaxis"),
          "predators": ("fb_1", "predators"),
          "rough_terrain": ("summit_1", "diffusion"), "shelf_retrieval": ("hb_1", "climbing"),
          "trail": ("fb_1", "trail_following"), "two_spot_foraging": ("fb_1", "behaviour_machine")}
# all robots of a distribution have the same source
DISTRIBUTED = ("aggregation", "battery_foraging", "chain_formation", "diffusion", "emergent_taxis",
               "eyebot_flocking", "flocking", "neural_aggregation", "neural_phototaxis", "predators", "two_spot_foraging")
QUICK = [("object_retrieval", 0, "false"), ("shelf_retrieval", 1, "false"), ("diffusion", 10, "true")]


class LockstepStartTest(RoslaunchTest):
    launch_file = LAUNCH_FOLDER / "run.launch"

    @contextlib.contextmanager
    def waiting_space(self, experiment, factor, paused):
        robot = REMOTE[experiment][0]
        setting = f"arena.{robot}.controller.source=remote"
        if experiment in DISTRIBUTED:
            group = robot.split("_")[0]
            setting = f"arena.distribute.quantity=1 arena.{group}.controller.source=remote"
        elif experiment == "climbing":
            setting = "arena.hb.controller.source=remote"
        process = self.launch("rviz:=false", f"experiment:={experiment}", f"real_time_factor:={factor}",
                              f"paused:={paused}", f"set:={setting}", "on_end:=stay")
        os.environ.update(ROS_MASTER_URI=self.master, ROS_HOSTNAME="localhost")
        try:
            yield
        finally:
            process.send_signal(signal.SIGINT)
            self.end_of(process)

    def call(self, name, kind, **request):
        """Calls a service that must be offered in time, and must answer in time."""
        until = time.monotonic() + PATIENCE
        master = rosgraph.Master("/lockstep_start_test")
        while not rosgraph.is_master_online() or name not in [service for service, _ in master.getSystemState()[2]]:
            self.assertLess(time.monotonic(), until, f"{name} is not offered")
            time.sleep(0.02)
        answers = []
        calling = threading.Thread(target=lambda: answers.append(rospy.ServiceProxy(name, kind)(**request)), daemon=True)
        calling.start()
        calling.join(PATIENCE)
        self.assertTrue(answers, f"{name} does not answer")
        return answers[0]

    def ticks(self):
        """Pauses the space. @return number of finished ticks"""
        self.assertTrue(self.call("/space/pause", Trigger).success)
        return self.call("/space/step", Step, ticks=1).tick

    def participant_runs(self, experiment, factor, paused):
        robot, controller = REMOTE[experiment]
        with self.subTest(experiment=experiment, factor=factor, paused=paused), \
                self.waiting_space(experiment, factor, paused):
            self.call("/space/pause", Trigger)
            self.assertTrue(self.call("/space/resume", Trigger).success)
            participant = Participant(robot, controller)
            try:
                until = time.monotonic() + PATIENCE
                while self.ticks() < 3:
                    self.assertLess(time.monotonic(), until, "nothing moves")
                    self.call("/space/resume", Trigger)
            finally:
                participant.end()

    def test_a_participant_registers_and_runs(self):
        starts = [(experiment, *PACES[i % len(PACES)]) for experiment in REMOTE for i in range(STARTS)]
        for start in starts or QUICK:
            self.participant_runs(*start)

    def test_services_answer_while_the_first_tick_waits(self):
        with self.waiting_space("object_retrieval", 0, "false"):
            self.assertTrue(self.call("/space/pause", Trigger).success)
            self.assertTrue(self.call("/space/resume", Trigger).success)
            self.assertTrue(self.call("/space/reset", Reset, seed=5).success)
            self.assertTrue(self.call("/space/delete", Delete, names=["fb_2"]).success)
            answer = self.call("/space/set_command_source", SetCommandSource, names=["eb"], source="none")
            self.assertTrue(answer.success, answer.message)
            self.assertEqual(0, answer.tick)
            until = time.monotonic() + PATIENCE
            while self.ticks() < 2:
                self.assertLess(time.monotonic(), until, "it waits on")
                self.call("/space/resume", Trigger)

    def test_a_source_that_nobody_fills_can_be_undone(self):
        with self.waiting_space("object_retrieval", 0, "true"):
            for source in ("controller", "remote", "none", "remote", "controller"):
                answer = self.call("/space/set_command_source", SetCommandSource, names=["eb"], source=source)
                self.assertTrue(answer.success, answer.message)
                self.call("/space/resume", Trigger)
            self.assertGreater(self.ticks(), 0)


if __name__ == "__main__":
    unittest.main(warnings="ignore")  # of sockets in rospy
