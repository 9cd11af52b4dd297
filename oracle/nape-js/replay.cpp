#include "oracle/nape-js/replay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace manifuzz::ledger_of {
namespace {

constexpr double kEpsilonOfNape = 1e-8;  // nape.Config.epsilon
constexpr double kSquareOfNape = kEpsilonOfNape * kEpsilonOfNape;
constexpr double kFarthestOfNape = 1e100;

using Corner = Vector2<double>;

/// ZPP_Edge.
struct EdgeOfNape {
  Corner from{0, 0};
  Corner to{0, 0};
  Corner normal{0, 0};
  double projection = 0;
  double low = 0;   ///< tp1
  double high = 0;  ///< tp0
};

using PolygonOfNape = std::vector<EdgeOfNape>;

/// validate_laxi, validate_gverts and validate_gaxi.
PolygonOfNape polygon_of_nape(const Body& body) {
  const Corner rotation = body.pose.rotation.cast<double>();
  const double angle = std::atan2(rotation.y(), rotation.x());
  const Pose<double> pose{body.pose.position.cast<double>(), {std::cos(angle), std::sin(angle)}};
  const std::vector<Corner> corners = spliced_by_nape(given_to_nape(body));
  PolygonOfNape polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& u = corners[i];
    const Corner& v = corners[(i + 1) % corners.size()];
    const double x = u.x() - v.x();
    const double y = u.y() - v.y();
    const double inverse = 1.0 / std::sqrt(x * x + y * y);
    const Corner local(-(y * inverse), x * inverse);
    EdgeOfNape edge{.from = transform(pose, u), .to = transform(pose, v)};
    edge.normal = rotate(pose.rotation, local);
    edge.projection = pose.position.dot(edge.normal) + local.dot(u);
    edge.high = cross(edge.normal, edge.from);
    edge.low = cross(edge.normal, edge.to);
    polygon.push_back(edge);
  }
  return polygon;
}

/// The first edge of the greatest separation, above `most`; none where one is a separating axis.
struct BestOfNape {
  const EdgeOfNape* edge = nullptr;
  bool is_apart = false;
};

BestOfNape best_of_nape(const PolygonOfNape& on, const PolygonOfNape& of, double& most) {
  BestOfNape best;
  for (const EdgeOfNape& edge : on) {
    double least = kFarthestOfNape;
    for (const EdgeOfNape& other : of) {
      const double along = edge.normal.x() * other.from.x() + edge.normal.y() * other.from.y();
      least = std::min(least, along);
      if (least - edge.projection <= most) break;
    }
    least -= edge.projection;
    if (least >= 0) return {nullptr, true};
    if (!(least > most)) continue;
    most = least;
    best.edge = &edge;
  }
  return best;
}

ContactOfNape cut_by_nape(const EdgeOfNape& face, const PolygonOfNape& of, CutOfNape cut) {
  const EdgeOfNape* incident = &of.front();
  double least = kFarthestOfNape;
  for (const EdgeOfNape& edge : of) {
    const double cosine = face.normal.x() * edge.normal.x() + face.normal.y() * edge.normal.y();
    if (!(cosine < least)) continue;
    least = cosine;
    incident = &edge;
  }
  const Corner along = incident->to - incident->from;
  // Along the face, against the order of its corners.
  const double first = cross(incident->from, face.normal);
  const double last = cross(incident->to, face.normal);
  ContactOfNape found;
  found.run = last - first;
  const double inverse = 1 / found.run;
  const double most = cut == CutOfNape::within_edge ? 1 : INFINITY;
  found.ends = {incident->from, incident->to};
  const double of_first = (-face.low - first) * inverse;
  const double of_last = (-face.high - last) * inverse;
  if (of_first > kEpsilonOfNape) found.ends[0] += std::min(of_first, most) * along;
  if (of_last < -kEpsilonOfNape) found.ends[1] += std::max(of_last, -most) * along;
  for (const std::size_t k : {0U, 1U}) {
    const Corner& end = found.ends[k];
    found.depths[k] = -(end.x() * face.normal.x() + end.y() * face.normal.y() - face.projection);
  }
  return found;
}

/// contactCollide of the first and the second of its shapes.
std::optional<ContactOfNape> contact_of_nape(const PolygonOfNape& first,
                                             const PolygonOfNape& second, CutOfNape cut) {
  double most = -kFarthestOfNape;
  const BestOfNape of_first = best_of_nape(first, second, most);
  if (of_first.is_apart) return std::nullopt;
  const BestOfNape of_second = best_of_nape(second, first, most);
  const bool is_of_second = of_second.edge != nullptr;
  const EdgeOfNape* const face = is_of_second ? of_second.edge : of_first.edge;
  if (of_second.is_apart || face == nullptr) return std::nullopt;
  ContactOfNape found = cut_by_nape(*face, is_of_second ? first : second, cut);
  if (found.depths[0] < 0 && found.depths[1] < 0) return std::nullopt;
  found.reference = is_of_second ? Side::b : Side::a;
  found.normal = is_of_second ? Corner(-face->normal) : face->normal;
  return found;
}

}  // namespace

// ZPP_Polygon.splice_collinear_real: a corner within epsilon of the next goes, and then each whose
// sides' cross product is below epsilon, until there is none.
std::vector<Vector2<double>> spliced_by_nape(std::vector<Vector2<double>> corners) {
  const auto at = [&](std::size_t i) -> const Vector2<double>& {
    return corners[i % corners.size()];
  };
  const auto erase = [&](std::size_t i) {
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i % corners.size()));
  };
  for (std::size_t i = 0; i < corners.size();) {
    const Vector2<double> apart = at(i) - at(i + 1);
    if (apart.x() * apart.x() + apart.y() * apart.y() < kSquareOfNape) {
      erase(i);
    } else {
      ++i;
    }
  }
  for (bool is_removed = true; is_removed && !corners.empty();) {
    is_removed = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2<double> a = at(i + 1) - at(i);
      const Vector2<double> b = at(i + 2) - at(i + 1);
      const double turn = cross(a, b);
      if (turn * turn >= kSquareOfNape) continue;
      // The first is erased from before this one.
      const bool is_first = i + 1 == corners.size();
      erase(i + 1);
      is_removed = true;
      if (is_first) --i;
    }
  }
  return corners;
}

std::vector<Vector2<double>> given_to_nape(const Body& body) {
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  const double length = std::sqrt(rotation.x() * rotation.x() + rotation.y() * rotation.y());
  std::vector<Vector2<double>> corners;
  for (int i = 0; i < body.polygon.count; ++i) {
    corners.emplace_back(length * body.polygon.vertices[i].cast<double>());
  }
  return corners;
}

std::vector<ContactOfNape> contacts_of_nape(const PairCase& pair, CutOfNape cut) {
  std::vector<ContactOfNape> found;
  if (std::min(pair.a.polygon.count, pair.b.polygon.count) < kMinVertices) return found;
  const PolygonOfNape a = polygon_of_nape(pair.a);
  const PolygonOfNape b = polygon_of_nape(pair.b);
  if (a.empty() || b.empty()) return found;
  if (const auto contact = contact_of_nape(a, b, cut)) found.push_back(*contact);
  if (auto contact = contact_of_nape(b, a, cut)) {
    contact->reference = other(contact->reference);
    contact->normal = -contact->normal;
    found.push_back(*contact);
  }
  return found;
}

}  // namespace manifuzz::ledger_of
