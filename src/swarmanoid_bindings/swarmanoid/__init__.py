"""The simulator of robot swarms in Python, in process and without ROS.

    import swarmanoid

    simulation = swarmanoid.Simulation("diffusion", seed=3)
    simulation.tick(100)
    print(simulation.robots.poses[:, :2])                             # (robots, 2), in metres
    print(simulation.robots.readings["footbot_proximity"].value)      # (robots, 24)

docs/how-to/analyse_trajectories.md shows what `load` makes of recorded runs, docs/how-to/simulate_in_python.md controllers in Python. Simulations of different threads run at the same time."""

from ._core import (Devices, ExperimentError, FieldArrays, ListArrays, Robots, Simulation, SteppedRobots,
                    installed_experiments)

from .recording import RecordedEvent, RecordedReadings, Recording, RecordingError, load

__all__ = ["Devices", "ExperimentError", "FieldArrays", "ListArrays", "RecordedEvent", "RecordedReadings", "Recording",
           "RecordingError", "Robots", "Simulation", "SteppedRobots", "installed_experiments", "load"]
