//! cute_c2 written anew in Rust, crate c2-sys 0.2.

#[path = "../../cute/adapter.rs"]
mod adapter;

use adapter::{COMMON, collide};
use manifuzz_collider::{Declaration, export};

const OURS: Declaration = Declaration {
    name: c"c2-sys".as_ptr(),
    version: c"0.2.0".as_ptr(),
    snippet: concat!(include_str!("../../cute/snippet.rs"), "\0").as_ptr().cast(),
    ..COMMON
};

export!(OURS, collide);
