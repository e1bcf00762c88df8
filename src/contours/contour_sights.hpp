#pragma once
/// Where the visibility of a contour is studied.
///
/// About half of a contour lies on triangles that look away, or behind a bulge between two vertices: there the nearest
/// triangles of the same surface hide it by a hair. On the page all of a fold lies on one side of its contour. So a segment
/// is studied a little beside it, on the other side, beyond all edges of the mesh's outline near it. There nothing of the
/// fold is in front, and what else is in front of the contour still is.
///
/// Which side the fold lies on follows from the slope of g towards the eye: where g grows, the surface curves away from its
/// normal, and the side of the normal is free. At a cusp of the contour that changes. The part of the contour whose free
/// side lies inside a solid is hidden by the solid's surface, as it should be.

#include <span>
#include <vector>

#include "contours/contour_choice.hpp"

namespace ligne {

/// The edges of the mesh's outline inside regions, by the sectors at their ends.
class OutlineGraph {
 public:
  OutlineGraph(const Scene& scene, const View& view, const SmoothPatch& patch, const std::vector<OutlineSide>& sides);

  struct End {
    std::uint32_t sector, other;  ///< sectors at this end of the edge and at the other
    Point2 p, q;                  ///< of these ends, on the page
  };
  std::span<const End> at(std::uint32_t sector) const {
    return {ends_.data() + begin_[sector], ends_.data() + begin_[sector + 1]};
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<End> ends_;
};

/// Sectors in the order in which they were reached, each once.
class ReachedSectors {
 public:
  /// `sectors`: how many there are, the same each time.
  void clear(std::size_t sectors) {
    place_.resize(sectors, 0);
    first_ += static_cast<std::uint32_t>(reached_.size());
    reached_.clear();
  }
  /// The place of a sector among those reached.
  std::size_t add(std::uint32_t sector) {
    std::uint32_t& place = place_[sector];
    if (place < first_) {
      place = first_ + static_cast<std::uint32_t>(reached_.size());
      reached_.push_back(sector);
    }
    return place - first_;
  }
  std::size_t size() const { return reached_.size(); }
  std::uint32_t operator[](std::size_t place) const { return reached_[place]; }

 private:
  std::uint32_t first_ = 1;
  std::vector<std::uint32_t> place_;  ///< less than `first_`: not reached since the last clear()
  std::vector<std::uint32_t> reached_;
};

/// The line in model space that is studied for a segment, and on which side of the contour it lies.
struct ContourSight {
  Point3 from, to;
  int side = 1;  ///< +1 on that of the normals
};

/// The surroundings of all chains of a drawing.
struct SightScene {
  const Scene& scene;
  const View& view;
  const SmoothPatch& patch;
  const OutlineGraph& outline;
  double slack_mm;  ///< the least distance of a line from the outline of the mesh, outside of it
};

/// Per segment of the chain. `reached`: for each thread, serves one chain after the other.
std::vector<ContourSight> contour_sights(const SightScene& in, const ContourChain& chain,
                                         std::vector<ReachedSectors>& reached);

/// The move on the page, mm, for a step of one unit along `n` from p.
Point2 page_direction(const View& view, const Point3& p, const Point3& n);

}  // namespace ligne
