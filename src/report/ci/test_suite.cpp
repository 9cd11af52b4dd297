#include <pugixml.hpp>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "report/ci/ci_output.hpp"

namespace manifuzz {

std::string fit_for_logs(std::string_view text, std::string_view kept) {
  constexpr auto replace = nlohmann::json::error_handler_t::replace;
  std::string fit = nlohmann::json::parse(nlohmann::json(text).dump(-1, ' ', false, replace));
  bool is_second_of_control = false;
  for (char& c : fit) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_control = byte < 0x20 || byte == 0x7f || (is_second_of_control && byte < 0xa0);
    is_second_of_control = byte == 0xc2;  // U+0080 to U+009F follow
    if (is_control && byte < 0x80 && kept.find(c) == kept.npos) c = ' ';
    if (is_control && byte >= 0x80) c = static_cast<char>(0xa0);  // a blank that does not break
  }
  return fit;
}

namespace {

void set(pugi::xml_node& node, const char* attribute, std::string_view text) {
  node.append_attribute(attribute) = fit_for_logs(text).c_str();
}

/// The counts of a suite, or of all of them; an error stands for a test that could not be.
void set_counts(pugi::xml_node& node, std::span<const TestSuite> suites) {
  std::size_t tests = 0;
  std::size_t failures = 0;
  std::size_t errors = 0;
  double seconds = 0;
  for (const TestSuite& suite : suites) {
    tests += suite.tests.size() + suite.errors.size();
    failures += suite.failures();
    errors += suite.errors.size();
    seconds += suite.seconds();
  }
  node.append_attribute("tests") = tests;
  node.append_attribute("failures") = failures;
  node.append_attribute("errors") = errors;
  set(node, "time", fmt::format("{:.3f}", seconds));
}

pugi::xml_node add_test(pugi::xml_node& node, const TestSuite& suite, std::string_view name,
                        double seconds) {
  pugi::xml_node test = node.append_child("testcase");
  set(test, "classname", suite.name);
  set(test, "name", name);
  set(test, "time", fmt::format("{:.6f}", seconds));
  return test;
}

/// With its last line's end.
std::string lines(const std::string& text) {
  return text.empty() || text.ends_with('\n') ? text : text + '\n';
}

void add_failure(pugi::xml_node test, const TestFailure& failure) {
  pugi::xml_node node = test.append_child("failure");
  set(node, "message", in_words(failure));
  std::string body = lines(failure.command);
  if (!body.empty() && !failure.picture.empty()) body += '\n';
  body += lines(failure.picture);
  if (!body.empty()) node.text() = fit_for_logs('\n' + body, "\n").c_str();
}

void add_suite(pugi::xml_node& all, const TestSuite& suite) {
  pugi::xml_node node = all.append_child("testsuite");
  set(node, "name", suite.name);
  set_counts(node, {&suite, 1});
  node.append_attribute("skipped") = suite.skipped();
  for (const std::string& error : suite.errors) {
    pugi::xml_node test = add_test(node, suite, error.substr(0, error.find(": ")), 0);
    pugi::xml_node why = test.append_child("error");
    set(why, "message", error);
  }
  for (const TestResult& result : suite.tests) {
    pugi::xml_node test = add_test(node, suite, result.name, result.seconds);
    if (!result.why_skipped.empty()) {
      pugi::xml_node why = test.append_child("skipped");
      set(why, "message", result.why_skipped);
    }
    if (result.failure) add_failure(test, *result.failure);
  }
}

}  // namespace

std::string junit_xml(std::span<const TestSuite> suites) {
  pugi::xml_document document;
  pugi::xml_node all = document.append_child("testsuites");
  set_counts(all, suites);
  for (const TestSuite& suite : suites) add_suite(all, suite);
  std::ostringstream text;
  document.save(text, "");
  return text.str();
}

}  // namespace manifuzz
