#include "report/page/page.hpp"

#include <array>

#include "report/page/page_case.hpp"
#include "report/page/page_source.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kResultKinds{"fuzz", "replay", "bench", "stress", "scene"};

Json sources_json(const Page& page) {
  Json sources = Json::array();
  for (const ResultFile& result : page.results) {
    sources.push_back({{"path", result.path}, {"kind", result.kind}, {"cases", nullptr}});
  }
  if (page.cases.empty()) return sources;
  sources.push_back({{"path", "cases"}, {"kind", "cases"}, {"cases", page.cases.size()}});
  return sources;
}

Json data_of(const Page& page) {
  Json data{{"format", "manifuzz/report/1"},
            {"version", MANIFUZZ_VERSION},
            {"command", page.command},
            {"sources", sources_json(page)},
            {"errors", page.errors}};
  for (const char* const kind : kResultKinds) {
    Json results = Json::array();
    for (const ResultFile& result : page.results) {
      if (result.kind == kind) {
        results.push_back({{"path", result.path}, {"result", result.json}});
      }
    }
    data[kind] = results;
  }
  data["cases"] = Json::array();
  for (const PageCase& page_case : page.cases) data["cases"].push_back(page_case_json(page_case));
  return data;
}

/// JSON as the text of a script element, which no `<` may end.
std::string script_text(const Json& json) {
  // Paths and words from outside need not be UTF-8.
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

struct Filling {
  std::string_view place;  ///< in the template
  std::string_view text;
};

/// The template with each place filled; what is filled in is not searched for places.
std::string filled(std::string_view rest, std::span<const Filling> fillings) {
  std::string out;
  for (const Filling& filling : fillings) {
    const std::size_t at = rest.find(filling.place);
    out.append(rest.substr(0, at)).append(filling.text);
    rest.remove_prefix(at + filling.place.size());
  }
  return out.append(rest);
}

}  // namespace

std::string page_html(const Page& page) {
  const std::string data = script_text(data_of(page));
  const std::array fillings{Filling{"@style@", kPageStyle}, Filling{"@data@", data},
                            Filling{"@script@", kPageScript}};
  return filled(kPageTemplate, fillings);
}

}  // namespace manifuzz
