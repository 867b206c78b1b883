"""Compares a conversion from numpy with the same call of the library: seconds and peak memory.

    python python/benchmarks/overhead.py target/release/examples/library [TRIANGLES]

Both sides take the same arrays from memory and end with the quads and the report; each run is a
process of its own, and the two sides take turns. Python begins with numpy arrays of `float64` and
`int64`, Rust with a mesh that the call may keep. The memory of a side is the growth of its peak
during the call. Rust has what it needs beside the mesh; Python may have as much, and the mesh that
it makes of the arrays. One thread, for repeatable times. Linux only.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import triquad

ALGORITHMS = ("tq", "best")
ROUNDS = 9
LIMIT = 1.1


def torus(triangles: int) -> tuple[np.ndarray, np.ndarray]:
    """Return vertices and triangles of a torus, numbered at random like a scan."""
    rows = max(3, round((triangles / 4) ** 0.5))
    columns = max(3, triangles // (2 * rows))
    row, column = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    u, v = 2 * np.pi * row / rows, 2 * np.pi * column / columns
    wide = 3 + np.cos(u)
    vertices = np.stack([wide * np.cos(v), wide * np.sin(v), np.sin(u)], axis=-1).reshape(-1, 3)
    here, right = row * columns + column, row * columns + (column + 1) % columns
    below = (row + 1) % rows * columns
    down, across = below + column, below + (column + 1) % columns
    halves = [np.stack([here, down, right], -1), np.stack([right, down, across], -1)]
    faces = np.concatenate([half.reshape(-1, 3) for half in halves])
    random = np.random.default_rng(7)
    name = random.permutation(len(vertices))
    renamed = np.empty_like(vertices)
    renamed[name] = vertices
    return renamed, random.permutation(name[faces])


def memory(name: str) -> int:
    """Return bytes of this process from a line of the kernel's account."""
    lines = pathlib.Path("/proc/self/status").read_text().splitlines()
    return 1024 * int(next(line.split()[1] for line in lines if line.startswith(name)))


def measure_python(folder: pathlib.Path, algorithm: str) -> None:
    """Convert the arrays in `folder` and print seconds and bytes."""
    vertices = np.fromfile(folder / "vertices").reshape(-1, 3)
    triangles = np.fromfile(folder / "triangles", np.int64).reshape(-1, 3)
    before = memory("VmRSS")
    start = time.perf_counter()
    quads, _ = triquad.convert(vertices, triangles, algorithm, threads=1)
    seconds = time.perf_counter() - start
    assert 2 * len(quads) == len(triangles)
    print(json.dumps({"seconds": seconds, "bytes": memory("VmHWM") - before}))


def run(command: list[str]) -> dict[str, float]:
    """Run a command that prints JSON."""
    environment = {**os.environ, "RAYON_NUM_THREADS": "1"}
    done = subprocess.run(command, check=True, stdout=subprocess.PIPE, env=environment)
    return json.loads(done.stdout)


def compare(program: str, folder: pathlib.Path, algorithm: str, mesh_bytes: int) -> bool:
    """Print one line for an algorithm; return whether time and memory are within the limits."""
    here = [sys.executable, __file__, "--child", str(folder), algorithm]
    there = [program, str(folder), algorithm]
    rounds = [(run(there), run(here)) for _ in range(ROUNDS)]
    ratios = sorted(python["seconds"] / rust["seconds"] for rust, python in rounds)
    ratio = statistics.median(ratios)
    rust, python = (
        {key: statistics.median(both[side][key] for both in rounds) for key in rounds[0][side]}
        for side in (0, 1)
    )
    print(
        f"{algorithm:5} Python {python['seconds']:.3f} s, Rust {rust['seconds']:.3f} s; "
        f"ratio {ratio:.3f}, from {ratios[0]:.3f} to {ratios[-1]:.3f}; "
        f"MB of Python {python['bytes'] / 1e6:.1f}, of Rust {rust['bytes'] / 1e6:.1f} "
        f"and the mesh {mesh_bytes / 1e6:.1f}",
        flush=True,
    )
    return ratio <= LIMIT and python["bytes"] <= rust["bytes"] + mesh_bytes


def main() -> None:
    """Write the arrays once and compare both sides for each algorithm."""
    if sys.argv[1:2] == ["--child"]:
        measure_python(pathlib.Path(sys.argv[2]), sys.argv[3])
        return
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    vertices, triangles = torus(int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000)
    # As the library holds them: 24 bytes a vertex, 12 a triangle.
    mesh_bytes = 24 * len(vertices) + 12 * len(triangles)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        vertices.astype("<f8").tofile(folder / "vertices")
        triangles.astype("<i8").tofile(folder / "triangles")
        print(f"{len(triangles)} triangles, medians of {ROUNDS} rounds, one thread")
        results = [compare(sys.argv[1], folder, name, mesh_bytes) for name in ALGORITHMS]
    sys.exit(not all(results))


if __name__ == "__main__":
    main()
