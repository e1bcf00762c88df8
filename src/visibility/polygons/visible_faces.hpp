#pragma once
/// Finds the visible regions of all faces: clips every facet by the facets in front of it, and joins the pieces of each
/// face.

#include <cstdint>
#include <functional>
#include <vector>

#include "base/add_counts.hpp"
#include "drawing/result_models.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/face_ranks.hpp"
#include "visibility/polygons/facet_clip.hpp"

namespace ligne {

/// A part of a side of a facet that borders a region of the facet's face.
struct BorderPart {
  std::uint32_t side = 0;   ///< see side_source()
  std::uint32_t level = 0;  ///< of the region
  double from = 0, to = 1;  ///< parameters on the segment from the vertex of the lower number
};

struct StudyCounts {
  std::uint64_t compared = 0;     ///< pairs of facets that overlap on the page
  std::uint64_t wrong_sorts = 0;  ///< compared pairs in which the facet that begins nearer is behind
  std::uint64_t cuts = 0;         ///< pairs that penetrate each other
  std::uint64_t ties = 0;         ///< pairs that coincide
  std::uint64_t clips = 0;        ///< clip faces laid over a subject
  std::uint64_t not_listed = 0;   ///< facets behind a cover everywhere
  std::uint64_t by_order = 0;     ///< pairs of facets that an order of the faces decides
  void operator+=(const StudyCounts& o) { add_counts(*this, o); }
};

struct VisibleFaces {
  std::vector<Region> regions;              ///< by face
  std::vector<BorderPart> borders;          ///< the borders of the regions, except cuts
  std::vector<std::uint8_t> facet_touches;  ///< per facet: 1 if it touches a facet that is not its neighbour along a side
  StudyCounts counts;

  /// Appends the regions and borders of parts, and sorts the regions by face.
  void append(std::vector<VisibleFaces>& parts);
};

/// Appends the regions that these edges bound, and their borders. `several_pieces`: the edges bound several adjacent
/// pieces, whose common borders are removed.
void add_regions(const Lattice& lattice, std::uint32_t face, std::uint32_t level, std::vector<ContourEdge>& edges,
                 bool several_pieces, VisibleFaces& out);

/// `grid` lists the facets of the scene. `progress` may be empty. `ranks` is an order of the faces. It decides for two
/// faces if all pieces of one come before all pieces of the other; depths decide for other pairs, and without it.
VisibleFaces find_visible_faces(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                const std::function<void(double)>& progress, const FaceRanks* ranks = nullptr);

}  // namespace ligne
