#pragma once

/// What the headers, compiled with this project's options, and the kernels find of many pairs.
struct Bits {
  unsigned long long sum = 0;  ///< over all bits of polygons, poses and manifolds
  int pairs = 0;
  int differences = 0;  ///< between the clipping, compiled here, and the kernels
};

__attribute__((visibility("default"))) Bits sum_of_bits();
