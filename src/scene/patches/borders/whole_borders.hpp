#pragma once
/// Decides edges that their own two sides leave open: the whole border of a patch decides them.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/find_patches.hpp"

namespace ligne {

/// The evidence of one edge between a patch and another curved surface, be it a patch or a free form, across which the
/// facets bend by at most kLargestBend.
enum class BorderEvidence : std::uint8_t {
  none,     ///< no such edge
  open,     ///< the normals do not decide
  tangent,  ///< both surfaces have one normal there, and different curvatures
  against,  ///< both sides are one surface, or meet at an angle
  angled,   ///< two recognised surfaces meet at the angle of a sharp edge
  alone,    ///< they do, and no edge beside it bends as it does
};

/// Decides edges that are PatchEdge::unknown and have evidence:
/// - Two patches that meet at an angle have a sharp edge if neither of them is a band of a larger free form. A strip between
///   two meridians of a dish lies on a cylinder, but it is such a band: it meets other curved surfaces on both sides. They
///   have one too if nearly all of their edges are alone: the bands of a free form bend on.
/// - A chain of consecutive edges on the border of one patch is tangent if most of its length is, and little of it speaks
///   against that.
/// `evidence` and `edges` are per edge of the topology. O(n log n).
void decide_by_whole_borders(const Scene& scene, const Topology& topology, const Patches& patches,
                             std::span<const BorderEvidence> evidence, std::vector<PatchEdge>& edges);

}  // namespace ligne
