@language rust
@none no point of a dist of 0 or less
@point local_p1 in the world $a, local_p2 in the world $b, dist $s
// cargo add parry2d-f64@0.30.2
use parry2d_f64::{math::*, query::*, shape::*};
fn main() {
@each     let at_@* = Pose::from_parts(@*.position(Vector::new($X_f64, $Y_f64))@, @*.unit_rotation(Rot2::from_cos_sin_unchecked($X_f64, $Y_f64))@);
@each @*.circle?     let at_@* = Pose::from_parts(at_@* * @*.unit_vertices(Vector::new($X_f64, $Y_f64))@, at_@*.rotation);
@each @*.circle?     let @* = Ball::new(@*.wide_radius@_f64);
@each @*.segment? @!*.rounded?     let @* = Segment::new(@*.unit_vertices(Vector::new($X_f64, $Y_f64))@);
@each @*.segment? @*.rounded?     let @* = Capsule::new(@*.unit_vertices(Vector::new($X_f64, $Y_f64))@, @*.wide_radius@_f64);
@each @*.polygon?     let @* = ConvexPolygon::from_convex_polyline_unmodified(
@each @*.polygon?         vec![@*.unit_vertices(Vector::new($X_f64, $Y_f64))@]).unwrap();
@each @*.polygon? @*.rounded?     let @* = RoundShape { inner_shape: @*, border_radius: @*.wide_radius@_f64 };
    let mut found = ContactManifold::<(), ()>::new();
    DefaultQueryDispatcher.@asked(contact_manifold_convex_convex)@(
        &at_a.inv_mul(&at_b), &a, &b, None, None, 0.0, &mut found).unwrap();
    println!("{} points, normal {:?}", found.points.len(), at_a.rotation * found.local_n1);
    for p in &found.points { println!("{:?} {:?} {}", at_a * p.local_p1, at_b * p.local_p2, p.dist); }
}
