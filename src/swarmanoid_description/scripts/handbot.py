"""The handbot: a climber with two arms that resembles a lobster (thesis 1, figures 1.2 and 3.9)."""
import math

from footbot import ring
from urdf_writer import Robot, box, cylinder, disc, sphere

LENGTH, WIDTH, HEIGHT = 0.41, 0.29, 0.29  # with the arms stretched ahead
BODY_LENGTH = 0.3  # without arms, from the tail
BODY_MASS = 2.1
CONSUMPTION = {"handbot_arms": 2, "handbot_hands": 0.6, "handbot_rope": 1, "handbot_camera": 1, "handbot_distance": 0.12,
               "handbot_proximity": 0.02, "loudspeaker": 0.2, "wifi": 0.8, "bluetooth": 0.1}  # W, docs/reference/battery.md
UPPER_ARM_MASS, FOREARM_MASS, HAND_MASS = 0.15, 0.1, 0.15  # together with the body 2.9 kg
STRIP_RADIUS = WIDTH / 2  # footbots from the sides touch strip and body at once
ROPE_LENGTH = 3  # on the winch [m]
STRIP_HEIGHT = 0.05  # height of the footbots' grippers
DISTANCE_COUNT = 12  # infrared sensors around the body
DISTANCE_HEIGHT = 0.07  # just over the strip
RANGE_AND_BEARING_HEIGHT = 0.205  # on the carapace
LED_COUNT = 12
LED_RADIUS, LED_HEIGHT = 0.05, 0.205  # on the carapace, around the rope launcher

FORWARD = (0, math.pi / 2, 0)  # turns a cylinder's axis from z to x
UP = (0, -math.pi / 2, 0)  # the x axis, in which devices point, points straight up
MATERIALS = {
    "black": (0.08, 0.08, 0.09, 1),
    "dark_grey": (0.25, 0.26, 0.28, 1),
    "light_grey": (0.75, 0.77, 0.8, 1),
    "red": (0.72, 0.14, 0.1, 1),
    "dark_red": (0.5, 0.09, 0.07, 1),
    "rubber": (0.85, 0.75, 0.5, 1),
    "yellow": (0.95, 0.8, 0.2, 1),
}


def body_visuals():
    tail = [cylinder(0.062 - 0.008 * i, 0.032, (-0.085 - 0.03 * i, 0, 0.135 - 0.008 * i),
                     "dark_red" if i % 2 else "red", FORWARD) for i in range(3)]
    fan = [box((0.045, 0.05, 0.008), (-0.175, 0.03 * side, 0.11), "dark_red", (0, 0, -0.5 * side)) for side in (-1, 1)]
    feelers = [cylinder(0.002, 0.11, (0.11, 0.035 * side, 0.215), "black", (0.25 * side, 1.1, 0)) for side in (-1, 1)]
    eyes = [sphere(0.011, (0.088, 0.03 * side, 0.185), "black") for side in (-1, 1)]
    return [
        disc(STRIP_RADIUS, 0.04, 0.06, "dark_grey"),  # the strip that footbots grip
        disc(0.08, 0, 0.04, "black"),
        disc(0.06, 0.06, 0.08, "black"),
        box((0.15, 0.15, 0.1), (0, 0, 0.13), "red"),  # carapace
        box((0.12, 0.11, 0.03), (-0.005, 0, 0.19), "dark_red"),
        box((0.04, 0.09, 0.07), (0.085, 0, 0.14), "dark_red"),  # head
        *tail, *fan, *feelers, *eyes,
        disc(0.03, 0.2, 0.25, "light_grey", (-0.02, 0)),  # rope launcher
        disc(0.014, 0.25, 0.28, "yellow", (-0.02, 0)),
        disc(0.02, 0.28, HEIGHT, "black", (-0.02, 0)),  # the rope's magnet
    ]


