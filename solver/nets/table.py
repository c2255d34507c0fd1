"""The table of nets: a net is known everywhere by its entry here.

Every module of this folder that has ``NETS`` adds its own, :func:`register` one from elsewhere.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from solver.errors import InputError
from solver.nets.net import Measure, Net
from solver.option import one_of

NETS: dict[str, Net] = {}


def register(net: Net) -> Net:
    """Add a net: to the command line, the measures, the advisor, documents and panels.

    Raises:
        InputError: there is one of that name already.
    """
    if net.name in NETS:
        raise InputError(f"net: there is a net '{net.name}' already; choose another name")
    NETS[net.name] = net
    ordered = sorted(NETS.values(), key=lambda one: one.place)
    NETS.clear()
    NETS.update((one.name, one) for one in ordered)
    return net


def unregister(name: str) -> None:
    """Take a net out again.

    Raises:
        InputError: there is none of that name.
    """
    del NETS[net_named(name).name]


def net_named(name: str) -> Net:
    """The net of that name.

    Raises:
        InputError: there is none.
    """
    one_of("net", name, NETS)
    return NETS[name]


def nets_with(option: str) -> tuple[str, ...]:
    """Names of the nets that heed an option, or that have supports."""
    return tuple(name for name, net in NETS.items() if option in net.told)


def refuse_foreign(
    asked: Net, given: Iterable[str], written: Callable[[str], str] = lambda name: name
) -> None:
    """Refuse what is said of a net that does not heed it.

    Args:
        asked: the net.
        given: names of options that say something other than their defaults.
        written: what an option is called where it was given.

    Raises:
        InputError: naming the option and the nets that have it.
    """
    for name in given:
        if name not in asked.told:
            those = ", ".join(nets_with(name))
            raise InputError(
                f"{written(name)}: {f'only {those} nets have it' if those else 'no net has it'}, "
                f"not {asked.name}; leave it out"
            )


def all_measures(mixed: bool = False) -> dict[str, Measure]:
    """Every measure of every net, by name, each once; those of ``mixed`` faces alone."""
    nets = [net for net in NETS.values() if net.any_faces or not mixed]
    return {measure.name: measure for net in nets for measure in net.measures}


def _found() -> Iterator[Net]:
    """Nets of the modules beside this one."""
    for module in pkgutil.iter_modules([str(Path(__file__).parent)], "solver.nets."):
        if module.name != __name__:
            yield from getattr(importlib.import_module(module.name), "NETS", ())


for _net in _found():
    register(_net)
