#!/usr/bin/python3
"""The bolt diagram with a preload by force that a study varies, and that is random: bolts.py HARMOS WORK_DIR

Locked and without a load the bolt keeps its force F, and F / 336000 N/mm is what tightening has drawn together.
"""
import csv
import math
import pathlib
import shutil
import subprocess
import sys

from checks import check, finish

HARMOS, WORK = sys.argv[1], pathlib.Path(sys.argv[2])
SCENE = pathlib.Path(__file__).resolve().parents[1] / "verification" / "bolt_diagram" / "bolt.xml"
STIFFNESS = 420000.0 * 1680000.0 / (420000.0 + 1680000.0)
LOWER, UPPER = 10000.0, 20000.0
OLD = ('<Parameter name="Type" type="string" value="Preload Jump"/>\n'
       '        <Parameter name="Jump" type="double" value="0.05"/>')
NEW = ('<Parameter name="Type" type="string" value="Pretension"/>\n'
       '        <Parameter name="Force" type="double" value="15000"/>\n'
       '        <Parameter name="Locked From" type="double" value="1"/>')
STUDY = """<ParameterList name="Harmos Study">
  <Parameter name="Scene" type="string" value="bolt.xml"/>
  <Parameter name="Accuracy" type="double" value="1e-6"/>
  <ParameterList name="Parameters">
    <ParameterList name="force">
      <Parameter name="Entry" type="string" value="Interfaces/preload/Law/Force"/>
      <ParameterList name="Distribution">
        <Parameter name="Type" type="string" value="Uniform"/>
        <Parameter name="Lower" type="double" value="{lower}"/>
        <Parameter name="Upper" type="double" value="{upper}"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Design">
    <Parameter name="Type" type="string" value="{design}"/>{more}
  </ParameterList>
  <ParameterList name="Responses">
    <ParameterList name="F">
      <Parameter name="Response" type="string" value="bolt"/>
      <Parameter name="Type" type="string" value="Final"/>
    </ParameterList>
    <ParameterList name="o">
      <Parameter name="Response" type="string" value="overlap"/>
      <Parameter name="Type" type="string" value="Final"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
"""


def near(value, expected, tolerance, what):
    check(abs(value - expected) <= tolerance * abs(expected), f"{what}: {value!r} is not {expected!r} to {tolerance:g}")


def run(design, more="", pieces=1):
    """What is printed, and the folder of the results."""
    folder = WORK / f"{design}_{pieces}".lower()
    folder.mkdir(parents=True)
    text = SCENE.read_text().replace(OLD, NEW)
    assert NEW in text
    overlap = ('<ParameterList name="overlap"><Parameter name="Type" type="string" value="Overlap"/>'
               '<Parameter name="Interface" type="string" value="preload"/></ParameterList>')
    text = text.replace('<ParameterList name="Responses">', '<ParameterList name="Responses">' + overlap)
    text = text.replace('name="traction" type="double" value="0.0009090909090909091"', 'name="traction" type="double" value="0"')
    text = text.replace('<ParameterList name="bolt">\n      <Parameter name="Material"',
                        f'<ParameterList name="bolt">\n      <Parameter name="Pieces" type="int" value="{pieces}"/>\n'
                        '      <Parameter name="Material"')
    (folder / "bolt.xml").write_text(text)
    (folder / "study.xml").write_text(STUDY.format(lower=LOWER, upper=UPPER, design=design, more=more))
    done = subprocess.run([HARMOS, "study", str(folder / "study.xml"), "--output", str(folder / "out")],
                          capture_output=True, text=True)
    check(done.returncode == 0, f"{design}: exit code {done.returncode}, not 0\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr, folder / "out"


def moments(folder):
    with open(folder / "study_moments.csv", newline="", encoding="utf-8") as file:
        return {row["response"]: (float(row["mean"]), float(row["std"])) for row in csv.DictReader(file)}


shutil.rmtree(WORK, ignore_errors=True)
mean, deviation = (LOWER + UPPER) / 2.0, (UPPER - LOWER) / math.sqrt(12.0)
for pieces in (1, 2):
    _, out = run("Collocation", pieces=pieces)
    found = moments(out)
    for response, scale in (("F", 1.0), ("o", 1.0 / STIFFNESS)):
        near(found[response][0], mean * scale, 1e-5, f"mean of {response}, collocation")
        near(found[response][1], deviation * scale, 1e-5, f"deviation of {response}, collocation")
order = '\n    <Parameter name="Order" type="int" value="2"/>'
for pieces in (1, 8):
    _, out = run("Chaos", order, pieces=pieces)
    for response, scale in (("F", 1.0), ("o", 1.0 / STIFFNESS)):
        near(moments(out)[response][0], mean * scale, 1e-5, f"mean of {response}, chaos, {pieces} pieces")
        near(moments(out)[response][1], deviation * scale, 1e-5, f"deviation of {response}, chaos, {pieces} pieces")
finish()
