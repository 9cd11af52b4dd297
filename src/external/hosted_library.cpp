#include <algorithm>
#include <array>
#include <atomic>
#include <fcntl.h>
#include <memory>
#include <optional>
#include <unistd.h>

#include <fmt/format.h>

#include "base/text.hpp"
#include "external/external_collider.hpp"
#include "process/child.hpp"
#include "process/patience.hpp"
#include "process/pool.hpp"
#include "process/signals.hpp"

namespace manifuzz {
namespace {

constexpr double kLoadSecondsMax = 20;
constexpr double kPollSeconds = 0.05;

/// What the library's process and ours share.
struct SharedState {
  manifuzz_declaration declared{};  ///< its texts are in those below
  SharedText<64> name;
  SharedText<64> version;
  SharedText<16384> snippet;
  SharedText<512> tolerance_source;
  SharedText<512> error;  ///< why it could not be loaded
  std::atomic<int> asked{0};
  std::atomic<int> answered{0};
  std::array<PairCase, kBatch> cases;
  std::array<manifuzz_manifold, kBatch> manifolds{};
  std::array<LibraryCall, kBatch> calls{};
};

/// What a library prints is no output of ours; in process it is seen.
void silence() {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

/// The library's process: a byte from us asks for a batch, a byte from it says that it is done.
void serve(const std::string& path, SharedState& shared, int in, int out) {
  silence();
  char byte = 0;
  std::optional<Library> library;
  try {
    library.emplace(path);
    shared.declared = library->declaration();
    shared.name.set(shared.declared.name);
    shared.version.set(shared.declared.version);
    shared.snippet.set(shared.declared.snippet);
    shared.tolerance_source.set(shared.declared.claims.tolerance_source);
  } catch (const UserError& error) {
    shared.error.set(error.what());
  }
  while (write(out, &byte, 1) == 1 && library && read(in, &byte, 1) == 1) {
    const int asked = shared.asked;
    for (int i = 0; i < asked; ++i) {
      shared.calls[i] = library->collide(shared.cases[i], shared.manifolds[i]);
      shared.answered.store(i + 1, std::memory_order_release);
    }
  }
}

class HostedLibrary {
 public:
  HostedLibrary(std::string path, double seconds_max)
      : path_(std::move(path)), seconds_max_(seconds_max) {}

  Declaration load() {
    const std::string death = start();
    if (!death.empty())
      throw UserError(fmt::format("{}: {} while it was loaded", printable(path_, 200), death));
    const SharedState& shared = **shared_;
    if (!shared.error.str().empty()) throw UserError(shared.error.str());
    manifuzz_declaration declared = shared.declared;
    declared.name = shared.name.c_str();
    declared.version = shared.version.c_str();
    declared.snippet = shared.snippet.c_str();
    declared.claims.tolerance_source = shared.tolerance_source.c_str();
    try {
      declaration_ = declaration_of(declared);
      return declaration_;
    } catch (const UserError& error) {
      throw UserError(fmt::format("{}: {}", printable(path_, 200), error.what()));
    }
  }

  /// Answers at least one, unless told to stop.
  std::size_t answer_batch(std::span<const PairCase> pairs, std::span<Answer> answers,
                           const std::function<bool()>& go_on) {
    if (!child_.running()) {
      const std::string death = start();
      if (!death.empty()) {
        answers[0] = Lost{Lost::How::crashed, death + " while it was loaded again"};
        return 1;
      }
    }
    SharedState& shared = **shared_;
    std::ranges::copy(pairs, shared.cases.begin());
    shared.asked = static_cast<int>(pairs.size());
    shared.answered = 0;
    const char byte = 0;
    [[maybe_unused]] const auto written = write(child_.to(), &byte, 1);  // the wait sees it die
    const std::optional<Lost> lost = wait_for_answers(go_on);
    const int answered = std::clamp(shared.answered.load(), 0, shared.asked.load());
    auto done = std::min(static_cast<std::size_t>(answered), pairs.size());
    for (std::size_t i = 0; i < done; ++i) {
      answers[i] =
          answer_of(shared.calls[i], shared.manifolds[i], declaration_, shared.declared, pairs[i]);
    }
    if (lost && done < pairs.size()) answers[done++] = *lost;
    return done;
  }

 private:
  /// Says how it died, if it did.
  std::string start() {
    shared_ = std::make_unique<Shared<SharedState>>();
    child_.start([&](int in, int out) { serve(path_, **shared_, in, out); });
    const Deadline deadline = after(kLoadSecondsMax);
    while (!wait_readable(child_.from(), kPollSeconds)) {
      if (!has_passed(deadline) && !child_.has_ended() && !is_out_of_time()) continue;
      const std::string death = child_.stop();
      if (!death.empty()) return death;
      return fmt::format("took more than {} s", kLoadSecondsMax);
    }
    return took_byte() ? "" : child_.stop();
  }

  bool took_byte() const {
    char byte = 0;
    return read(child_.from(), &byte, 1) == 1;
  }

  /// Until all is answered or nothing more will come; what became of the case at work, if it was
  /// lost.
  std::optional<Lost> wait_for_answers(const std::function<bool()>& go_on) {
    int seen = 0;
    Patience patience;
    patience.begin(child_.process());
    while (!wait_readable(child_.from(), kPollSeconds)) {
      const int answered = (*shared_)->answered.load(std::memory_order_acquire);
      if (answered != seen) {
        seen = answered;
        patience.begin(child_.process());
      }
      const bool stopped = !go_on() || is_out_of_time();
      const bool has_died = child_.has_ended();  // what it forked may keep its pipe open
      if (!stopped && !has_died && !patience.is_over(seconds_max_)) continue;
      const std::string death = child_.stop();
      if (stopped) return std::nullopt;
      if (has_died) return Lost{Lost::How::crashed, death};
      return Lost{Lost::How::timed_out, fmt::format("no answer in {} s", seconds_max_)};
    }
    if (took_byte()) return std::nullopt;
    return Lost{Lost::How::crashed, child_.stop()};
  }

  std::string path_;
  double seconds_max_;
  Declaration declaration_;
  Child child_;
  std::unique_ptr<Shared<SharedState>> shared_;
};

}  // namespace

Collider collider_in_own_process(const std::string& path, double seconds_max) {
  const auto library = std::make_shared<HostedLibrary>(path, seconds_max);
  return isolated(library->load(), kLoadSecondsMax + seconds_max,
                  [library](auto pairs, auto answers, const auto& go_on) {
                    return library->answer_batch(pairs, answers, go_on);
                  });
}

}  // namespace manifuzz
