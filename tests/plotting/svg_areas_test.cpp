/// Areas that abut, coincide and overlap, held against a sampled picture: who is on top is told point by point, from the
/// shapes as they were meant, without anything of the code under test.

#include <random>

#include "main/tier.hpp"
#include "support/test.hpp"
#include "svg_text.hpp"

namespace ligne {
namespace {

using namespace test;

using Contour = std::vector<Point2>;

struct MeantArea {
  std::vector<Contour> contours;
  bool even_odd = false;
  std::vector<Contour> clips{};
};

struct MeantScene {
  std::vector<MeantArea> areas;
  std::string body;
};

int windings_round(const std::vector<Contour>& contours, Point2 p) {
  int winding = 0;
  for (const Contour& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point2 a = contour[k], b = contour[(k + 1) % contour.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const double x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
      if (x > p.x) winding += b.y > a.y ? 1 : -1;
    }
  }
  return winding;
}

bool is_in(const MeantArea& area, Point2 p) {
  const int winding = windings_round(area.contours, p);
  if (area.even_odd ? winding % 2 == 0 : winding == 0) return false;
  return std::ranges::all_of(area.clips, [&](const Contour& clip) { return windings_round({clip}, p) != 0; });
}

/// The area that is painted last over the point; -1: none.
int top_at(const MeantScene& scene, Point2 p) {
  for (std::size_t i = scene.areas.size(); i-- > 0;) {
    if (is_in(scene.areas[i], p)) return static_cast<int>(i);
  }
  return -1;
}

constexpr double kAside = 0.02, kOnLine = 1e-4;

double distance_to(Point2 a, Point2 b, Point2 p) {
  const Point2 along = b - a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return glm::distance(p, a + along * t);
}

/// Whether an edge comes near the point in another direction, or ends there.
bool is_disturbed(const MeantScene& scene, Point2 p, Point2 direction) {
  const auto disturbs = [&](const Contour& contour) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point2 a = contour[k], b = contour[(k + 1) % contour.size()];
      const bool parallel = std::abs(cross(glm::normalize(b - a), direction)) < 1e-9;
      if (parallel && std::abs(cross(a - p, direction)) < 1e-7 && glm::distance(a, p) > 3 * kAside &&
          glm::distance(b, p) > 3 * kAside)
        continue;
      if (distance_to(a, b, p) < 3 * kAside) return true;
    }
    return false;
  };
  return std::ranges::any_of(scene.areas, [&](const MeantArea& area) {
    return std::ranges::any_of(area.contours, disturbs) || std::ranges::any_of(area.clips, disturbs);
  });
}

std::string color_of_area(int i) {
  char text[16];
  std::snprintf(text, sizeof text, "#0000%02x", i + 1);
  return text;
}

bool passes(const Polylines& lines, Point2 p) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    for (std::size_t k = 1; k < line.size(); ++k) {
      if (distance_to(line[k - 1], line[k], p) <= kOnLine) return true;
    }
  }
  return false;
}

/// How many pens have lines through the point, and whether this one has.
std::pair<int, bool> pens_at(const ReadDrawing& drawn, Point2 p, const std::string& own) {
  int all = 0;
  bool is_own = false;
  for (const Layer& layer : drawn.drawing.layers) {
    if (!passes(layer.lines, p)) continue;
    ++all;
    is_own |= layer.name == own;
  }
  return {all, is_own};
}

/// How many edges of the area's own contours pass through the point.
int own_edges_at(const MeantArea& area, Point2 p) {
  int count = 0;
  for (const Contour& contour : area.contours) {
    for (std::size_t k = 0; k < contour.size(); ++k)
      count += distance_to(contour[k], contour[(k + 1) % contour.size()], p) <= kOnLine;
  }
  return count;
}

/// Wrong places of the plotted borders: a border is drawn once where it parts what is seen, and nowhere else.
int wrong_places(const MeantScene& scene, std::mt19937& random) {
  const ReadDrawing drawn = read_svg_drawing(page(scene.body), "a.svg", {}, {FillReading::How::outline, 0.35, true});
  std::uniform_real_distribution<double> part(0.02, 0.98);
  int wrong = 0;
  for (std::size_t i = 0; i < scene.areas.size(); ++i) {
    std::vector<Contour> borders = scene.areas[i].contours;
    borders.insert(borders.end(), scene.areas[i].clips.begin(), scene.areas[i].clips.end());
    for (const Contour& contour : borders) {
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const Point2 a = contour[k], b = contour[(k + 1) % contour.size()], direction = glm::normalize(b - a);
        for (int sample = 0; sample < 4; ++sample) {
          const Point2 p = a + (b - a) * part(random), aside = Point2{-direction.y, direction.x} * kAside;
          if (is_disturbed(scene, p, direction)) continue;
          const int left = top_at(scene, p + aside), right = top_at(scene, p - aside);
          const auto [all, own] = pens_at(drawn, p, color_of_area(static_cast<int>(i)));
          // A contour that runs back on itself is drawn where the area has nothing beside it, too.
          if (std::ranges::any_of(scene.areas, [&](const MeantArea& area) { return own_edges_at(area, p) > 1; })) continue;
          const bool seen_left = left == static_cast<int>(i), seen_right = right == static_cast<int>(i);
          if (seen_left != seen_right && all != 1) ++wrong;  // not drawn, or by two pens
          if (!seen_left && !seen_right && own) ++wrong;
        }
      }
    }
  }
  return wrong;
}

