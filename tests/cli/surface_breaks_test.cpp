/// Where formulas end and jump: strokes end on the true border, and none goes over a jump.

#include "surface_program.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

struct Place {
  double x, y, z;
};

class SurfaceBreaksTest : public SurfaceProgramTest {
 protected:
  /// Segments of the visible curves and borders, in the numbers of the axes.
  std::vector<std::array<Place, 2>> segments(const Words& arguments, const std::string& view = "top") {
    const Outcome outcome = surface(
        arguments + Words{"--z-scale", "1", "--aspect", "equal", "--view", view, "--method", "appel"}, "-o - --format json");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const json drawing = json::parse(outcome.out);
    const auto& m = drawing["view"]["matrix"];
    mm_ = std::hypot(m[0].get<double>(), m[1].get<double>(), m[2].get<double>());
    std::vector<std::array<Place, 2>> found;
    for (const json& stroke : drawing["strokes"]) {
      if (stroke["class"] != "horizon" && stroke["class"] != "border") continue;
      const auto& ends = stroke["source"]["ends"];
      found.push_back({Place{ends[0][0], ends[0][1], ends[0][2]}, Place{ends[1][0], ends[1][1], ends[1][2]}});
      border_.push_back(stroke["class"] == "border");
    }
    return found;
  }
  double mm_ = 1;  ///< of a unit
  std::vector<bool> border_;
};

/// A formula with its domain: the distance of a place of the ground from the border, known by hand.
struct KnownBorder {
  Words plot;
  std::function<double(double, double)> distance;
  double length;  ///< of the border within the plot
};

double from_circle(double x, double y, double radius) { return std::abs(std::hypot(x, y) - radius); }

TEST_F(SurfaceBreaksTest, StrokesEndOnTheTrueBorder) {
  constexpr double kPi = 3.14159265358979323846;
  const Words ground = "-x -4:4 -y -4:4";
  const auto plot = [&](const std::string& formula, const Words& more = {}) {
    Words all = Words{formula} + ground + more;
    return all;
  };
  const double root = std::sqrt(2);
  const KnownBorder borders[] = {
      {plot("sqrt(9-x^2-y^2)"), [](double x, double y) { return from_circle(x, y, 3); }, 6 * kPi},
      {plot("acos(r/3.3)"), [](double x, double y) { return from_circle(x, y, 3.3); }, 6.6 * kPi},
      {plot("if((x-0.3)^2+(y+0.2)^2 < 4, x*y/4, 0/0)"), [](double x, double y) { return from_circle(x - 0.3, y + 0.2, 2); },
       4 * kPi},
      {plot("sqrt(x-y+0.03)/2"), [&](double x, double y) { return std::abs(x - y + 0.03) / root; }, (8 - 0.03) * root},
      {plot("sqrt(r-1.7)"), [](double x, double y) { return from_circle(x, y, 1.7); }, 3.4 * kPi},
      {plot("sqrt(2.01-abs(x))"), [](double x, double) { return std::abs(std::abs(x) - 2.01); }, 16},
      {plot("if(x+2*y > 0.1, sin(x), 0/0)"), [](double x, double y) { return std::abs(x + 2 * y - 0.1) / std::sqrt(5); },
       4 * std::sqrt(5)},
      {plot("x^2+y^2", "--z-range -1:7"), [](double x, double y) { return from_circle(x, y, std::sqrt(7)); },
       2 * kPi * std::sqrt(7)},
      {plot("x+y/3", "--z-range -2:1"),
       [](double x, double y) { return std::min(std::abs(x + y / 3 - 1), std::abs(x + y / 3 + 2)) / std::hypot(1, 1. / 3); },
       2 * 8 * std::hypot(1, 1. / 3)},
      {plot("1/(x-0.1)", "--z-range -2:2"), [](double x, double) { return std::min(std::abs(x - 0.6), std::abs(x + 0.4)); },
       16},
  };
  for (const KnownBorder& known : chosen("borders", 2, borders)) {
    border_.clear();
    const auto drawn = segments(known.plot);
    ASSERT_GT(drawn.size(), 100u) << known.plot[0];
    double farthest = 0, length = 0;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      if (!border_[k]) continue;
      length += std::hypot(drawn[k][1].x - drawn[k][0].x, drawn[k][1].y - drawn[k][0].y);
      for (const double t : {0., 0.5, 1.}) {
        const double x = drawn[k][0].x + t * (drawn[k][1].x - drawn[k][0].x);
        const double y = drawn[k][0].y + t * (drawn[k][1].y - drawn[k][0].y);
        farthest = std::max(farthest, known.distance(x, y) * mm_);
      }
    }
    EXPECT_LT(farthest, 0.01) << known.plot[0] << ": mm from the true border";
    EXPECT_NEAR(length, known.length, 2e-3 * known.length) << known.plot[0];
    // Every curve ends there, or where the plot does.
    double loose = 0;
    std::map<std::array<double, 3>, int> ends;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      if (border_[k]) continue;
      for (const Place& p : drawn[k]) ++ends[{p.x, p.y, p.z}];
    }
    for (const auto& [p, count] : ends) {
      const bool at_rim = std::abs(std::abs(p[0]) - 4) < 1e-9 || std::abs(std::abs(p[1]) - 4) < 1e-9;
      if (count == 1 && !at_rim) loose = std::max(loose, known.distance(p[0], p[1]) * mm_);
    }
    EXPECT_LT(loose, 0.01) << known.plot[0] << ": mm of a loose end from the true border";
  }
}

