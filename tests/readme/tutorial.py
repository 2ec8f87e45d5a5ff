#!/usr/bin/env python3
"""Every block of code in the tutorials must stand in files that are tested, but for white space.

tutorial.py SOURCE_DIRECTORY
"""
import pathlib
import re
import sys

# Of every page the files that its blocks of a language must stand in, and how many blocks there are at least.
PAGES = {
    "embedding.md": ({"cpp": ["tests/install/consumer/main.cpp"],
                      "cmake": ["tests/install/consumer/CMakeLists.txt"]}, 10),
    "python.md": ({"py": ["docs/guide/laws_in_python.py"]}, 1),
    "writing-laws.md": ({"cpp": ["tests/install/consumer/laws/Maxwell.hpp", "tests/install/consumer/laws/plugin.cpp"],
                         "cmake": ["tests/install/consumer/CMakeLists.txt"],
                         "XML": ["xml/glue_by_formula.xml"]}, 7),
}


def normalised(text):
    return " ".join(text.split())


def wrong_blocks(source, page, files, least):
    """Messages about the blocks of a page."""
    text = (source / "docs" / "guide" / page).read_text(encoding="utf-8")
    count = 0
    for match in re.finditer(r"^```(\w+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        language, block = match.groups()
        if language not in files:
            continue
        count += 1
        if any(normalised(block) in normalised((source / name).read_text(encoding="utf-8")) for name in files[language]):
            continue
        line = text.count("\n", 0, match.start()) + 1
        yield f"docs/guide/{page}:{line}: this block is not in {' or '.join(files[language])}:\n{block}"
    if count < least:
        yield f"only {count} blocks found in docs/guide/{page}"


def main():
    source = pathlib.Path(sys.argv[1])
    messages = [each for page, (files, least) in PAGES.items() for each in wrong_blocks(source, page, files, least)]
    print("\n".join(messages))
    return 1 if messages else 0


if __name__ == "__main__":
    sys.exit(main())
