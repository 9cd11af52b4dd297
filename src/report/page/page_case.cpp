#include <algorithm>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <limits>
#include <span>

#include "exact/placed.hpp"
#include "exchange/json.hpp"
#include "report/page/page.hpp"
#include "report/picture/drawing.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

/// Bytes as text, after RFC 4648.
std::string base64(std::string_view bytes) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<const char*, 6, 8>>;
  std::string text(Digits(bytes.data()), Digits(bytes.data() + bytes.size()));
  return text.append((4 - text.size() % 4) % 4, '=');
}

Json vector_json(const Vector2<double>& v) {
  return Json::array({v.x(), v.y()});
}

template <class Value>
Json value_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json segment_json(const Segment& segment) {
  return {vector_json(segment.first), vector_json(segment.second)};
}

/// What is filled: the core, or of round shapes what is around it too.
Region filled(const PairCase& pair, const exact::RoughPair& placed, Side side) {
  const double radius = is_round(pair) ? static_cast<double>(pair[side].polygon.radius) : 0;
  const Rim rim = rim_of(placed[side], radius, Rounding::round);
  return region_of(rim, box_around_rim(rim), radius / 1000);
}

/// Where a polygon's letter stands: off its middle, away from what it shares with the other.
Point letter_place(const Region& own, const Region& other) {
  Region outside = own;
  std::erase_if(outside, [&](const Point& p) { return depth_in(other, p) > 0; });
  return outside.empty() ? middle_of(own) : Point((middle_of(own) + middle_of(outside)) / 2);
}

/// How thick a convex region is where it is thinnest.
double thickness(const Region& region) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Point along = unit_or_zero(region[(i + 1) % region.size()] - region[i]);
    double most = 0;
    for (const Point& p : region) most = std::max(most, cross<double>(along, p - region[i]));
    if (along != Point(0, 0)) least = std::min(least, most);
  }
  return least;
}

Json body_json(const PairCase& pair, Side side, const exact::RoughPolygon& placed,
               const Region& own, const Region& other) {
  Json vertices = Json::array();
  for (const Point& vertex : placed.corners()) vertices.push_back(vector_json(vertex));
  return {{"vertices", vertices},
          {"radius", static_cast<double>(pair[side].polygon.radius)},
          {"corners", is_round(pair) ? "round" : "mitre"},
          {"letter", vector_json(letter_place(own, other))}};
}

/// The edge of one polygon that features of these points name: by itself, or by its ends. Where
/// round shapes are nearest at a vertex, from that to itself.
std::optional<Segment> named_edge(std::span<const ContactPoint<double>> points, Side side,
                                  const exact::RoughPolygon& polygon, bool is_round) {
  const auto is_named = [&](Feature::Kind kind, int index) {
    return std::ranges::any_of(points, [&](const ContactPoint<double>& point) {
      const Feature feature = side == Side::a ? point.features.a : point.features.b;
      return feature.kind == kind && feature.index == index;
    });
  };
  const auto at = [&polygon](int vertex) { return polygon.vertices[vertex]; };
  for (int i = 0; i < polygon.face_count(); ++i) {
    const int next = polygon.next(i);
    const bool by_ends =
        is_named(Feature::Kind::vertex, i) && is_named(Feature::Kind::vertex, next);
    if (by_ends || is_named(Feature::Kind::face, i)) {
      return Segment{at(i), at(next)};
    }
  }
  for (int i = 0; is_round && i < polygon.count; ++i) {
    if (is_named(Feature::Kind::vertex, i)) return Segment{at(i), at(i)};
  }
  return std::nullopt;
}

/// Two points of the line of each side plane: of the reference face's ends, widened by the radii.
/// Side planes of round shapes are not drawn: they are perpendicular to a normal that is not the
/// face's.
Json planes_json(const PairCase& pair, const Segment& face) {
  if (is_round(pair)) return Json::array();
  const Point along = unit_or_zero(face.second - face.first);
  const Point away = counter_clockwise_quarter<double>(along) * length(face.second - face.first);
  const Point first = face.first - total_radius(pair) * along;
  const Point second = face.second + total_radius(pair) * along;
  return {segment_json({first, first + away}), segment_json({second, second + away})};
}

/// `outward` points from the incident shape out of the reference face. The bar is the depth as a
/// stretch along it, from the incident skin below the point to the reference's.
Json point_json(const PairCase& pair, const ContactPoint<double>& point, const Point& outward,
                Side incident) {
  const Point seen = exact::seen_from_a(pair, point.position);
  // A round shape's point is on its surface.
  const double radius = is_round(pair) ? 0 : static_cast<double>(pair[incident].polygon.radius);
  const Point skin = seen - radius * outward;
  const Segment bar{skin, skin + point.depth * outward};
  const bool has_bar = bar.first.allFinite() && bar.second.allFinite();
  return {{"position", vector_json(seen)},
          {"world", vector_json(to_world(pair, point.position))},
          {"depth", point.depth},
          {"features", {feature_name(point.features.a), feature_name(point.features.b)}},
          {"bar", has_bar ? segment_json(bar) : Json()}};
}

