#!/usr/bin/env python3
"""Every block of C++ and CMake in the tutorial of embedding must stand in the files of the consumer, but for white space.

tutorial.py SOURCE_DIRECTORY
"""
import pathlib
import re
import sys

FILES = {"cpp": "main.cpp", "cmake": "CMakeLists.txt"}
LEAST = 10


def normalised(text):
    return " ".join(text.split())


def main():
    source = pathlib.Path(sys.argv[1])
    consumer = source / "tests" / "install" / "consumer"
    page = (source / "docs" / "guide" / "embedding.md").read_text(encoding="utf-8")
    texts = {language: normalised((consumer / name).read_text(encoding="utf-8")) for language, name in FILES.items()}
    count, wrong = 0, 0
    for match in re.finditer(r"^```(\w+)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
        language, block = match.groups()
        if language not in FILES:
            continue
        count += 1
        if normalised(block) in texts[language]:
            continue
        wrong += 1
        line = page.count("\n", 0, match.start()) + 1
        print(f"docs/guide/embedding.md:{line}: this block is not in tests/install/consumer/{FILES[language]}:\n{block}")
    if count < LEAST:
        print(f"only {count} blocks found in docs/guide/embedding.md")
    return 1 if wrong or count < LEAST else 0


if __name__ == "__main__":
    sys.exit(main())
