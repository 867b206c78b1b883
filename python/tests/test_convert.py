"""Conversion, pairing, reduction: results, and calls from threads and under Ctrl-C."""

from __future__ import annotations

import dataclasses
import json
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import triquad
from surfaces import TETRAHEDRON, torus

with pytest.raises(ValueError, match="use one of: ") as _unknown:
    triquad.convert(*TETRAHEDRON, "no such algorithm")
ALGORITHMS = (*str(_unknown.value).partition("use one of: ")[2].split(", "), "lrs few-flips")
Command = Callable[..., str]


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_quads_are_those_of_the_command_byte_for_byte(
    algorithm: str, command: Command, tmp_path: Path
) -> None:
    given, ours, theirs, stats = (tmp_path / name for name in ("a.obj", "b.obj", "c.obj", "s.json"))
    triquad.write(given, *torus(12, 17))
    vertices, triangles = triquad.read(given)
    quads, report = triquad.convert(vertices, triangles, algorithm, seed=7)
    triquad.write(ours, vertices, quads)
    name, _, variant = algorithm.partition(" ")
    options = ["--algorithm", name, "--seed", 7, "--stats", stats]
    options += ["--lrs-variant", variant] if variant else []
    command("convert", given, "-o", theirs, *options)
    assert ours.read_bytes() == theirs.read_bytes()
    written = json.loads(stats.read_text())
    counts = report.to_dict()
    assert all(written[name] == counts[name] for name in counts if not name.endswith("seconds"))
    assert set(counts) <= {field.name for field in dataclasses.fields(report)}
    own = {"schema", "input", "read_seconds", "write_seconds", "peak_memory_bytes", "left_out"}
    assert set(written) - set(counts) == own


@pytest.mark.parametrize("cost", ["default", "shape"])
@pytest.mark.parametrize("augmentation", ["local", "tarjan", "rebuild"])
def test_options_reach_the_converter(cost: str, augmentation: str) -> None:
    vertices, triangles = torus(9, 10)
    quads, report = triquad.convert(
        vertices, triangles, "ps", cost=cost, augmentation=augmentation, seed=np.int64(3)
    )
    assert (report.augmentation, report.seed) == (augmentation, 3)
    assert triquad.check(quads, triangles).quads == len(triangles) // 2
    best = triquad.convert(vertices, triangles, cost=cost)[1]
    assert best.proved_least and best.summary.startswith("180 triangles (genus 1) -> 90 quads")


def strip(width: int, height: int) -> tuple[np.ndarray, np.ndarray]:
    """Return a rectangle of an odd number of triangles."""
    i, j = (x.ravel() for x in np.mgrid[: width + 1, : height + 1])
    corner = lambda i, j: i * (height + 1) + j  # noqa: E731
    i0, j0 = (x.ravel() for x in np.mgrid[:width, :height])
    a, b, c, d = corner(i0, j0), corner(i0 + 1, j0), corner(i0 + 1, j0 + 1), corner(i0, j0 + 1)
    triangles = np.column_stack((a, b, c, a, c, d)).reshape(-1, 3)
    return np.column_stack((i, j, 0 * i)).astype(float), triangles[:-1]


def test_open_surfaces_leave_the_fewest_triangles(command: Command, tmp_path: Path) -> None:
    vertices, triangles = strip(4, 5)
    with pytest.raises(triquad.MeshError, match="open=True converts it") as refused:
        triquad.convert(vertices, triangles)
    assert refused.value.law == "boundary-edge"
    with pytest.raises(ValueError, match="^algorithm: ds works on closed.*use one of: ") as closed:
        triquad.convert(vertices, triangles, "ds", open=True)
    for algorithm in str(closed.value).partition("use one of: ")[2].split(", "):
        quads, report = triquad.convert(vertices, triangles, algorithm, open=True)
        assert quads.shape == (19, 4) and report.leftover.shape == (1, 3)
        assert report.leftover_triangles == 1 and report.proved_fewest
        checked = triquad.check(quads, triangles, report.leftover)
        assert (checked.triangles, checked.euler_characteristic) == (1, 1)
    given, out = tmp_path / "a.obj", tmp_path / "b.obj"
    triquad.write(given, vertices, triangles)
    command("convert", given, "--open", "-o", out)
    quads, report = triquad.convert(vertices, triangles, open=True)
    faces = [line for line in out.read_text().splitlines() if line.startswith("f ")]
    ours = ["f " + " ".join(map(str, face + 1)) for face in (*quads, *report.leftover)]
    assert sorted(faces) == sorted(ours)


