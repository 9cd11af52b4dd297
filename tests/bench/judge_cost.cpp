// What a full exact verdict costs, and what the penetration curve does, in calls of
// b2CollidePolygons, by regime: medians of paired rounds within this run. The curve judges clip's
// manifolds as points that no clip made, and their normals and depths alone.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

using Clock = std::chrono::steady_clock;

struct Filled {
  b2PolygonShape a;
  b2PolygonShape b;
  b2Transform at_a;
  b2Transform at_b;
};

b2PolygonShape filled(const ConvexPolygon<float>& polygon) {
  b2PolygonShape shape;
  for (int i = 0; i < polygon.count; ++i) {
    shape.m_vertices[i] = {polygon.vertices[i].x(), polygon.vertices[i].y()};
    shape.m_normals[i] = {polygon.normals[i].x(), polygon.normals[i].y()};
  }
  shape.m_count = polygon.count;
  shape.m_radius = polygon.radius;
  return shape;
}

b2Transform filled(const Pose<float>& pose) {
  b2Transform transform;
  transform.p = {pose.position.x(), pose.position.y()};
  transform.q.c = pose.rotation.x();
  transform.q.s = pose.rotation.y();
  return transform;
}

template <class Work>
double time_ns(std::size_t count, const Work& work) {
  const auto start = Clock::now();
  for (std::size_t i = 0; i < count; ++i) work(i);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() /
         static_cast<double>(count);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Its manifolds as points that no clip made, or as normals and depths.
Declaration claiming(const Collider& collider, Claims claims) {
  Declaration declaration = collider.declaration;
  declaration.claims = claims;
  declaration.clips = false;
  return declaration;
}

Answer without_points(const Answer& answer) {
  const auto said = said_along(answer);
  if (!said) return Penetration{};
  return Penetration{.touches = true, .normal = said->normal, .depth = said->depth};
}

void measure(const Regime& regime) {
  constexpr std::size_t count = 2000;
  constexpr int rounds = 15;
  const Collider clip = make_clip();
  const Collider box2d = make_box2d();
  std::vector<PairCase> pairs;
  std::vector<Filled> shapes;
  std::vector<std::array<Answer, 2>> answers;
  for (std::size_t i = 0; i < count; ++i) {
    const PairCase& pair = pairs.emplace_back(generate(1, regime, i));
    shapes.push_back(
        {filled(pair.a.polygon), filled(pair.b.polygon), filled(pair.a.pose), filled(pair.b.pose)});
    answers.push_back({clip.collide(pair), box2d.collide(pair)});
  }
  const Declaration with_points = claiming(clip, Claims::manifold);
  const Declaration separation = claiming(clip, Claims::separation);
  std::vector<Answer> separations;
  for (const auto& answer : answers) separations.push_back(without_points(answer[0]));
  std::vector<double> ratios;
  std::vector<double> times;
  std::vector<double> curve_ratios;
  std::vector<double> separation_ratios;
  int contacts = 0;
  std::size_t explained = 0;
  for (int round = 0; round < rounds; ++round) {
    const double of_box2d = time_ns(count, [&](std::size_t i) {
      b2Manifold manifold;
      b2CollidePolygons(&manifold, &shapes[i].a, shapes[i].at_a, &shapes[i].b, shapes[i].at_b);
      contacts += manifold.pointCount;
    });
    const double of_judge = time_ns(count, [&](std::size_t i) {
      const auto verdict =
          judge(pairs[i], {clip.declaration, answers[i][0]}, {box2d.declaration, answers[i][1]});
      explained += static_cast<std::size_t>(verdict.bucket.verdict);
    });
    const auto by_curve = [&](const Declaration& declaration, const auto& answer) {
      return time_ns(count, [&](std::size_t i) {
        const exact::Truth truth(pairs[i]);
        explained += static_cast<std::size_t>(judge_by_curve(truth, declaration, answer(i)).kind);
      });
    };
    curve_ratios.push_back(
        by_curve(with_points, [&](std::size_t i) -> const Answer& { return answers[i][0]; }) /
        of_box2d);
    separation_ratios.push_back(
        by_curve(separation, [&](std::size_t i) -> const Answer& { return separations[i]; }) /
        of_box2d);
    ratios.push_back(of_judge / of_box2d);
    times.push_back(of_judge);
  }
  std::printf("%-16s %8.0f ns %6.1f calls %9.1f calls %9.1f calls  (%d, %zu)\n",
              std::string(regime.name).c_str(), median(times), median(ratios), median(curve_ratios),
              median(separation_ratios), contacts, explained);
}

}  // namespace

int main(int count, char** names) {
  std::puts("regime             a verdict              points by curve   separation by curve");
  for (const Regime& regime : polygon_regimes()) {
    const bool wanted =
        count < 2 || std::find(names + 1, names + count, regime.name) != names + count;
    if (wanted) measure(regime);
  }
}
