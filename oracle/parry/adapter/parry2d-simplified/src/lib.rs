//! parry in floats, polygons as `from_convex_polyline` makes them: without the vertices that it
//! takes for collinear.

#[path = "../../parry/adapter.rs"]
mod adapter;
#[path = "../../parry/snippet.rs"]
mod snippet;

use adapter::{COMMON, collide};
use manifuzz_collider::{Body, Declaration, Claims, FLOAT32, Manifold, export};
use parry::shape::ConvexPolygon;
use snippet::snippet;

/// It makes none of fewer than three corners whose normals' product is at most 1 - sqrt(2^-23)
/// (parry2d, src/shape/convex_polygon.rs): that of an angle of 0.02628.
const LEAST_TURN: f64 = 0.0263;

const OURS: Declaration = Declaration {
    name: c"parry2d-simplified".as_ptr(),
    scalar: FLOAT32,
    snippet: snippet!("parry2d", "parry2d", "$x_f32, $y_f32", "", "radius@_f32", "from_convex_polyline"),
    claims: Claims { alters_shapes: 1, least_polygon_turn: LEAST_TURN, ..COMMON.claims },
    ..COMMON
};

fn collide_all(a: &Body, b: &Body) -> Option<Manifold> {
    collide(a, b, ConvexPolygon::from_convex_polyline, true)
}

export!(OURS, collide_all);
