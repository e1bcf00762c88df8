#include "picture/run_report.hpp"

#include <algorithm>

#include "files/message_text.hpp"

namespace ligne {
namespace {

std::string line(const std::string& name, std::size_t width, const std::string& value) {
  return "  " + name + std::string(width - name.size() + 2, ' ') + value + "\n";
}

}  // namespace

std::string report_text(const RunReport& report) {
  std::size_t width = 0;
  for (const auto& [name, value] : report.study.counts) width = std::max(width, name.size());
  for (const auto& [name, value] : report.study.seconds) width = std::max(width, name.size());
  for (const auto& [name, value] : report.clear.counts) width = std::max(width, name.size());
  for (const auto& [name, value] : report.stages.seconds) width = std::max(width, name.size());

  for (const auto& [name, value] : report.choices) width = std::max(width, name.size());

  std::string text;
  if (!report.method.empty()) text += "method " + report.method + "\n";
  for (const auto& [name, value] : report.choices) text += line(name, width, value);
  for (const auto& [name, value] : report.study.counts) text += line(name, width, std::to_string(value));
  for (const auto& [name, value] : report.study.seconds) text += line(name, width, duration(value));
  if (!report.clear.counts.empty()) text += "clear lines\n";
  for (const auto& [name, value] : report.clear.counts) text += line(name, width, std::to_string(value));
  text += "stages\n";
  double total = 0;
  for (const auto& [name, value] : report.stages.seconds) {
    text += line(name, width, duration(value));
    total += value;
  }
  return text + line("total", std::max<std::size_t>(width, 5), duration(total));
}

}  // namespace ligne
