/// Functions of texts that the readers of models, tables and formulas are made of: the folder values.

#include "height_tools.hpp"
#include "main/script.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/thinned_heights.hpp"
#include "scene/tables/column_names.hpp"
#include "scene/tables/table.hpp"

namespace ligne {
namespace {

using test::as_text;

std::function<std::string(const std::string&)> cell(const NumberStyle& style) {
  return [style](const std::string& text) -> std::string {
    const CellValue value = cell_value(text, style);
    return value.kind == CellKind::number ? as_text(value.value) : value.kind == CellKind::word ? "word" : "missing";
  };
}

/// The separator, and behind it the signs within numbers: "; 1.000,5".
std::string style_of(const std::string& text) {
  const CellStyle style = cell_style(text);
  const std::string thousands = style.numbers.thousands ? std::string(1, style.numbers.thousands) : "";
  return std::string(1, style.separator) + " 1" + thousands + "000" + (style.numbers.decimal_comma ? ",5" : ".5") +
         (style.doubtful_comma ? " doubtful" : "");
}

/// "COLUMNS ROWS [EVERY]": every so manieth curve is asked for.
std::string thinning(const std::string& text) {
  const std::vector<std::string> words = test::words_of(text);
  const GridChoice choice{{}, words.size() > 2 ? std::optional<unsigned>(std::stoul(words[2])) : std::nullopt, true};
  return std::to_string(thinning_step(std::stoul(words.at(0)), std::stoul(words.at(1)), choice));
}

std::string kept(const std::string& text) {
  std::string places;
  for (const std::size_t place : kept_places(std::stoul(text), std::stoul(text.substr(text.find(' ')))))
    places += (places.empty() ? "" : " ") + std::to_string(place);
  return places;
}

std::string parametric(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ';');
  parametric_points({parts.at(0), parts.at(1), parts.at(2)}, {0, 1}, {0, 1});
  return "read";
}

/// Describes a table: names, lines of rows, blocks, rows at which data sets begin, and what is left out.
std::string table(const std::string& text) {
  Warnings warnings;
  const Table table = read_table(text, "M", warnings);
  std::string all = "names ";
  for (const std::string& name : table.names()) all += "[" + name + "]";
  all += "; lines";
  for (std::size_t row = 0; row < table.rows(); ++row) all += " " + std::to_string(table.line(row));
  all += "; blocks " + std::to_string(table.blocks().size()) + "; sets";
  for (const auto& set : table.data_sets()) all += " " + std::to_string(set.begin);
  if (table.has_unnamed_first()) all += "; first unnamed";
  if (table.column(0).is_text()) all += "; first of text";
  return all + (warnings.left_out().text().empty() ? "" : "; " + warnings.left_out().text());
}

/// "NAME; TABLE": the number of the column of a name.
std::string column(const std::string& text) {
  Warnings warnings;
  const std::size_t end = text.find("; ");
  return std::to_string(column_of(read_table(text.substr(end + 2), "M", warnings), text.substr(0, end), "M"));
}

std::string roles(const std::string& text) {
  const NamedColumns found = named_columns(test::parts_of(text, '|'));
  const auto number = [](const std::optional<std::size_t>& n) { return n ? std::to_string(*n) : "none"; };
  return "x " + number(found.x) + " y " + number(found.y) + " z " + number(found.z) + " label " + number(found.label);
}

std::string positions(const std::string& text) {
  const auto found = positions_in_names(test::words_of(text));
  if (!found) return "none";
  std::string all;
  for (const double position : *found) all += (all.empty() ? "" : " ") + as_text(position);
  return all;
}

std::string precision(const std::string& text) {
  DecimalPrecision precision;
  for (const std::string& word : test::words_of(text)) precision.add(word.c_str(), *number_in(word));
  return as_text(precision.value());
}

const test::TextFunctions kFunctions{
    {"cell", cell({})},
    {"cell-comma", cell({true, '\0'})},
    {"cell-english", cell({false, ','})},
    {"cell-german", cell({true, '.'})},
    {"cell-french", cell({true, ' '})},
    {"cell-swiss", cell({false, '\''})},
    {"style", style_of},
    {"table", table},
    {"column", column},
    {"roles", roles},
    {"positions", positions},
    {"numbered", [](auto& t) { return are_numbered(test::words_of(t)) ? "yes" : "no"; }},
    {"precision", precision},
    {"half-ulp-32", [](auto& t) { return as_text(half_ulp_float32(test::value_of(t))); }},
    {"half-ulp-64", [](auto& t) { return as_text(half_ulp_double(test::value_of(t))); }},
    {"without-comment", [](auto& t) { return std::string(without_comment(t, ',')); }},
    {"cells", [](auto& t) { return std::to_string(cells_of(t, ',').size()); }},
    {"cell-text", [](auto& t) { return std::string(cell_text(t)); }},
    {"thinning", thinning},
    {"kept", kept},
    {"parametric", parametric},
    {"constant", [](auto& t) { return as_text(constant_of(t)); }},
    {"number", [](auto& t) { return as_text(number_in(t).value()); }},
    {"integer", [](auto& t) { return std::to_string(parse_integer(t).value()); }},
};

[[maybe_unused]] const bool values_are_added =
    test::add_function_scripts(LIGNE_SOURCE_DIR "/tests/scene/values", kFunctions);

}  // namespace
}  // namespace ligne
