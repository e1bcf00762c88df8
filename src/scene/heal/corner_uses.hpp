#pragma once
/// The faces round a vertex.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

/// A corner of a face, and the vertices before and after it on its contour.
struct CornerUse {
  std::uint32_t vertex, before, after;
  std::uint32_t face;
  bool triangle;
};

/// The corners of some vertices of an object.
class CornerUses {
 public:
  CornerUses(const Scene& scene, const Object& object, const std::vector<std::uint32_t>& vertices);

  /// In the order of the faces.
  std::span<const CornerUse> of(std::uint32_t v) const;

 private:
  std::vector<CornerUse> uses_;  ///< by vertex
};

/// Whether the triangle p, before, after turns over, or loses its area, when its corner p goes to q. One without area does
/// not.
bool turns_over(const Point3& p, const Point3& q, const Point3& before, const Point3& after);

}  // namespace ligne
