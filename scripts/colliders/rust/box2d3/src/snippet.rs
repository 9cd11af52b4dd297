// cargo add boxdd-sys@0.6.0; CFLAGS=-DNDEBUG cargo run --release
use boxdd_sys::ffi::*;

fn floats(text: &str) -> Vec<f32> {
    let numbers = text.split(['[', ']', ',', ' ']).filter(|number| !number.is_empty());
    numbers.map(|number| number.parse().unwrap()).collect()
}

fn vectors(text: &str) -> Vec<b2Vec2> {
    floats(text).chunks(2).map(|v| b2Vec2 { x: v[0], y: v[1] }).collect()
}

/// b2InvMulTransforms
fn between(a: &[&str; 5], b: &[&str; 5]) -> b2Transform {
    let [p, q] = [a, b].map(|body| vectors(body[3])[0]);
    let [u, v] = [a, b].map(|body| vectors(body[4])[0]);
    let d = b2Vec2 { x: q.x - p.x, y: q.y - p.y };
    b2Transform {
        p: b2Vec2 { x: u.x * d.x + u.y * d.y, y: -u.y * d.x + u.x * d.y },
        q: b2Rot { c: u.x * v.x + u.y * v.y, s: u.x * v.y - u.y * v.x },
    }
}

fn circle([v, _, r, ..]: &[&str; 5]) -> b2Circle {
    b2Circle { center: vectors(v)[0], radius: floats(r)[0] }
}

fn capsule([v, _, r, ..]: &[&str; 5]) -> b2Capsule {
    b2Capsule { center1: vectors(v)[0], center2: vectors(v)[1], radius: floats(r)[0] }
}

fn polygon([v, n, r, ..]: &[&str; 5]) -> b2Polygon {
    let filled = |text| {
        let given = vectors(text);
        std::array::from_fn(|i| given[i % given.len()])
    };
    let centroid = b2Vec2 { x: 0.0, y: 0.0 }; // no b2Collide function reads it
    let count = vectors(v).len() as i32;
    b2Polygon { vertices: filled(v), normals: filled(n), centroid, radius: floats(r)[0], count }
}

fn main() {
    let a = ["@a.vertices[]@", "@a.normals[]@", "@a.radius@", "@a.position[]@", "@a.rotation[]@"];
    let b = ["@b.vertices[]@", "@b.normals[]@", "@b.radius@", "@b.position[]@", "@b.rotation[]@"];
    let count = |body: &[&str; 5]| vectors(body[0]).len();
    // Polygons, capsules, circles: the functions take them in this order.
    let swapped = count(&a).min(3) < count(&b).min(3);
    let (a, b) = if swapped { (b, a) } else { (a, b) };
    let to = between(&a, &b);
    let manifold = unsafe {
        match (count(&a), count(&b)) {
            (1, 1) => b2CollideCircles(&circle(&a), &circle(&b), to),
            (2, 1) => b2CollideCapsuleAndCircle(&capsule(&a), &circle(&b), to),
            (2, 2) => b2CollideCapsules(&capsule(&a), &capsule(&b), to),
            (_, 1) => b2CollidePolygonAndCircle(&polygon(&a), &circle(&b), to),
            (_, 2) => b2CollidePolygonAndCapsule(&polygon(&a), &capsule(&b), to),
            _ => b2CollidePolygons(&polygon(&a), &polygon(&b), to),
        }
    };
    println!("in the frame of {}: {manifold:#?}", if swapped { "B, from B to A" } else { "A" });
}
