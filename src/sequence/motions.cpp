#include "sequence/motions.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/text.hpp"
#include "sequence/stage.hpp"

namespace manifuzz {
namespace {

constexpr Motion kMotions[] = {
#define MANIFUZZ_ENTRY(name, description) {#name, description, motion::name},
    MANIFUZZ_MOTIONS(MANIFUZZ_ENTRY)
#undef MANIFUZZ_ENTRY
};

/// Two triangles, of solids of any kind, are one of 144 that are drawn.
constexpr int kAttempts = 4096;

}  // namespace

std::span<const Motion> motions() {
  return kMotions;
}

const Motion* find_motion(std::string_view name) {
  return find_by_name(kMotions, name);
}

Sequence draw_sequence(std::uint64_t seed, const Motion& motion, std::uint64_t index,
                       const TakesSequence& takes) {
  Random random(seed, motion.name, index);
  const Sequence first = motion.draw(random);
  Sequence drawn = first;
  for (int i = 1; takes && !takes(drawn); ++i) {
    if (i == kAttempts) return first;
    drawn = motion.draw(random);
  }
  return drawn;
}

bool has_taken(const Motion& motion, const TakesSequence& takes) {
  return !takes || takes(draw_sequence(1, motion, 0, takes));
}

}  // namespace manifuzz

