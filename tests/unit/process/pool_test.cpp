#include "process/pool.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <catch2/catch.hpp>

#include "process/child.hpp"
#include "process/patience.hpp"

using namespace manifuzz;

namespace {

constexpr double kLong = 1e6;  // seconds: it is never waited for
constexpr double kAtOnce = 0;  // whoever makes no progress from one look to the next

bool has_children() {
  return waitpid(-1, nullptr, WNOHANG) >= 0 || errno != ECHILD;
}

struct Work {
  SharedQueue queue;
  std::array<std::atomic<int>, 100> done{};  ///< how often each number was
};

void take_all(Work& work) {
  while (work.queue.is_open()) {
    const SharedQueue::Block block = work.queue.take(7);
    if (block.begin == block.end) return;
    for (std::uint64_t i = block.begin; i < block.end; ++i) ++work.done[i];
  }
}

}  // namespace

TEST_CASE("jobs take every number once") {
  const Shared<Work> work;
  work->queue.next = 3;
  work->queue.end = work->done.size();
  Interruption interruption;
  const Pool pool{.jobs = 3,
                  .body = [&](int) { take_all(*work); },
                  .progress = [](int) { return 0; },
                  .seconds_max = kLong,
                  .on_lost = [](int, Ending) { return false; }};
  CHECK_FALSE(run_pool(pool, interruption).is_stopped);
  for (std::size_t i = 0; i < work->done.size(); ++i) CHECK(work->done[i] == (i < 3 ? 0 : 1));
  CHECK_FALSE(has_children());
}

TEST_CASE("a job that dies is replaced for as long as it is asked for") {
  const Shared<std::atomic<int>> starts;
  Interruption interruption;
  int lost = 0;
  const Pool pool{.body =
                      [&](int) {
                        if (++*starts < 4) _exit(9);
                      },
                  .progress = [](int) { return 0; },
                  .seconds_max = kLong,
                  .on_lost =
                      [&](int, Ending ending) {
                        CHECK(ending == Ending::crashed);
                        return ++lost < 9;
                      }};
  CHECK_FALSE(run_pool(pool, interruption).is_stopped);
  CHECK(*starts == 4);
  CHECK(lost == 3);
}

TEST_CASE("how a child ends is told") {
  Interruption interruption;
  const auto pauses = [] { pause(); };
  CHECK(run_in_child([] {}, kLong, interruption) == Ending::done);
  CHECK(run_in_child([] { _exit(1); }, kLong, interruption) == Ending::crashed);
  CHECK(run_in_child([] { std::exit(0); }, kLong, interruption) == Ending::crashed);
  CHECK(run_in_child([] { throw std::runtime_error("x"); }, kLong, interruption) ==
        Ending::crashed);
  CHECK(run_in_child(pauses, kAtOnce, interruption) == Ending::timed_out);
  Interruption first_signal(kUntilSignal);
  raise(SIGINT);
  CHECK(run_in_child(pauses, kLong, first_signal) == Ending::stopped);
  CHECK_FALSE(has_children());
}

TEST_CASE("what waits for a processor is not late, and what sleeps is") {
  const auto spins = [] {
    const auto begin = Clock::now();
    while (seconds_since(begin) < kLong) {
    }
  };
  std::vector<pid_t> rivals;
  for (unsigned i = 0; i <= 4 * std::thread::hardware_concurrency(); ++i) {
    rivals.push_back(spawn(spins));
  }
  Patience with_rivals;
  with_rivals.begin(rivals.front());
  CHECK_FALSE(with_rivals.is_over(kLong));
  const pid_t sleeper = spawn([] { pause(); });
  Patience asleep;
  asleep.begin(sleeper);
  CHECK_FALSE(asleep.is_over(kLong));
  while (!asleep.is_over(0.5)) usleep(1000);
  CHECK_FALSE(with_rivals.is_over(0.45));
  CHECK(seconds_waited(rivals.front()) > 0.1);
  CHECK(seconds_waited(sleeper) < 0.1);
  for (const pid_t rival : rivals) kill_and_wait(rival);
  kill_and_wait(sleeper);
  CHECK(seconds_waited(sleeper) == 0);
}

TEST_CASE("once there is hurry jobs are told, and end by themselves") {
  const Shared<std::atomic<bool>> hurry;
  Interruption interruption;
  const auto until_hurry = [&] {
    while (!*hurry) usleep(1000);
  };
  raise(SIGTERM);
  CHECK(run_in_child(until_hurry, kLong, interruption, {}, &*hurry) == Ending::done);
}

TEST_CASE("no child outlives a pool that throws") {
  Interruption interruption;
  const Pool pool{.jobs = 2,
                  .body =
                      [](int job) {
                        if (job == 0) _exit(1);
                        pause();
                      },
                  .progress = [](int) { return 0; },
                  .seconds_max = kLong,
                  .on_lost = [](int, Ending) -> bool { throw std::runtime_error("defect"); }};
  CHECK_THROWS_AS(run_pool(pool, interruption), std::runtime_error);
  CHECK_FALSE(has_children());
}
