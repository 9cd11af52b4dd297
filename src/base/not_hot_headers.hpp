#pragma once

// What sources that are not hot include of other projects besides: JSON alone would cost each hot
// source a third of a second, whether it uses it or not.

#include <filesystem>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
