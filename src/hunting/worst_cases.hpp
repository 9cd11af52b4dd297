#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "hunting/hunt.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

// The worst known cases: in a corpus, worst/COLLIDER/GAUGE.json.

std::filesystem::path worst_file(const std::filesystem::path& corpus, const std::string& collider,
                                 Gauge gauge);

/// What the collider's answer gives now, asked in a process of its own; none where it gives no
/// answer that is judged. Throws Interrupted.
std::optional<Observation> observed_now(const Collider& collider, const PairCase& pair,
                                        Interruption& interruption);

/// What a file says of its case.
std::string note_of_worst(Gauge gauge, double value);

/// Writes the hunt's worst case of each gauge to the folder and names its file, but where one of
/// the known folders has a case that is as bad. What cannot be written is an error of the hunt's
/// saving.
void keep_worst(Hunt& hunt, std::span<const std::filesystem::path> known,
                const std::filesystem::path& folder);

}  // namespace manifuzz
