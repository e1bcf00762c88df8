#pragma once
/// The number of faces before a line carried from vertex to vertex along the edges, in place of a test of every edge.
///
/// Along an edge the number changes where the edge passes behind a side at which a surface turns back or ends, and nowhere
/// else, as long as the edge pierces and touches nothing. From one edge to the next at their vertex it changes by the faces
/// round the vertex alone. So one edge of a connected set is tested against all faces, and the others against the sides that
/// they cross, and the faces that are near to them in space.
///
/// Counts that are not certain are not carried: an edge that touches or pierces a face, that passes exactly through a corner
/// or along a side on the page, or whose ends are cut, is tested against all faces. So the parts found are those of
/// FaceCounter, and every place that is hidden is the same to the last bit where both ends are quotients of the same
/// determinants.

#include <cstdint>
#include <vector>

#include "visibility/edges/face_counts.hpp"

namespace ligne {

/// The quantity that is carried, and the order in which edges are followed.
enum class Propagation : std::uint8_t {
  count,   ///< the number of faces [Appel1967], in rings about the start
  nature,  ///< the set of faces [GalimbertiMontanari1969]; it changes at every side of a face
  path,    ///< the number of faces along a path that goes on at the end of each edge, from the nearest vertex [Loutrel1970]
};

struct PropagationCounts {
  std::uint64_t tested = 0;    ///< edges against all faces
  std::uint64_t carried = 0;   ///< edges by what was known at one end
  std::uint64_t in_doubt = 0;  ///< of the tested ones, those of which nothing is carried on
  std::uint64_t facets = 0;    ///< line against facet, for the tested edges
  std::uint64_t near = 0;      ///< line against facet near it, for all edges
  std::uint64_t sides = 0;     ///< line against side
};

/// The parts of each candidate edge, by its number; none of those seen end on.
std::vector<std::vector<CountedPart>> propagate(const ProjectedScene& scene, const FacetForest& forest,
                                                double coincidence_steps, Propagation kind, PropagationCounts& counts);

}  // namespace ligne
