// The arrays of a JSON document: rows of numbers; an object whose members are arrays, such as a trace of plotly;
// columns; or records. An object with "data" is a figure, or a table of pandas.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

#include "files/message_text.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/tables/cell_value.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {
namespace {

using Json = nlohmann::json;
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Largest number of cells per member of a list of records: records may lack members, but memory must stay bounded.
constexpr std::size_t kMostCellsPerMember = 100;

/// Replaces NaN and Infinity, which Python writes and JSON does not know, by null.
std::string with_nulls(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\' && i + 1 < text.size()) {
      out += {c, text[++i]};
      continue;
    }
    if (c == '"') in_string = !in_string;
    bool is_word = false;
    for (const std::string_view word : {"NaN", "-Infinity", "Infinity", "-NaN"}) {
      if (in_string || is_word || (c != word[0]) || !text.substr(i).starts_with(word)) continue;
      out += "null";
      i += word.size() - 1;
      is_word = true;
    }
    if (!is_word) out += c;
  }
  return out;
}

/// A number, NaN for a missing one, or nothing for words.
std::optional<double> number_of(const Json& value) {
  if (value.is_number()) {
    const auto number = value.get<double>();
    return std::isfinite(number) ? number : kMissing;
  }
  if (value.is_null()) return kMissing;
  if (!value.is_string()) return {};
  const CellValue cell = cell_value(value.get_ref<const std::string&>(), {});
  return cell.kind == CellKind::word ? std::nullopt : std::optional(cell.value);
}

class JsonArrays {
 public:
  JsonArrays(const std::string& name, Warnings& warnings, std::vector<TextColumn>* texts)
      : name_(name), warnings_(warnings), texts_(texts) {}

  std::vector<DataArray> read(const Json& document) {
    const Json* root = &document;
    if (is_geojson(document)) {
      throw InputError(name_, "is GeoJSON, which is not read: ogr2ogr -f CSV OUT.csv IN -lco GEOMETRY=AS_XYZ");
    }
    if (root->is_object() && root->contains("data")) root = data_of(*root);
    if (root->is_object()) take_object(*root);
    if (root->is_array()) take_list(*root);
    if (arrays_.empty())
      throw InputError(name_,
                       "is JSON without an array of numbers: [[...], [...]], or {\"x\": [...], \"y\": [...], \"z\": [...]}");
    return std::move(arrays_);
  }

 private:
  static bool is_geojson(const Json& document) {
    return document.is_object() && document.contains("features") && document.contains("type");
  }

  /// The trace of a figure, or the object itself. Tables of pandas are added at once.
  const Json* data_of(const Json& root) {
    const Json& data = root["data"];
    if (root.contains("columns") && root["columns"].is_array() && data.is_array()) {
      take_rows(data, root["columns"]);
      static const Json nothing;
      return &nothing;
    }
    if (!data.is_array() || data.empty() || !data[0].is_object()) return data.is_structured() ? &data : &root;
    const auto has_heights = [](const Json& trace) { return trace.is_object() && trace.contains("z"); };
    const auto first = std::find_if(data.begin(), data.end(), has_heights);
    if (first == data.end()) return &data;
    const auto others = data.size() - 1;
    warnings_.leave_out(others == 1 ? "trace" : "traces", others);
    return &*first;
  }

  void take_object(const Json& object) {
    for (const auto& [key, value] : object.items()) {
      if (value.is_array()) {
        if (!add_array(key, value)) add_texts(key, {value.begin(), value.end()});
      } else if (value.is_object()) {
        add_column_of_object(key, value);
      }
    }
  }

  void left_out(const std::string& key) { warnings_.leave_out("member (" + printable(key) + ")"); }

  void take_list(const Json& list) {
    if (list.empty()) return;
    if (!list[0].is_object()) {
      if (!add_array("", list)) throw InputError(name_, "is a JSON list, but not of rows of numbers of equal length");
      return;
    }
    take_records(list);
  }

