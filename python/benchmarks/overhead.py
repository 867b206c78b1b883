"""Compares a conversion from numpy with the same conversion in Rust: seconds and peak memory.

    python python/benchmarks/overhead.py target/release/triquad [TRIANGLES]

Both convert one torus with the same algorithm, in processes of their own and in turn. The time of
Rust is what `--stats` reports of building, pairing, augmentation and check; the time of Python is
that of `triquad.convert`, arrays in and arrays out. The memory of Python is the growth of the peak
during the call, that of Rust the peak of the process without the mesh that it reads. Linux and
macOS only.
"""

import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

import triquad

ALGORITHMS = ("tq", "best")
REPETITIONS = 5
PARTS = ("build_seconds", "pairing_seconds", "augmentation_seconds", "check_seconds")
# The most that Python may take over Rust, in time.
ALLOWED = 1.10


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


def peak_bytes() -> int:
    """Return the peak of this process."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else 1024 * peak


def measure_python(folder: pathlib.Path, algorithm: str) -> None:
    """Convert the arrays in `folder` and print seconds and bytes."""
    vertices, triangles = np.load(folder / "vertices.npy"), np.load(folder / "triangles.npy")
    before = peak_bytes()
    start = time.perf_counter()
    quads, _ = triquad.convert(vertices, triangles, algorithm=algorithm, threads=1)
    seconds = time.perf_counter() - start
    assert 2 * len(quads) == len(triangles)
    print(json.dumps({"seconds": seconds, "bytes": peak_bytes() - before}))


def run(command: list[str]) -> dict[str, float]:
    """Run a command that prints JSON."""
    return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)


def compare(program: str, folder: pathlib.Path, algorithm: str, mesh_bytes: int) -> bool:
    """Print one line for an algorithm; return whether Python is within the limits."""
    times: dict[str, list[float]] = {"rust": [], "python": []}
    memory: dict[str, list[float]] = {"rust": [], "python": []}
    for _ in range(REPETITIONS):
        command = [program, "convert", str(folder / "mesh.ply"), "--algorithm", algorithm]
        stats = run([*command, "--threads", "1", "--stats", "-"])
        times["rust"].append(sum(stats[part] for part in PARTS))
        memory["rust"].append(stats["peak_memory_bytes"] - mesh_bytes)
        ours = run([sys.executable, __file__, "--child", str(folder), algorithm])
        times["python"].append(ours["seconds"])
        memory["python"].append(ours["bytes"])
    rust, python = (statistics.median(times[side]) for side in ("rust", "python"))
    used = {side: statistics.median(memory[side]) / 1e6 for side in memory}
    print(
        f"{algorithm:5} seconds: Rust {rust:.3f}, Python {python:.3f}, ratio {python / rust:.3f}; "
        f"MB beside the mesh: Rust {used['rust']:.0f}, Python {used['python']:.0f}"
    )
    return python <= ALLOWED * rust and used["python"] <= used["rust"] + mesh_bytes / 1e6


def main() -> None:
    """Write the mesh once and compare both sides for each algorithm."""
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
        np.save(folder / "vertices.npy", vertices)
        np.save(folder / "triangles.npy", triangles)
        triquad.write(folder / "mesh.ply", vertices, triangles)
        print(f"{len(triangles)} triangles, medians of {REPETITIONS} runs, one thread")
        results = [compare(sys.argv[1], folder, name, mesh_bytes) for name in ALGORITHMS]
    sys.exit(not all(results))


if __name__ == "__main__":
    main()
