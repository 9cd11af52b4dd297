#include <cstdio>

#include "bits.hpp"

int main() {
  const Bits bits = sum_of_bits();
  std::printf("%d differences in %d pairs, %016llx\n", bits.differences, bits.pairs, bits.sum);
}
