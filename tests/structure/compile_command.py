"""Compile commands of a build, applied to other sources."""
import json
import pathlib
import shlex
import subprocess


def commands(build):
    """The commands of a build by source, without source and output."""
    found = {}
    for entry in json.loads((pathlib.Path(build) / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        source = words.pop(words.index("-c") + 1)
        del words[words.index("-o"):words.index("-o") + 2]
        words.remove("-c")
        found[source] = words
    return found


def check(command, text, folder):
    """What the compiler says about a source with this text, None if it accepts it. Nothing is written."""
    done = subprocess.run([*command, "-fsyntax-only", "-x", "c++", "-"], input=text, cwd=folder, capture_output=True,
                          text=True)
    return None if done.returncode == 0 else done.stderr


def include(header):
    return f"#include <harmos/{header}>\n"
