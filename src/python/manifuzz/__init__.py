"""Contact points of convex shapes by clipping, and the exact judge of anybody's.

Shapes have 1 to 8 vertices, counter-clockwise: polygons, with 2 vertices segments and capsules, with 1 circles.
A manifold says how two of them touch: 0, 1 or 2 points, each with its depth, and a unit normal from A to B. Points and
normals are in A's frame (`to_world` maps them), lengths in the unit of the shapes and poses.

Arrays are used where they are, without copies (`judge` makes doubles of answers that are floats): they must have the
dtypes that each function names, and be contiguous.
Names that end in 32 are of floats, those in 64 of doubles:

`shape32`, `shape64`
    ``vertices`` (8, 2), of which ``count`` are used; ``radius``, a length; ``round``, whether corners are round.
`body32`, `body64`
    ``shape``, an index; ``pose``: x and y of the position, cos and sin of the rotation.
`manifold32`, `manifold64`
    ``count``: 0, 1 or 2; ``reference``: whose face clips, 0 for A and 1 for B; ``normal`` (2,); ``points`` (2,), each
    with ``position`` (2,), ``depth`` >= 0, and ``features``: what of ``a`` and of ``b`` makes it, of ``kind`` 0
    (vertex) or 1 (face), and its ``index``. What is behind the last point is 0, and without points all else is.
`judgement`
    what `judge` gives.

`clip`, `clip64`, `batch`, `cases` and `judge` let other threads run meanwhile, which must not change their arrays.
"""

from ._arrays import body32, body64, judgement, manifold32, manifold64, shape32, shape64
from ._collide import Shapes, batch, clip, clip64, manifolds, shape, to_world
from ._judge import Cases, Declaration, cases, judge, regimes

__all__ = [
    "Cases",
    "Declaration",
    "Shapes",
    "batch",
    "body32",
    "body64",
    "cases",
    "clip",
    "clip64",
    "judge",
    "judgement",
    "manifold32",
    "manifold64",
    "manifolds",
    "regimes",
    "shape",
    "shape32",
    "shape64",
    "to_world",
]
