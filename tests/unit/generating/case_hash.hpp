#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "geometry/pair_case.hpp"

namespace manifuzz {

/// FNV-1a of every bit that makes cases; the normals follow from them.
class CaseHash {
 public:
  void add(const PairCase& pair) {
    for (const Body* body : {&pair.a, &pair.b}) {
      for (const auto& v : body->polygon.corners()) {
        add(v.x());
        add(v.y());
      }
      for (const float x : {body->polygon.radius, body->pose.position.x(), body->pose.position.y(),
                            body->pose.rotation.x(), body->pose.rotation.y()}) {
        add(x);
      }
    }
  }

  std::string hex() const { return fmt::format("{:016x}", hash_); }

 private:
  void add(float x) { hash_ = (hash_ ^ std::bit_cast<std::uint32_t>(x)) * 0x100000001b3ULL; }

  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace manifuzz
