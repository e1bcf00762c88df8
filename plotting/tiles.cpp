#include "plotting/tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "plotting/stroke_text.hpp"

namespace ligne {
namespace {

constexpr double kMarkMm = 3, kNumberMm = 3;  ///< adjustable: half of a register mark, height of the sheet's number

/// The interval of the segment inside the box; nothing where it lies outside.
std::optional<std::array<double, 2>> inside(Point2 a, Point2 b, const Rect& box) {
  double from = 0, to = 1;
  for (const int axis : {0, 1}) {
    const double way = b[axis] - a[axis];
    if (way == 0) {
      if (a[axis] < box.min[axis] || a[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double low = (box.min[axis] - a[axis]) / way, high = (box.max[axis] - a[axis]) / way;
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  return from <= to ? std::optional(std::array{from, to}) : std::nullopt;
}

/// The point of the segment at `t`, kept inside the box against rounding.
Point2 at(Point2 a, Point2 b, double t, const Rect& box) {
  if (t == 0) return a;
  if (t == 1) return b;
  const Point2 p = a + (b - a) * t;
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
}

/// Number of sheets along one side; the first begins at 0.
std::size_t sheets_along(double length, double usable, double overlap) {
  return length <= usable ? 1 : static_cast<std::size_t>(std::ceil((length - overlap) / (usable - overlap)));
}

void add_marks(Layer& layer, const Rect& area, double overlap_mm, const std::string& number, const Page& paper) {
  const Rect marks{area.min + Point2{overlap_mm, overlap_mm} * 0.5, area.max - Point2{overlap_mm, overlap_mm} * 0.5};
  for (const double x : {marks.min.x, marks.max.x}) {
    for (const double y : {marks.min.y, marks.max.y}) {
      const std::array across{Point2{x - kMarkMm, y}, Point2{x + kMarkMm, y}};
      const std::array down{Point2{x, y - kMarkMm}, Point2{x, y + kMarkMm}};
      layer.lines.add(across);
      layer.lines.add(down);
    }
  }
  TextItem text{.text = number, .height_mm = kNumberMm};
  // In the lower margin where that is high enough, else inside.
  const double below = paper.height_mm - area.max.y;
  text.at = {marks.min.x + 2 * kMarkMm, area.max.y + (below >= 2 * kNumberMm ? 1.5 * kNumberMm : -kNumberMm)};
  append_stroke_text(text, layer.lines);
}

}  // namespace

Polylines clip_to_box(const Polylines& lines, const Rect& box) {
  Polylines kept;
  std::vector<Point2> piece;
  const auto end = [&] {
    if (!piece.empty()) kept.add(piece);
    piece.clear();
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (line.size() == 1) {
      if (inside(line[0], line[0], box)) kept.add(line);
      continue;
    }
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Point2 a = line[k - 1], b = line[k];
      const auto part = inside(a, b, box);
      // A line that only touches the box ends there; a dot is a line of no length.
      if (!part || ((*part)[0] == (*part)[1] && a != b)) {
        end();
        continue;
      }
      const Point2 from = at(a, b, (*part)[0], box), to = at(a, b, (*part)[1], box);
      if (piece.empty() || piece.back() != from) {
        end();
        piece.push_back(from);
      }
      piece.push_back(to);
      if ((*part)[1] < 1) end();
    }
    end();
  }
  return kept;
}

std::vector<Tile> cut_into_tiles(const Drawing& drawing, const Page& whole, const Page& paper, double overlap_mm) {
  const Rect area = paper.drawable();
  const std::size_t columns = sheets_along(whole.width_mm, area.width(), overlap_mm),
                    rows = sheets_along(whole.height_mm, area.height(), overlap_mm);
  std::vector<Tile> tiles;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const Point2 corner{static_cast<double>(column) * (area.width() - overlap_mm),
                          static_cast<double>(row) * (area.height() - overlap_mm)};
      const Rect box{corner, corner + area.max - area.min};
      Tile tile{row * columns + column + 1, {}};
      for (const Layer& layer : drawing.layers) {
        Layer part = layer;
        part.lines = clip_to_box(layer.lines, box);
        if (part.lines.size() == 0) continue;
        for (Point2& p : part.lines.points) p += area.min - corner;
        tile.drawing.layers.push_back(std::move(part));
      }
      if (tile.drawing.layers.empty()) continue;
      Layer marks{"register", {}};
      add_marks(marks, area, overlap_mm, std::to_string(tile.number) + "/" + std::to_string(rows * columns), paper);
      tile.drawing.layers.push_back(std::move(marks));
      tiles.push_back(std::move(tile));
    }
  }
  return tiles;
}

}  // namespace ligne
