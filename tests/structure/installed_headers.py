#!/usr/bin/env python3
"""Compiles the installed headers with the flags of a project that uses an installed Harmos.

  installed_headers.py BUILD_DIR PREFIX [--each]

BUILD_DIR is that project's. All headers in one source, or with --each, every header by itself.
"""
import argparse
import concurrent.futures
import os
import pathlib
import sys

from compile_command import check, commands, include


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("prefix", type=pathlib.Path)
    parser.add_argument("--each", action="store_true")
    options = parser.parse_args()
    folder = options.prefix / "include" / "harmos"
    headers = sorted(str(path.relative_to(folder)) for path in folder.rglob("*.hpp"))
    command = next(iter(commands(options.build).values()))
    if options.each:
        texts = [include(each) for each in headers]
    else:
        texts = ["".join(map(include, headers))]
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        messages = [each for each in pool.map(lambda text: check(command, text, options.build), texts) if each]
    print("\n".join(messages) or f"{len(headers)} headers compile {'by themselves' if options.each else 'together'}")
    sys.exit(1 if messages or not headers else 0)


if __name__ == "__main__":
    main()
