"""A process that commands robots of a space in lockstep."""

import threading

import rospy
from swarmanoid_msgs.msg import CommandFrame, SensorFrame
from swarmanoid_msgs.srv import Register

from .frames import Hosted


class Participant:
    """Registers with a space and answers each sensor frame with the commands of its robots. The space waits for each
    answer, so runs do not depend on computation time.

        class Patrol:
            def __init__(self, robot): ...
            def step(self, time, dt): ...          # simulated seconds; reads robot.sensors, writes robot.actuators

        rospy.init_node("patrol")
        Participant(["fb_1", "fb_2"], Patrol).run()

    An exception in a controller stops its robot, not the others. A reset creates new controllers.
    """

    def __init__(self, robots, make_controller, space="/space", name=None, timeout=0.0, policy=""):
        """@param robots names of the robots; @param make_controller called with a Robot; @param name of the participant,
        by default the node's; @param timeout of each answer [s]; @param policy for late answers ("wait", "skip", "stop").
        The defaults of timeout and policy are the space's settings.
        @raise RuntimeError with the reason if the space rejects the registration"""
        self._name = name or rospy.get_name().lstrip("/")
        self._robots = list(robots)
        self._space = space
        rospy.wait_for_service(space + "/register")
        register = rospy.ServiceProxy(space + "/register", Register)
        registration = register(participant=self._name, robots=self._robots, timeout=timeout, policy=policy)
        if not registration.success:
            raise RuntimeError(registration.message)
        self._session = registration.session
        self._run = registration.run
        self._seed = registration.seed
        self._hosted = [Hosted(robot, make_controller) for robot in registration.robots]
        self._answered = None
        self._over = threading.Event()

    def run(self):
        """Answers until the space ends or the node is shut down."""
        topics = f"{self._space}/participants/{self._name}"
        commands = rospy.Publisher(topics + "/commands", CommandFrame, queue_size=1, latch=True, tcp_nodelay=True)
        sensors = rospy.Subscriber(topics + "/sensors", SensorFrame, self._answer, commands, queue_size=1,
                                   tcp_nodelay=True)
        was_there = False
        while not rospy.is_shutdown() and not self._over.wait(0.1):
            is_there = sensors.get_num_connections() > 0
            if was_there and not is_there:
                rospy.loginfo("%s is gone", self._space)
                break
            was_there = is_there
        sensors.unregister()
        commands.unregister()

    def _answer(self, frame, commands):
        if frame.session != self._session:
            return  # latched, for an earlier participant of the same name
        stamp = (frame.run, frame.tick)
        if self._answered is None or self._answered[0] != stamp:
            self._answered = (stamp, self._commands(frame))
        commands.publish(session=frame.session, run=frame.run, tick=frame.tick, data=self._answered[1])

    def _commands(self, frame):
        if (frame.run, frame.seed) != (self._run, self._seed):
            self._run, self._seed = frame.run, frame.seed
            for hosted in self._hosted:
                hosted.drop()
        data, position = b"", 0
        for hosted in self._hosted:
            part, position = hosted.answer(frame.data, position, frame.seed, frame.stamp.to_sec(),
                                           frame.clocktick.to_sec())
            data += part
        return data
