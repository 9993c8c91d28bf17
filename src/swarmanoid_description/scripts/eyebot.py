"""The eyebot: a quadrotor whose rotors turn in ducts (thesis 1, figures 1.3 and 3.9)."""
import math

from footbot import ring
from urdf_writer import Robot, box, cylinder, disc, sphere

RADIUS = 0.25  # 50 cm across
HEIGHT = 0.54
MASS = 2.0
LED_COUNT = 16
LED_HEIGHT = 0.2
RANGE_AND_BEARING_HEIGHT = 0.22  # in the hub, over its LEDs
DISTANCE_COUNT = 16  # infrared sensors around the body
DISTANCE_HEIGHT = 0.29  # at half the height of the ducts
LIGHT_COUNT = 24  # light sensors at the same height; same number as the eye-bot of ARGoS
OMNIDIRECTIONAL_CAMERA_HEIGHT = 0.42  # on the mast, over the rotors
PAN_TILT_CAMERA = (0.085, 0, 0.17)  # ahead of the hub, under its LEDs; drawn in its rest position
DUCT_RADIUS = 0.1
DUCT_BOTTOM, DUCT_TOP = 0.24, 0.34
DUCT_WALL = 0.006
ROTOR_RADIUS = 0.092
CONSUMPTION = {"eyebot_camera": 1, "eyebot_laser": 0.1, "range_and_bearing": 0.5, "eyebot_omnidirectional_camera": 1,
               "eyebot_pan_tilt_camera": 1, "eyebot_distance": 0.18, "loudspeaker": 0.2, "wifi": 0.8,
               "bluetooth": 0.1}  # W, docs/reference/battery.md
DUCT_PLATES = 16

MATERIALS = {
    "black": (0.08, 0.08, 0.09, 1),
    "dark_grey": (0.25, 0.26, 0.28, 1),
    "light_grey": (0.78, 0.8, 0.82, 1),
    "green": (0.15, 0.6, 0.3, 1),
    "red": (0.85, 0.1, 0.1, 1),
    "milky": (0.95, 0.95, 1, 0.75),
    "blur": (0.5, 0.55, 0.6, 0.3),
}
DOWN = (0, math.pi / 2, 0)  # the x axis, in which devices look, points straight down
UP = (0, -math.pi / 2, 0)


def duct(azimuth):
    """A ring of upright plates (URDF has no tubes), a motor, a rotor of two blades and the disc it sweeps."""
    x, y = ((RADIUS - DUCT_RADIUS) * f(azimuth) for f in (math.cos, math.sin))
    middle = (DUCT_BOTTOM + DUCT_TOP) / 2
    shapes = []
    width = 2 * DUCT_RADIUS * math.tan(math.pi / DUCT_PLATES)
    for i in range(DUCT_PLATES):
        angle = 2 * math.pi * i / DUCT_PLATES
        reach = DUCT_RADIUS - DUCT_WALL / 2
        place = (x + reach * math.cos(angle), y + reach * math.sin(angle), middle)
        shapes.append(box((DUCT_WALL, width, DUCT_TOP - DUCT_BOTTOM), place, "green", (0, 0, angle)))
    blade = box((0.18, 0.018, 0.003), (x, y, middle + 0.02), "black", (0, 0, azimuth + 0.6))
    return shapes + [disc(0.016, middle - 0.03, middle + 0.025, "black", (x, y)), blade,
                     disc(ROTOR_RADIUS, middle + 0.0185, middle + 0.0215, "blur", (x, y)),
                     box((0.19, 0.012, 0.012), (x, y, middle - 0.03), "dark_grey", (0, 0, azimuth))]


def leg(azimuth):
    """A strut from under the hub outwards to the ground, ending in a foot."""
    tilt = math.atan2(0.08, 0.2)
    middle = (0.14 * math.cos(azimuth), 0.14 * math.sin(azimuth), 0.11)
    foot = (0.18 * math.cos(azimuth), 0.18 * math.sin(azimuth), 0.012)
    return [cylinder(0.006, math.hypot(0.08, 0.2), middle, "light_grey", (0, -tilt, azimuth)),
            sphere(0.012, foot, "black")]


def body_visuals():
    quarters = [i * math.pi / 2 for i in range(4)]
    return [
        *(shape for azimuth in quarters for shape in duct(azimuth + math.pi / 4)),
        *(shape for azimuth in quarters for shape in leg(azimuth)),
        disc(0.07, 0.21, 0.33, "dark_grey"),  # the hub
        disc(0.055, 0.33, 0.36, "light_grey"),
        disc(0.098, 0.19, 0.21, "milky"),  # LEDs
        sphere(0.035, (0, 0, 0.185), "black"),  # camera
        disc(0.008, 0.15, 0.19, "red", (0.05, 0)),  # laser pointer
        disc(0.009, 0.36, 0.51, "light_grey"),  # the mast that ends in the magnet for the ceiling
        disc(0.035, 0.51, HEIGHT, "red"),
    ]


def make():
    robot = Robot("eyebot", "A flying robot with a camera and a laser.", MATERIALS)
    robot.link("body", visuals=body_visuals(), collisions=[disc(RADIUS, 0, HEIGHT)], mass=MASS,
               inertia=disc(0.18, 0.2, 0.36))
    for i, xyz, rpy in ring(LED_COUNT, 0.1, LED_HEIGHT):
        robot.link(f"led_{i}", xyz=xyz, rpy=rpy, visuals=[sphere(0.006, material="light_grey")])
    for i, xyz, rpy in ring(DISTANCE_COUNT, RADIUS, DISTANCE_HEIGHT):
        robot.link(f"distance_{i}", xyz=xyz, rpy=rpy)
    robot.link(f"distance_{DISTANCE_COUNT}", xyz=(-0.05, 0, 0.36), rpy=UP)  # on the hub
    robot.link(f"distance_{DISTANCE_COUNT + 1}", xyz=(-0.05, 0, 0.15), rpy=DOWN)  # beside the camera
    for i, xyz, rpy in ring(LIGHT_COUNT, RADIUS, DISTANCE_HEIGHT):
        robot.link(f"light_{i}", xyz=xyz, rpy=rpy)
    robot.camera("camera", (0, 0, 0.15), DOWN)
    robot.link("omnidirectional_camera", xyz=(0, 0, OMNIDIRECTIONAL_CAMERA_HEIGHT),
               visuals=[disc(0.014, -0.015, 0.015, "black")])
    robot.camera("pan_tilt_camera", PAN_TILT_CAMERA, visuals=[sphere(0.015, (-0.005, 0, 0), "black")])
    robot.link("range_and_bearing", xyz=(0, 0, RANGE_AND_BEARING_HEIGHT))
    robot.link("altimeter", xyz=(0, 0, 0), rpy=DOWN)
    robot.link("laser_pointer", xyz=(0.05, 0, 0.15), rpy=DOWN)
    robot.link("magnet", xyz=(0, 0, HEIGHT), rpy=UP)
    robot.can("magnet", name="magnet", link="magnet")
    robot.can("leds", links="led")
    robot.can("battery", capacity=199800, voltage=11.1, electronics=4, led=0.2, rotors=4, rotor_radius=ROTOR_RADIUS,
              rotor_efficiency=0.5)
    for device, power in CONSUMPTION.items():
        robot.can("consumption", device=device, power=power)
    return robot
