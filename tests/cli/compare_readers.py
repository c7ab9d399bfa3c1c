"""Holds three readings of one run against each other: h5py, MDAnalysis and the exported text.

Usage: compare_readers.py TRAJECTORY EXPORT
Exits 0 when they agree: bit for bit, MDAnalysis to the single precision it keeps.
"""
import sys

import h5py
import MDAnalysis
import numpy as np


def exported_frames(path):
    """Positions and velocities of each frame of an extended XYZ file."""
    with open(path) as file:
        while line := file.readline():
            count = int(line)
            file.readline()
            rows = [file.readline().split() for _ in range(count)]
            numbers = np.array([row[1:7] for row in rows], dtype=float)
            yield numbers[:, :3], numbers[:, 3:]


trajectory, export = sys.argv[1:]
with h5py.File(trajectory) as file:
    balls = file["particles/balls"]
    positions = balls["position/value"][()]
    velocities = balls["velocity/value"][()]
    times = balls["position/time"][()]

universe = MDAnalysis.Universe.empty(positions.shape[1], trajectory=True, velocities=True)
universe.load_new(trajectory, format="H5MD", convert_units=False)
assert len(universe.trajectory) == len(positions)
for k, (frame, text) in enumerate(zip(universe.trajectory, exported_frames(export), strict=True)):
    assert abs(frame.time - times[k]) < 1e-6 * max(1, times[k])
    assert (frame.positions == positions[k].astype(np.float32)).all()
    assert (frame.velocities == velocities[k].astype(np.float32)).all()
    assert (text[0] == positions[k]).all()
    assert (text[1] == velocities[k]).all()
