"""What a controller sees of its robot."""


class Robot:
    """`sensors` and `actuators` have the devices by type, and those their fields by the names of the device's struct in
    swarmanoid_interface/devices/:

        robot.sensors.footbot_proximity.value[3]           # also robot.sensors["footbot_proximity"]
        robot.actuators.footbot_wheels.left = 2.0

    Units are SI and radians; docs/reference/devices.md, and `swarmanoid list`, say those of each field, with its range and
    meaning. `print(robot.sensors)` has the devices that there are, and `print` of a device its fields and their values; a
    name that does not exist is an error that lists those that do. `help("swarmanoid_python.device")` has more.

    Devices are the same objects in each tick: a reading is replaced in its place before each step, and what is written to
    an actuator stays until it is changed.

    Also: name, type ("footbot"), parameters (texts by name, as in the experiment file; nested ones as outer/inner), seed.
    """

    def __init__(self, name, kind, parameters, seed, sensors, actuators):
        self.name = name
        self.type = kind
        self.parameters = parameters
        self.seed = seed
        self.sensors = sensors
        self.actuators = actuators
        self.debug_values = {}

    def debug(self, key, value):
        """A named value for people: in rviz, on topics and in tables."""
        self.debug_values[str(key)] = str(value)
