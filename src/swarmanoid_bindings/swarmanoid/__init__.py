"""The simulator of robot swarms in Python, in process and without ROS.

>>> import swarmanoid
>>> simulation = swarmanoid.Simulation("diffusion", seed=3)
>>> simulation.tick(100)
100
>>> simulation.robots.poses[:, :2].shape                             # x, y of each robot, in metres
(100, 2)
>>> simulation.robots.readings["footbot_proximity"].value.shape      # 24 sensors each
(100, 24)
>>> simulation.apply(swarmanoid.Move("fb_1", (90, 3, 0)))
Traceback (most recent call last):
swarmanoid.InterventionError: move is refused: position: found '90, 3, 0', allowed: in the arena, from 0, 0, 0 to 12.65, 12.65, 1

docs/tutorial/swarm_in_python.md is an introduction, docs/how-to/simulate_in_python.md shows controllers, interventions and
rules, docs/how-to/record_and_analyse.md shows how to `load` recorded runs. Simulations in different threads run in parallel."""

from ._core import (Answer, Delete, Devices, Disc, ErrorModel, ExperimentError, FieldArrays, HandOver, InterventionError,
                    ListArrays, Move, Paint, Pictures, Robots, RuleError, SetCommandSource, SetEngineParameters, SetFault, SetProperty, Simulation,
                    Snapshot, Spawn, SteppedRobots, World, Worlds, fields_of, installed_experiments)

from ._single import Robot
from .recording import RecordedEvent, RecordedReadings, Recording, RecordingError, load

__all__ = ["Answer", "Delete", "Devices", "Disc", "ErrorModel", "ExperimentError", "FieldArrays", "HandOver",
           "InterventionError", "ListArrays", "Move", "Paint", "Pictures", "RecordedEvent", "RecordedReadings", "Recording",
           "RecordingError", "Robots", "RuleError", "SetCommandSource", "SetEngineParameters", "SetFault", "SetProperty",
           "Simulation", "Snapshot", "Spawn", "SteppedRobots", "World", "Worlds", "fields_of", "installed_experiments", "load", "Robot"]

for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__   # the public module, for users and pickle
del _name
