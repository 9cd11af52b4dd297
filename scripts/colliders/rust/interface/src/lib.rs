//! src/external/manifuzz_collider.h in Rust, which says what every member means, and `export!`,
//! which makes a shared library of a declaration and a function. A panic ends the process, which
//! counts as a crash.

mod timed_world;

use std::ffi::{c_char, c_int};
use std::ptr::null;

pub use timed_world::{Move, TimedWorld};

pub const VERTICES_MAX: usize = 8;

#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Float2 {
    pub x: f32,
    pub y: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Double2 {
    pub x: f64,
    pub y: f64,
}

#[repr(C)]
pub struct Body {
    count: i32,
    vertices: [Float2; VERTICES_MAX],
    normals: [Float2; VERTICES_MAX],
    pub radius: f32,
    pub position: Float2,
    pub rotation: Float2,
    round: i32,
}

impl Body {
    pub fn vertices(&self) -> &[Float2] {
        &self.vertices[..self.count as usize]
    }
    pub fn normals(&self) -> &[Float2] {
        &self.normals[..self.count as usize]
    }

    /// The length of the stored rotation, which is not quite 1.
    pub fn unit(&self) -> f64 {
        let Float2 { x, y } = self.rotation;
        (f64::from(x) * f64::from(x) + f64::from(y) * f64::from(y)).sqrt()
    }

    /// A direction of the body's frame in the world, as long as it was.
    pub fn turned(&self, v: Double2) -> Double2 {
        let [c, s] = [self.rotation.x, self.rotation.y].map(|part| f64::from(part) / self.unit());
        Double2 { x: c * v.x - s * v.y, y: s * v.x + c * v.y }
    }

    /// A point of the body's frame in the world.
    pub fn placed(&self, v: Double2) -> Double2 {
        let [c, s] = [self.rotation.x, self.rotation.y].map(f64::from);
        Double2 {
            x: c * v.x - s * v.y + f64::from(self.position.x),
            y: s * v.x + c * v.y + f64::from(self.position.y),
        }
    }
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Feature {
    pub kind: u8,
    pub index: u8,
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Point {
    pub position: Double2,
    pub depth: f64,
    pub feature_a: Feature,
    pub feature_b: Feature,
}

/// What an engine made of a polygon.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Shape {
    pub count: i32,
    pub vertices: [Double2; VERTICES_MAX],
}

#[repr(C)]
#[derive(Default)]
pub struct Manifold {
    count: i32,
    pub reference: i32,
    pub normal: Double2,
    points: [Point; 2],
    pub touching: i32,
    pub depth: f64,
    pub shapes: [Shape; 2],
}

impl Manifold {
    /// Adds a point; one of a separation above 0 is there for the solver alone, and left out.
    pub fn add(&mut self, position: Double2, separation: f64) {
        if separation > 0.0 {
            return;
        }
        self.points[self.count as usize] = Point { position, depth: -separation, ..Point::default() };
        self.count += 1;
    }
}

pub const FLOAT32: i32 = 0;
pub const FLOAT64: i32 = 1;
pub const WORLD: i32 = 0;
pub const FRAME_OF_A: i32 = 1;
pub const CLIP_POINTS: i32 = 0;
pub const MIDPOINTS: i32 = 1;
pub const ON_SURFACE_B: i32 = 4;
pub const A_TO_B: i32 = 0;
pub const REFERENCE_B: i32 = 2;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct Claims {
    pub answers: i32,
    pub does_not_clip: i32,
    pub shares_depth: i32,
    pub one_point_enough: i32,
    pub takes_angles: i32,
    pub alters_shapes: i32,
    pub speculative: f64,
    pub least_depth: f64,
    pub tie_bias_relative: f64,
    pub tie_bias_towards: i32,
    pub tolerance_absolute: f64,
    pub tolerance_relative: f64,
    pub tolerance_source: *const c_char,
    pub vertices_min: i32,
    pub takes_round: i32,
    pub second_point: i32,
    pub second_point_angle: f64,
    pub least_polygon_turn: f64,
    pub least_polygon_area: f64,
}

#[repr(C)]
pub struct Declaration {
    pub interface: i32,
    pub name: *const c_char,
    pub version: *const c_char,
    pub scalar: i32,
    pub rounds_in: i32,
    pub answers_in: i32,
    pub points: i32,
    pub normal: i32,
    pub tie_bias: f64,
    pub vertices_max: i32,
    pub takes_radius: i32,
    pub snippet: *const c_char,
    pub claims: Claims,
}

// SAFETY: its pointers are to constants.
unsafe impl Sync for Declaration {}

/// Manifolds that clips make, of polygons with sharp corners alone: all zero.
pub const CLAIMS: Claims = Claims {
    answers: 0,
    does_not_clip: 0,
    shares_depth: 0,
    one_point_enough: 0,
    takes_angles: 0,
    alters_shapes: 0,
    speculative: 0.0,
    least_depth: 0.0,
    tie_bias_relative: 0.0,
    tie_bias_towards: 0,
    tolerance_absolute: 0.0,
    tolerance_relative: 0.0,
    tolerance_source: null(),
    vertices_min: 0,
    takes_round: 0,
    second_point: 0,
    second_point_angle: 0.0,
    least_polygon_turn: 0.0,
    least_polygon_area: 0.0,
};

/// What follows `"version": ` in the text of an engine.json, with a 0 after it, for a declaration.
pub const fn version_in(json: &str) -> [u8; 64] {
    const KEY: &[u8] = b"\"version\": \"";
    let text = json.as_bytes();
    let (mut at, mut matched) = (0, 0);
    while matched < KEY.len() {
        matched = if text[at] == KEY[matched] { matched + 1 } else { (text[at] == KEY[0]) as usize };
        at += 1;
    }
    let mut version = [0; 64];
    let mut i = 0;
    while text[at + i] != b'"' {
        version[i] = text[at + i];
        i += 1;
    }
    assert!(i < version.len());
    version
}

/// The first of each choice.
pub const DECLARATION: Declaration = Declaration {
    interface: 4,
    name: null(),
    version: null(),
    scalar: FLOAT32,
    rounds_in: WORLD,
    answers_in: WORLD,
    points: CLIP_POINTS,
    normal: A_TO_B,
    tie_bias: 0.0,
    vertices_max: VERTICES_MAX as i32,
    takes_radius: 0,
    snippet: null(),
    claims: CLAIMS,
};

/// What an engine says to a case: nothing where it cannot be given it.
pub type Collide = fn(&Body, &Body) -> Option<Manifold>;

/// # Safety
/// All three are valid, as the header says.
pub unsafe fn answer(collide: Collide, a: *const Body, b: *const Body, to: *mut Manifold) -> c_int {
    // SAFETY: by the caller.
    match collide(unsafe { &*a }, unsafe { &*b }) {
        Some(manifold) => {
            unsafe { *to = manifold };
            0
        }
        None => 1,
    }
}

/// The shared library's two names.
#[macro_export]
macro_rules! export {
    ($declaration:expr, $collide:expr) => {
        #[allow(non_upper_case_globals)]
        #[unsafe(no_mangle)]
        pub static manifuzz_collider: $crate::Declaration = $declaration;

        /// # Safety
        /// As manifuzz_collider.h says.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn manifuzz_collide(
            a: *const $crate::Body,
            b: *const $crate::Body,
            manifold: *mut $crate::Manifold,
        ) -> std::ffi::c_int {
            unsafe { $crate::answer($collide, a, b, manifold) }
        }
    };
}
