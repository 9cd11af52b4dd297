//! parry in doubles, polygons with all their vertices.

#[path = "../../parry/adapter.rs"]
mod adapter;

use adapter::{COMMON, collide};
use manifuzz_collider::{Body, Declaration, FLOAT64, Manifold, export};
use parry::shape::ConvexPolygon;

const OURS: Declaration = Declaration {
    name: c"parry2d-f64".as_ptr(),
    scalar: FLOAT64,
    snippet: concat!(include_str!("../../parry/snippet_f64.rs"), "\0").as_ptr().cast(),
    ..COMMON
};

fn collide_all(a: &Body, b: &Body) -> Option<Manifold> {
    collide(a, b, ConvexPolygon::from_convex_polyline_unmodified, false)
}

export!(OURS, collide_all);
