@language rust
@point in the world $m, separation $s
// cargo add boxdd-sys@0.6.0; CFLAGS=-DNDEBUG cargo run --release
use boxdd_sys::ffi::*;
fn main() {
@each @*.circle?     let @* = b2Circle { center: @*.vertices(b2Vec2 { x: $x_f32, y: $y_f32 })@, radius: @*.radius@_f32 };
@each @*.segment?     let [p, q] = [@*.vertices(b2Vec2 { x: $x_f32, y: $y_f32 })@];
@each @*.segment? @!*.rounded?     let @* = b2Segment { point1: p, point2: q };
@each @*.segment? @*.rounded?     let @* = b2Capsule { center1: p, center2: q, radius: @*.radius@_f32 };
@each @*.polygon?     let [of, out] = [[@*.vertices(b2Vec2 { x: $x_f32, y: $y_f32 })@], [@*.normals(b2Vec2 { x: $x_f32, y: $y_f32 })@]];
@each @*.polygon?     let [vertices, normals] = [of, out].map(|all| std::array::from_fn(|i| all[i % @*.count@]));
@each @*.polygon?     let @* = b2Polygon { vertices, normals, centroid: of[0], radius: @*.radius@_f32, count: @*.count@ };
@each     let pose_@* = [@*.position($x_f32, $y_f32)@, @*.rotation($x_f32, $y_f32)@];
@a.polygon? @b.segment? @!b.rounded? @b_first
@a.segment? @a.rounded? @b.segment? @!b.rounded? @b_first
@a.segment? @a.rounded? @b.polygon? @b_first
@a.circle? @b.segment? @!b.rounded? @b_first
@a.circle? @b.polygon? @b_first
@a.circle? @b.segment? @b.rounded? @b_first
@a.segment? @!a.rounded? @b.segment? @!b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.segment? @!a.rounded? @b.polygon?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.segment? @!a.rounded? @b.segment? @b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.segment? @!a.rounded? @b.circle?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.polygon? @b.segment? @!b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_b, pose_a);
@a.polygon? @b.polygon?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.polygon? @b.segment? @b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.polygon? @b.circle?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.segment? @a.rounded? @b.segment? @!b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_b, pose_a);
@a.segment? @a.rounded? @b.polygon?     let ([x, y, c, s], [u, v, d, t]) = (pose_b, pose_a);
@a.segment? @a.rounded? @b.segment? @b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.segment? @a.rounded? @b.circle?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
@a.circle? @b.segment? @!b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_b, pose_a);
@a.circle? @b.polygon?     let ([x, y, c, s], [u, v, d, t]) = (pose_b, pose_a);
@a.circle? @b.segment? @b.rounded?     let ([x, y, c, s], [u, v, d, t]) = (pose_b, pose_a);
@a.circle? @b.circle?     let ([x, y, c, s], [u, v, d, t]) = (pose_a, pose_b);
    let p = b2Vec2 { x: c * (u - x) + s * (v - y), y: -s * (u - x) + c * (v - y) };
    let to = b2Transform { p, q: b2Rot { c: c * d + s * t, s: c * t - s * d } };
@a.segment? @!a.rounded? @b.segment? @!b.rounded?     let found = unsafe { @asked(b2CollideSegmentAndCapsule)@(&a, &b2Capsule { center1: b.point1, center2: b.point2, radius: 0.0 }, to) };
@a.segment? @!a.rounded? @b.polygon?     let found = unsafe { @asked(b2CollideSegmentAndPolygon)@(&a, &b, to) };
@a.segment? @!a.rounded? @b.segment? @b.rounded?     let found = unsafe { @asked(b2CollideSegmentAndCapsule)@(&a, &b, to) };
@a.segment? @!a.rounded? @b.circle?     let found = unsafe { @asked(b2CollideSegmentAndCircle)@(&a, &b, to) };
@a.polygon? @b.segment? @!b.rounded?     let found = unsafe { @asked(b2CollideSegmentAndPolygon)@(&b, &a, to) };
@a.polygon? @b.polygon?     let found = unsafe { @asked(b2CollidePolygons)@(&a, &b, to) };
@a.polygon? @b.segment? @b.rounded?     let found = unsafe { @asked(b2CollidePolygonAndCapsule)@(&a, &b, to) };
@a.polygon? @b.circle?     let found = unsafe { @asked(b2CollidePolygonAndCircle)@(&a, &b, to) };
@a.segment? @a.rounded? @b.segment? @!b.rounded?     let found = unsafe { @asked(b2CollideSegmentAndCapsule)@(&b, &a, to) };
@a.segment? @a.rounded? @b.polygon?     let found = unsafe { @asked(b2CollidePolygonAndCapsule)@(&b, &a, to) };
@a.segment? @a.rounded? @b.segment? @b.rounded?     let found = unsafe { @asked(b2CollideCapsules)@(&a, &b, to) };
@a.segment? @a.rounded? @b.circle?     let found = unsafe { @asked(b2CollideCapsuleAndCircle)@(&a, &b, to) };
@a.circle? @b.segment? @!b.rounded?     let found = unsafe { @asked(b2CollideSegmentAndCircle)@(&b, &a, to) };
@a.circle? @b.polygon?     let found = unsafe { @asked(b2CollidePolygonAndCircle)@(&b, &a, to) };
@a.circle? @b.segment? @b.rounded?     let found = unsafe { @asked(b2CollideCapsuleAndCircle)@(&b, &a, to) };
@a.circle? @b.circle?     let found = unsafe { @asked(b2CollideCircles)@(&a, &b, to) };
    println!("{} points in the first shape's frame: {found:#?}", found.pointCount);
}
