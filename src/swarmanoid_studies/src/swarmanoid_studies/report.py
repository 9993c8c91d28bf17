"""The report of a batch: one HTML file with embedded pictures, or one PNG."""

import base64
import html
import os
from typing import Iterable, List, Sequence

import numpy

from .atomic_file import write_atomically
from .input_file import shown
from .plots import all_pictures, picture
from .results_table import Results, read_results
from .statistics import LEVEL, comparisons, panels, summaries

STYLE = ("body{font-family:sans-serif;max-width:70em;margin:2em auto;padding:0 1em}table{border-collapse:collapse;margin:1em 0}"
         "td,th{border:1px solid #ccc;padding:.2em .6em;text-align:right}th:first-child,td:first-child,.text td{text-align:left}"
         "img{max-width:100%}")


def write_report(results_file: str, report: str) -> None:
    """@param report ends in .html or .png @raise BadInput, RunsStopped"""
    results = read_results(results_file)
    title = _title(results, results_file)
    content = all_pictures(results, title) if report.endswith(".png") else _page(results, title).encode(errors="replace")
    write_atomically(report, content)


def _title(results: Results, file: str) -> str:
    experiments = ", ".join(results.identity["experiment"]) or os.path.basename(file)
    return f"{shown(experiments)}: {results.count} runs, {len(numpy.unique(results.seeds))} seeds"


def _number(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _table(head: Sequence[str], rows: Iterable[Sequence[object]], of_texts: bool = False) -> str:
    def line(tag: str, cells: Iterable[object]) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(_number(cell))}</{tag}>" for cell in cells) + "</tr>\n"
    kind = ' class="text"' if of_texts else ""
    return f"<table{kind}>\n{line('th', head)}{''.join(line('td', row) for row in rows)}</table>\n"


def _page(results: Results, title: str) -> str:
    percent = f"{LEVEL:.0%}"
    compared = comparisons(results)
    parts: List[str] = [f"<h1>{html.escape(title)}</h1>\n", _about(results, sum(map(len, compared.values())))]
    for metric, path in panels(results):
        parts.append(f"<h2>{html.escape(metric)}{' by ' + html.escape(path) if path else ''}</h2>\n")
        data = base64.b64encode(picture(results, metric, path)).decode()
        parts.append(f'<img alt="distribution of {html.escape(metric)}" src="data:image/png;base64,{data}">\n')
        parts.append(_table([path or "", "runs", "mean", f"{percent} from", "to", "median", "least", "most"],
                            summaries(results, path, metric)))
        if compared.get((metric, path)):
            parts.append("<p>In pairs of the same seed:</p>\n" + _table(
                ["from", "to", "pairs", "mean difference", f"{percent} from", "to", "effect size d_z", "Wilcoxon p", "p, Holm"],
                compared[metric, path]))
    if results.failed:
        parts.append(f"<h2>Runs that failed: {results.failed}</h2>\n" + _table(
            [*results.columns.paths, "seed", "failure"], results.failures, of_texts=True))
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
            f"<style>{STYLE}</style></head><body>\n{''.join(parts)}</body></html>\n")


def _about(results: Results, tests: int) -> str:
    facts: List[Sequence[object]] = [
        ("version", ", ".join(results.identity["version"])), ("library of mathematics", ", ".join(results.identity["math_library"])),
        ("failed", results.failed), ("wall time of all runs [s]", results.wall_s)]
    if results.texts:
        facts.append(("metrics that are texts", ", ".join(results.texts)))
    if tests:
        facts.append(("tests", f"{tests} Wilcoxon tests in this report; the column \"p, Holm\" has p corrected for this number of tests "
                      "(Holm, 1979)"))
    return _table(["", ""], facts, of_texts=True)
