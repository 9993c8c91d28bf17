"""The footbot: a wheeled robot based on the marXbot (thesis 1, figures 1.1 and 3.9)."""
import math

from urdf_writer import Robot, box, cylinder, disc, number, sphere

RADIUS = 0.085  # 17 cm across
HEIGHT = 0.146  # of the body, up to the camera
MASS = 1.8
WHEEL_MASS = 0.1
CONSUMPTION = {"footbot_proximity": 0.24, "proximity": 0.24, "footbot_ground": 0.04, "footbot_base_ground": 0.08,
               "ground": 0.12, "footbot_camera": 1, "range_and_bearing": 0.5, "footbot_turret": 0.3,
               "footbot_gripper": 0.3, "footbot_front_camera": 1, "footbot_scanner": 0.3, "footbot_microphones": 0.05,
               "microphones": 0.05, "loudspeaker": 0.2, "rfid_reader": 0.3, "wifi": 0.8, "bluetooth": 0.1}  # W, docs/reference/battery.md
WHEEL_RADIUS = 0.029
WHEEL_SEPARATION = 0.14
RIM_SPEED = 0.3  # [m/s]
GRIPPER_TIP = 0.11
GRIPPER_HEIGHT = 0.05  # half the height of a prey
TURRET_SPEED = 3.0  # [rad/s]: half a turn in a second
TURRET_TORQUE = 2.0  # [N m]: above the 1.1 to 1.5 N m at which the friction of resting treels holds the chassis
PROXIMITY_COUNT = 24
PROXIMITY_HEIGHT = 0.06
GROUND_COUNT = 8
GROUND_RADIUS = 0.063
BASE_GROUND_OFFSET = 0.03
GROUND_HEIGHT = 0.005
LED_COUNT = 12
LED_HEIGHT = 0.12
CAMERA_HEIGHT = 0.28
MICROPHONE_COUNT = 4
MICROPHONE_RADIUS = 0.07
RFID_HEIGHT = 0.01  # of the antenna, at the bottom of the body
FRONT_CAMERA = (0.08, 0, 0.09)  # over the gripper
RANGE_AND_BEARING_HEIGHT = 0.13  # below the top of the body, so that footbots occlude each other
SCANNER_HEIGHT = 0.13  # below the top of the body, so that beams hit other footbots

ROLLED = (math.pi / 2, 0, 0)  # turns a cylinder's axis from z to y
MATERIALS = {
    "black": (0.08, 0.08, 0.09, 1),
    "dark_grey": (0.22, 0.23, 0.25, 1),
    "light_grey": (0.75, 0.77, 0.8, 1),
    "blue": (0.1, 0.33, 0.75, 1),
    "orange": (0.95, 0.5, 0.1, 1),
    "milky": (0.95, 0.95, 1, 0.75),
    "glass": (0.7, 0.85, 0.95, 0.35),
}


