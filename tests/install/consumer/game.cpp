// A game's scene: what src/scene/README.md shows of it, and where it is played.

#include <cstdio>
#include <manifuzz/scene/query.hpp>
#include <vector>

using namespace manifuzz;
using scene::BodyHandle;

enum Category : std::uint32_t { kGround = 1, kPlayer = 2, kBullet = 4, kCoin = 8 };

struct Game {
  scene::Scene scene;
  std::uint32_t tile = shape({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0);
  std::uint32_t body = shape({{0, -0.5F}, {0, 0.5F}}, 0.5F);  // a capsule
  std::uint32_t head = shape({{0, 0}}, 0.4F);                 // a circle
  std::uint32_t dot = shape({{0, 0}}, 0.1F);
  BodyHandle player{};
  BodyHandle bullet{};

  std::uint32_t shape(const std::vector<Vector2<float>>& vertices, float radius) {
    return std::get<std::uint32_t>(scene.add_shape(make_polygon<float>(vertices, radius)));
  }
  BodyHandle add(std::uint32_t shape, float x, float y, const scene::Rules& rules) {
    return std::get<BodyHandle>(scene.add(shape, {{x, y}, {1, 0}}, rules));
  }

  Game() {
    const scene::Rules of_ground{.filter = {.category = kGround}, .is_static = true};
    const scene::Rules of_coins{.filter = {kCoin, kPlayer}, .is_sensor = true};
    const scene::Rules of_bullets{.filter = {kBullet, kGround}};  // not who shoots them
    for (int i = 0; i < 8; ++i) add(tile, 2 * static_cast<float>(i), -1, of_ground);
    for (const float x : {4.0F, 6.0F}) add(dot, x, 1, of_coins);
    const scene::BodyPart parts[] = {{body, {{0, 0}, {1, 0}}}, {head, {{0, 1.2F}, {1, 0}}}};
    player =
        std::get<BodyHandle>(scene.add(parts, {{1, 1}, {1, 0}}, {.filter = {.category = kPlayer}}));
    bullet = add(dot, 1, 1, of_bullets);
  }

  void step(float x, float height_of_bullet) {
    const scene::Move moves[] = {{player, {{x, 0.9F}, {1, 0}}},
                                 {bullet, {{x + 2, height_of_bullet}, {1, 0}}}};
    const auto stepped = scene.step(moves);
    const auto& result = std::get<scene::StepResult>(stepped);
    for (const std::uint32_t began : result.began) {
      const scene::Contact& contact = result.contacts[began];
      const float at = scene.pose(scene.part(contact.a).body).position.x();  // a tile or a coin
      const bool is_player = scene.part(contact.b).body == player;
      if (contact.manifold.count == 0) {
        std::printf("a coin at x = %g\n", at);
      } else {
        std::printf("the %s on the tile at x = %g\n", is_player ? "player" : "bullet", at);
      }
    }
  }
};

int main() {
  Game game;
  game.step(1, 2);
  game.step(3.5F, 0.05F);
  game.step(5.5F, 1);
  const Ray sight{{-5, 0.5F}, {20, 0}};
  const auto seen = scene::cast_ray(game.scene, sight, {.category = kBullet, .mask = kPlayer});
  std::printf("seen at x = %g\n", -5 + 20 * seen->hit.share);
}
