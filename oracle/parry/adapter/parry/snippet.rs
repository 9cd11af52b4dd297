/// The program of a report on parry, of one package: how its scalar writes two coordinates and a
/// radius, what doubles ask of a body first, and how a polygon is made.
macro_rules! snippet {
    ($package:literal, $module:literal, $numbers:literal, $unit:literal, $radius:literal, $make:literal) => {
        concat!(
            r#"@language rust
@none no point of a dist of 0 or less
@figures by way of A's frame, so to a few roundings of the largest
@point middle of local_p1 and local_p2 in the world $m, dist $s
// cargo add "#, $package, "@", env!("CARGO_PKG_VERSION"), r#"
use "#, $module, r#"::{math::*, query::*, shape::*};
fn main() {
@each     let at_@* = Pose::from_parts(@*.position(Vector::new("#, $numbers, r#"))@, @*."#, $unit, r#"rotation(Rot2::from_cos_sin_unchecked("#, $numbers, r#"))@);
@each @*.circle?     let at_@* = Pose::from_parts(at_@* * @*."#, $unit, r#"vertices(Vector::new("#, $numbers, r#"))@, at_@*.rotation);
@each @*.circle?     let @* = Ball::new(@*."#, $radius, r#");
@each @*.segment? @!*.rounded?     let @* = Segment::new(@*."#, $unit, r#"vertices(Vector::new("#, $numbers, r#"))@);
@each @*.segment? @*.rounded?     let @* = Capsule::new(@*."#, $unit, r#"vertices(Vector::new("#, $numbers, r#"))@, @*."#, $radius, r#");
@each @*.polygon?     let @* = ConvexPolygon::"#, $make, r#"(
@each @*.polygon?         vec![@*."#, $unit, r#"vertices(Vector::new("#, $numbers, r#"))@]).unwrap();
@each @*.polygon? @*.rounded?     let @* = RoundShape { inner_shape: @*, border_radius: @*."#, $radius, r#" };
    let mut found = ContactManifold::<(), ()>::new();
    DefaultQueryDispatcher.@asked(contact_manifold_convex_convex)@(
        &at_a.inv_mul(&at_b), &a, &b, None, None, 0.0, &mut found).unwrap();
    println!("{} points, normal {:?}", found.points.len(), at_a.rotation * found.local_n1);
    for p in &found.points { let (on_a, on_b) = (at_a * p.local_p1, at_b * p.local_p2);
        println!("{on_a:?} {on_b:?}, middle {:?}, dist {}", (on_a + on_b) / 2.0, p.dist); }
}
"#, "\0"
        )
        .as_ptr()
        .cast()
    };
}
pub(crate) use snippet;
