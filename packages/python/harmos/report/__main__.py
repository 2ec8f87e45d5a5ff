"""Writes one HTML file with the pictures and tables of a study; `harmos report` calls it.

python3 -m harmos.report STUDY.h5 PAGE.html [--abscissa CURVE] [--pictures DIR]
"""
import argparse
import pathlib
import sys

from harmos.report.page import page
from harmos.report.writing import Pictures
from harmos.results import read_study


def main() -> int:
    """Does what the command line says; returns the exit code, 2 when the study or the curve cannot be read."""
    parser = argparse.ArgumentParser(prog="python3 -m harmos.report", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study")
    parser.add_argument("page")
    parser.add_argument("--abscissa", default="", help="curve to draw the other curves against (default: time)")
    parser.add_argument("--pictures", type=pathlib.Path, help="folder that also gets the pictures, as PNG files")
    arguments = parser.parse_args()
    try:
        study = read_study(arguments.study)
        if arguments.abscissa and arguments.abscissa not in study.curves:
            raise ValueError(f"there is no curve {arguments.abscissa}; there are {', '.join(study.curves)}")
    except (OSError, ValueError) as error:
        print(f"harmos report: {error}", file=sys.stderr)
        return 2
    text = page(study, arguments.abscissa, Pictures(arguments.pictures))
    with open(arguments.page, "w", encoding="utf-8") as file:
        file.write(text)
    print(arguments.page)
    return 0


if __name__ == "__main__":
    sys.exit(main())
