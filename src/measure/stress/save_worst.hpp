#pragma once

#include <filesystem>
#include <functional>

#include "measure/stress/stress.hpp"

namespace manifuzz {

/// Writes the worst of a run to a corpus, a file a sweep and collider, over those of runs before
/// that are no worse:
/// - where a collider is wrong, by the judge too: the case on which it is farthest off, shrunk, in
///   the folder of its verdict;
/// - of `clip` otherwise, against Box2D or, where that leaves nothing to decide, clip64: the case
///   of its largest error, as a case on which it must stay right.
/// `on_file` is told of each before it is shrunk, `on_kept` of each file of a run before that shows
/// a worse case. Throws UserError where one cannot be written, and Interrupted.
void save_worst(const StressPlan& plan, const StressResult& result,
                const std::filesystem::path& corpus, Interruption& interruption,
                const std::function<void(const std::string& name)>& on_file,
                const std::function<void(const std::filesystem::path& file)>& on_kept);

}  // namespace manifuzz
