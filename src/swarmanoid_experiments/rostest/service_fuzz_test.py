#!/usr/bin/python3
"""Services of a running space, called with arbitrary requests: each call is answered, with a reason if it is rejected, and
the space continues. FUZZED_CALLS=2000 makes that many calls; FUZZ_SEED=2 makes different ones.

A robot, or a step, may wait for a participant that registered here and never answers. The next pause and source therefore
undo steps and registered participants."""

import os
import pathlib
import random
import signal
import sys
import threading
import time
import unittest

import rosgraph
import rospy
from std_srvs.srv import Trigger

from roslaunch_process import LAUNCH_FOLDER, RoslaunchTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "fuzz"))
from service_requests import Requests  # noqa: E402  pylint: disable=wrong-import-position

CALLS = int(os.environ.get("FUZZED_CALLS", 150))
SEED = os.environ.get("FUZZ_SEED", "1")
PATIENCE = 20.0  # [s] of wall time for each answer
# experiment: engines, entities, controllers
WORLDS = {"object_retrieval": (["ground", "sky"], ["fb_1", "fb_2", "fb_3", "eb", "prey_yellow"], ["fc", "ec"]),
          "shelf_retrieval": (["ground", "space"], ["hb_1", "fb_1", "fb_2", "box_1"], ["climbing"]),
          "group_pull": (["ground"], ["prey", "fb_1", "fb_10"], ["pull"])}
STOPPED = "the run has stopped: "


class ServiceFuzzTest(RoslaunchTest):
    launch_file = LAUNCH_FOLDER / "run.launch"

    def call(self, name, kind, request):
        """@return the answer, None without one, and the problem with it"""
        answers = []

        def ask():
            try:
                answers.append(rospy.ServiceProxy("/space/" + name, kind)(**request))
            except rospy.ServiceException as error:
                answers.append(error)
            except Exception as error:  # such a request cannot even be sent
                answers.append(error)

        asking = threading.Thread(target=ask, daemon=True)
        asking.start()
        asking.join(PATIENCE if name != "step" else 1.0)
        if not answers and name == "step":
            rospy.ServiceProxy("/space/pause", Trigger)()  # it waits for a participant
            asking.join(PATIENCE)
        return answers[0] if answers else None

    def start_space(self, experiment):
        self.process = self.launch("rviz:=false", f"experiment:={experiment}", "real_time_factor:=0", "max_ticks:=1000000000",
                                   "lockstep_policy:=skip", "lockstep_join_timeout:=0.1", "lockstep_timeout:=0.1",
                                   "on_end:=stay")
        os.environ.update(ROS_MASTER_URI=self.master, ROS_HOSTNAME="localhost")
        until = time.monotonic() + PATIENCE
        while not rosgraph.is_master_online() or not self.is_offered("/space/set_command_source"):
            self.assertLess(time.monotonic(), until, "the space does not start")
            time.sleep(0.05)

    @staticmethod
    def is_offered(name):
        return name in [service for service, _ in rosgraph.Master("/service_fuzz_test").getSystemState()[2]]

    def end_space(self):
        self.process.send_signal(signal.SIGINT)
        return self.end_of(self.process)[1]

    def fuzz(self, experiment, calls):
        """@return numbers of accepted, rejected and unsendable calls; and reasons for which the run stopped"""
        numbers = random.Random(f"{SEED}/{experiment}")
        requests = Requests(numbers, *WORLDS[experiment])
        done = refused = unsent = 0
        stops = []
        self.start_space(experiment)
        for number in range(calls):
            name, kind, request = requests.make()
            what = f"call {number}: {name} {str(request)[:600]}"
            answer = self.call(name, kind, request)
            if answer is None or self.process.poll() is not None:
                self.fail(f"{what}: no answer\n{self.end_space()[-3000:]}")
            if isinstance(answer, rospy.ServiceException):
                self.fail(f"{what}: {answer}\n{self.end_space()[-3000:]}")
            elif isinstance(answer, Exception):
                unsent += 1
            elif answer.success:
                done += 1
            else:
                refused += 1
                self.assertGreater(len(answer.message), 7 if name != "step" else 0, what)
                if STOPPED in answer.message:
                    stops.append(answer.message)
                    self.end_space()
                    self.start_space(experiment)
        self.assertTrue(self.call("pause", Trigger, {}).message)
        output = self.end_space()
        self.assertNotIn("exit code -", output)
        return done, refused, unsent, stops

    def test_each_call_is_answered(self):
        for experiment in WORLDS:
            with self.subTest(experiment):
                done, refused, unsent, stops = self.fuzz(experiment, CALLS // len(WORLDS))
                print(f"{experiment}: {done} done, {refused} refused, {unsent} cannot be sent, {len(stops)} stopped the run")
                for stop in stops:
                    print("  " + stop)
                self.assertGreater(done, CALLS // len(WORLDS) // 10)
                self.assertGreater(refused, CALLS // len(WORLDS) // 10)


if __name__ == "__main__":
    unittest.main(warnings="ignore")  # of sockets in rospy
