#include "kernel/target.hpp"

#include <hwy/targets.h>

namespace manifuzz::kernel {

#ifdef HWY_COMPILE_ONLY_STATIC

std::vector<std::string> targets() {
  return {hwy::TargetName(HWY_STATIC_TARGET)};
}

void use_target(const std::string&) {}

#else

std::vector<std::string> targets() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    names.emplace_back(hwy::TargetName(target));
  }
  return names;
}

void use_target(const std::string& name) {
  hwy::SetSupportedTargetsForTest(0);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (name == hwy::TargetName(target)) hwy::SetSupportedTargetsForTest(target);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

#endif

}  // namespace manifuzz::kernel
