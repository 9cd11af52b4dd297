"""The dtypes of manifuzz's arrays, and how arrays are looked at before they are used where they are."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _core


def _shape(scalar: DTypeLike) -> np.dtype[Any]:
    return np.dtype(
        [("vertices", scalar, (8, 2)), ("radius", scalar), ("count", np.int32), ("round", np.bool_)], align=True
    )


def _body(scalar: DTypeLike) -> np.dtype[Any]:
    return np.dtype([("shape", np.uint32), ("pose", scalar, 4)], align=True)


_feature = np.dtype([("kind", np.uint8), ("index", np.uint8)])


def _manifold(scalar: DTypeLike) -> np.dtype[Any]:
    point = np.dtype(
        [("position", scalar, 2), ("depth", scalar), ("features", [("a", _feature), ("b", _feature)])], align=True
    )
    return np.dtype(
        [("count", np.int32), ("reference", np.uint8), ("normal", scalar, 2), ("points", point, 2)], align=True
    )


shape32, shape64 = _shape(np.float32), _shape(np.float64)
body32, body64 = _body(np.float32), _body(np.float64)
manifold32, manifold64 = _manifold(np.float32), _manifold(np.float64)

_plain = np.dtype([("normal", np.float64), ("position", np.float64), ("depth", np.float64)])
_errors = np.dtype([(name, np.float64) for name in _core.components])
_figures = [
    ("touching", np.bool_),
    ("right_count", np.int32),
    ("separation", np.float64),
    ("depth", np.float64),
    ("normal", np.float64, 2),
    ("size", np.float64),
    ("magnitude", np.float64),
    ("bound", np.float64),
    ("errors", _errors),
    ("of_size", _plain),
    ("of_bound", _plain),
    ("right", manifold64),
]
judgement_record = np.dtype([("verdict", np.uint8), ("kind", np.uint8), *_figures], align=True)
verdicts, kinds = np.array(_core.verdicts), np.array(_core.kinds)
judgement = np.dtype([("verdict", verdicts.dtype), ("kind", kinds.dtype), *_figures], align=True)


def _in_words(array: Any) -> str:
    if not isinstance(array, np.ndarray):
        return f"a {type(array).__name__}"
    return f"{dtype_name(array.dtype)} of shape {array.shape}"


def dtype_name(dtype: np.dtype[Any]) -> str:
    """The name of one of the dtypes above, or numpy's."""
    for name in ("shape32", "shape64", "body32", "body64", "manifold32", "manifold64", "judgement"):
        if dtype == globals()[name]:
            return f"manifuzz.{name}"
    return dtype.name if dtype.names is None else f"another record ({', '.join(dtype.names)})"


def expect(name: str, array: Any, dtype: DTypeLike, shape: tuple[int | str, ...], hint: str = "") -> NDArray[Any]:
    """The array, if it has this dtype and this shape (a letter stands for any length) and lies in memory as C has it.

    Raises TypeError for another dtype, ValueError for another shape or layout; each says what would be right.
    """
    dtype = np.dtype(dtype)
    letters = f"({', '.join(str(length) for length in shape)}{',' if len(shape) == 1 else ''})"
    wanted = f"{name}: an array of {dtype_name(dtype)} and shape {letters} is expected"
    if not isinstance(array, (np.ndarray, np.void)) or array.dtype != dtype:
        raise TypeError(f"{wanted}, not {_in_words(array)}{hint and '; ' + hint}")
    given: NDArray[Any] = np.asarray(array)
    fits = len(given.shape) == len(shape) and all(
        isinstance(want, str) or have == want for have, want in zip(given.shape, shape)
    )
    if not fits:
        raise ValueError(f"{wanted}, not {_in_words(given)}")
    if not given.flags.c_contiguous or not given.flags.aligned:
        raise ValueError(f"{name}: its memory is not contiguous; numpy.ascontiguousarray({name}) makes a copy that is")
    return given


def rows(array: NDArray[Any], dtype: np.dtype[Any]) -> NDArray[np.uint8]:
    """The bytes of an array that `expect` let through, a row for each record of `dtype`; nothing is copied."""
    flat = array.reshape(-1) if array.size else np.empty(0, array.dtype)
    by_byte: NDArray[np.uint8] = flat.view(np.uint8).reshape(-1, dtype.itemsize)
    return by_byte


def parts(count: int, length: int) -> Iterator[slice]:
    """0 to `count` in slices of this length, for what ctrl-C should end between two of them."""
    for begin in range(0, count, length):
        yield slice(begin, min(begin + length, count))
