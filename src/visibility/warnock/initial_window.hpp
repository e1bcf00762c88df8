#pragma once
/// The first window, and the axes of all.

#include "view/projected_scene.hpp"
#include "visibility/warnock/window.hpp"

namespace ligne::warnock {

enum class WindowChoice : std::uint8_t {
  screen,     ///< the sheet, as far as the study sees it
  bounding,   ///< the smallest upright square round the scene
  principal,  ///< the smallest rectangle of any direction round the scene; all windows are turned with it
};

struct InitialWindow {
  WindowFrame frame;
  Window window;
};

/// Holds all vertices of the scene. A scene without vertices has an empty window.
InitialWindow initial_window(const ProjectedScene& scene, WindowChoice choice);

/// Direction of a side of the smallest rectangle round the points, which touches a side of their convex hull (Freeman and
/// Shapira 1975): |a|, |b| <= 2^25, turned into the first quadrant. (1, 0) when the points lie in one place.
WindowFrame principal_frame(const std::vector<ProjectedVertex>& vertices);

}  // namespace ligne::warnock
