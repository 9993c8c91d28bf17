#!/usr/bin/python3
"""Behaviour of roslaunch: bad arguments are rejected before any node starts, results are reported, files are written to
the right folders, and Ctrl-C leaves a complete bag; and exit codes of `swarmanoid launch`."""

import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

import rosbag

from roslaunch_process import LAUNCH_FOLDER, TIMEOUT, RoslaunchTest

LAUNCH_FILE = LAUNCH_FOLDER / "run.launch"
FAILING = LAUNCH_FOLDER.parent / "src/swarmanoid_experiments/test/data/failing_controller.xml"
QUICK = ("rviz:=false", "real_time_factor:=0")
ALARM = "REQUIRED process"


def address_for_others():
    """Returns an address of this machine that others can reach; the test is skipped if there is none."""
    addresses = subprocess.check_output(["hostname", "-I"], universal_newlines=True).split()
    addresses = [address for address in addresses if "." in address]
    if not addresses:
        raise unittest.SkipTest("this machine has no address but those of the loopback")
    return addresses[0]


class LaunchTest(RoslaunchTest):
    launch_file = LAUNCH_FILE

    def launch(self, *arguments, **more):
        return super().launch("rviz:=false", *arguments, **more)

    def code_of(self, *arguments):
        """Returns exit code and output of `swarmanoid launch`."""
        return self.end_of(self.start("swarmanoid", "launch", *arguments))

    def test_a_bad_experiment_is_refused_before_anything_starts(self):
        for argument, reason in (("experiment:=object_retrievl", "did you mean 'object_retrieval'?"),
                                 ("experiment:=/nowhere/run.xml", "/nowhere/run.xml"),
                                 ("seed:=one", "one"),
                                 ("set:=framework.maxclok=3", "did you mean 'maxclock'?"),
                                 ("real_time_factor:=fast", "fast")):
            code, output = self.output_of(argument)
            self.assertNotEqual(0, code, output)
            self.assertIn(reason, output)
            self.assertNotIn("process[", output, "something was started")

    def test_what_only_the_space_can_tell_ends_the_launch(self):
        for argument, reason in (("device_topics:=fb_9", "~device_topics: found 'fb_9', allowed: all, none, fb_1"),
                                 ("tf_level:=most", "~tf/level: found 'most', allowed: auto, none, base, full"),
                                 ("record:=/nowhere/run.bag", "cannot write")):
            _, output = self.output_of(argument)
            self.assertIn(reason, output)
            self.assertRegex(output, r"process has died|exit code [1-9]", "roslaunch does not report it")

    def test_a_failed_controller_is_in_the_exit_code(self):
        _, output = self.output_of(f"experiment:={FAILING}", "real_time_factor:=0")
        self.assertIn("the controller of fb_2 failed", output)
        self.assertIn("exit code 3", output)

    def test_a_file_is_found_from_where_roslaunch_is_started(self):
        text = (LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text()
        pathlib.Path(self.folder.name, "mine.xml").write_text(text)
        code, output = self.output_of("experiment:=mine.xml", "max_ticks:=10", "real_time_factor:=0")
        self.assertEqual(0, code)
        self.assertIn("mine, seed 1: finished after 10 ticks", output)

    def test_a_run_that_is_over_ends_without_alarm(self):
        code, output = self.output_of("max_ticks:=10", "real_time_factor:=0", "exit_code:=code.txt")
        self.assertEqual(0, code)
        self.assertIn("finished after 10 ticks", output)
        self.assertNotIn(ALARM, output)
        self.assertNotIn("has died", output)
        self.assertNotIn("escalating", output)
        self.assertNotIn("\033[31m", output, "something is red")
        self.assertEqual("0\n", pathlib.Path(self.folder.name, "code.txt").read_text())

    def test_the_former_name_of_the_launch_file_is_another_name_of_it(self):
        code, output = self.output_of("max_ticks:=10", "real_time_factor:=0",
                                      file=LAUNCH_FILE.with_name("object_retrieval.launch"))
        self.assertEqual(0, code)
        self.assertIn("object_retrieval, seed 1: finished after 10 ticks", output)

    def test_the_command_returns_what_the_run_returns(self):
        for code, arguments in ((0, ("object_retrieval", "max_ticks:=10")),
                                (2, ("object_retrievl",)),
                                (2, ("object_retrieval", "paused:=perhaps")),
                                (2, ("object_retrieval", "device_topics:=fb_9")),
                                (2, ("object_retrieval", "record:=/nowhere/run.bag", "on_end:=stay")),
                                (3, (FAILING,)),
                                (4, ("object_retrieval", "record:=/dev/full")),
                                (4, ("object_retrieval", "set:=arena.eb.controller.source=remote",
                                     "lockstep_policy:=stop", "lockstep_join_timeout:=0.2"))):
            with self.subTest(code=code, arguments=arguments):
                found, output = self.code_of(*map(str, arguments), *QUICK)
                self.assertEqual(code, found, output)
                is_refused_before = output.startswith("swarmanoid: object_retrievl: ")  # roslaunch does not even start
                is_without_alarm = code == 0 or "RLException" in output or is_refused_before
                self.assertEqual(is_without_alarm, ALARM not in output, output)
        self.assertEqual([], list(pathlib.Path(self.folder.name).glob("swarmanoid_launch_*")), "it leaves files")

    def test_a_bag_of_a_launched_run_is_made_again_elsewhere_without_ros(self):
        own = pathlib.Path(self.folder.name, "own.xml")
        own.write_text((LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text())
        done = pathlib.Path(self.folder.name, "done.xml")
        done.write_text('<interventions><delete tick="4" entity="fb_1"/></interventions>')
        code, output = self.output_of("experiment:=own.xml", "max_ticks:=12", "seed:=7", "real_time_factor:=0",
                                      "record:=run.bag", "interventions:=done.xml")
        self.assertEqual(0, code, output)
        own.unlink()
        done.unlink()
        with tempfile.TemporaryDirectory() as elsewhere:
            bag = shutil.move(self.folder.name + "/run.bag", elsewhere)
            environment = {name: value for name, value in os.environ.items() if not name.startswith("ROS_MASTER")}
            again = subprocess.run(["swarmanoid", "rerun", bag], cwd=elsewhere, env=environment, universal_newlines=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=TIMEOUT)
        self.assertEqual((0, "each of 12 ticks has the state of the recorded run\n"), (again.returncode, again.stdout),
                         again.stderr)

    def test_the_command_refuses_what_it_says_itself(self):
        code, output = self.code_of("object_retrieval", "exit_code:=mine.txt")
        self.assertEqual(2, code)
        self.assertIn("launch: found 'exit_code:=mine.txt', allowed: arguments of run.launch other than", output)

    def test_the_command_runs_where_others_reach_the_master(self):
        for code, arguments in ((0, ("max_ticks:=10",)), (2, ("device_topics:=fb_9",)), (2, ("force:=true",))):
            with self.subTest(arguments=arguments):
                found, output = self.code_of("object_retrieval", f"hostname:={address_for_others()}", *QUICK, *arguments)
                self.assertEqual(code, found, output)
                self.assertIn("whoever reaches them can run programs as this user", output)
                self.assertNotIn("~exit_code", output)

    def test_a_refused_exit_code_is_not_written(self):
        other = tempfile.NamedTemporaryFile(mode="w+", prefix="swarmanoid_other_")
        self.addCleanup(other.close)
        other.write("130\n")
        other.flush()
        for more in ((), ("device_topics:=fb_9",), ("on_end:=never",)):
            with self.subTest(more=more):
                _, output = self.output_of(f"hostname:={address_for_others()}", f"exit_code:={other.name}", *QUICK[1:], *more)
                self.assertIn(f"~exit_code: found '{other.name}', allowed, as other computers reach the master: files in "
                              f"{self.folder.name}; or allow_remote_files:=true at start", output)
                self.assertEqual("130\n", pathlib.Path(other.name).read_text())

    def test_the_master_of_the_command_listens_where_it_is_to(self):
        address = address_for_others()
        for arguments, is_open in (((), False), ((f"hostname:={address}",), True)):
            with self.subTest(arguments=arguments):
                process = self.start("env", "-u", "ROS_HOSTNAME", "-u", "ROS_IP", "swarmanoid", "launch", "object_retrieval",
                                     "paused:=true", "hashes:=hashes.txt", *QUICK, *arguments)
                port = int(process.args[-1])
                hashes = pathlib.Path(self.folder.name, "hashes.txt")
                until = time.monotonic() + TIMEOUT
                while not hashes.exists() and time.monotonic() < until:
                    time.sleep(0.1)
                with socket.socket() as visitor:
                    is_found_open = visitor.connect_ex((address, port)) == 0
                process.send_signal(signal.SIGINT)
                _, output = self.end_of(process)
                self.assertEqual(is_open, is_found_open, output)
                hashes.unlink()

    def test_a_shell_with_our_setup_keeps_to_this_machine_unless_told(self):
        setup = pathlib.Path(os.environ["CMAKE_PREFIX_PATH"].split(":")[0], "setup.bash")
        for given, expected in (("", "localhost|"), ("ROS_HOSTNAME=simulator", "simulator|"), ("ROS_IP=10.0.0.7", "|10.0.0.7")):
            text = f'unset ROS_HOSTNAME ROS_IP; export {given}; source {setup}; echo "$ROS_HOSTNAME|$ROS_IP"'
            found = subprocess.check_output(["bash", "-c", text], universal_newlines=True)
            self.assertEqual(expected, found.splitlines()[-1])

    def test_an_interrupted_command_ends_its_roslaunch(self):
        for arguments, file, code in ((("max_ticks:=10", "on_end:=stay"), "swarmanoid_launch_*/exit_code", 0),
                                      (("paused:=true", "hashes:=hashes.txt"), "hashes.txt", 130)):
            with self.subTest(arguments=arguments):
                process = self.start("swarmanoid", "launch", "object_retrieval", *QUICK, *arguments)
                until = time.monotonic() + TIMEOUT
                while not list(pathlib.Path(self.folder.name).glob(file)) and time.monotonic() < until:
                    time.sleep(0.1)
                process.send_signal(signal.SIGINT)
                found, output = self.end_of(process)
                self.assertEqual(code, found, output)
                self.assertNotIn(ALARM, output)
                self.assertIn("done", output)

    def test_files_land_where_roslaunch_was_started_or_in_out(self):
        world = LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/experiments/diffusion.xml"
        table = '<visualisations><text_render id="t"><file>table.txt</file></text_render>'
        text = world.read_text()
        self.assertEqual(1, text.count("</ahss-config>"))
        text = text.replace("<visualisations>", table) if "<visualisations>" in text else text.replace(
            "</ahss-config>", table + "</visualisations></ahss-config>")
        here = pathlib.Path(self.folder.name)
        (here / "mine.xml").write_text(text)
        arguments = ("experiment:=mine.xml", "max_ticks:=10", "real_time_factor:=0", "hashes:=hashes.txt",
                     "record:=run.bag")
        for out, folder in ((), here), (("out:=deep/er",), here / "deep/er"), (("out:=deep/er", "force:=true"), here / "deep/er"):
            code, output = self.output_of(*arguments, *out)
            self.assertEqual(0, code, output)
            self.assertIn(f"files go to {folder}", output)
            for name in ("table.txt", "hashes.txt", "run.bag"):
                self.assertTrue((folder / name).exists(), f"{name} is not in {folder}")

    def test_no_file_is_replaced_and_none_is_written_elsewhere(self):
        here = pathlib.Path(self.folder.name)
        for name in ("run.bag", "hashes.txt"):
            (here / name).write_text("mine")
        for argument, file in (("record", "run.bag"), ("hashes", "hashes.txt")):
            _, output = self.output_of(f"{argument}:={file}", *QUICK[1:])
            self.assertIn(f"~{argument}: found '{file}', which is there already, allowed: another name, or ~force to replace it",
                          output)
            self.assertEqual((here / file).read_text(), "mine")
        world = (LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text()
        table = '<visualisations><text_render id="t"><file>../table.txt</file></text_render></visualisations>'
        (here / "mine.xml").write_text(world.replace("</ahss-config>", table + "</ahss-config>"))
        _, output = self.output_of("experiment:=mine.xml", "out:=out", *QUICK[1:])
        self.assertIn(f"text_render 't': file: found '../table.txt', allowed: a file in {here}/out, or ~write_anywhere", output)
        self.assertFalse((here / "out").exists())
        code, output = self.output_of("experiment:=mine.xml", "out:=out", "write_anywhere:=true", "max_ticks:=3", *QUICK[1:])
        self.assertEqual(0, code, output)
        self.assertTrue((here / "table.txt").exists())

    def test_the_exit_code_replaces_an_exit_code_only(self):
        world = (LAUNCH_FILE.parents[1] / "src/swarmanoid_experiments/experiments/diffusion.xml").read_text()
        here = pathlib.Path(self.folder.name)
        (here / "mine.xml").write_text(world)
        (here / "code.txt").write_text("130\n")
        for file, expected in (("mine.xml", world), ("code.txt", "0\n")):
            _, output = self.output_of("experiment:=mine.xml", "max_ticks:=3", *QUICK[1:], f"exit_code:={file}")
            self.assertEqual(expected, (here / file).read_text())
            self.assertEqual(file == "mine.xml", f"~exit_code: found '{here / file}', which is there and holds no exit code, "
                             "allowed: another name" in output, output)

    def test_out_is_taken_away_again_if_nothing_starts(self):
        _, output = self.output_of("out:=new", "record:=nowhere/run.bag")
        self.assertIn("cannot write", output)
        self.assertFalse(pathlib.Path(self.folder.name, "new").exists())
        _, output = self.output_of("out:=/dev/null/x")
        self.assertIn("~out: cannot make the folder '/dev/null/x': Not a directory", output)

    def test_values_of_set_may_hold_blanks_and_commas(self):
        code, output = self.output_of("set:=arena.size=6, 6, 3 framework.maxclock=7 arena.eb.position=2, 3, 2",
                                      "real_time_factor:=0")
        self.assertEqual(0, code)
        self.assertIn("finished after 7 ticks", output)
        for bad, reason in (("set:=arena.size=6, 6", "found '6, 6'"), ("set:=it's", "found 'it's', allowed: path=value")):
            code, output = self.output_of(bad)
            self.assertEqual(1, code)
            self.assertIn(reason, output)
            self.assertNotIn("process[", output, "something was started")

    def start_recording(self, *arguments):
        """@return the process, after it has recorded some data; bag; hashes"""
        bag = pathlib.Path(self.folder.name, "run.bag")
        hashes = pathlib.Path(self.folder.name, "hashes.txt")
        process = self.launch(f"record:={bag}", f"hashes:={hashes}", "real_time_factor:=5", *arguments)
        until = time.monotonic() + TIMEOUT
        while (not bag.exists() or bag.stat().st_size < 10**5) and time.monotonic() < until:
            time.sleep(0.1)
        return process, bag, hashes

    def test_an_interrupt_leaves_a_complete_bag(self):
        process, bag, hashes = self.start_recording()
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=TIMEOUT)
        self.assert_complete(bag, hashes, output)

    def test_signals_to_the_manager_leave_a_complete_bag_and_the_result(self):
        for number in (signal.SIGTERM, signal.SIGHUP):
            process, bag, hashes = self.start_recording("force:=true", "exit_code:=code.txt")
            os.kill(self.manager_of(process.pid), number)
            output, _ = process.communicate(timeout=TIMEOUT)
            self.assertRegex(output, r"object_retrieval, seed 1: stopped after \d+ ticks in .* \(shut down\)")
            self.assertEqual("130\n", pathlib.Path(self.folder.name, "code.txt").read_text())
            self.assert_complete(bag, hashes, output)
            bag.unlink()

    def manager_of(self, roslaunch):
        """Returns the process of the nodelet manager that this roslaunch started."""
        for folder in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
                words = (folder / "cmdline").read_bytes().split(b"\0")
            except OSError:  # it has ended
                continue
            if parent == roslaunch and b"manager" in words:
                return int(folder.name)
        self.fail("there is no manager")

    def assert_complete(self, bag, hashes, output):
        last = int(hashes.read_text().splitlines()[-1].split()[0])
        self.assertGreater(last, 0, output)
        with rosbag.Bag(str(bag)) as reader:  # throws if the bag is not indexed
            states = [(m.tick, m.header.stamp) for _, m, _ in reader.read_messages("/space/world_state")]
            moving = [m.transforms[0].header.stamp for _, m, _ in reader.read_messages("/tf")]
        self.assertEqual(list(range(last + 1)), [tick for tick, _ in states])
        self.assertEqual([stamp for _, stamp in states], moving)


if __name__ == "__main__":
    unittest.main()
