#!/usr/bin/python3
"""Gives the program damaged files of every kind: exit code 0 or 2 within some seconds, no signal, nothing written.

program.py HARMOS SCENE.xml STUDY.xml WORK_DIR SECONDS

SCENE makes its own mesh. HARMOS_FUZZ_SECONDS and HARMOS_FUZZ_SEED go before what the command line says and seed 1. A
file that does worse stays in WORK_DIR/current.
"""
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time
import zlib

LONGEST = 60.0
"""Seconds for one command, on a machine that does much else."""

harmos, scene, study, work = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])
seconds = float(os.environ.get("HARMOS_FUZZ_SECONDS") or sys.argv[5])
chance = random.Random(int(os.environ.get("HARMOS_FUZZ_SEED") or 1))
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)


def run(*words: str) -> tuple[int, str]:
    """Exit code and what is printed, -99 when it takes too long."""
    try:
        result = subprocess.run([harmos, *words], capture_output=True, text=True, errors="replace", timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return -99, ""
    return result.returncode, result.stdout + result.stderr


def with_mesh_file(text: str, mesh: str) -> str:
    """The scene with its mesh from a file."""
    begin = text.index('<ParameterList name="Mesh">')
    depth = 0
    for tag in re.finditer(r"<ParameterList\b[^>]*?(/?)>|</ParameterList>", text[begin:]):
        depth += -1 if tag[0].startswith("</") else 0 if tag[1] else 1
        if depth == 0:
            break
    return (text[:begin] + '<ParameterList name="Mesh"><Parameter name="Type" type="string" value="Exodus"/>'
            f'<Parameter name="File" type="string" value="{mesh}"/></ParameterList>' + text[begin + tag.end():])


def damaged(content: bytes) -> bytes:
    """With one to three damages."""
    for _ in range(chance.randint(1, 3)):
        at = chance.randrange(len(content))
        size = chance.choice((1, 2, 4, 8))
        kind = chance.randrange(5)
        if kind == 0:
            content = content[:at] + bytes([content[at] ^ 1 << chance.randrange(8)]) + content[at + 1:]
        elif kind == 1:
            content = content[:at] + chance.choice((b"\0", b"\x7f", b"\x80", b"\xff")) * size + content[at + size:]
        elif kind == 2:
            content = content[:at] + chance.randbytes(size) + content[at + size:]
        elif kind == 3:
            content = content[:at] + content[at + chance.randrange(1, 64):]
        else:
            content = content[:at + 1]
    return content


def sealed(content: bytes) -> bytes:
    """With the checksum of a study file made anew: HDF5 itself must stand the damage."""
    return content + b"harmos:%08x\n" % zlib.crc32(content)


assert run("mesh", str(scene), "--output", str(work / "sound.e"))[0] == 0
assert run("study", str(study), "--output", str(work), "--quiet")[0] == 0
archive = next(work.glob("*.h5")).read_bytes()
(work / "with_file.xml").write_text(with_mesh_file(scene.read_text(), "current/damaged.e"))
current = work / "current"
current.mkdir()
files = {"damaged.e": (work / "sound.e").read_bytes(), "damaged.h5": archive[:-16],
         "damaged.xml": scene.read_bytes()}
commands = {
    "damaged.e": [["check", str(work / "with_file.xml"), "--quiet"],
                  ["compare", str(work / "sound.e"), str(current / "damaged.e")]],
    "damaged.h5": [["predict", str(current / "damaged.h5"), "--at", "mu=0.4", "--at", "pressure=20"],
                   ["report", str(current / "damaged.h5"), "--output", str(work / "page.html")]],
    "damaged.xml": [["check", str(current / "damaged.xml"), "--quiet"]],
}
for name, content in files.items():
    (current / name).write_bytes(sealed(content) if name.endswith("h5") else content)
    for words in commands[name]:
        code, text = run(*words)
        assert code == 0, (words, code, text)

begin, counts = time.monotonic(), dict.fromkeys((0, 1, 2), 0)
while time.monotonic() - begin < seconds:
    for name, content in files.items():
        broken = damaged(content)
        (current / name).write_bytes(sealed(broken) if name.endswith("h5") else broken)
        for words in commands[name]:
            code, text = run(*words)
            # A mesh of text that became large is too large for the memory, and says so.
            allowed = {0, 2} | ({1} if words[0] == "compare" or "not enough memory" in text else set())
            if code not in allowed or (code == 2 and not text) or "Traceback" in text:
                print(f"FAILED: harmos {' '.join(words)}: exit code {code}\n{text}")
                sys.exit(1)
            counts[code] += 1
print("commands by exit code:", counts)
