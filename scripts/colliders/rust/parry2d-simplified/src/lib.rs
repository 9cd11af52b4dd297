//! parry in floats, polygons as `from_convex_polyline` makes them: without the vertices that it
//! takes for collinear.

#[path = "../../parry/adapter.rs"]
mod adapter;

use adapter::{COMMON, collide};
use manifuzz_collider::{Body, Declaration, Claims, FLOAT32, Manifold, export};
use parry::shape::ConvexPolygon;

const OURS: Declaration = Declaration {
    name: c"parry2d-simplified".as_ptr(),
    scalar: FLOAT32,
    snippet: concat!(include_str!("../../parry/snippet_simplified.rs"), "\0").as_ptr().cast(),
    claims: Claims { alters_shapes: 1, ..COMMON.claims },
    ..COMMON
};

fn collide_all(a: &Body, b: &Body) -> Option<Manifold> {
    collide(a, b, ConvexPolygon::from_convex_polyline, true)
}

export!(OURS, collide_all);
