#pragma once

#include <string_view>

namespace manifuzz {

// What src/embed.cmake makes of the files that texts.txt lists.

/// Colliders to begin with: examples of scripts/colliders.
extern const std::string_view kPythonCollider;
extern const std::string_view kJavaScriptCollider;
extern const std::string_view kCCollider;
/// What the one in C includes.
extern const std::string_view kColliderHeader;

/// A workflow of GitHub, in which `@url@` and the like stand for what workflow.hpp names.
extern const std::string_view kWorkflow;

}  // namespace manifuzz
