#include "scene/scene.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"

namespace manifuzz::scene {

Scene::Scene(const Settings& settings) : settings_(settings), shapes_(settings.tie_bias) {
  assert(!find_defect(settings));
}

std::variant<std::uint32_t, Defect> Scene::add_shape(const ConvexPolygon<float>& polygon) {
  return shapes_.add(polygon);
}

std::variant<BodyHandle, Defect> Scene::add(std::uint32_t shape, const Pose<float>& pose,
                                            const Rules& rules) {
  if (shape >= shapes_.size()) return Defect::unknown_shape;
  if (const auto defect = find_defect(pose)) return *defect;
  make_room_for(1, !(rules == Rules{}));
  const std::uint32_t body = take_place(shape, pose);
  set_traits(body, {rules, {handle(body)}});
  return handle(body);
}

/// So that so many can be added, and need no memory then.
void Scene::make_room_for(std::size_t bodies, bool with_traits) {
  const std::size_t places =
      placements_.size() + (bodies > free_.size() ? bodies - free_.size() : 0);
  const auto make = [places](auto&... by_body) { (make_room(by_body, places), ...); };
  make(placements_, generations_, states_, paths_, leave_at_, boxes_, tight_, left_at_);
  if (with_traits || !traits_.empty()) make_room(traits_, places);
  make_room(free_, 1);
  make_room(movers_, movers_.size() + bodies);
}

/// A place, for which there is room, of a body that has this shape and no traits yet.
std::uint32_t Scene::take_place(std::uint32_t shape, const Pose<float>& pose) {
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(placements_.size()));
    placements_.emplace_back();
    generations_.push_back(0);
    states_.push_back(0);
    paths_.push_back(kNoPath);
    leave_at_.push_back(0);
    boxes_.push_back(kNowhere);
    tight_.push_back(kNowhere);
    left_at_.push_back(0);
  }
  const std::uint32_t body = free_.back();
  free_.pop_back();
  placements_[body] = {shape, pose};
  ++generations_[body];
  ++body_count_;
  start_path(body);
  return body;
}

/// In how many contacts a body takes part.
std::size_t Scene::contacts_of(std::uint32_t body) {
  if (!is(body, kFiled)) return 0;
  const auto touches = [](const Candidate& candidate) { return candidate.touches(); };
  auto count = static_cast<std::size_t>(std::ranges::count_if(candidates_.row(body), touches));
  for (const std::uint32_t other : cells_.near(boxes_[body])) {
    const Candidate* const candidate = other < body ? candidates_.find(other, body) : nullptr;
    count += static_cast<std::size_t>(candidate != nullptr && candidate->touches());
  }
  return count;
}

/// There is room for what is told of it.
void Scene::leave_place(std::uint32_t body) {
  if (is(body, kFiled)) {
    drop_all(body);
    cells_.remove(body, boxes_[body]);
  }
  boxes_[body] = kNowhere;
  states_[body] &= kMoved;  // it stays among the movers, if it is one
  ++generations_[body];
  --body_count_;
  removed_.push_back(body);
}

std::optional<Defect> Scene::set_shape(BodyHandle body, std::uint32_t shape, std::uint32_t part) {
  if (!is_known(body)) return Defect::unknown_body;
  if (shape >= shapes_.size()) return Defect::unknown_shape;
  std::uint32_t place = body.index;
  if (part > 0) {
    const auto assembly = assemblies_.find(body.index);
    if (assembly == assemblies_.end() || part >= assembly->second.parts.size()) {
      return Defect::unknown_part;
    }
    place = assembly->second.parts[part].handle.index;
  }
  make_room(movers_, movers_.size() + 1);
  placements_[place].shape = shape;
  start_path(place);
  return std::nullopt;
}

/// Nothing that was known of its box and its pairs holds any more.
void Scene::start_path(std::uint32_t body) {
  paths_[body] = kNoPath;
  states_[body] &= static_cast<std::uint8_t>(~kBoxed);
  if (is(body, kMoved)) return;
  states_[body] |= kMoved | kUnsure;
  make_room(movers_, movers_.size() + 1);
  movers_.push_back(body);
}

/// Bodies to be looked at that are in the scene no more are not looked at.
void Scene::forget_removed() {
  const auto is_gone = [&](std::uint32_t body) { return generations_[body] % 2 == 0; };
  std::erase_if(movers_, [&](std::uint32_t body) {
    if (is_gone(body)) states_[body] = 0;
    return is_gone(body);
  });
}

