#pragma once
/// Faces laid straight onto the lattice, for tests of the modules of the method warnock.

#include <utility>
#include <vector>

#include "visibility/warnock/control.hpp"
#include "visibility/warnock/initial_window.hpp"

namespace ligne::test {

/// A corner: lattice steps and depth in mm.
struct Corner {
  std::int32_t x, y;
  double z;
};

/// A few faces, and all that the modules ask of them.
class Stage {
 public:
  Stage() { scene_.lattice.step_mm = 0x1p-17; }

  /// A convex face (or a fan from its first corner that covers it); returns its number.
  std::uint32_t add(const std::vector<Corner>& corners) {
    const std::uint32_t face = faces_++;
    const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
    for (const Corner& c : corners) scene_.vertices.push_back({{c.x, c.y}, c.z});
    for (std::uint32_t i = 2; i < corners.size(); ++i) scene_.triangles.push_back({{first, first + i - 1, first + i}, face});
    return face;
  }

  /// Upright rectangle of one depth.
  std::uint32_t add_rectangle(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, double z) {
    return add({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
  }

  /// A rectangle with a rectangular hole: eight triangles round it.
  std::uint32_t add_frame(std::int32_t outer, std::int32_t inner, double z) {
    const std::uint32_t face = faces_++;
    const auto v = static_cast<std::uint32_t>(scene_.vertices.size());
    for (const std::int32_t r : {outer, inner}) {
      for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        scene_.vertices.push_back({{sx * r, sy * r}, z});
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t k = (i + 1) % 4;
      scene_.triangles.push_back({{v + i, v + k, v + 4 + i}, face});
      scene_.triangles.push_back({{v + k, v + 4 + k, v + 4 + i}, face});
    }
    return face;
  }

  /// Call once, when all faces are there.
  const warnock::FaceTable& table(const warnock::WindowFrame& frame = {}) {
    facets_ = make_facets(scene_, 1);
    table_ = warnock::make_faces(scene_, facets_.facets, frame);
    return table_;
  }

  const warnock::Face& face(std::uint32_t number) const {
    for (const warnock::Face& f : table_.faces) {
      if (f.face == number) return f;
    }
    return table_.faces.front();
  }

  ProjectedScene& scene() { return scene_; }

 private:
  ProjectedScene scene_;
  Facets facets_;
  warnock::FaceTable table_;
  std::uint32_t faces_ = 0;
};

}  // namespace ligne::test
