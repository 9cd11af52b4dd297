#include "oracle/libccd/ledger/prisms.hpp"

#include <algorithm>
#include <cmath>

// oracle/libccd/prism.hpp.

namespace manifuzz::ledger_of {

CcdPrisms::Prism CcdPrisms::placed(const Body& body, double half_height) {
  Prism prism{{}, half_height};
  const Vector2<double> turn = body.pose.rotation.cast<double>();
  const Vector2<double> place = body.pose.position.cast<double>();
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<double> vertex = body.polygon.vertices[i].cast<double>();
    prism.corners.emplace_back(turn.x() * vertex.x() - turn.y() * vertex.y() + place.x(),
                               turn.y() * vertex.x() + turn.x() * vertex.y() + place.y());
  }
  return prism;
}

CcdPrisms::CcdPrisms(const PairCase& pair, const Heights& heights) {
  const auto reach = [](const Body& body) {
    double farthest = 0;
    for (int i = 0; i < body.polygon.count; ++i) {
      const Vector2<double> vertex = body.polygon.vertices[i].cast<double>();
      farthest = std::max(farthest, std::hypot(vertex.x(), vertex.y()));
    }
    return farthest;
  };
  const double both = reach(pair.a) + reach(pair.b);
  a_ = placed(pair.a, heights.a * both);
  b_ = placed(pair.b, heights.b * both);
}

CcdVector CcdPrisms::Prism::farthest(const CcdVector& along) const {
  std::size_t best = 0;
  const auto far = [&](std::size_t i) {
    return corners[i].x() * along.x() + corners[i].y() * along.y();
  };
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (far(i) > far(best)) best = i;
  }
  return {corners[best].x(), corners[best].y(), along.z() < 0 ? -half_height : half_height};
}

CcdVector CcdPrisms::Prism::middle() const {
  Vector2<double> sum(0, 0);
  for (const Vector2<double>& corner : corners) sum += corner;
  const auto count = static_cast<double>(corners.size());
  return {sum.x() / count, sum.y() / count, 0};
}

CcdVector CcdPrisms::support(const CcdVector& along) const {
  return a_.farthest(along) - b_.farthest(along * -1.0);
}

CcdVector CcdPrisms::middle() const {
  return a_.middle() - b_.middle();
}

}  // namespace manifuzz::ledger_of
