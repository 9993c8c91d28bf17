#!/usr/bin/env python3
"""Addresses equal those of C++ controllers (radio_test.cpp of swarmanoid_devices)."""
import unittest

from swarmanoid_python import radio


class RadioTest(unittest.TestCase):
    def test_an_address_is_that_of_the_name(self):
        self.assertEqual(22510536293955, radio.address_of("fb_1"))
        self.assertLess(radio.address_of("a long name of a robot"), 2**48)
        self.assertNotEqual(radio.EVERYBODY, radio.address_of(""))


if __name__ == "__main__":
    unittest.main()
