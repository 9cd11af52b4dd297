#include <memory>

#include "external/external_collider.hpp"

namespace manifuzz {

LibraryCall call(CollideFunction collide, const PairCase& pair, manifuzz_manifold& manifold) {
  const manifuzz_body a = c_body(pair.a);
  const manifuzz_body b = c_body(pair.b);
  manifold = {};
  const CallWatch watch;
  const int status = collide(&a, &b, &manifold);
  return {status, watch.end()};
}

LibraryCall Library::collide(const PairCase& pair, manifuzz_manifold& manifold) const {
  return call(collide_, pair, manifold);
}

Collider collider_of_function(const manifuzz_declaration& declared, CollideFunction collide) {
  Collider collider;
  collider.declaration = declaration_of(declared);
  collider.collide = [declared, collide,
                      declaration = collider.declaration](const PairCase& pair) -> Answer {
    if (auto declined = beyond_limits(declaration, pair)) return *declined;
    manifuzz_manifold manifold;
    return answer_of(call(collide, pair, manifold), manifold, declaration, declared, pair);
  };
  return collider;
}

Collider collider_in_process(const std::string& path) {
  const Library library(path);  // which stays loaded
  return collider_of_function(library.declaration(), library.function());
}

}  // namespace manifuzz
