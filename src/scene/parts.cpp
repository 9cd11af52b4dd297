#include "scene/parts.hpp"

#include <algorithm>
#include <array>

#include "scene/scene.hpp"

// What not every body of a scene has: rules, and several parts.

namespace manifuzz::scene {

/// `act(place)` of each part of a body.
template <class Act>
void Scene::for_each_part(BodyHandle body, const Act& act) const {
  const auto assembly = assemblies_.find(body.index);
  if (assembly == assemblies_.end()) return act(body.index);
  for (const Assembly::Part& part : assembly->second.parts) act(part.handle.index);
}

std::optional<Defect> Scene::remove(BodyHandle handle) {
  if (!is_known(handle)) return Defect::unknown_body;
  std::size_t parts = 0;
  std::size_t contacts = 0;
  for_each_part(handle, [&](std::uint32_t place) {
    ++parts;
    contacts += contacts_of(place);
  });
  make_room(removed_, removed_.size() + parts);
  make_room(ended_, ended_.size() + contacts);
  make_room(renumbered_, renumbered_.size() + contacts);
  for_each_part(handle, [&](std::uint32_t place) { leave_place(place); });
  assemblies_.erase(handle.index);
  return std::nullopt;
}

/// Scenes whose bodies have none hold no array of them.
void Scene::set_traits(std::uint32_t body, const Traits& traits) {
  const bool is_plain = traits.rules == Rules{} && traits.name == PartName{handle(body)};
  if (traits_.empty() && is_plain) return;
  make_room(traits_, placements_.size());
  for (auto place = static_cast<std::uint32_t>(traits_.size()); place < placements_.size();
       ++place) {
    // A body that was removed, and whose end is yet to be told, had the generation before.
    const std::uint32_t generation = generations_[place] - (generations_[place] % 2 == 0 ? 1 : 0);
    traits_.push_back({{}, {{place, generation}}});
  }
  traits_[body] = traits;
}

std::optional<Defect> Scene::set_filter(BodyHandle body, const Filter& filter) {
  if (!is_known(body)) return Defect::unknown_body;
  if (rules(body).filter == filter) return std::nullopt;
  try {
    for_each_part(body, [&](std::uint32_t place) {
      Traits traits = traits_.empty() ? Traits{{}, {handle(place)}} : traits_[place];
      traits.rules.filter = filter;
      set_traits(place, traits);
    });
    for_each_part(body, [&](std::uint32_t place) { refilter(place); });
  } catch (...) {
    forget_pairs();
    throw;
  }
  return std::nullopt;
}

/// Candidates are the pairs that may touch: those that no longer may are dropped, others are added.
void Scene::refilter(std::uint32_t body) {
  if (!is(body, kFiled)) return;  // its partners are yet to be found
  for (const std::uint32_t other : cells_.near(boxes_[body])) {
    if (other == body) continue;
    const auto [a, b] = std::minmax(body, other);
    Candidate* const candidate = candidates_.find(a, b);
    const bool is_allowed = may_touch(a, b);
    if (candidate != nullptr && !is_allowed) drop(a, *candidate);
    if (candidate != nullptr || !is_allowed) continue;
    candidates_.add(a, Candidate(b));
    ++counts_.pairs_added;
  }
  start_path(body);
}

std::variant<BodyHandle, Defect> Scene::add(std::span<const BodyPart> parts,
                                            const Pose<float>& pose, const Rules& rules) {
  if (parts.empty()) return Defect::no_parts;
  if (const auto defect = find_defect(pose)) return *defect;
  for (const BodyPart& part : parts) {
    if (part.shape >= shapes_.size()) return Defect::unknown_shape;
    if (const auto defect = find_defect(part.pose)) return *defect;
    if (const auto defect = find_defect(composed(pose, part.pose))) return *defect;
  }
  // All that needs memory comes first: its own node among the others, too.
  Assembly assembly{pose, {}};
  assembly.parts.reserve(parts.size());
  decltype(assemblies_) of_one;
  of_one.try_emplace(0);
  assemblies_.reserve(assemblies_.size() + 1);
  make_room_for(parts.size(), true);
  for (const BodyPart& part : parts) {
    const std::uint32_t place = take_place(part.shape, composed(pose, part.pose));
    assembly.parts.push_back({handle(place), part.pose});
    const BodyHandle body = assembly.parts.front().handle;
    const auto number = static_cast<std::uint32_t>(assembly.parts.size() - 1);
    set_traits(place, {rules, {body, number}});
  }
  const BodyHandle body = assembly.parts.front().handle;
  auto node = of_one.extract(0);
  node.key() = body.index;
  node.mapped() = std::move(assembly);
  assemblies_.insert(std::move(node));
  return body;
}

const Pose<float>& Scene::pose(BodyHandle body) const {
  const auto assembly = assemblies_.find(body.index);
  return assembly == assemblies_.end() ? placements_[body.index].pose : assembly->second.pose;
}

BodyHandle Scene::handle(const PartName& name) const {
  const auto assembly = assemblies_.find(name.body.index);
  return assembly == assemblies_.end() ? name.body : assembly->second.parts[name.part].handle;
}

/// Finds the first move of all that is refused, whatever task finds it, and whether they may be
/// made in tasks.
CheckedMoves Scene::check(std::span<const Move> moves) const {
  std::array<CheckedMoves, kTasks> checked;
  const std::size_t tasks = division_.tasks_for(moves.size());
  division_.divide(moves.size(), tasks, [&](const Share& share, std::size_t task) {
    const std::size_t before = std::max<std::size_t>(share.first, 1) - 1;
    checked[task] = {
        find_refused(moves, share),
        tasks > 1 && assemblies_.empty() && do_ascend(moves.subspan(before, share.last - before))};
  });
  CheckedMoves all{{}, true};
  for (const auto& [refused, may_divide] : std::span(checked).first(tasks)) {
    if (!all.refused) all.refused = refused;
    all.may_divide = all.may_divide && may_divide;
  }
  return all;
}

std::optional<RefusedMove> Scene::find_refused(std::span<const Move> moves,
                                               const Share& share) const {
  const auto some = moves.subspan(share.first, share.last - share.first);
  if (assemblies_.empty() && are_sound(some, generations_)) return std::nullopt;
  for (std::size_t i = share.first; i < share.last; ++i) {
    const auto& [body, pose] = moves[i];
    if (!is_known(body)) return RefusedMove{i, Defect::unknown_body};
    if (const auto defect = find_defect(pose)) return RefusedMove{i, *defect};
    if (assemblies_.empty()) continue;
    const auto assembly = assemblies_.find(body.index);
    if (assembly == assemblies_.end()) continue;
    for (const Assembly::Part& part : assembly->second.parts) {
      const auto defect = find_defect(composed(pose, part.pose));
      if (defect) return RefusedMove{i, *defect};
    }
  }
  return std::nullopt;
}

/// The moves, those of bodies of parts as one of each part.
std::span<const Move> Scene::moves_of_parts(std::span<const Move> moves) {
  if (assemblies_.empty()) return moves;
  part_moves_.clear();
  for (const Move& move : moves) {
    const auto found = assemblies_.find(move.body.index);
    if (found == assemblies_.end()) {
      part_moves_.push_back(move);
      continue;
    }
    for (const Assembly::Part& part : found->second.parts) {
      part_moves_.push_back({part.handle, composed(move.pose, part.pose)});
    }
  }
  for (const Move& move : moves) {
    const auto found = assemblies_.find(move.body.index);
    if (found != assemblies_.end()) found->second.pose = move.pose;
  }
  return part_moves_;
}

}  // namespace manifuzz::scene
