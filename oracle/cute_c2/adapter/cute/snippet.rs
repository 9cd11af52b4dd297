@language rust
@point contact_points $p, depths $d
// cargo add c2-sys@0.2.0
use c2_sys::*;
fn main() {
@each     let x = c2x { p: @*.position(c2v { x: $x_f32, y: $y_f32 })@, r: @*.rotation(c2r { c: $x_f32, s: $y_f32 })@ };
@each @!*.polygon? @*.placed?     let at = |v: c2v| c2v { x: x.r.c * v.x - x.r.s * v.y + x.p.x, y: x.r.s * v.x + x.r.c * v.y + x.p.y };
@each @!*.polygon? @!*.placed?     let at = |v: c2v| v;
@each @*.circle?     let (@*, kind_@*, x_@*) = (c2Circle { p: at(@*.vertices(c2v { x: $x_f32, y: $y_f32 })@), r: @*.radius@_f32 }, C2_TYPE_C2_TYPE_CIRCLE, x);
@each @*.segment?     let [p, q] = [@*.vertices(c2v { x: $x_f32, y: $y_f32 })@].map(at);
@each @*.segment?     let (@*, kind_@*, x_@*) = (c2Capsule { a: p, b: q, r: @*.radius@_f32 }, C2_TYPE_C2_TYPE_CAPSULE, x);
@each @*.polygon?     let [of, out] = [[@*.vertices(c2v { x: $x_f32, y: $y_f32 })@], [@*.normals(c2v { x: $x_f32, y: $y_f32 })@]];
@each @*.polygon?     let [verts, norms] = [of, out].map(|all| std::array::from_fn(|i| all[i % @*.count@]));
@each @*.polygon?     let (@*, kind_@*, x_@*) = (c2Poly { count: @*.count@, verts, norms }, C2_TYPE_C2_TYPE_POLY, x);
    let mut found: c2Manifold = unsafe { std::mem::zeroed() };
    unsafe { @asked(c2Collide)@(&raw const a as _, &x_a, kind_a, &raw const b as _, &x_b, kind_b, &mut found) };
    println!("{} points: {found:#?}", found.count);
}
