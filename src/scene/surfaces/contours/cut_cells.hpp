#pragma once
/// Cells of a formula's grid that the surface does not fill: where the domain ends, where heights leave a window, and
/// where the function jumps. The surface ends there on the true border, not at the last sample.

#include "scene/surfaces/grids/grid_edges.hpp"
#include "scene/surfaces/height_breaks.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// Irregularities of a function z = f(x, y) that plain sampling can not represent.
struct Irregularity {
  bool breaks = false;  ///< it ends or jumps somewhere
  bool poles = false;   ///< its heights grow without bound somewhere
  bool empty = false;   ///< no sample has a height
  SampleSpan span;
};

/// Examines the samples of a function, and the function itself where neighbouring samples differ irregularly. Steep
/// slopes are distinguished from jumps if the samples resolve them: jumps below a quarter of the neighbouring
/// differences are not searched.
Irregularity find_irregularity(const HeightSource& heights, const HeightFunction& function, const HeightWindow& window = {});

/// Default window of heights for a surface with poles: the range of nine tenths of its samples, extended by half of it
/// on either side, but within the range of all samples.
HeightWindow window_without_poles(const HeightSource& heights);
/// The range of the samples.
HeightWindow window_of_samples(const HeightSource& heights);

/// Cells with an edge on which the surface breaks off (SurfacePoints::left_out), for callers that can not cut them.
std::vector<char> broken_cells(const HeightSource& heights, const HeightFunction& function);

/// make_surface_mesh() of z = f(x, y), with cells cut along the true border of the part whose heights are in the window.
/// `heights`: the source of the surface's samples.
SurfaceMesh make_cut_mesh(const SurfacePoints& surface, const HeightSource& heights, const HeightWindow& window);

}  // namespace ligne
