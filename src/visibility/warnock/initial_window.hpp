#pragma once
/// The first window, and the axes of all windows.

#include "view/projected_scene.hpp"
#include "visibility/warnock/convex_window.hpp"

namespace ligne::warnock {

enum class WindowChoice : std::uint8_t {
  screen,     ///< the visible part of the sheet
  bounding,   ///< the smallest axis-parallel square round the scene
  principal,  ///< the smallest rectangle of any direction round the scene; all windows share its axes
};

struct InitialWindow {
  WindowFrame frame;
  Window window;
};

/// Contains all vertices of the scene. Empty for a scene without vertices.
InitialWindow initial_window(const ProjectedScene& scene, WindowChoice choice);

/// Direction of a side of the smallest rectangle round the points; one side of it lies on a side of their convex hull
/// (Freeman and Shapira 1975). |a|, |b| <= 2^25, rotated into the first quadrant. (1, 0) if all points coincide.
WindowFrame principal_frame(const std::vector<ProjectedVertex>& vertices);

}  // namespace ligne::warnock
