#include <cmath>
#include <type_traits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "exact/curve.hpp"
#include "exchange/json.hpp"
#include "judging/by_curve.hpp"
#include "judging/manifold_error.hpp"
#include "judging/used_shapes.hpp"
#include "report/departure/departure.hpp"
#include "report/outputs.hpp"
#include "report/round_truth.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

template <class Number>
std::string digits(Number value) {
  std::string out;
  append_number(out, value);
  return out;
}

/// Given numbers, floats, to the last bit; of computed ones the sign of a zero says nothing.
template <class Number>
std::string digits(const Vector2<Number>& v) {
  constexpr Number zero = std::is_same_v<Number, float> ? -0.0F : 0;  // x + -0 is x
  return fmt::format("({}, {})", digits(v.x() + zero), digits(v.y() + zero));
}

/// A named value, the values of one block below each other.
void row(std::string& text, std::string_view name, std::string_view value) {
  text += fmt::format("  {:<18} {}\n", name, value);
}

Vector2<double> world_vertex(const Body& body, int i) {
  const Pose<double> pose{body.pose.position.cast<double>(), body.pose.rotation.cast<double>()};
  return transform<double>(pose, body.polygon.vertices[i].cast<double>());
}

void write_body(std::string& text, const Body& body, char name) {
  text += fmt::format("{}: {}\n", name, shape_in_words(body.polygon));
  row(text, "radius", digits(body.polygon.radius));
  row(text, "position", digits(body.pose.position));
  row(text, "rotation", digits(body.pose.rotation) + "  (cos, sin)");
  for (int i = 0; i < body.polygon.count; ++i) {
    row(text, fmt::format("vertex {}", i),
        fmt::format("{:<32} world {}", digits(body.polygon.vertices[i]),
                    digits(world_vertex(body, i))));
  }
}

std::string greatest_separation(const exact::Truth& truth, Side side) {
  if (!truth.has_faces(side)) return "a point has no face";
  const exact::FaceOf face = truth.greatest(side);
  return fmt::format("{:<24} {}", digits(leading(truth.fine_separation(face))),
                     face_name(side, face.index));
}

void write_truth(std::string& text, const PairCase& pair) {
  const exact::Truth truth(pair);
  const Standing stands = standing(truth);
  text += "truth\n";
  row(text, "separation S_A", greatest_separation(truth, Side::a));
  row(text, "separation S_B", greatest_separation(truth, Side::b));
  row(text, "separation S", digits(exact::separation_of(truth)));
  row(text, "total radius", digits(total_radius(pair)));
  row(text, "touching, near",
      fmt::format("{}, {}", stands.touching ? "yes" : "no", stands.near ? "yes" : "no"));
  row(text, "extent", digits(truth.extent()));
  row(text, "size", digits(truth.size()));
}

void write_bounds(std::string& text, const JudgedCase& judged) {
  const Bounds of_subject = bounds(judged.given.pair(), judged.subject.declaration);
  const Bounds of_oracle = bounds(judged.given.pair(), judged.oracle.declaration);
  const auto add_bound = [&](std::string_view name, double Bounds::*member) {
    row(text, name,
        fmt::format("{:<24} {}", digits(of_subject.*member), digits(of_oracle.*member)));
  };
  text += fmt::format("bounds               {:<24} {}\n", judged.subject.declaration.name,
                      judged.oracle.declaration.name);
  add_bound("separation, depth", &Bounds::separation);
  add_bound("incident dot", &Bounds::incident_dot);
  add_bound("normal", &Bounds::normal);
  add_bound("position", &Bounds::position);
}

void write_normal(std::string& text, const PairCase& pair, const Vector2<double>& normal) {
  row(text, "normal",
      fmt::format("world {}, local {}", digits(world_normal(pair, normal)), digits(normal)));
}

void write_points(std::string& text, const PairCase& pair, const Manifold<double>& manifold,
                  int count) {
  for (int i = 0; i < count; ++i) {
    const auto& [local, depth, features] = manifold.points[i];
    row(text, "point",
        fmt::format("world {}, local {}", digits(to_world(pair, local)), digits(local)));
    row(text, "",
        fmt::format("depth {}, features A {}, B {}", digits(depth), feature_name(features.a),
                    feature_name(features.b)));
  }
}

std::string edge(const Body& body, int face) {
  return fmt::format("{} to {}", digits(world_vertex(body, face)),
                     digits(world_vertex(body, body.polygon.next(face))));
}

void write_round_contact(std::string& text, const Admissible& right,
                         const Declaration& declaration) {
  const std::vector<Manifold<double>> manifolds = manifolds_to_show(right, declaration);
  text += fmt::format("right contact        one of {} for {}, within the bounds\n",
                      manifolds.size(), declaration.name);
  if (manifolds.empty() || manifolds.back().count == 0) return row(text, "", "no contact");
  const Manifold<double>& touching = manifolds.back();
  write_normal(text, right.pair(), touching.normal);
  write_points(text, right.pair(), touching, touching.count);
}

/// Which ends of the incident edge the side planes cut off, in the order of the points.
std::string ends_in_words(const exact::Clip& clip) {
  if (clip.misses()) return "none is between the side planes";
  const auto end = [&](int i) -> std::string {
    if (clip.cuts[i] == exact::Cut::inside) return "not clipped";
    const Side side = clip.reference.side;
    const FeaturePair& features = clip.points[i].features;
    return "clipped at " + place_name(side, side == Side::a ? features.a : features.b);
  };
  return fmt::format("first {}, second {}", end(0), end(1));
}

