import sys, os, pathlib
sys.path.insert(0, os.getcwd())
from tests.freecad.test_freecad_suites import *
import tests.freecad.test_freecad_suites as t
name=sys.argv[1]; d=pathlib.Path(sys.argv[2]); d.mkdir(parents=True,exist_ok=True)
import inspect
prog=[t.SCREEN,"-a","-s","-screen 0 1400x900x24",t.WINDOW] if "window" in name else [t.CONSOLE]
r,s=t.run_suite(prog, name, d, d)
print(r); print(s[-3000:])
