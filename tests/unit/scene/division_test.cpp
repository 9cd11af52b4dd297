#include "scene/division.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <set>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "scene/threads.hpp"

// How a step is divided: each thing belongs to one task, and each task has a scratch of its own.

using namespace manifuzz;
using scene::Division;
using scene::Lending;
using scene::Scratch;

TEST_CASE("loans of one time have a scratch each, and a new one has the first that is free") {
  CHECK(rc::check("loans begin and end in any order", [] {
    std::vector<Scratch> scratches(scene::kTasks);
    Lending lending(scratches);
    std::vector<std::unique_ptr<Lending::Loan>> loans(scene::kTasks);  // by scratch
    for (const auto place : *rc::gen::container<std::vector<std::size_t>>(
             rc::gen::inRange<std::size_t>(0, 2 * scene::kTasks))) {
      if (place < loans.size()) {
        loans[place].reset();
        continue;
      }
      const auto free = std::ranges::find_if(loans, [](const auto& loan) { return !loan; });
      if (free == loans.end()) continue;
      *free = std::make_unique<Lending::Loan>(lending);
      RC_ASSERT(&**free->get() == &scratches[static_cast<std::size_t>(free - loans.begin())]);
    }
  }));
}

TEST_CASE("each thing is in one share, and a task's scratch is no other's while it runs") {
  scene::Threads threads(4);
  const scene::Executor executor = std::ref(threads);
  CHECK(rc::check("any number of things, with threads or without", [&] {
    Division division;
    const bool has_executor = *rc::gen::arbitrary<bool>();
    if (has_executor) division.set_executor(executor);
    const auto things = *rc::gen::inRange<std::size_t>(0, 300);
    const std::size_t tasks = division.tasks_for(things);
    RC_ASSERT(tasks == (has_executor && things > 8 * scene::kTasks ? scene::kTasks : 1));
    std::vector<std::atomic<int>> seen(things);
    std::mutex mutex;
    std::set<const Scratch*> in_use;
    bool is_shared = false;
    const auto note = [&](const auto& act) {
      const std::lock_guard lock(mutex);
      act();
    };
    division.divide_with_scratch(things, tasks,
                                 [&](const scene::Share& share, std::size_t, Scratch& scratch) {
                                   note([&] { is_shared |= !in_use.insert(&scratch).second; });
                                   for (std::size_t i = share.first; i < share.last; ++i) ++seen[i];
                                   note([&] { in_use.erase(&scratch); });
                                 });
    RC_ASSERT(!is_shared);
    RC_ASSERT(std::ranges::all_of(seen, [](const auto& n) { return n == 1; }));
  }));
}
