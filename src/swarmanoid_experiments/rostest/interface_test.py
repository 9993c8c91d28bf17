#!/usr/bin/python3
"""A launched experiment offers exactly the interface of docs/reference/ros_interface.md."""

import pathlib
import re
import sys
import unittest
import xmlrpc.client

import rosbag
import rosgraph
import roslaunch.arg_dump
import roslaunch.config
import rospkg
import rospy
import rosservice
import rostest
from visualization_msgs.msg import Marker, MarkerArray

from space_client import Space

REPOSITORY = pathlib.Path(rospkg.RosPack().get_path("swarmanoid_experiments")).parents[1]
PAGE = (REPOSITORY / "docs/reference/ros_interface.md").read_text()
ROBOTS = {"<footbot>": ("fb_1", "fb_2", "fb_3"), "<eyebot>": ("eb",), "<robot>": ("fb_1", "fb_2", "fb_3", "eb")}
# of devices that this experiment does not use; turret_test.py, climbing_test.py and tests of messages cover them
ELSEWHERE = ("/turret/state", "/joint_states", "/hands/state", "/rope/state", "/magnet/state", "/turret/command",
             "/arms/command", "/hands/command", "/rope/command", "/magnet/command",
             "<eyebot>/leds/command", "/front_camera/blobs", "/omnidirectional_camera/blobs", "/pan_tilt_camera/blobs",
             "<handbot>/camera/blobs", "/pan_tilt_camera/command", "/altitude", "/pressure", "/flight/command",
             "/command/pose")


def section(title):
    return PAGE.split("\n## " + title + "\n")[1].split("\n## ")[0]


def named_in(title):
    """Returns names and types of a table whose rows start with them, with the robots in place of placeholders."""
    found = {}
    for name, kind in re.findall(r"^\| `(/\S+)` \| `(\S+)` \|", section(title), re.M):
        if name.endswith(ELSEWHERE):
            continue
        for placeholder, robots in ROBOTS.items():
            if placeholder in name:
                found.update({name.replace(placeholder, robot): kind for robot in robots})
                break
        else:
            found[name] = kind
    return found


class InterfaceTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        Space()  # everything is available once the services are
        publishers, subscribers, services = rosgraph.Master("/interface_test").getSystemState()
        self.publishers = {topic: nodes for topic, nodes in publishers if not topic.startswith("/rosout")}
        self.commands = [topic for topic, nodes in subscribers
                         if "/swarmanoid" in nodes and topic.startswith(("/fb_", "/eb/"))]
        self.services = [name for name, _ in services if "logger" not in name and "/interface" not in name]

    def test_topics_are_those_of_the_page(self):
        types = dict(rosgraph.Master("/interface_test").getTopicTypes())
        self.assertEqual(named_in("Topics published"), {topic: types[topic] for topic in self.publishers})

    def test_commands_are_those_of_the_page(self):
        types = dict(rosgraph.Master("/interface_test").getTopicTypes())
        self.assertEqual(named_in("Topics subscribed"), {topic: types[topic] for topic in self.commands})

    def test_services_are_those_of_the_page(self):
        self.assertEqual(named_in("Services"), {name: rosservice.get_service_type(name)
                                    for name in self.services if not name.startswith("/rosout")})

    def test_engines_show_what_they_work_with(self):
        markers = {m.ns: m for m in rospy.wait_for_message("/space/engine_markers", MarkerArray, timeout=10).markers}
        self.assertEqual({f"engines/{engine}/{kind}" for engine in ("ground", "sky")
                          for kind in ("shapes", "contacts", "joints", "forces")}, set(markers))
        self.assertGreater(len(markers["engines/ground/shapes"].points), 100)
        self.assertEqual(Marker.DELETE, markers["engines/sky/joints"].action)

    def test_devices_show_what_they_do(self):
        markers = rospy.wait_for_message("/space/device_markers", MarkerArray, timeout=10).markers
        found = {(m.ns, m.id): m for m in markers}
        self.assertEqual(len(markers), len(found))
        rays = found["devices/footbot_proximity", 0]
        self.assertEqual((Marker.LINE_LIST, "world"), (rays.type, rays.header.frame_id))
        self.assertEqual([2 * 24 * len(ROBOTS["<footbot>"])] * 2, [len(rays.points), len(rays.colors)])
        self.assertIn(("devices/eyebot_camera", 0), found)
        self.assertNotIn("devices/footbot_wheels", {m.ns for m in markers})

    def test_the_manager_publishes_everything(self):
        for topic, nodes in self.publishers.items():
            self.assertEqual(["/swarmanoid"], nodes, topic)

    def test_each_controller_runs_in_its_own_nodelet(self):
        master = rosgraph.Master("/interface_test")
        _, _, pid = xmlrpc.client.ServerProxy(master.lookupNode("/swarmanoid")).getPid("/interface_test")
        with open(f"/proc/{pid}/maps") as maps:
            loaded = maps.read()
        for controller in ("footbot_retrieval", "eyebot_retrieval"):
            self.assertIn(f"lib{controller}_nodelet.so", loaded)

    def test_parameters_are_those_of_the_page(self):
        source = (REPOSITORY / "src/swarmanoid_ros/src/space/space_options.cpp").read_text()
        read = re.findall(r'reader\.\w+\("([a-z_/]+)"', source)
        self.assertEqual(sorted(set(read)), sorted(re.findall(r"^\| `([a-z_/]+)` \|", section("Parameters of the space"), re.M)))

    def test_launch_arguments_are_those_of_the_page(self):
        first, second = section("Launch arguments").split("`launch/play_bag.launch`")
        for name, text in (("run", first), ("play_bag", second.split(".\n")[0])):
            file = str(REPOSITORY / f"launch/{name}.launch")
            written = set(re.findall(r"`([a-z_]+)`", text)) - {"stay", "none"}   # values
            self.assertEqual(set(roslaunch.arg_dump.get_args([file])), written)
        written = section("Lockstep").split("`launch/robot.launch` starts a participant: ")[1].split(".\n")[0].split(". ")[0]
        self.assertEqual(set(roslaunch.arg_dump.get_args([str(REPOSITORY / "launch/robot.launch")])),
                         set(re.findall(r"`([a-z_]+)`", written)))

    def test_launch_arguments_of_a_robot_in_the_simulator_are_those_of_its_page(self):
        page = (REPOSITORY / "docs/reference/drivers.md").read_text().split("\n## A robot in the simulator\n")[1]
        written = page.split("Its arguments are ")[1].split(". ")[0]
        self.assertEqual(set(roslaunch.arg_dump.get_args([str(REPOSITORY / "launch/mock_robot.launch")])),
                         set(re.findall(r"`([a-z_]+)`", written)))

    def test_launch_files_load_and_explain_their_arguments(self):
        folder = str(REPOSITORY / "launch") + "/"
        bag = pathlib.Path(rospkg.get_ros_home(), "interface_test.bag")
        rosbag.Bag(str(bag), "w").close()
        self.addCleanup(bag.unlink)
        for name, arguments in (("run", ["rviz:=true"]), ("run", ["rviz:=false"]), ("object_retrieval", []),
                                ("play_bag", [f"bag:={bag}", "loop:=true"]),
                                ("robot", ["robot:=fb_1 fb_2", "controller:=footbot_retrieval"]),
                                ("mock_robot", ["robot:=fb_1", "type:=footbot"])):
            config = roslaunch.config.load_config_default([(folder + name + ".launch", arguments)], None)
            self.assertEqual([], config.config_errors)
        for name in ("run", "play_bag", "robot", "mock_robot"):
            for argument, (doc, _) in roslaunch.arg_dump.get_args([folder + name + ".launch"]).items():
                self.assertTrue(doc, f"{name}.launch: {argument} has no doc")

    def test_parameters_for_time_and_robots(self):
        self.assertTrue(rospy.get_param("/use_sim_time"))
        for robot in ("footbot", "eyebot", "handbot"):
            self.assertIn("<robot", rospy.get_param("/" + robot + "/robot_description"))


if __name__ == "__main__":
    rospy.init_node("interface_test", anonymous=True)
    rostest.rosrun("swarmanoid_experiments", "interface", InterfaceTest, sys.argv)
