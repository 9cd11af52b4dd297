@language rust
@none no point of a dist of 0 or less
@point local_p1 in the world $a, local_p2 in the world $b, dist $s
// cargo add parry2d@0.30.2
use parry2d::{math::*, query::*, shape::*};
fn main() {
@each     let at_@* = Pose::from_parts(@*.position(Vector::new($x_f32, $y_f32))@, @*.rotation(Rot2::from_cos_sin_unchecked($x_f32, $y_f32))@);
@each @*.circle?     let at_@* = Pose::from_parts(at_@* * @*.vertices(Vector::new($x_f32, $y_f32))@, at_@*.rotation);
@each @*.circle?     let @* = Ball::new(@*.radius@_f32);
@each @*.segment? @!*.rounded?     let @* = Segment::new(@*.vertices(Vector::new($x_f32, $y_f32))@);
@each @*.segment? @*.rounded?     let @* = Capsule::new(@*.vertices(Vector::new($x_f32, $y_f32))@, @*.radius@_f32);
@each @*.polygon?     let @* = ConvexPolygon::from_convex_polyline_unmodified(
@each @*.polygon?         vec![@*.vertices(Vector::new($x_f32, $y_f32))@]).unwrap();
@each @*.polygon? @*.rounded?     let @* = RoundShape { inner_shape: @*, border_radius: @*.radius@_f32 };
    let mut found = ContactManifold::<(), ()>::new();
    DefaultQueryDispatcher.@asked(contact_manifold_convex_convex)@(
        &at_a.inv_mul(&at_b), &a, &b, None, None, 0.0, &mut found).unwrap();
    println!("{} points, normal {:?}", found.points.len(), at_a.rotation * found.local_n1);
    for p in &found.points { println!("{:?} {:?} {}", at_a * p.local_p1, at_b * p.local_p2, p.dist); }
}
