#pragma once
/// The study of visibility: every facet clipped by those in front of it, and the pieces of a face put together.

#include <cstdint>
#include <functional>
#include <vector>

#include "drawing/result_models.hpp"
#include "visibility/common/cell_grid.hpp"
#include "visibility/common/face_ranks.hpp"
#include "visibility/polygons/facet_clip.hpp"

namespace ligne {

/// A part of a side of a facet that borders a region of the facet's face.
struct BorderPart {
  std::uint32_t side = 0;   ///< see side_source()
  std::uint32_t level = 0;  ///< of the region
  double from = 0, to = 1;  ///< on the segment from the vertex of the lower number
};

struct StudyCounts {
  std::uint64_t compared = 0;     ///< pairs of facets that overlap on the page
  std::uint64_t wrong_sorts = 0;  ///< of them, those in which the one that begins nearer is behind
  std::uint64_t cuts = 0;         ///< pairs that pass through each other
  std::uint64_t ties = 0;         ///< pairs that coincide
  std::uint64_t clips = 0;        ///< clip faces laid over a subject
  std::uint64_t not_listed = 0;   ///< facets behind a cover everywhere
  std::uint64_t by_order = 0;     ///< pairs of facets that an order of the faces decides
  void operator+=(const StudyCounts& o) {
    compared += o.compared;
    wrong_sorts += o.wrong_sorts;
    cuts += o.cuts;
    ties += o.ties;
    clips += o.clips;
    not_listed += o.not_listed;
    by_order += o.by_order;
  }
};

struct VisibleFaces {
  std::vector<Region> regions;      ///< by face
  std::vector<BorderPart> borders;  ///< their borders, but for cuts
  std::vector<std::uint8_t>
      facet_touches;  ///< per facet: somewhere it touches another one that is no neighbour along a side
  StudyCounts counts;
};

/// Appends the regions that these edges bound, and their borders. `several_pieces`: the edges are those of pieces that lie
/// beside each other; what two of these have in common vanishes.
void add_regions(const Lattice& lattice, std::uint32_t face, std::uint32_t level, std::vector<ContourEdge>& edges,
                 bool several_pieces, VisibleFaces& out);

/// `grid` lists the facets of the scene. `progress` may be empty. `ranks`: an order of the faces, which then says for every
/// two whose pieces all stand before each other which is in front; of other pairs, and without it, depths decide.
VisibleFaces find_visible_faces(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                const std::function<void(double)>& progress, const FaceRanks* ranks = nullptr);

}  // namespace ligne
