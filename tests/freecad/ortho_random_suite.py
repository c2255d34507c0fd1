"""Random sequences of what a user can do; the document must survive each. Run by FreeCAD.

ORTHO_TEST_SEQUENCES says how many (200 by default), ORTHO_TEST_SEED which is the first: a failure
names its seed and what was done, and ``ORTHO_TEST_SEED=17 ORTHO_TEST_SEQUENCES=1`` repeats it.
"""

import os
import unittest
from collections import Counter

import FreeCAD
import ortho_suite_tools as tools
from ortho_document_state import assert_same, snapshot
from ortho_random_actions import ACTIONS, Sequence

from freecad_ortho import documents

COUNT = int(os.environ.get("ORTHO_TEST_SEQUENCES", "200"))
FIRST = int(os.environ.get("ORTHO_TEST_SEED", "0"))
# They leave the document as it is or open one of their own,
UNTRIED = {"keep_outcome", "open_example", "save_picture"}
# stand behind others that are tried, or take long.
UNTRIED |= {"add_source", "add_structure", "dragging", "quads_from_mesh"}


class TestRandomSequences(unittest.TestCase):
    def tearDown(self):
        tools.close_all()

    def test_every_document_function_is_tried(self):
        tried = {action.__name__ for action in ACTIONS}
        missing = set(documents.__all__) - tried - UNTRIED
        self.assertFalse(missing, "give class Sequence a method of the same name for each")

    def test_documents_survive(self):
        done = Counter()
        for seed in range(FIRST, FIRST + COUNT):
            sequence = Sequence(seed)
            try:
                sequence.run()
                sequence.document.recompute()
                sequence.reopen()
                before = snapshot(sequence.document)
                for item in sequence.document.Objects:
                    item.touch()
                sequence.document.recompute()
                assert_same(before, snapshot(sequence.document), 1e-9)
            except Exception as error:
                raise AssertionError(f"seed {seed} after {', '.join(sequence.done)}") from error
            done.update(sequence.done)
            FreeCAD.closeDocument(sequence.document.Name)
        if COUNT >= 100:
            self.assertEqual(set(done), {action.__name__ for action in ACTIONS})
