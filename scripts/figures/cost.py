"""Cost per robot, by engine and by sensor, as a function of the number of robots: a picture, and its points as rows."""

import math
import statistics
import time

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  pylint: disable=wrong-import-position
import swarmanoid  # noqa: E402  pylint: disable=wrong-import-position

from table import ROOT  # noqa: E402  pylint: disable=wrong-import-position

PICTURE = ROOT / "docs/images/cost.png"
AREA = 1.6          # per robot [m2]
LONG_ENOUGH = 0.6   # minimum duration of a measurement [s]
MOST_TICKS = 20000
PAIRS = 3
LEAST = 0.005       # [us] per robot and tick: the difference of two runs cannot resolve less

ENGINES = {
    "kinematics2d": ("<kinematics2d id='ground'/>", (10, 100, 1000, 10000, 100000)),
    "dynamics2d, 4 steps": ("<dynamics2d id='ground'><subclock>4</subclock></dynamics2d>", (10, 100, 1000, 10000)),
    "dynamics3d, 10 steps": ("<dynamics3d id='ground'><subclock>10</subclock></dynamics3d>", (10, 100, 1000)),
}
PROXIMITY = "<footbot_proximity><range>0.1</range></footbot_proximity>"
SENSORS = {
    "proximity, 0.1 m": ("", PROXIMITY),
    "ground": ("", "<footbot_ground/>"),
    "light, ten bulbs that reach 5 m": ("", "<light><range>5</range><led_range>0.5</led_range></light>"),
    "scanner, 1.5 m": ("<footbot_scanner/>", "<footbot_scanner_readings/>"),
    "range and bearing, 3 m, all send": ("<range_and_bearing/>",
                                         "<range_and_bearing_received><range>3</range></range_and_bearing_received>"),
    "blob camera, 1.5 m, all LEDs lit": ("<footbot_leds/>", "<footbot_camera><range>1.5</range></footbot_camera>"),
}
SIZES = (10, 100, 1000, 10000)


def experiment(robots, engine, controller, actuators="", sensors=""):
    side = math.sqrt(robots * AREA)
    bulbs = "".join(f"<light id='bulb_{i}'><position>{side * (0.5 + 0.3 * math.cos(0.2 * math.pi * i)):.4f},"
                    f"{side * (0.5 + 0.3 * math.sin(0.2 * math.pi * i)):.4f},2</position><orientation>0,0,0</orientation>"
                    "<intensity>100</intensity></light>" for i in range(10)) if "light" in sensors else ""
    return (f"<ahss-config><framework><clocktick>100</clocktick><maxclock>1000000000</maxclock></framework><controllers>"
            f"<{controller} id='dc' library='{controller}'><actuators><footbot_wheels/>{actuators}</actuators>"
            f"<sensors>{sensors}</sensors></{controller}></controllers>"
            f"<arena size='{side:.4f},{side:.4f},3' optimization='2D' bounded='true'>{bulbs}"
            f"<distribute quantity='{robots}' layout='uniform'><minimum>0.15,0.15,0</minimum>"
            f"<maximum>{side - 0.15:.4f},{side - 0.15:.4f},0</maximum><max_trials>100000</max_trials>"
            f"<footbot id='fb'><controller>dc</controller></footbot></distribute></arena><engines>{engine}</engines>"
            "<arena_physics><engine id='ground'><entity id='fb'/></engine></arena_physics></ahss-config>")


def turn(robots):
    """All robots turn on the spot, send messages and light their LEDs; commands persist."""
    if robots.tick > 0:
        return
    wheels = robots.commands["footbot_wheels"]
    wheels.left, wheels.right = -2.0, 2.0
    if "range_and_bearing" in robots.commands:
        robots.commands["range_and_bearing"].sends = 1
    if "footbot_leds" in robots.commands:
        robots.commands["footbot_leds"].ring.red = 255
    if "footbot_scanner" in robots.commands:
        robots.commands["footbot_scanner"].mode, robots.commands["footbot_scanner"].speed = 1, 4.0


def cost(robots, **simulation):
    """@return microseconds per robot and tick, after some ticks of warm-up"""
    with swarmanoid.Simulation(**simulation) as run:
        run.tick(20 if robots <= 10000 else 5)
        ticks, seconds = 1, 0.0
        while seconds < LONG_ENOUGH and ticks <= MOST_TICKS:
            begin = time.perf_counter()
            run.tick(ticks)
            seconds = time.perf_counter() - begin
            ticks *= 2
        return 1e6 * seconds / (ticks // 2 * robots)


def of_sensor(robots, actuators, sensors):
    """Additional cost compared with a robot without sensors: the median over interleaved pairs of runs."""
    def run(*devices):
        return cost(robots, text=experiment(robots, "<kinematics2d id='ground'/>", "diffusion", *devices), controllers={"dc": turn})

    return statistics.median(run(actuators, sensors) - run() for _ in range(PAIRS))


def draw(engines, sensors):
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 5.2), sharey=True)
    for place, curves, title in ((axes[0], engines, "a robot of diffusion, by engine"), (axes[1], sensors, "a sensor, on top")):
        for name, points in curves.items():
            place.loglog(points.keys(), [max(value, LEAST) for value in points.values()], marker="o", label=name)
        place.set_title(title)
        place.set_xlabel("robots, one per 1.6 m²")
        place.grid(True, which="both", alpha=0.3)
        place.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncol=2, fontsize=8)
    axes[0].set_ylim(bottom=LEAST)
    axes[0].set_ylabel("microseconds a robot and tick, one thread")
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110, metadata={"Software": None})


def costs(table):
    engines = {name: {robots: cost(robots, text=experiment(robots, text, "diffusion", "", PROXIMITY)) for robots in sizes}
               for name, (text, sizes) in ENGINES.items()}
    sensors = {name: {robots: of_sensor(robots, *devices) for robots in SIZES} for name, devices in SENSORS.items()}
    draw(engines, sensors)
    for curves, what in ((engines, "a robot of diffusion in {}"), (sensors, "{}: on top of a footbot that turns on the spot")):
        for name, points in curves.items():
            table.add(f"{what.format(name)}, microseconds a robot and tick, one thread", "reported",
                      ", ".join(f"{robots:,} robots " + (f"{value:.2f}" if value >= LEAST else f"under {LEAST}")
                                for robots, value in points.items()), None)
