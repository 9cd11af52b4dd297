//! cute_c2 in C, as crate c2-sys builds it.

#[path = "../../cute/adapter.rs"]
mod adapter;

use adapter::{COMMON, collide};
use manifuzz_collider::{Declaration, export, version_in};

const VERSION: &[u8] = &version_in(include_str!("../../../engine.json"));

const OURS: Declaration = Declaration {
    name: c"cute_c2".as_ptr(),
    version: VERSION.as_ptr().cast(),
    snippet: concat!(include_str!("../../cute/snippet.c"), "\0").as_ptr().cast(),
    ..COMMON
};

export!(OURS, collide);
