#pragma once

#include <optional>

#include "afresh/defect.hpp"

namespace manifuzz::scene {

/// What holds for all pairs of a scene.
struct Settings {
  /// A face of B is taken only where it leads by more than this (a length, >= 0).
  float tie_bias = 0;
  /// Pairs that touch keep their contact, carried along rigidly, until a vertex has moved by this,
  /// seen from the other body (a length). 0 is strict: the same bits as colliding them afresh.
  float recycled_motion = 0;
  /// Pairs are proven to be apart, and then skipped. Off, all pairs that moved are collided: the
  /// same contacts.
  bool certificates = true;
};

/// The first defect of settings, or none.
inline std::optional<Defect> find_defect(const Settings& settings) {
  for (const float length : {settings.tie_bias, settings.recycled_motion}) {
    if (!(length >= 0 && length <= kLengthMax)) return Defect::setting_not_a_length;
  }
  return std::nullopt;
}

}  // namespace manifuzz::scene