namespace manifuzz::motion {
namespace {

/// How two bodies stand before they move.
enum class Standing { on_sides, anyhow };

/// A gap as a share of the size: mostly a slight overlap.
double slight_gap(Random& random) {
  const double kind = random.unit();
  if (kind < 0.6) return -random.magnitude(-20, -6);
  if (kind < 0.75) return -0.1 * random.unit();
  if (kind < 0.85) return 0;
  return 0.02 * random.unit();
}

Meeting meet(Random& random, const Solid& a, const Solid& b, Standing standing, double share) {
  constexpr int attempts = 1000;
  const double gap = share * std::min(size_of(a), size_of(b));
  for (int i = 0; i < attempts; ++i) {
    Solid below = a;
    Solid above = b;
    for (Solid* const solid : {&below, &above}) {
      const bool is_side = standing == Standing::on_sides || random.chance(0.5);
      solid->outline = is_side ? side_up(random, solid->outline) : place_up(random, solid->outline);
    }
    if (const auto meeting = meeting_of(random, below, above, gap)) return *meeting;
  }
  throw std::logic_error("two solids never meet");
}

Meeting meet(Random& random, Standing standing) {
  const Solid a = any_solid(random);
  const Solid b = any_solid(random);
  return meet(random, a, b, standing, slight_gap(random));
}

int frame_count(Random& random) {
  return random.integer(kMinFrames, kMaxFrames);
}

/// A step of up to so much along each axis.
Vector2<double> tremble(Random& random, double most) {
  const double x = random.uniform(-most, most);
  const double y = random.uniform(-most, most);
  return {x, y};
}

/// From 0 to 1, back past 0 to -1, and to 0 again, evenly.
double wave(double phase) {
  const double within = phase - std::floor(phase);
  if (within < 0.25) return 4 * within;
  return within < 0.75 ? 2 - 4 * within : 4 * within - 4;
}

Sequence rest(Random& random, const Meeting& meeting) {
  Stage stage(random, meeting);
  const double most = random.magnitude(-24, -14);
  const double dropped = random.chance(0.3) ? random.uniform(0, 0.05) : 0;
  const bool is_a_moved = random.chance(0.25);
  const int frames = frame_count(random);
  double height = dropped * meeting.size;
  for (int i = 0; i < frames; ++i) {
    Move a;
    Move b;
    if (random.chance(0.8)) {
      b.turn = turn_by(random.uniform(-most, most));
      b.by = tremble(random, most * meeting.size);
    }
    if (is_a_moved) a.by = tremble(random, most * meeting.size);
    b.by.y() += height;
    height /= 2;
    stage.show(a, b);
  }
  return stage.finished(random);
}

Sequence rock(Random& random, const Meeting& meeting) {
  Stage stage(random, meeting);
  const double most = random.chance(0.7) ? random.uniform(0.005, 0.1) : random.magnitude(-20, -7);
  const double period = random.uniform(4, 24);
  const int frames = frame_count(random);
  for (int i = 0; i < frames; ++i) {
    const double tilt = most * wave(i / period);
    // Counter-clockwise it stands on its left end.
    const double end = tilt > 0 ? meeting.left : meeting.right;
    stage.show({}, {.turn = turn_by(tilt), .about = {end, meeting.height}});
  }
  return stage.finished(random);
}

Sequence slip(Random& random, const Meeting& meeting) {
  Stage stage(random, meeting);
  const double speed = random.chance(0.5) ? random.uniform(1e-3, 0.03) : random.magnitude(-12, -2);
  const double pressed = random.chance(0.3) ? random.magnitude(-16, -8) : 0;
  const double tilt = random.chance(0.3) ? random.either_sign(random.magnitude(-16, -5)) : 0;
  const double way = random.either_sign(meeting.size * speed);
  const bool comes_back = random.chance(0.3);
  const int frames = frame_count(random);
  for (int i = 0; i < frames; ++i) {
    const int steps = comes_back ? std::min(i, frames - i) : i;
    const double y = -pressed * meeting.size * random.unit();
    stage.show({}, {.turn = turn_by(tilt), .by = {way * steps, y}});
  }
  return stage.finished(random);
}

/// Corners on a circle: a regular polygon of 3 to 8.
Solid regular_solid(Random& random) {
  const double scale = random.magnitude(-2, 0);
  const double radius = random.chance(0.3) ? scale * random.uniform(0.05, 0.5) : 0;
  const int count = random_count(random);
  return {stretched(regular_outline(count), scale, scale), radius,
          radius > 0 ? Rounding::round : Rounding::mitre};
}

int lowest_of(const Outline& outline) {
  const auto* const first = outline.vertices.begin();
  const auto* const lowest = std::min_element(
      first, first + outline.count, [](const auto& v, const auto& w) { return v.y() < w.y(); });
  return static_cast<int>(lowest - first);
}

}  // namespace

Sequence resting(Random& random) {
  return rest(random, meet(random, Standing::anyhow));
}

Sequence rocking(Random& random) {
  return rock(random, meet(random, Standing::on_sides));
}

Sequence sliding(Random& random) {
  return slip(random, meet(random, Standing::anyhow));
}

Sequence rolling(Random& random) {
  const Solid wheel =
      random.chance(0.5) ? draw_solid(random, Family::circle) : regular_solid(random);
  const double length = size_of(wheel) * random.uniform(1, 6);
  Solid floor{box(length, size_of(wheel) * random.uniform(0.2, 1)), 0, Rounding::mitre};
  if (random.chance(0.3)) floor = {segment(2 * length), random.uniform(0, 0.1), Rounding::round};
  const double share = -random.magnitude(-20, -6);
  Solid above = wheel;
  if (wheel.outline.count > 1) above.outline = face_up(wheel.outline, 0, 0.5);
  Solid below = floor;
  below.outline = face_up(floor.outline, 0, 0.5);
  const auto meeting = meeting_of(random, below, above, share * size_of(wheel));
  if (!meeting) return resting(random);
  Stage stage(random, *meeting);
  const Vector2<double> step = turn_by(random.either_sign(random.magnitude(-9, -3)));
  // What is fixed on the wheel turns about its middle; what touches stays where it is.
  const Outline core = upside_down(above.outline);
  const Vector2<double> hub = middle(core);
  Vector2<double> turn{1, 0};
  Outline now = moved(core, -hub);
  double x = 0;
  const int frames = frame_count(random);
  for (int i = 0; i < frames; ++i) {
    const int lowest = lowest_of(now);
    const double drop = -now.vertices[lowest].y() - hub.y();
    const Vector2<double> about{hub.x(), hub.y() + meeting->height};
    stage.show({}, {.turn = turn, .about = about, .by = {x, drop}});
    turn = unit(rotate(step, turn));
    const Outline next = turned(moved(core, -hub), turn);
    const int pivot = lowest_of(next);
    x += now.vertices[pivot].x() - next.vertices[pivot].x() - above.radius * step.y();
    now = next;
  }
  return stage.finished(random);
}

Sequence turning_platform(Random& random) {
  const Meeting meeting = meet(random, Standing::anyhow);
  Stage stage(random, meeting);
  const bool is_exact = random.chance(0.15);
  const Vector2<double> turn = is_exact ? quarter_turn(random)
                               : random.chance(0.1)
                                   ? Vector2<double>(1, 0)
                                   : turn_by(random.either_sign(random.magnitude(-8, -2)));
  const Vector2<double> by =
      random.chance(0.4) ? tremble(random, 0.2 * meeting.size) : Vector2<double>(0, 0);
  const double most = random.chance(0.6) ? 0 : random.magnitude(-20, -9);
  const int frames = frame_count(random);
  for (int i = 0; i < frames; ++i) {
    Move b;
    b.turn = turn_by(random.uniform(-most, most));
    b.by = tremble(random, most * meeting.size);
    stage.show({}, b);
    stage.carry(turn, by);
  }
  return stage.finished(random);
}

Sequence apart_and_back(Random& random) {
  const Meeting meeting = meet(random, Standing::anyhow);
  Stage stage(random, meeting);
  const double most = meeting.size * random.uniform(0.005, 0.08);
  const double aside = random.chance(0.4) ? random.uniform(-1, 1) : 0;
  const double tilt = random.chance(0.4) ? random.uniform(-0.02, 0.02) : 0;
  const double period = random.uniform(4, 24);
  const int frames = frame_count(random);
  for (int i = 0; i < frames; ++i) {
    const double height = std::abs(wave(i / period));
    stage.show(
        {}, {.turn = turn_by(tilt * height), .by = Vector2<double>(aside * height, height) * most});
  }
  return stage.finished(random);
}

Sequence teleport(Random& random) {
  const Meeting meeting = meet(random, Standing::anyhow);
  Stage stage(random, meeting);
  const double most = random.chance(0.5) ? 0 : random.magnitude(-20, -3);
  const int frames = frame_count(random);
  Move b;
  bool is_away = false;
  for (int i = 0; i < frames; ++i) {
    if (i > 0 && random.chance(0.25)) {
      is_away = !is_away;
      const double far = meeting.size * random.uniform(3, 50);
      b = is_away ? Move{.turn = random_direction(random), .by = far * random_direction(random)}
                  : Move{.turn = turn_by(random.uniform(-most, most)),
                         .by = tremble(random, most * meeting.size)};
    }
    stage.show({}, b);
  }
  return stage.finished(random);
}

Sequence tiny_bodies(Random& random) {
  const double scale = random.magnitude(-14, -7);
  const double scale_a = random.chance(0.5) ? scale : 1;
  const Solid a = scaled(any_solid(random), scale_a);
  const Solid b = scaled(any_solid(random), scale);
  const int kind = random.integer(0, 2);
  if (kind == 0) return rest(random, meet(random, a, b, Standing::anyhow, slight_gap(random)));
  const Meeting meeting = meet(random, a, b, Standing::on_sides, slight_gap(random));
  return kind == 1 ? rock(random, meeting) : slip(random, meeting);
}

}  // namespace manifuzz::motion
