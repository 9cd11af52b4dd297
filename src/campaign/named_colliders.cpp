#include "campaign/named_colliders.hpp"

namespace manifuzz {

NamedColliders::NamedColliders(const Find& find, const std::optional<Collider>& subject,
                               const std::optional<Collider>& oracle)
    : find_(find), has_subject_(subject.has_value()), has_oracle_(oracle.has_value()) {
  if (subject) known_[subject_ = subject->declaration.name] = subject;
  if (oracle) known_[oracle_ = oracle->declaration.name] = oracle;
}

const Collider* NamedColliders::find(const std::string& name) {
  auto known = known_.find(name);
  if (known == known_.end()) known = known_.emplace(name, find_(name)).first;
  return known->second ? &*known->second : nullptr;
}

const Collider* NamedColliders::subject_of(const CorpusCase& known) {
  const bool names_one = known.expect && !known.expect->subject.empty();
  return find(has_subject_ || !names_one ? subject_ : known.expect->subject);
}

const Collider* NamedColliders::oracle_of(const CorpusCase& known) {
  const bool names_one = known.expect && !known.expect->oracle.empty();
  const Collider* named = has_oracle_ || !names_one ? nullptr : find(known.expect->oracle);
  return named != nullptr ? named : find(oracle_);
}

}  // namespace manifuzz
