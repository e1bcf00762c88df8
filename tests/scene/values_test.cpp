/// Functions of texts that the readers of models, tables and formulas are made of: the folder values.

#include "height_tools.hpp"
#include "main/script.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/thinned_heights.hpp"
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

const test::TextFunctions kFunctions{
    {"cell", cell({})},
    {"cell-comma", cell({true, '\0'})},
    {"cell-english", cell({false, ','})},
    {"cell-german", cell({true, '.'})},
    {"cell-french", cell({true, ' '})},
    {"cell-swiss", cell({false, '\''})},
    {"style", style_of},
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
