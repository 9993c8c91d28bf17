#!/usr/bin/python3
"""A controller on another host, in lockstep over a slow link that is cut during a run: the bits of a run in process if the
policy waits, and the policy's result otherwise."""

import re
import threading
import time
import unittest

from swarmanoid_msgs.msg import Event, RunResult

from participants import LockstepStatus
from space_client import TIMEOUT, Collector, Space, run_without_ros
from two_hosts_case import DELAY, TwoHostsCase

PATIENCE = 1.0  # [s] for each answer except the first
CUT = 2.0  # [s]
TICKS = 300
FINISHED = "the run finished before all of them were made"


class TwoHostsLockstepTest(TwoHostsCase):
    """Master, space and this test are on host a, the eyebot's controller is on host b."""

    def start(self, policy):
        self.hashes = self.folder / f"{self.id()}.txt"
        self.launch(self.hosts.a, "run.launch", seed=1, allow_remote_files="true", max_ticks=TICKS, hashes=self.hashes, rviz="false",
                    paused="true", real_time_factor=0, on_end="stay", set="arena.eb.controller.source=remote")
        self.space = Space()
        self.events = Collector("/space/events", Event)
        self.events.wait_for_publisher()
        self.launch(self.hosts.b, "robot.launch", robot="eb", controller="eyebot_retrieval", policy=policy,
                    timeout=PATIENCE)
        self.addCleanup(self.hosts.join)
        self.assertTrue(self.space.step(20).success)

    def assert_event(self, kind, pattern):
        self.assertIsNotNone(self.events.wait_for(
            lambda event: event.kind == kind and event.entity == "eb_controller" and re.fullmatch(pattern, event.text)),
            f"{pattern}, among {[event.text for event in self.events.messages()]}")

    def assert_same_bits(self):
        """Expects the run of the program, tick by tick."""
        expected = run_without_ros(self, "object_retrieval", 1)
        self.assertEqual(expected[:TICKS + 1], self.hashes.read_text().splitlines())

    def test_slow_link(self):
        self.start("wait")
        start = time.monotonic()
        self.assertEqual(FINISHED, self.space.step(10**6).message)
        seconds = time.monotonic() - start
        self.assert_same_bits()
        self.assertGreater(seconds, (TICKS - 20) * 2 * DELAY, "the link is not slow")
        print(f"{DELAY * 1e3:g} ms each way: {(TICKS - 20) / seconds:.0f} ticks/s")

    def test_link_cut_wait(self):
        self.start("wait")
        answers = []
        stepping = threading.Thread(target=lambda: answers.append(self.space.step(10**6)))
        stepping.start()
        time.sleep(0.5)
        self.hosts.cut()
        time.sleep(CUT)
        self.assertEqual([], answers)
        self.assertTrue(LockstepStatus().wait_for("missing: 'eb_controller'"))
        self.hosts.join()
        stepping.join(TIMEOUT)
        self.assertEqual(FINISHED, answers[0].message)
        self.assert_event(Event.PARTICIPANT_LATE, rf"no answer in tick \d+ \({PATIENCE:g} s\); policy wait")
        self.assert_event(Event.PARTICIPANT_JOINED, r"is back in tick \d+")
        self.assert_same_bits()

    def test_link_cut_skip(self):
        self.start("skip")
        self.hosts.cut()
        start = time.monotonic()
        self.assertTrue(self.space.step(100).success)
        self.assertLess(time.monotonic() - start, PATIENCE + 1.0, "only one tick waits")
        self.assert_event(Event.PARTICIPANT_LATE, rf"no answer in tick 20 \({PATIENCE:g} s\); policy skip")
        self.assertTrue(LockstepStatus().wait_for("missing: 'eb_controller'"))
        time.sleep(max(0.0, start + CUT - time.monotonic()))
        self.hosts.join()
        self.assertTrue(LockstepStatus().wait_for("1 participants"))
        start = time.monotonic()
        self.assertTrue(self.space.step(20).success)
        self.assertGreater(time.monotonic() - start, 20 * 2 * DELAY, "it is waited for in each tick again")
        self.assert_event(Event.PARTICIPANT_JOINED, r"is back: it answered for tick \d+")
        late = [event for event in self.events.messages() if event.kind == Event.PARTICIPANT_LATE]
        self.assertEqual(1, len(late))

    def test_link_cut_stop(self):
        results = Collector("/space/result", RunResult)
        self.start("stop")
        self.hosts.cut()
        reason = f"tick 20: participant 'eb_controller': no answer in tick 20 ({PATIENCE:g} s); policy stop"
        start = time.monotonic()
        self.assertEqual("the run has stopped: " + reason, self.space.step(20).message)
        self.assertLess(time.monotonic() - start, PATIENCE + 1.0)
        self.assertIsNotNone(results.wait_for(lambda result: not result.finished and result.message == reason))


if __name__ == "__main__":
    unittest.main(verbosity=2, warnings="ignore")  # of sockets that rospy leaves open
