//! cute_c2 for manifuzz, as `c2` has it: in C, or by hand in Rust.

use std::ffi::c_void;

use c2_sys::{c2Capsule, c2Circle, c2Collide, c2Manifold, c2Poly, c2r, c2v, c2x};
use manifuzz_collider::{
    Body, CLAIMS, Claims, DECLARATION, Declaration, Double2, Float2, Manifold, REFERENCE_B,
    VERTICES_MAX,
};

/// c2PolytoPolyManifold takes A's face iff sa * kRelTol > sb + kAbsTol, which is
/// sa > sb / kRelTol + kAbsTol / kRelTol.
const REL_TOL: f64 = 0.95_f32 as f64;
const ABS_TOL: f64 = 0.01_f32 as f64;

pub const COMMON: Declaration = Declaration {
    tie_bias: ABS_TOL / REL_TOL,
    claims: Claims {
        tie_bias_relative: 1.0 - 1.0 / REL_TOL,
        tie_bias_towards: REFERENCE_B,
        vertices_min: 1,
        ..CLAIMS
    },
    ..DECLARATION
};

/// In the world already, but for polygons.
enum Shape {
    Circle(c2Circle),
    Capsule(c2Capsule),
    Polygon(c2Poly),
}

impl Shape {
    fn pointer(&self) -> *const c_void {
        match self {
            Shape::Circle(circle) => (&raw const *circle).cast(),
            Shape::Capsule(capsule) => (&raw const *capsule).cast(),
            Shape::Polygon(polygon) => (&raw const *polygon).cast(),
        }
    }
    fn kind(&self) -> c2_sys::C2_TYPE {
        match self {
            Shape::Circle(_) => c2_sys::C2_TYPE_C2_TYPE_CIRCLE,
            Shape::Capsule(_) => c2_sys::C2_TYPE_C2_TYPE_CAPSULE,
            Shape::Polygon(_) => c2_sys::C2_TYPE_C2_TYPE_POLY,
        }
    }
}

fn vector(v: Float2) -> c2v {
    c2v { x: v.x, y: v.y }
}

fn transform(body: &Body) -> c2x {
    c2x { p: vector(body.position), r: c2r { c: body.rotation.x, s: body.rotation.y } }
}

/// c2Mulxv, which is inline in C: where its users put a circle or a capsule.
fn placed(body: &Body, v: Float2) -> c2v {
    let c2x { p, r } = transform(body);
    c2v { x: r.c * v.x - r.s * v.y + p.x, y: r.s * v.x + r.c * v.y + p.y }
}

/// Filled as it stands: c2MakePoly would weld and reorder.
fn polygon(body: &Body) -> c2Poly {
    let zero = c2v { x: 0.0, y: 0.0 };
    let mut polygon = c2Poly {
        count: body.vertices().len() as i32,
        verts: [zero; VERTICES_MAX],
        norms: [zero; VERTICES_MAX],
    };
    for (to, vertex) in polygon.verts.iter_mut().zip(body.vertices()) {
        *to = vector(*vertex);
    }
    for (to, normal) in polygon.norms.iter_mut().zip(body.normals()) {
        *to = vector(*normal);
    }
    polygon
}

/// Nothing of a polygon with a radius: c2Poly has none.
fn shape(body: &Body) -> Option<Shape> {
    Some(match *body.vertices() {
        [center] => Shape::Circle(c2Circle { p: placed(body, center), r: body.radius }),
        [from, to] => {
            Shape::Capsule(c2Capsule { a: placed(body, from), b: placed(body, to), r: body.radius })
        }
        _ if body.radius > 0.0 => return None,
        _ => Shape::Polygon(polygon(body)),
    })
}

fn wide(v: c2v) -> Double2 {
    Double2 { x: f64::from(v.x), y: f64::from(v.y) }
}

pub fn collide(a: &Body, b: &Body) -> Option<Manifold> {
    let (of_a, of_b) = (shape(a)?, shape(b)?);
    let [to_a, to_b] = [a, b].map(transform);
    let zero = c2v { x: 0.0, y: 0.0 };
    let mut found =
        c2Manifold { count: 0, depths: [0.0; 2], contact_points: [zero; 2], n: zero };
    // SAFETY: each pointer is to a shape of its kind.
    unsafe {
        c2Collide(
            of_a.pointer(), &to_a, of_a.kind(), of_b.pointer(), &to_b, of_b.kind(), &mut found);
    }
    let mut manifold = Manifold::default();
    manifold.normal = wide(found.n);
    for (place, depth) in found.contact_points.iter().zip(found.depths).take(found.count as usize) {
        manifold.add(wide(*place), -f64::from(depth));
    }
    Some(manifold)
}
