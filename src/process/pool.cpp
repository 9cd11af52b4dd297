#include "process/pool.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <sys/mman.h>
#include <sys/wait.h>
#include <vector>

#include "process/child.hpp"
#include "process/patience.hpp"

namespace manifuzz {

SharedMemory shared_memory(std::size_t bytes) {
  void* const data =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (data == MAP_FAILED) throw std::bad_alloc();
  return {data, [bytes](void* mapped) { munmap(mapped, bytes); }};
}

namespace {

constexpr double kPollSeconds = 0.1;
constexpr double kTickSeconds = 0.2;

class WatchedChild {
 public:
  WatchedChild() = default;
  ~WatchedChild() { kill(); }
  WatchedChild& operator=(WatchedChild&&) = delete;  // neither moved nor copied

  bool is_running() const { return process_ > 0; }

  void start(const std::function<void()>& body) {
    process_ = spawn(body);
    patience_.begin(process_);
  }

  /// How it ended, once it has.
  std::optional<Ending> look(std::uint64_t progress, double seconds_max) {
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) == process_) {
      process_ = 0;
      return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::done : Ending::crashed;
    }
    if (progress != progress_) {
      progress_ = progress;
      patience_.begin(process_);
    }
    if (!patience_.is_over(seconds_max)) return std::nullopt;
    kill();
    return Ending::timed_out;
  }

 private:
  void kill() {
    if (is_running()) kill_and_wait(process_);
    process_ = 0;
  }

  pid_t process_ = 0;
  std::uint64_t progress_ = 0;
  Patience patience_;
};

}  // namespace

SharedQueue::Block SharedQueue::take(std::uint64_t length) {
  const std::uint64_t begin = std::min(next.fetch_add(length), end);
  return {begin, begin + std::min(length, end - begin)};
}

PoolResult run_pool(const Pool& pool, Interruption& interruption) {
  const auto begin = Clock::now();
  std::vector<WatchedChild> children(pool.jobs);
  const auto start = [&](int job) { children[job].start([&pool, job] { pool.body(job); }); };
  for (int job = 0; job < pool.jobs; ++job) start(job);
  double next_tick = kTickSeconds;
  // It may be hurried from the start: then nothing is waited for.
  for (double poll = 0; std::ranges::any_of(children, &WatchedChild::is_running);
       poll = kPollSeconds) {
    interruption.wait(poll);
    const Interruption::State state = interruption.state();
    if (state == Interruption::State::stopped) return {true, seconds_since(begin)};
    if (state == Interruption::State::hurried && pool.hurry) *pool.hurry = true;
    for (int job = 0; job < pool.jobs; ++job) {
      if (!children[job].is_running()) continue;
      const auto ending = children[job].look(pool.progress(job), pool.seconds_max);
      if (ending && *ending != Ending::done && pool.on_lost(job, *ending)) start(job);
    }
    const double seconds = seconds_since(begin);
    if (!pool.on_tick || seconds < next_tick) continue;
    next_tick = seconds + kTickSeconds;
    pool.on_tick(seconds);
  }
  return {false, seconds_since(begin)};
}

Ending run_in_child(const std::function<void()>& body, double seconds_max,
                    Interruption& interruption, const std::function<std::uint64_t()>& progress,
                    std::atomic<bool>* hurry) {
  Ending ending = Ending::done;
  const Pool pool{.body = [&](int) { body(); },
                  .progress = [&](int) { return progress ? progress() : 0; },
                  .seconds_max = seconds_max,
                  .on_lost =
                      [&](int, Ending lost) {
                        ending = lost;
                        return false;
                      },
                  .hurry = hurry};
  return run_pool(pool, interruption).is_stopped ? Ending::stopped : ending;
}

}  // namespace manifuzz
