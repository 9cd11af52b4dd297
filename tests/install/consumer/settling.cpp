// A scene: what src/scene/README.md shows of it, and more steps.

#include <cstdio>
#include <manifuzz/scene/scene.hpp>

using namespace manifuzz;

int main() {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto polygon = make_polygon<float>(corners);
  const Pose<float> pose{{0.5F, 2.5F}, {1, 0}};
  const std::vector<scene::Move> moves;

  scene::Scene scene;
  const auto shape = std::get<std::uint32_t>(scene.add_shape(polygon));
  const auto body = std::get<scene::BodyHandle>(scene.add(shape, pose));
  const auto stepped = scene.step(moves);  // poses of the bodies that moved
  const auto& result =
      std::get<scene::StepResult>(stepped);  // contacts; what began, stayed, ended; counters

  std::printf("%zu contacts\n", result.contacts.size());
  const auto floor = std::get<scene::BodyHandle>(scene.add(shape, {}));
  for (float height = 2.5F; height >= 1.5F; height -= 0.25F) {
    const scene::Move down[] = {{body, {{0.5F, height}, {1, 0}}}};
    const auto settled = scene.step(down);
    const auto& now = std::get<scene::StepResult>(settled);
    for (const scene::Contact& contact : now.contacts) {
      std::printf("%g deep, the normal points to the %s, %zu began\n",
                  contact.manifold.points[0].depth, contact.b == floor ? "floor" : "body",
                  now.began.size());
    }
  }
  const scene::Move away[] = {{body, {{1e30F, 0}, {1, 0}}}};
  const auto refused = scene.step(away);
  std::puts(describe(std::get<scene::RefusedMove>(refused).defect).data());
}
