"""Formulas that a user types, e.g. ``-3.5 + sin(pi*s)``: arithmetic only, nothing else runs."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Mapping

import numpy as np

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

Formula = Callable[[Mapping[str, FloatArray | float]], FloatArray | float]

_OPERATORS: dict[type, Callable[..., FloatArray]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}
_FUNCTIONS: dict[str, Callable[[FloatArray], FloatArray]] = {
    name: getattr(np, name)
    for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs")
}
# No formula of a curve is longer, and what is may be meant to keep the reader of it busy.
_LONGEST = 300


def formula(text: str, names: tuple[str, ...]) -> Callable[..., FloatArray]:
    """A function of the named values, given by keyword, from the text of a formula.

    Args:
        text: numbers, the names, pi, + - * / ** ( ), and sin cos tan sinh cosh tanh exp log sqrt
            abs.
        names: what the formula may use.

    Raises:
        InputError: anything else, or (when called) a result that is not finite.
    """
    try:
        tree = (
            ast.parse(text.strip().replace("^", "**"), mode="eval")
            if len(text) <= _LONGEST
            else None
        )
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        tree = None
    if tree is None:
        raise InputError(f"formula: '{text[:40]}' cannot be read; write e.g. 0.5 + 0.2*sin(pi*s)")
    _check(tree.body, text, names)

    def value(**given: FloatArray | float) -> FloatArray:
        with np.errstate(all="ignore"):
            result = np.asarray(_value(tree.body, {**given, "pi": np.pi}), dtype=np.complex128)
        if not np.isfinite(result).all() or (result.imag != 0).any():
            raise InputError(f"formula: '{text}' is not a finite number everywhere; mend it")
        return np.asarray(result.real)

    return value


def _check(part: ast.expr, text: str, names: tuple[str, ...]) -> None:
    if isinstance(part, ast.BinOp) and type(part.op) in _OPERATORS:
        _check(part.left, text, names)
        _check(part.right, text, names)
    elif isinstance(part, ast.UnaryOp) and type(part.op) in _OPERATORS:
        _check(part.operand, text, names)
    elif isinstance(part, ast.Call) and isinstance(part.func, ast.Name) and len(part.args) == 1:
        if part.func.id not in _FUNCTIONS or part.keywords:
            raise _unknown(part.func.id, text, names)
        _check(part.args[0], text, names)
    elif isinstance(part, ast.Name):
        if part.id not in (*names, "pi"):
            raise _unknown(part.id, text, names)
    elif not (isinstance(part, ast.Constant) and type(part.value) in (int, float)):
        raise _unknown(ast.unparse(part)[:20], text, names)


def _unknown(word: str, text: str, names: tuple[str, ...]) -> InputError:
    return InputError(
        f"formula: '{word}' in '{text[:40]}' is not allowed; use {', '.join(names)}, pi, "
        f"+ - * / ** and {', '.join(_FUNCTIONS)}"
    )


def _value(part: ast.expr, given: Mapping[str, FloatArray | float]) -> FloatArray | float:
    if isinstance(part, ast.BinOp):
        return _OPERATORS[type(part.op)](_value(part.left, given), _value(part.right, given))
    if isinstance(part, ast.UnaryOp):
        return _OPERATORS[type(part.op)](_value(part.operand, given))
    if isinstance(part, ast.Call) and isinstance(part.func, ast.Name):
        return _FUNCTIONS[part.func.id](np.asarray(_value(part.args[0], given)))
    if isinstance(part, ast.Name):
        return given[part.id]
    assert isinstance(part, ast.Constant)
    return np.asarray(part.value, dtype=np.float64)
