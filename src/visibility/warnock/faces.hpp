#pragma once
/// The faces of a study: contours, planes and depths, and their order from near to far (the initial sort of the method).

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/warnock/window.hpp"

namespace ligne::warnock {

/// A directed side of a contour, as projected vertices: the face lies on its positive side.
struct Side {
  std::uint32_t v0 = 0, v1 = 0;
};

/// Depths between two bounds.
struct DepthRange {
  double near = 0, far = 0;
};

/// A plane face on the page. Its contours are the sides that only one of its facets has, so that a face with holes, or one
/// that was cut into triangles, has its true contours and no cuts.
struct Face {
  std::uint32_t face = 0;                        ///< of the scene
  std::uint32_t facet_begin = 0, facet_end = 0;  ///< in FaceTable::facet_order
  std::uint32_t side_begin = 0, side_end = 0;    ///< in FaceTable::sides
  float z_near = 0, z_far = 0;                   ///< of all its corners
  float slack = 0;                               ///< depth tolerance, and how far its facets are off its plane
  FramePoint base;                               ///< a point of the plane, its depth there, and the gradient by frame unit
  double base_z = 0, gu = 0, gv = 0;
  Window box;  ///< of its projection

  double z(double u, double v) const { return base_z + gu * (u - base.u) + gv * (v - base.v); }
  /// Bounds of the depth of the face where it lies over the window.
  DepthRange depths_over(const Window& window) const;
};

struct FaceTable {
  std::vector<Face> faces;              ///< in the order of their first facets: neighbours on the page are neighbours here
  std::vector<std::uint32_t> by_depth;  ///< indices of faces by z_near, then by number of the face
  std::vector<std::uint32_t> facet_order;  ///< facets, those of a face in one range
  std::vector<Side> sides;
  const std::vector<Facet>* facets = nullptr;
  const std::vector<ProjectedVertex>* vertices = nullptr;
  WindowFrame frame;

  std::span<const Side> sides_of(const Face& f) const { return {sides.data() + f.side_begin, sides.data() + f.side_end}; }
  std::span<const std::uint32_t> facets_of(const Face& f) const {
    return {facet_order.data() + f.facet_begin, facet_order.data() + f.facet_end};
  }
  FramePoint at(std::uint32_t vertex) const { return frame((*vertices)[vertex].p); }
};

/// `facets` and the scene must outlive the table.
FaceTable make_faces(const ProjectedScene& scene, const std::vector<Facet>& facets, const WindowFrame& frame);

}  // namespace ligne::warnock
