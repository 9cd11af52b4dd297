"""Shapes and their manifolds."""

from collections.abc import Callable
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _core
from ._arrays import body32, body64, expect, manifold32, manifold64, parts, rows, shape32, shape64

_Array = NDArray[Any]

# Python sees ctrl-C only between calls, so long batches are split into calls of this many pairs.
_PAIRS_AT_A_TIME = 100_000


def shape(
    vertices: ArrayLike, radius: ArrayLike = 0, *, round: ArrayLike = False, dtype: DTypeLike = np.float32
) -> _Array:
    """Shapes of `vertices`.

    vertices: (k, 2) for one shape, (n, k, 2) for n of k vertices each, 1 <= k <= 8: lengths in the shape's own frame,
        counter-clockwise, strictly convex. 2 are a segment or, with a radius, a capsule; 1 is a circle's centre.
    radius: a length >= 0, one or n: what is around the vertices; corners of polygons stay sharp unless `round`.
    round: whether corners are round, one or n. Circles and capsules always are.
    dtype: float32 for `clip` and `batch`, float64 for `clip64` and `batch`.

    Returns an array of `shape32` or `shape64`, of shape () or (n,). numpy.concatenate and numpy.stack join some.
    Raises ValueError where vertices are no convex shape, or are not finite, or a radius is no length.
    """
    scalar = np.dtype(dtype)
    if scalar not in (np.float32, np.float64):
        raise TypeError(f"dtype: float32 or float64 is expected, not {scalar}")
    given = np.asarray(vertices, scalar)
    if given.ndim not in (2, 3) or given.shape[-1] != 2 or not 1 <= given.shape[-2] <= 8:
        raise ValueError(f"vertices: shape (k, 2) or (n, k, 2), with k from 1 to 8, is expected, not {given.shape}")
    made = np.zeros(given.shape[:-2], shape32 if scalar == np.float32 else shape64)
    made["vertices"][..., : given.shape[-2], :] = given
    made["count"] = given.shape[-2]
    made["radius"] = radius
    made["round"] = round
    check = _core.check_shapes if scalar == np.float32 else _core.check_shapes64
    check(rows(made, made.dtype), "vertices")
    return made


def _shapes(name: str, given: Any, dtype: np.dtype[Any], other: str) -> _Array:
    """One shape or several, of this dtype or as the vertices of one."""
    scalar = dtype["radius"]
    if isinstance(given, np.ndarray) and given.dtype == scalar:
        return shape(given, dtype=scalar)
    dimensions = getattr(given, "ndim", 0)
    shape_of = ("n",) if dimensions else ()
    return expect(name, given, dtype, shape_of, f"{other} takes the other precision, and manifuzz.shape makes shapes")


def _bias(tie_bias: float) -> float:
    if not (isfinite(tie_bias) and tie_bias >= 0):
        raise ValueError(f"tie_bias: a length of 0 or more is expected, not {tie_bias}")
    return float(tie_bias)


def _out(out: _Array | None, dtype: np.dtype[Any], shape_of: tuple[int, ...]) -> _Array:
    if out is None:
        return np.empty(shape_of, dtype)
    array = expect("out", out, dtype, shape_of)
    if not array.flags.writeable:
        raise ValueError("out: it is read-only; an array that can be written to is expected")
    return array


def _clip(
    core: Callable[..., None],
    scalar: DTypeLike,
    other: str,
    a: Any,
    b: Any,
    poses: Any,
    tie_bias: float,
    out: _Array | None,
) -> _Array:
    is_float = scalar == np.float32
    shapes = shape32 if is_float else shape64
    of_a, of_b = _shapes("a", a, shapes, other), _shapes("b", b, shapes, other)
    is_one = getattr(poses, "ndim", 3) == 2 and of_a.ndim == of_b.ndim == 0
    poses = expect("poses", poses, scalar, (2, 4) if is_one else ("n", 2, 4), f"{other} takes the other precision")
    count = 1 if is_one else len(poses)
    for name, of in (("a", of_a), ("b", of_b)):
        if of.ndim and len(of) != count:
            raise ValueError(f"{name}: {len(of)} shapes for {count} pairs; one, or one a pair, is expected")
    bias = _bias(tie_bias)
    manifold = manifold32 if is_float else manifold64
    result = _out(out, manifold, () if is_one else (count,))
    pair = np.dtype((scalar, (2, 4)))
    for some in parts(count, _PAIRS_AT_A_TIME):
        core(
            rows(of_a, shapes),
            rows(of_b, shapes),
            rows(poses, pair),
            bias,
            rows(result, manifold),
            some.start,
            some.stop,
        )
    return result


def clip(a: _Array, b: _Array, poses: _Array, *, tie_bias: float = 0.0, out: _Array | None = None) -> _Array:
    """The manifolds of pairs of shapes, in float.

    a, b: one shape for all pairs or n, `shape32` of shape () or (n,); or the vertices of one, float32 of shape (k, 2).
    poses: float32 of shape (n, 2, 4), or (2, 4) of one pair: of A and of B x and y of the position in the world, a
        length, and cos and sin of the rotation.
    tie_bias: B's face is taken only where its separation is greater by more than this length. 0 in the article.
    out: where manifolds are written to; else an array is made.

    Returns `manifold32` of shape (n,), or () of one pair.
    Raises TypeError for another dtype; ValueError for another shape, for memory that is not contiguous, for a shape
    that is not convex or not finite, and for (cos, sin) that is not of length 1 within 5e-6.
    """
    return _clip(_core.clip, np.float32, "clip64", a, b, poses, tie_bias, out)


