// An engine's loop: what src/kernel/README.md shows of it, and what it prints.

#include <iostream>
#include <manifuzz/kernel/batch.hpp>
#include <manifuzz/kernel/pair.hpp>
#include <vector>

using namespace manifuzz;

namespace {

int complain(std::string_view why) {
  std::cerr << why << '\n';
  return 2;
}

}  // namespace

int main() {
  const std::vector<Vector2<float>> corners{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  if (const auto defect = find_defect(corners)) return complain(describe(*defect));
  const auto box = make_polygon<float>(corners);
  const auto rows = kernel::rows_of(box);  // as one pair at a time takes it
  kernel::Shapes<float> shapes;            // as many at once take it, by index
  const auto shape = shapes.add(box);
  std::vector<kernel::Placement<float>> bodies{
      {shape, {{0, 0}, {1, 0}}}, {shape, {{0.5F, 3}, {1, 0}}}, {shape, {{1, 6}, {0.6F, 0.8F}}}};
  const std::vector<kernel::BodyPair> pairs{{0, 1}, {1, 2}};  // from your broad phase
  std::vector<Manifold<float>> manifolds(pairs.size());
  kernel::FaceHint hint;  // one a pair, kept: the face that separated it last time
  int steps_apart = 0;
  for (int step = 0; step < 100; ++step) {
    for (const int body : {1, 2}) bodies[body].pose.position.y() -= 0.0625F;
    const auto b_in_a = relative_pose(bodies[0].pose, bodies[1].pose);
    if (!kernel::touches(rows, rows, b_in_a, &hint)) ++steps_apart;
    kernel::collide_pairs_again(shapes, bodies, pairs, 0, manifolds);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Manifold<float>& m = manifolds[i];  // in A's frame
      float depth = 0;
      for (int k = 0; k < m.count; ++k) depth = std::max(depth, m.points[k].depth);
      const auto& [a, b] = pairs[i];
      if (m.count > 0) bodies[b].pose.position += depth * rotate(bodies[a].pose.rotation, m.normal);
    }
  }

  const auto contact = transform(bodies[1].pose, manifolds[1].points[0].position);
  std::cout << "heights " << bodies[1].pose.position.y() << " and " << bodies[2].pose.position.y()
            << ", contact at " << contact.x() << ' ' << contact.y() << ", apart for " << steps_apart
            << " steps\n";
}
