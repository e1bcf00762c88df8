#pragma once
/// Classifies the edges of a mesh by the surfaces on both sides.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/patches/find_patches.hpp"

namespace ligne {

/// The relation of the surfaces on both sides of an edge.
enum class PatchEdge : std::uint8_t {
  unknown,  ///< not decided here: between free forms, beside a free form that gives no evidence, at an angle above
            ///< kLargestBend, between recognised surfaces that meet at an angle, or not at exactly two faces
  inside,   ///< both sides are one surface, or two that join smoothly with similar curvature
  tangent,  ///< two surfaces, at least one of them curved, join smoothly
  sharp,    ///< two surfaces, at least one of them a plane or a free form, meet at an angle
};

/// Smallest angle between surfaces that makes an edge, in degrees. Taste: drawings of machine parts leave out smaller
/// ones.
inline constexpr double kSurfaceCreaseDegrees = 10;

/// Least bend between facets that may be a crease by the rules for meshes, in degrees: half of the default angle, at
/// which creases continue.
inline constexpr double kMeshBend = 15;

/// Smallest difference of the curvatures across an edge, as a fraction of the largest curvature of both surfaces, that
/// makes a tangent line between surfaces that join smoothly. A fillet along a curve consists of several tori with
/// similar curvatures, and gets no lines across it. Taste.
inline constexpr double kLikeCurvature = 0.1;

/// Classifies the edges of the topology by the normals of the surfaces at both ends of each edge. Normals of free forms
/// are extrapolated to their borders (freeform_borders.hpp). Faces without a patch or a free form are planes.
/// `sharp_degrees` is the smallest angle of a sharp edge.
std::vector<PatchEdge> classify_patch_edges(const Scene& scene, const Topology& topology, const MeshAngles& angles,
                                            const Patches& patches, double sharp_degrees);

/// Sets Patch::is_band of the patches that continue into another patch across most of their common border, which is neither
/// a line nor sharp there; but not of fillets that meet at a mitre.
void mark_bands(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals,
                std::span<const PatchEdge> edges, Patches& patches);

/// Turns loose tangent edges into PatchEdge::inside. A line between curved surfaces is loose if no other line begins at
/// either of its ends: bands of a free form have such borders. Elsewhere only short chains with a free end are removed, as
/// flecks, and connected edges that meet no other line, enclose nothing and are short for their object. Before that, lines
/// with teeth are removed, which follow the facets of a free form in steps. `is_line`: per edge, 1 if it is another line.
/// O(n log n).
void drop_loose_tangents(const Scene& scene, const Topology& topology, const Patches& patches,
                         const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges);

}  // namespace ligne
