#pragma once
/// Reads all surfaces of a file. A text may hold several data sets, and meshes whose x, y and z all vary.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "scene/surfaces/height_source.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne {

/// Heights at a grid, or a mesh.
struct GridSurface {
  std::unique_ptr<HeightSource> heights;  ///< null for a mesh
  std::optional<SurfacePoints> mesh;      ///< parametric; rows are the blocks of the file
};

/// The surfaces of a file in its order, at least one. See read_grid().
std::vector<GridSurface> read_surfaces(const std::filesystem::path& file, Warnings& warnings, InputFiles* opened = nullptr,
                                       const GridChoice& choice = {});

}  // namespace ligne
