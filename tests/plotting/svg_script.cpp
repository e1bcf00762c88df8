/// Tests of the SVG reader that are written as text, in the folder scripts. A step is what stands in a page of 100 x 100 mm
/// whose unit is the millimetre, drawn without fills and with black strokes, with repetitions as of support/mesh_text.hpp.
/// Words before it: "occluded", areas hide what is below them, or "occluded-within", what is below them in their layer;
/// "document TEXT" reads a whole file, "document-72" one whose pixels are those of 72 to the inch, and "file NAME" one of
/// the folder drawings. Checks, where OP is = != < > <= or >=, and numbers are sums of numbers, of quantities and of $NAMES:
///
///     lines 0,0 500,0; 0,900 0,0     all lines that are drawn, in hundredths of a millimetre, in any order; or none
///     shapes 0,0 500,0; ...          those that are no letters
///     has 0,0 500,0; lacks ...       one of them
///     points 1,2 30,40               the points of the only line in mm, to a millionth
///     round X,Y R +- T               all corners lie so near to the circle, and the lines between them within their
///     flatness layers #ff0000; 2 cut          names of the layers in their order; or none colors 1,0,0; 0,0,1 those of the
///     layers paper NAME                     the paper that the page would be at another resolution omits LIST; omitted N
///     KIND     what was left out, as the warning has it, or nothing; how many of one kind refuses TEXT; refuses nothing the
///     error of strict reading, in the second or third line fails TEXT                     the error of any reading keep
///     NAME NUMBER               a number that is $NAME in the rest of the test QUANTITY OP NUMBER [+- T]      count and
///     corners of the lines; mm, their length; page-width, page-height; dpi of the
///                                    paper; assumed, simplified, first-omitted; pen:N, the width of a layer; and of a layer
///                                    left:NAME, right:, top:, bottom:, width:, height:, middle-x:, middle-y:

#include <chrono>

#include "main/script.hpp"
#include "support/mesh_text.hpp"
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

/// Corners on a circle, and lines that leave it by no more than curves may.
void check_round(const ReadDrawing& drawing, std::string_view text) {
  constexpr double kFlatness = 0.0051;
  const std::string middle = take_word(text), radius = take_word(text);
  take_word(text);
  const std::size_t comma = middle.find(',');
  const Point2 at{value_of(middle.substr(0, comma)), value_of(middle.substr(comma + 1))};
  for (const Layer& layer : drawing.drawing.layers) {
    for (const Point2 p : layer.lines.points) EXPECT_NEAR(glm::distance(p, at), value_of(radius), value_of(text));
    for_segments(layer.lines, [&](Point2 a, Point2 b) {
      EXPECT_NEAR(glm::distance((a + b) * 0.5, at), value_of(radius), value_of(text) + kFlatness);
    });
  }
}

class SvgScript {
 public:
  void read(std::string_view body) {
    FillReading fills;
    SvgReading reading;
    fills.occlude = body.starts_with("occluded");
    fills.own_layer = body.starts_with("occluded-within ");
    const bool is_document = body.starts_with("document"), is_file = body.starts_with("file ");
    reading.px_per_inch = body.starts_with("document-72 ") ? 72 : 96;
    if (fills.occlude || is_document || is_file) take_word(body);
    svg_ = is_file       ? bytes_of_file(std::string(LIGNE_SOURCE_DIR "/tests/plotting/drawings/").append(body))
           : is_document ? repeated(unescaped(body))
                         : page(repeated(unescaped(body)));
    error_ = failure_of([&] { drawing_ = read_svg_drawing(svg_, "a.svg", {}, fills, reading); });
  }

