#include "report/run_json.hpp"

#include <nlohmann/json.hpp>

namespace ligne {

std::string report_json(const RunReport& report) {
  nlohmann::ordered_json json;
  json["format"] = "ligne-stats";
  json["version"] = 1;
  json["method"] = report.method;
  json["counts"] = nlohmann::ordered_json::object();
  json["seconds"] = nlohmann::ordered_json::object();
  json["stages"] = nlohmann::ordered_json::object();
  json["processor_seconds"] = nlohmann::ordered_json::object();
  for (const auto& [name, value] : report.choices) json["choices"][name] = value;
  for (const auto& [name, value] : report.study.counts) json["counts"][name] = value;
  for (const auto& [name, value] : report.study.seconds) json["seconds"][name] = value;
  for (const auto& [name, value] : report.clear.counts) json["clear"][name] = value;
  for (const auto& [name, value] : report.stages.seconds) json["stages"][name] = value;
  for (const auto& [name, value] : report.stages.processor_seconds) json["processor_seconds"][name] = value;
  return json.dump(2) + "\n";
}

}  // namespace ligne
