"""Makes valid, nearly valid and arbitrary requests for the services of a space."""

from geometry_msgs.msg import Point, PoseStamped
from std_msgs.msg import ColorRGBA
from std_srvs.srv import Trigger
from swarmanoid_msgs.msg import DeviceError, EntityPose, EntitySpecification, TextParameter
from swarmanoid_msgs.srv import (Delete, Handover, Inspect, Move, PaintFloor, Register, Reset, SetCommandSource, SetFault, SetProperty,
                                 SetRealTimeFactor, Spawn, Step)

NUMBERS = [float("nan"), float("inf"), float("-inf"), 1e308, -1e308, 1e40, 1e12, 1e9, 1e6, 1e4, 100.0, 1e-9, 1e-40, 5e-324, 0.0, -0.0, -1.0]
NAMES = ["", " ", "a/b", "/a", "1", "world", "space", "é", "a" * 10000, "a.b", "\x00", "%s%n", "../x", "fb_1", "eb", "hb", "prey"]
TYPES = ["footbot", "eyebot", "handbot", "block", "cylindric_prey", "light", "heightfield", "distribute", "box", ""]
SENSIBLE = {"footbot": {}, "eyebot": {}, "cylindric_prey": {"radius": "0.05", "height": "0.1"}, "block": {"size": "0.1, 0.2, 0.1"}}
PARAMETERS = {"radius": ["0.1", "1e-6", "1e6", "nan", "-1", "x"], "height": ["0.1", "1e6", "0"], "mass": ["0.3", "0", "1e6", "-1"],
              "size": ["1, 1, 1", "1e-9,1,1", "1e6,1e6,1e6", "1,1"], "color": ["red", "999,0,0"], "nothing": ["1"]}
SOURCES = ["controller", "remote", "topics", "none", "nobody", ""]


class Requests:
    """Keeps the names of spawned entities, so that later requests can use them."""

    def __init__(self, random, engines, entities, controllers):
        self._random, self._engines, self._controllers = random, engines, controllers
        self._entities, self._count = list(entities), 0

    def make(self):
        """@return name of a service, its type, its request"""
        ways = [self._spawn] * 6 + [self._move] * 6 + [self._delete, self._handover, self._handover, self._source, self._source,
                                                       self._property, self._paint, self._fault, self._reset, self._step, self._trigger,
                                                       self._register, self._inspect, self._real_time_factor]
        return self._random.choice(ways)()

    def _number(self, low=0.0, high=4.0):
        return self._random.choice(NUMBERS) if self._random.random() < 0.05 else self._random.uniform(low, high)

    def _name(self):
        return self._random.choice(NAMES if self._random.random() < 0.15 else self._entities)

    def _names(self):
        return [self._name() for _ in range(self._random.choice([0, 1, 1, 1, 2, 5]))]

    def _pose(self):
        pose = PoseStamped()
        pose.header.frame_id = self._random.choice(["world"] * 6 + ["", "map"])
        position, turn = pose.pose.position, pose.pose.orientation
        position.x, position.y = self._number(), self._number()
        position.z = self._random.choice([0.0, 0.0, self._number(0.0, 2.0)])
        turn.w = 1.0
        if self._random.random() < 0.3:
            turn.x, turn.y, turn.z, turn.w = (self._number(-1.0, 1.0) for _ in range(4))
        return pose

    def _spawn(self):
        entities = []
        for _ in range(self._random.choice([0, 1, 1, 1, 3])):
            self._count += 1
            name = f"new_{self._count}" if self._random.random() < 0.8 else self._name()
            self._entities.append(name)
            engines = [self._random.choice(self._engines) for _ in range(self._random.choice([0, 1, 1, 1, 2, 3]))]
            kind = self._random.choice(sorted(SENSIBLE))
            parameters = SENSIBLE[kind]
            if self._random.random() < 0.4:
                kind = self._random.choice(TYPES)
                engines += ["nowhere"] * (self._random.random() < 0.1)
                parameters = {key: self._random.choice(PARAMETERS[key]) for key in self._random.choices(sorted(PARAMETERS), k=2)}
            entities.append(EntitySpecification(
                name=name, type=kind, engines=engines, pose=self._pose(), controller=self._random.choice(self._controllers + [""] * 4),
                parameters=[TextParameter(name=key, value=value) for key, value in parameters.items()],
                color=ColorRGBA(*(self._number(0.0, 1.0) for _ in range(4)))))
        return "spawn", Spawn, {"entities": entities}

    def _move(self):
        return "move", Move, {"entities": [EntityPose(name=name, pose=self._pose()) for name in self._names()]}

    def _delete(self):
        return "delete", Delete, {"names": self._names()}

    def _handover(self):
        return "handover", Handover, {"names": self._names(), "engine": self._random.choice(self._engines + ["", "x"])}

    def _source(self):
        return "set_command_source", SetCommandSource, {"names": self._names(), "source": self._random.choice(SOURCES)}

    def _property(self):
        return "set_property", SetProperty, {"names": self._names(),
                                             "property": self._random.choice(["intensity", "color", "charge", "", "x" * 5000]),
                                             "value": self._random.choice(["0", "1", "nan", "-1", "red", "1,2,3", "300,0,0", ""])}

    def _paint(self):
        return "paint_floor", PaintFloor, {"positions": [Point(*(self._number(-1.0, 6.0) for _ in range(3))) for _ in range(self._random.randint(0, 3))],
                                           "radius": self._number(-0.1, 0.5), "color": self._random.choice(["black", "red", "", "1,2,300"]),
                                           "strength": self._number(-0.1, 1.5)}

    def _fault(self):
        errors = []
        for _ in range(self._random.choice([0, 1, 1, 2])):
            error = DeviceError(kind=self._random.choice(["stuck", "dead", "gaussian", "latency", "", "x" * 5000]))
            error.field = self._random.choice(["", "", "value", "value[3]", "left", "value[999999999999]", "é"])
            error.from_tick = self._random.choice([0, 0, 20, 2**64 - 1])
            for name in self._random.choice([[], ["deviation"], ["ticks"], ["deviation", "deviation"]]):
                error.parameters.append(TextParameter(name, self._random.choice(["0.1", "3", "nan", "-1", "1e9", "10001", ""])))
            errors.append(error)
        return "set_fault", SetFault, {"names": self._names(), "errors": errors,
                                       "device": self._random.choice(["footbot_proximity", "footbot_wheels", "eyebot_camera", "x"])}

    def _reset(self):
        return "reset", Reset, {"scope": self._random.choice([0, 0, 1, 6, 7, 255]), "seed": self._random.choice([0, 1, 2**64 - 1]),
                                "zero_seed": self._random.random() < 0.2}

    def _step(self):
        return "step", Step, {"ticks": self._random.choice([0, 1, 3])}

    def _trigger(self):
        return self._random.choice(["pause", "resume", "toggle_pause"]), Trigger, {}

    def _inspect(self):
        return "inspect", Inspect, {"name": self._random.choice(["", self._name()]), "near": Point(*(self._number(-1.0, 6.0) for _ in range(3))),
                                    "within": self._random.choice([0.0, self._number()])}

    def _real_time_factor(self):
        return "set_real_time_factor", SetRealTimeFactor, {"real_time_factor": self._random.choice([0.0, 0.0, 1e6, 50.0, 1e-6, 1e-9, *NUMBERS])}

    def _register(self):
        return "register", Register, {"participant": self._random.choice(["a", "a", "b", "", "a b", "/a", "a" * 5000]),
                                      "robots": self._names(), "timeout": self._number(-1.0, 5.0),
                                      "policy": self._random.choice(["", "skip", "stop", "x"])}
