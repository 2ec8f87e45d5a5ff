"""Writes one HTML file with the pictures and tables of a study; `harmos report` calls it.

python3 -m harmos.report STUDY.h5 PAGE.html [--abscissa CURVE] [--pictures DIR]
"""
import argparse
import pathlib
import sys

import numpy

from harmos.outputs import demand_distinct, replace_file
from harmos.report.page import page
from harmos.report.writing import Pictures
from harmos.results import read_study


def main(words: list[str] | None = None) -> int:
    """Does what the words say, those of the command line if there are none; returns the exit code, 2 when the study or the curve cannot be read."""
    parser = argparse.ArgumentParser(prog="python3 -m harmos.report", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study")
    parser.add_argument("page")
    parser.add_argument("--abscissa", default="", help="curve to draw the other curves against (default: time)")
    parser.add_argument("--pictures", type=pathlib.Path, help="folder that also gets the pictures, as PNG files")
    arguments = parser.parse_args(words)
    try:
        demand_distinct(arguments.study, arguments.page)
        study = read_study(arguments.study)
        if arguments.abscissa and arguments.abscissa not in study.curves:
            raise ValueError(f"there is no curve {arguments.abscissa}; there are {', '.join(study.curves)}")
        pictures = Pictures(arguments.pictures, arguments.study)
    except (OSError, ValueError) as error:
        print(f"harmos report: {error}\nNothing was written.", file=sys.stderr)
        return 2
    try:
        text = page(study, arguments.abscissa, pictures)
    except (ArithmeticError, LookupError, TypeError, ValueError, numpy.linalg.LinAlgError) as error:
        print(f"harmos report: {arguments.study}: its content cannot be shown, {type(error).__name__}: {error}\n"
              "  It may be damaged: run the study again to restore it.", file=sys.stderr)
        return 2
    try:
        pictures.write()
        replace_file(arguments.page, text.encode())
        print(arguments.page, flush=True)
    except (OSError, ValueError) as error:
        print(f"harmos report: {error}", file=sys.stderr)
        return 1 if isinstance(error, OSError) else 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
