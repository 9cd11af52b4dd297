#pragma once

// Catch2 is parsed once for all tests.

#include <catch2/catch.hpp>