/// A transform, as SVG writes it, with its inverse.
struct Move {
  std::string text;
  std::function<Point2(Point2)> back;
};

Move random_move(std::mt19937& random) {
  const auto number = [&](double low, double high) {
    return std::round(std::uniform_real_distribution<double>(low, high)(random) * 1e4) / 1e4;
  };
  std::ostringstream text;
  text.precision(17);
  switch (random() % 5) {
    case 0: {
      const Point2 by{number(-9, 9), number(-9, 9)};
      text << "translate(" << by.x << " " << by.y << ")";
      return {text.str(), [by](Point2 p) { return p - by; }};
    }
    case 1:
      return {"rotate(90)", [](Point2 p) { return Point2{p.y, -p.x}; }};
    case 2:
      return {"scale(-1 1)", [](Point2 p) { return Point2{-p.x, p.y}; }};
    case 3: {
      const Point2 by{number(0.3, 3), number(0.3, 3)};
      text << "scale(" << by.x << " " << by.y << ")";
      return {text.str(), [by](Point2 p) { return p / by; }};
    }
    default:
      return {"translate(0 0)", [](Point2 p) { return p; }};
  }
}

std::string path_text(const std::vector<Contour>& contours, const std::function<Point2(Point2)>& back) {
  std::ostringstream d;
  d.precision(12);
  for (const Contour& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point2 p = back(contour[k]);
      d << (k == 0 ? "M" : "L") << p.x << " " << p.y;
    }
    d << "Z";
  }
  return d.str();
}

/// Adds an area below two random transforms and its clip paths, each of which is written in its own units.
void add_area(MeantScene& scene, const MeantArea& area, std::mt19937& random) {
  const std::string number = std::to_string(scene.areas.size());
  const Move outer = random_move(random), inner = random_move(random);
  const auto back = [&](Point2 p) { return inner.back(outer.back(p)); };
  std::string open = "<g transform='" + outer.text + "'><g transform='" + inner.text + "'>", close = "</g></g>";
  for (std::size_t k = 0; k < area.clips.size(); ++k) {
    const std::string id = "c" + number + "_" + std::to_string(k);
    scene.body += "<clipPath id='" + id + "'><path d='" + path_text({area.clips[k]}, back) + "'/></clipPath>";
    open += "<g clip-path='url(#" + id + ")'>";
    close += "</g>";
  }
  scene.body += open + "<path stroke='none' fill='" + color_of_area(static_cast<int>(scene.areas.size())) + "' fill-rule='" +
                (area.even_odd ? "evenodd" : "nonzero") + "' d='" + path_text(area.contours, back) + "'/>" + close;
  scene.areas.push_back(area);
}

