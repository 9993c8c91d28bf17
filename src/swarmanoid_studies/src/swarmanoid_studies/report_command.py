"""`swarmanoid report`: the report of a CSV file of a batch."""

import os

from .atomic_file import refuse_unwritable
from .mistakes import FINISHED, Arguments, BadInput, call, print_result


def check_report_name(report: str, results: str) -> None:
    """@raise BadInput"""
    if not report.endswith((".html", ".png")):
        raise BadInput(f"{report}: found another ending, allowed: .html or .png")
    if os.path.abspath(report) == os.path.abspath(results):
        raise BadInput(f"{report}: found the CSV file, allowed: another name")
    refuse_unwritable(report)


def main() -> int:
    return call(_main)


def _main() -> int:
    parser = Arguments("report", "Writes a report of a CSV file: metrics by value, pairs of the same seed, runs that failed.")
    parser.add_argument("csv", help="as `swarmanoid batch` writes it")
    parser.add_argument("--out", metavar="FILE", help=".html or .png; without it an .html beside the CSV file")
    arguments = parser.parse_args()
    report = arguments.out or os.path.splitext(arguments.csv)[0] + ".html"
    check_report_name(report, arguments.csv)
    from .report import write_report
    write_report(arguments.csv, report)
    print_result(report)
    return FINISHED
