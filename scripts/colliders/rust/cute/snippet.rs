// cargo add c2-sys@0.1.0 (cute_c2 1.08 in C) or c2-sys@0.2.0 (by hand in Rust)
use c2_sys::*;

fn floats(text: &str) -> Vec<f32> {
    let numbers = text.split(['[', ']', ',', ' ']).filter(|number| !number.is_empty());
    numbers.map(|number| number.parse().unwrap()).collect()
}

fn vectors(text: &str) -> Vec<c2v> {
    floats(text).chunks(2).map(|v| c2v { x: v[0], y: v[1] }).collect()
}

fn placed(x: &c2x, v: c2v) -> c2v {
    c2v { x: x.r.c * v.x - x.r.s * v.y + x.p.x, y: x.r.s * v.x + x.r.c * v.y + x.p.y }
}

/// A shape, its type, and where it stands: circles and capsules in the world already.
fn body(v: &str, n: &str, r: &str, p: &str, q: &str) -> (*const std::ffi::c_void, C2_TYPE, c2x) {
    let (at, r) = (vectors(q)[0], floats(r)[0]);
    let x = c2x { p: vectors(p)[0], r: c2r { c: at.x, s: at.y } };
    let filled = |text| {
        let given = vectors(text);
        std::array::from_fn(|i| given[i % given.len()])
    };
    match vectors(v)[..] {
        [p] => {
            let circle = c2Circle { p: placed(&x, p), r };
            (Box::into_raw(Box::new(circle)) as _, C2_TYPE_C2_TYPE_CIRCLE, x)
        }
        [a, b] => {
            let capsule = c2Capsule { a: placed(&x, a), b: placed(&x, b), r };
            (Box::into_raw(Box::new(capsule)) as _, C2_TYPE_C2_TYPE_CAPSULE, x)
        }
        ref all => {
            let polygon = c2Poly { count: all.len() as i32, verts: filled(v), norms: filled(n) };
            (Box::into_raw(Box::new(polygon)) as _, C2_TYPE_C2_TYPE_POLY, x)
        }
    }
}

fn main() {
    let (a, of_a, to_a) = body(
        "@a.vertices[]@", "@a.normals[]@", "@a.radius@", "@a.position[]@", "@a.rotation[]@");
    let (b, of_b, to_b) = body(
        "@b.vertices[]@", "@b.normals[]@", "@b.radius@", "@b.position[]@", "@b.rotation[]@");
    let zero = c2v { x: 0.0, y: 0.0 };
    let mut m = c2Manifold { count: 0, depths: [0.0; 2], contact_points: [zero; 2], n: zero };
    unsafe { c2Collide(a, &to_a, of_a, b, &to_b, of_b, &mut m) };
    println!("{m:#?}");
}
