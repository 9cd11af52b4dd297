//! src/external/manifuzz_timed_world.h in Rust, and `export_timed_world!`, which adds its five
//! functions to a shared library.

use crate::{Body, Float2};

/// A body's new place.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Move {
    pub body: u32,
    pub position: Float2,
    pub rotation: Float2,
}

/// An engine's world, as the header says.
pub trait TimedWorld: Sized {
    /// Nothing where there is none of that name.
    fn create(name: &str) -> Option<Self>;
    /// Whether it can take the body.
    fn add(&mut self, body: &Body) -> bool;
    /// Nanoseconds.
    fn step(&mut self, moves: &[Move]) -> f64;
    fn contacts(&mut self) -> i64;
}

#[macro_export]
macro_rules! export_timed_world {
    ($world:ty) => {
        /// # Safety
        /// The caller keeps to manifuzz_timed_world.h.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn manifuzz_timed_world_create(
            name: *const std::ffi::c_char,
        ) -> *mut $world {
            let name = unsafe { std::ffi::CStr::from_ptr(name) };
            match name.to_str().ok().and_then(<$world as $crate::TimedWorld>::create) {
                Some(world) => Box::into_raw(Box::new(world)),
                None => std::ptr::null_mut(),
            }
        }

        /// # Safety
        /// The caller keeps to manifuzz_timed_world.h.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn manifuzz_timed_world_add(
            world: *mut $world,
            body: *const $crate::Body,
        ) -> std::ffi::c_int {
            i32::from(!$crate::TimedWorld::add(unsafe { &mut *world }, unsafe { &*body }))
        }

        /// # Safety
        /// The caller keeps to manifuzz_timed_world.h.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn manifuzz_timed_world_step(
            world: *mut $world,
            moves: *const $crate::Move,
            count: i32,
        ) -> f64 {
            let moves = match count {
                0 => &[],
                _ => unsafe { std::slice::from_raw_parts(moves, count as usize) },
            };
            unsafe { $crate::TimedWorld::step(&mut *world, moves) }
        }

        /// # Safety
        /// The caller keeps to manifuzz_timed_world.h.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn manifuzz_timed_world_contacts(world: *mut $world) -> i64 {
            unsafe { $crate::TimedWorld::contacts(&mut *world) }
        }

        /// # Safety
        /// The caller keeps to manifuzz_timed_world.h.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn manifuzz_timed_world_destroy(world: *mut $world) {
            drop(unsafe { Box::from_raw(world) });
        }
    };
}
