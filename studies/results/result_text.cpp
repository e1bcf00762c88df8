#include "studies/results/result_text.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace ligne::studies {
namespace {

/// Three significant digits: measurements are no more precise.
std::string shown(double v) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", v);
  return buffer;
}

std::string shown(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::uint64_t>(&cell)) return std::to_string(*count);
  if (const auto* value = std::get_if<double>(&cell)) return shown(*value);
  return "";
}

std::string row_label(const Table& table, const std::vector<Cell>& row) {
  std::string label;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (table.columns[i].kind == ColumnKind::label) label += (label.empty() ? "" : ", ") + shown(row[i]);
  }
  return label;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

template <class Names, class Value>
std::string name_of(const Names& names, Value value) {
  return std::string(names[static_cast<std::size_t>(value)]);
}

nlohmann::ordered_json json_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::uint64_t>(&cell)) return *count;
  if (const auto* value = std::get_if<double>(&cell)) return *value;
  return nullptr;
}

nlohmann::ordered_json json_of(const Table& table) {
  nlohmann::ordered_json json{{"title", table.title}, {"columns", nlohmann::ordered_json::array()}};
  for (const Column& c : table.columns)
    json["columns"].push_back({{"name", c.name}, {"kind", name_of(kColumnKindNames, c.kind)}});
  json["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json cells = nlohmann::ordered_json::array();
    for (const Cell& cell : row) cells.push_back(json_of(cell));
    json["rows"].push_back(std::move(cells));
  }
  return json;
}

}  // namespace

std::string text_of(const Outcome& outcome) {
  const auto& [experiment, result] = outcome;
  std::string text = "## " + std::string(experiment->name) + ": " + std::string(experiment->title) + " (" +
                     std::string(experiment->section) + ")\n";
  for (const Table& table : result.tables) {
    text += "\n" + table.title + "\n\n|";
    for (const Column& c : table.columns) text += " " + c.name + " |";
    text += "\n|";
    for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
    for (const auto& row : table.rows) {
      text += "\n|";
      for (const Cell& cell : row) text += " " + shown(cell) + " |";
    }
    text += "\n";
  }
  return text + "\nThe finding " + name_of(kFindingNames, result.finding) + ". " + result.sentence + "\n";
}

std::string csv_of(std::span<const Outcome> outcomes) {
  std::string text = "experiment,table,row,column,kind,value\n";
  for (const auto& [experiment, result] : outcomes) {
    for (const Table& table : result.tables) {
      for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
          const Column& column = table.columns[i];
          if (column.kind == ColumnKind::label || std::holds_alternative<std::monostate>(row[i])) continue;
          text += std::string(experiment->name) + "," + quoted(table.title) + "," + quoted(row_label(table, row)) + "," +
                  quoted(column.name) + "," + name_of(kColumnKindNames, column.kind) + "," + quoted(shown(row[i])) + "\n";
        }
      }
    }
  }
  return text;
}

std::string json_of(std::span<const Outcome> outcomes, StudySize size) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [experiment, result] : outcomes) {
    nlohmann::ordered_json tables = nlohmann::ordered_json::array();
    for (const Table& table : result.tables) tables.push_back(json_of(table));
    list.push_back({{"name", experiment->name},
                    {"section", experiment->section},
                    {"title", experiment->title},
                    {"tables", std::move(tables)},
                    {"finding", name_of(kFindingNames, result.finding)},
                    {"sentence", result.sentence}});
  }
  return nlohmann::ordered_json{{"format", "ligne-study"},
                                {"version", 1},
                                {"size", name_of(kStudySizeNames, size)},
                                {"experiments", std::move(list)}}
             .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

std::string list_of_experiments() {
  std::string text;
  for (const Experiment& e : experiments()) {
    std::string name(e.name);
    name.resize(std::max<std::size_t>(name.size() + 1, 18), ' ');
    text += name + std::string(e.section) + ": " + std::string(e.title) + "\n";
  }
  return text;
}

}  // namespace ligne::studies
