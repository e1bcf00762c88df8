#pragma once
/// Cells of a formula's grid that its surface does not fill: where the domain ends, where heights leave a window, and where
/// the function jumps. The surface ends there on the true border, not at the last sample.

#include <optional>

#include "scene/surfaces/grids/grid_edges.hpp"
#include "scene/surfaces/height_breaks.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// A place where sampling can not show a function z = f(x, y).
struct Irregularity {
  bool breaks = false;  ///< it ends or jumps somewhere
  bool poles = false;   ///< heights grow beyond bounds there
  bool empty = false;   ///< no sample has a height
  SampleSpan span;
};

/// Looks at the samples of a function, and at the function where neighbouring samples are not in step. Steps of samples are
/// told from jumps as long as they are resolved: a jump that is smaller than a quarter of the steps beside it is not looked
/// for.
Irregularity find_irregularity(const HeightSource& heights, const HeightFunction& function, const HeightWindow& window = {});

/// Heights to which a surface with poles is cut when nothing is said: what nine tenths of its samples span, and half of that
/// more on either side, but no more than all span.
HeightWindow window_without_poles(const HeightSource& heights);
/// The window that the samples span.
HeightWindow window_of_samples(const HeightSource& heights);

/// Cells that have an edge on which the surface breaks off (SurfacePoints::left_out), for who can not cut them.
std::vector<char> broken_cells(const HeightSource& heights, const HeightFunction& function);

/// make_surface_mesh() of z = f(x, y) with cells cut along the true borders of what counts in the window. `heights` are
/// those of the surface.
SurfaceMesh make_cut_mesh(const SurfacePoints& surface, const HeightSource& heights, const HeightWindow& window);

}  // namespace ligne