def test_edges_are_kept_and_the_others_are_given_up() -> None:
    vertices, triangles = TETRAHEDRON
    # Every perfect pairing removes two opposite edges, and one of them is at vertex 0.
    quads, report = triquad.convert(vertices, triangles, keep_edges=[[0, 1], [0, 2], [0, 3]])
    assert report.given_up.shape == (1, 2)
    assert (report.kept_edges, report.given_up_edges) == (3, 1)
    options = {"keep_edges": [[0, 1], [0, 2], [0, 3]], "strict": True}
    quads, report = triquad.convert(vertices, triangles, **options)
    assert (len(quads), len(report.leftover), len(report.given_up)) == (1, 2, 0)
    assert triquad.check(quads, triangles, report.leftover).triangles == 2
    _, report = triquad.convert(*TETRAHEDRON, keep_sharp=30.0)
    assert (report.kept_edges, report.given_up_edges) == (6, 2)
    with pytest.raises(ValueError, match=r"^keep_edges: row 1: \(0, 7\) is no edge"):
        triquad.convert(vertices, triangles, keep_edges=[[0, 1], [0, 7]])
    with pytest.raises(ValueError, match="^algorithm: edges to keep cannot be given to tq"):
        triquad.convert(vertices, triangles, "tq", keep_sharp=30)
    for wrong in (-1, 181, np.nan):
        with pytest.raises(ValueError, match="^keep_sharp: "):
            triquad.convert(vertices, triangles, keep_sharp=wrong)
    with pytest.raises(TypeError, match="^keep_sharp: "):
        triquad.convert(vertices, triangles, keep_sharp="30")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="^strict: "):
        triquad.convert(vertices, triangles, strict=True)


def test_costs_and_prices_decide() -> None:
    vertices, triangles = TETRAHEDRON
    # The edges in the order in which the triangles first pass them: 02, 21, 10, 13, 30, 23.
    quads, report = triquad.convert(vertices, triangles, cost=[9, 1, 9, 9, 1, 9])
    assert report.total_cost == 2
    assert triquad.convert(vertices, triangles, cost=[9, 9, 1, 9, 9, 1])[1].total_cost == 2
    quads, report = triquad.convert(vertices, triangles, cost=[9] * 6, quad_dominant=4)
    assert (len(quads), len(report.leftover)) == (0, 4)
    for price, left in ((-1000, 4), (1000, 0)):
        report = triquad.convert(vertices, triangles, quad_dominant=price)[1]
        assert report.leftover_triangles == left
    with pytest.raises(ValueError, match="^cost: "):
        triquad.convert(vertices, triangles, cost=[1, 2])
    with pytest.raises(ValueError, match="^cost: .*does not fit 32 bits"):
        triquad.convert(vertices, triangles, cost=[2**31] * 6)
    with pytest.raises(ValueError, match="^quad_dominant: "):
        triquad.convert(vertices, triangles, quad_dominant=np.nan)


def test_options_that_are_not_there_are_refused_by_name() -> None:
    with pytest.raises(ValueError, match="^algorithm: .*best, tq, sg"):
        triquad.convert(*TETRAHEDRON, "mst")
    with pytest.raises(ValueError, match="^augmentation: "):
        triquad.convert(*TETRAHEDRON, augmentation="none")
    with pytest.raises(ValueError, match="^cost: "):
        triquad.convert(*TETRAHEDRON, cost="none")
    with pytest.raises(ValueError, match="^seed: .*-1"):
        triquad.convert(*TETRAHEDRON, seed=-1)
    with pytest.raises(TypeError, match="^seed: "):
        triquad.convert(*TETRAHEDRON, seed=1.5)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="^algorithm: best needs vertices"):
        triquad.pair(TETRAHEDRON[1], "best")


def test_flipped_faces_are_turned_only_if_asked_for() -> None:
    vertices, triangles = torus(5, 6)
    triangles[3] = triangles[3, ::-1]
    with pytest.raises(triquad.MeshError) as refused:
        triquad.convert(vertices, triangles)
    assert refused.value.law == "inconsistent-orientation"
    assert refused.value.remedy == "orient=True flips faces until they agree"
    assert len(triquad.convert(vertices, triangles, orient=True)[0]) == len(triangles) // 2


@pytest.mark.parametrize("algorithm", ["tq", "sg", "ps", "ds", "gw"])
def test_pairs_are_the_triangles_of_the_quads(algorithm: str) -> None:
    vertices, triangles = torus(8, 11)
    pairs, report = triquad.pair(triangles, algorithm, seed=5)
    quads, _ = triquad.convert(vertices, triangles, algorithm, seed=5)
    assert np.array_equal(np.sort(pairs.ravel()), np.arange(len(triangles)))
    assert (pairs[:, 0] < pairs[:, 1]).all() and (np.diff(pairs[:, 0].astype(int)) > 0).all()
    for pair, quad in zip(pairs, quads, strict=True):
        assert set(triangles[pair].ravel()) == set(quad)
    assert report.quality_mean is None and report.quads == len(quads)


