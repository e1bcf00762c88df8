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
  /// `faces`: all of the object that have one of them, and maybe others, ascending.
  CornerUses(const Scene& scene, const Object& object, std::span<const std::uint32_t> faces,
             const std::vector<std::uint32_t>& vertices);

  /// In the order of the faces.
  std::span<const CornerUse> of(std::uint32_t v) const;

 private:
  std::uint32_t first_vertex_;
  std::vector<std::uint32_t> number_;  ///< per vertex of the object: among those asked for, from 1 on; 0: none of them
  std::vector<std::uint32_t> begin_;   ///< by number: the first use; and the end
  std::vector<CornerUse> uses_;
};

/// Whether the triangle p, before, after turns over, or loses its area, when its corner p goes to q. One without area does
/// not.
bool turns_over(const Point3& p, const Point3& q, const Point3& before, const Point3& after);

}  // namespace ligne