  void check(const std::string& check) {
    std::string_view rest = check;
    const std::string verb = take_word(rest), text(rest);
    ASSERT_EQ(error_.empty(), verb != "fails") << error_;
    if (verb == "fails") {
      expect_parts(error_, {text});
    } else if (verb == "lines" || verb == "shapes") {
      const std::vector<std::string> wanted = listed(text);
      EXPECT_EQ(found(verb == "lines"), Lines(wanted.begin(), wanted.end()));
    } else if (verb == "has" || verb == "lacks") {
      EXPECT_EQ(found().contains(text), verb == "has") << testing::PrintToString(found());
    } else if (verb == "points") {
      check_points(drawing_, text);
    } else if (verb == "round") {
      check_round(drawing_, text);
    } else if (verb == "layers" || verb == "colors") {
      std::vector<std::string> each;
      for (const Layer& l : drawing_.drawing.layers) {
        const std::array<double, 3> color = l.color.value_or(std::array{-1.0, -1.0, -1.0});
        each.push_back(verb == "layers" ? l.name : as_text(color[0]) + "," + as_text(color[1]) + "," + as_text(color[2]));
      }
      EXPECT_EQ(each, listed(text));
    } else if (verb == "paper") {
      EXPECT_EQ(drawing_.paper_of_view_box, text == "none" ? "" : text);
    } else if (verb == "omitted") {
      const std::string number = take_word(rest);
      EXPECT_EQ(drawing_.omitted.of(std::string(rest)), std::stoul(number)) << drawing_.omitted.list();
    } else if (verb == "omits") {
      EXPECT_EQ(drawing_.omitted.list(), text == "nothing" ? "" : text);
    } else if (verb == "refuses") {
      check_refusal(svg_, text);
    } else if (verb == "keep") {
      const std::string name = take_word(rest);
      kept_["$" + name] = number(std::string(rest));
    } else {
      const std::string op = take_word(rest);
      const std::size_t sign = rest.find(" +- ");
      const double tolerance = sign == rest.npos ? 1e-9 : number(std::string(rest.substr(sign + 4)));
      const double value = quantity(verb), wanted = number(std::string(rest.substr(0, sign)));
      EXPECT_TRUE(holds(value, op, wanted, tolerance)) << value << ", not " << wanted;
    }
  }

 private:
  Lines found(bool with_letters = true) const {
    ReadDrawing drawing = drawing_;
    if (!with_letters) std::erase_if(drawing.drawing.layers, [](const Layer& layer) { return layer.name == "text"; });
    Lines lines;
    for (const std::string& line : lines_of(drawing)) lines.insert(line.substr(0, line.size() - 1));
    return lines;
  }

  double number(std::string text) const {
    if (text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-:") == text.npos && text != "pi") return quantity(text);
    for (const auto& [name, value] : kept_)
      for (std::size_t at; (at = text.find(name)) != text.npos;) text.replace(at, name.size(), as_text(value));
    return value_of(text);
  }

  double quantity(const std::string& name) const {
    const std::vector<std::string> words = parts_of(name, ':');
    if (words.size() > 1 && words[0] == "pen") return drawing_.drawing.layers.at(std::stoul(words[1])).width_mm.value();
    if (words.size() > 1) return extent(words[0], box_of(drawing_, words[1]));
    double mm = 0, corners = 0;
    for (const Layer& layer : drawing_.drawing.layers) {
      mm += length_of(layer.lines);
      corners += static_cast<double>(layer.lines.points.size());
    }
    const std::map<std::string, double> numbers{{"count", static_cast<double>(found().size())},
                                                {"corners", corners},
                                                {"mm", mm},
                                                {"page-width", drawing_.page.width_mm},
                                                {"page-height", drawing_.page.height_mm},
                                                {"dpi", drawing_.paper_dpi},
                                                {"assumed", drawing_.size_assumed},
                                                {"simplified", static_cast<double>(drawing_.simplified_paints)},
                                                {"first-omitted", static_cast<double>(drawing_.first_omitted_line)}};
    return numbers.at(name);
  }

  static double extent(const std::string& name, const Rect& box) {
    const std::map<std::string, double> numbers{{"left", box.min.x},
                                                {"right", box.max.x},
                                                {"top", box.min.y},
                                                {"bottom", box.max.y},
                                                {"width", box.width()},
                                                {"height", box.height()},
                                                {"middle-x", (box.min.x + box.max.x) / 2},
                                                {"middle-y", (box.min.y + box.max.y) / 2}};
    return numbers.at(name);
  }

  std::string svg_, error_;
  ReadDrawing drawing_;
  std::map<std::string, double> kept_;
};

[[maybe_unused]] const bool scripts_are_added =
    add_scripts(LIGNE_SOURCE_DIR "/tests/plotting/scripts", [](const Script& script) {
      SvgScript svg;
      for (const ScriptStep& step : script.steps) {
        SCOPED_TRACE(step.place + ": " + step.line);
        const auto start = std::chrono::steady_clock::now();
        svg.read(step.line);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
        for (const std::string& check : step.checks) svg.check(check);
      }
    });

}  // namespace
}  // namespace ligne