def test_flips_are_reported_with_their_triangulation() -> None:
    vertices, triangles = torus(20, 23, seed=2)
    quads, report = triquad.convert(vertices, triangles, "lrs")
    assert report.edge_flips > 0 and report.triangulation is not None
    assert triquad.check(quads, report.triangulation).quads == len(quads)
    assert "triangulation" not in report.to_dict()
    with pytest.raises(triquad.MeshError) as refused:
        triquad.check(quads, triangles)
    assert refused.value.law == "not-a-pair" and refused.value.element.kind == "face"


@pytest.mark.parametrize("algorithm", ["rs", "schipper", "brute-force"])
def test_irreducible_triangulations_are_those_of_the_command(
    algorithm: str, command: Command, tmp_path: Path
) -> None:
    given, ours, theirs = (tmp_path / name for name in ("a.off", "b.off", "c.off"))
    triquad.write(given, *torus(7, 9))
    vertices, triangles = triquad.read(given)
    left, report = triquad.irreducible(triangles, algorithm, seed=4)
    used, numbers = np.unique(left, return_inverse=True)
    triquad.write(ours, vertices[used], numbers.reshape(-1, 3))
    command("irreducible", given, "-o", theirs, "--algorithm", algorithm, "--seed", 4)
    assert ours.read_bytes() == theirs.read_bytes()
    assert (report.genus, report.result_vertices) == (1, len(used))
    assert report.to_dict()["contractions"] == 63 - len(used)


def test_simplified_meshes_are_those_of_the_command(command: Command, tmp_path: Path) -> None:
    # More vertices to be removed than in one step.
    given, ours, theirs = (tmp_path / name for name in ("a.ply", "b.ply", "c.ply"))
    triquad.write(given, *torus(130, 140))
    triquad.write(ours, *triquad.simplify(*triquad.read(given), 500))
    command("simplify", given, "-o", theirs, "--vertices", 500)
    assert ours.read_bytes() == theirs.read_bytes()
    with pytest.raises(ValueError, match="^vertex_count: .*ask for 4 or fewer"):
        triquad.simplify(*TETRAHEDRON, 5)
    with pytest.raises(ValueError, match="^vertex_count: .*ask for 4 or more"):
        triquad.simplify(*TETRAHEDRON, 3)


def test_eight_threads_at_once_get_the_same() -> None:
    vertices, triangles = torus(60, 70)
    with ThreadPoolExecutor(8) as pool:
        runs = [pool.submit(triquad.convert, vertices, triangles, "ps", seed=3) for _ in range(8)]
        quads = [run.result()[0] for run in runs]
    assert all(np.array_equal(quads[0], other) for other in quads)


@pytest.mark.parametrize("algorithm", ["best", "ps"])
def test_results_do_not_depend_on_the_number_of_threads(algorithm: str) -> None:
    vertices, triangles = torus(120, 130)
    one, report = triquad.convert(vertices, triangles, algorithm, threads=1)
    for threads in (2, 5, None):
        other, _ = triquad.convert(vertices, triangles, algorithm, threads=threads)
        assert np.array_equal(other, one)
    for wrong in (0, -1, 2000):
        with pytest.raises(ValueError, match="^threads: "):
            triquad.convert(vertices, triangles, threads=wrong)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no processes are forked here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_forked_process_converts_too() -> None:
    vertices, triangles = torus(60, 70)
    quads, _ = triquad.convert(vertices, triangles)
    child = os.fork()
    if child == 0:
        same = np.array_equal(triquad.convert(vertices, triangles)[0], quads)
        os._exit(0 if same else 1)
    assert os.waitpid(child, 0)[1] == 0


# Minutes of work on any machine.
SLOW = "triquad.convert(*torus(500, 500), 'sg', augmentation='rebuild')"


def test_other_threads_go_on_while_a_call_works() -> None:
    vertices, triangles = torus(300, 300)
    call = threading.Thread(
        target=triquad.convert, args=(vertices, triangles, "sg"), kwargs={"augmentation": "tarjan"}
    )
    call.start()
    steps = 0
    while call.is_alive():
        steps += 1
        time.sleep(0)
    assert steps > 10


@pytest.mark.skipif(sys.platform != "linux", reason="counts threads in /proc")
def test_ctrl_c_ends_a_long_call_and_its_work() -> None:
    program = f"""
        import os, signal, sys, time, triquad
        sys.path.insert(0, {str(Path(__file__).parent)!r})
        from surfaces import torus
        # Background jobs of a shell ignore interrupts, and so would this program.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        before = len(os.listdir("/proc/self/task"))
        print("ready", flush=True)
        try:
            {SLOW}
        except KeyboardInterrupt:
            pass
        else:
            sys.exit("not interrupted")
        while len(os.listdir("/proc/self/task")) > before:
            time.sleep(0.01)
        print("stopped", flush=True)
    """
    words = [sys.executable, "-c", textwrap.dedent(program)]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        try:
            output, _ = process.communicate(timeout=60)
        finally:
            process.kill()
        assert (process.returncode, output) == (0, "stopped\n")
