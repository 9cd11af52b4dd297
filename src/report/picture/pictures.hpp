#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/plan.hpp"
#include "judging/judge.hpp"

namespace manifuzz {

// The pictures of a case.

/// The case as an SVG document: verdict, polygons, overlap, reference and incident, every
/// collider's points with their depths, closer views of what is too small to be seen, a legend.
std::string case_svg(const JudgedCase& judged);

/// The penetration curve of the case as an SVG document: the depth in every direction around the
/// shapes, the least one ringed, every collider's answer a mark at its normal and depth, and in
/// words what each mark means.
std::string curve_svg(const JudgedCase& judged);
/// Its plot alone, for a narrow place, and what would stand around it.
struct CurvePlot {
  std::string svg;
  std::vector<std::string> words;
};
CurvePlot curve_plot(const JudgedCase& judged);
/// The picture as a PNG file.
std::string curve_png(const JudgedCase& judged);

/// The neighbourhood as a PNG file: what the subject says, what the oracle says, what is true and
/// the verdict, side by side, with the severity and a legend in words.
std::string map_png(const JudgedCase& judged, const Neighbourhood& neighbourhood);

/// A case's neighbourhood, drawn.
struct CaseMap {
  std::string png;                 ///< the file's bytes
  std::vector<std::string> words;  ///< what it is a map of, and its severity
};

/// Asks both about every neighbour, which lie `step_ulps` apart. Throws Interrupted.
CaseMap case_map(const JudgedCase& judged, const Collider& subject, const Collider& oracle,
                 int step_ulps, Interruption& interruption);

/// The case as a picture of characters, for terminals, logs and code blocks: outlines, overlap,
/// right contact points and those of the answers (the subject, then the oracle if there is one), a
/// closer view where these are too near each other, a legend. At most 76 characters wide but for
/// the legend, and 46 lines with it; UTF-8.
std::string text_picture(const PairCase& pair, std::span<const DeclaredAnswer> answers);

/// Whether cases of a kind are drawn in text.
inline bool has_text_picture(CaseKind kind) {
  return kind == CaseKind::pair;
}

/// A case between two colliders, as text.
std::string text_picture(const JudgedCase& judged);

}  // namespace manifuzz
