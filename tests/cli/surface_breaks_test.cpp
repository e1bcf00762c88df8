/// Where formulas end and jump: strokes end on the true border, and none goes over a jump.

#include <chrono>
#include <regex>

#include "drawing_quantities.hpp"
#include "main/script.hpp"
#include "support/mesh_text.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class SurfaceBreaksTest : public SurfaceProgramTest {
 protected:
  /// Segments of the visible curves and borders, in the numbers of the axes.
  std::vector<std::array<Point3, 2>> segments(const Words& arguments, const std::string& view = "top") {
    const Outcome outcome = surface(
        arguments + Words{"--z-scale", "1", "--aspect", "equal", "--view", view, "--method", "appel"}, "-o - --format json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const json drawing = json::parse(outcome.out);
    const auto& m = drawing["view"]["matrix"];
    mm_ = std::hypot(m[0].get<double>(), m[1].get<double>(), m[2].get<double>());
    std::vector<std::array<Point3, 2>> found;
    border_.clear();
    for (const json& stroke : drawing["strokes"]) {
      if (stroke["class"] != "horizon" && stroke["class"] != "border") continue;
      const auto& ends = stroke["source"]["ends"];
      found.push_back({Point3{ends[0][0], ends[0][1], ends[0][2]}, Point3{ends[1][0], ends[1][1], ends[1][2]}});
      border_.push_back(stroke["class"] == "border");
    }
    return found;
  }
  double mm_ = 1;  ///< of a unit
  std::vector<bool> border_;
};

/// The rows of a table beside this file.
std::vector<std::vector<std::string>> table_of(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream in(LIGNE_SOURCE_DIR "/tests/cli/" + table);
  for (std::string line; std::getline(in, line);) {
    std::erase(line, ' ');
    if (!line.starts_with('#')) rows.push_back(parts_of(line, '|'));
  }
  return rows;
}

/// A formula of a place of the ground.
std::function<double(const Point3&)> on_ground(const std::string& formula) {
  static constexpr std::array<std::string_view, 2> kVariables{"x", "y"};
  return [value = place_formula(formula + ";0;0", kVariables)](const Point3& p) { return value({p.x, p.y}).x; };
}

TEST_F(SurfaceBreaksTest, StrokesEndOnTheTrueBorder) {
  for (const auto& row : chosen("borders", 2, table_of("surface_borders.txt"))) {
    SCOPED_TRACE(row[0]);
    const auto distance = on_ground(row.at(2));
    const auto drawn = segments(Words{row[0]} + "-x -4:4 -y -4:4" + row[1].c_str());
    ASSERT_GT(drawn.size(), 100u);
    double farthest = 0, length = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      if (!border_[k]) continue;
      const auto& [from, to] = drawn[k];
      length += std::hypot(to.x - from.x, to.y - from.y);
      for (const double t : {0., 0.5, 1.}) farthest = std::max(farthest, distance(from + t * (to - from)) * mm_);
    }
    const double expected = number_of(row.at(3));
    EXPECT_LT(farthest, 0.01) << "mm from the true border";
    EXPECT_NEAR(length, expected, 2e-3 * expected);
    // Every curve ends there, or where the plot does.
    double loose = 0;
    std::map<std::array<double, 3>, int> ends;
    for (std::size_t k = 0; k < drawn.size(); ++k)
      for (const Point3& p : drawn[k]) ends[{p.x, p.y, p.z}] += !border_[k];
    for (const auto& [p, count] : ends) {
      const bool at_rim = std::abs(std::abs(p[0]) - 4) < 1e-9 || std::abs(std::abs(p[1]) - 4) < 1e-9;
      if (count == 1 && !at_rim) loose = std::max(loose, distance({p[0], p[1], 0}) * mm_);
    }
    EXPECT_LT(loose, 0.01) << "mm of a loose end from the true border";
  }
}

