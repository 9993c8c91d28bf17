"""Decodes sensor frames into robots and encodes command frames, as defined in swarmanoid_interface/frames.hpp. Free of
ROS."""

import struct
import traceback

from .device import Device, Devices, replace_values
from .layout import Layout
from .names import Fields
from .robot import Robot

_NOTHING, _STEPPED, _FAILED = 0, 1, 2


def _text(text):
    data = text.encode()
    return struct.pack("<I", len(data)) + data


def _block(data):
    return struct.pack("<I", len(data)) + data


def _layouts(devices):
    return [(device.type, Layout(device.layout), Fields(device.type, device.names)) for device in devices]


def _resting(kind, layouts):
    return Devices(kind, {name: Device(layout.initial(), fields) for name, layout, fields in layouts})


class Hosted:
    """One registered robot, and its controller while the robot exists."""

    def __init__(self, description, make_controller):
        self._description = description
        self._make_controller = make_controller
        self._sensors = _layouts(description.sensors)
        self._actuators = _layouts(description.actuators)
        self.drop()

    def drop(self):
        """Deletes the controller; the next step creates a new one."""
        self._robot = None
        self._controller = None
        self._failure = ""

    def answer(self, data, position, seed, time, dt):
        """Reads the robot's part of a sensor frame. @return its part of the command frame, and the position after the
        part that was read"""
        is_present = data[position]
        position += 1
        if not is_present:
            self.drop()
            return bytes([_NOTHING]), position
        if self._robot is None:
            self._start(seed)
        for name, layout, _ in self._sensors:
            values, end = layout.read(data, position + 4)
            (length,) = struct.unpack_from("<I", data, position)
            if end != position + 4 + length:
                raise ValueError(f"{self._description.name}, {name}: found {length} bytes, "
                                 f"expected {end - position - 4}")
            replace_values(self._robot.sensors[name], values)
            position = end
        return self._step(time, dt), position

    def _start(self, seed):
        robot = self._description
        self._robot = Robot(robot.name, robot.type, {p.name: p.value for p in robot.parameters}, seed,
                            _resting("sensor", self._sensors), _resting("actuator", self._actuators))

    def _step(self, time, dt):
        if not self._failure:
            try:
                if self._controller is None:
                    self._controller = self._make_controller(self._robot)
                self._controller.step(time, dt)
                return bytes([_STEPPED]) + self._commands()
            except Exception as error:  # stops this robot only
                traceback.print_exc()
                self._failure = f"{type(error).__name__}: {error}"
        return bytes([_FAILED]) + _text(self._failure)

    def _commands(self):
        data = b"".join(_block(layout.write(self._robot.actuators[name], fields.names))
                        for name, layout, fields in self._actuators)
        debug = self._robot.debug_values
        return data + struct.pack("<I", len(debug)) + b"".join(_text(key) + _text(value) for key, value in debug.items())
