"""What demo.py has FreeCAD run: sets Python's path, hands over to demo_document, answers.

The order comes as JSON in the environment variable ORTHO_DEMO. The answer is the word ``done`` or
one line that says what went wrong, in the file that the order names.
"""

import json
import os
import sys
import traceback
from pathlib import Path

ORDER = json.loads(os.environ["ORTHO_DEMO"])
# FreeCAD with a window empties PYTHONPATH when it starts.
sys.path[:0] = ORDER["paths"]

try:
    import demo_document

    demo_document.run(ORDER)
    answer = "done"
except Exception as error:  # whatever it is, the demo has to hear of it
    traceback.print_exc()
    answer = f"FreeCAD: {type(error).__name__}: {error}"
Path(ORDER["result"]).write_text(answer, encoding="utf-8")
sys.stdout.flush()
# Leave without being asked whether to save.
os._exit(0)
