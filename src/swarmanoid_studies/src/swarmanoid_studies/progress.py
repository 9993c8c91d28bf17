"""Progress of many runs: one line that is redrawn on a terminal, otherwise a line per tenth, as in `swarmanoid run`."""

import sys
import time

WIDTH = 40
BETWEEN_S = 0.1  # between two redraws


def duration(seconds: float) -> str:
    """Text such as "3 min 7 s"."""
    whole = round(seconds)
    for name, unit, smaller, of_smaller in (("d", 86400, "h", 3600), ("h", 3600, "min", 60), ("min", 60, "s", 1)):
        if whole >= unit:
            return f"{whole // unit} {name} {whole % unit // of_smaller} {smaller}"
    return f"{whole} s"


class Progress:
    def __init__(self, title: str, total: int, done: int = 0, is_quiet: bool = False) -> None:
        """@param done runs made earlier, before a resume"""
        self._title, self._total, self._done, self._failed = title, total, done, 0
        self._before = done
        self._start = time.monotonic()
        self._is_quiet = is_quiet
        self._is_terminal = sys.stderr.isatty()
        self._next = 0.0
        self._tenth = done * 10 // max(total, 1) + 1

    def note(self, is_failed: bool) -> None:
        """Counts one more run."""
        self._done += 1
        self._failed += is_failed
        now = time.monotonic()
        if self._is_terminal:
            if now >= self._next or self._done == self._total:
                self._next = now + BETWEEN_S
                self._draw()
        elif self._done * 10 >= self._tenth * self._total:
            self._tenth = self._done * 10 // self._total + 1
            self._draw()

    def finish(self) -> None:
        if self._is_terminal and not self._is_quiet:
            self._draw()
            print(file=sys.stderr)

    def say(self, line: str) -> None:
        """Prints a line above the redrawn one."""
        if not self._is_quiet:
            print(f"\r{line}\x1b[K" if self._is_terminal else line, file=sys.stderr, flush=True)

    def text(self) -> str:
        filled = WIDTH * self._done // max(self._total, 1)
        rate = (self._done - self._before) / max(time.monotonic() - self._start, 1e-9)
        text = (f"{self._title} [{'#' * filled}{'.' * (WIDTH - filled)}] {self._done} of {self._total} runs, "
                f"{rate:.1f} runs/s")
        if self._failed:
            text += f", {self._failed} failed"
        if self._done < self._total and rate > 0:
            text += f", about {duration((self._total - self._done) / rate)} left"
        return text

    def _draw(self) -> None:
        if not self._is_quiet:
            print(f"\r{self.text()}\x1b[K" if self._is_terminal else self.text(), end="" if self._is_terminal else "\n",
                  file=sys.stderr, flush=True)
