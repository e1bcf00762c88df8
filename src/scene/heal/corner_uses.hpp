#pragma once
/// Finds the faces around a vertex.

#include <cstdint>
#include <span>
#include <vector>

#include "base/index_lists.hpp"
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
  /// `faces`: ascending; all faces of the object that have one of the vertices, and possibly others.
  CornerUses(const Scene& scene, const Object& object, std::span<const std::uint32_t> faces,
             const std::vector<std::uint32_t>& vertices);

  /// The uses of a vertex, in the order of the faces.
  std::span<const CornerUse> of(std::uint32_t v) const { return uses_[number_[v - first_vertex_]]; }

 private:
  std::uint32_t first_vertex_;
  std::vector<std::uint32_t> number_;  ///< per vertex of the object: its number, from 1 on; 0: not requested
  ListsOf<CornerUse> uses_;            ///< per number
};

/// Whether the triangle p, before, after turns over or loses its area when its corner p moves to q. False for a
/// needle that may have had no area before its coordinates were rounded to `precision`.
bool turns_over(const Point3& p, const Point3& q, const Point3& before, const Point3& after, double precision);

}  // namespace ligne
