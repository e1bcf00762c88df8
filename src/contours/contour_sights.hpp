#pragma once
/// Sights: the lines on which the visibility of a contour is computed.
///
/// About half of a contour lies on back faces, or behind a bulge between two vertices. There the nearest triangles of
/// the same surface hide it by a hair. On the page a fold lies entirely on one side of its contour. So the visibility
/// of a segment is computed on a line a little beside it, on the other side, beyond all edges of the mesh's outline
/// near it. No part of the fold is in front of that line, but all other occluders of the contour are.
///
/// The slope of g towards the eye tells the side of the fold: where g grows, the surface curves away from its normal,
/// and the side of the normal is free. The sides change at a cusp: where the fitted surface has one, else where the contour
/// turns back on the page. Where the free side lies inside a solid, the surface of the solid hides the line, as it should.

#include <span>
#include <vector>

#include "base/index_lists.hpp"
#include "contours/contour_choice.hpp"

namespace ligne {

/// The edges of the mesh's outline inside regions, listed by the sectors at their ends.
class OutlineGraph {
 public:
  OutlineGraph(const Scene& scene, const View& view, const SmoothPatch& patch, const std::vector<OutlineSide>& sides);

  struct End {
    std::uint32_t sector, other;  ///< the sectors at this end of the edge and at the other end
    Point2 p, q;                  ///< these two ends on the page
  };
  std::span<const End> at(std::uint32_t sector) const { return ends_[sector]; }

 private:
  ListsOf<End> ends_;
};

/// A list of sectors without duplicates, in the order in which a search reached them. clear() takes constant time.
class ReachedSectors {
 public:
  /// Empties the list. `sectors` is the number of sectors of the patch, the same in each call.
  void clear(std::size_t sectors) {
    place_.resize(sectors, 0);
    first_ += static_cast<std::uint32_t>(reached_.size());
    reached_.clear();
  }
  /// Adds the sector if it is new, and returns its index in the list.
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
  std::vector<std::uint32_t> place_;  ///< per sector: first_ plus its index; less if not reached since the last clear()
  std::vector<std::uint32_t> reached_;
};

/// The line in model space whose visibility is computed for a segment.
struct ContourSight {
  Point3 from, to;
  int side = 1;  ///< side of the contour on which it lies: +1 is the side of the normals, -1 the other
};

/// The scene, view and mesh of all chains of a drawing.
struct SightScene {
  const Scene& scene;
  const View& view;
  const SmoothPatch& patch;
  const OutlineGraph& outline;
  double slack_mm;  ///< smallest distance of a sight beyond the outline of the mesh
};

/// The sights of a chain, one per segment. `reached`: scratch memory, one element per thread.
std::vector<ContourSight> contour_sights(const SightScene& in, const ContourChain& chain,
                                         std::vector<ReachedSectors>& reached);

/// The displacement on the page, mm, of a point that moves from p by one model unit along `n`.
Point2 page_direction(const View& view, const Point3& p, const Point3& n);

}  // namespace ligne
