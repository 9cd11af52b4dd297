#include "report/page/page_case.hpp"

#include <array>
#include <span>

#include <fmt/format.h>

#include "exchange/json.hpp"
#include "oracle/exact/rough.hpp"
#include "report/page/base64.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vector2<double>& v) {
  return Json::array({v.x(), v.y()});
}

template <class Value>
Json value_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json body_json(const Body& body, const exact::RoughPolygon& polygon) {
  Json vertices = Json::array();
  for (int i = 0; i < polygon.count; ++i) vertices.push_back(vector_json(polygon.vertices[i]));
  return {{"vertices", vertices},
          {"radius", static_cast<double>(body.polygon.radius)},
          {"position", vector_json(body.pose.position.cast<double>())}};
}

/// The edge of one polygon that features of a manifold's points name: by itself, or by its ends.
std::optional<int> edge_of(const Manifold<double>& manifold, Side side, int count) {
  std::array<int, 2> corners{-1, -1};
  for (int i = 0; i < manifold.count; ++i) {
    const FeaturePair& features = manifold.points[i].features;
    const Feature feature = side == Side::a ? features.a : features.b;
    if (feature.kind == Feature::Kind::face) return feature.index;
    corners[static_cast<std::size_t>(i)] = feature.index;
  }
  if (manifold.count < 2) return std::nullopt;
  for (const auto& [from, to] : {std::pair(corners[0], corners[1]), {corners[1], corners[0]}}) {
    if ((from + 1) % count == to) return from;
  }
  return std::nullopt;
}

Json point_json(const PairCase& pair, const ContactPoint<double>& point) {
  const Vector2<double> seen = rotate<double>(pair.a.pose.rotation.cast<double>(), point.position);
  return {{"position", vector_json(seen)},
          {"world", vector_json(to_world(pair, point.position))},
          {"depth", point.depth},
          {"features", {feature_name(point.features.a), feature_name(point.features.b)}}};
}

Json manifold_json(const PairCase& pair, const Manifold<double>& manifold, int count) {
  Json points = Json::array();
  for (int i = 0; i < count; ++i) points.push_back(point_json(pair, manifold.points[i]));
  Json json{{"normal", nullptr},
            {"reference", nullptr},
            {"face", nullptr},
            {"edge", nullptr},
            {"points", points}};
  if (count == 0) return json;
  const Side incident = other(manifold.reference);
  json["normal"] = vector_json(world_normal(pair, manifold.normal));
  json["reference"] = manifold.reference == Side::a ? "a" : "b";
  json["face"] =
      value_or_null(edge_of(manifold, manifold.reference, pair[manifold.reference].polygon.count));
  json["edge"] = value_or_null(edge_of(manifold, incident, pair[incident].polygon.count));
  return json;
}

Json answer_json(const PairCase& pair, const DeclaredAnswer& asked, std::string_view role) {
  Json manifolds = Json::array();
  if (asked.manifold() != nullptr) {
    manifolds.push_back(manifold_json(pair, *asked.manifold(), asked.count()));
  }
  return {{"role", role},
          {"name", asked.declaration.name},
          {"version", asked.declaration.version},
          {"words", answer_in_words(asked)},
          {"manifolds", manifolds}};
}

Json truth_json(const PageCase& page_case) {
  const PairCase& pair = page_case.judged.given.pair;
  Json manifolds = Json::array();
  for (const Manifold<double>& right : page_case.right) {
    manifolds.push_back(manifold_json(pair, right, right.count));
  }
  return {{"role", "truth"},
          {"name", kJudgeName},
          {"version", ""},
          {"words", truth_in_words(pair)},
          {"manifolds", manifolds}};
}

Json found_json(const std::optional<Found>& found) {
  if (!found) return nullptr;
  return {{"seed", found->seed},
          {"regime", found->regime},
          {"index", found->index},
          {"versions", found->versions}};
}

/// The verdict as a sentence; without a judgement, what its file says.
std::string sentence_of(const PageCase& page_case) {
  if (page_case.is_judged) return verdict_sentence(page_case.judged);
  const CorpusCase& given = page_case.judged.given;
  return given.note.empty() ? truth_in_words(given.pair) : given.note;
}

Json map_json(const std::optional<CaseMap>& map) {
  return map ? Json("data:image/png;base64," + base64(map->png)) : Json();
}

}  // namespace

Json page_case_json(const PageCase& page_case) {
  const JudgedCase& judged = page_case.judged;
  const CorpusCase& given = judged.given;
  const PairCase& pair = given.pair;
  const exact::Truth truth(pair);
  const exact::RoughPair placed = exact::place_roughly(pair);
  const Expectation expect = given.expect.value_or(Expectation{});
  const Bucket& bucket = judged.judgement.bucket;
  std::string line;
  append_case_line(line, pair);
  const bool is_recorded = !expect.bucket.empty() || !page_case.is_judged;
  return {{"file", given.path},
          {"role", page_case.smallest.empty() ? "smallest" : "worst"},
          {"smallest", page_case.smallest.empty() ? Json() : Json(page_case.smallest)},
          {"bucket", is_recorded ? expect.bucket : to_string(bucket)},
          {"verdict", is_recorded ? expect.verdict : std::string(to_string(bucket.verdict))},
          {"regime", given.found ? given.found->regime : ""},
          {"subject", judged.subject.declaration.name},
          {"oracle", judged.oracle.declaration.name},
          {"sentence", sentence_of(page_case)},
          {"note", given.note},
          {"property", given.property},
          {"severity", value_or_null(expect.severity)},
          {"magnitude", page_case.is_judged ? Json(judged.judgement.magnitude) : Json()},
          {"count", value_or_null(page_case.count)},
          {"found", found_json(given.found)},
          {"commands", page_case.commands},
          {"case", line},
          {"separation", truth.separation()},
          {"total_radius", total_radius(pair)},
          {"size", truth.size()},
          {"extent", truth.extent()},
          {"origin", vector_json(pair.a.pose.position.cast<double>())},
          {"bodies", {body_json(pair.a, placed.a), body_json(pair.b, placed.b)}},
          {"answers",
           {truth_json(page_case), answer_json(pair, judged.subject, "subject"),
            answer_json(pair, judged.oracle, "oracle")}},
          {"map", map_json(page_case.map)},
          {"map_words", page_case.map ? Json(page_case.map->words) : Json::array()}};
}

}  // namespace manifuzz
