#include "unit/scene/model.hpp"

#include <algorithm>
#include <map>

#include "generating/drafts.hpp"
#include "geometry/pair_case.hpp"
#include "kernel/batch.hpp"

namespace manifuzz::test {
namespace {

using Contacts = std::map<Ordinals, Manifold<float>>;

Ordinals ordered(const Subject& subject, std::size_t i, std::size_t j) {
  const bool in_order = subject.handles[i].index < subject.handles[j].index;
  return in_order ? Ordinals{i, j} : Ordinals{j, i};
}

/// All pairs of bodies by the kernel, nothing skipped.
Contacts afresh(const Subject& subject, const Model& model) {
  static const kernel::Shapes<float> shapes = [] {
    kernel::Shapes<float> all;
    for (const auto& shape : shapes_for_scenes()) all.add(shape);
    return all;
  }();
  std::vector<kernel::Placement<float>> placements;
  for (const Model::Body& body : model.bodies) placements.push_back({body.shape, body.pose});
  std::vector<kernel::BodyPair> pairs;
  const auto alive = model.alive();
  for (std::size_t i = 0; i < alive.size(); ++i) {
    for (std::size_t j = i + 1; j < alive.size(); ++j) {
      const auto [a, b] = ordered(subject, alive[i], alive[j]);
      const bool is_one_body = model.bodies[a].first == model.bodies[b].first;
      if (is_one_body || !may_touch(model.bodies[a].rules, model.bodies[b].rules)) continue;
      pairs.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    }
  }
  std::vector<Manifold<float>> manifolds(pairs.size());
  kernel::collide_pairs(shapes, placements, pairs, kTieBias, manifolds);
  Contacts contacts;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (manifolds[i].count == 0) continue;
    const auto& [a, b] = pairs[i];
    contacts[{a, b}] = manifolds[i];
    const bool is_sensed = model.bodies[a].rules.is_sensor || model.bodies[b].rules.is_sensor;
    if (is_sensed) contacts[{a, b}].count = 0;
  }
  return contacts;
}

/// The bodies that had these handles, the removed ones too.
std::optional<Ordinals> ordinals_of(const Subject& subject, const Handle& a, const Handle& b) {
  const auto find = [&](const Handle& handle) {
    std::size_t i = subject.handles.size();
    while (i > 0 && !(subject.handles[i - 1] == handle)) --i;
    return i;
  };
  const Ordinals found{find(a), find(b)};
  if (found[0] == 0 || found[1] == 0) return std::nullopt;
  return Ordinals{found[0] - 1, found[1] - 1};
}

/// What is wrong with what began, stayed and ended, and with the counters.
std::optional<std::string> changes_complaint(const Subject& subject, const Stepped& stepped,
                                             const std::set<Ordinals>& now) {
  std::set<Ordinals> expected = subject.touching;
  for (const auto& [a, b] : stepped.ended) {
    const auto pair = ordinals_of(subject, a, b);
    if (!pair || expected.erase(*pair) == 0) return "an end that was none";
  }
  for (const std::uint32_t i : stepped.began) {
    if (i >= stepped.contacts.size()) return "a begin that is none";
    const Touching& contact = stepped.contacts[i];
    if (!expected.insert(*ordinals_of(subject, contact.a, contact.b)).second) {
      return "a contact begins again";
    }
  }
  if (expected != now) return "begun and ended do not lead from the contacts before to these";
  if (stepped.stayed + stepped.began.size() != now.size()) return "the contacts that stayed";
  const std::size_t looked_at = stepped.separated + stepped.collided;
  if (stepped.at_rest > stepped.candidates || stepped.candidates < now.size() ||
      stepped.at_rest + looked_at != stepped.candidates) {
    return "the counters do not add up";
  }
  return std::nullopt;
}

/// Whether what is kept by a contact's index stays with it; `pairs` become those of now.
std::optional<std::string> order_complaint(const Subject& subject, const Stepped& stepped,
                                           std::vector<Ordinals>& pairs) {
  for (const auto& [from, to] : stepped.renumbered) {
    if (from >= pairs.size() || to >= from) return "a contact is renumbered that is none";
    pairs[to] = pairs[from];
  }
  pairs.resize(stepped.contacts.size());
  for (const std::uint32_t i : stepped.began) {
    pairs[i] = *ordinals_of(subject, stepped.contacts[i].a, stepped.contacts[i].b);
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Touching& contact = stepped.contacts[i];
    if (pairs[i] != *ordinals_of(subject, contact.a, contact.b)) return "a contact lost its index";
  }
  return std::nullopt;
}

}  // namespace

