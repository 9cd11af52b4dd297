#include <filesystem>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "report/measurements/measurements.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

namespace {

LinePlot plot() {
  return {.title = "a title",
          .x_label = "knob",
          .y_label = "error",
          .falls = true,
          .limit = 0.01,
          .lines = {{.name = "clip", .points = {{1, 1e-7}, {0.1, 0}}, .breaks_at = {}},
                    {.name = "pair", .points = {{1, 1e-7}, {0.1, 0}}, .breaks_at = {}},
                    {.name = "other", .points = {{1, 1e-6}, {0.1, 1}}, .breaks_at = 1}}};
}

}  // namespace

TEST_CASE("lines of equal points are drawn once, with all their names") {
  const auto lines = merged(plot().lines);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].name == "clip, pair");
  CHECK(lines[1].name == "other");
  auto broken = plot().lines;
  broken[1].breaks_at = 0;
  CHECK(merged(broken).size() == 3);
}

TEST_CASE("a picture of lines names them and what is on its axes") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "lines.svg";
  write_plot(path.string(), plot());
  const std::string svg = test::text_of(path);
  for (const char* text : {"a title", "knob", "error", "clip, pair", "other", "breaks here"}) {
    CAPTURE(text);
    CHECK(svg.find(text) != std::string::npos);
  }
  CHECK_THROWS_AS(write_plot((folder.path() / "lines.txt").string(), plot()), UserError);
}