TEST_F(SurfaceBreaksTest, NoStrokeGoesOverAJump) {
  struct KnownJump {
    std::string formula;
    std::function<double(double, double)> side;  ///< changes where the formula jumps
  };
  const auto step = [](double v) { return std::floor(v); };
  const KnownJump jumps[] = {
      {"floor(x)+y/9", [&](double x, double) { return step(x); }},
      {"sign(x-0.03)*2", [&](double x, double) { return double(x > 0.03); }},
      {"ceil(x+y/2)", [&](double x, double y) { return std::ceil(x + y / 2); }},
      {"round(y)/2+x/5", [&](double, double y) { return std::round(y); }},
      {"mod(x+0.013*y,1)", [&](double x, double y) { return step(x + 0.013 * y); }},
      {"if(r < 2.02, 2, 0)", [&](double x, double y) { return double(std::hypot(x, y) < 2.02); }},
      {"sign(x*y)", [&](double x, double y) { return double(x > 0) + 2 * double(y > 0); }},
      {"atan(1/(x-y/3))", [&](double x, double y) { return double(x > y / 3); }},
      {"floor(r)", [&](double x, double y) { return step(std::hypot(x, y)); }},
      {"x*x/4-3*(x > sin(y))", [&](double x, double y) { return double(x > std::sin(y)); }},
  };
  constexpr double kBeside = 1e-6;  // of a unit: what is nearer to a jump has no side
  for (const KnownJump& known : chosen("jumps", 3, jumps)) {
    border_.clear();
    const auto drawn = segments({known.formula, "-x", "-3.5:3.5", "-y", "-3.5:3.5"});
    ASSERT_GT(drawn.size(), 100u) << known.formula;
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
      const double first = known.side(p.x + t * (q.x - p.x), p.y + t * (q.y - p.y));
      across += first != known.side(q.x + t * (p.x - q.x), q.y + t * (p.y - q.y));
    }
    EXPECT_EQ(across, 0) << known.formula;
  }
}

TEST_F(SurfaceBreaksTest, AJumpThatRunsIntoTheBorderMakesNoWall) {
  // Samples lie on the border where the jump meets it, and the border is a rounding farther than they are.
  for (const char* formula :
       {"r<=3 ? 2*(y>=0) : 0/0", "x>-3+y*y/99 ? 2*(y>0) : 0/0", "r<=3 && abs(y)>0.1 ? sign(y) : 0/0"}) {
    border_.clear();
    const auto drawn = segments({formula, "-x", "-3:3:13", "-y", "-3:3:13", "--samples", "49"}, "iso");
    ASSERT_GT(drawn.size(), 100u) << formula;
    for (const auto& [p, q] : drawn) EXPECT_LT(std::abs(q.z - p.z), 0.01) << formula << " at " << p.x << ", " << p.y;
  }
}

TEST_F(SurfaceBreaksTest, FineGridsAreThinned) {
  std::string text;
  for (int j = 0; j < 300; ++j) {
    for (int i = 0; i < 450; ++i) text += std::to_string(i * j % 7) + (i == 449 ? "\n" : " ");
  }
  write("fine.txt", text);
  const auto curves = [&](const Words& more) {
    return layers("--grid fine.txt --z-scale 0.001 --view top --page 200x150 --margin 10 --pen-width 0.3" + more)
        .at("horizon");
  };
  // There is room for one column in 0.45 mm, of 450 columns in 180 mm: every second one, and the last.
  EXPECT_NEAR(curves({}), curves("--every 2"), 0.1);
  EXPECT_NEAR(curves("--every auto --method appel"), curves("--every 2"), 0.1);
  EXPECT_GT(curves("--every 1"), 1.9 * curves({}));
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

}  // namespace
}  // namespace ligne::test
