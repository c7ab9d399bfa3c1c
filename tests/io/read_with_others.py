"""Opens a made-up run (tests/io/made_up_run.hpp) as its users would: with h5py and MDAnalysis.

Usage: read_with_others.py FILE COUNT FRAMES BOUNDARY
Exits 0 when every number is the one that was written.
"""
import sys

import h5py
import MDAnalysis
import numpy as np


def distinct(a, b, c):
    return (1 + a + 7 * b + 1000 * c) / 3.0


def made_up(count, frame):
    axis, ball = np.meshgrid(np.arange(3), np.arange(count))
    return (distinct(axis, ball, frame), -distinct(axis, ball, frame + 1), frame - axis)


def check(holds, what):
    if not holds:
        sys.exit(f"differs: {what}")


path, count, frames, boundary = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), sys.argv[4]

with h5py.File(path, "r", libver="latest", swmr=True) as file:
    check(tuple(file["h5md"].attrs["version"]) == (1, 1), "h5md version")
    check(file["h5md/creator"].attrs["name"] == b"clack", "creator")
    balls = file["particles/balls"]
    check(list(balls["box"].attrs["boundary"]) == [boundary.encode()] * 3, "boundary")
    check(("image" in balls) == (boundary == "periodic"), "image")
    check(balls["position/value"].dtype == np.float64, "double precision")
    check(balls["position/value"].shape == (frames, count, 3), "shape")
    check(balls["velocity/step"] == balls["position/step"], "step is a hard link")
    for k in range(frames):
        position, velocity, image = made_up(count, k)
        check((balls["position/value"][k] == position).all(), f"position of frame {k}")
        check((balls["velocity/value"][k] == velocity).all(), f"velocity of frame {k}")
        check(boundary == "none" or (balls["image/value"][k] == image).all(), f"image {k}")
        check(balls["position/step"][k] == 10 * k, f"step of frame {k}")
        check(balls["position/time"][k] == k * 0.1, f"time of frame {k}")
        check(file["observables/kinetic_energy/value"][k] == distinct(3, k, 0), f"energy {k}")
        check(file["samples/virial"][k] == distinct(1, k, 0), f"virial {k}")
        check(file["events/velocity_j"][k, 2] == distinct(2, k, 0), f"event {k}")
    check(b"made up" in file["parameters/scene"][()], "scene")

universe = MDAnalysis.Universe.empty(count, trajectory=True, velocities=True)
universe.load_new(path, format="H5MD", convert_units=False)
check(len(universe.trajectory) == frames, "number of frames in MDAnalysis")
for k, frame in enumerate(universe.trajectory):
    position, velocity, _ = made_up(count, k)
    check((universe.atoms.positions == position.astype(np.float32)).all(), "MDAnalysis positions")
    check((universe.atoms.velocities == velocity.astype(np.float32)).all(), "velocities")
    check(abs(frame.time - k * 0.1) < 1e-6, "MDAnalysis time")
    if boundary == "periodic":
        check(np.allclose(frame.dimensions, [20, 20, 20, 90, 90, 90]), "MDAnalysis dimensions")
    check(frame.data["ball_collisions"] == 10 * k, "MDAnalysis observables")
