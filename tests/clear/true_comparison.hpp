#pragma once
/// Clear drawings beside the true lines of their parts.

#include "clear/true_parts.hpp"
#include "picture/draw_scene.hpp"
#include "support/page_lines.hpp"

namespace ligne::test {

/// Size of the cells in which lines and triangles of the page are found.
inline constexpr double kHidingCellMm = 2;

/// Tells by a fine mesh of a part which points it hides.
class Hiding {
 public:
  Hiding(const Scene& scene, const View& view) : view_(view), cells_(view.window, kHidingCellMm) {
    for (const Triangle& t : build_topology(scene).triangles) {
      std::array<Point3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = on_page(scene.vertices[t.v[k]]);
      const auto number = static_cast<std::uint32_t>(triangles_.size());
      triangles_.push_back(corners);
      const Point2 a(corners[0]), b(corners[1]), c(corners[2]);
      cells_.add(glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c), number);
    }
  }

  Point3 on_page(const Point3& p) const {
    const HomogeneousPoint h = to_homogeneous(view_, p);
    return Point3(h.x, h.y, h.z) / h.w;
  }

  bool hides(Point2 p, double depth) const {
    bool hidden = false;
    cells_.each(p, p, [&](std::uint32_t i) { hidden = hidden || depth_at(triangles_[i], p) < depth; });
    return hidden;
  }

 private:
  static double depth_at(const std::array<Point3, 3>& t, Point2 p) {
    const auto twice_area = [](Point2 a, Point2 b, Point2 c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const Point2 a(t[0]), b(t[1]), c(t[2]);
    const double u = twice_area(b, c, p), v = twice_area(c, a, p), w = twice_area(a, b, p), sum = u + v + w;
    const bool is_inside = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    return is_inside && sum != 0 ? (u * t[0].z + v * t[1].z + w * t[2].z) / sum : std::numeric_limits<double>::infinity();
  }

  View view_;
  std::vector<std::array<Point3, 3>> triangles_;
  PageCells cells_;
};

/// Samples of the edges and outlines of a part, whatever hides them.
struct KnownLines {
  std::vector<TruePoint> wanted;
  std::vector<TruePoint> other;  ///< lines that a drawing may have or not
};

struct DrawnShare {
  double seen_mm = 0, drawn_mm = 0;  ///< of true lines: surely seen, and of these drawn
  double part() const { return seen_mm > 0 ? drawn_mm / seen_mm : 1; }
};

/// A line of the page that only one of a drawing and the truth has.
struct OddPiece {
  std::vector<Point2> path;
  TruePoint sample;  ///< its first one, if it is missing
};

struct Comparison {
  Drawing drawing;
  std::array<DrawnShare, 3> kinds;  ///< by TrueLine
  double ink_mm = 0, true_mm = 0;   ///< drawn, and of this on a true line that may be seen
  std::vector<Point2> cusps;        ///< of true outlines, hidden ones too
  std::vector<OddPiece> missing;    ///< what is surely seen and not drawn
  std::vector<OddPiece> extra;      ///< what is drawn and not true
};

struct TrueScene {
  Scene drawn;  ///< the mesh that is drawn
  Scene fine;   ///< the mesh that tells what is hidden
  /// The lines of the part, with samples every `step` model units.
  std::function<KnownLines(const Viewer& viewer, double step)> lines;
  /// How far the drawn mesh lies from the true line there, in model units.
  std::function<double(const TruePoint&)> sag;
};

/// Draws with the lines of tangent borders and a pen of 0.35 mm, and compares within 0.1 mm and the sag.
Comparison compare_with_truth(const TrueScene& scene, const ViewRequest& view);

}  // namespace ligne::test
