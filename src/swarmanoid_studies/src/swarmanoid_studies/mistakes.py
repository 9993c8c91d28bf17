"""Errors in input, and exit codes of programs, as docs/reference/program.md states for `swarmanoid`."""

import argparse
import contextlib
import os
import signal
import sys
from typing import Callable, Iterator, NoReturn

FINISHED, BAD_INPUT, CONTROLLER_FAILED, STOPPED, INTERRUPTED = 0, 2, 3, 4, 130


class BadInput(Exception):
    """An error of the user; the message has its location, the value found and the values allowed."""


class RunsStopped(Exception):
    """The request cannot be completed: a run has no result, or a file could not be written."""


class Arguments(argparse.ArgumentParser):
    """Reports errors in one line, as the program `swarmanoid` does."""

    def __init__(self, command: str, description: str) -> None:
        super().__init__(prog=f"swarmanoid {command}", description=description, allow_abbrev=False)

    def error(self, message: str) -> NoReturn:
        raise BadInput(f"{message}; `{self.prog} --help` has all options")


class _Interrupts:
    """A pending interrupt: it was held, or lost, since Python ignores exceptions in destructors and in callbacks of its garbage
    collector, which libraries have."""
    is_waiting = False
    is_held = False


def _interrupt(_signal: int, _frame: object) -> None:
    if _Interrupts.is_held:
        _Interrupts.is_waiting = True
    else:
        raise KeyboardInterrupt


def _note_lost(ignored: "sys.UnraisableHookArgs") -> None:
    if issubclass(ignored.exc_type, KeyboardInterrupt):
        _Interrupts.is_waiting = True
    else:
        sys.__unraisablehook__(ignored)


def hear_interrupts() -> None:
    """Raises a pending interrupt. Programs call it where they receive results."""
    if _Interrupts.is_waiting:
        _Interrupts.is_waiting = False
        raise KeyboardInterrupt


@contextlib.contextmanager
def interrupts_held() -> Iterator[None]:
    """Delays interrupts until the end of an atomic action, such as writing a row and counting it. @pre the program was started
    with `call`"""
    _Interrupts.is_held = True
    try:
        yield
    finally:
        _Interrupts.is_held = False
    hear_interrupts()


def interrupted() -> int:
    """Prints how to continue. @return the exit code"""
    print("swarmanoid: interrupted; --resume goes on", file=sys.stderr)
    return INTERRUPTED


def print_result(text: str) -> None:
    """Prints the program's line on standard output. @raise RunsStopped"""
    try:
        sys.stdout.write(text.encode(errors="backslashreplace").decode() + "\n")
        sys.stdout.flush()
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # the interpreter flushes again at its end
        raise RunsStopped(f"standard output: cannot be written: {error.strerror}") from None


def call(main: Callable[[], int]) -> int:
    """Runs the body of a program. @return its exit code"""
    sys.unraisablehook = _note_lost
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) != signal.SIG_IGN:  # as nohup sets it
            signal.signal(number, _interrupt)
    try:
        return main()
    except BadInput as mistake:
        print(f"swarmanoid: {mistake}", file=sys.stderr)
        return BAD_INPUT
    except (OSError, RunsStopped) as problem:
        print(f"swarmanoid: {problem}", file=sys.stderr)
        return STOPPED
    except KeyboardInterrupt:
        print("swarmanoid: interrupted", file=sys.stderr)
        return INTERRUPTED
