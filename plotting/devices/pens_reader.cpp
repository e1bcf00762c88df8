#include <algorithm>

#include "files/message_text.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/devices/toml_reading.hpp"

namespace ligne {
namespace {

constexpr double kWidestPenMm = 50;

Pen read_pen(const TomlTable& table) {
  Pen pen;
  const auto number = table.count("number", 1, kMostPens);
  if (!number) table.fail("a pen has no number");
  pen.number = *number;
  pen.name = table.text("name").value_or("");
  // The name becomes part of a comment in G-code and of a layer's name.
  if (std::any_of(pen.name.begin(), pen.name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) {
    table.fail("name has control characters", table.find("name"));
  }
  if (const auto color = table.text("color")) {
    try {
      pen.color = parse_color(*color);
    } catch (const std::invalid_argument& e) {
      table.fail(e.what(), table.find("color"));
    }
  }
  if (const auto width = table.number("width")) {
    if (!(*width > 0 && *width <= kWidestPenMm)) table.fail("width is not above 0 and at most 50 mm", table.find("width"));
    pen.width_mm = *width;
  }
  pen.skip = table.flag("skip").value_or(false);
  pen.pause = table.flag("pause").value_or(false);
  pen.speed = table.count("speed", 1, kMostPercent);
  pen.height = table.count("height", 0, kMostPercent);
  pen.delay_ms = table.count("delay", 0, kMostDelayMs);
  return pen;
}

}  // namespace

PenTable read_pens(std::string_view toml, const std::string& name) {
  const toml::table file = parse_toml(toml, name);
  const TomlTable root(file, name);
  root.only({"pen"});
  PenTable result;
  for (const TomlTable& table : root.tables("pen")) {
    table.only({"number", "name", "color", "width", "skip", "pause", "speed", "height", "delay", "classes", "objects",
                "materials", "shades", "rest"});
    const Pen pen = read_pen(table);
    if (!result.pens.emplace(pen.number, pen).second) table.fail("pen " + std::to_string(pen.number) + " is given twice");
    const auto assign = [&](std::string_view key, auto& target) {
      for (const std::string& layer : table.texts(key)) {
        if (!target.emplace(layer, pen.number).second) table.fail(printable(layer) + " has two pens", table.find(key));
      }
    };
    assign("classes", result.pen_of_layer);
    assign("materials", result.pen_of_material);
    for (const std::string& object : table.texts("objects")) result.pen_of_object.emplace_back(object, pen.number);
    for (const unsigned shade : table.counts("shades", 1, kMostPenShades)) {
      if (!result.pen_of_shade.emplace(shade, pen.number).second)
        table.fail("shade " + std::to_string(shade) + " has two pens", table.find("shades"));
    }
    if (table.flag("rest").value_or(false)) {
      result.rest = pen.number;
      result.names_rest = true;
    }
  }
  if (result.empty()) root.fail("there is no [[pen]]");
  return result;
}

}  // namespace ligne
