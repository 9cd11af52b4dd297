#include "conformance/right_clips.hpp"

#include <algorithm>
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
      : out_(out), clip_(clip), points_(std::move(points)) {
    for (const ClipPoint* const point : points_) {
      const auto [position, depth] =
          exact::locate<exact::Approximate<exact::DoubleDouble>>(clip, point->end);
      places_.push_back({{leading(position.x.value), leading(position.y.value)},
                         leading(depth.value),
                         point->features});
    }
  }

  void append(const std::vector<InScalar>& scalars) {
    out_ += clip_.reference.side == Side::a ? R"({"reference": "a", "normal": )"
                                            : R"({"reference": "b", "normal": )";
    append_vector(out_, exact::true_manifold(clip_).normal);
    append_list("points", places_, [&](const ContactPoint<double>& place) {
      append_vector(out_ += "{\"local\": ", place.position);
      append_number(out_ += ", \"depth\": ", place.depth);
      out_ += ", \"features\": [\"" + feature_name(place.features.a) + "\",\"" +
              feature_name(place.features.b) + "\"]}";
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
    append_widened(out_, in.right.bounds.normal + lost_in_writing(1));
    std::vector<double> positions;
    std::vector<double> depths;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double reach = places_[i].position.norm();
      positions.push_back(position_bound(in.right, clip_, *points_[i]) + lost_in_writing(reach));
      depths.push_back(depth_bound(in.right, clip_, *points_[i]) +
                       lost_in_writing(places_[i].depth));
    }
    const auto append_one = [&](double bound) { append_widened(out_, bound); };
    append_list("local", positions, append_one);
    append_list("depth", depths, append_one);
    append_indices("needed", in, [](const auto& right, const auto& clip, const auto& point) {
      return !is_optional(right, clip, point);
    });
    append_indices("features", in, features_decided);
    out_ += '}';
  }

  std::string& out_;
  const Clip& clip_;
  std::vector<const ClipPoint*> points_;
  std::vector<ContactPoint<double>> places_;
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
