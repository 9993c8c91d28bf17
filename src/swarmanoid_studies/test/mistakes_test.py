#!/usr/bin/python3
"""Exit codes and messages of programs."""

import contextlib
import gc
import io
import os
import signal
import unittest

from swarmanoid_studies import mistakes


class Holder:
    """An object whose destructor sends a signal to the process."""

    def __del__(self):
        os.kill(os.getpid(), signal.SIGTERM)


class CallTest(unittest.TestCase):
    def call(self, main):
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            code = mistakes.call(main)
        return code, errors.getvalue()

    def test_an_interrupt_ends_a_program(self):
        self.assertEqual(self.call(lambda: os.kill(os.getpid(), signal.SIGTERM)), (130, "swarmanoid: interrupted\n"))

    def test_an_interrupt_that_python_ignores_is_heard_with_the_next_result(self):
        reached = []

        def collected(_phase, _info):
            os.kill(os.getpid(), signal.SIGTERM)

        def in_callback():
            gc.callbacks.append(collected)
            try:
                gc.collect()
            finally:
                gc.callbacks.remove(collected)
            reached.append("callback")
            mistakes.hear_interrupts()

        def in_destructor():
            holder = Holder()
            del holder
            reached.append("destructor")
            mistakes.hear_interrupts()

        for main in (in_callback, in_destructor):
            self.assertEqual(self.call(main), (130, "swarmanoid: interrupted\n"))
        self.assertEqual(reached, ["callback", "destructor"])

    def test_what_is_done_as_a_whole_is_done_before_an_interrupt_is_raised(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            reached = []

            def main():
                with mistakes.interrupts_held():
                    os.kill(os.getpid(), number)
                    reached.append("end of the whole")
                reached.append("what comes after it")

            self.assertEqual(self.call(main), (130, "swarmanoid: interrupted\n"))
            self.assertEqual(reached, ["end of the whole"])

    def test_a_mistake_in_what_is_done_as_a_whole_ends_the_program(self):
        def main():
            with mistakes.interrupts_held():
                raise mistakes.RunsStopped("the disk is full")
        self.assertEqual(self.call(main), (4, "swarmanoid: the disk is full\n"))
        self.test_an_interrupt_ends_a_program()  # interrupts are no longer held

    def test_without_one_nothing_is_heard(self):
        def main():
            mistakes.hear_interrupts()
            return 0
        self.assertEqual(self.call(main), (0, ""))


if __name__ == "__main__":
    unittest.main()
