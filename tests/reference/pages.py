#!/usr/bin/python3
"""The pages of docs/reference, made of what the program and the docstrings of the Python package say.

  pages.py --harmos build/drivers/harmos docs/reference [--write]

Exit code 1: a page is not what it should be; --write writes all of them instead.
"""
import argparse
import difflib
import importlib
import inspect
import pathlib
import pkgutil
import re
import subprocess
import sys

MADE = "<!-- Made by: cmake --build build --target reference -->\n\n"
INPUTS = {
    "scene.md": ("Scenes", "The inputs of a scene but for laws and responses."),
    "laws.md": ("Laws", "Laws of interfaces and boundaries, with equations, sources and snippets that run."),
    "responses.md": ("Responses", "Numbers that a scene reports."),
    "study.md": ("Studies", "The inputs of a study."),
    "outputs.md": ("Outputs", "Variables of the result files."),
}
"""Pages of what `harmos doc` prints: heading and summary."""
VERBS = ("command-line.md", "Command line", "Verbs, their options, exit codes.")
LIBRARIES = ("harmos.laws",)  # packages in the package whose modules users import
PYTHON = ("python.md", "Python", "The modules, classes and functions of the package harmos.")


def output(harmos: str, *words: str) -> str:
    return subprocess.run([harmos, *words], capture_output=True, text=True, check=True).stdout


def page_of(heading: str) -> str | None:
    """Which page of INPUTS a section of `harmos doc` belongs to."""
    if heading == "Exit Codes":
        return None  # a part of the command line
    if heading == "Laws" or re.match(r"Harmos / (Interfaces|Boundaries) / \(your name\) / Law", heading):
        return "laws.md"
    if heading.startswith("Harmos / Responses"):
        return "responses.md"
    if heading.startswith("Harmos Study"):
        return "study.md"
    return "outputs.md" if heading == "Outputs" else "scene.md"


def fenced(section: str) -> str:
    """A section with its snippets, which are indented for a terminal, as blocks of XML."""
    def fence(match: re.Match[str]) -> str:
        return "```xml\n" + re.sub(r"^    ", "", match[0], flags=re.MULTILINE).rstrip() + "\n```\n"
    return re.sub(r"(?:^    .*\n)+", fence, section, flags=re.MULTILINE)


def input_pages(harmos: str) -> dict[str, str]:
    sections: dict[str, list[str]] = {name: [] for name in INPUTS}
    for section in re.split(r"^(?=## )", output(harmos, "doc"), flags=re.MULTILINE)[1:]:
        heading = section.splitlines()[0].removeprefix("## ")
        page = page_of(heading)
        if page:
            sections[page].insert(0 if heading == "Laws" else len(sections[page]), fenced(section.rstrip() + "\n"))
    return {name: f"# {INPUTS[name][0]}\n\n{MADE}" + "\n".join(parts) for name, parts in sections.items()}


def command_line(harmos: str) -> str:
    verbs = re.findall(r"^  (\w+)  ", output(harmos, "--help").split("Commands:\n")[1].split("\n\n")[0], re.MULTILINE)
    parts = [f"# {VERBS[1]}\n\n{MADE}How scripts use the exit codes: [exit-codes.md](../guide/exit-codes.md).\n",
             output(harmos, "doc", "Exit Codes").rstrip() + "\n"]
    for verb in verbs:
        text = output(harmos, verb, "--help").split("\nExit codes:")[0].rstrip()
        parts.append(f"## harmos {verb}\n\n```\n{text}\n```\n")
    return "\n".join(parts)


def members(owner: object, name: str) -> list[tuple[str, object]]:
    """Public classes and functions of a module, or methods of a class, that it defines itself, in their order."""
    def is_own(key: str, value: object) -> bool:
        if key.startswith("_") and key not in ("__init__", "__getitem__", "__call__"):
            return False
        value = getattr(value, "__func__", value)
        return isinstance(value, property) or (inspect.isclass(value) or inspect.isfunction(value)) and \
            getattr(value, "__module__", None) == name
    return [(key, value) for key, value in vars(owner).items() if is_own(key, value)]


def signature(value: object) -> str:
    try:
        text = str(inspect.signature(value))  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return ""
    return re.sub(r"<(?:function|class) '?([\w.]+)'?[^>]*>", r"\1", text)


def text_block(text: str | None) -> str:
    return f"```text\n{inspect.cleandoc(text)}\n```\n" if text else ""


def modules_of(package: str) -> list[str]:
    """The public modules of a package, without those of packages in it that are no matter of users."""
    path = importlib.import_module(package).__path__
    found = [each for each in pkgutil.iter_modules(path, f"{package}.") if not each.name.split(".")[-1].startswith("_")]
    return [name for each in found for name in (
        [each.name, *(modules_of(each.name) if each.name in LIBRARIES else [])])]


def python_page() -> str:
    parts = [f"# {PYTHON[1]}\n\n{MADE}What it is for, with examples: [python.md](../guide/python.md).\n"]
    for name in sorted(["harmos", *modules_of("harmos")]):
        module = importlib.import_module(name)
        parts.append(f"## {name}\n\n{text_block(module.__doc__)}")
        for key, value in members(module, name):
            kind = "class " if inspect.isclass(value) else ""
            parts.append(f"### {kind}{name}.{key}\n\n`{key}{signature(value)}`\n\n{text_block(value.__doc__)}")
            if not inspect.isclass(value):
                continue
            for method, function in members(value, name):
                function = getattr(function, "__func__", function)
                shown = method if isinstance(function, property) else method + signature(function)
                parts.append(f"`{key}.{shown}`\n\n{text_block(function.__doc__)}")
    return "\n".join(parts)


def all_pages(harmos: str) -> dict[str, str]:
    pages = {**input_pages(harmos), VERBS[0]: command_line(harmos), PYTHON[0]: python_page()}
    rows = [*((name, *about) for name, about in INPUTS.items()), VERBS, PYTHON]
    lines = "".join(f"* [{title}]({name}): {summary}\n" for name, title, summary in rows)
    pages["README.md"] = (f"# Reference\n\n{MADE}{lines}\n`harmos doc TOPIC` prints one section of the first five. "
                          "C++: `cmake --build build --target docs`.\n")
    return pages


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--harmos", required=True)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    pages = all_pages(arguments.harmos)
    stale = [path for path in arguments.folder.glob("*") if path.name not in pages]
    if arguments.write:
        arguments.folder.mkdir(exist_ok=True)
        for path in stale:
            path.unlink()
        for name, text in pages.items():
            (arguments.folder / name).write_text(text)
        return 0
    different = [f"{path}: nothing makes this page\n" for path in stale]
    for name, text in pages.items():
        path = arguments.folder / name
        committed = path.read_text() if path.exists() else ""
        if committed != text:
            different += difflib.unified_diff(committed.splitlines(True), text.splitlines(True), str(path), "made", n=1)
    sys.stdout.writelines(different[:60])
    if different:
        print("\nThe reference is not up to date. Run: cmake --build build --target reference")
    return bool(different)


if __name__ == "__main__":
    sys.exit(main())
