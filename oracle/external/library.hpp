#pragma once

#include <string>

#include "collider/collider.hpp"
#include "oracle/external/manifuzz_collider.h"

namespace manifuzz {

/// A shared library after manifuzz_collider.h, loaded into this process for good.
class Library {
 public:
  /// Throws UserError that says what is wrong with it.
  explicit Library(const std::string& path);

  const manifuzz_declaration& declaration() const { return *declaration_; }
  /// What `manifuzz_collide` returns; the manifold comes zeroed.
  int collide(const PairCase& pair, manifuzz_manifold& manifold) const;

 private:
  const manifuzz_declaration* declaration_ = nullptr;
  decltype(&manifuzz_collide) collide_ = nullptr;
};

/// The declaration as a `Declaration`. Throws UserError that names the field that is wrong.
Declaration declaration_of(const manifuzz_declaration& declared);

/// What `manifuzz_collide` returned for a case (0, or 1 where it declines) and the manifold that it
/// filled in, as an answer: in A's frame, its normal from A to B; `Lost` where it is no manifold.
Answer answer_of(int status, const manifuzz_manifold& manifold,
                 const manifuzz_declaration& declared, const PairCase& pair);

/// A shared library after manifuzz_collider.h as a collider in this process: the fastest, but where
/// it crashes, so does this process. Throws UserError where the library cannot be loaded.
Collider collider_in_process(const std::string& path);

}  // namespace manifuzz
