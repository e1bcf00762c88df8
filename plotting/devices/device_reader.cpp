#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "plotting/devices/device.hpp"
#include "plotting/devices/embedded.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/devices/toml_reading.hpp"

namespace ligne {
namespace {

constexpr double kFinestStepMm = 1e-4, kCoarsestStepMm = 10;
constexpr unsigned kMostPoints = 1'000'000;

/// Bounds of real machines, with room on both sides. Within these bounds no time, feed or coordinate overflows: a drawing
/// has less than 2^32 points, none of them farther than kFarthestMm, and so takes less than 2 * 10^18 s, which 64 bits hold.
constexpr double kSlowestMmPerS = 0.01, kFastestMmPerS = 10'000, kLongestLiftS = 600, kLongestChangeS = 86'400;
constexpr double kLargestPaperMm = 100'000, kFarthestOriginMm = 1e6, kFarthestUnit = 1e10;

bool is_paper_side(double mm) { return mm > 0 && mm <= kLargestPaperMm; }

std::string required_text(const TomlTable& table, std::string_view key) {
  const auto value = table.text(key);
  if (!value || value->empty()) table.fail("there is no " + std::string(key));
  return *value;
}

Rect read_limits(const TomlTable& table) {
  const auto v = table.numbers("limits", 4);
  if (!v) table.fail("there are no limits [x0, y0, x1, y1]");
  const Rect limits{{(*v)[0], (*v)[1]}, {(*v)[2], (*v)[3]}};
  if (!(limits.width() > 0 && limits.height() > 0)) table.fail("the limits are empty", table.find("limits"));
  return limits;
}

bool is_within(Point2 p, double most) { return std::abs(p.x) <= most && std::abs(p.y) <= most; }

/// Fails at unknown placeholders in braces, which would reach the machine as they are.
void check_placeholders(const TomlTable& table, std::string_view key, std::string_view command,
                        std::span<const std::string_view> known) {
  for (std::size_t at = command.find('{'); at != command.npos; at = command.find('{', at + 1)) {
    const std::size_t end = std::min(command.find('}', at), command.size());
    const std::string_view name = command.substr(at + 1, end - at - 1);
    if (end < command.size() && std::ranges::find(known, name) != known.end()) continue;
    std::string there;
    for (const std::string_view one : known) there += (there.empty() ? "there is {" : ", {") + std::string(one) + "}";
    table.fail(std::string(key) + ": {" + printable(name) + (end < command.size() ? "}" : "") + " is unknown here; " +
                   (there.empty() ? "the braces are empty" : there),
               table.find(key));
  }
}

DevicePaper read_paper(const TomlTable& table) {
  table.only({"name", "width", "height", "limits", "origin", "select", "note"});
  DevicePaper paper;
  paper.name = required_text(table, "name");
  paper.width_mm = table.number("width").value_or(0);
  paper.height_mm = table.number("height").value_or(0);
  if (!is_paper_side(paper.width_mm) || !is_paper_side(paper.height_mm))
    table.fail("width and height of a paper are above 0 and at most 100000 mm");
  paper.limits = read_limits(table);
  for (const Point2 corner : {paper.limits.min, paper.limits.max}) {
    if (!is_within(corner, kFarthestUnit))
      table.fail("the limits of a paper are not from -1e10 to 1e10 units", table.find("limits"));
  }
  if (const auto origin = table.numbers("origin", 2)) {
    paper.origin_mm = Point2{(*origin)[0], (*origin)[1]};
    if (!is_within(*paper.origin_mm, kFarthestOriginMm))
      table.fail("the origin is farther than a kilometre away", table.find("origin"));
  }
  paper.select = table.text("select").value_or("");
  check_placeholders(table, "select", paper.select, {});
  paper.note = table.text("note").value_or("");
  return paper;
}

DevicePlace read_place(const TomlTable& table) {
  table.only({"name", "at"});
  DevicePlace place{required_text(table, "name"), {}};
  const auto at = table.numbers("at", 2);
  if (!at) table.fail("there is no at [x, y]");
  place.at_mm = {(*at)[0], (*at)[1]};
  if (!is_within(place.at_mm, kFarthestOriginMm)) table.fail("the place is farther than a kilometre away", table.find("at"));
  return place;
}

DeviceAction read_action(const TomlTable& table, const Device& device) {
  constexpr std::string_view kFeeds[] = {"feed", "z_feed"};
  table.only({"name", "at", "commands"});
  DeviceAction action{required_text(table, "name"), table.text("at").value_or(""), table.texts("commands")};
  if (!action.place.empty() && !find_place(device, action.place))
    table.fail("there is no [[place]] " + printable(action.place), table.find("at"));
  if (action.commands.empty()) table.fail("there are no commands");
  for (const std::string& command : action.commands) check_placeholders(table, "commands", command, kFeeds);
  return action;
}

/// A command of a device file, of one line or several, and the placeholders that it may have; plot_writer.cpp replaces
/// them.
struct DeviceCommand {
  std::string_view key;
  std::string Device::*line;
  std::vector<std::string> Device::*lines;
  std::array<std::string_view, 3> names{};
};
constexpr DeviceCommand kDeviceCommands[] = {{"begin", nullptr, &Device::begin, {"paper"}},
                                             {"end", nullptr, &Device::end},
                                             {"up", nullptr, &Device::up},
                                             {"down", nullptr, &Device::down, {"feed", "z_feed"}},
                                             {"dot", &Device::dot, nullptr},
                                             {"pen_change", nullptr, &Device::pen_change, {"pen", "name"}},
                                             {"travel", &Device::travel, nullptr, {"x", "y"}},
                                             {"pen_select", &Device::pen_select, nullptr, {"pen", "width"}},
                                             {"velocity", &Device::velocity, nullptr, {"cm_per_s"}},
                                             {"delay", &Device::delay, nullptr, {"seconds"}},
                                             {"draw", &Device::draw, nullptr, {"x", "y", "feed"}}};

std::span<const std::string_view> placeholders(const DeviceCommand& command, DeviceLanguage language) {
  static constexpr std::string_view kPoints[] = {"points"};
  if (command.key == "draw" && language == DeviceLanguage::hpgl) return kPoints;
  const auto end = std::ranges::find(command.names, std::string_view{});
  return {command.names.begin(), end};
}

DeviceLanguage read_language(const TomlTable& table) {
  const std::string name = required_text(table, "language");
  for (std::size_t i = 0; i < std::size(kDeviceLanguageNames); ++i) {
    if (name == kDeviceLanguageNames[i]) return static_cast<DeviceLanguage>(i);
  }
  table.fail("language is not hpgl, gcode or svg", table.find("language"));
}

void read_speeds(const TomlTable& table, Device& device) {
  const auto read = [&](std::string_view key, double low, double high, const char* range) {
    const auto value = table.number(key);
    if (!value) table.fail("there is no " + std::string(key));
    if (!(*value >= low && *value <= high)) table.fail(std::string(key) + " is not from " + range, table.find(key));
    return *value;
  };
  device.down_mm_s = read("speed_down", kSlowestMmPerS, kFastestMmPerS, "0.01 to 10000 mm/s");
  device.up_mm_s = read("speed_up", kSlowestMmPerS, kFastestMmPerS, "0.01 to 10000 mm/s");
  device.lift_s = read("lift_seconds", 0, kLongestLiftS, "0 to 600 s");
  device.pen_change_s = read("pen_change_seconds", 0, kLongestChangeS, "0 to 86400 s");
}

void read_commands(const TomlTable& table, Device& device) {
  device.points_per_command = table.count("points_per_command", 0, kMostPoints).value_or(0);
  for (const DeviceCommand& command : kDeviceCommands) {
    const std::span<const std::string_view> known = placeholders(command, device.language);
    const std::vector<std::string> lines =
        command.lines ? table.texts(command.key) : std::vector{table.text(command.key).value_or("")};
    for (const std::string& line : lines) check_placeholders(table, command.key, line, known);
    if (command.lines) {
      device.*command.lines = lines;
    } else {
      device.*command.line = lines.front();
    }
  }
  if (device.language == DeviceLanguage::svg) return;
  for (const std::string_view key : {"travel", "draw"}) required_text(table, key);
  const auto check_point = [&](std::string_view key, std::string_view command) {
    if (command.find("{x}") == command.npos || command.find("{y}") == command.npos)
      table.fail(std::string(key) + " has no {x} and {y}", table.find(key));
  };
  if (device.language == DeviceLanguage::hpgl) {
    required_text(table, "dot");
    if (device.draw.find("{points}") == std::string::npos) table.fail("draw has no {points}", table.find("draw"));
  } else {
    check_point("draw", device.draw);
  }
  check_point("travel", device.travel);
}

}  // namespace

Device read_device(std::string_view toml, const std::string& file) {
  const toml::table parsed = parse_toml(toml, file);
  const TomlTable table(parsed, file);
  table.only({"name",
              "title",
              "note",
              "language",
              "step",
              "pens",
              "rotation",
              "turn",
              "y_down",
              "limits",
              "paper",
              "place",
              "action",
              "begin",
              "end",
              "up",
              "down",
              "pen_change",
              "pen_select",
              "travel",
              "draw",
              "dot",
              "velocity",
              "delay",
              "points_per_command",
              "returns",
              "inside_first",
              "speed_down",
              "speed_up",
              "lift_seconds",
              "pen_change_seconds"});
  Device device;
  device.name = required_text(table, "name");
  device.title = required_text(table, "title");
  device.note = table.text("note").value_or("");
  device.language = read_language(table);
  device.step_mm = table.number("step").value_or(0);
  if (!(device.step_mm >= kFinestStepMm && device.step_mm <= kCoarsestStepMm))
    table.fail("step is not from 0.0001 to 10 mm", table.find("step"));
  device.pens = table.count("pens", 0, kMostPens).value_or(1);
  device.rotation = static_cast<int>(table.count("rotation", 0, 270).value_or(0));
  if (device.rotation % 90 != 0) table.fail("rotation is not 0, 90, 180 or 270", table.find("rotation"));
  const std::string turn = table.text("turn").value_or("left");
  if (turn != "left" && turn != "right") table.fail("turn is neither left nor right", table.find("turn"));
  device.turn_right = turn == "right";
  device.y_down = table.flag("y_down").value_or(false);
  device.inside_first = table.flag("inside_first").value_or(false);
  device.returns = table.flag("returns").value_or(false);
  for (const TomlTable& paper : table.tables("paper")) device.papers.push_back(read_paper(paper));
  if (device.papers.empty()) device.limits_mm = read_limits(table);
  if (!device.papers.empty() && table.has("limits")) table.fail("limits are those of the papers", table.find("limits"));
  for (const TomlTable& place : table.tables("place")) device.places.push_back(read_place(place));
  for (const TomlTable& action : table.tables("action")) device.actions.push_back(read_action(action, device));
  read_commands(table, device);
  read_speeds(table, device);
  return device;
}

const std::vector<Device>& devices() {
  static const std::vector<Device> all = [] {
    std::vector<Device> list;
    for (const EmbeddedDevice& file : embedded_devices()) list.push_back(read_device(file.toml, std::string(file.name)));
    std::sort(list.begin(), list.end(), [](const Device& l, const Device& r) { return l.name < r.name; });
    return list;
  }();
  return all;
}

}  // namespace ligne
