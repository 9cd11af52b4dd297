#pragma once

#include <optional>
#include <string>

#include "campaign/plan.hpp"

namespace manifuzz {

/// What an answer does to two bodies, where a solver pushes B by the depth along the normal that
/// it was given: world lengths, and an angle.
struct Effect {
  bool is_contact = false;   ///< whether there is a contact at all
  double size = 0;           ///< of the smaller shape
  double overlap = 0;        ///< how deep they overlap; negative: how far they are apart
  double push = 0;           ///< the depth given
  double overlap_after = 0;  ///< once B is pushed; negative: how far they are apart then
  double turn = 0;           ///< of the normal given from the nearest right one, in radians
  double length = 1;         ///< of the normal given
  double rounding = 0;       ///< within which two lengths are alike
  double turn_rounding = 0;  ///< within which two directions are alike
};

Effect effect_of(const JudgedCase& judged, const DeclaredAnswer& asked);

/// How deep two bodies overlap once B is moved by `push` in the world: negative across a gap.
/// As near as double says it.
double overlap_once_pushed(const PairCase& pair, const Vector2<double>& push);

/// What is seen of an answer, and how large that is.
struct Sight {
  std::string text;
  double share = 1;       ///< of the smaller shape's size; of a direction an angle in radians
  bool is_length = true;  ///< else a direction
};

/// What becomes of the bodies by a push along the given normal; none where that is as it should be.
std::optional<Sight> seen_of_push(const Effect& effect);

/// "0.5 degrees", or radians where they are few.
std::string angle_in_words(double radians);

}  // namespace manifuzz
