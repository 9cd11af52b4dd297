#include <map>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "unit/committed_tree.hpp"
#include "unit/functions.hpp"

// The sources of a library are compiled as one: anonymous namespaces of all of them are one too.
// What stands there is found before a function of the same name that a header declares, or is
// defined twice.

using namespace manifuzz::test;

namespace {

/// What calls may take for one another: its namespaces, its name, its parameters.
using Called = std::tuple<std::string, std::string, std::string>;

Called called(const NamedFunction& function) {
  return {function.scope, function.name, function.parameters};
}

/// src/NAME/ or oracle/NAME/: what is compiled as one, at most; empty of other files.
std::string library_of(const std::string& path) {
  if (!path.starts_with("src/") && !path.starts_with("oracle/")) return {};
  const std::size_t end = path.find('/', path.find('/') + 1);
  return end == std::string::npos ? std::string() : path.substr(0, end + 1);
}

Violations hiding_functions(const std::vector<SourceFile>& files) {
  std::map<Called, std::string> declared;
  for (const SourceFile& file : files) {
    if (library_of(file.path).empty() || !file.path.ends_with(".hpp")) continue;
    for (const NamedFunction& function : functions_in(file.text)) {
      declared.emplace(called(function), file.path);
    }
  }
  Violations found;
  std::map<std::pair<std::string, Called>, std::string> hidden;
  for (const SourceFile& file : files) {
    const std::string library = library_of(file.path);
    if (library.empty() || !file.path.ends_with(".cpp")) continue;
    for (const NamedFunction& function : functions_in(file.text)) {
      if (!function.is_hidden || !function.has_body) continue;
      const auto said = [&](const std::string& where) {
        return fmt::format("{}: {}({}) is in {} too", file.path, function.name, function.parameters,
                           where);
      };
      if (const auto other = declared.find(called(function)); other != declared.end()) {
        found.push_back(said(other->second));
      }
      const auto [first, is_first] =
          hidden.emplace(std::pair(library, called(function)), file.path);
      if (!is_first && first->second != file.path) found.push_back(said(first->second));
    }
  }
  return found;
}

}  // namespace

TEST_CASE("no hidden function has the name of another that its library's sources see") {
  CHECK(hiding_functions(tree()) == Violations{});
}

TEST_CASE("a hidden function that another may be taken for is caught") {
  const SourceFile header{
      "src/exact/a.hpp",
      "namespace manifuzz::exact {\nint f(const Pose& pose, int n = g(1, 2));\n}"};
  const auto with_source = [&](const std::string& path, const std::string& text) {
    return hiding_functions({header, {path, text}}).size();
  };
  const std::string hidden =
      "namespace manifuzz::exact {\nnamespace {\nint f(const Pose& a, int b) "
      "{ return g({a, b}); }\n}\n}";
  CHECK(with_source("src/exact/a.cpp", hidden) == 1);
  CHECK(with_source("oracle/planck/a.cpp", hidden) == 1);
  CHECK(with_source("tests/unit/a.cpp", hidden) == 0);
  CHECK(with_source("src/exact/a.cpp",
                    "namespace manifuzz::exact {\nint f(const Pose& a, int b) {}\n}") == 0);
  CHECK(with_source("src/exact/a.cpp",
                    "namespace manifuzz {\nnamespace {\nint f(const Pose& a, int b) "
                    "{}\n}\n}") == 0);
  CHECK(with_source("src/exact/a.cpp",
                    "namespace manifuzz::exact {\nnamespace {\nint f(int b) {}\n}\n}") == 0);
  CHECK(hiding_functions({{"src/exact/a.cpp", hidden}, {"src/exact/b.cpp", hidden}}).size() == 1);
  CHECK(hiding_functions({{"src/exact/a.cpp", hidden}, {"src/scene/b.cpp", hidden}}).empty());
}

TEST_CASE("functions are told from what else stands in a namespace") {
  const auto found = functions_in(R"cpp(
#define F(x) \
      int x() {}
    /* int no(); */ namespace a {
    namespace b {
    struct S {
      int member() { return 0; }
    };
    const std::string kText = text("};");  // int no();
    std::map<int, std::function<void(int)>> table(std::span<const S> all, char quote = '"') {
      if (all) {
      }
    }
    int S::defined() {
      return 1;
    }
    bool operator==(const S&, const S&) {
      return true;
    }
    template <class T>
    requires(sizeof(T) > 1) T largest(T one, T other);
    namespace {
    const auto kList = {R"(})", "}"};
    void hidden(void) {}
    }  // namespace
    }  // namespace b
    }  // namespace a
  )cpp");
  REQUIRE(found.size() == 3);
  CHECK(found[0].scope == "a::b");
  CHECK(found[0].name == "table");
  CHECK(found[0].parameters == "std :: span < const S >, char");
  CHECK(found[0].has_body);
  CHECK(found[1].name == "largest");
  CHECK_FALSE(found[1].has_body);
  CHECK(found[2].name == "hidden");
  CHECK(found[2].parameters.empty());
  CHECK(found[2].is_hidden);
}
