#pragma once
/// Pairs of faces that concern each other.

#include <cstdint>
#include <vector>

#include "visibility/common/facet.hpp"

namespace ligne {

/// Each pair as lower face << 32 | higher face; ascending, each once.
struct FacePairs {
  std::vector<std::uint64_t> overlapping;  ///< they have a part of the page in common
  std::vector<std::uint64_t> penetrating;  ///< they pass through each other
  bool complete = true;                    ///< all of them; false where there were too many to look at
};

/// Facets are those of the scene. At most some millions of pairs of facets are looked at, cell by cell of a grid over the
/// page.
FacePairs find_face_pairs(const ProjectedScene& scene, const std::vector<Facet>& facets, double coincidence_steps);

}  // namespace ligne
