//! cute_c2 1.08 in C, as crate c2-sys 0.1 builds it.

#[path = "../../cute/adapter.rs"]
mod adapter;

use adapter::{COMMON, collide};
use manifuzz_collider::{Declaration, export};

const OURS: Declaration = Declaration {
    name: c"cute_c2".as_ptr(),
    version: c"1.08".as_ptr(),
    snippet: concat!(include_str!("../../cute/snippet.c"), "\0").as_ptr().cast(),
    ..COMMON
};

export!(OURS, collide);