def clip64(a: _Array, b: _Array, poses: _Array, *, tie_bias: float = 0.0, out: _Array | None = None) -> _Array:
    """The manifolds of pairs of shapes, in double.

    a, b, poses, tie_bias and out are as `clip` has them, but `shape64` or float64, and `manifold64`. Rotations are
    divided by their lengths, which floats leave off 1 by 6e-8, and shapes are as many times as large.

    Returns `manifold64` of shape (n,), or () of one pair. Raises as `clip` does.
    """
    return _clip(_core.clip64, np.float64, "clip", a, b, poses, tie_bias, out)


class Shapes:
    """The shapes of a batch, checked and laid out once, for many calls of `batch`.

    shapes: `shape32` or `shape64` of shape (k,). Raises as `clip` does.
    """

    def __init__(self, shapes: _Array) -> None:
        is_double = getattr(shapes, "dtype", None) == shape64
        self.scalar = np.dtype(np.float64 if is_double else np.float32)
        dtype = shape64 if is_double else shape32
        array = expect("shapes", shapes, dtype, ("k",), "manifuzz.shape makes shapes")
        self._core = (_core.LaidOut64 if is_double else _core.LaidOut32)(rows(array, dtype))

    def __len__(self) -> int:
        return len(self._core)


def batch(
    shapes: Shapes | _Array, bodies: _Array, pairs: _Array, *, tie_bias: float = 0.0, out: _Array | None = None
) -> _Array:
    """The manifolds of many pairs of bodies, at the speed of the kernel: those of `clip`, bit for bit.

    shapes: what bodies refer to: `shape32` or `shape64` of shape (k,), or `Shapes` of them, which spares laying them
        out again.
    bodies: of shape (m,), `body32`, or `body64` where shapes are doubles. Positions are in the world.
    pairs: uint32 of shape (n, 2): A's index among the bodies, and B's.
    tie_bias, out: as `clip` has them.

    Returns `manifold32` or `manifold64` of shape (n,), each in the frame of its A. Rotations are taken to be of
    length 1.
    Raises TypeError and ValueError as `clip` does, and ValueError for an index of no shape or no body.
    """
    laid_out = shapes if isinstance(shapes, Shapes) else Shapes(shapes)
    is_float = laid_out.scalar == np.float32
    body, manifold = (body32, manifold32) if is_float else (body64, manifold64)
    bodies = expect("bodies", bodies, body, ("m",), f"the shapes are of {laid_out.scalar}")
    pairs = expect("pairs", pairs, np.uint32, ("n", 2), "pairs.astype(numpy.uint32) makes them")
    result = _out(out, manifold, (len(pairs),))
    two = np.dtype((np.uint32, 2))
    _core.batch(laid_out._core, rows(bodies, body), rows(pairs, two), _bias(tie_bias), rows(result, manifold))
    return result


def manifolds(counts: ArrayLike, normals: ArrayLike, positions: ArrayLike, depths: ArrayLike) -> _Array:
    """Manifolds of an engine of your own, for `judge`.

    counts: (n,), of points: 0, 1 or 2, or whether there is one. normals: (n, 2), unit. positions: (n, 2, 2).
    depths: (n, 2), lengths >= 0.

    Returns `manifold64` of shape (n,). Raises ValueError where shapes do not fit, TypeError where counts are no
    integers.
    """
    counts = np.asarray(counts)
    if counts.size > 0 and counts.dtype.kind not in "biu":
        raise TypeError(f"counts: {counts.dtype}; integers are expected")
    n = counts.size
    expected = (("counts", counts, (n,)), ("normals", normals, (n, 2)), ("positions", positions, (n, 2, 2)))
    for name, given, shape in (*expected, ("depths", depths, (n, 2))):
        if np.shape(given) != shape:
            raise ValueError(f"{name}: shape {np.shape(given)}; {shape} is expected")
    made = np.zeros(n, manifold64)
    made["count"] = counts
    made["normal"] = normals
    made["points"]["position"] = positions
    made["points"]["depth"] = depths
    return made


def to_world(poses: _Array, manifolds: _Array) -> tuple[_Array, _Array]:
    """Points and normals of manifolds in the world.

    poses: (n, 2, 4) of float32 or float64, of which A's count. manifolds: (n,), of either dtype.

    Returns positions, float64 of shape (n, 2, 2), of which `count` are points, and unit normals, float64 of
    shape (n, 2).
    """
    of_a = np.asarray(poses, np.float64)[..., 0, :]
    cos, sin = of_a[..., 2], of_a[..., 3]
    turn = np.stack([np.stack([cos, -sin], -1), np.stack([sin, cos], -1)], -2)
    positions = np.asarray(manifolds["points"]["position"], np.float64) @ np.swapaxes(turn, -1, -2)
    normals = np.einsum("...ij,...j", turn, np.asarray(manifolds["normal"], np.float64))
    return positions + of_a[..., None, :2], normals / np.hypot(cos, sin)[..., None]