def ring(count, radius, height):
    """Yields index, position and orientation of places on a circle, the first ahead, then counter-clockwise; angles are in
    (-pi, pi]."""
    for i in range(count):
        angle = 2 * math.pi * (i if i <= count // 2 else i - count) / count
        yield i, (radius * math.cos(angle), radius * math.sin(angle), height), (0, 0, angle)


def treel(side):
    """The track around a wheel: two rollers and the box between them."""
    y = side * 0.063
    rollers = [cylinder(0.022, 0.02, (x, y, 0.024), "black", ROLLED) for x in (-0.028, 0.028)]
    return rollers + [box((0.056, 0.02, 0.044), (0, y, 0.024), "black")]


def body_visuals():
    return [
        *treel(1), *treel(-1),
        disc(0.05, 0.012, 0.045, "dark_grey"),
        disc(0.082, 0.055, 0.068, "black"),  # infrared sensors
        disc(0.078, 0.068, 0.112, "blue"),
        disc(0.083, 0.113, 0.127, "milky"),  # LEDs
        disc(0.078, 0.127, HEIGHT, "light_grey"),
        disc(0.032, HEIGHT, 0.166, "black"),  # rotating long-range distance sensor
        disc(0.022, 0.166, 0.27, "glass"),  # camera looking up into a mirror
        disc(0.006, 0.166, 0.25, "dark_grey"),
        sphere(0.014, (0, 0, 0.262), "light_grey"),
        disc(0.025, 0.27, 0.29, "black"),
    ]


def body_collisions():
    """Figure 3.9a: the body and two wheels. The wheels are upright cylinders, as planar engines require."""
    wheels = [disc(0.018, 0, 2 * WHEEL_RADIUS, xy=(0, side * WHEEL_SEPARATION / 2)) for side in (1, -1)]
    return [disc(RADIUS, 0.01, HEIGHT), *wheels]


def add_turret(robot):
    """The ring that carries the gripper and turns against the chassis. Its mass is part of the body's mass."""
    gripper = box((0.04, 0.04, 0.03), (GRIPPER_TIP - 0.02, 0, 0), "orange")
    robot.link("turret", xyz=(0, 0, GRIPPER_HEIGHT), joint="turret", kind="continuous", axis=(0, 0, 1),
               limit=f'effort="{number(TURRET_TORQUE)}" velocity="{number(TURRET_SPEED)}"',
               visuals=[disc(0.083, -0.008, 0.004, "dark_grey"), gripper], collisions=[gripper])
    robot.link("gripper_tip", parent="turret", xyz=(GRIPPER_TIP, 0, 0))


def add_ground_sensors(robot):
    """Sensors that look down: a ring around the body, which starts half a step to the left, and four between the wheels."""
    step = 2 * math.pi / GROUND_COUNT
    angles = [(i + 0.5) * step for i in range(GROUND_COUNT)]
    ring_places = [(GROUND_RADIUS * math.cos(angle), GROUND_RADIUS * math.sin(angle)) for angle in angles]
    base_places = [(x * BASE_GROUND_OFFSET, y * BASE_GROUND_OFFSET) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    for name, places in (("ground", ring_places), ("base_ground", base_places)):
        for i, place in enumerate(places):
            robot.link(f"{name}_{i}", xyz=(*place, GROUND_HEIGHT), rpy=(0, math.pi / 2, 0))


def make():
    robot = Robot("footbot", "A wheeled robot with a gripper.", MATERIALS)
    robot.link("body", visuals=body_visuals(), collisions=body_collisions(), mass=MASS - 2 * WHEEL_MASS,
               inertia=disc(0.075, 0.02, 0.12))
    wheel = cylinder(WHEEL_RADIUS, 0.02, material="dark_grey", rpy=ROLLED)
    hub = cylinder(0.012, 0.024, material="orange", rpy=ROLLED)
    for name, side in (("left_wheel", 1), ("right_wheel", -1)):
        robot.link(name + "_link", xyz=(0, side * WHEEL_SEPARATION / 2, WHEEL_RADIUS), joint=name, kind="continuous",
                   axis=(0, 1, 0), limit=f'effort="1" velocity="{RIM_SPEED / WHEEL_RADIUS!r}"',
                   visuals=[wheel, hub], mass=WHEEL_MASS, inertia=wheel)
    for i, xyz, rpy in ring(PROXIMITY_COUNT, RADIUS, PROXIMITY_HEIGHT):
        robot.link(f"proximity_{i}", xyz=xyz, rpy=rpy, visuals=[box((0.004, 0.008, 0.006), (-0.002, 0, 0), "glass")])
    add_ground_sensors(robot)
    for i, xyz, rpy in ring(LED_COUNT, RADIUS, LED_HEIGHT):
        robot.link(f"led_{i}", xyz=xyz, rpy=rpy, visuals=[sphere(0.005, (-0.003, 0, 0), "light_grey")])
    robot.link("camera", xyz=(0, 0, CAMERA_HEIGHT))
    robot.camera("front_camera", FRONT_CAMERA, visuals=[box((0.008, 0.012, 0.012), (-0.004, 0, 0), "black")])
    robot.link("range_and_bearing", xyz=(0, 0, RANGE_AND_BEARING_HEIGHT))
    for i, xyz, rpy in ring(MICROPHONE_COUNT, MICROPHONE_RADIUS, HEIGHT):
        robot.link(f"microphone_{i}", xyz=xyz, rpy=rpy)
    robot.link("rfid_antenna", xyz=(0, 0, RFID_HEIGHT))
    robot.link("scanner", xyz=(0, 0, SCANNER_HEIGHT))  # axis of its head; the scanner device computes the rotation
    add_turret(robot)
    robot.link("gripping_strip", xyz=(0, 0, GRIPPER_HEIGHT), collisions=[cylinder(RADIUS, 0.012)])
    robot.can("wheels", left="left_wheel", right="right_wheel")
    robot.can("gripper", name="gripper", link="gripper_tip")
    robot.can("gripping_strip", link="gripping_strip")
    robot.can("leds", links="led")
    robot.can("battery", capacity=133200, voltage=3.7, electronics=3.2, capacitor=60, drive=4, led=0.2)
    for device, power in CONSUMPTION.items():
        robot.can("consumption", device=device, power=power)
    return robot
