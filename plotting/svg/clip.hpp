#pragma once
/// Areas of an SVG, and lines cut down to them. Private to plotting.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne::svg {

/// Links that lead on to links.
inline constexpr int kMostLinks = 16;

enum class FillRule { nonzero, even_odd };

/// Edges that were looked at, by all areas of a drawing together: a small file must not ask for endless work.
using ClipWork = std::shared_ptr<std::size_t>;

/// What lies inside contours, page mm; open ones are closed. Every function throws std::invalid_argument when the work
/// becomes endless.
class Area {
 public:
  Area(const Polylines& contours, FillRule rule, ClipWork work);

  bool contains(Point2 p) const;   ///< the rim too: half the width of a line along it shows
  bool surrounds(Point2 p) const;  ///< not the rim
  /// Parameters of the segment, in (0, 1), at which it crosses the contours; appends them.
  void crossings(Point2 a, Point2 b, std::vector<double>& out) const;
  /// The parts of the closed contours whose edges reach into the box.
  Polylines contours_near(const Rect& box) const;
  const Rect& box() const { return box_; }
  bool empty() const { return edges_.empty(); }

 private:
  struct Edge {
    Point2 a, b;
  };
  enum class Place { outside, rim, inside };
  Place place_of(Point2 p) const;
  std::size_t row(double y) const;

  std::vector<Edge> edges_;
  Rect box_;
  FillRule rule_;
  std::vector<std::vector<std::uint32_t>> rows_;  ///< edges by the part of the height that they meet
  void count(std::size_t edges) const;

  ClipWork work_;
};

/// What shows through one or several clip paths or masks, one inside the other.
struct Clip {
  std::vector<Area> any_of;  ///< inside one of these
  std::vector<char> opens;   ///< of a mask: whether an area shows or hides, the last painted decides; empty: all show
  bool open = false;         ///< the rims of the areas do not belong to it
  std::shared_ptr<const Clip> outer;  ///< and of this; nullptr: nothing more

  bool shows(Point2 p) const;  ///< without the outer ones
};

/// The parts of the lines that show.
Polylines clipped(const Polylines& lines, const Clip& clip);

}  // namespace ligne::svg
