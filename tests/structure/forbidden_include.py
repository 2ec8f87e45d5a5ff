#!/usr/bin/env python3
"""Shows that an include of a package outside the row does not compile, nor one of another package's detail/.

  forbidden_include.py BUILD_DIR [--root DIR]

Takes the command that compiles a file of each package. As a control, a header of its row is accepted.
"""
import argparse
import pathlib
import sys

from compile_command import check, commands, include
from packages import Packages


def first(packages, package, detail=False):
    """The public header of a package, or detail, with the fewest includes: it is read fastest."""
    headers = [each for each in packages.of(package) if each.endswith(".hpp") and ("/detail/" in each) == detail]
    return min(headers, key=lambda each: (packages.folder / each).read_text().count("#include"), default=None)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    root = options.root.resolve()
    packages = Packages(root)
    compiled = commands(options.build)
    failures = []
    tried = 0
    for package in packages.order:
        of_package = [words for source, words in sorted(compiled.items())
                      if source.startswith(f"{root}/packages/{package}/")]
        if not of_package:
            continue  # nothing but headers
        def message(text):
            return check(of_package[0], text, options.build)
        others = [each for each in packages.order if each != package]
        forbidden = [first(packages, each, detail=True) for each in others]
        forbidden += [first(packages, each) for each in others if each not in packages.rows[package]]
        forbidden = [each for each in forbidden if each]
        tried += len(forbidden)
        # All of them by asking the preprocessor; the last one, which is rather a header than a detail, in earnest.
        asked = message("".join(f"#if __has_include(<harmos/{each}>)\n#error {each} is found\n#endif\n" for each in forbidden))
        if asked is not None:
            failures.append(f"{package}: {asked}")
        said = message(include(forbidden[-1]))
        if said is None or f"{forbidden[-1]}: No such file" not in said:
            failures.append(f"{package} may include <harmos/{forbidden[-1]}>\n{said or ''}")
        allowed = first(packages, (packages.rows[package] or [package])[0])
        said = message(f"#if !__has_include(<harmos/{allowed}>)\n#error\n#endif\n" + include(allowed))
        if said is not None:
            failures.append(f"{package} cannot include <harmos/{allowed}>\n{said}")
    print("\n".join(failures) or f"{tried} forbidden headers cannot be included")
    sys.exit(1 if failures or not tried else 0)


if __name__ == "__main__":
    main()
