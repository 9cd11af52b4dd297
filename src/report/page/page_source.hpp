#pragma once

#include <string_view>

namespace manifuzz {

/// `page/page.html`, in which `@style@`, `@script@` and `@data@` stand once each for what goes
/// there.
extern const std::string_view kPageTemplate;

/// The style sheets of `page/files.txt`, one after the other.
extern const std::string_view kPageStyle;

/// The scripts of `page/files.txt`, one after the other: one module.
extern const std::string_view kPageScript;

}  // namespace manifuzz
