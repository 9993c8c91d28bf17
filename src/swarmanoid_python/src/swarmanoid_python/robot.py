"""A robot as its controller sees it."""


class Robot:
    """`sensors` and `actuators` have the devices by type. Fields have the names of the device's struct in
    swarmanoid_interface/devices/:

        robot.sensors.footbot_proximity.value[3]           # also robot.sensors["footbot_proximity"]
        robot.actuators.footbot_wheels.left = 2.0

    Units are SI and radians; docs/reference/devices.md and `swarmanoid list` have unit, range and meaning of each field.
    `print(robot.sensors)` lists the devices, and `print` of a device its fields and their values. An unknown name is an
    error that lists the known ones. `help("swarmanoid_python.device")` has more.

    Devices are the same objects in each tick: readings are replaced in place before each step, and commands stay until
    they are changed.

    Other attributes: name, type ("footbot"), parameters (strings by name, as in the experiment file; nested ones as
    outer/inner), seed.
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
        """Sets a named debug value, shown in rviz, on topics and in tables."""
        self.debug_values[str(key)] = str(value)
