"""Addresses of robots, for WiFi and Bluetooth:

    self._wifi.to = address_of("fb_3")
    if message.sender == address_of("fb_3"): ...
"""

EVERYBODY = 0
_BITS = 48


def address_of(name):
    """Same result as addressOf of swarmanoid_interface/devices/radio.hpp. @param name of the robot"""
    value = 0xCBF29CE484222325  # FNV-1a
    for byte in name.encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return (value ^ value >> _BITS) % 2**_BITS or 1
