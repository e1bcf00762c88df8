#include "plotting/meant_areas.hpp"

#include "drawing/measures.hpp"

namespace ligne::test {
namespace {

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
  for (std::size_t i = scene.areas.size(); i-- > 0;)
    if (is_in(scene.areas[i], p)) return static_cast<int>(i);
  return -1;
}

constexpr double kAside = 0.002, kOnLine = 1e-4;

/// Whether an edge comes near the point in another direction, or ends there.
bool is_disturbed(const MeantScene& scene, Point2 p, Point2 direction) {
  const auto disturbs = [&](const Contour& contour) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point2 a = contour[k], b = contour[(k + 1) % contour.size()];
      const bool parallel = std::abs(cross(glm::normalize(b - a), direction)) < 1e-9;
      if (parallel && std::abs(cross(a - p, direction)) < 1e-7 && glm::distance(a, p) > 3 * kAside &&
          glm::distance(b, p) > 3 * kAside)
        continue;
      if (distance_to_segment(p, a, b) < 3 * kAside) return true;
    }
    return false;
  };
  return std::ranges::any_of(scene.areas, [&](const MeantArea& area) {
    return std::ranges::any_of(area.contours, disturbs) || std::ranges::any_of(area.clips, disturbs);
  });
}

/// How many pens have lines through the point, and whether this one has.
std::pair<int, bool> pens_at(const ReadDrawing& drawn, Point2 p, const std::string& own) {
  int all = 0;
  bool is_own = false;
  for (const Layer& layer : drawn.drawing.layers) {
    if (distance_to_lines(p, layer.lines) > kOnLine) continue;
    ++all;
    is_own |= layer.name == own;
  }
  return {all, is_own};
}

/// How many edges of the area's own contours pass through the point.
int own_edges_at(const MeantArea& area, Point2 p) {
  int count = 0;
  for (const Contour& contour : area.contours)
    for (std::size_t k = 0; k < contour.size(); ++k)
      count += distance_to_segment(p, contour[k], contour[(k + 1) % contour.size()]) <= kOnLine;
  return count;
}

/// A transform, as SVG writes it, with its inverse.
struct Move {
  std::string text;
  std::function<Point2(Point2)> back;
};

