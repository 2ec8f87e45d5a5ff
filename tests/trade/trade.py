#!/usr/bin/env python3
"""What `harmos trade` recommends keeps its promise against a truth that it has not seen, and bad words are refused.

  trade.py HARMOS SCENE.xml FOLDER

The truth is a run with quadratic elements on a mesh finer than any that the trade may use.
"""
import csv
import fcntl
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import h5py

TARGETS = (0.05, 0.01)
TRUTH = {"Mesh/Order": "2", "Mesh/Refine": "4", "Steps/load/Increments": "8", "Solver/Accuracy": "1e-6",
         "Solver/Mesh Error": "false"}

harmos, scene, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)


def run(*words):
    return subprocess.run([harmos, *map(str, words)], capture_output=True, text=True, check=False)


def demand(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def final(path, *words):
    """The last row of the history of a run."""
    results = folder / "runs" / path.stem
    end = run("run", path, "--quiet", "--output", results, *words)
    demand(end.returncode == 0, f"{path} does not run: {end.stderr}")
    with open(results / f"{path.stem}_history.csv", newline="") as file:
        return {name: float(value) for name, value in list(csv.DictReader(file))[-1].items()}


def begun(output, **options):
    """A trade whose first run is certified, so that a further one is under way."""
    process = subprocess.Popen([harmos, "trade", str(scene), "--output", str(output), "--budget", "1h", "--targets", "2%"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **options)
    for line in process.stderr:
        if "certified" in line:
            break
    return process


truth = final(scene, *(word for entry, value in TRUTH.items() for word in ("--set", f"{entry}={value}")))
trade = run("trade", scene, "--output", folder, "--budget", "200s", "--targets", ",".join(f"{100 * t:g}%" for t in TARGETS))
print(trade.stderr, trade.stdout)
demand(trade.returncode == 0, "a target has no settings")
for target in TARGETS:
    file = folder / f"{scene.stem}_within_{100 * target:g}_percent.xml"
    values = final(file)
    for name in ("u", "v"):
        error = abs(values[name] - truth[name]) / abs(truth[name])
        print(f"{name} within {100 * target:g} %: {100 * error:.3f} % off")
        demand(error <= target, f"{name} is {100 * error:.3g} % off, {100 * target:g} % were promised")
base = folder / f"{scene.stem}_trade"
with open(f"{base}.csv", newline="") as file:
    rows = list(csv.DictReader(file))
demand(len(rows) >= 10 and any(float(row["u total_error"]) > 0.05 for row in rows), "there is no ladder")
demand(all(float(row["cpu_s"]) > 0 for row in rows if row["certified"] == "1"), "a run costs nothing")
with h5py.File(f"{base}.h5") as file:
    for name in ("u", "v"):
        response = file[f"responses/{name}"]
        off = abs(response["reference"][-1] - truth[name])
        demand(off <= response["uncertainty"][-1], f"the reference of {name} is off by {off:.3g}, more than it says")
        row = next(line.split() for line in trade.stdout.splitlines() if line.startswith(f"{name} "))
        demand(abs(float(row[2]) / response.attrs["size"] - 1) < 1e-4, f"errors of {name} are not relative to {row[2]}")
demand("<img" in pathlib.Path(f"{base}.html").read_text(), "the page has no picture")
demand(not [path for path in folder.iterdir() if path.name.startswith(".trade")], "runs were left behind")

for words, message in ((("--budget", "5"), "--budget"), (("--budget", "1e400s"), "--budget"), (("--budget", "1.2.3s"), "--budget"),
                       (("--targets", "1"), "--targets"), (("--memory", "8"), "--memory"),
                       (("--responses", "w"), "there are u, v")):
    end = run("trade", scene, "--output", folder / "refused", *words)
    demand(end.returncode == 2 and message in end.stderr and not os.path.exists(folder / "refused"), f"{words}: {end.stderr}")
mute = folder / "mute.xml"
mute.write_text(scene.read_text().split('  <ParameterList name="Responses">')[0] + "</ParameterList>")
end = run("trade", mute, "--output", folder / "mute")
demand(end.returncode == 2 and "no Responses" in end.stderr and not os.path.exists(folder / "mute"), end.stderr)
wrong = folder / "wrong.xml"
wrong.write_text(scene.read_text().replace("Friction Coefficient", "Friction Coeficient"))
end = run("trade", wrong, "--output", folder / "wrong")
demand(end.returncode == 2 and "Friction Coefficient" in end.stderr, end.stderr)
# Nothing holds the upper block sideways: the loads are beyond slip, nothing can be certified, and nothing is promised.
slipping = folder / "slipping.xml"
slipping.write_text(scene.read_text().replace('name="X" type="double" value="0.2"', 'name="X" type="double" value="0.5"'))
end = run("trade", slipping, "--output", folder / "slipping", "--budget", "20s", "--targets", "5%")
demand(end.returncode == 3 and "no settings" in end.stdout and not list((folder / "slipping").glob("*within*")),
       end.stdout + end.stderr)

# Interrupted in the middle: what an earlier trade has written stays, nothing of this one is left, and nothing runs on.
kept = {path: path.read_bytes() for path in folder.iterdir() if path.is_file()}
cut = begun(folder)
time.sleep(0.1)
cut.send_signal(signal.SIGTERM)
demand(cut.wait(timeout=10) == 130, f"a trade that was interrupted ends with {cut.returncode}")
demand({path: path.read_bytes() for path in folder.iterdir() if path.is_file()} == kept, "half a trade is left")
demand(not [path for path in folder.iterdir() if path.name.startswith(".trade")], "runs of half a trade are left")

# Ctrl-C comes to all of its processes, and may come again while they clean up.
cut = begun(folder / "cut", start_new_session=True)
while cut.poll() is None:
    os.killpg(cut.pid, signal.SIGINT)
    time.sleep(0.002)
patience = time.monotonic() + 10  # the program may be ended before what it has started has cleaned up
while list((folder / "cut").iterdir()):
    demand(time.monotonic() < patience, "runs of a trade that was interrupted over and over are left")
    time.sleep(0.02)

# Killed, it cannot clean up, the next one in the same folder does; one that runs beside it is left alone.
killed = begun(folder / "killed", start_new_session=True)
os.killpg(killed.pid, signal.SIGKILL)
killed.wait()
left = {path.name for path in (folder / "killed").glob(".trade_*")}
demand(len(left) == 1, f"a trade that was killed leaves {left}")
demand(not [path for path in (folder / "killed").iterdir() if path.name not in left], "a trade that was killed has results")
beside = folder / "killed" / ".trade_beside"
beside.mkdir()
with open(beside / "owner.lock", "wb") as owner:
    fcntl.flock(owner, fcntl.LOCK_EX)
    run("trade", scene, "--output", folder / "killed", "--budget", "1s", "--targets", "5%")
    demand({path.name for path in (folder / "killed").glob(".trade_*")} == {".trade_beside"}, "runs of a killed trade are left")

# A new trade replaces the old one, with settings for targets that this one has none for.
old = folder / "slipping" / "slipping_within_5_percent.xml"
old.write_text("<!-- settings of harmos trade for errors below 5 % in every response: x -->\n")
own = folder / "slipping" / "slipping_within_2_percent.xml"
own.write_text("<!-- mine -->\n")
end = run("trade", slipping, "--output", folder / "slipping", "--budget", "5s", "--targets", "5%")
demand(end.returncode == 3 and not old.exists() and own.exists(), "settings of an older trade are left")
