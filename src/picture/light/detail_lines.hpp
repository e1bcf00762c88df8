#pragma once
/// The contours of the details of faces ([Boulle1980] figure 2.62) as lines.

#include <array>
#include <cstdint>
#include <vector>

#include "scene/model/scene.hpp"

namespace ligne {

struct DetailLine {
  std::array<Point3, 2> ends;
  std::uint32_t face = 0;  ///< of the scene
};

/// Returns the sides of all details, in their order, clipped to their faces, so that holes are left out.
std::vector<DetailLine> detail_lines(const Scene& scene);

}  // namespace ligne
