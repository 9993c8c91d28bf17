"""Long tests, and tests with a sanitizer."""

import os
import shutil
import subprocess
import sys
import tempfile

from table import ROOT


def last_word(output):
    """Last line about the result of a gtest. The whole output of a failed test is printed, since some take 20 minutes."""
    if "FAILED" in output:
        print(output, file=sys.stderr)
    last = [line for line in output.splitlines() if "PASSED" in line or "FAILED" in line]
    return last[0].strip("[ ]").replace("]", ":") if last else "did not run"


def rostest(name, package="experiments"):
    """@return the summary of a test with a master of its own, and whether it passed"""
    with tempfile.TemporaryDirectory() as home:
        done = subprocess.run(["rostest", ROOT / f"src/swarmanoid_{package}/rostest/{name}.test"], capture_output=True,
                              text=True, env=dict(os.environ, ROS_HOME=home))
    words = [line.strip(" *") for line in done.stdout.splitlines() if line.startswith(" * ")]
    return ", ".join(words) or "did not run", done.returncode == 0


def long_tests(table, build):
    environment = dict(os.environ, SWARMANOID_LONG_TESTS="1")
    for package, name, test, what, figure in (
            ("experiments", "file_to_motion", "Subclocks/*", "0.1 m/s for 10 s and an arc, subclock 1, 2, 5, 10, 50",
             "1.000 m within 1e-9; arc within 0.1 %"),
            ("engines", "crowd", "*", "1,000 footbots packed at 0.6 of the area, to one point, then into a wall",
             "no overlap, ever; equal hash on repeat"),
            ("engines", "dynamics3d_boxes", "*",
             "dynamics3d, 1,000,000 random poses of two boxes, plates and rods, quarter turns among them, against all separating axes",
             "no contact missed, depth within 0.03 mm"),
            ("engines", "dynamics3d_ramps", "*",
             "dynamics3d, 4,000 boxes on ramps of 2 to 30 degrees at mu 0.9, 5 s; 80 boxes that slide at mu 0.31",
             "all rest within 1 mm; ways within 3 % of Coulomb's"),
            ("experiments", "free_again", "*",
             "diffusion, 200 footbots, 0.1, 0.2, 0.3 m/s, subclock 1 and 10, 1,000 s, 5 seeds, kinematics2d",
             "nobody stands for 100 s (no turn of 10 degrees, no advance of 1 cm)"),
            ("engines", "contact", "*",
             "wall, corner, prey, robot approached at 0.05 to 0.3 m/s, ticks of 10 to 200 ms, kinematics2d",
             "contact within 1 mm, no overlap, free again"),
            ("experiments", "repeatability", "LifeCycle*:Failure*",
             "every second of 1,000 robots deleted, others spawned; failing controllers",
             "references kept, equal hash on repeat; the robot stops, the others go on")):
        file = build / f"devel/lib/swarmanoid_{package}/swarmanoid_{package}_{name}_test"
        done = subprocess.run([file, f"--gtest_filter={test}"], capture_output=True, text=True, env=environment)
        table.add(what, figure, last_word(done.stdout), done.returncode == 0)


def sanitizer(table):
    """Builds and runs one test with the address sanitizer."""
    targets = ["swarmanoid_experiments_repeatability_test", "swarmanoid_devices", "swarmanoid_engines",
               "swarmanoid_visualisations", "retrieval_monitor", "footbot_retrieval", "eyebot_retrieval"]
    cache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    with tempfile.TemporaryDirectory() as build:
        subprocess.run(["cmake", *cache, "-S", ROOT, "-B", build, "-G", "Ninja", "-DBUILD_TESTS_IN_ALL=ON",
                        "-DSWARMANOID_SANITIZE=address", "-DCMAKE_BUILD_TYPE=RelWithDebInfo"],
                       check=True, capture_output=True)
        subprocess.run(["cmake", "--build", build, "--target", *targets], check=True, capture_output=True)
        environment = dict(os.environ, SWARMANOID_LONG_TESTS="1", ASAN_OPTIONS="detect_leaks=1",
                           CMAKE_PREFIX_PATH=f"{build}/devel", LD_LIBRARY_PATH=f"{build}/devel/lib")
        done = subprocess.run([f"{build}/devel/lib/swarmanoid_experiments/swarmanoid_experiments_repeatability_test",
                               "--gtest_filter=LifeCycle*:Failure*"], capture_output=True, text=True, env=environment)
        if done.returncode != 0:
            print(done.stdout[-4000:], done.stderr[-8000:], file=sys.stderr)
        reports = done.stderr.count("ERROR: ")
        table.add("the same deletions and failures under the address sanitizer", "nothing reported, no leak",
                  f"{last_word(done.stdout)}; {reports} reports", done.returncode == 0 and reports == 0)
