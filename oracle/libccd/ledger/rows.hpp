#pragma once

#include <vector>

#include "judging/ledger.hpp"

namespace manifuzz {

std::vector<LedgerRows> libccd_ledger();

}  // namespace manifuzz
