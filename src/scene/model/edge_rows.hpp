#pragma once
/// Rows of edges side by side, as tessellators cut a curved surface into facets.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "base/no_index.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

/// How much the edges of a row may differ.
struct RowBends {
  double least, most;  ///< their angles, as fractions of the angle of the first one
  double cosine;       ///< least cosine of the angle between consecutive ones
};
/// The edges of a rounding: coarse meshes of smooth surfaces bend unevenly (37 degrees). Adjustable.
inline constexpr RowBends kRoundingBends{0.4, 1e300, 0.8};
/// The edges of one even row (25 degrees). Adjustable.
inline constexpr RowBends kEvenBends{1 / 1.4, 1.4, 0.9};

/// Walks from an edge to the edges beside it that are nearly parallel and bend to the same side.
class EdgeRows {
 public:
  /// `normals` are those of face_normals().
  EdgeRows(const Scene& scene, const Topology& topology, std::span<const glm::vec3> normals)
      : scene_(scene), topology_(topology), normals_(normals) {}

  /// An edge of a row, and its face on the side to which the row goes on.
  struct Step {
    std::uint32_t edge = kNone, face = kNone;
    double distance = 0;  ///< from the edge before, model units
    double angle = 0;     ///< at the first edge of the row, radians; 0 at that edge itself
    explicit operator bool() const { return edge != kNone; }
  };

  /// The next edge of the row: of the edges of the face and of those beside it, the most nearly parallel one that bends
  /// alike. None at a face of many sides, and where edges bend as those of polygons do. O(log n).
  Step next(const Step& from, const RowBends& bends) const;

  /// The next edges on both sides of an edge; nothing if one is missing or the edge has not exactly two faces.
  std::optional<std::array<Step, 2>> beside(std::uint32_t edge, const RowBends& bends) const;

  /// Angle between the two faces of an edge in radians, seen from one of them: positive where the other falls away.
  double bend(std::uint32_t edge, std::uint32_t face) const;

 private:
  struct Turn {
    Point3 across{0, 0, 0};       ///< cross product of the normals
    double sine = 0, cosine = 0;  ///< of the angle between the faces
  };
  Turn turn_at(std::uint32_t edge, std::uint32_t face) const;
  double signed_angle(const Turn& turn, std::uint32_t edge, std::uint32_t face) const;
  Point3 along(std::uint32_t edge) const;

  const Scene& scene_;
  const Topology& topology_;
  std::span<const glm::vec3> normals_;
};

}  // namespace ligne
