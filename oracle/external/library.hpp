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

  const manifuzz_declaration& says() const { return *says_; }
  /// What `manifuzz_collide` returns; the manifold comes zeroed.
  int collide(const PairCase& pair, manifuzz_manifold& manifold) const;

 private:
  const manifuzz_declaration* says_ = nullptr;
  decltype(&manifuzz_collide) collide_ = nullptr;
};

/// The declaration in our terms. Throws UserError that names the field that is wrong.
Declaration declaration_of(const manifuzz_declaration& says);

/// What was returned for a case, in our terms: in A's frame, its normal from A to B.
Answer answer_of(int status, const manifuzz_manifold& manifold, const manifuzz_declaration& says,
                 const PairCase& pair);

/// A collider that runs in this process: the fastest, and it can take the process along.
Collider collider_in_process(const std::string& path);

}  // namespace manifuzz
