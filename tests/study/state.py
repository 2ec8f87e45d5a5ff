#!/usr/bin/python3
"""Prints how far a study is: state.py STUDY.h5"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "packages" / "python"))
from harmos import read_study

print(read_study(sys.argv[1]).state)