TEST_F(SurfaceBreaksTest, NoStrokeGoesOverAJump) {
  constexpr double kBeside = 1e-6;  // of a unit: what is nearer to a jump has no side
  for (const auto& row : chosen("jumps", 3, table_of("surface_jumps.txt"))) {
    const auto side = on_ground(row.at(1));
    const auto drawn = segments(Words{row[0]} + "-x -3.5:3.5 -y -3.5:3.5");
    ASSERT_GT(drawn.size(), 100u) << row[0];
    int across = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      const auto& [p, q] = drawn[k];
      const double length = std::hypot(q.x - p.x, q.y - p.y);
      if (length < kBeside) {
        across += std::abs(q.z - p.z) > 0.01;  // a wall
        continue;
      }
      const double t = kBeside / length;
      if (border_[k]) continue;  // they run along it
      across += side(p + t * (q - p)) != side(q + t * (p - q));
    }
    EXPECT_EQ(across, 0) << row[0];
  }
}

TEST_F(SurfaceBreaksTest, AJumpThatRunsIntoTheBorderMakesNoWall) {
  // Samples lie on the border where the jump meets it, and the border is a rounding farther than they are.
  for (const char* formula :
       {"r<=3 ? 2*(y>=0) : 0/0", "x>-3+y*y/99 ? 2*(y>0) : 0/0", "r<=3 && abs(y)>0.1 ? sign(y) : 0/0"}) {
    const auto drawn = segments({formula, "-x", "-3:3:13", "-y", "-3:3:13", "--samples", "49"}, "iso");
    ASSERT_GT(drawn.size(), 100u) << formula;
    for (const auto& [p, q] : drawn) EXPECT_LT(std::abs(q.z - p.z), 0.01) << formula << " at " << p.x << ", " << p.y;
  }
}

TEST_F(SurfaceBreaksTest, FineGridsAreThinned) {
  std::string text;
  for (int j = 0; j < 300; ++j)
    for (int i = 0; i < 450; ++i) text += std::to_string(i * j % 7) + (i == 449 ? "\n" : " ");
  write("fine.txt", text);
  const auto curves = [&](const Words& more) {
    return layers("--grid fine.txt --z-scale 0.001 --view top --page 200x150 --margin 10 --pen-width 0.3" + more)
        .at("horizon");
  };
  // There is room for one column in 0.45 mm, of 450 columns in 180 mm: every second one, and the last.
  EXPECT_NEAR(curves({}), curves("--every 2"), 0.1);
  EXPECT_NEAR(curves("--every auto --method appel"), curves("--every 2"), 0.1);
  EXPECT_GT(curves("--every 1"), 1.9 * curves({}));
  EXPECT_LT(curves("-x 0:7 --aspect box"), 0.55 * curves("-x 0:7 --aspect box --every 1")) << "eight columns, fewer rows";
}

TEST_F(SurfaceBreaksTest, ScatteredPointsComeFromStandardInputToo) {
  std::string rows = "id,x,y,z\n";
  for (int k = 0; k < 400; ++k) {
    const double x = k * 37 % 101, y = k * 61 % 97;
    rows += std::to_string(k) + "," + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(x * y / 50) + "\n";
  }
  write("points.csv", rows);
  const Outcome outcome = surface("--grid points.csv --axes", "-o a.svg");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err,
            "ligne: points.csv: warning: 400 scattered points: heights are linear in their Delaunay triangles\n"
            "ligne: points.csv: warning: left out: 1 column (id)\n");
  EXPECT_EQ(surface("--grid - --axes", "-o a.svg").status, 1) << "there is nothing on it";
}

// Contour lines and axes of `ligne surface` by the mesh methods.

using SurfaceLinesTest = SurfaceProgramTest;