/// A malformed manifold may say any count.
Json manifold_json(const PairCase& pair, const Manifold<double>& manifold) {
  Json json{{"normal", nullptr}, {"outward", nullptr}, {"reference", nullptr},   {"face", nullptr},
            {"planes", nullptr}, {"edge", nullptr},    {"points", Json::array()}};
  const auto count = static_cast<std::size_t>(std::clamp(manifold.count, 0, 2));
  if (count == 0) return json;
  const exact::RoughPair placed = exact::place_roughly(pair);
  const Side incident = other(manifold.reference);
  const Point normal = world_normal(pair, manifold.normal);
  const Point outward = incident == Side::b ? unit_or_zero(normal) : Point(-unit_or_zero(normal));
  json["normal"] = vector_json(normal);
  json["outward"] = outward.allFinite() ? vector_json(outward) : Json();
  json["reference"] = manifold.reference == Side::a ? "a" : "b";
  const auto points = std::span(manifold.points).first(count);
  const Side reference = manifold.reference;
  if (const auto face = named_edge(points, reference, placed[reference], is_round(pair))) {
    json["face"] = segment_json(*face);
    json["planes"] = planes_json(pair, *face);
  }
  if (const auto edge = named_edge(points, incident, placed[incident], false)) {
    json["edge"] = segment_json(*edge);
  }
  for (const ContactPoint<double>& point : points) {
    json["points"].push_back(point_json(pair, point, outward, incident));
  }
  return json;
}

Json answer_json(const PairCase& pair, std::string_view role, const Declaration& by,
                 const std::string& words, std::span<const Manifold<double>> manifolds) {
  Json json{{"role", role}, {"name", by.name}, {"version", by.version}, {"words", words}};
  json["manifolds"] = Json::array();
  for (const Manifold<double>& manifold : manifolds) {
    json["manifolds"].push_back(manifold_json(pair, manifold));
  }
  return json;
}

Json answer_json(const PairCase& pair, std::string_view role, const DeclaredAnswer& asked) {
  const std::span manifolds(asked.manifold(), asked.manifold() == nullptr ? 0 : 1);
  return answer_json(pair, role, asked.declaration, answer_in_words(asked), manifolds);
}

/// The verdict as a sentence; without a judgement, what its file says.
std::string sentence_of(const PageCase& page_case) {
  if (page_case.is_judged) return verdict_and_why(page_case.judged);
  const CorpusCase& given = page_case.judged.given;
  return given.note.empty() ? truth_in_words(given.pair()) : given.note;
}

}  // namespace

Json page_case_json(const PageCase& page_case) {
  const JudgedCase& judged = page_case.judged;
  const CorpusCase& given = judged.given;
  const PairCase& pair = given.pair();
  const exact::Truth truth(pair);
  const exact::RoughPair placed = exact::place_roughly(pair);
  const Region a = filled(pair, placed, Side::a);
  const Region b = filled(pair, placed, Side::b);
  const Expectation expect = given.expect.value_or(Expectation{});
  const Bucket& bucket = judged.judgement.bucket;
  const CurvePlot curve = curve_plot(judged);
  Declaration judge;
  judge.name = kJudgeName;
  std::string line;
  append_case_line(line, pair);
  // The overlap of the polygons, or else the thinner of them.
  const Region overlap = intersection(a, b);
  const Region& thin = overlap.size() >= 3 ? overlap : thickness(a) < thickness(b) ? a : b;
  Json found;
  if (given.found) {
    found = {{"seed", given.found->seed},
             {"regime", given.found->regime},
             {"index", given.found->index},
             {"versions", given.found->versions}};
  }
  const auto recorded = find_bucket(expect.bucket);
  const bool is_mended = page_case.is_judged && recorded && is_unexplained(recorded->verdict) &&
                         !is_unexplained(bucket.verdict);
  const bool is_recorded = (!expect.bucket.empty() || !page_case.is_judged) && !is_mended;
  return {
      {"file", given.path},
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
      {"found", found},
      {"commands", page_case.commands},
      {"case", line},
      {"separation", truth.separation()},
      {"total_radius", total_radius(pair)},
      {"size", truth.size()},
      {"extent", truth.extent()},
      {"origin", vector_json(pair.a.pose.position.cast<double>())},
      {"bodies",
       {body_json(pair, Side::a, placed.a, a, b), body_json(pair, Side::b, placed.b, b, a)}},
      {"thinnest", {{"center", vector_json(middle_of(thin))}, {"thickness", thickness(thin)}}},
      {"answers",
       {answer_json(pair, "truth", judge, truth_in_words(pair), page_case.right),
        answer_json(pair, "subject", judged.subject), answer_json(pair, "oracle", judged.oracle)}},
      {"curve", curve.svg},
      {"curve_words", curve.words},
      {"map", page_case.map ? Json("data:image/png;base64," + base64(page_case.map->png)) : Json()},
      {"map_words", page_case.map ? Json(page_case.map->words) : Json::array()}};
}

}  // namespace manifuzz