  /// Adds a list of records: [{"x": 1, "y": 2, "z": 3}, ...]
  void take_records(const Json& list) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : list[0].items()) keys.push_back(key);
    std::size_t members = 0;
    for (const Json& record : list) members += record.is_object() ? record.size() : 0;
    if (keys.size() * list.size() > kMostCellsPerMember * (members + list.size()))
      throw InputError(name_, "is a JSON list of records in which most members are missing");
    for (const std::string& key : keys) {
      std::vector<Json> cells;
      for (const Json& record : list) {
        if (!record.is_object()) throw InputError(name_, "is a JSON list that mixes records with other values");
        const auto found = record.find(key);
        cells.push_back(found == record.end() ? Json() : *found);
      }
      add_column(key, cells);
    }
  }

  /// Adds rows of cells with the names of their columns.
  void take_rows(const Json& rows, const Json& names) {
    for (std::size_t k = 0; k < names.size(); ++k) {
      std::vector<Json> cells;
      for (const Json& row : rows) {
        if (!row.is_array() || row.size() != names.size())
          throw InputError(name_, "is a JSON table whose rows and columns differ in length");
        cells.push_back(row[k]);
      }
      add_column(names[k].is_string() ? names[k].get<std::string>() : names[k].dump(), cells);
    }
  }

  /// Adds a column of numbers, or of words if a cell is one.
  void add_column(const std::string& key, const std::vector<Json>& cells) {
    DataArray column{key, {cells.size()}, {}};
    for (const Json& cell : cells) {
      const std::optional<double> value = number_of(cell);
      if (!value) return add_texts(key, cells);
      column.values.push_back(*value);
    }
    arrays_.push_back(std::move(column));
  }

  void add_texts(const std::string& key, const std::vector<Json>& cells) {
    if (!texts_) return left_out(key);
    TextColumn column{key, {}};
    for (const Json& cell : cells) {
      if (cell.is_structured()) return left_out(key);
      column.cells.push_back(cell.is_string() ? cell.get<std::string>() : cell.is_null() ? std::string() : cell.dump());
    }
    texts_->push_back(std::move(column));
  }

  /// Adds a column as pandas writes it: {"0": 1.5, "1": 2.5}
  void add_column_of_object(const std::string& key, const Json& object) {
    // The members are sorted as text: "10" comes before "2".
    std::vector<std::pair<double, const Json*>> rows;
    for (const auto& [row, cell] : object.items()) {
      const std::optional<double> number = number_in(row);
      if (!number) return left_out(key);
      rows.emplace_back(*number, &cell);
    }
    std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Json> cells;
    cells.reserve(rows.size());
    for (const auto& [row, cell] : rows) cells.push_back(*cell);
    if (!cells.empty()) add_column(key, cells);
  }

  /// Adds an array. False unless the list holds numbers or lists of equally many numbers.
  bool add_array(const std::string& key, const Json& list) {
    DataArray array{key, {list.size()}, {}};
    if (list.empty()) return false;
    if (list[0].is_array()) array.shape.push_back(list[0].size());
    for (const Json& row : list) {
      if (row.is_array() != (array.shape.size() == 2)) return false;
      if (row.is_array() && row.size() != array.shape[1]) {
        throw InputError(
            name_, "has rows of " + std::to_string(array.shape[1]) + " and of " + std::to_string(row.size()) + " numbers");
      }
      if (!row.is_array() && !add_value(row, array)) return false;
      if (!row.is_array()) continue;
      for (const Json& value : row) {
        if (!add_value(value, array)) return false;
      }
    }
    arrays_.push_back(std::move(array));
    return true;
  }

  static bool add_value(const Json& value, DataArray& array) {
    const std::optional<double> number = number_of(value);
    if (number) array.values.push_back(*number);
    return number.has_value();
  }

  const std::string& name_;
  Warnings& warnings_;
  std::vector<TextColumn>* texts_;
  std::vector<DataArray> arrays_;
};

}  // namespace

bool may_be_json(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  constexpr char kBlanks[] = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos || text[begin] != '[') return begin != std::string_view::npos && text[begin] == '{';
  const std::size_t next = text.find_first_of("[]{\"-0123456789nNI", begin + 1);  // no section of settings
  return next != std::string_view::npos && next == text.find_first_not_of(kBlanks, begin + 1);
}

std::vector<DataArray> read_json_arrays(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                        std::vector<TextColumn>* texts) {
  const std::string text = with_nulls(as_text(bytes, name));
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::parse_error& error) {
    if (text.find_first_of("\":") == std::string::npos) return read_text_arrays(text, name);
    const std::string_view before = std::string_view(text).substr(0, std::max<std::size_t>(error.byte, 1) - 1);
    throw error_at_line(
        name, 1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
        "JSON: byte " + std::to_string(before.size() - (before.rfind('\n') + 1) + 1) + " of the line is unexpected");
  } catch (const Json::exception& error) {
    throw InputError(name, std::string("JSON: ") + error.what());
  }
  return JsonArrays(name, warnings, texts).read(document);
}

}  // namespace ligne