TEST_F(SurfaceLinesTest, AxesOfTheMeshAreThoseOfTheHorizon) {
  for (const char* style : {"--axes", "--axes=grid", "--axes=box", "--axes=base"}) {
    for (const Words view :
         chosen(std::string("views, ") + style, 3, {"", "--azimuth 20 --elevation -35", "--eye 30,-20,25"})) {
      Words plot = Words{"5*sin(r)/r", "-x", "-9:9:30", "-y", "-8:9:30", "--z-scale", "1", style, "--title", "hat"} + view;
      const Outcome mesh = surface(plot, "--method appel -o - --format svg");
      const std::string by_horizon = surface(plot, "-o - --format svg").out, by_mesh = mesh.out;
      EXPECT_EQ(mesh.err, "");
      const double horizon = layers_of(by_horizon).at("axes");
      EXPECT_NEAR(layers_of(by_mesh).at("axes"), horizon, 1e-3 * horizon) << style;
      EXPECT_EQ(by_mesh.substr(by_mesh.find("id=\"text\"")), by_horizon.substr(by_horizon.find("id=\"text\""))) << style;
    }
  }
}

TEST_F(SurfaceLinesTest, Logarithms) {
  const json heights = drawn("10^x -x 0:2:3 -y 0:1:2 --log-z --z-scale 1");
  for (const json& stroke : heights["strokes"])
    for (const json& end : stroke["source"]["ends"]) EXPECT_NEAR(end[2].get<double>(), end[0].get<double>(), 1e-12);
  EXPECT_GT(layers("x --log-z -x -1:1:20").at("horizon"), 0) << "by the horizon, too; half of it are holes";
}

