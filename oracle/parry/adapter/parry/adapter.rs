//! parry for manifuzz, of floats or doubles: `parry` is either crate. It is asked as Rapier asks
//! it, by its dispatcher, without prediction and without what it keeps from one call to the next.

use manifuzz_collider::{
    Body, CLAIMS, Claims, DECLARATION, Declaration, Double2, Float2, Manifold, MIDPOINTS, Shape,
};
use parry::math::{Pose, Real, Rot2, Vector};
use parry::query::{ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry::shape::{Ball, Capsule, ConvexPolygon, RoundShape, Segment, Shape as ParryShape};

/// What all rows declare. The normal is a face's of the polytope that EPA ends with, within 100
/// roundoffs of the least deep; both edges are clipped along it, and neither is the reference.
pub const COMMON: Declaration = Declaration {
    version: concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast(),
    points: MIDPOINTS,
    claims: Claims {
        does_not_clip: 1,
        tolerance_absolute: 100.0 * Real::EPSILON as f64,
        tolerance_source: concat!(
            "parry2d ", env!("CARGO_PKG_VERSION"),
            ", src/query/epa/epa2.rs: _eps_tol = _eps * 100.0\0").as_ptr().cast(),
        vertices_min: 1,
        takes_round: 1,
        ..CLAIMS
    },
    ..DECLARATION
};

/// How its users make a polygon of vertices.
pub type MakePolygon = fn(Vec<Vector>) -> Option<ConvexPolygon>;

/// A shape of parry's, the vertices that it kept, and where it stands. A ball's centre is its origin.
struct Placed {
    shape: Box<dyn ParryShape>,
    pose: Pose,
    vertices: Vec<Vector>,
}

fn vector(v: Float2, unit: Real) -> Vector {
    Vector::new(unit * Real::from(v.x), unit * Real::from(v.y))
}

/// In doubles the stored rotation is unit to 32 bits only: what it lacks goes into the vertices.
fn unit_of(body: &Body) -> Real {
    if size_of::<Real>() == size_of::<f64>() { body.unit() as Real } else { 1.0 }
}

fn placed(body: &Body, make: MakePolygon) -> Option<Placed> {
    let unit = unit_of(body);
    let Float2 { x: cos, y: sin } = body.rotation;
    let rotation = Rot2::from_cos_sin_unchecked(Real::from(cos) / unit, Real::from(sin) / unit);
    let mut pose = Pose::from_parts(vector(body.position, 1.0), rotation);
    let radius = Real::from(body.radius);
    let mut vertices: Vec<Vector> = body.vertices().iter().map(|v| vector(*v, unit)).collect();
    let shape: Box<dyn ParryShape> = match vertices[..] {
        [centre] => {
            pose.translation = pose * centre;
            Box::new(Ball::new(radius))
        }
        [from, to] if radius == 0.0 => Box::new(Segment::new(from, to)),
        [from, to] => Box::new(Capsule::new(from, to, radius)),
        _ => {
            let inner_shape = make(vertices)?;
            vertices = inner_shape.points().to_vec();
            if radius > 0.0 {
                Box::new(RoundShape { inner_shape, border_radius: radius })
            } else {
                Box::new(inner_shape)
            }
        }
    };
    Some(Placed { shape, pose, vertices })
}

fn wide(v: Vector) -> Double2 {
    Double2 { x: v.x as f64, y: v.y as f64 }
}

/// In the body's own frame.
fn used(placed: &Placed, unit: Real) -> Shape {
    let mut shape = Shape::default();
    for vertex in &placed.vertices {
        shape.vertices[shape.count as usize] = wide(*vertex / unit);
        shape.count += 1;
    }
    shape
}

pub fn collide(body_a: &Body, body_b: &Body, make: MakePolygon, says_shapes: bool) -> Option<Manifold> {
    let a = placed(body_a, make)?;
    let b = placed(body_b, make)?;
    let between = a.pose.inv_mul(&b.pose);
    let mut found = ContactManifold::<(), ()>::new();
    DefaultQueryDispatcher
        .contact_manifold_convex_convex(
            &between, &*a.shape, &*b.shape, None, None, 0.0, &mut found)
        .ok()?;
    let mut manifold = Manifold::default();
    for point in &found.points {
        let middle = (a.pose * point.local_p1 + b.pose * point.local_p2) / 2.0;
        manifold.add(wide(middle), f64::from(point.dist));
    }
    manifold.normal = wide(a.pose.rotation * found.local_n1);
    if says_shapes {
        manifold.shapes = [used(&a, unit_of(body_a)), used(&b, unit_of(body_b))];
    }
    Some(manifold)
}
