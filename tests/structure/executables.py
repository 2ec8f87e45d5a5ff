#!/usr/bin/env python3
"""Fails where a script of the project may not be run by its path, as the documentation does.

  executables.py [--root DIR]

A script is a file that begins with #!; exit code 1 names those that are not executable.
"""
import argparse
import os
import pathlib
import sys

FOLDERS = (".ci", "cmake", "docs", "drivers", "packages", "tests", "xml")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    root = parser.parse_args().root
    paths = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*"))]
    wrong = [path for path in paths if path.is_file() and not os.access(path, os.X_OK) and begins(path)]
    for path in wrong:
        print(f"{path.relative_to(root)} begins with #! and is not executable: chmod +x")
    return 1 if wrong else 0


def begins(path):
    with open(path, "rb") as file:
        return file.read(2) == b"#!"


if __name__ == "__main__":
    sys.exit(main())