TEST_F(SurfaceLinesTest, MeshesOverDegreesAreNoThingsInSpace) {
  write("mesh.dat", "0 0 0\n1 0.1 0\n2 0 0\n\n0.1 1 0\n1.1 1.1 12\n2.1 1 0\n\n0 2 0\n1 2.1 0\n2 2 0\n");
  const auto highest = [&](const Words& more) {
    const Outcome outcome = surface(Words("--grid mesh.dat --as-mesh") + more, {"-o", "mesh.obj"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream text(contents(file("mesh.obj")));
    double z = 0;
    for (std::string line; std::getline(text, line);)
      if (line.starts_with("v ")) z = std::max(z, std::stod(line.substr(line.rfind(' '))));
    return z;
  };
  for (const Words more : {"", "--ground metres"}) EXPECT_DOUBLE_EQ(highest(more), 12);
  EXPECT_LT(highest("--ground degrees"), 2);
}

/// Bad input of `ligne surface`: one line, the exit status and no file, or a right drawing of what there is.

using SurfaceInputTest = SurfaceProgramTest;

TEST_F(SurfaceInputTest, ContoursWithoutNumberOrMemory) {
  // Ten thousand levels on a steep sheet of two million triangles would cut it into thousands of millions.
  const auto begin = std::chrono::steady_clock::now();
  fails("sin(50*x)*sin(50*y) -x 0:1:500 -y 0:1:500 --samples 1000 --contours 10000 --skirt -o out.svg", 1,
        "sin(50*x)*sin(50*y): has too many contour lines: they cut it into more than 12 million triangles\n");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_FALSE(exists("out.svg"));
  fails({"x", "--axes", "--x-label", std::string(1000, 'n'), "-o", "a.svg"}, 2,
        "--page: numbers and names of the axes leave no drawable area");
}

// Fills and terrain maps: what scripts/surface.txt can not measure.

/// Seen from above, ten units of the ground are 80 mm.
const Words kMap = "-x 0:10:11 -y 0:10:11 --view top --lines none --page 100x100 --margin 10 --scale 8:1";

using TerrainTest = SurfaceProgramTest;

TEST_F(TerrainTest, FillsShowTheBandsInTheirColours) {
  const Words bands = "x -x 0:10:11 -y 0:10:3 --bands 0,2,5 --fill material --colors red,lime,blue --legend --lines y";
  const Outcome outcome = surface(bands, "-o - --format svg");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::size_t fill = outcome.out.find("inkscape:label=\"fill\""),
                    lines = outcome.out.find("inkscape:label=\"horizon\"");
  ASSERT_TRUE(fill != std::string::npos && lines != std::string::npos);
  for (const char* color : {"\"#f00\"", "\"#0f0\"", "\"#00f\""}) {
    const std::size_t at = outcome.out.find(color);
    EXPECT_TRUE(fill < at && at < lines) << color << " is that of an area";
    EXPECT_EQ(outcome.out.find(color, lines), std::string::npos) << "lines on areas are black";
  }
  EXPECT_NE(outcome.out.find("inkscape:label=\"legend\""), std::string::npos) << "samples have a frame";
  expect_parts(outcome.out, {">2 \u2013 5</text>"});
  for (const char* format : {"pdf", "png"}) EXPECT_EQ(surface(bands, {"-o", "-", "--format", format}).status, 0) << format;
}

TEST_F(TerrainTest, HachuresDownASlopeStayOnTheGround) {
  const Words terrain = "sin(x)*cos(y)+0.1*sin(7*x)*sin(5*y) --hachures slope --outline off";
  Rect box;
  for (const Layer& layer : read_svg_drawing(surface(terrain, kMap + "-o - --format svg").out, "a", {}).drawing.layers)
    for (const Point2 p : layer.lines.points) box.extend(p);
  EXPECT_GE(std::min(box.min.x, box.min.y), 10 - 1e-3);
  EXPECT_LE(std::max(box.max.x, box.max.y), 90 + 1e-3);
  EXPECT_GT(box.width(), 70);
}

TEST_F(TerrainTest, AxesOfRidgelinesSayTruePositions) {
  const auto drawn = [&](const std::vector<std::string>& more) {
    return surface({"sin(x)+0.1*y", "-x", "-6:6", "-y", "0:10:20", "--ridgeline", "-o", "-", "--format", "svg"}, more).out;
  };
  for (const char* style : {"--axes", "--axes=box", "--axes=base", "--axes=grid"}) {
    const std::string out = drawn({style});
    expect_parts(out, {">−6</text>", ">−2</text>", ">6</text>", ">10</text>", ">7</text>", ">1.5</text>"});
    expect_no_parts(out, {">0.35</text>", ">1.2</text>", ">0.9</text>"});
    // Lines of the axes that no longer path holds: ticks, and lines of the grid over the last row.
    const std::string axes = out.substr(out.find("id=\"axes\""));
    const std::regex straight("<path d=\"M(\\S+) (\\S+)l(\\S+) (\\S+)\"/>");
    for (std::sregex_iterator line(axes.begin(), axes.end(), straight), end; line != end; ++line) {
      const double dx = std::stod((*line)[3]), y = std::stod((*line)[2]);
      if (std::abs(dx) < 100) continue;
      EXPECT_TRUE(y > 230 || y < 90 || style == std::string("--axes=grid")) << style << ": crosses the rows at " << y;
    }
  }
  EXPECT_EQ(layers({"sin(x)^2+cos(x)^2", "-x", "0:9"}), layers({"1", "-x", "0:9"})) << "a height and its rounding";
  EXPECT_EQ(layers({"x*0", "-x", "0:9", "-y", "0:1:4", "--ridgeline", "--axes"}).count("axes"), 1u) << "flat rows";
}

TEST_F(TerrainTest, UnevenRowsOfRidgelinesStandAtTheirPositions) {
  write("rows.csv", ",0,1,2\n0,5,5,5\n1,5,5,5\n10,5,5,6\n");
  const std::string out = surface("--grid rows.csv --ridgeline 1", "-o - --format svg").out;
  std::vector<double> y;
  const Polylines lines = read_svg_drawing(out, "a", {}).drawing.layers.at(0).lines;
  for (std::size_t i = 0; i < lines.size(); ++i) y.push_back(lines[i][0].y);
  ASSERT_EQ(y.size(), 3u);
  std::sort(y.begin(), y.end());
  EXPECT_NEAR((y[1] - y[0]) / (y[2] - y[1]), 9, 0.01);
}

}  // namespace
}  // namespace ligne::test
