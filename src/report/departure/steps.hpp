#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "exact/truth.hpp"
#include "judging/bounds.hpp"
#include "report/departure/replay.hpp"

namespace manifuzz {

/// One right way through the steps of a case.
struct RightWay {
  const exact::Truth& truth;
  const exact::RoughPair& polygons;
  const Bounds& bounds;
  exact::FaceOf reference;
  int incident = 0;       ///< the edge of the other polygon that is clipped
  bool is_apart = false;  ///< no contact is right: the reference is the face that separates them
};

/// What the steps choose behind a reference face that clips an edge of either polygon.
ClipChoices choices_of(const RightWay& way, exact::FaceOf reference, exact::FaceOf edge);
ClipChoices choices_of(const RightWay& way);

/// The edge as it is named in words: "B's edge 2".
std::string edge_in_words(exact::FaceOf edge);

/// Takes the choices with one of them replaced. The words say by what; they complete the sentence
/// "... the clip gives this answer".
using TryChoices = std::function<void(const std::string& words, const ClipChoices& choices)>;

/// A step of the article, and every other choice that is tried for it.
struct ClipStep {
  std::string_view name;
  void (*try_others)(const RightWay& way, const TryChoices& attempt) = nullptr;
};

/// All steps in the article's order. A step is added here, and nowhere else.
std::span<const ClipStep> clip_steps();

}  // namespace manifuzz
