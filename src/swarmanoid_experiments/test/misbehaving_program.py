"""Shared by the tests of the program with misbehaving users' code: the actions' messages, and calls of the program."""

import json
import os
import subprocess

import rosbag

from misbehaving_world import ROBOTS, world, world_with
from program_world import HEADER, ProgramTest

TIMEOUT = 60.0  # [s]

OTHER = ", which is no std::exception"
THROWN = {
    "throw_runtime_error": "told to",
    "throw_derived": "a derived exception",
    "throw_bad_alloc": "std::bad_alloc",
    "throw_int": "threw the number 7" + OTHER,
    "throw_string": "threw the text 'a string'" + OTHER,
    "throw_text": "threw the text 'a text'" + OTHER,
    "throw_null": "threw a null pointer" + OTHER,
    "throw_nullptr": "threw a null pointer" + OTHER,
    "throw_thing": "threw a 'swarmanoid::test::(anonymous namespace)::Thing'" + OTHER,
    "throw_pointer": "threw a 'std::runtime_error*'" + OTHER,
    "throw_without_text": "threw an exception without a text",
    "throw_null_text": "threw an exception without a text",
    "throw_nested": "the outer one",
}
CRASHES = {
    "segv_read": "crashed: SIGSEGV", "segv_write": "crashed: SIGSEGV", "segv_call": "crashed: SIGSEGV",
    "segv_raise": "crashed: SIGSEGV", "stack_overflow": "crashed: SIGSEGV", "bus": "crashed: SIGBUS",
    "fpe": "crashed: SIGFPE", "ill": "crashed: SIGILL", "abort": "crashed: SIGABRT", "terminate": "crashed: SIGABRT",
    "pure_virtual": "crashed: SIGABRT", "throw_through_noexcept": "crashed: SIGABRT",
    "exit_0": "called exit", "exit_7": "called exit", "quick_exit_0": "called quick_exit",
    "thread_exit": "called pthread_exit",
}


class MisbehavingTest(ProgramTest):
    @staticmethod
    def text(phase, action, who=None, **more):
        """@param who: plugin that misbehaves; by default only the fourth robot's controller"""
        return world(phase, action, **more) if who is None else world_with(who, phase, action, **more)

    def misbehave(self, phase, action, *arguments, environment="", **more):
        """Runs the experiment to its end. @return exit code, summary or None, error stream"""
        (self.folder / "world.xml").write_text(self.text(phase, action, **more))
        done = subprocess.run(["swarmanoid", "run", "world.xml", "--quiet", "--force", *arguments], cwd=self.folder,
                              env=dict(os.environ, MISBEHAVING=environment), timeout=TIMEOUT, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, encoding="utf-8", errors="replace", check=False)
        return done.returncode, json.loads(done.stdout) if done.stdout else None, done.stderr

    def start(self, phase, action, *arguments, preexec_fn=None, **more):
        (self.folder / "world.xml").write_text(self.text(phase, action, **more))
        # Python starts children with its own SIGINT handling; the shell of a test may ignore the signal
        process = subprocess.Popen(["swarmanoid", "run", "world.xml", "--quiet", "--force", *arguments], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                                   preexec_fn=preexec_fn)
        for clean_up in (process.wait, process.stderr.close, process.stdout.close, process.kill):
            self.addCleanup(clean_up)
        return process

    def read_until(self, process, text):
        lines = []
        for line in process.stderr:
            lines.append(line)
            if text in line:
                return line
        self.fail(f"not found: {text} in {lines}")

    def assert_table(self, ticks):
        """Expects the state before the first tick, and after each of `ticks` ticks, in the table."""
        lines = (self.folder / "table.txt").read_text().splitlines(keepends=True)
        self.assertEqual(lines[1], HEADER)
        self.assertEqual(len([line for line in lines if not line.startswith("#")]), (ticks + 1) * len(ROBOTS))
        self.assertTrue(lines[-1].endswith("\n"))

    def assert_bag(self, ticks):
        with rosbag.Bag(str(self.folder / "run.bag")) as bag:
            states = [message.tick for _, message, _ in bag.read_messages(topics=["/space/world_state"])]
        self.assertEqual(states, list(range(ticks + 1)))
