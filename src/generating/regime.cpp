#include "generating/regime.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

constexpr Regime kRegimes[] = {
#define MANIFUZZ_ENTRY(name, description) {#name, description, draw::name},
    MANIFUZZ_REGIMES(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
#define MANIFUZZ_ENTRY(name, description) {#name, description, draw::name, true},
        MANIFUZZ_ROUND_REGIMES(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
};

/// Two overlapping right triangles: what is left when every attempt failed.
PairCase plain_pair() {
  const Vector2<float> vertices[] = {{0, 0}, {1, 0}, {0, 1}};
  Body body;
  body.polygon = make_polygon<float>(vertices);
  PairCase pair{body, body};
  pair.b.pose.position = {0.5f, 0.25f};
  return pair;
}

/// One attempt: whether it gave a case. With large radii bodies are put so far away that float
/// ends; what polygons there are have no defects.
bool attempt(Random& random, const Regime& regime, const GenerationContext& context,
             PairCase& pair) {
  return regime.attempt(random, context, pair) && pair.a.pose.position.allFinite() &&
         pair.b.pose.position.allFinite();
}

constexpr int kAttempts = 64;

/// The last case of all attempts, none of which gives one that is taken.
PairCase untaken(Random random, const Regime& regime, const GenerationContext& context) {
  PairCase last = plain_pair();
  for (int i = 0; i < kAttempts; ++i) {
    PairCase made;
    if (attempt(random, regime, context, made)) last = made;
  }
  return last;
}

}  // namespace

std::span<const Regime> regimes() {
  return kRegimes;
}

std::span<const Regime> polygon_regimes() {
  const auto* const first_round = std::ranges::find(kRegimes, true, &Regime::is_round);
  return {std::begin(kRegimes), first_round};
}

std::span<const Regime> round_regimes() {
  return regimes().subspan(polygon_regimes().size());
}

const Regime* find_regime(std::string_view name) {
  return find_by_name(kRegimes, name);
}

bool is_taken(const GenerationContext& context, const PairCase& pair) {
  const auto& takes = is_round(pair) ? context.takes : context.takes_mitred;
  return !takes || takes(pair);
}

void put_radius(const GenerationContext& context, PairCase& pair) {
  const auto given = context.radius || is_round(pair) ? context.radius : context.mitred_radius;
  if (!given) return;
  for (Body* const body : {&pair.a, &pair.b}) {
    if (body->polygon.count >= kMinVertices) body->polygon.radius = *given;
  }
}

PairCase generate(std::uint64_t seed, const Regime& regime, std::uint64_t index,
                  const GenerationContext& context) {
  const Random start(seed, regime.stream, index);
  Random random = start;
  PairCase pair;
  bool is_drawn = false;
  for (int i = 0; i < kAttempts && !is_drawn; ++i) {
    is_drawn = attempt(random, regime, context, pair) && is_taken(context, pair);
  }
  if (!is_drawn) pair = untaken(start, regime, context);
  put_radius(context, pair);
  return pair;
}

}  // namespace manifuzz

namespace manifuzz::draw {

// Regimes that move the cases of others.

namespace {

/// What `ulp` draws from. A list of its own, so that a new regime changes no case of `ulp`.
constexpr std::string_view kMovable[] = {
    "generic",       "boxes",           "regular",       "grid",        "sliver",
    "near_parallel", "tied_faces",      "micro_edge",    "corner_face", "touching",
    "deep",          "near_collinear",  "corner_corner", "tie_bias",    "scaled",
    "off_unit",      "far_from_origin",
};

/// One coordinate of a vertex, mostly, or of the pose.
float& random_number(Random& random, PairCase& pair) {
  Body& body = random.chance(0.5) ? pair.a : pair.b;
  const int axis = random.integer(0, 1);
  const double kind = random.unit();
  if (kind < 0.15) return body.pose.rotation[axis];
  if (kind < 0.3) return body.pose.position[axis];
  return body.polygon.vertices[random.integer(0, body.polygon.count - 1)][axis];
}

int few_ulps(Random& random) {
  const int steps = random.integer(1, random.chance(0.7) ? 2 : 8);
  return random.chance(0.5) ? steps : -steps;
}

void step_some(Random& random, PairCase& pair) {
  const int numbers = random.integer(1, 4);
  for (int i = 0; i < numbers; ++i) {
    float& number = random_number(random, pair);
    number = stepped(number, few_ulps(random));
  }
}

void change_some(Random& random, PairCase& pair) {
  float& number = random_number(random, pair);
  const double share = random.magnitude(-24, -7);
  number = static_cast<float>(number * (random.chance(0.5) ? 1 + share : 1 - share));
}

void change_radii(Random& random, PairCase& pair) {
  const float radius =
      random.chance(0.3) ? 0 : static_cast<float>(size(pair) * random.magnitude(-12, -5));
  pair.a.polygon.radius = pair.b.polygon.radius = radius;
}

void mutate(Random& random, PairCase& pair) {
  switch (random.integer(0, 6)) {
    case 0:
    case 1:
      return step_some(random, pair);
    case 2:
      return change_some(random, pair);
    case 3:
      return std::swap(pair.a, pair.b);
    case 4:
      return turn_by_quarter(pair);
    case 5:
      return scale_lengths(pair, std::ldexp(1.0f, random.integer(-8, 8)));
    default:
      return change_radii(random, pair);
  }
}

}  // namespace

bool ulp(Random& random, const GenerationContext& context, PairCase& pair) {
  const int choice = random.integer(0, static_cast<int>(std::size(kMovable)) - 1);
  const PairCase drawn = generate(random.bits(), *find_regime(kMovable[choice]), 0, context);
  PairCase moved = drawn;
  step_some(random, moved);
  pair = revalidated(moved).value_or(drawn);
  return true;
}

bool corpus(Random& random, const GenerationContext& context, PairCase& pair) {
  if (context.corpus.empty()) return generic(random, context, pair);
  const auto last = static_cast<int>(context.corpus.size()) - 1;
  const PairCase& known = context.corpus[random.integer(0, last)];
  PairCase mutated = known;
  const int times = random.integer(1, 3);
  for (int i = 0; i < times; ++i) mutate(random, mutated);
  pair = revalidated(mutated).value_or(known);
  return true;
}

}  // namespace manifuzz::draw
