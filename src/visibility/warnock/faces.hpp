#pragma once
/// The faces of a study: contours, planes, depths, and their order from near to far (the initial sort of the method).

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/common/facet.hpp"
#include "visibility/warnock/convex_window.hpp"

namespace ligne::warnock {

/// A directed side of a contour, as projected vertices: the face lies on its positive side.
struct Side {
  std::uint32_t v0 = 0, v1 = 0;
};

/// A range of depths.
struct DepthRange {
  double near = 0, far = 0;
};

/// A planar face on the page. Its contours are the sides of exactly one of its facets, so a triangulated face, with or
/// without holes, has its true contours without cuts.
struct Face {
  std::uint32_t face = 0;                        ///< number in the scene
  std::uint32_t facet_begin = 0, facet_end = 0;  ///< range in FaceTable::facet_order
  std::uint32_t side_begin = 0, side_end = 0;    ///< range in FaceTable::sides
  float z_near = 0, z_far = 0;                   ///< depth range of all corners
  float slack = 0;                               ///< depth tolerance plus the largest distance of a facet from the plane
  FramePoint base;                               ///< a point of the plane; below: its depth, and the gradient per frame unit
  double base_z = 0, gu = 0, gv = 0;
  Window box;  ///< bounding box of the projection

  double z(double u, double v) const { return base_z + gu * (u - base.u) + gv * (v - base.v); }
  /// Bounds of the face's depth where it lies over the window.
  DepthRange depths_over(const Window& window) const;
  /// Bounds of its depth over a convex window that is larger by `margin` frame units.
  DepthRange depths_over(const ConvexWindow& window, double margin) const;
};

struct FaceTable {
  std::vector<Face> faces{};  ///< in the order of their first facets: faces adjacent on the page lie close together
  std::vector<std::uint32_t> by_depth{};     ///< indices of faces, sorted by z_near, then by face number
  std::vector<std::uint32_t> facet_order{};  ///< facets grouped by face
  std::vector<Side> sides{};
  const std::vector<Facet>* facets = nullptr;
  const std::vector<ProjectedVertex>* vertices = nullptr;
  WindowFrame frame{};

  std::span<const Side> sides_of(const Face& f) const { return {sides.data() + f.side_begin, sides.data() + f.side_end}; }
  std::span<const std::uint32_t> facets_of(const Face& f) const {
    return {facet_order.data() + f.facet_begin, facet_order.data() + f.facet_end};
  }
  FramePoint at(std::uint32_t vertex) const { return frame((*vertices)[vertex].p); }
};

/// `facets` and the scene must outlive the table.
FaceTable make_faces(const ProjectedScene& scene, const std::vector<Facet>& facets, const WindowFrame& frame);

}  // namespace ligne::warnock
