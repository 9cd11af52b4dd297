//! Box2D 3: every `b2Collide` function for two bodies' shapes, without a world; and a world to be timed.

mod world;

use boxdd_sys::ffi::{
    b2Capsule, b2Circle, b2CollideCapsuleAndCircle, b2CollideCapsules, b2CollideCircles,
    b2CollidePolygonAndCapsule, b2CollidePolygonAndCircle, b2CollidePolygons,
    b2CollideSegmentAndCapsule, b2CollideSegmentAndCircle, b2CollideSegmentAndPolygon,
    b2LocalManifold, b2Polygon, b2Rot, b2Segment, b2Transform, b2Vec2,
};
use manifuzz_collider::{
    Body, CLAIMS, Claims, DECLARATION, Declaration, Double2, Float2, FRAME_OF_A, Manifold,
    MIDPOINTS, VERTICES_MAX, export, export_timed_world, version_in,
};

const VERSION: &[u8] = &version_in(include_str!("../../../engine.json"));

/// Where either is as deep, A's face is the reference (manifold.c: separationA >= separationB).
const OURS: Declaration = Declaration {
    name: c"box2d3".as_ptr(),
    version: VERSION.as_ptr().cast(),
    rounds_in: FRAME_OF_A,
    points: MIDPOINTS,
    snippet: concat!(include_str!("snippet.c"), "\0").as_ptr().cast(),
    claims: Claims { vertices_min: 1, takes_round: 1, ..CLAIMS },
    ..DECLARATION
};

enum Shape {
    Segment(b2Segment),
    Polygon(b2Polygon),
    Capsule(b2Capsule),
    Circle(b2Circle),
}

fn vector(v: Float2) -> b2Vec2 {
    b2Vec2 { x: v.x, y: v.y }
}

/// Filled as it stands: b2ComputeHull would weld vertices. Inlined, for to copy what was written a
/// moment ago takes nearly as long as to collide it.
#[inline(always)]
fn polygon(body: &Body) -> b2Polygon {
    let zero = b2Vec2 { x: 0.0, y: 0.0 };
    let mut polygon = b2Polygon {
        vertices: [zero; VERTICES_MAX],
        normals: [zero; VERTICES_MAX],
        centroid: zero, // no b2Collide function reads it
        radius: body.radius,
        count: body.vertices().len() as i32,
    };
    for (i, (vertex, normal)) in body.vertices().iter().zip(body.normals()).enumerate() {
        polygon.vertices[i] = vector(*vertex);
        polygon.normals[i] = vector(*normal);
    }
    polygon
}

fn capsule(from: Float2, to: Float2, radius: f32) -> b2Capsule {
    b2Capsule { center1: vector(from), center2: vector(to), radius }
}

fn shape(body: &Body) -> Shape {
    match *body.vertices() {
        [center] => Shape::Circle(b2Circle { center: vector(center), radius: body.radius }),
        [from, to] if body.radius == 0.0 => {
            Shape::Segment(b2Segment { point1: vector(from), point2: vector(to) })
        }
        [from, to] => Shape::Capsule(capsule(from, to, body.radius)),
        _ => Shape::Polygon(polygon(body)),
    }
}

/// b2InvMulTransforms, which is inline in C.
fn between(a: &Body, b: &Body) -> b2Transform {
    let [p, q] = [a.rotation, b.rotation];
    let d = Float2 { x: b.position.x - a.position.x, y: b.position.y - a.position.y };
    b2Transform {
        p: b2Vec2 { x: p.x * d.x + p.y * d.y, y: -p.y * d.x + p.x * d.y },
        q: b2Rot { c: p.x * q.x + p.y * q.y, s: p.x * q.y - p.y * q.x },
    }
}

/// In A's frame; nothing where the function takes B first.
fn collide_in_order(a: &Shape, b: &Shape, to: b2Transform) -> Option<b2LocalManifold> {
    use Shape::{Capsule, Circle, Polygon, Segment};
    // SAFETY: all are filled, and only read.
    Some(unsafe {
        match (a, b) {
            (Segment(a), Polygon(b)) => b2CollideSegmentAndPolygon(a, b, to),
            (Segment(a), Capsule(b)) => b2CollideSegmentAndCapsule(a, b, to),
            (Segment(a), Circle(b)) => b2CollideSegmentAndCircle(a, b, to),
            (Segment(a), Segment(b)) => {
                let b = b2Capsule { center1: b.point1, center2: b.point2, radius: 0.0 };
                b2CollideSegmentAndCapsule(a, &b, to)
            }
            (Polygon(a), Polygon(b)) => b2CollidePolygons(a, b, to),
            (Polygon(a), Capsule(b)) => b2CollidePolygonAndCapsule(a, b, to),
            (Polygon(a), Circle(b)) => b2CollidePolygonAndCircle(a, b, to),
            (Capsule(a), Capsule(b)) => b2CollideCapsules(a, b, to),
            (Capsule(a), Circle(b)) => b2CollideCapsuleAndCircle(a, b, to),
            (Circle(a), Circle(b)) => b2CollideCircles(a, b, to),
            _ => return None,
        }
    })
}

fn wide(v: b2Vec2) -> Double2 {
    Double2 { x: f64::from(v.x), y: f64::from(v.y) }
}

/// `sign`: -1 where `first`, in whose frame it was found, is B.
fn in_world(found: &b2LocalManifold, first: &Body, sign: f64) -> Manifold {
    let mut manifold = Manifold::default();
    let normal = first.turned(wide(found.normal));
    manifold.normal = Double2 { x: sign * normal.x, y: sign * normal.y };
    for point in &found.points[..found.pointCount as usize] {
        manifold.add(first.placed(wide(point.point)), f64::from(point.separation));
    }
    manifold
}

fn collide(a: &Body, b: &Body) -> Option<Manifold> {
    let [of_a, of_b] = [a, b].map(shape);
    if let Some(found) = collide_in_order(&of_a, &of_b, between(a, b)) {
        return Some(in_world(&found, a, 1.0));
    }
    let found = collide_in_order(&of_b, &of_a, between(b, a))?;
    Some(in_world(&found, b, -1.0))
}

export!(OURS, collide);
export_timed_world!(world::Box2dWorld);
