// Facts about the devices: every number names its source, and agrees with the table of the sources.

#include "main/script.hpp"
#include "plotting/devices/device.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

const std::filesystem::path kDevices = std::filesystem::path(LIGNE_SOURCE_DIR) / "plotting/devices";
const std::filesystem::path kSources = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/plotting/device_sources.csv";

/// Keys whose values are measures of the machine or of its paper.
constexpr std::array<std::string_view, 12> kMeasures{"step",
                                                     "pens",
                                                     "limits",
                                                     "origin",
                                                     "width",
                                                     "height",
                                                     "speed_down",
                                                     "speed_up",
                                                     "lift_seconds",
                                                     "pen_change_seconds",
                                                     "points_per_command",
                                                     "at"};

TEST(DeviceFacts, EveryNumberNamesItsSource) {
  std::size_t numbers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kDevices)) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      const std::string key = line.substr(0, line.find(' '));
      if (std::ranges::find(kMeasures, key) == kMeasures.end() || line.find("= \"") != std::string::npos) continue;
      ++numbers;
      const std::size_t comment = line.find("  # ");
      EXPECT_TRUE(comment != std::string::npos && line.size() > comment + 6) << entry.path().filename() << ": " << line;
    }
  }
  EXPECT_GT(numbers, 150u);
}

Point2 point_of(const std::string& text) {
  const std::vector<std::string> parts = test::parts_of(text, ' ');
  return {std::stod(parts.at(0)), std::stod(parts.at(1))};
}

void compare(const Device& device, const DevicePaper* paper, const std::string& fact, const std::string& value) {
  if (fact == "step") {
    EXPECT_EQ(device.step_mm, std::stod(value));
  } else if (fact == "reach") {
    EXPECT_EQ(device.limits_mm.max - device.limits_mm.min, point_of(value));
  } else if (!paper) {
    FAIL() << "the device has no such paper";
  } else if (fact == "limit_x") {
    EXPECT_EQ(paper->limits.max.x, std::stod(value));
  } else if (fact == "limit_y") {
    EXPECT_EQ(paper->limits.max.y, std::stod(value));
  } else if (fact == "middle") {
    const Point2 middle = *paper->origin_mm + point_of(value) * device.step_mm;
    EXPECT_NEAR(glm::distance(middle, Point2(paper->width_mm, paper->height_mm) * 0.5), 0, 0.01);
    const Point2 far = *paper->origin_mm + paper->limits.max * device.step_mm;
    EXPECT_TRUE(far.x < paper->width_mm && far.y < paper->height_mm) << "the reach leaves the paper";
  } else if (fact == "p1" || fact == "p2") {
    const Point2 p = point_of(value);
    EXPECT_TRUE(p.x >= paper->limits.min.x && p.y >= paper->limits.min.y && p.x <= paper->limits.max.x &&
                p.y <= paper->limits.max.y);
  } else {
    FAIL() << "no such fact";
  }
}

TEST(DeviceFacts, AgreeWithTheTableOfTheirSources) {
  std::ifstream file(kSources);
  ASSERT_TRUE(file);
  std::set<std::string> told;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    SCOPED_TRACE(line);
    const std::vector<std::string> cells = test::parts_of(line, ',');
    ASSERT_EQ(cells.size(), 5u);
    const Device* const device = find_device(cells[0]);
    ASSERT_NE(device, nullptr);
    const auto paper = std::ranges::find(device->papers, cells[1], &DevicePaper::name);
    compare(*device, paper == device->papers.end() ? nullptr : &*paper, cells[2], cells[3]);
    told.insert(cells[0]);
  }
  // GRBL is a controller: its machines have any size.
  for (const Device& device : devices())
    EXPECT_TRUE(told.contains(device.name) || device.name.starts_with("grbl")) << device.name;
}

}  // namespace
}  // namespace ligne
