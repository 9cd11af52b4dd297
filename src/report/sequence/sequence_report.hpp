#pragma once

#include <string>
#include <vector>

#include "campaign/run.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "exchange/kept_json.hpp"

namespace manifuzz {

// Sequences, and colliders that keep points over them, for people.

/// What there is, a line each, with its description.
std::string keeper_line(const SequenceCollider& keeper);
std::string list_motions();

/// How deep the shapes truly overlap in a frame, and along which normals, in the world, from A to
/// B: each at which the depth is least within the subject's bound.
struct TrueOverlap {
  double depth = 0;  ///< a world length; negative across a gap
  std::vector<Vector2<double>> normals;
};
TrueOverlap true_overlap(const PairCase& pair, const Declaration& subject);

/// What is wrong in a frame, or "right"; of an answer that never came, what became of it.
std::string frame_in_words(const JudgedSequence& judged, std::size_t frame);

/// The points of a frame; none where there is no answer.
std::vector<KeptPoint> points_in(const JudgedSequence& judged, std::size_t frame);

/// The verdict as a sentence: "cached is wrong in frame 3: a point is kept past what is declared,
/// by 0.01".
std::string verdict_sentence(const JudgedSequence& judged);

/// The sequence for a terminal: verdict, shapes, and frame by frame where the bodies stand, what is
/// kept, born and left, how deep, and what is wrong. Numbers read back bit for bit.
std::string sequence_text(const JudgedSequence& judged);

/// Appends what `judge` prints of a sequence: a line a frame, but for the last one's end.
void append_sequence_judgement(std::string& lines, std::size_t sequence,
                               const JudgedSequence& judged);

/// The sequence as a filmstrip, an SVG document: its frames side by side, or those that matter,
/// with the bodies, the kept points, their anchors and normals, the true normal, the depths; what
/// is wrong framed in red.
std::string filmstrip_svg(const JudgedSequence& judged);

/// A campaign of sequences: what ran, and each motion's frames and verdicts.
std::string sequence_heading(const CampaignResult& result, std::uint64_t seed);
std::string motion_rows(const CampaignResult& result);

}  // namespace manifuzz
