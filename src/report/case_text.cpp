#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "exact/curve.hpp"
#include "exchange/json.hpp"
#include "judging/by_curve.hpp"
#include "judging/manifold_error.hpp"
#include "judging/unjudged.hpp"
#include "judging/used_shapes.hpp"
#include "report/departure/departure.hpp"
#include "report/outputs.hpp"
#include "report/round_truth.hpp"
#include "report/rows.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

Vector2<double> world_vertex(const Body& body, int i) {
  const Pose<double> pose{body.pose.position.cast<double>(), body.pose.rotation.cast<double>()};
  return transform<double>(pose, body.polygon.vertices[i].cast<double>());
}

void write_body(Rows& rows, const Body& body, char name) {
  rows.text += fmt::format("{}: {}\n", name, shape_in_words(body.polygon));
  rows.add("radius", digits(body.polygon.radius));
  rows.add("position", digits(body.pose.position));
  rows.add("rotation", digits(body.pose.rotation) + "  (cos, sin)");
  for (int i = 0; i < body.polygon.count; ++i) {
    rows.add(fmt::format("vertex {}", i),
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

void write_truth(Rows& rows, const PairCase& pair) {
  const exact::Truth truth(pair);
  const Standing stands = standing(truth);
  rows.text += "truth\n";
  rows.add("separation S_A", greatest_separation(truth, Side::a));
  rows.add("separation S_B", greatest_separation(truth, Side::b));
  rows.add("separation S", digits(exact::separation_of(truth)));
  rows.add("total radius", digits(total_radius(pair)));
  rows.add("touching, near",
           fmt::format("{}, {}", stands.touching ? "yes" : "no", stands.near ? "yes" : "no"));
  rows.add("extent", digits(truth.extent()));
  rows.add("size", digits(truth.size()));
}

void write_bounds(Rows& rows, const JudgedCase& judged) {
  const Bounds of_subject = bounds(judged.given.pair(), judged.subject.declaration);
  const Bounds of_oracle = bounds(judged.given.pair(), judged.oracle.declaration);
  const auto add_bound = [&](std::string_view name, double Bounds::*member) {
    rows.add(name, fmt::format("{:<24} {}", digits(of_subject.*member), digits(of_oracle.*member)));
  };
  rows.text += fmt::format("bounds               {:<24} {}\n", judged.subject.declaration.name,
                           judged.oracle.declaration.name);
  add_bound("separation, depth", &Bounds::separation);
  add_bound("incident dot", &Bounds::incident_dot);
  add_bound("normal", &Bounds::normal);
  add_bound("position", &Bounds::position);
}

void write_normal(Rows& rows, const PairCase& pair, const Vector2<double>& normal) {
  rows.add("normal",
           fmt::format("world {}, local {}", digits(world_normal(pair, normal)), digits(normal)));
}

void write_points(Rows& rows, const PairCase& pair, const Manifold<double>& manifold, int count) {
  for (int i = 0; i < count; ++i) {
    const auto& [local, depth, features] = manifold.points[i];
    rows.add("point",
             fmt::format("world {}, local {}", digits(to_world(pair, local)), digits(local)));
    rows.add("", fmt::format("depth {}, features A {}, B {}", digits(depth),
                             feature_name(features.a), feature_name(features.b)));
  }
}

std::string edge(const Body& body, int face) {
  return fmt::format("{} to {}", digits(world_vertex(body, face)),
                     digits(world_vertex(body, body.polygon.next(face))));
}

void write_round_contact(Rows& rows, const Admissible& right, const Declaration& declaration) {
  const std::vector<Manifold<double>> manifolds = manifolds_to_show(right, declaration);
  rows.text += fmt::format("right contact        one of {} for {}, within the bounds\n",
                           manifolds.size(), declaration.name);
  if (manifolds.empty() || manifolds.back().count == 0) return rows.add("", "no contact");
  const Manifold<double>& touching = manifolds.back();
  write_normal(rows, right.pair(), touching.normal);
  write_points(rows, right.pair(), touching, touching.count);
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

void write_clip(Rows& rows, const PairCase& pair, const exact::Clip& clip,
                const Manifold<double>& manifold) {
  const exact::FaceOf reference = clip.reference;
  const Side incident = other(reference.side);
  rows.add("reference", fmt::format("{}, world {}", face_name(reference.side, reference.index),
                                    edge(pair[reference.side], reference.index)));
  rows.add("incident", fmt::format("{}, world {}", face_name(incident, clip.incident),
                                   edge(pair[incident], clip.incident)));
  rows.add("ends", ends_in_words(clip));
  write_normal(rows, pair, manifold.normal);
  rows.add("cos of the angle", digits(clip.cosine));
  if (const double gap = clip.gap(); gap > 0) rows.add("misses the slab by", digits(gap));
  write_points(rows, pair, manifold, manifold.count);
}

/// Each manifold that is right for the subject, a block each.
void write_right(Rows& rows, const PairCase& pair, const DeclaredAnswer& subject) {
  const Admissible right = admissible(pair, subject.declaration);
  if (is_round(pair)) return write_round_contact(rows, right, subject.declaration);
  const bool may_be_nothing = mismatch(Manifold<double>{}, right).kind == Kind::none;
  const std::vector<const exact::Clip*> clips = right_clips(right);
  const std::size_t count = clips.size() + (may_be_nothing ? 1 : 0);
  std::size_t written = 0;
  const auto begin_block = [&] {
    rows.text += fmt::format("right manifold       {} of {} for {}\n", ++written, count,
                             subject.declaration.name);
  };
  if (may_be_nothing) {
    begin_block();
    rows.add("", "no contact");
  }
  for (const exact::Clip* const clip : clips) {
    begin_block();
    write_clip(rows, pair, *clip, true_manifold(*clip, right.bounds.separation));
  }
}

void write_answer(Rows& rows, const PairCase& pair, const DeclaredAnswer& asked,
                  std::string_view role) {
  rows.text += fmt::format("{}: {} {}, {}\n", role, asked.declaration.name,
                           asked.declaration.version, answer_in_words(asked));
  const auto departures = departures_of(pair, {asked.declaration, asked.answer});
  if (departures) rows.add("why it is wrong", departures_in_words(*departures));
  const Manifold<double>* const manifold = asked.manifold();
  if (manifold == nullptr || asked.count() == 0) return;
  rows.add("reference", manifold->reference == Side::a ? "A" : "B");
  write_normal(rows, pair, manifold->normal);
  write_points(rows, pair, *manifold, asked.count());
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
  Rows rows{.name_width = 18, .text = verdict_and_why(judged) + '\n'};
  rows.add_finding(judged.judgement.bucket, judged.judgement.magnitude,
                   judged.judgement.explanation);
  rows.add_origin(judged.given, "regime");
  write_body(rows, pair.a, 'A');
  write_body(rows, pair.b, 'B');
  write_truth(rows, pair);
  write_bounds(rows, judged);
  write_right(rows, pair, judged.subject);
  write_answer(rows, pair, judged.subject, "subject");
  write_answer(rows, pair, judged.oracle, "oracle");
  return rows.text;
}

}  // namespace manifuzz
