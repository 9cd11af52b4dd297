#include <array>
#include <fcntl.h>
#include <memory>
#include <optional>
#include <type_traits>
#include <unistd.h>

#include "campaign/in_child.hpp"
#include "external/external_collider.hpp"
#include "process/child.hpp"
#include "process/pool.hpp"

namespace manifuzz {
namespace {

constexpr double kPollSeconds = 0.05;

/// An answer without pointers, for shared memory.
struct AnswerSlot {
  std::size_t kind = 0;  ///< its place among the kinds of an Answer
  PartialManifold manifold;
  Penetration penetration;
  Lost::How how = Lost::How::crashed;
  SharedText<512> why;

  void put(const Answer& answer) {
    kind = answer.index();
    if (const auto* const whole = std::get_if<Manifold<double>>(&answer)) manifold = {*whole};
    if (const auto* const partial = std::get_if<PartialManifold>(&answer)) manifold = *partial;
    if (const auto* const less = std::get_if<Penetration>(&answer)) penetration = *less;
    if (const auto* const declined = std::get_if<Unsupported>(&answer)) why.set(declined->why);
    if (const auto* const lost = std::get_if<Lost>(&answer)) {
      how = lost->how;
      why.set(lost->why);
    }
  }

  Answer answer() const {
    const std::array<Answer, std::variant_size_v<Answer>> kinds{
        manifold.manifold, Unsupported{why.str()}, manifold, Lost{how, why.str()}, penetration};
    return kinds[kind];
  }
};

/// What the collider's process and ours share.
struct HostSlot {
  PairCase pair;
  AnswerSlot answer;
};

class Host {
 public:
  explicit Host(const Collider& collider) : collider_(collider) {}

  /// None where it was told to stop.
  std::optional<Answer> ask(const PairCase& pair, const std::function<bool()>& go_on) {
    if (!child_.running()) start();
    slot_->pair = pair;
    char byte = 0;
    [[maybe_unused]] const auto written = write(child_.to(), &byte, 1);  // the wait sees it die
    const Clock::time_point began = Clock::now();
    while (!wait_readable(child_.from(), kPollSeconds)) {
      const bool is_stopped = !go_on();
      if (!is_stopped && seconds_since(began) <= kCaseSeconds) continue;
      child_.stop();
      return is_stopped ? std::nullopt : std::optional<Answer>(lost_by(Ending::timed_out));
    }
    if (read(child_.from(), &byte, 1) == 1) return slot_->answer.answer();
    child_.stop();
    return lost_by(Ending::crashed);
  }

 private:
  /// A byte from us asks a case, a byte from it says that the answer is there.
  void serve(int in, int out) {
    char byte = 0;
    while (read(in, &byte, 1) == 1) {
      slot_->answer.put(collider_.collide(slot_->pair));
      if (write(out, &byte, 1) != 1) return;
    }
  }

  void start() {
    const int errors = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
    child_.start([&](int in, int out) {
      dup2(errors, STDERR_FILENO);  // nobody reads its pipe of errors
      serve(in, out);
    });
    if (errors >= 0) close(errors);
  }

  Collider collider_;
  Shared<HostSlot> slot_;
  Child child_;
};

}  // namespace

Collider hosted(const Collider& collider) {
  if (collider.is_isolated()) return collider;
  const auto host = std::make_shared<Host>(collider);
  return isolated(collider.declaration, kCaseSeconds,
                  [host](auto pairs, auto answers, const auto& go_on) -> std::size_t {
                    const auto answer = host->ask(pairs[0], go_on);
                    if (answer) answers[0] = *answer;
                    return answer ? 1 : 0;
                  });
}

}  // namespace manifuzz
