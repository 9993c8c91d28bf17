"""Crowds pressed into a corner: cost of a tick against that of robots apart, and overlap of bodies."""

import math
import sys
import time
from typing import NamedTuple

import numpy
import swarmanoid
from footbot_bodies import axes_of, depths, reach

CENTRE = 0.078        # of a footbot's body, above the ground [m]
NEAR = 0.22           # robots that are farther apart do not touch, however they lean [m]
SECONDS = 35.0        # in which the crowd forms
MEASURED = 40         # ticks at the end
SAMPLES = 50          # of the overlap
FASTEST = 8.0         # of wheels [rad/s]
ROBOTS = (20, 150, 1000)
ALLOWED_FACTOR, ALLOWED_MS = 5.0, 0.1  # of the free tick, and a robot


class Case(NamedTuple):
    engine: str
    steps: int
    tick_ms: int
    overlap: float    # that is promised, with rounding [m]


CASES = (Case("kinematics2d", 1, 100, 1e-8), Case("dynamics2d", 1, 100, 6e-4), Case("dynamics2d", 10, 100, 6e-4),
         Case("dynamics3d", 1, 10, 1.5e-3), Case("dynamics3d", 10, 100, 1.5e-3))


def into_the_corner(robots):
    """Wheels that turn a robot towards the corner at the origin, and press it there."""
    poses = robots.poses
    heading = 2 * numpy.arctan2(poses[:, 5], poses[:, 6])
    astray = (numpy.arctan2(-poses[:, 1], -poses[:, 0]) - heading + math.pi) % (2 * math.pi) - math.pi
    turn = 1.5 * numpy.clip(astray, -1, 1)
    wheels = robots.commands["footbot_wheels"]
    wheels.left, wheels.right = FASTEST * (1 - turn), FASTEST * (1 + turn)


def simulation(case, robots, side):
    """Robots on a square lattice in a room."""
    per_line = math.ceil(math.sqrt(robots))
    step = (side - 0.4) / per_line
    placed = "".join(
        f"<footbot id='fb_{i}'><position>{0.2 + step * (i % per_line + 0.5)},{0.2 + step * (i // per_line + 0.5)},0</position>"
        f"<orientation>0,0,{37 * i % 360}</orientation><controller>c</controller></footbot>" for i in range(robots))
    members = "".join(f"<entity id='fb_{i}'/>" for i in range(robots))
    text = (f"<ahss-config><framework><clocktick>{case.tick_ms}</clocktick><maxclock>1000000</maxclock></framework><controllers>"
            "<diffusion id='c' library='diffusion'><actuators><footbot_wheels/></actuators><sensors/></diffusion></controllers>"
            f"<arena size='{side},{side},1' optimization='{'3D' if case.engine == 'dynamics3d' else '2D'}' bounded='true'>{placed}</arena>"
            f"<engines><{case.engine} id='g'><subclock>{case.steps}</subclock></{case.engine}></engines>"
            f"<arena_physics><engine id='g'>{members}</engine></arena_physics></ahss-config>")
    return swarmanoid.Simulation(text=text, controllers={"c": into_the_corner})


def tick_ms(run):
    """@return mean length of a tick, processor time [ms]"""
    begin = time.process_time()
    run.tick(MEASURED)
    return 1e3 * (time.process_time() - begin) / MEASURED


def overlap_of(run, side):
    """@return largest overlap of the bodies of two robots, or of a robot and a wall [m]; not above 0 without one"""
    poses = run.robots.poses
    axes = axes_of(poses)
    centres = poses[:, :3] + CENTRE * axes
    sideways = numpy.stack([reach(axes, direction) for direction in numpy.eye(3)[:2]], -1)
    deepest = max((sideways - centres[:, :2]).max(), (centres[:, :2] + sideways).max() - side)
    apart = numpy.linalg.norm(centres[:, None] - centres[None], axis=-1)
    first, second = numpy.nonzero(numpy.triu(apart < NEAR, 1))
    line = (centres[second] - centres[first]) / apart[first, second, None]
    along_the_line = reach(axes[first], line) + reach(axes[second], line) - apart[first, second]
    may = along_the_line > deepest  # the shortest way is not longer than that along the line
    first, second = first[may], second[may]
    return max(deepest, depths(centres[first], axes[first], centres[second], axes[second]).max(initial=deepest))


def crowds(table):
    for case in CASES:
        for robots in ROBOTS:
            print(f"{case.engine}, {case.steps} steps, {robots} robots", file=sys.stderr)
            with simulation(case, robots, 2.0 * math.ceil(math.sqrt(robots)) + 0.4) as free:
                free.tick(10)
                free_ms = tick_ms(free)
            side = max(4.0, 0.6 + 0.32 * math.sqrt(robots))
            overlap = 0.0
            with simulation(case, robots, side) as pressed:
                ticks = round(1e3 * SECONDS / case.tick_ms)
                for _ in range(SAMPLES):
                    pressed.tick(ticks // SAMPLES)
                    overlap = max(overlap, overlap_of(pressed, side))
                pressed_ms = tick_ms(pressed)
            allowed = ALLOWED_FACTOR * free_ms + ALLOWED_MS * robots
            table.add(f"{robots:,} footbots press into a corner for {SECONDS:.0f} s, {case.engine}, ticks of {case.tick_ms} ms, steps a tick {case.steps}",
                      f"overlap at most {1e3 * case.overlap:g} mm; a tick within {ALLOWED_FACTOR:.0f} free ones and {ALLOWED_MS} ms a robot",
                      f"{1e3 * max(overlap, 0.0):.2f} mm; {pressed_ms:.2f} ms of {allowed:.2f} (free {free_ms:.2f})",
                      overlap <= case.overlap and pressed_ms <= allowed)
