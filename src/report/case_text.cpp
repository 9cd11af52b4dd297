#include "report/case_text.hpp"

#include <iterator>

#include <fmt/format.h>

#include "cases/text.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

using truth::Real;

template <class Number>
std::string exact(Number value) {
  std::string out;
  append_number(out, value);
  return out;
}

template <class Number>
std::string exact(const Vector2<Number>& v) {
  return fmt::format("({}, {})", exact(v.x()), exact(v.y()));
}

std::string exact(Real value) {
  return exact(static_cast<double>(value));
}

class Text {
 public:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  /// A named value, the values of one block below each other.
  void row(std::string_view name, std::string_view value) { line("  {:<18} {}", name, value); }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string feature_name(Feature feature) {
  return fmt::format("{}{}", feature.kind == Feature::Kind::face ? 'f' : 'v', feature.index);
}

std::string features_name(const FeaturePair& features) {
  return fmt::format("A {}, B {}", feature_name(features.a), feature_name(features.b));
}

Vector2<double> world_vertex(const Body& body, int i) {
  const Pose<double> pose{body.pose.position.cast<double>(), body.pose.rotation.cast<double>()};
  return transform<double>(pose, body.polygon.vertices[i].cast<double>());
}

void write_body(Text& text, const Body& body, char name) {
  text.line("{}", name);
  text.row("radius", exact(body.polygon.radius));
  text.row("position", exact(body.pose.position));
  text.row("rotation", exact(body.pose.rotation) + "  (cos, sin)");
  for (int i = 0; i < body.polygon.count; ++i) {
    text.row(fmt::format("vertex {}", i),
             fmt::format("{:<32} world {}", exact(body.polygon.vertices[i]),
                         exact(world_vertex(body, i))));
  }
}

std::string greatest_separation(const truth::World<Real>& world, Side side) {
  const GreatestFace greatest = greatest_face(world, side);
  return fmt::format("{:<24} {}", exact(greatest.separation), face_name(side, greatest.face));
}

void write_truth(Text& text, const PairCase& pair) {
  const auto world = truth::place<Real>(pair);
  const Standing stands = standing(pair);
  text.line("truth");
  text.row("separation S_A", greatest_separation(world, Side::a));
  text.row("separation S_B", greatest_separation(world, Side::b));
  text.row("separation S", exact(stands.separation));
  text.row("total radius", exact(total_radius(pair)));
  text.row("touching, near",
           fmt::format("{}, {}", stands.touching ? "yes" : "no", stands.near ? "yes" : "no"));
  text.row("extent", exact(extent(pair)));
  text.row("size", exact(size(pair)));
}

void write_bounds(Text& text, const ShownCase& shown) {
  const Bounds of_subject = bounds(shown.given.pair, shown.subject.declaration);
  const Bounds of_oracle = bounds(shown.given.pair, shown.oracle.declaration);
  const auto row = [&](std::string_view name, double Bounds::*member) {
    text.row(name, fmt::format("{:<24} {}", exact(of_subject.*member), exact(of_oracle.*member)));
  };
  text.line("bounds               {:<24} {}", shown.subject.declaration.name,
            shown.oracle.declaration.name);
  row("separation", &Bounds::separation);
  row("incident dot", &Bounds::incident_dot);
  row("normal", &Bounds::normal);
  row("position, depth", &Bounds::length);
}

void write_point(Text& text, const PairCase& pair, const Vector2<double>& local, double depth,
                 const FeaturePair& features) {
  text.row("point", fmt::format("world {}, local {}", exact(to_world(pair, local)), exact(local)));
  text.row("", fmt::format("depth {}, features {}", exact(depth), features_name(features)));
}

std::string edge(const Body& body, int face) {
  return fmt::format("{} to {}", exact(world_vertex(body, face)),
                     exact(world_vertex(body, body.polygon.next(face))));
}

void write_candidate(Text& text, const PairCase& pair, const Party& subject) {
  const Admissible right = admissible(pair, subject.declaration);
  text.line("right manifold       one of {} for {}", right.candidates.size(),
            subject.declaration.name);
  const Candidate* const shown = candidate_to_show(right, subject);
  if (shown == nullptr) return text.row("", "no contact");
  const Side incident_side = other(shown->reference_side);
  const truth::Clip& clip = shown->clip;
  text.row("reference",
           fmt::format("{}, world {}", face_name(shown->reference_side, shown->reference),
                       edge(pair[shown->reference_side], shown->reference)));
  text.row("incident", fmt::format("{}, world {}", face_name(incident_side, shown->incident),
                                   edge(pair[incident_side], shown->incident)));
  const Vector2<double> normal = clip.normal.cast<double>();
  text.row("normal",
           fmt::format("world {}, local {}", exact(world_normal(pair, normal)), exact(normal)));
  text.row("cos of the angle", exact(clip.cosine));
  if (clip.gap > 0) text.row("misses the slab by", exact(clip.gap));
  for (int i = 0; i < clip.count; ++i) {
    const truth::ClipPoint& point = clip.points[i];
    write_point(text, pair, point.position.cast<double>(), static_cast<double>(point.depth),
                point.features);
  }
}

void write_answer(Text& text, const PairCase& pair, const Party& party, std::string_view role) {
  text.line("{}: {} {}, {}", role, party.declaration.name, party.declaration.version,
            answer_in_words(party));
  const Manifold<double>* const manifold = party.manifold();
  if (manifold == nullptr || party.count() == 0) return;
  text.row("reference", manifold->reference == Side::a ? "A" : "B");
  text.row("normal", fmt::format("world {}, local {}", exact(world_normal(pair, manifold->normal)),
                                 exact(manifold->normal)));
  for (int i = 0; i < party.count(); ++i) {
    const ContactPoint<double>& point = manifold->points[i];
    write_point(text, pair, point.position, point.depth, point.features);
  }
}

void write_verdict(Text& text, const Judgement& judgement) {
  text.row("verdict", to_string(judgement.bucket.verdict));
  text.row("bucket", to_string(judgement.bucket));
  text.row("magnitude", exact(judgement.magnitude) + " of the size");
  if (judgement.explanation == nullptr) return;
  text.row("ledger",
           fmt::format("{}: {}", judgement.explanation->id, judgement.explanation->description));
  text.row("source", judgement.explanation->source);
}

void write_origin(Text& text, const CorpusCase& given) {
  if (given.found) {
    text.row("found", fmt::format("seed {}, regime {}, index {}", given.found->seed,
                                  printable(given.found->regime), given.found->index));
  }
  if (!given.note.empty()) text.row("note", printable(given.note, 1000));
}

}  // namespace

std::string case_text(const ShownCase& shown) {
  const PairCase& pair = shown.given.pair;
  Text text;
  text.line("{}", verdict_sentence(shown));
  write_verdict(text, shown.judgement);
  write_origin(text, shown.given);
  write_body(text, pair.a, 'A');
  write_body(text, pair.b, 'B');
  write_truth(text, pair);
  write_bounds(text, shown);
  write_candidate(text, pair, shown.subject);
  write_answer(text, pair, shown.subject, "subject");
  write_answer(text, pair, shown.oracle, "oracle");
  return text.take();
}

}  // namespace manifuzz