const std::vector<ConvexPolygon<float>>& shapes_for_scenes() {
  static const std::vector<ConvexPolygon<float>> shapes = [] {
    std::vector<ConvexPolygon<float>> all;
    const auto add = [&](const Outline& outline, float radius) {
      if (const auto polygon = rounded(outline, radius)) all.push_back(*polygon);
    };
    add(box(0.5, 0.5), 0);
    add(box(3, 0.05), 0);
    add(stretched(regular_outline(3), 1, 0.001), 0);
    add(box(0.25, 0.5), 0.01F);
    for (int count = kMinVertices; count <= kMaxVertices; ++count) {
      Random random(1, "scene shapes", static_cast<std::uint64_t>(count));
      const float radius = count % 2 == 0 ? 0.0F : 0.02F;
      add(stretched(random_outline(random, count), 0.5, 0.5), radius);
    }
    add(moved(box(0.2, 0.2), {1, 1}), 0);  // its origin lies outside
    add(box(0.2, 0.3), 0.3F);              // more skin than flesh
    const auto add_round = [&](const std::vector<Vector2<float>>& vertices, float radius) {
      all.push_back(make_polygon<float>(vertices, radius, Rounding::round));
    };
    add_round({{0, 0}}, 0.4F);
    add_round({{0.3F, 0.1F}}, 0.05F);  // its origin lies outside
    add_round({{-0.5F, 0}, {0.5F, 0}}, 0);
    add_round({{-0.2F, 0}, {0.2F, 0}}, 0.2F);
    add_round({{-0.3F, -0.2F}, {0.3F, -0.2F}, {0, 0.4F}}, 0.1F);
    add_round({{0, 0}, {1, 0}, {1, 1e-5F}}, 0.01F);  // too sharp without its radius
    return all;
  }();
  return shapes;
}

Subject::Subject(MakeScene make) : scene(make()) {
  for (const auto& shape : shapes_for_scenes()) scene->add_shape(shape);
}

void Subject::keep(const Handle& handle) {
  is_named_twice = is_named_twice || std::ranges::find(handles, handle) != handles.end();
  handles.push_back(handle);
}

void Subject::add(const Model::Body& body) {
  keep(scene->add(body.shape, body.pose, body.rules));
}

void Subject::add(const std::vector<scene::BodyPart>& parts, const Pose<float>& pose,
                  const scene::Rules& rules) {
  for (const Handle& part : scene->add(parts, pose, rules)) keep(part);
}

void Subject::remove(std::size_t ordinal) {
  std::erase_if(moves, [&](const Moved& moved) { return moved.body == handles[ordinal]; });
  scene->remove(handles[ordinal]);
}

std::optional<std::string> Subject::step(const Model& model) {
  const std::optional<Stepped> stepped = scene->step(moves);
  moves.clear();
  if (!stepped) return "the step is refused";
  if (is_named_twice) return "a body has the handle of one before";
  std::set<Ordinals> now;
  const Contacts right = afresh(*this, model);
  for (const Touching& contact : stepped->contacts) {
    const auto pair = ordinals_of(*this, contact.a, contact.b);
    if (!pair) return "a contact of nobody";
    const auto found = right.find(*pair);
    if (found == right.end()) return "a contact that is none";
    if (!same_bits(found->second, contact.manifold)) return "another manifold";
    if (!now.insert(*pair).second) return "a contact twice";
  }
  if (now.size() != right.size()) return "a contact is missing";
  const auto complaint = changes_complaint(*this, *stepped, now);
  touching = std::move(now);
  return complaint ? complaint : order_complaint(*this, *stepped, pairs);
}

}  // namespace manifuzz::test
