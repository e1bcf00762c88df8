#include "report/compare_output.hpp"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "files/message_text.hpp"
#include "picture/models/memory.hpp"
#include "plotting/writers/number_text.hpp"
#include "report/scene_info.hpp"

namespace ligne {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> seconds_of(const Statistics& stages, const std::string& name) {
  for (const auto& [known, value] : stages.seconds) {
    if (known == name) return value;
  }
  return {};
}

template <class T>
Json json_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

/// Longest note in the text, in bytes; the JSON has the whole note.
constexpr std::size_t kLongestNote = 300;

/// Length by which a method differs from the reference; none without a reference.
std::optional<double> from_reference(const MethodComparison& comparison, std::size_t i) {
  if (!comparison.reference) return {};
  return comparison.differences_mm[*comparison.reference][i];
}

/// Arranges text in columns, the first aligned left and the others right.
std::string in_columns(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> width;
  for (const auto& row : rows) {
    width.resize(std::max(width.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string one = row[0] + std::string(width[0] - row[0].size(), ' ');
    for (std::size_t c = 1; c < row.size(); ++c) one += "  " + std::string(width[c] - row[c].size(), ' ') + row[c];
    while (one.ends_with(' ')) one.pop_back();
    text += "  " + one + "\n";
  }
  return text;
}

/// The note on a method.
std::string note_of(const MethodOutcome& m) {
  if (!m.drawn()) return m.failure;
  if (!m.unsupported_reason.empty())
    return "only for " + std::string(m.method->traits().only_for) + "; here " + m.unsupported_reason;
  return "";
}

std::string csv_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

Json json_of(const MethodOutcome& m, std::optional<double> differs_mm) {
  const MethodTraits& traits = m.method->traits();
  Json json{{"name", traits.name}, {"exact", traits.exact && m.exact()}, {"penetration", traits.penetration}};
  json["only_for"] = traits.only_for.empty() ? Json(nullptr) : Json(traits.only_for);
  json["drawn"] = m.drawn();
  json["failure"] = m.drawn() ? Json(nullptr) : Json(m.failure);
  json["beyond"] = m.unsupported_reason.empty() ? Json(nullptr) : Json(m.unsupported_reason);
  json["resolution_mm"] = json_or_null(m.resolution_mm);
  json["strokes"] = m.strokes;
  json["visible_mm"] = m.visible_mm;
  json["hidden_mm"] = m.hidden_mm;
  json["differs_mm"] = json_or_null(differs_mm);
  json["longest_difference_mm"] = differs_mm ? Json(m.from_reference.longest_mm) : Json(nullptr);
  json["stages"] = Json::object();
  for (const auto& [name, value] : m.stages.seconds) json["stages"][name] = value;
  json["processor_seconds"] = Json::object();
  for (const auto& [name, value] : m.stages.processor_seconds) json["processor_seconds"][name] = value;
  json["seconds"] = m.seconds();
  json["peak_bytes"] = json_or_null(m.peak_bytes);
  json["thesis_words"] = json_or_null(m.thesis_words);
  json["operations"] = Json::object();
  for (std::size_t k = 0; k < kOperationKinds; ++k) {
    json["operations"][std::string(kOperationNames[k].key)] = json_or_null(m.operations[k]);
  }
  json["counts"] = Json::object();
  for (const auto& [name, n] : m.study.counts) json["counts"][name] = n;
  json["phases"] = Json::object();
  for (const auto& [name, value] : m.study.seconds) json["phases"][name] = value;
  return json;
}

}  // namespace

std::string compare_text(const MethodComparison& comparison) {
  std::string text = "scene\n";
  for (const auto& [name, value] : lines_of(comparison.traits)) {
    constexpr std::size_t kColumn = 15;
    text.append("  ").append(name).append(kColumn - name.size(), ' ').append(value).append("\n");
  }
  text += "  auto           " + comparison.chosen + ": " + comparison.why_chosen + "\n";
  std::vector<std::vector<std::string>> rows{{"method", "strokes", "visible mm", "differs mm", "study", "all", "memory"}};
  std::vector<std::vector<std::string>> operations{{"method"}};
  for (const OperationName& name : kOperationNames) operations[0].emplace_back(name.key);
  std::string notes;
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    const MethodOutcome& m = comparison.methods[i];
    const std::string name(m.method->traits().name);
    if (const std::string note = note_of(m); !note.empty())
      notes += "  " + name + ": " + printable(note, kLongestNote) + "\n";
    if (m.resolution_mm) notes += "  " + name + ": limited to " + fixed(*m.resolution_mm, 3) + " mm by its resolution\n";
    if (!m.drawn()) {
      rows.push_back({name, "-"});
      continue;
    }
    const auto differs = from_reference(comparison, i);
    const auto study = seconds_of(m.stages, "study");
    rows.push_back({name, std::to_string(m.strokes), fixed(m.visible_mm, 3), differs ? fixed(*differs, 3) : "-",
                    study ? duration(*study) : "-", duration(m.seconds()), m.peak_bytes ? bytes_text(*m.peak_bytes) : "-"});
    operations.push_back({name});
    for (const auto& n : m.operations) operations.back().push_back(n ? std::to_string(*n) : "-");
  }
  text += "methods\n" + in_columns(rows) + "operations\n" + in_columns(operations);
  return text + (notes.empty() ? "" : "notes\n" + notes);
}

std::string compare_csv(const MethodComparison& comparison) {
  std::string text =
      "method,exact,drawn,note,resolution_mm,strokes,visible_mm,hidden_mm,differs_mm,longest_difference_mm,study_s,"
      "all_s,peak_bytes,thesis_words";
  for (const OperationName& name : kOperationNames) text += "," + std::string(name.key);
  text += "\n";
  const auto add = [&](const std::string& value) { text += "," + value; };
  const auto number = [&](const std::optional<double>& value) { add(value ? shortest(*value) : ""); };
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    const MethodOutcome& m = comparison.methods[i];
    const auto differs = from_reference(comparison, i);
    text += m.method->traits().name;
    add(m.method->traits().exact && m.exact() ? "yes" : "no");
    add(m.drawn() ? "yes" : "no");
    add(csv_text(note_of(m)));
    number(m.resolution_mm);
    add(std::to_string(m.strokes));
    number(m.visible_mm);
    number(m.hidden_mm);
    number(differs);
    number(differs ? std::optional(m.from_reference.longest_mm) : std::nullopt);
    number(seconds_of(m.stages, "study"));
    number(m.seconds());
    number(m.peak_bytes);
    add(m.thesis_words ? std::to_string(*m.thesis_words) : "");
    for (const auto& n : m.operations) add(n ? std::to_string(*n) : "");
    text += "\n";
  }
  return text;
}

std::string compare_json(const MethodComparison& comparison, const std::vector<std::string>& files) {
  Json json{{"format", "ligne-compare"}, {"version", 1}};
  json["files"] = files;
  json["page_mm"] = {comparison.page.width_mm, comparison.page.height_mm};
  json["traits"] = json_of(comparison.traits);
  json["auto"] = {{"method", comparison.chosen}, {"rule", comparison.why_chosen}};
  json["reference"] =
      comparison.reference ? Json(comparison.methods[*comparison.reference].method->traits().name) : Json(nullptr);
  json["methods"] = Json::array();
  for (std::size_t i = 0; i < comparison.methods.size(); ++i) {
    json["methods"].push_back(json_of(comparison.methods[i], from_reference(comparison, i)));
  }
  json["differences_mm"] = Json::array();
  for (const auto& row : comparison.differences_mm) {
    Json list = Json::array();
    for (const auto& value : row) list.push_back(json_or_null(value));
    json["differences_mm"].push_back(std::move(list));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ligne
