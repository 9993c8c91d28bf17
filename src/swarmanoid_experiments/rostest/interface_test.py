#!/usr/bin/python3
"""Topics, services and types of a launched experiment: users' tools are written against them."""

import sys
import unittest
import xmlrpc.client

import rosgraph
import roslaunch.arg_dump
import roslaunch.config
import rospkg
import rospy
import rosservice
import rostest

from space_client import Space

TOPICS = {
    "/clock": "rosgraph_msgs/Clock",
    "/tf": "tf2_msgs/TFMessage",
    "/tf_static": "tf2_msgs/TFMessage",
    "/diagnostics": "diagnostic_msgs/DiagnosticArray",
    "/space/world_state": "swarmanoid_msgs/WorldState",
    "/space/performance": "swarmanoid_msgs/Performance",
    "/space/events": "swarmanoid_msgs/Event",
    "/space/markers": "visualization_msgs/MarkerArray",
    "/space/markers_static": "visualization_msgs/MarkerArray",
    "/space/result": "swarmanoid_msgs/RunResult",
    "/eb/camera/blobs": "swarmanoid_msgs/ColorBlobs",
    "/eb/leds/state": "swarmanoid_msgs/LedArray",
}
for robot in ("/fb_1", "/fb_2", "/fb_3"):
    TOPICS[robot + "/proximity"] = "swarmanoid_msgs/ProximityArray"
    TOPICS[robot + "/camera/blobs"] = "swarmanoid_msgs/ColorBlobs"
    TOPICS[robot + "/gripper/state"] = "swarmanoid_msgs/GripperState"
    TOPICS[robot + "/leds/state"] = "swarmanoid_msgs/LedArray"

SERVICES = {
    "/space/pause": "std_srvs/Trigger",
    "/space/resume": "std_srvs/Trigger",
    "/space/toggle_pause": "std_srvs/Trigger",
    "/space/step": "swarmanoid_msgs/Step",
    "/space/reset": "swarmanoid_msgs/Reset",
    "/space/spawn": "swarmanoid_msgs/Spawn",
    "/space/delete": "swarmanoid_msgs/Delete",
    "/space/move": "swarmanoid_msgs/Move",
    "/swarmanoid/list": "nodelet/NodeletList",
    "/swarmanoid/load_nodelet": "nodelet/NodeletLoad",
    "/swarmanoid/unload_nodelet": "nodelet/NodeletUnload",
}


class InterfaceTest(unittest.TestCase):
    def setUp(self):
        Space()  # all is there once the services are
        publishers, _, services = rosgraph.Master("/interface_test").getSystemState()
        self.publishers = {topic: nodes for topic, nodes in publishers if not topic.startswith("/rosout")}
        self.services = [name for name, _ in services if "logger" not in name and "/interface" not in name]

    def test_topics_are_the_pinned_ones(self):
        types = dict(rosgraph.Master("/interface_test").getTopicTypes())
        self.assertEqual(TOPICS, {topic: types[topic] for topic in self.publishers})

    def test_services_are_the_pinned_ones(self):
        self.assertEqual(SERVICES, {name: rosservice.get_service_type(name)
                                    for name in self.services if not name.startswith("/rosout")})

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

    def test_launch_files_load_and_explain_their_arguments(self):
        folder = rospkg.RosPack().get_path("swarmanoid_experiments") + "/../../launch/"
        for name, arguments in (("object_retrieval", ["rviz:=true"]), ("object_retrieval", ["rviz:=false"]),
                                ("play_bag", ["bag:=/tmp/run.bag", "loop:=true"])):
            config = roslaunch.config.load_config_default([(folder + name + ".launch", arguments)], None)
            self.assertEqual([], config.config_errors)
        for name in ("object_retrieval", "play_bag"):
            for argument, (doc, _) in roslaunch.arg_dump.get_args([folder + name + ".launch"]).items():
                self.assertTrue(doc, f"{name}.launch: {argument} has no doc")

    def test_parameters_for_time_and_robots(self):
        self.assertTrue(rospy.get_param("/use_sim_time"))
        for robot in ("footbot", "eyebot", "handbot"):
            self.assertIn("<robot", rospy.get_param("/" + robot + "/robot_description"))


if __name__ == "__main__":
    rospy.init_node("interface_test", anonymous=True)
    rostest.rosrun("swarmanoid_experiments", "interface", InterfaceTest, sys.argv)
