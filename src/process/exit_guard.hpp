#pragma once

#include <functional>

namespace manifuzz {

/// Runs it. Where anything calls exit meanwhile, the process ends at once with the status that
/// `on_exit` gives.
int guarding_exit(const std::function<int()>& run, const std::function<int()>& on_exit);

}  // namespace manifuzz
