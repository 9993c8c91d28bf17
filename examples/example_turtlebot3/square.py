"""A TurtleBot3 drives a square by its odometry, and a rule compares odometry and true pose."""

import math


class Square:
    """Controller of one robot: drives four sides by odometry, and turns by 90 degrees after each."""

    def init(self, robot, parameters):
        self.side = float(parameters["side"])              # [m]
        self.speed = float(parameters["speed"])            # [m/s]
        self.turn_rate = float(parameters["turn_rate"])    # [rad/s]
        self.odometry = robot.readings["odometry"]
        self.drive = robot.commands["differential_drive"]
        self.done = 0                                      # number of completed sides and turns
        self.start = (0.0, 0.0)                            # start of this side, by odometry [m]

    def step(self, robot):
        """Moves at full speed, and in the last tick of a side or turn by the rest."""
        self.drive.speed = self.drive.turn_rate = 0.0
        if self.done == 8:
            return robot.debug("state", "there")
        is_turn = self.done % 2 == 1
        missing = self.missing_angle() if is_turn else self.missing_way()
        if abs(missing) < 1e-4:
            self.done += 1
            self.start = (float(self.odometry.x), float(self.odometry.y))
        elif is_turn:
            self.drive.turn_rate = max(-self.turn_rate, min(self.turn_rate, missing / robot.dt))
        else:
            self.drive.speed = max(-self.speed, min(self.speed, missing / robot.dt))
        return robot.debug("state", "turns" if is_turn else "drives")

    def missing_way(self):
        """@return remaining length of the side, which is parallel to an axis [m]"""
        direction = math.pi / 2 * (self.done // 2)
        ahead = (self.odometry.x - self.start[0]) * math.cos(direction) + (self.odometry.y - self.start[1]) * math.sin(direction)
        return float(self.side - ahead)

    def missing_angle(self):
        """@return angle to the direction of the next side [rad]"""
        wanted = math.pi / 2 * (self.done // 2 + 1)
        return float(math.remainder(wanted - self.odometry.heading, 2 * math.pi))


class OdometryError:
    """Distance of the first robot from its pose by odometry, and from its start."""

    values = {"odometry_error": 0.0, "from_start": 0.0, "heading_error": 0.0}  # before the first tick

    def reset(self, world):
        self.values = OdometryError.values
        pose = world.robots.poses[0]
        self.start = (pose[0], pose[1], heading_of(pose))

    def after_tick(self, world):
        pose = world.robots.poses[0]
        odometry = world.robots.readings["odometry"]
        x, y, heading = self.start
        believed_x = x + odometry.x[0] * math.cos(heading) - odometry.y[0] * math.sin(heading)
        believed_y = y + odometry.x[0] * math.sin(heading) + odometry.y[0] * math.cos(heading)
        turned = heading_of(pose) - heading
        self.values = {"odometry_error": math.hypot(pose[0] - believed_x, pose[1] - believed_y),
                       "from_start": math.hypot(pose[0] - x, pose[1] - y),
                       "heading_error": abs(math.remainder(turned - odometry.heading[0], 2 * math.pi))}

    def metrics(self):
        return self.values


def heading_of(pose):
    """@param pose x, y, z and a quaternion about z @return heading [rad]"""
    return 2 * math.atan2(pose[5], pose[6])
