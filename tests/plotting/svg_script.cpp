/// Tests of the SVG reader that are written as text, in the folder scripts. A step is what stands in a page of 100 x 100 mm
/// whose unit is the millimetre, drawn without fills and with black strokes; "occluded BODY" reads it so that areas hide
/// what is below them, and "document TEXT" reads a whole file. Checks:
///
///     lines 0,0 500,0; 0,900 0,0     all lines that are drawn, in hundredths of a millimetre, in any order; or none
///     has 0,0 500,0; lacks ...       one of them
///     count OP N                     their number
///     points 1,2 30,40               the points of the only line in mm, to a millionth
///     layers #ff0000; 2 cut          names of the layers in their order; or none
///     omits LIST; omitted N KIND     what was left out, as the warning has it, or nothing; how many of one kind
///     refuses TEXT; refuses nothing  the error of strict reading, in the second or third line

#include "main/script.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

std::vector<std::string> listed(const std::string& text) {
  if (text == "none" || text == "nothing") return {};
  std::vector<std::string> parts = parts_of(text, ';');
  for (std::string& part : parts) part.erase(0, part.find_first_not_of(' '));
  return parts;
}

void check_points(const ReadDrawing& drawing, const std::string& text) {
  ASSERT_TRUE(drawing.drawing.layers.size() == 1 && drawing.drawing.layers[0].lines.size() == 1) << "not one line";
  const auto line = drawing.drawing.layers[0].lines[0];
  const std::vector<std::string> wanted = words_of(text);
  ASSERT_EQ(line.size(), wanted.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::size_t comma = wanted[i].find(',');
    const Point2 p{value_of(wanted[i].substr(0, comma)), value_of(wanted[i].substr(comma + 1))};
    EXPECT_NEAR(glm::distance(line[i], p), 0, 1e-9) << "point " << i;
  }
}

void check_refusal(const std::string& svg, const std::string& text) {
  const std::string error = error_of(svg);
  if (text == "nothing") {
    EXPECT_EQ(error, "");
    return;
  }
  expect_parts(error, {text});
  EXPECT_TRUE(error.starts_with("a.svg:2: ") || error.starts_with("a.svg:3: ")) << error;
}

void do_check(const ReadDrawing& drawing, const std::string& svg, const std::string& check) {
  std::string_view rest = check;
  const std::string verb = take_word(rest), text(rest);
  Lines found;
  for (const std::string& line : lines_of(drawing)) found.insert(line.substr(0, line.size() - 1));
  if (verb == "lines") {
    const std::vector<std::string> wanted = listed(text);
    EXPECT_EQ(found, Lines(wanted.begin(), wanted.end()));
  } else if (verb == "has" || verb == "lacks") {
    EXPECT_EQ(found.contains(text), verb == "has") << testing::PrintToString(found);
  } else if (verb == "count") {
    const std::string op = take_word(rest);
    EXPECT_TRUE(holds(static_cast<double>(found.size()), op, value_of(rest), 0)) << testing::PrintToString(found);
  } else if (verb == "points") {
    check_points(drawing, text);
  } else if (verb == "layers") {
    std::vector<std::string> names;
    for (const Layer& layer : drawing.drawing.layers) names.push_back(layer.name);
    EXPECT_EQ(names, listed(text));
  } else if (verb == "omitted") {
    const std::string number = take_word(rest);
    EXPECT_EQ(drawing.omitted.of(std::string(rest)), std::stoul(number)) << drawing.omitted.list();
  } else if (verb == "omits") {
    EXPECT_EQ(drawing.omitted.list(), text == "nothing" ? "" : text);
  } else if (verb == "refuses") {
    check_refusal(svg, text);
  } else {
    ADD_FAILURE() << "no check: " << verb;
  }
}

[[maybe_unused]] const bool scripts_are_added =
    add_scripts(LIGNE_SOURCE_DIR "/tests/plotting/scripts", [](const Script& script) {
      for (const ScriptStep& step : script.steps) {
        SCOPED_TRACE(step.place + ": " + step.line);
        std::string_view body = step.line;
        const bool is_occluded = body.starts_with("occluded "), is_document = body.starts_with("document ");
        if (is_occluded || is_document) take_word(body);
        const std::string svg = is_document ? unescaped(body) : page(unescaped(body));
        FillReading fills;
        fills.occlude = is_occluded;
        const ReadDrawing drawing = read_svg_drawing(svg, "a.svg", {}, fills);
        for (const std::string& check : step.checks) do_check(drawing, svg, check);
      }
    });

}  // namespace
}  // namespace ligne
