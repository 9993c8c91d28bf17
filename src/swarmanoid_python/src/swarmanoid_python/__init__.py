"""Controllers in Python, in lockstep with a space: see Participant."""

from .participant import Participant
from .robot import Robot

__all__ = ["Participant", "Robot"]