Move random_move(Dice& dice) {
  const auto number = [&](double low, double high) {
    return std::round(std::uniform_real_distribution<double>(low, high)(dice) * 1e4) / 1e4;
  };
  std::ostringstream text;
  text.precision(17);
  switch (dice() % 5) {
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

/// The colour of the area, which is the name of its layer.
std::string color_of_area(std::size_t i) {
  char text[16];
  std::snprintf(text, sizeof text, "#0000%02x", static_cast<unsigned>(i) + 1);
  return text;
}

/// Adds an area below two random transforms and its clip paths, each of which is written in its own units.
void add_area(MeantScene& scene, const MeantArea& area, Dice& dice) {
  const std::string number = std::to_string(scene.areas.size());
  const Move outer = random_move(dice), inner = random_move(dice);
  const auto back = [&](Point2 p) { return inner.back(outer.back(p)); };
  std::string open = "<g transform='" + outer.text + "'><g transform='" + inner.text + "'>", close = "</g></g>";
  for (std::size_t k = 0; k < area.clips.size(); ++k) {
    const std::string id = "c" + number + "_" + std::to_string(k);
    scene.body += "<clipPath id='" + id + "'><path d='" + path_text({area.clips[k]}, back) + "'/></clipPath>";
    open += "<g clip-path='url(#" + id + ")'>";
    close += "</g>";
  }
  scene.body += open + "<path stroke='none' fill='" + color_of_area(scene.areas.size()) + "' fill-rule='" +
                (area.even_odd ? "evenodd" : "nonzero") + "' d='" + path_text(area.contours, back) + "'/>" + close;
  scene.areas.push_back(area);
}

Contour rectangle(Point2 low, Point2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

/// The corners of a grid, turned a little or not at all.
class GridCorners {
 public:
  GridCorners(std::uint32_t side, double distance, Dice& dice) : side_(side), distance_(distance) {
    const double turn = dice() % 2 ? 0 : std::uniform_real_distribution<double>(0, 1)(dice);
    x_ = Point2{std::cos(turn), std::sin(turn)} * distance;
  }

  Point2 any(Dice& dice) const {
    const double middle = (side_ - 1) / 2.0, x = dice() % side_ - middle, y = dice() % side_ - middle;
    return Point2{50, 50} + x_ * x + Point2{-x_.y, x_.x} * y;
  }

  /// Neighbours are different corners.
  Contour polygon(std::size_t count, Dice& dice) const {
    Contour contour;
    while (contour.size() < count) {
      const Point2 p = any(dice);
      const auto is_same = [&](Point2 q) { return glm::distance(p, q) < distance_ / 2; };
      if (contour.empty() || (!is_same(contour.back()) && (contour.size() + 1 < count || !is_same(contour.front()))))
        contour.push_back(p);
    }
    return contour;
  }

 private:
  std::uint32_t side_;
  double distance_;
  Point2 x_;
};

/// Positions at random, ascending. They are apart: of closer ones no picture shows which is which.
std::vector<double> lines_of_grid(Dice& dice) {
  constexpr std::size_t kLines = 6;
  constexpr double kLeastGap = 0.01;
  std::vector<double> lines(kLines);
  do {
    for (double& v : lines) v = std::uniform_real_distribution<double>(10, 90)(dice);
    std::ranges::sort(lines);
  } while (std::ranges::adjacent_find(lines, [](double a, double b) { return b - a < kLeastGap; }) != lines.end());
  return lines;
}

}  // namespace

std::string svg_of(const MeantScene& scene) {
  return "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100' fill='none'>" +
         scene.body + "</svg>";
}

MeantScene abutting_rectangles(Dice& dice) {
  const std::vector<double> xs = lines_of_grid(dice), ys = lines_of_grid(dice);
  const auto any = [&] {
    std::size_t x = dice() % 5, y = dice() % 5;
    const std::size_t x2 = x + 1 + dice() % (5 - x), y2 = y + 1 + dice() % (5 - y);
    return rectangle({xs[x], ys[y]}, {xs[x2], ys[y2]});
  };
  MeantScene scene;
  const std::size_t count = 2 + dice() % 5;
  while (scene.areas.size() < count) {
    MeantArea area{{any()}};
    if (dice() % 4 == 0) area.contours.push_back(any()), area.even_odd = dice() % 2;
    for (std::size_t clips = dice() % 3; clips > 0; --clips) area.clips.push_back(any());
    add_area(scene, area, dice);
  }
  return scene;
}

/// Areas of one contour or two, clipped or not.
MeantScene polygons(const GridCorners& corners, std::size_t count, std::uint32_t most_corners, bool doubled, Dice& dice) {
  MeantScene scene;
  while (scene.areas.size() < count) {
    MeantArea area{{corners.polygon(3 + dice() % most_corners, dice)}, dice() % 2 == 0};
    if (doubled && dice() % 3 == 0) area.contours.push_back(corners.polygon(3 + dice() % most_corners, dice));
    if (dice() % 3 == 0) area.clips.push_back(corners.polygon(3 + dice() % most_corners, dice));
    add_area(scene, area, dice);
  }
  return scene;
}

MeantScene polygons_of_shared_corners(Dice& dice) {
  const GridCorners corners(7, 9, dice);
  return polygons(corners, 2 + dice() % 4, 5, true, dice);
}

MeantScene scribbles(Dice& dice) {
  const GridCorners corners(40, 1.5, dice);
  return polygons(corners, 1 + dice() % 3, 120, false, dice);
}

int wrong_places(const MeantScene& scene, Dice& dice) {
  const ReadDrawing drawn = read_svg_drawing(svg_of(scene), "a.svg", {}, {FillReading::How::outline, 0.35, true});
  std::uniform_real_distribution<double> part(0.02, 0.98);
  int wrong = 0;
  for (std::size_t i = 0; i < scene.areas.size(); ++i) {
    std::vector<Contour> borders = scene.areas[i].contours;
    borders.insert(borders.end(), scene.areas[i].clips.begin(), scene.areas[i].clips.end());
    for (const Contour& contour : borders) {
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const Point2 a = contour[k], b = contour[(k + 1) % contour.size()], direction = glm::normalize(b - a);
        for (int sample = 0; sample < 4; ++sample) {
          const Point2 p = a + (b - a) * part(dice), aside = Point2{-direction.y, direction.x} * kAside;
          if (is_disturbed(scene, p, direction)) continue;
          const int left = top_at(scene, p + aside), right = top_at(scene, p - aside);
          const auto [all, own] = pens_at(drawn, p, color_of_area(i));
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

}  // namespace ligne::test
