#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "report/outputs.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

template <class Number>
std::string digits_of(Number value) {
  std::string out;
  append_number(out, value);
  return out;
}

template <class Number>
std::string place_of(const Vector2<Number>& v) {
  return fmt::format("({}, {})", digits_of(v.x()), digits_of(v.y()));
}

/// A named value, the values of one block below each other.
void add_row(std::string& text, std::string_view name, std::string_view value) {
  text += fmt::format("  {:<12} {}\n", name, value);
}

void write_shape(std::string& text, const ConvexPolygon<float>& shape, char name) {
  text += fmt::format("{}: {}\n", name, shape_in_words(shape));
  for (int i = 0; i < shape.count; ++i) {
    add_row(text, fmt::format("vertex {}", i), place_of(shape.vertices[i]));
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
                     digits_of(point.depth), place_of(without_negative_zeros(point.normal)),
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

void write_frame(std::string& text, const JudgedSequence& judged, std::size_t frame) {
  const PairCase pair = judged.given.sequence().at(frame);
  const FrameJudgement* const verdict =
      frame < judged.judgement.frames.size() ? &judged.judgement.frames[frame] : nullptr;
  const std::string words = frame_in_words(judged, frame);
  const bool is_wrong = verdict != nullptr && verdict->kind != Kind::none;
  text += fmt::format("frame {}: {}\n", frame, is_wrong ? bad(words) : words);
  add_row(text, "A", pose_in_words(pair.a.pose));
  add_row(text, "B", pose_in_words(pair.b.pose));
  const TrueOverlap truth = true_overlap(pair, judged.subject.declaration);
  std::string true_words = fmt::format("{} {}, normal", truth.depth < 0 ? "apart by" : "overlap",
                                       digits_of(truth.depth < 0 ? -truth.depth : truth.depth));
  for (const Vector2<double>& normal : truth.normals) {
    true_words += (&normal == &truth.normals.front() ? " " : " or ") +
                  place_of(without_negative_zeros(normal));
  }
  add_row(text, "truth", true_words);
  if (frame >= judged.answers.size()) return;
  const std::vector<KeptPoint> points = points_in(judged, frame);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_to_blame = is_wrong && verdict->point == i;
    add_row(text, fmt::format("point {}{}", points[i].id, is_to_blame ? " *" : ""),
            point_in_words(pair, points[i], frame));
  }
  if (points.empty()) add_row(text, "points", "none");
  const std::string left = left_out(judged, frame);
  if (!left.empty()) add_row(text, "dropped", left);
}

void write_outcome(std::string& text, const JudgedSequence& judged) {
  const SequenceJudgement& judgement = judged.judgement;
  const Verdict verdict = judgement.bucket.verdict;
  const std::string name(to_string(verdict));
  add_row(text, "verdict", is_unexplained(verdict) ? bad(name) : name);
  add_row(text, "bucket", to_string(judgement.bucket));
  add_row(text, "magnitude", digits_of(judgement.magnitude) + " of the size");
  if (const LedgerEntry* const entry = judgement.explanation) {
    add_row(text, "ledger", fmt::format("{}: {}", entry->id, entry->description));
    add_row(text, "source", entry->source);
  }
  if (judged.given.found) {
    add_row(text, "found",
            fmt::format("seed {}, motion {}, index {}", judged.given.found->seed,
                        printable(judged.given.found->regime), judged.given.found->index));
  }
  if (!judged.given.note.empty()) add_row(text, "note", printable(judged.given.note, 1000));
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

void write_frames(std::string& text, const JudgedSequence& judged) {
  for (std::size_t k = 0; k < judged.given.sequence().frames.size(); ++k) {
    std::size_t next = k;
    while (!is_shown(judged, next)) ++next;
    if (next > k) {
      text +=
          fmt::format("frames {} to {}: {}\n", k, next - 1,
                      next <= judged.judgement.frames.size() ? "nothing is wrong" : "not judged");
      k = next;
    }
    write_frame(text, judged, k);
  }
}

}  // namespace

std::string sequence_text(const JudgedSequence& judged) {
  std::string text = verdict_sentence(judged) + '\n';
  write_outcome(text, judged);
  write_shape(text, judged.given.sequence().a, 'A');
  write_shape(text, judged.given.sequence().b, 'B');
  write_frames(text, judged);
  return text;
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
    fmt::format_to(std::back_inserter(lines),
                   "{{\"sequence\": {}, \"frame\": {}, \"penetration\": {{\"depth\": ", sequence,
                   k);
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
