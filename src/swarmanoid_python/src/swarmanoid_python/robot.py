"""What a controller sees of its robot."""


class Robot:
    """`sensors` and `actuators` by type, each with the fields of the device's struct in swarmanoid_interface/devices/ as
    attributes, and a list of their values: sensors["footbot_proximity"].value has 24 numbers, actuators["footbot_wheels"].left one.
    What is written to an actuator stays until it is changed. Device objects stay the same from tick to tick.

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
