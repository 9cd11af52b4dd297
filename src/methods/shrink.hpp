#pragma once

#include "geometry/convex_polygon.hpp"