Contour rectangle(Point2 low, Point2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

/// Rectangles whose sides lie on few lines, so that most of them abut or coincide.
MeantScene abutting_rectangles(std::mt19937& random) {
  std::array<double, 6> xs, ys;
  for (double& v : xs) v = std::uniform_real_distribution<double>(10, 90)(random);
  for (double& v : ys) v = std::uniform_real_distribution<double>(10, 90)(random);
  std::ranges::sort(xs);
  std::ranges::sort(ys);
  const auto any = [&] {
    std::size_t x = random() % 5, y = random() % 5;
    const std::size_t x2 = x + 1 + random() % (5 - x), y2 = y + 1 + random() % (5 - y);
    return rectangle({xs[x], ys[y]}, {xs[x2], ys[y2]});
  };
  MeantScene scene;
  const std::size_t count = 2 + random() % 5;
  while (scene.areas.size() < count) {
    MeantArea area{{any()}};
    if (random() % 4 == 0) area.contours.push_back(any()), area.even_odd = random() % 2;
    for (std::size_t clips = random() % 3; clips > 0; --clips) area.clips.push_back(any());
    add_area(scene, area, random);
  }
  return scene;
}

/// Polygons with corners on a coarse grid, turned a little: they cross themselves, and share corners and parts of edges.
MeantScene polygons_of_shared_corners(std::mt19937& random) {
  const double turn = random() % 2 ? 0 : std::uniform_real_distribution<double>(0, 1)(random);
  const double c = std::cos(turn), s = std::sin(turn);
  const auto corner = [&] {
    const Point2 p{static_cast<double>(random() % 7) * 9 - 27, static_cast<double>(random() % 7) * 9 - 27};
    return Point2{50 + c * p.x - s * p.y, 50 + s * p.x + c * p.y};
  };
  const auto polygon = [&] {
    Contour contour;
    const std::size_t count = 3 + random() % 5;
    while (contour.size() < count) {
      const Point2 p = corner();
      const auto is_same = [&](Point2 q) { return glm::distance(p, q) < 1; };
      if (contour.empty() || (!is_same(contour.back()) && (contour.size() + 1 < count || !is_same(contour.front()))))
        contour.push_back(p);
    }
    return contour;
  };
  MeantScene scene;
  const std::size_t count = 2 + random() % 4;
  while (scene.areas.size() < count) {
    MeantArea area{{polygon()}, random() % 2 == 0};
    if (random() % 3 == 0) area.contours.push_back(polygon());
    if (random() % 3 == 0) area.clips.push_back(polygon());
    add_area(scene, area, random);
  }
  return scene;
}

void expect_right(MeantScene (*make)(std::mt19937&), unsigned seed) {
  std::mt19937 random(seed);
  const int count = runs_all() ? 10'000 : 300;
  int wrong = 0;
  for (int i = 0; i < count; ++i) {
    const MeantScene scene = make(random);
    if (wrong_places(scene, random) == 0) continue;
    if (++wrong == 1) ADD_FAILURE() << "the first that is wrong: " << page(scene.body);
  }
  EXPECT_EQ(wrong, 0) << "of " << count;
}

TEST(SvgAreas, AbuttingRectanglesAgreeWithAPicture) { expect_right(abutting_rectangles, 1); }
TEST(SvgAreas, PolygonsOfSharedCornersAgreeWithAPicture) { expect_right(polygons_of_shared_corners, 2); }

Lines occluded_lines(const std::string& body) {
  return lines_of(read_svg_drawing(page(body), "a.svg", {}, {FillReading::How::outline, 0.35, true}));
}

TEST(SvgAreas, LinesOnBordersAreDrawnOnceIfTheyAreSeen) {
  const std::string square = "<rect x='10' y='10' width='20' height='20' stroke='none' fill='";
  const std::string outline = "1000,1000 3000,1000 3000,3000 1000,3000 1000,1000 ";
  const ReadDrawing equal =
      read_svg_drawing(page(square + "red'/>" + square + "blue'/>"), "a.svg", {}, {FillReading::How::outline, 0.35, true});
  EXPECT_EQ(lines_of(equal), Lines{outline});
  EXPECT_EQ(equal.drawing.layers.at(0).name, "#0000ff") << "the upper one";
  EXPECT_EQ(lines_of(read(square + "red'/>" + square + "white'/>")), Lines{}) << "white covers all of it";
  const std::string stroked = "<rect x='10' y='10' width='20' height='20' fill='red' stroke-width='";
  EXPECT_EQ(occluded_lines(stroked + "2'/>" + stroked + "2'/>"), Lines{outline}) << "strokes of one width";
  EXPECT_EQ(occluded_lines(stroked + "2'/>" + stroked + "1'/>").size(), 2u) << "the wider one sticks out";
  const std::string line = "<line x1='30' y1='12' x2='30' y2='18'/>";
  const std::string right = "<rect x='30' y='10' width='20' height='20' stroke='none' fill='white'/>";
  EXPECT_EQ(lines_of(read(line + square + "white'/>")), Lines{"3000,1200 3000,1800 "}) << "half of its ink is seen";
  EXPECT_EQ(lines_of(read(line + square + "white'/>" + right)), Lines{}) << "between two areas that abut";
}

/// Edges on one line, a thousand areas in one place, and corners in one point take no time that grows with their square.
TEST(SvgAreas, CrowdsInOnePlaceAreRight) {
  std::string body = "<line y1='50' x2='100' y2='50'/>", star = "M";
  for (int i = 0; i < 20'000; ++i) body += "<path d='M20 20H80V80H20z' fill='white' stroke='none'/>";
  EXPECT_EQ(lines_of(read(body)), (Lines{"0,5000 2000,5000 ", "8000,5000 10000,5000 "}));
  for (int i = 0; i < 10'000; ++i) {
    const double a = 2 * std::numbers::pi * i / 10'000;
    star += "50 50L" + std::to_string(50 + 30 * std::cos(a)) + " " + std::to_string(50 + 30 * std::sin(a)) + "L";
  }
  EXPECT_EQ(lines_of(read("<line y1='50' x2='100' y2='50'/><path d='" + star + "50 50z' fill='white' stroke='none'/>")),
            Lines{"0,5000 10000,5000 "})
      << "spikes have no area";
}

}  // namespace
}  // namespace ligne
