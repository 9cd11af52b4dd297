#include "python/records.hpp"

NB_MODULE(_core, module) {
  using namespace manifuzz::python;
  module.doc() = "What manifuzz/__init__.py calls once it has looked at its arrays.";
  define_clip(module);
  define_batch(module);
  define_cases(module);
  define_judge(module);
}
