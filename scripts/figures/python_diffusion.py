"""Diffusion of footbots in Python, for all robots at once and for one robot at a time: exactly the computation of the C++
controller `diffusion`, so that runs are equal, bit for bit."""

import math

import numpy

ANGLES = [(i if i <= 12 else i - 24) * (2 * math.pi / 24) for i in range(24)]   # of the proximity sensors, from ahead
AHEAD = numpy.flatnonzero(numpy.abs(ANGLES) <= 1.5)
COSINES = numpy.array([math.cos(ANGLES[i]) for i in AHEAD])[:, None]
SINES = numpy.array([math.sin(ANGLES[i]) for i in AHEAD])[:, None]
THRESHOLD, TURN_RATE = 0.05, 1.5         # of the obstacle vector; rad/s
RADIUS, SEPARATION = 0.029, 0.140        # of the wheels [m]


def experiment(robots, area=1.6):
    """Footbots at random places in a square arena with walls. @param area of the floor per robot [m2]"""
    side = math.sqrt(robots * area)
    return f"""<ahss-config><framework><clocktick>100</clocktick><maxclock>1000000000</maxclock></framework><controllers>
      <diffusion id="dc" library="diffusion"><actuators><footbot_wheels/></actuators><sensors><footbot_proximity/></sensors>
      <parameters><speed>0.05</speed></parameters></diffusion></controllers>
      <arena size="{side:.6f},{side:.6f},1" optimization="2D" bounded="true"><distribute quantity="{robots}" layout="uniform">
      <minimum>0.15,0.15,0</minimum><maximum>{side - 0.15:.6f},{side - 0.15:.6f},0</maximum><max_trials>100000</max_trials>
      <footbot id="fb"><controller>dc</controller></footbot></distribute></arena>
      <engines><kinematics2d id="ground"/></engines>
      <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics></ahss-config>"""


class AtOnce:
    """Controller of all robots. Few robots have an obstacle near, and only these need the full computation; the others drive
    straight on."""

    def init(self, parameters):
        self.wheel_speed = float(parameters["speed"]) / RADIUS
        self.turn_rates = numpy.zeros(0)

    def step(self, robots):
        value = robots.readings["footbot_proximity"].value                        # (robots, 24)
        near = numpy.unique(numpy.flatnonzero(value.ravel() != 0) // 24)
        ahead = value[near].T[AHEAD]                                             # (sensors ahead, robots with an obstacle near)
        x, y = (ahead * COSINES).sum(axis=0), (ahead * SINES).sum(axis=0)
        turns = numpy.hypot(x, y) > THRESHOLD
        turning, y = near[turns], y[turns]
        if len(self.turn_rates) != len(robots):
            self.turn_rates = numpy.zeros(len(robots))
        before = self.turn_rates[turning]
        rates = numpy.where(before != 0, before, numpy.where(y > 0, -TURN_RATE, TURN_RATE))
        self.turn_rates = numpy.zeros(len(robots))
        self.turn_rates[turning] = rates
        left = numpy.full(len(robots), self.wheel_speed)
        right = left.copy()
        difference = 0.5 * rates * SEPARATION
        left[turning], right[turning] = (0.0 - difference) / RADIUS, (0.0 + difference) / RADIUS
        wheels = robots.commands["footbot_wheels"]
        wheels.left, wheels.right = left, right


class Alone:
    def init(self, robot, parameters):
        self.speed = float(parameters["speed"])
        self.turn_rate = 0.0
        self.proximity = robot.readings["footbot_proximity"]
        self.wheels = robot.commands["footbot_wheels"]
        self.ahead = [(int(i), float(c), float(s)) for i, c, s in zip(AHEAD, COSINES[:, 0], SINES[:, 0])]

    def step(self, robot):
        value = self.proximity.value
        x = y = 0.0
        if value.any():
            numbers = value.tolist()
            for i, cosine, sine in self.ahead:
                x += numbers[i] * cosine
                y += numbers[i] * sine
        if math.hypot(x, y) > THRESHOLD:
            self.turn_rate = self.turn_rate or (-TURN_RATE if y > 0 else TURN_RATE)
            speed = 0.0
        else:
            self.turn_rate = 0.0
            speed = self.speed
        difference = 0.5 * self.turn_rate * SEPARATION
        self.wheels.left = (speed - difference) / RADIUS
        self.wheels.right = (speed + difference) / RADIUS
