#include <algorithm>
#include <csignal>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

#include "corpus/corpus.hpp"
#include "exchange/json.hpp"
#include "external/behaviour.hpp"
#include "own_colliders/own_colliders.hpp"
#include "support/used_shapes_of.hpp"

// clip64 as a program that answers lines. Its argument says what else it does.

using namespace manifuzz;

namespace {

/// What it declares beside its name: that it says less than clip64 does.
std::string_view claims_of(std::string_view behaviour) {
  if (behaviour == "touching") return R"(, "claims": "touching")";
  if (behaviour == "separation" || behaviour == "reversed") return R"(, "claims": "separation")";
  if (behaviour == "point" || behaviour == "two-points") return R"(, "claims": "point")";
  if (behaviour == "alters" || behaviour == "no-shapes") return R"(, "alters_shapes": true)";
  if (behaviour == "stops-short") {
    return R"(, "claims": "separation", "tolerance": {"relative": 0.02, "source": "its manual"})";
  }
  return "";
}

/// Without the first vertex of each polygon that has more than three.
PairCase altered(PairCase pair) {
  for (const Side side : {Side::a, Side::b}) {
    ConvexPolygon<float>& polygon = pair[side].polygon;
    if (polygon.count <= kMinVertices) continue;
    polygon = make_polygon<float>(polygon.corners().subspan(1), polygon.radius);
  }
  return pair;
}

/// What clip64 says of the altered polygons, and which they are.
Answer answer_by_altered(const PairCase& pair) {
  static const Collider clip64 = make_clip64();
  const PairCase used = altered(pair);
  PartialManifold result{.manifold = std::get<Manifold<double>>(clip64.collide(used))};
  result.used = test::used_shapes_of(used);
  return result;
}

/// As much of what clip64 says as that behaviour claims.
Answer claimed(Manifold<double> manifold, std::string_view behaviour) {
  if (manifold.count == 2 && manifold.points[1].depth > manifold.points[0].depth) {
    std::swap(manifold.points[0], manifold.points[1]);
  }
  Penetration penetration{.touches = manifold.count > 0, .normal = {}, .depth = 0};
  if (penetration.touches && behaviour != "touching") {
    penetration.normal =
        behaviour == "reversed" ? Vector2<double>(-manifold.normal) : manifold.normal;
    penetration.depth = manifold.points[0].depth;
    if (behaviour == "stops-short") penetration.depth *= 0.99;
  }
  if (behaviour == "point") manifold.count = std::min(manifold.count, 1);
  const bool has_points = behaviour == "point" || behaviour == "two-points";
  return has_points ? Answer(manifold) : Answer(penetration);
}

std::string answer_to(const std::string& line, std::string_view behaviour) {
  static const Collider clip64 = make_clip64();
  const PairCase pair = parse_case(line, FormatKey::required).pair();
  const float x = pair.a.polygon.vertices[0].x();
  const float y = pair.b.pose.position.y();
  const bool is_unlucky = test::is_unlucky(x, y);
  static int asked = 0;
  if (behaviour == "tires" && ++asked == 100) std::raise(SIGSEGV);
  if (behaviour == "late") usleep(300'000);
  if (behaviour == "complains") std::cerr << std::string(200'000, 'x') << '\n';
  if (is_unlucky && behaviour == "breaks-off") {
    std::cout << R"({"points": [)" << std::flush;
    std::raise(SIGSEGV);
  }
  test::misbehave(behaviour == "buffers-and-crashes" ? "crashes" : behaviour, x, y);
  if (is_unlucky && behaviour == "negative") {
    return R"({"points": [{"position": [0, 0], "depth": -0.25}], "normal": [0, 1]})"
           "\n";
  }
  if (is_unlucky && behaviour == "garbage") return "[object Object]\n";
  if (is_unlucky && behaviour == "not-a-number") return "{\"points\": [], \"depth\": NaN}\n";
  if (is_unlucky && behaviour == "nonsense") return "{\"points\": 3}\n";
  std::string answer;
  const Answer whole = clip64.collide(pair);
  const bool is_whole = behaviour == "no-shapes" || claims_of(behaviour).empty();
  append_answer(answer, pair, "behaving",
                behaviour == "alters" || behaviour == "alters-unsaid" ? answer_by_altered(pair)
                : is_whole                                            ? whole
                           : claimed(std::get<Manifold<double>>(whole), behaviour));
  answer += '\n';
  if (is_unlucky && behaviour == "twice") answer += answer;
  if (is_unlucky && behaviour == "never") answer.clear();
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view behaviour = argc > 1 ? argv[1] : "";
  if (behaviour == "dies-at-start") return 3;
  if (behaviour != "undeclared") {
    std::cout << R"({"declaration": {"name": "behaving", "version": "1.0", "scalar": "float64", )"
              << R"("frame": "local")" << claims_of(behaviour) << "}}" << std::endl;
  }
  // Whether more cases are there to be read is known only so.
  std::ios::sync_with_stdio(false);
  std::string held;
  for (std::string line; std::getline(std::cin, line);) {
    const std::string answer = answer_to(line, behaviour);
    if (behaviour == "buffers-and-crashes") {
      held += answer;
      if (std::cin.rdbuf()->in_avail() <= 0) std::cout << std::exchange(held, "") << std::flush;
    } else if (behaviour != "out-of-order") {
      std::cout << answer << std::flush;
    } else if (held.empty()) {
      held = answer;  // a case late, and swapped with the next
    } else {
      std::cout << answer << std::exchange(held, "") << std::flush;
    }
  }
  return 0;
}