void write_clip(std::string& text, const PairCase& pair, const exact::Clip& clip,
                const Manifold<double>& manifold) {
  const exact::FaceOf reference = clip.reference;
  const Side incident = other(reference.side);
  row(text, "reference",
      fmt::format("{}, world {}", face_name(reference.side, reference.index),
                  edge(pair[reference.side], reference.index)));
  row(text, "incident",
      fmt::format("{}, world {}", face_name(incident, clip.incident),
                  edge(pair[incident], clip.incident)));
  row(text, "ends", ends_in_words(clip));
  write_normal(text, pair, manifold.normal);
  row(text, "cos of the angle", digits(clip.cosine));
  if (const double gap = clip.gap(); gap > 0) row(text, "misses the slab by", digits(gap));
  write_points(text, pair, manifold, manifold.count);
}

/// Each manifold that is right for the subject, a block each.
void write_right(std::string& text, const PairCase& pair, const DeclaredAnswer& subject) {
  const Admissible right = admissible(pair, subject.declaration);
  if (is_round(pair)) return write_round_contact(text, right, subject.declaration);
  const bool may_be_nothing = mismatch(Manifold<double>{}, right).kind == Kind::none;
  const std::vector<const exact::Clip*> clips = right_clips(right);
  const std::size_t count = clips.size() + (may_be_nothing ? 1 : 0);
  std::size_t written = 0;
  const auto begin_block = [&] {
    text += fmt::format("right manifold       {} of {} for {}\n", ++written, count,
                        subject.declaration.name);
  };
  if (may_be_nothing) {
    begin_block();
    row(text, "", "no contact");
  }
  for (const exact::Clip* const clip : clips) {
    begin_block();
    write_clip(text, pair, *clip, true_manifold(*clip, right.bounds.separation));
  }
}

/// Where a wrong answer departs from the article's steps.
void write_departures(std::string& text, const PairCase& pair, const DeclaredAnswer& asked) {
  const auto departures = departures_of(pair, {asked.declaration, asked.answer});
  if (departures) row(text, "why it is wrong", departures_in_words(*departures));
}

void write_answer(std::string& text, const PairCase& pair, const DeclaredAnswer& asked,
                  std::string_view role) {
  text += fmt::format("{}: {} {}, {}\n", role, asked.declaration.name, asked.declaration.version,
                      answer_in_words(asked));
  write_departures(text, pair, asked);
  const Manifold<double>* const manifold = asked.manifold();
  if (manifold == nullptr || asked.count() == 0) return;
  row(text, "reference", manifold->reference == Side::a ? "A" : "B");
  write_normal(text, pair, manifold->normal);
  write_points(text, pair, *manifold, asked.count());
}

void write_verdict(std::string& text, const Judgement& judgement) {
  const Verdict verdict = judgement.bucket.verdict;
  const std::string_view name = to_string(verdict);
  row(text, "verdict", is_unexplained(verdict) ? bad(name) : std::string(name));
  row(text, "bucket", to_string(judgement.bucket));
  row(text, "magnitude", digits(judgement.magnitude) + " of the size");
  if (judgement.explanation == nullptr) return;
  row(text, "ledger",
      fmt::format("{}: {}", judgement.explanation->id, judgement.explanation->description));
  row(text, "source", judgement.explanation->source);
}

void write_origin(std::string& text, const CorpusCase& given) {
  if (given.found) {
    row(text, "found",
        fmt::format("seed {}, regime {}, index {}", given.found->seed,
                    printable(given.found->regime), given.found->index));
  }
  if (given.expect && given.expect->severity) {
    row(text, "severity",
        digits(*given.expect->severity) + " of the neighbours, when it was saved");
  }
  if (!given.note.empty()) row(text, "note", printable(given.note, 1000));
}

}  // namespace

nlohmann::ordered_json case_json(const PairCase& pair) {
  std::string line;
  append_case_line(line, pair);
  return nlohmann::ordered_json::parse(line);
}

void append_collision(std::string& line, const Collider& collider, const PairCase& pair) {
  const Answer answer = collider.collide(pair);
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    throw UserError(fmt::format("$: {} gives no answer: {}", collider.declaration.name, lost->why));
  }
  if (const auto why = why_malformed(pair, {collider.declaration, answer})) {
    throw UserError(fmt::format("$: {} answers nonsense: {}", collider.declaration.name, *why));
  }
  append_answer(line, pair, collider.declaration.name, whole(answer, pair, collider.declaration));
}

std::string case_text(const JudgedCase& judged) {
  const PairCase& pair = judged.given.pair();
  std::string text = verdict_and_why(judged) + '\n';
  write_verdict(text, judged.judgement);
  write_origin(text, judged.given);
  write_body(text, pair.a, 'A');
  write_body(text, pair.b, 'B');
  write_truth(text, pair);
  write_bounds(text, judged);
  write_right(text, pair, judged.subject);
  write_answer(text, pair, judged.subject, "subject");
  write_answer(text, pair, judged.oracle, "oracle");
  return text;
}

}  // namespace manifuzz