def arm(robot, name, side):
    """Shoulder (raises the arm), elbow (swings it sideways), wrist (turns the hand); stretched ahead at zero."""
    def limit(low, high):
        return f'lower="{low}" upper="{high}" effort="5" velocity="2"'

    upper = cylinder(0.017, 0.07, (0.035, 0, 0), "red", FORWARD)
    robot.link(f"{name}_upper_arm", "body", (0.03, side * 0.11, 0.15), joint=f"{name}_shoulder", kind="revolute",
               axis=(0, 1, 0), limit=limit(-1.57, 0.7), mass=UPPER_ARM_MASS, inertia=upper,
               visuals=[sphere(0.03, material="dark_grey"), upper], collisions=[upper])
    fore = cylinder(0.014, 0.045, (0.025, 0, 0), "dark_red", FORWARD)
    robot.link(f"{name}_forearm", f"{name}_upper_arm", (0.07, 0, 0), joint=f"{name}_elbow", kind="revolute",
               axis=(0, 0, 1), limit=limit(-1.2, 1.2), mass=FOREARM_MASS, inertia=fore,
               visuals=[sphere(0.02, material="dark_grey"), fore], collisions=[fore])
    palm = box((0.02, 0.055, 0.03), (0.01, 0, 0), "dark_grey")
    fingers = [box((0.04, 0.014, 0.026), (0.032, 0.021 * s, 0), "red", (0, 0, -0.15 * s)) for s in (-1, 1)]
    robot.link(f"{name}_hand", f"{name}_forearm", (0.045, 0, 0), joint=f"{name}_wrist", kind="revolute",
               axis=(1, 0, 0), limit=limit(-3.14, 3.14), mass=HAND_MASS, inertia=palm,
               visuals=[palm, *fingers], collisions=[box((0.058, 0.055, 0.03), (0.029, 0, 0))])
    robot.link(f"{name}_suction", f"{name}_hand", (0.06, 0, 0))  # contact point of the cups; x axis away from the hand
    for i, y in enumerate((0.018, -0.018)):
        cup = cylinder(0.011, 0.008, (-0.004, 0, 0), "rubber", FORWARD)
        robot.link(f"{name}_cup_{i}", f"{name}_hand", (0.06, y, 0), visuals=[cup])


def make():
    robot = Robot("handbot", "A climbing robot with two arms.", MATERIALS)
    robot.link("body", visuals=body_visuals(), mass=BODY_MASS, inertia=box((0.25, 0.18, 0.16), (-0.02, 0, 0.12)),
               collisions=[box((BODY_LENGTH, WIDTH, HEIGHT), ((BODY_LENGTH - LENGTH) / 2, 0, HEIGHT / 2))])
    arm(robot, "left", 1)
    arm(robot, "right", -1)
    for i, xyz, rpy in ring(DISTANCE_COUNT, STRIP_RADIUS, DISTANCE_HEIGHT):
        robot.link(f"distance_{i}", xyz=xyz, rpy=rpy)
    robot.camera("camera", (0.105, 0, 0.16))
    robot.link("range_and_bearing", xyz=(-0.005, 0, RANGE_AND_BEARING_HEIGHT))
    for i, xyz, rpy in ring(LED_COUNT, LED_RADIUS, LED_HEIGHT):
        robot.link(f"led_{i}", xyz=xyz, rpy=rpy, visuals=[sphere(0.005, material="light_grey")])
    robot.link("rope_launcher", xyz=(-0.02, 0, HEIGHT), rpy=UP)
    robot.link("gripping_strip", xyz=(0, 0, STRIP_HEIGHT), collisions=[cylinder(STRIP_RADIUS, 0.012)])
    robot.can("suction", name="left hand", link="left_suction")
    robot.can("suction", name="right hand", link="right_suction")
    robot.can("rope", name="rope", link="rope_launcher", length=ROPE_LENGTH)
    robot.can("gripping_strip", link="gripping_strip")
    robot.can("leds", links="led")
    robot.can("battery", capacity=133200, voltage=3.7, electronics=4, led=0.2)
    for device, power in CONSUMPTION.items():
        robot.can("consumption", device=device, power=power)
    return robot
