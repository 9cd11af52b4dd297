#include <algorithm>
#include <array>

#include "scene/scene.hpp"

// Bodies that left their boxes: whose boxes overlap theirs now, and what is known of those pairs.

namespace manifuzz::scene {

/// Each task searches for its share of those that left, and looks at the pairs that are new.
void Scene::find_all_partners() {
  if (left_.empty()) return;
  const std::size_t tasks = division_.tasks_for(left_.size());
  if (partner_works_.size() < tasks) partner_works_.resize(tasks);
  division_.divide_with_scratch(
      left_.size(), tasks, [&](const Share& share, std::size_t task, Scratch& scratch) {
        PartnerWork& found = partner_works_[task];
        for (std::size_t i = share.first; i < share.last; i += Cells::kTogether) {
          find_partners(std::span(left_).subspan(i, std::min(Cells::kTogether, share.last - i)),
                        scratch, found);
        }
        look_at_new(found.lower, begun_work(division_.row_tasks() + task, scratch,
                                            found.adding.data(), found.adding.size()));
      });
  for (const Leaver& leaver : left_) {
    std::uint8_t& state = states_[leaver.body];
    state = static_cast<std::uint8_t>((state & ~(kAlone | kFewPartners)) | kFiled);
  }
  for (PartnerWork& work : std::span(partner_works_).first(tasks)) {
    for (const std::uint32_t body : work.alone) states_[body] |= kAlone;
    for (const std::uint32_t body : work.with_few) states_[body] |= kFewPartners;
    clear_for(work.alone, body_count_);
    clear_for(work.with_few, body_count_);
  }
}

/// Where theirs may lie is found out of all first, and asked for.
void Scene::find_partners(std::span<const Leaver> some, Scratch& scratch, PartnerWork& work) const {
  std::array<std::size_t, Cells::kTogether> ends;
  scratch.runs.clear();
  for (std::size_t i = 0; i < some.size(); ++i) {
    cells_.find_runs(boxes_[some[i].body], scratch.runs);
    ends[i] = scratch.runs.size();
  }
  std::size_t first = 0;
  for (std::size_t i = 0; i < some.size(); ++i) {
    const auto runs = std::span<const Cells::Run>(scratch.runs).subspan(first, ends[i] - first);
    add_partners(some[i], cells_.among(runs, boxes_[some[i].body], scratch.found), scratch.partners,
                 work);
    first = ends[i];
  }
}

/// Two that left are found by the lower one.
void Scene::add_partners(const Leaver& leaver, std::span<const std::uint32_t> found,
                         std::vector<std::uint32_t>& partners, PartnerWork& work) const {
  const std::uint32_t body = leaver.body;
  const Box& before = leaver.before;
  constexpr std::size_t kFew = 2;
  const std::size_t others = found.size() - 1;
  if (others <= kFew) (others == 0 ? work.alone : work.with_few).push_back(body);
  if (partners.size() < found.size()) resize(partners, found.size());
  std::size_t count = 0;
  for (const std::uint32_t other : found) {  // no branch depends on which are new
    partners[count] = other;
    const bool is_new = !scene::overlap(before, boxes_[other]);
    count += static_cast<std::size_t>(is_new) | static_cast<std::size_t>(is(other, kLeft));
  }
  const auto is_old = [&](std::uint32_t other) {  // of few: where those were before that left
    if (!is(other, kLeft)) return false;
    return other <= body || scene::overlap(before, left_[left_at_[other]].before);
  };
  for (const std::uint32_t other : std::span(partners).first(count)) {
    if (is_old(other) || !may_touch(body, other)) continue;
    work.lower.push_back(std::min(body, other));
    work.adding.emplace_back(std::max(body, other));
  }
}

/// Nothing is known of them, so all wait to be compared.
void Scene::look_at_new(std::span<const std::uint32_t> lower, PairWork& work) {
  Queue& apart = work.scratch->apart;
  for (std::uint32_t i = 0; i < lower.size(); ++i) {
    if (apart.count == apart.room()) collide_apart(work);
    apart.push({lower[i], work.candidates[i].b}, i);
  }
  collide_apart(work);
}

/// With what is known of them by now.
void Scene::add_candidates() {
  for (auto& [lower, adding, alone, with_few] : partner_works_) {
    for (std::size_t i = 0; i < adding.size(); ++i) {
      candidates_.prefetch(lower[ahead_of(i, kRowsAhead, adding.size())]);
      candidates_.add(lower[i], adding[i]);
    }
    counts_.pairs_added += adding.size();
    counts_.pairs.candidates += adding.size();
    clear_for(lower, body_count_);
    clear_for(adding, body_count_);
  }
}

}  // namespace manifuzz::scene
