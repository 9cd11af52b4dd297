#include "conformance/right_clips.hpp"

#include <algorithm>
#include <ranges>
#include <vector>

#include "base/text.hpp"
#include "conformance/widened.hpp"
#include "exchange/json.hpp"
#include "judging/admissible.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

using exact::Clip;
using exact::ClipPoint;
using Fine = exact::Approximate<exact::DoubleDouble>;

/// What is right in one scalar.
struct InScalar {
  ScalarType scalar;
  Admissible right;
};

/// The ends of a clip that a right manifold may have: those that are not in front of the face by
/// more than the bound, in any scalar.
std::vector<const ClipPoint*> possible_points(const Clip& clip,
                                              const std::vector<InScalar>& scalars) {
  std::vector<const ClipPoint*> points;
  for (const ClipPoint& point : points_of(clip)) {
    const bool is_possible = std::ranges::any_of(scalars, [&](const InScalar& in) {
      return compare_depth(clip, point, -depth_bound(in.right, clip, point)) >= 0;
    });
    if (is_possible) points.push_back(&point);
  }
  return points;
}

/// Whether points of this clip are right in that scalar.
bool is_candidate(const InScalar& in, const Clip& clip) {
  return std::ranges::count(in.right.candidates, &clip) > 0 &&
         compare_gap(clip, in.right.bounds.separation) <= 0;
}

class ClipWriter {
 public:
  ClipWriter(std::string& out, const Clip& clip, std::vector<const ClipPoint*> points)
      : out_(out),
        clip_(clip),
        points_(std::move(points)),
        normal_(exact::true_normal<Fine>(clip)) {
    for (const ClipPoint* const point : points_) {
      places_.push_back(exact::locate<Fine>(clip, point->end));
    }
  }

  void append(const std::vector<InScalar>& scalars) {
    out_ += clip_.reference.side == Side::a ? R"({"reference": "a", "normal": )"
                                            : R"({"reference": "b", "normal": )";
    append_vector(out_, Vector2<double>(leading(normal_.x.value), leading(normal_.y.value)));
    append_list("points", std::views::iota(std::size_t{0}, points_.size()), [&](std::size_t i) {
      const auto& [position, depth] = places_[i];
      const FeaturePair& features = points_[i]->features;
      append_vector(out_ += "{\"local\": ",
                    Vector2<double>(leading(position.x.value), leading(position.y.value)));
      append_number(out_ += ", \"depth\": ", leading(depth.value));
      out_ += ", \"features\": [\"" + feature_name(features.a) + "\",\"" +
              feature_name(features.b) + "\"]}";
    });
    for (const InScalar& in : scalars) {
      if (is_candidate(in, clip_)) append_bounds(in);
    }
    out_ += '}';
  }

 private:
  template <class List, class Append>
  void append_list(std::string_view key, const List& list, const Append& append) {
    out_.append(", \"").append(key) += "\": [";
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0) out_ += ',';
      append(list[i]);
    }
    out_ += ']';
  }

  void append_indices(std::string_view key, const InScalar& in,
                      bool (*is_so)(const Admissible&, const Clip&, const ClipPoint&)) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (is_so(in.right, clip_, *points_[i])) indices.push_back(i);
    }
    append_list(key, indices, [&](std::size_t i) { out_ += std::to_string(i); });
  }

  void append_bounds(const InScalar& in) {
    out_.append(", \"").append(scalar_key(in.scalar)) += "\": {\"normal\": ";
    append_widened(out_, in.right.bounds.normal);
    append_list("local", points_, [&](const ClipPoint* point) {
      append_widened(out_, position_bound(in.right, clip_, *point));
    });
    append_list("depth", points_, [&](const ClipPoint* point) {
      append_widened(out_, depth_bound(in.right, clip_, *point));
    });
    append_indices("needed", in, [](const auto& right, const auto& clip, const auto& point) {
      return !is_optional(right, clip, point);
    });
    append_indices("features", in, features_decided);
    if (in.scalar == ScalarType::float64) append_lows();
    out_ += '}';
  }

  /// Appends what rounding to doubles lost of the normal, then of each place and depth.
  void append_lows() {
    append_low(out_ += ", \"low\": [", normal_.x.value);
    append_low(out_ += ',', normal_.y.value);
    for (const auto& [position, depth] : places_) {
      for (const Fine& figure : {position.x, position.y, depth}) {
        append_low(out_ += ',', figure.value);
      }
    }
    out_ += ']';
  }

  std::string& out_;
  const Clip& clip_;
  std::vector<const ClipPoint*> points_;
  std::vector<exact::Located<Fine>> places_;
  exact::Point<Fine> normal_;
};

}  // namespace

void append_right_clips(std::string& out, const exact::Truth& truth) {
  std::vector<InScalar> scalars;
  std::vector<const Clip*> clips;
  out += "\"empty\": [";
  for (const ScalarType scalar : kScalars) {
    scalars.push_back({scalar, admissible(exact::unowned(truth), port_declaration(scalar))});
    const Admissible& right = scalars.back().right;
    for (const Clip* const clip : right.candidates) {
      if (is_candidate(scalars.back(), *clip) && std::ranges::count(clips, clip) == 0) {
        clips.push_back(clip);
      }
    }
    if (mismatch(Manifold<double>(), right).kind != Kind::none) continue;
    if (out.back() != '[') out += ',';
    out.append("\"").append(scalar_key(scalar)) += '"';
  }
  out += "], \"right\": [";
  for (const Clip* const clip : clips) {
    auto points = possible_points(*clip, scalars);
    if (points.empty()) continue;
    if (out.back() != '[') out += ", ";
    ClipWriter(out, *clip, std::move(points)).append(scalars);
  }
  out += ']';
}

}  // namespace manifuzz
