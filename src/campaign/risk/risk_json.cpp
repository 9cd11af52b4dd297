#include "campaign/risk/risk_json.hpp"

#include "campaign/risk/risk.hpp"

namespace manifuzz {
namespace {

using Json = nlohmann::ordered_json;

void add_unseen(const UnseenRisk& risk, Json& to) {
  to["once"] = risk.once;
  to["next"] = risk.next;
  to["low"] = risk.low;
  to["high"] = risk.high;
}

Json json_of(const RiskRow& row) {
  Json json{{"regime", row.regime}, {"cases", row.cases}};
  add_unseen(row.any, json);
  json["wrong"] = Json::object();
  add_unseen(row.wrong, json["wrong"]);
  return json;
}

void check_unseen(const JsonView& risk) {
  risk.at("once").whole_number();
  for (const char* const figure : {"next", "low", "high"}) risk.at(figure).magnitude();
}

void check_row(const JsonView& row) {
  row.at("regime").string();
  row.at("cases").whole_number();
  check_unseen(row);
  check_unseen(row.at("wrong"));
}

}  // namespace

void add_risk(const CampaignResult& result, Json& json) {
  if (!result.risk_error) return;
  json["risk"] = Json::array();
  for (const RiskRow& row : risk_of(result)) json["risk"].push_back(json_of(row));
  json["risk_error"] = *result.risk_error;
  if (!result.ended_by.empty()) json["ended_by"] = result.ended_by;
}

void read_risk(const JsonView& root, CampaignResult& result) {
  result.ended_by = root.string_or("ended_by", "");
  const auto rows = root.find("risk");
  if (!rows) return;
  for (const JsonView& row : rows->elements()) check_row(row);
  const JsonView error = root.at("risk_error");
  const double value = error.magnitude();
  if (value > 1) error.fail("is no chance; at most 1 is expected");
  result.risk_error = value;
}

}  // namespace manifuzz
