#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "report/outputs.hpp"
#include "report/rows.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

template <class Number>
std::string place_of(const Vector2<Number>& v) {
  return fmt::format("({}, {})", digits(v.x()), digits(v.y()));
}

void write_shape(Rows& rows, const ConvexPolygon<float>& shape, char name) {
  rows.text += fmt::format("{}: {}\n", name, shape_in_words(shape));
  for (int i = 0; i < shape.count; ++i) {
    rows.add(fmt::format("vertex {}", i), place_of(shape.vertices[i]));
  }
}

std::string pose_in_words(const Pose<float>& pose) {
  return fmt::format("at {}, rotation {}", place_of(pose.position), place_of(pose.rotation));
}

/// Since when, with which normal, and how deep.
std::string point_in_words(const PairCase& pair, const KeptPoint& point, std::size_t frame) {
  const bool is_new = point.born == static_cast<int>(frame);
  return fmt::format("{}, depth {}, normal {} with {}, at {} on A ({}) and {} on B",
                     is_new ? "born" : fmt::format("kept since frame {}", point.born),
                     digits(point.depth), place_of(without_negative_zeros(point.normal)),
                     name_of(point.travels_with), place_of(point.anchor_a),
                     "world " + place_of(to_world(pair, point.anchor_a)), place_of(point.anchor_b));
}

/// The points that the frame before had and this one has not.
std::string left_out(const JudgedSequence& judged, std::size_t frame) {
  if (frame == 0 || frame >= judged.answers.size()) return "";
  const std::vector<KeptPoint> now = points_in(judged, frame);
  std::string names;
  for (const KeptPoint& before : points_in(judged, frame - 1)) {
    if (std::ranges::find(now, before.id, &KeptPoint::id) != now.end()) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", before.id);
  }
  return names;
}

void write_frame(Rows& rows, const JudgedSequence& judged, std::size_t frame) {
  const PairCase pair = judged.given.sequence().at(frame);
  const FrameJudgement* const verdict =
      frame < judged.judgement.frames.size() ? &judged.judgement.frames[frame] : nullptr;
  const std::string words = frame_in_words(judged, frame);
  const bool is_wrong = verdict != nullptr && verdict->kind != Kind::none;
  rows.text += fmt::format("frame {}: {}\n", frame, is_wrong ? bad(words) : words);
  rows.add("A", pose_in_words(pair.a.pose));
  rows.add("B", pose_in_words(pair.b.pose));
  const TrueOverlap truth = true_overlap(pair, judged.subject.declaration);
  std::string true_words = fmt::format("{} {}, normal", truth.depth < 0 ? "apart by" : "overlap",
                                       digits(truth.depth < 0 ? -truth.depth : truth.depth));
  for (const Vector2<double>& normal : truth.normals) {
    true_words += (&normal == &truth.normals.front() ? " " : " or ") +
                  place_of(without_negative_zeros(normal));
  }
  rows.add("truth", true_words);
  if (frame >= judged.answers.size()) return;
  const std::vector<KeptPoint> points = points_in(judged, frame);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_to_blame = is_wrong && verdict->point == i;
    rows.add(fmt::format("point {}{}", points[i].id, is_to_blame ? " *" : ""),
             point_in_words(pair, points[i], frame));
  }
  if (points.empty()) rows.add("points", "none");
  const std::string left = left_out(judged, frame);
  if (!left.empty()) rows.add("dropped", left);
}

/// Whether a frame is shown: in a long sequence those about the frame that decides, the last, and
/// all that are wrong.
bool is_shown(const JudgedSequence& judged, std::size_t frame) {
  constexpr std::size_t shown_whole = 32;
  const std::size_t count = judged.given.sequence().frames.size();
  const std::size_t deciding = judged.judgement.frame;
  if (count <= shown_whole || frame + 1 == count) return true;
  if (frame + 2 >= deciding && frame <= deciding + 1) return true;
  return frame < judged.judgement.frames.size() &&
         judged.judgement.frames[frame].kind != Kind::none;
}

void write_frames(Rows& rows, const JudgedSequence& judged) {
  for (std::size_t k = 0; k < judged.given.sequence().frames.size(); ++k) {
    std::size_t next = k;
    while (!is_shown(judged, next)) ++next;
    if (next > k) {
      rows.text +=
          fmt::format("frames {} to {}: {}\n", k, next - 1,
                      next <= judged.judgement.frames.size() ? "nothing is wrong" : "not judged");
      k = next;
    }
    write_frame(rows, judged, k);
  }
}

}  // namespace

std::string sequence_text(const JudgedSequence& judged) {
  const SequenceJudgement& judgement = judged.judgement;
  Rows rows{.name_width = 12, .text = verdict_sentence(judged) + '\n'};
  rows.add_finding(judgement.bucket, judgement.magnitude, judgement.explanation);
  rows.add_origin(judged.given, "motion");
  write_shape(rows, judged.given.sequence().a, 'A');
  write_shape(rows, judged.given.sequence().b, 'B');
  write_frames(rows, judged);
  return rows.text;
}

void append_sequence_judgement(std::string& lines, std::size_t sequence,
                               const JudgedSequence& judged) {
  const SequenceJudgement& judgement = judged.judgement;
  for (std::size_t k = 0; k < judged.given.sequence().frames.size(); ++k) {
    static constexpr FrameJudgement kNotJudged{};
    const FrameJudgement& frame = k < judgement.frames.size() ? judgement.frames[k] : kNotJudged;
    const TrueOverlap truth =
        true_overlap(judged.given.sequence().at(k), judged.subject.declaration);
    if (k > 0) lines += '\n';
    lines += fmt::format(
        "{{\"sequence\": {}, \"frame\": {}, \"penetration\": {{\"depth\": ", sequence, k);
    append_number(lines, truth.depth);
    std::string_view separator = ", \"normals\": [";
    for (const Vector2<double>& normal : truth.normals) {
      append_vector(lines.append(separator), without_negative_zeros(normal));
      separator = ", ";
    }
    append_string(lines += "]}, \"kind\": ", name_of(frame.kind, kKindNames));
    lines += ", \"point\": " + (frame.point ? std::to_string(*frame.point) : "null");
    append_number(lines += ", \"magnitude\": ", frame.magnitude);
    append_number(lines += ", \"bound\": ", frame.bound);
    append_string(lines += ", \"verdict\": ", to_string(judgement.bucket.verdict));
    append_string(lines += ", \"bucket\": ", to_string(judgement.bucket));
    lines += '}';
  }
}

}  // namespace manifuzz
