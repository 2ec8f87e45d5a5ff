#!/usr/bin/python3
"""Kills a running study at random instants and resumes it; the end must be that of a study left in peace.

kill.py HARMOS STUDY.xml WORK_DIR KILLS [SEED]

After every kill the study file must be readable, and no configuration that the journal holds may be lost or solved
again but where the study has learned since that its estimate is too small. A study that ends before enough kills is started over.
"""
import csv
import json
import pathlib
import random
import shutil
import subprocess
import sys
import time
import zlib

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
from harmos import read_study

harmos, study, work, kills = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]), int(sys.argv[4])
seed = int(sys.argv[5]) if len(sys.argv) > 5 else time.time_ns() % 100000
print("seed", seed)
random.seed(seed)
name = pathlib.Path(study).stem
accuracy = 1e-4
options = ["--quiet", "--set", "Parameters/mu/Count=30", "--set", f"Accuracy={accuracy}"]


def command(directory):
    return [harmos, "study", study, "--output", str(directory), *options]


def journal(directory):
    """Ids of the complete records and whether each is known to have to be solved again, in their order; the last line
    may have been cut."""
    path = directory / f"{name}.journal"
    records = []
    if path.exists():
        for line in path.read_bytes().split(b"\n")[:-1]:
            checksum, text = line[:8], line[9:]
            assert int(checksum, 16) == zlib.crc32(text), "a damaged line"
            if text.startswith(b'{"id":'):
                record = json.loads(text)
                records.append((record["id"], record["status"], record["linear_stages"]))
    return records


def solved_again(before, after):
    """Ids solved after they had a result before, though nothing had opened them again."""
    latest = {id: (status, stages) for id, status, stages in before}
    wrong = set()
    for id, status, stages in after:
        was, spent = latest.get(id, ("reopened", 0))
        if status != "reopened" and was != "reopened" and stages != spent:
            wrong.add(id)
        latest[id] = (status, stages)
    return wrong


def rows(directory):
    with open(directory / f"{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
begin = time.time()
subprocess.run(command(work / "peace"), check=True)
duration = time.time() - begin
reference = rows(work / "peace")
print(f"{len(reference)} configurations, {duration:.2f} s in peace")

done, rounds = 0, 0
while done < kills:
    rounds += 1
    killed = work / "killed"
    shutil.rmtree(killed, ignore_errors=True)
    while True:
        before = journal(killed)
        process = subprocess.Popen(command(killed))
        try:
            # Most kills meet the solutions, some the start and the end.
            process.wait(random.uniform(0.0, 0.6 * duration) if done < kills else None)
            # 3: an audit may find more than was accepted, for what is solved after a kill is calibrated anew.
            assert process.returncode in (0, 3), process.returncode
            break
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            done += 1
        after = journal(killed)
        assert after[:len(before)] == before, "records are lost"
        assert not solved_again(before, after[len(before):]), "configurations are solved again"
        file = killed / f"{name}.h5"
        if file.exists():
            present = read_study(file)
            assert set(present.id[present.status != "open"]) <= {record[0] for record in after}
    assert {record[0] for record in journal(killed)} == set(range(1, len(reference) + 1)), "each configuration"
    final = read_study(killed / f"{name}.h5")
    assert final.state == "complete" and final.solved.all()
    result = rows(killed)
    differences = []
    for response in final.responses:
        expected = numpy.array([float(row[response]) for row in reference])
        found = numpy.array([float(row[response]) for row in result])
        differences.append(numpy.abs(found - expected).max() / numpy.abs(expected).max())
        assert differences[-1] <= 2 * accuracy, (response, differences[-1])
    left = [path.name for path in killed.iterdir() if ".partial." in path.name]
    print(f"round {rounds}: {done} kills, largest difference {max(differences):.1e}, left over: {left or 'nothing'}")