/// Puts bodies where they are now, in tasks or one after another, and counts those that moved.
void Scene::place(std::span<const Move> moves, bool may_divide) {
  forget_removed();
  started_ = movers_.size();
  if (!may_divide) {
    place(moves, movers_, unsure_);
    return count_movers(movers_.size());
  }
  mover_works_.resize(kTasks);
  division_.divide(moves.size(), kTasks, [&](const Share& share, std::size_t task) {
    auto& [moved, unsure] = mover_works_[task];
    place(moves.subspan(share.first, share.last - share.first), moved, unsure);
  });
  std::size_t count = movers_.size();
  for (const MoverWork& work : mover_works_) count += work.moved.size();
  count_movers(count);
  for (auto& [moved, unsure] : mover_works_) {
    if (few_moved_) append(movers_, moved);  // where many moved, nobody asks who did
    append(unsure_, unsure);
    clear_for(moved, body_count_);
    clear_for(unsure, body_count_);
  }
}

/// Adds the bodies that moved to one list, and to the other those that may have left their boxes.
void Scene::place(std::span<const Move> moves, std::vector<std::uint32_t>& moved,
                  std::vector<Mover>& unsure) {
  constexpr std::size_t kSome = 256;
  std::array<std::uint32_t, kSome> some_moved;
  std::array<Mover, kSome> some_unsure;
  for (std::size_t first = 0; first < moves.size(); first += kSome) {
    const auto [moved_count, unsure_count] =
        place_moves(moves.subspan(first, std::min(kSome, moves.size() - first)),
                    {&shapes_.facts(0), placements_.data(), states_.data(), paths_.data(),
                     leave_at_.data(), some_moved.data(), some_unsure.data()});
    append(moved, std::span(some_moved).first(moved_count));
    append(unsure, std::span(some_unsure).first(unsure_count));
  }
}

void Scene::drop_all(std::uint32_t body) {
  const std::span<Candidate> row = candidates_.row(body);
  for (std::size_t i = row.size(); i-- > 0;) drop(body, row[i]);
  for (const std::uint32_t other : cells_.near(boxes_[body])) {
    if (other > body) continue;
    if (Candidate* const candidate = candidates_.find(other, body)) drop(other, *candidate);
  }
}

void Scene::drop(std::uint32_t a, Candidate& candidate) {
  if (candidate.touches()) end_contact(candidate);
  candidates_.drop(a, candidate);
  ++counts_.pairs_dropped;
}

void Scene::end_contact(Candidate& candidate) {
  const std::uint32_t contact = candidate.contact();
  candidate.know(0);
  ended_.push_back({contacts_[contact].a, contacts_[contact].b});
  erase_contact(contact);
}

/// The last contact of all takes its place, and that one's pair is looked for.
void Scene::erase_contact(std::uint32_t contact) {
  const Contact& last = contacts_.back();
  if (contact + 1 < contacts_.size()) {
    make_room(renumbered_, renumbered_.size() + 1);
    renumbered_.push_back({static_cast<std::uint32_t>(contacts_.size() - 1), contact});
    candidates_.find(last.a.index, last.b.index)->touch(contact);
    contacts_[contact] = last;
    if (!kept_.empty()) kept_[contact] = kept_.back();
  }
  contacts_.pop_back();
  if (!kept_.empty()) kept_.pop_back();
}

Memory Scene::memory() const {
  std::size_t of_assemblies = 0;
  for (const auto& [place, assembly] : assemblies_) {
    of_assemblies += sizeof(place) + sizeof(assembly) + bytes_of(assembly.parts);
  }
  std::size_t of_leavers = 0;
  for (const MoverWork& work : mover_works_) of_leavers += work.bytes();
  for (const std::vector<Leaver>& left : left_works_) of_leavers += bytes_of(left);
  std::size_t of_works = division_.bytes();
  for (const PairWork& work : pair_works_) of_works += work.bytes();
  for (const PartnerWork& work : partner_works_) of_works += work.bytes();
  return {bytes_of(free_) + bytes_of(removed_) + bytes_of(placements_) + bytes_of(generations_) +
              bytes_of(states_) + bytes_of(paths_) + bytes_of(leave_at_) + bytes_of(boxes_) +
              bytes_of(left_at_) + bytes_of(traits_) + of_assemblies + of_leavers + cells_.bytes() +
              candidates_.bytes_by_body() + bytes_of(movers_) + bytes_of(unsure_) +
              bytes_of(part_moves_) + bytes_of(left_) + bytes_of(bodies_) + bytes_of(marks_) +
              bytes_of(tight_),
          candidates_.bytes_by_pair() + bytes_of(contacts_) + bytes_of(kept_) + of_works +
              bytes_of(vacant_) + bytes_of(began_) + bytes_of(ended_) + bytes_of(renumbered_)};
}

}  // namespace manifuzz::scene
