// cargo add parry2d@0.30.2; of parry2d-f64, its name and f64.
use parry2d::math::{Pose, Rot2, Vector};
use parry2d::query::{ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher};
use parry2d::shape::{Ball, Capsule, ConvexPolygon, RoundShape, Segment, Shape};
type Real = f32;

fn floats(text: &str) -> Vec<Real> {
    let numbers = text.split(['[', ']', ',', ' ']).filter(|number| !number.is_empty());
    numbers.map(|number| number.parse::<f32>().unwrap() as Real).collect()
}

fn body(vertices: &str, radius: &str, position: &str, rotation: &str) -> (Box<dyn Shape>, Pose) {
    let (radius, p, q) = (floats(radius)[0], floats(position), floats(rotation));
    // In doubles, what the rotation lacks of length 1 goes into the vertices.
    let unit = if Real::DIGITS > 6 { q[0].hypot(q[1]) } else { 1.0 };
    let rotation = Rot2::from_cos_sin_unchecked(q[0] / unit, q[1] / unit);
    let mut pose = Pose::from_parts(Vector::new(p[0], p[1]), rotation);
    let numbers = floats(vertices);
    let corners: Vec<_> = numbers.chunks(2).map(|v| unit * Vector::new(v[0], v[1])).collect();
    let shape: Box<dyn Shape> = match corners[..] {
        [centre] => {
            pose.translation = pose * centre;
            Box::new(Ball::new(radius))
        }
        [a, b] if radius == 0.0 => Box::new(Segment::new(a, b)),
        [a, b] => Box::new(Capsule::new(a, b, radius)),
        _ => {
            // parry2d-simplified: from_convex_polyline
            let inner_shape = ConvexPolygon::from_convex_polyline_unmodified(corners).unwrap();
            match radius > 0.0 {
                true => Box::new(RoundShape { inner_shape, border_radius: radius }),
                false => Box::new(inner_shape),
            }
        }
    };
    (shape, pose)
}

fn main() {
    let (a, at) = body("@a.vertices[]@", "@a.radius@", "@a.position[]@", "@a.rotation[]@");
    let (b, bt) = body("@b.vertices[]@", "@b.radius@", "@b.position[]@", "@b.rotation[]@");
    let mut manifold = ContactManifold::<(), ()>::new();
    DefaultQueryDispatcher
        .contact_manifold_convex_convex(&at.inv_mul(&bt), &*a, &*b, None, None, 0.0, &mut manifold)
        .unwrap();
    println!("{} points, normal {:?}", manifold.points.len(), at.rotation * manifold.local_n1);
    for point in &manifold.points {
        println!("{:?} on A, {:?} on B, {}", at * point.local_p1, bt * point.local_p2, point.dist);
    }
}
