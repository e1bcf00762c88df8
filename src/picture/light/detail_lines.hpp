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

/// The sides of all details, in their order; of each what lies on its face, and so not in a hole.
std::vector<DetailLine> detail_lines(const Scene& scene);

}  // namespace ligne
