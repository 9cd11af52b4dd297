//! parry in floats, polygons with all their vertices.

#[path = "../../parry/adapter.rs"]
mod adapter;
#[path = "../../parry/snippet.rs"]
mod snippet;

use adapter::{COMMON, collide};
use manifuzz_collider::{Body, Declaration, FLOAT32, Manifold, export};
use parry::shape::ConvexPolygon;
use snippet::snippet;

const OURS: Declaration = Declaration {
    name: c"parry2d".as_ptr(),
    scalar: FLOAT32,
    snippet: snippet!("parry2d", "parry2d", "$x_f32, $y_f32", "", "radius@_f32", "from_convex_polyline_unmodified"),
    ..COMMON
};

fn collide_all(a: &Body, b: &Body) -> Option<Manifold> {
    collide(a, b, ConvexPolygon::from_convex_polyline_unmodified, false)
}

export!(OURS, collide_all);
