"""Opens a STEP file and says how long that took. Run by FreeCAD.

``scripts/bench_step.py`` starts it and says in ORTHO_STEP which file and how.
"""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

import FreeCAD
import Import

ORDER = json.loads(os.environ["ORTHO_STEP"])
PREFERENCES = "User parameter:BaseApp/Preferences/Mod/Import"
FreeCAD.ParamGet(f"{PREFERENCES}/hSTEP").SetBool("ReadShapeCompoundMode", False)
# Where it is depends on FreeCAD's release.
for group in (PREFERENCES, f"{PREFERENCES}/hSTEP"):
    FreeCAD.ParamGet(group).SetBool("UseLinkGroup", ORDER["links"])
begin = time.process_time()
Import.open(ORDER["path"])
seconds = time.process_time() - begin
labels = [thing.Label for thing in FreeCAD.ActiveDocument.Objects]
Path(ORDER["answer"]).write_text(json.dumps({"seconds": seconds, "labels": labels}))
# Closing ten thousand objects takes longer than there is to learn from it.
os._exit(0)
