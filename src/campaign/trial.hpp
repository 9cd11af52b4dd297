#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"
#include "process/pool.hpp"

namespace manifuzz {

/// How a child ended, and who was at work then.
struct Loss {
  Ending ending = Ending::crashed;
  Fault at_work = Fault::none;
};

/// What shrinking gives: the smallest case that is the same finding.
struct Smallest {
  AnyCase any;
  bool complete = true;  ///< false where time or a limit came before the minimum
};

/// Who is asked about cases of one kind, and how that is judged, shrunk and recorded. Whoever is
/// asked may die or hang: that is a verdict. What may be interrupted throws Interrupted.
class Trial {
 public:
  virtual ~Trial() = default;
  Trial& operator=(Trial&&) = delete;  // neither moved nor copied

  /// The collider under test; of what is not asked about pairs the declaration alone.
  const Collider& subject() const { return subject_; }
  /// The collider it is held against; of no name where the judge alone says who is right.
  const Collider& oracle() const { return oracle_; }

  /// Whether the subject is installed.
  virtual bool is_there() const { return true; }
  virtual Judgement judge(const AnyCase& any, Interruption& interruption) const = 0;
  /// The judgement where a child ended before it had one.
  virtual Judgement judge_lost(const AnyCase& any, const Loss& loss,
                               Interruption& interruption) const = 0;
  /// Ends early, with the smallest so far, at the deadline, and at the first signal from now on.
  virtual Smallest shrink(const AnyCase& any, Interruption& interruption,
                          const Deadline& deadline) const = 0;
  /// What keeps a case with this verdict from being shrunk, and what is expected; else empty.
  virtual std::string why_unshrinkable(const Judgement& judgement, bool was_begun) const = 0;
  /// The corpus case with what these answer now. A severity that is not there until the deadline,
  /// or, once there is hurry, after a second, is left out.
  virtual CorpusCase recorded(const AnyCase& any, const Judgement& judgement,
                              Interruption& interruption,
                              const Deadline& severity_until = {}) const = 0;
  /// The corpus case without asking anybody.
  virtual CorpusCase unasked(const AnyCase& any, const Judgement& judgement) const = 0;

 protected:
  Trial(Collider subject, Collider oracle)
      : subject_(std::move(subject)), oracle_(std::move(oracle)) {}

 private:
  Collider subject_;
  Collider oracle_;
};

/// The trial of a case by those that it names, or that were given; nullptr where there is no
/// subject of that name.
using TrialOf = std::function<std::shared_ptr<const Trial>(const CorpusCase& known)>;

}  // namespace manifuzz
