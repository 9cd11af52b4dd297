//! parry in doubles, polygons with all their vertices.

#[path = "../../parry/adapter.rs"]
mod adapter;
#[path = "../../parry/snippet.rs"]
mod snippet;

use adapter::{COMMON, collide};
use manifuzz_collider::{Body, Declaration, FLOAT64, Manifold, export};
use parry::shape::ConvexPolygon;
use snippet::snippet;

const OURS: Declaration = Declaration {
    name: c"parry2d-f64".as_ptr(),
    scalar: FLOAT64,
    snippet: snippet!("parry2d-f64", "parry2d_f64", "$X_f64, $Y_f64", "unit_", "wide_radius@_f64", "from_convex_polyline_unmodified"),
    ..COMMON
};

fn collide_all(a: &Body, b: &Body) -> Option<Manifold> {
    collide(a, b, ConvexPolygon::from_convex_polyline_unmodified, false)
}

export!(OURS, collide_all);
