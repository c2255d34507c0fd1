"""Work through executors: the same result whoever does it."""

import multiprocessing
import os
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, Panels, build, local_pool
from freecad_ortho.fabrication.workers import in_chunks, interpreter
from solver.errors import InputError


def squares(numbers):
    return [number**2 for number in numbers]


def process_numbers(items):
    return [os.getpid() for _ in items]


def test_chunks_keep_the_order():
    with ThreadPoolExecutor(3) as pool:
        for executor in (None, pool):
            seen = []
            made = in_chunks(squares, list(range(500)), executor, seen.append, size=7)
            assert made == [number**2 for number in range(500)]
            assert seen == sorted(seen)
    assert in_chunks(squares, []) == []


def test_progress_may_stop_the_work():
    def stop(fraction):
        raise KeyboardInterrupt

    with ThreadPoolExecutor(1) as pool, pytest.raises(KeyboardInterrupt):
        in_chunks(squares, list(range(500)), pool, stop)


@pytest.mark.parametrize("workers", [0, -2, 1000, 2.5])
def test_bad_numbers_of_workers(workers):
    words = f"workers: expected a whole number, 1 to 256, got {workers}"
    with pytest.raises(InputError, match=words), local_pool(workers):
        pass
    with pytest.raises(InputError, match="workers: expected a finite number, got 'many'"):
        local_pool("many").__enter__()


def test_no_pool_for_one():
    for workers in (None, 1):
        with local_pool(workers) as pool:
            assert pool is None


def test_interpreter_is_a_python_even_where_the_program_is_freecad(monkeypatch):
    import sys

    assert interpreter() == sys.executable
    monkeypatch.setattr(sys, "executable", "/usr/bin/freecad")
    assert "python" in os.path.basename(interpreter())


def nap(seconds):
    time.sleep(seconds[0])
    return seconds


@pytest.mark.slow
def test_stopping_drops_what_was_not_begun():
    with pytest.raises(KeyboardInterrupt), local_pool(2) as pool:
        assert in_chunks(nap, [0.0], pool) == [0.0]
        waiting = [pool.submit(nap, [1.0]) for _ in range(30)]
        raise KeyboardInterrupt
    assert sum(future.cancelled() for future in waiting) >= 20
    assert not multiprocessing.active_children()


@pytest.mark.slow
def test_pool_works_elsewhere_and_files_are_the_same(roof, tmp_path):
    structure = build(roof, [Beams(200, 12), Panels(20, 15)])
    with local_pool(2) as pool:
        assert os.getpid() not in in_chunks(process_numbers, list(range(8)), pool, size=2)
    folders = {}
    for name, workers in (("alone", None), ("together", 2)):
        folders[name] = api.write_fabrication(structure, tmp_path / name, workers=workers)
    for one, other in zip(*folders.values(), strict=True):
        assert one.read_bytes() == other.read_bytes(), one.name


@pytest.mark.slow
def test_dask_cluster_gives_the_same_files(roof, tmp_path):
    distributed = pytest.importorskip("distributed", reason="dask's distributed is not installed")
    structure = build(roof, [Beams(200, 12)])
    one = api.write_fabrication(structure, tmp_path / "alone")
    cluster = distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, processes=True, dashboard_address=None
    )
    with cluster, distributed.Client(cluster) as client:
        assert in_chunks(squares, [1, 2, 3], client.get_executor(), size=2) == [1, 4, 9]
        other = api.write_fabrication(
            structure, tmp_path / "cluster", executor=client.get_executor()
        )
    for first, second in zip(one, other, strict=True):
        assert first.read_bytes() == second.read_bytes()
