"""Meshes, drawings and decks of other programs, made into a mesh and a starting scene of Harmos.

Readers make a `Mesh`; `start` writes a first scene for a bare mesh, `deck` one for what a deck of Abaqus or CalculiX
says. What is not taken over is listed in `Findings`, never dropped in silence.
"""
