/// HPGL and G-code, command by command: goldens of every device, replayed by machines that complain.

#include "main/script.hpp"
#include "plotted.hpp"
#include "plotting/devices/device.hpp"

namespace ligne {
namespace {

using namespace test;

std::vector<std::string> plotters() {
  std::vector<std::string> names;
  for (const Device& device : devices())
    if (device.language != DeviceLanguage::svg) names.push_back(device.name);
  return names;
}

class EveryPlotter : public testing::TestWithParam<std::string> {
 protected:
  const Device& device() const { return *find_device(GetParam()); }
  void expect_within_limits(const Replay& got, const DeviceFrame& frame) const {
    const double step = device().language == DeviceLanguage::hpgl ? 1 : device().step_mm;
    for (const int axis : {0, 1}) {
      EXPECT_GE(got.reach.min[axis], frame.limits.min[axis] * step - 1e-9);
      EXPECT_LE(got.reach.max[axis], frame.limits.max[axis] * step + 1e-9);
    }
  }
};

TEST_P(EveryPlotter, WritesItsGolden) {
  const std::string suffix = device().language == DeviceLanguage::hpgl ? ".hpgl" : ".gcode";
  expect_golden("plot-" + GetParam() + suffix, written(device(), plotter_drawing(), true).text);
}

TEST_P(EveryPlotter, DrawsWhatThePlotHolds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(20, 190), y(30, 260);
  Drawing drawing = plotter_drawing();
  for (int i = 0; i < 200; ++i) {
    std::vector<Point2> line;
    for (int k = 0; k < 2 + i % 7; ++k) line.push_back({x(random), y(random)});
    add_line(drawing, i % 2 ? "crease" : "border", line);
  }
  for (const bool two_pens : {false, true}) {
    const Written w = written(device(), drawing, two_pens);
    const Replay got = replay(device(), w.text);
    EXPECT_EQ(got.faults, std::vector<std::string>{});
    EXPECT_TRUE(got.ends_up);
    const double unit = device().language == DeviceLanguage::hpgl ? device().step_mm : 1;
    std::size_t stroke = 0;
    for (const PenLines& pen : w.plot.pens) {
      for (std::size_t i = 0; i < pen.lines.size(); ++i, ++stroke) {
        ASSERT_LT(stroke, got.strokes.size());
        const auto line = pen.lines[i];
        const auto& drawn = got.strokes[stroke];
        // Each drawn point is the image of the next point, within half a step in x and in y.
        std::size_t k = 0;
        for (const Point2 p : line) {
          const Point2 wanted = w.frame.to_device(p);
          if (k + 1 < drawn.size() && glm::distance(wanted, drawn[k] * unit) > device().step_mm * 0.7072) ++k;
          ASSERT_LE(glm::distance(wanted, drawn[k] * unit), device().step_mm * 0.7072);
        }
        EXPECT_EQ(k + 1, drawn.size());
      }
    }
    EXPECT_EQ(stroke, got.strokes.size());
    expect_within_limits(got, w.frame);
  }
}

TEST_P(EveryPlotter, RefusesWhatLeavesTheLimitsOrMakesItFit) {
  Drawing drawing;
  add_line(drawing, "outline", {{-40, -50}, {500, 700}});
  const std::string error = failure_of([&] { place_on_device(device(), {}, drawn_bounds(drawing), false); });
  expect_parts(error, {" mm ", "--fit-device"});
  const Written w = written(device(), drawing, false, true);
  const Replay got = replay(device(), w.text);
  expect_within_limits(got, w.frame);
  const Point2 across = w.frame.to_device({1, 0}) - w.frame.to_device({0, 0}),
               down = w.frame.to_device({0, 1}) - w.frame.to_device({0, 0});
  EXPECT_NEAR(glm::length(across), glm::length(down), 1e-12) << "made smaller alike in both directions";
  EXPECT_NEAR(glm::distance(w.frame.to_page(w.frame.to_device({12, 34})), Point2(12, 34)), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Devices, EveryPlotter, testing::ValuesIn(plotters()), [](const auto& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
});

TEST(Devices, ThatTakeSvgWriteTheirGoldens) {
  std::size_t count = 0;
  for (const Device& device : devices()) {
    if (device.language != DeviceLanguage::svg) continue;
    Written w = written(device, plotter_drawing(), true, true);
    for (PenLines& pen : w.plot.pens)
      for (Point2& p : pen.lines.points) p = w.frame.fitted(p);
    PlotOptions options;
    options.style = styles_of(w.plot);
    expect_golden("plot-" + device.name + ".svg", write_svg(drawing_of(w.plot), options));
    ++count;
  }
  EXPECT_EQ(count, 7u);
}

/// HPGL as hp2xx reads it, a program that is not ours.

bool hp2xx_is_there() { return std::system("command -v hp2xx >/dev/null 2>&1") == 0; }

/// Points of the paths of hp2xx's SVG, in its units of 1/90 inch.
std::vector<Point2> hp2xx_points(const std::string& hpgl) {
  const TemporaryFolder folder;
  folder.write("in.hpgl", hpgl);
  const std::string command = "cd '" + folder.string() + "' && hp2xx -q -N -t -m svg -f out.svg in.hpgl >/dev/null 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::vector<Point2> points;
  for (const std::string& path : path_data(bytes_of_file(folder / "out.svg"))) {
    std::istringstream data(path);
    double x = 0;
    char comma = 0;
    for (std::string word; data >> word;) {
      if (word != "M" && word != "L") continue;
      Point2 p{0, 0};
      if (data >> x >> comma >> p.y) points.push_back({x, p.y});
    }
  }
  return points;
}

class Hp2xx : public testing::TestWithParam<std::string> {};

TEST_P(Hp2xx, ReadsTheSameDrawingOfTheSameSize) {
  if (!hp2xx_is_there()) GTEST_SKIP() << "hp2xx is not installed";
  const Device& device = *find_device(GetParam());
  Drawing drawing = plotter_drawing();
  const Written w = written(device, drawing, true);
  const std::vector<Point2> read = hp2xx_points(w.text);
  ASSERT_FALSE(read.empty());
  // hp2xx takes a unit for 0.025 mm, puts the lower left of the drawing into a corner, and fits its SVG to a page: shapes
  // are compared, at our width. That sizes are true the test of the 7475A tells.
  constexpr double kUnitMm = 0.025;
  Rect ours, pixels;
  std::vector<Point2> points;
  for (const auto& stroke : test::replay_hpgl(w.text).strokes)
    for (const Point2 p : stroke) ours.extend(points.emplace_back(p * kUnitMm));
  for (const Point2 p : read) pixels.extend(p);
  const double pixel_mm = ours.width() / pixels.width();
  constexpr double kWithinMm = 0.05;
  EXPECT_NEAR(pixels.height() * pixel_mm, ours.height(), kWithinMm);
  const auto nearest = [](Point2 p, const std::vector<Point2>& all) {
    double least = 1e300;
    for (const Point2 q : all) least = std::min(least, glm::distance(p, q));
    return least;
  };
  std::vector<Point2> shifted;
  for (const Point2 p : read) shifted.push_back(ours.min + Point2{p.x - pixels.min.x, pixels.max.y - p.y} * pixel_mm);
  for (const Point2 p : points) EXPECT_LE(nearest(p, shifted), kWithinMm) << p.x << " " << p.y;
  for (const Point2 p : shifted) EXPECT_LE(nearest(p, points), kWithinMm) << p.x << " " << p.y;
}

INSTANTIATE_TEST_SUITE_P(Devices, Hp2xx, testing::Values("hp7475a", "hp7550a", "designjet", "cutter"));

// Facts about the devices: every number names its source, and agrees with the table of the sources.

const std::filesystem::path kDevices = std::filesystem::path(LIGNE_SOURCE_DIR) / "plotting/devices";
const std::filesystem::path kSources = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/plotting/device_sources.csv";

/// Keys whose values are measures of the machine or of its paper.
constexpr std::string_view kMeasures =
    " step pens limits origin width height speed_down speed_up lift_seconds pen_change_seconds points_per_command at ";

TEST(DeviceFacts, EveryNumberNamesItsSource) {
  std::size_t numbers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kDevices)) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      const std::string key = line.substr(0, line.find(' '));
      if (kMeasures.find(" " + key + " ") == kMeasures.npos || line.find("= \"") != std::string::npos) continue;
      ++numbers;
      const std::size_t comment = line.find("  # ");
      EXPECT_TRUE(comment != std::string::npos && line.size() > comment + 6) << entry.path().filename() << ": " << line;
    }
  }
  EXPECT_GT(numbers, 150u);
}

Point2 point_of(std::string text) { return line_of_text(text.replace(text.find(' '), 1, ",")).at(0); }

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
