/// Device files: numbers within their bounds, and nothing in braces that would reach the machine.

#include <gtest/gtest.h>

#include <cmath>

#include "plotting/device.hpp"
#include "plotting/plot.hpp"
#include "plotting/plot_writers.hpp"

namespace ligne {
namespace {

/// A right file with one key given another value, or added.
std::string device_with(const std::string& language, const std::string& key, const std::string& value) {
  const bool hpgl = language == "hpgl";
  std::vector<std::pair<std::string, std::string>> keys{{"name", "\"own\""},
                                                        {"title", "\"Own\""},
                                                        {"language", "\"" + language + "\""},
                                                        {"step", "0.025"},
                                                        {"limits", "[0, 0, 500, 500]"},
                                                        {"travel", hpgl ? "\"U{x},{y};\"" : "\"G0 X{x} Y{y}\""},
                                                        {"draw", hpgl ? "\"D{points};\"" : "\"G1 X{x} Y{y}\""},
                                                        {"dot", "\"D;\""},
                                                        {"speed_down", "10"},
                                                        {"speed_up", "20"},
                                                        {"lift_seconds", "0.5"},
                                                        {"pen_change_seconds", "30"}};
  bool found = false;
  std::string text;
  for (auto& [name, own] : keys) {
    if (name == key) own = value, found = true;
    text += name + " = " + own + "\n";
  }
  return found || key.empty() ? text : text + key + " = " + value + "\n";
}

std::string device_error(const std::string& toml) {
  try {
    read_device(toml, "F");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(DeviceFile, SpeedsAndTimesHaveBounds) {
  const struct {
    const char *key, *least, *most;
    std::vector<const char*> bad;
    const char* range;
  } cases[] = {
      {"speed_down", "0.01", "10000", {"0", "-1", "0.009", "10001", "1e-300", "1e300", "inf", "-inf"}, "0.01 to 10000 mm/s"},
      {"speed_up", "0.01", "10000", {"0", "-1", "0.009", "10001", "1e-300", "1e300", "inf", "-inf"}, "0.01 to 10000 mm/s"},
      {"lift_seconds", "0", "600", {"-0.1", "601", "1e300", "inf"}, "0 to 600 s"},
      {"pen_change_seconds", "0", "86400", {"-0.1", "86401", "1e300", "inf"}, "0 to 86400 s"}};
  for (const auto& c : cases) {
    for (const char* good : {c.least, c.most})
      EXPECT_EQ(device_error(device_with("hpgl", c.key, good)), "no error") << c.key;
    for (const char* bad : c.bad) {
      const std::string line = device_error(device_with("hpgl", c.key, bad));
      EXPECT_TRUE(line.ends_with(std::string(": ") + c.key + " is not from " + c.range)) << bad << ": " << line;
    }
    EXPECT_TRUE(device_error(device_with("hpgl", c.key, "nan")).ends_with(" is not a number"));
  }
}

TEST(DeviceFile, NoTimeWithinTheBoundsOverflows) {
  Device device = read_device(device_with("hpgl", "speed_down", "0.01"), "F");
  device.up_mm_s = 0.01;
  device.lift_s = 600;
  device.pen_change_s = 86400;
  const std::size_t strokes = std::size_t{1} << 32;
  const double farthest = static_cast<double>(strokes) * 2e6 * std::sqrt(2);
  EXPECT_LT(plot_seconds(device, {strokes, farthest, farthest}, 1000), 9e18);
}

TEST(DeviceFile, PapersHaveBounds) {
  const auto with_paper = [](const std::string& paper) {
    std::string text = device_with("hpgl", "", "");
    text.erase(text.find("limits"), text.find('\n', text.find("limits")) + 1 - text.find("limits"));
    return device_error(text + "[[paper]]\nname = \"p\"\n" + paper);
  };
  EXPECT_EQ(with_paper("width = 210\nheight = 297\nlimits = [0, 0, 1, 1]\n"), "no error");
  EXPECT_NE(with_paper("width = 1e300\nheight = 297\nlimits = [0, 0, 1, 1]\n").find("at most 100000 mm"), std::string::npos);
  EXPECT_NE(with_paper("width = 210\nheight = 297\nlimits = [0, 0, 1e300, 1]\n").find("1e10 units"), std::string::npos);
  EXPECT_NE(
      with_paper("width = 210\nheight = 297\nlimits = [0, 0, 1, 1]\norigin = [inf, 0]\n").find("the origin is farther"),
      std::string::npos);
  EXPECT_NE(with_paper("width = 210\nheight = 297\nlimits = [0, 0, 1, 1]\nselect = \"PS{x};\"\n").find("select: {x} is not"),
            std::string::npos);
}

TEST(DeviceFile, WhatIsNotKnownInBracesIsAnErrorThatListsWhatIs) {
  const auto error = [](const char* key, const char* value, const char* language = "hpgl") {
    const std::string line = device_error(device_with(language, key, value));
    const std::size_t cause = line.find(": ");
    return cause == std::string::npos ? line : line.substr(cause + 2);
  };
  EXPECT_EQ(error("travel", "\"U{x},{y}{nonsense};\""), "travel: {nonsense} is not known here; there is {x}, {y}");
  EXPECT_EQ(error("draw", "\"D{points}{x};\""), "draw: {x} is not known here; there is {points}");
  EXPECT_EQ(error("draw", "\"G1 X{x} Y{y} F{speed}\"", "gcode"),
            "draw: {speed} is not known here; there is {x}, {y}, {feed}");
  EXPECT_EQ(error("begin", "[\"IN;\", \"{Paper}\"]"), "begin: {Paper} is not known here; there is {paper}");
  EXPECT_EQ(error("up", "[\"{x}\"]"), "up: {x} is not known here; there is nothing in braces");
  EXPECT_EQ(error("velocity", "\"VS{cm_per_s\""), "velocity: {cm_per_s is not known here; there is {cm_per_s}");
  EXPECT_EQ(error("dot", "\"{}\""), "dot: {} is not known here; there is nothing in braces");
  EXPECT_EQ(error("pen_select", "\"SP{pen};PW{width},{pen};\""), "no error");
}

/// What the reader lets pass the writer replaces.
TEST(DeviceFile, EveryKnownPlaceholderIsReplaced) {
  for (const std::string language : {"hpgl", "gcode"}) {
    const bool hpgl = language == "hpgl";
    std::string text = device_with(language, "travel", "\"a{x}{y}\"");
    text.erase(text.find("draw"), text.find('\n', text.find("draw")) + 1 - text.find("draw"));
    text += hpgl ? "draw = \"b{points}\"\n" : "draw = \"b{x}{y}{feed}\"\n";
    text +=
        "begin = [\"c{paper}\"]\ndown = [\"d{feed}{z_feed}\"]\npen_change = [\"e{pen}{name}\"]\npen_select = \"f{pen}{width}\"\n"
        "velocity = \"g{cm_per_s}\"\npens = 0\n";
    const Device device = read_device(text, "F");
    Plot plot;
    PenLines lines;
    lines.pen.number = 1;
    lines.pen.speed = 50;
    lines.pen.pause = true;
    lines.lines.points = {{10, 10}, {20, 20}};
    lines.lines.begin.push_back(2);
    plot.pens.push_back(lines);
    const Page page{100, 100, 0};
    const std::string commands = write_plot(plot, device, place_on_device(device, page, Rect{{10, 10}, {20, 20}}, false));
    EXPECT_EQ(commands.find_first_of("{}"), std::string::npos) << commands;
    for (const char* begin : {"a", "b", "c", "d", "e", "f", "g"}) {
      EXPECT_NE(("\n" + commands).find(std::string("\n") + begin), std::string::npos) << begin << " in " << commands;
    }
  }
}

}  // namespace
}  // namespace ligne
