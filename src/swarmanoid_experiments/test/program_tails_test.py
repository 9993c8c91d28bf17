#!/usr/bin/env python3
"""Files of a run that is ended from outside, or whose disk is full: all data before that time are complete."""

import json
import os
import pathlib
import random
import resource
import signal
import subprocess
import time
import unittest

import misbehaving_world
from program_world import CONTROLLER_FAILED, FINISHED, INTERRUPTED, STOPPED, ProgramTest

LONG = 10**9  # ticks
FILES = ('<text_render id="t"><file>table.txt</file></text_render><debug_render id="d"><file>debug.txt</file></debug_render>'
         '<hash_recorder id="h"><file>hashes.txt</file></hash_recorder>')
FULL = "No space left on device"


class TailsTest(ProgramTest):
    def start(self, *arguments, visualisations=FILES, **options):
        """Starts an endless run that writes all kinds of files, in an empty folder."""
        for file in self.folder.iterdir():
            file.unlink()
        command = ["swarmanoid", "run", self.world(maxclock=LONG, visualisations=visualisations), "--quiet",
                   *map(str, arguments)]
        return subprocess.Popen(command, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                                **options)

    def wait_until(self, condition):
        deadline = time.monotonic() + 60
        while not condition() and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertTrue(condition())

    def has_grown(self, name="hashes.txt", size=20000):
        file = self.folder / name
        return file.exists() and file.stat().st_size > size

    def reindexed_ticks(self, bag="run.bag"):
        """Returns the ticks that `rosbag reindex` recovers."""
        done = subprocess.run(["rosbag", "reindex", "--force", bag], cwd=self.folder, timeout=120, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, encoding="utf-8", check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return self.ticks_in(self.folder / bag)

    def last_whole_tick(self, name):
        """Returns the last tick in a text with ticks in the first column."""
        lines = (self.folder / name).read_text().split("\n")[:-1]
        return int([line for line in lines if not line.startswith("#")][-1].split()[0])


class LibraryTest(ProgramTest):
    def test_a_library_that_does_not_let_the_process_end_is_left(self):
        world = self.folder / "world.xml"
        world.write_text(misbehaving_world.world())
        command = ["swarmanoid", "run", str(world), "--quiet", "--force"]
        processes = [subprocess.Popen([*command, "--out", action], cwd=self.folder, encoding="utf-8", stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, env=dict(os.environ, MISBEHAVING=f"unload {action}"))
                     for action in ("loop", "loop_deaf")]
        for process in processes:
            self.addCleanup(process.kill)
        for process in processes:
            summary, errors = process.communicate(timeout=40)
            self.assertEqual((process.returncode, errors),
                             (FINISHED, "swarmanoid: a library does not let the process end: it is left there\n"))
            self.assertTrue(json.loads(summary)["finished"])

    def test_a_library_that_crashes_as_it_is_unloaded_changes_no_exit_status(self):
        world = self.folder / "world.xml"
        crashes = {"segv_read": "SIGSEGV", "stack_overflow": "SIGSEGV", "bus": "SIGBUS", "fpe": "SIGFPE", "ill": "SIGILL", "abort": "SIGABRT",
                   "free_twice": "SIGABRT", "throw_runtime_error": "SIGABRT"}
        for phase, code in (("never", FINISHED), ("step", CONTROLLER_FAILED)):
            world.write_text(misbehaving_world.world(phase, "throw_runtime_error"))
            for action, name in crashes.items():
                with self.subTest(action=action, code=code):
                    done = subprocess.run(["swarmanoid", "run", str(world), "--quiet", "--force", "--out", "out"], cwd=self.folder,
                                          timeout=60, encoding="utf-8", stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                                          env=dict(os.environ, MISBEHAVING=f"unload {action}"))
                    self.assertEqual(done.returncode, code, done.stderr)
                    self.assertIn(f"swarmanoid: warning: a library crashed ({name}) when all was done: the exit status is that of the work\n",
                                  done.stderr)
                    self.assertGreater(json.loads(done.stdout)["ticks"], 0)

    def test_the_full_name_is_that_of_before_a_library_changes_the_folder(self):
        world = self.folder / "world.xml"
        world.write_text(misbehaving_world.world("destroy", "change_folder"))
        done = subprocess.run(["swarmanoid", "validate", "--path", world.name], cwd=self.folder, timeout=60, encoding="utf-8",
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (FINISHED, str(world), ""))


class SignalTest(TailsTest):
    def test_each_signal_that_asks_a_run_to_end_keeps_its_results(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            process = self.start("--bag", "run.bag")
            self.wait_until(self.has_grown)
            process.send_signal(number)
            output, errors = process.communicate(timeout=60)
            self.assertEqual(process.returncode, INTERRUPTED, errors)
            ticks = json.loads(output)["ticks"]
            self.assertEqual(self.ticks_in(self.folder / "run.bag"), list(range(ticks + 1)))
            self.assertEqual((self.last_whole_tick("table.txt"), self.last_whole_tick("hashes.txt")), (ticks, ticks))

    def test_nohup_is_obeyed(self):
        process = self.start("--bag", "run.bag", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.wait_until(self.has_grown)
        process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        self.assertIsNone(process.poll())
        process.terminate()
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, INTERRUPTED)

    def test_a_pipe_that_nobody_reads_does_not_end_the_run(self):
        arguments = ["swarmanoid", "run", self.world(maxclock=2000, visualisations=""), "--bag", "run.bag"]
        with subprocess.Popen(arguments, cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stderr.close()  # no reader for the progress bar
            json.loads(process.stdout.read())
        self.assertEqual(process.returncode, FINISHED)
        self.assertEqual(self.ticks_in(self.folder / "run.bag"), list(range(2001)))


class KillTest(TailsTest):
    """A run flushes its files every second, even if it writes little."""

    SELDOM = ('<text_render id="t"><file>table.txt</file><every>5000</every></text_render>'
              '<rosbag_recorder id="b" library="swarmanoid_recording"><file>run.bag</file><every>5000</every></rosbag_recorder>')

    def test_a_killed_run_loses_the_last_second_at_most(self):
        randomness = random.Random(5)
        for delay in [0.0, 0.001] + [randomness.uniform(0.0, 3.0) for _ in range(6)]:
            process = self.start(visualisations=self.SELDOM)
            self.wait_until(lambda: self.has_grown("run.bag", 4200))
            time.sleep(delay)
            process.kill()
            process.communicate(timeout=60)
            ticks = self.reindexed_ticks()
            self.assertEqual(ticks, list(range(0, 5000 * len(ticks), 5000)))
            self.assertGreater(len(ticks), 0, "the state before the first tick at the least")
            if delay > 1.5:  # the interval is one second; a busy machine gets more time
                self.assertGreater(len(ticks), 1)
                self.assertGreater(self.last_whole_tick("table.txt"), 0)

    def test_files_grow_while_little_is_written(self):
        process = self.start(visualisations=self.SELDOM)
        try:
            for name in ("run.bag", "table.txt"):
                sizes = set()
                self.wait_until(lambda: sizes.add(self.size(name)) or len(sizes) > 3)
                self.assertLess(max(sizes), 300000, "no buffer was full")
        finally:
            process.kill()
            process.communicate(timeout=60)

    def size(self, name):
        file = self.folder / name
        return file.stat().st_size if file.exists() else 0


class FullDiskTest(TailsTest):
    def test_a_bag_that_cannot_be_written_stops_the_run_at_once(self):
        done = self.call("run", self.world(maxclock=LONG), "--quiet", "--bag", "/dev/full", "--hashes", "hashes.txt")
        self.assertEqual(done.returncode, STOPPED, done.stderr)
        summary = json.loads(done.stdout)
        self.assertEqual(done.stderr, f"swarmanoid: stopped in tick {summary['ticks']}: --bag: writing /dev/full failed: {FULL}\n")
        self.assertFalse(summary["finished"])
        self.assertEqual(self.last_whole_tick("table.txt"), summary["ticks"])
        self.assertEqual(self.last_whole_tick("hashes.txt"), summary["ticks"])

    def test_texts_are_told_of_at_once_too(self):
        for label in ("text_render", "hash_recorder"):
            full = f'<{label} id="full"><file>/dev/full</file></{label}><text_render id="t"><file>t.txt</file></text_render>'
            done = self.call("run", self.world(maxclock=LONG, visualisations=full), "--quiet", "--write-anywhere", "--force")
            self.assertEqual(done.returncode, STOPPED, done.stderr)
            ticks = json.loads(done.stdout)["ticks"]
            self.assertEqual(done.stderr, f"swarmanoid: stopped in tick {ticks}: {label} 'full': writing /dev/full failed: "
                             f"{FULL}\n")
            self.assertGreaterEqual(self.last_whole_tick("t.txt"), ticks - 1)

    def test_a_failing_controller_is_not_hidden_by_a_bag_in_time(self):
        self.run_world("--bag", "run.bag", fail_at=3, code=CONTROLLER_FAILED)
        self.assertEqual(self.ticks_in(self.folder / "run.bag"), list(range(21)))

    def test_a_file_at_its_limit_is_a_full_disk(self):
        """A limit on the file size needs no rights, unlike a small file system. The bag is complete up to that size."""
        limit = 3000000
        process = self.start("--bag", "run.bag", visualisations="",
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        output, errors = process.communicate(timeout=120)
        self.assertEqual(process.returncode, STOPPED, errors)
        ticks = json.loads(output)["ticks"]
        self.assertEqual(errors, f"swarmanoid: stopped in tick {ticks}: --bag: writing {self.folder}/run.bag failed: "
                         "File too large; what was written before is complete\n")
        recorded = self.ticks_in(self.folder / "run.bag")
        self.assertEqual(recorded, list(range(len(recorded))))
        self.assertGreater(len(recorded), 1000)

    @unittest.skipUnless(os.geteuid() == 0, "only root may mount a small file system")
    def test_a_full_file_system(self):
        disk = self.folder / "disk"
        disk.mkdir()
        script = ('mount -t tmpfs -o size=2m none "$1" || exit 77; cd "$1"; shift; "$@"; code=$?; cp run.bag ..; '
                  'tail -n 1 hashes.txt > ../last_hash; exit $code')
        world = self.world(maxclock=LONG, visualisations="")
        done = subprocess.run(["unshare", "--mount", "sh", "-c", script, "sh", disk, "swarmanoid", "run", world, "--quiet",
                               "--bag", "run.bag", "--hashes", "hashes.txt"], timeout=120, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, encoding="utf-8", check=False)
        if done.returncode in (1, 77):
            self.skipTest("cannot mount a file system: " + done.stderr)
        self.assertEqual(done.returncode, STOPPED, done.stderr)
        self.assertIn(FULL, done.stderr)
        recorded = self.ticks_in(self.folder / "run.bag")
        self.assertEqual(recorded, list(range(len(recorded))))
        self.assertGreater(len(recorded), 100)


if __name__ == "__main__":
    unittest.main(argv=[pathlib.Path(__file__).name, "-v"])
