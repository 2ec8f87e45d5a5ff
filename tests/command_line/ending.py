#!/usr/bin/python3
"""Ends the program by signals in all of its phases: soon, with the documented exit code, and without litter.

ending.py HARMOS SCENES WORK_DIR: SCENES is the folder of the worked scenes.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

LONGEST = 1.0
"""Seconds until the process must have ended, as promised."""
SLACK = 2.0
"""Seconds by which a machine with other work may miss it."""
STARTED = 0.5
"""Seconds before which the system may not have started the program's own code; it is then ended by the signal."""

harmos, scenes, work = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
failures = 0


def end(name: str, number: int, delay: float, words: list[str], launcher: tuple[str, ...] = ()) -> float:
    """Ends `harmos words` after some seconds; returns how long that took. With a launcher, that is what is asked to end."""
    global failures
    output = work / "results"
    process = subprocess.Popen([*launcher, harmos, *words, "--output", str(output)], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
    time.sleep(delay)
    begin = time.monotonic()
    process.send_signal(number)
    try:
        _, text = process.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        process.kill()
        _, text = process.communicate()
    seconds = time.monotonic() - begin
    codes = {1} if launcher and number != signal.SIGUSR1 else {130} | ({-number} if delay <= STARTED else set())
    litter = [str(path) for path in output.glob("**/*.partial.*")]
    if process.returncode not in codes or seconds > LONGEST + SLACK or litter:
        failures += 1
        print(f"FAILED: {name}, signal {number} after {delay} s: exit code {process.returncode}, {seconds:.2f} s, "
              f"left over: {litter}, {text.decode()}")
    return seconds


# Each of these takes much longer than the largest delay: in one phase, or in several.
fine = ["--set", "Mesh/Refinement=6"]
cases = {
    "assembly and factorisation": ["run", str(scenes / "bolted_joint.xml"), "--quiet", *fine],
    "iteration": ["run", str(scenes / "bolted_joint.xml"), "--quiet", "--set", "Solver/Accuracy=1e-10",
                  "--set", "Solver/Algorithm=Plain", "--set", "Solver/Maximum Iterations=1000000000"],
    "study": ["study", str(scenes / "bolted_joint_study.xml"), "--quiet", "--set", "Scene/Mesh/Refinement=4"],
    "expansions": ["study", str(scenes / "glued_assembly_chaos.xml"), "--quiet", "--set", "Scene/Mesh/Cell Size=0.02"],
}
for name, words in cases.items():
    longest = max(end(name, number, delay, words)
                  for number, delay in ((signal.SIGTERM, 0.02), (signal.SIGINT, 0.6), (signal.SIGTERM, 1.5),
                                        (signal.SIGTERM, 4.0)))
    print(f"{name}: ended within {longest:.2f} s")
# Ctrl-C reaches all that a terminal has started, what the program starts besides included.
scene = scenes / "bolted_joint.xml"
subprocess.run([harmos, "run", str(scene), "--output", str(work / "solved"), "--quiet"], check=True)
for number in (signal.SIGINT, signal.SIGTERM):
    for delay in (1.0, 3.0):
        shutil.rmtree(work / "vtu", ignore_errors=True)
        process = subprocess.Popen([harmos, "export", str(work / "solved" / "bolted_joint.e"), "--output", str(work / "vtu")],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
        time.sleep(delay)
        os.killpg(process.pid, number)
        _, text = process.communicate(timeout=60)
        litter = list((work / "vtu").glob("*.partial.*"))
        if process.returncode not in (0, 130) or text or litter:
            failures += 1
            print(f"FAILED: export, signal {number} after {delay} s: exit code {process.returncode}, left over: {litter}, {text.decode()}")
# Of mpirun every rank ends so for SIGUSR1, and mpirun as they do; of SIGTERM it makes an end of its own.
ranks = ("mpirun", "-n", "2", "--oversubscribe")
for name in ("iteration", "study"):
    longest = max(end(f"{name} on two ranks", number, 3.0, cases[name], ranks)
                  for number in (signal.SIGUSR1, signal.SIGTERM))
    print(f"{name} on two ranks: ended within {longest:.2f} s")
sys.exit(failures > 0)
