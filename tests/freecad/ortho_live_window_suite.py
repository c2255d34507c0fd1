"""Steps of a dragged net that are made while FreeCAD's window lives on."""

import gc
import threading
import time
import types
import weakref

import numpy as np
from ortho_suite_cases import WindowCase
from ortho_suite_tools import wait
from PySide import QtCore

from freecad_ortho.panels.background import worker
from freecad_ortho.panels.live import Live
from solver.errors import InputError


class SlowSession:
    """Stands for a session whose steps take long."""

    def __init__(self):
        self.vertices, self.dragged = np.zeros((1, 3)), []

    def drag(self, places):
        time.sleep(0.3)
        self.dragged.append(places)
        if any(np.isnan(place).any() for place in places.values()):
            raise InputError("handle: no point")
        return types.SimpleNamespace(step_length=0.0)

    def settling(self):
        time.sleep(0.3)
        yield
        return "exact"


class TestLive(WindowCase):
    def setUp(self):
        super().setUp()
        self.session, self.shown, self.ends = SlowSession(), [], []
        self.live = Live(self.session, self.shown.append, lambda *end: self.ends.append(end))

    def test_the_window_lives_on_during_a_step_and_the_last_move_counts(self):
        ticks = []
        timer = QtCore.QTimer()
        timer.timeout.connect(lambda: ticks.append(time.perf_counter()))
        timer.start(5)
        self.live.aim({0: np.ones(3)})
        self.assertTrue(wait(lambda: self.live.busy, 5))
        self.live.aim({0: 2 * np.ones(3)})
        self.live.aim({0: 3 * np.ones(3)})
        self.assertTrue(wait(lambda: len(self.shown) >= 2, 5))
        self.assertLess(np.diff(ticks).max(), 0.2)
        self.assertEqual([places[0][0] for places in self.session.dragged[:2]], [1, 3])

    def test_what_is_given_up_during_a_step_ends_in_the_thread_of_the_window(self):
        """Its timer may not be deleted in another: FreeCAD crashes."""
        threads = []
        weakref.finalize(self.live, lambda: threads.append(threading.current_thread()))
        self.live.aim({0: np.ones(3)})
        self.assertTrue(wait(lambda: self.live.busy, 5))
        self.live.stop()
        self.live = None
        self.assertTrue(wait(lambda: threads, 5))
        self.assertEqual(threads, [threading.current_thread()])

    def test_garbage_is_collected_in_the_thread_of_the_window_alone(self):
        """Widgets and scenes of anyone's may be among it."""
        threads = set()

        def note(phase, info):
            threads.add(threading.current_thread())

        gc.callbacks.append(note)
        self.addCleanup(gc.callbacks.remove, note)
        made = worker.submit(lambda: [[[]] for _ in range(100_000)])
        self.assertTrue(wait(made.done, 20))
        self.assertTrue(wait(gc.isenabled, 5))
        self.assertEqual(threads, {threading.current_thread()})

    def test_what_was_stopped_is_not_told(self):
        self.live.aim({0: np.ones(3)})
        self.assertTrue(wait(lambda: self.live.busy, 5))
        self.live.stop()
        wait(lambda: bool(self.session.dragged), 5)
        wait(seconds=0.1)
        self.assertEqual(self.shown, [])
        self.live.aim({0: np.ones(3)})
        self.live.settle()
        self.assertTrue(self.live.settling)
        self.assertTrue(wait(lambda: bool(self.ends), 5))
        self.assertEqual(self.ends, [("exact", None)])
        self.assertFalse(self.live.settling)

    def test_taking_a_handle_up_again_ends_settling(self):
        self.live.aim({0: np.ones(3)})
        self.live.settle()
        self.assertTrue(wait(lambda: self.live.busy, 5))
        self.live.aim({0: 2 * np.ones(3)})
        self.assertTrue(wait(lambda: len(self.session.dragged) >= 2 and not self.live.busy, 5))
        self.assertEqual(self.ends, [])

    def test_an_error_in_a_step_ends_it_with_its_words(self):
        self.live.aim({0: np.full(3, np.nan)})
        self.assertTrue(wait(lambda: bool(self.ends), 5))
        self.assertEqual(self.ends, [(None, "handle: no point")])
        self.assertFalse(self.live.busy)
