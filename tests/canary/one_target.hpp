#pragma once

// To be included before Highway: copies of the kernels are compiled for one instruction set, since
// each costs time. It has lanes (without -m flags, x86 would have one), and every machine has it.
#define HWY_COMPILE_ONLY_STATIC
#if defined(__x86_64__)
#define HWY_BASELINE_TARGETS (HWY_SSE4 | HWY_SCALAR)
#endif
