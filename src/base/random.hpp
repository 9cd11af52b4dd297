#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace manifuzz {

/// SplitMix64's finaliser (Steele, Lea, Flood 2014): every bit of the input moves every bit out.
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// FNV-1a, so that a stream depends on a name and not on a place in a list.
constexpr std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

/// 2^exponent, which is to be above -1023 and below 1024.
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// Counter-based random numbers: draw n of a stream is a function of (key, n) alone. Everything is
/// exact IEEE arithmetic, so the same draws come out of every compiler and processor. One
/// expression may hold one draw, or nested ones: C++ leaves the order of operands and arguments to
/// the compiler.
class Random {
 public:
  Random(std::uint64_t seed, std::string_view stream, std::uint64_t index)
      : Random(seed, hash_of(stream), index) {}
  /// By the stream's hash.
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t index)
      : place_(mix(mix(seed + kGolden) ^ mix(stream) ^ mix(index * kGolden + 1))) {}

  std::uint64_t bits() {
    place_ += kGolden;
    return mix(place_);
  }

  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * unit(); }

  /// In {low, ..., high}. The bias, below 2^-32 times the width, does not matter here.
  int integer(int low, int high) {
    const auto width = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(((bits() >> 32) * width) >> 32);
  }

  /// Whether `unit` is below the probability, which is at least 0; of a constant one, integers
  /// alone say so.
  bool chance(double probability) {
    return bits() >> 11 < static_cast<std::uint64_t>(std::ceil(probability * 0x1p53));
  }

  /// 2^k times [1, 2), k in {low, ..., high - 1}: spread over magnitudes without a logarithm.
  double magnitude(int low, int high) {
    const int exponent = integer(low, high - 1);
    return uniform(1, 2) * power_of_two(exponent);
  }

  /// x or -x.
  double either_sign(double x) { return chance(0.5) ? x : -x; }

 private:
  static constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;
  std::uint64_t place_;  ///< key + n * kGolden
};

/// The float `steps` away in the order of the floats; x itself where that would not be finite.
inline float stepped(float x, int steps) {
  constexpr std::int64_t sign = 0x80000000;
  const std::int64_t bits = std::bit_cast<std::uint32_t>(x);
  const std::int64_t ordered = (bits < sign ? bits : sign - bits) + steps;
  const std::int64_t moved = ordered >= 0 ? ordered : sign - ordered;
  const float result = std::bit_cast<float>(static_cast<std::uint32_t>(moved));
  return std::isfinite(x) && std::isfinite(result) ? result : x;
}

/// The distance from |x| to the next float above it.
inline double ulp_of(double x) {
  const float magnitude = static_cast<float>(std::abs(x));
  return static_cast<double>(stepped(magnitude, 1)) - static_cast<double>(magnitude);
}

}  // namespace manifuzz
