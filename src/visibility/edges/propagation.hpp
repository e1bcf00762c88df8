#pragma once
/// Carries the number of faces in front of a line from vertex to vertex along the edges, instead of testing every edge.
///
/// As long as an edge pierces and touches nothing, the number changes along it only where it passes behind a side at
/// which a surface turns back or ends. From one edge to the next at their vertex only the faces round that vertex
/// change it. So one edge of a connected set is tested against all faces, and the others only against the sides that
/// they cross and the faces near them in space.
///
/// Uncertain counts are not carried. An edge is tested against all faces if it touches or pierces a face, if it passes
/// exactly through a corner or along a side on the page, or if its ends are cut. So the parts are those of FaceCounter;
/// their ends are equal to the last bit where both are quotients of the same determinants.

#include <cstdint>
#include <vector>

#include "visibility/edges/face_counts.hpp"

namespace ligne {

/// The quantity carried, and the order in which edges are followed.
enum class Propagation : std::uint8_t {
  count,   ///< the number of faces [Appel1967], in rings about the start
  nature,  ///< the set of faces [GalimbertiMontanari1969]; it changes at every side of a face
  path,    ///< the number of faces, depth first from the nearest vertex: a path continues at the end of each edge
           ///< [Loutrel1970]
};

struct PropagationCounts {
  std::uint64_t tested = 0;    ///< edges tested against all faces
  std::uint64_t carried = 0;   ///< edges with counts carried from one end
  std::uint64_t in_doubt = 0;  ///< tested edges from which no count is carried on
  std::uint64_t facets = 0;    ///< tests of a line against a facet, for the tested edges
  std::uint64_t near = 0;      ///< tests of a line against a facet near it, for all edges
  std::uint64_t sides = 0;     ///< tests of a line against a side
};

/// Returns the parts of each candidate edge, by its number. Edges seen end on have none.
std::vector<std::vector<CountedPart>> propagate(const ProjectedScene& scene, const FacetForest& forest,
                                                double coincidence_steps, Propagation kind, PropagationCounts& counts);

}  // namespace ligne
