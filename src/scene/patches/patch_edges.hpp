#pragma once
/// Edges of a mesh as borders between the surfaces that it stands for.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/patches/find_patches.hpp"

namespace ligne {

enum class PatchEdge : std::uint8_t {
  unknown,  ///< between free forms, beside one that tells nothing, of a bend larger than one surface makes, or of other
            ///< than two faces
  inside,   ///< of one surface, or of two that run into each other and bend alike
  tangent,  ///< two surfaces, one of them curved, run into each other
  sharp,    ///< two surfaces, one of them a plane or a free form, meet at an angle
};

/// Angle from which on surfaces that meet make an edge, in degrees. Taste: drawings of parts leave out flatter bends.
inline constexpr double kSurfaceCreaseDegrees = 10;

/// Surfaces that run into each other have a line between them when their curvatures across the edge differ by more than this
/// part of the largest curvature of either: a fillet along a curve is made of several tori, and has no lines across. Taste.
inline constexpr double kLikeCurvature = 0.1;

/// Classifies the edges of the topology by the normals of the surfaces at both of their ends, those of free forms continued
/// to their borders (freeform_borders.hpp). Faces of no patch and no free-form region are planes. `normals` are those of
/// face_normals().
std::vector<PatchEdge> classify_patch_edges(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals,
                                            const Patches& patches, double sharp_degrees);

/// Marks patches that run on into others (Patch::is_band): over an edge that is neither a line nor a sharp bend.
void mark_bands(const Topology& topology, std::span<const glm::vec3> normals, std::span<const PatchEdge> edges,
                Patches& patches);

/// Takes tangent edges out (they are PatchEdge::inside then) that end where no other line begins, and what ends there
/// without them: their surfaces go over into a free form there. `is_line`: per edge whether it is another line. O(n log n).
void drop_loose_tangents(const Topology& topology, const std::vector<std::uint8_t>& is_line, std::vector<PatchEdge>& edges);

}  // namespace ligne
