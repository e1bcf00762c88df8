#pragma once
/// From the options of a surface to its samples.

#include <cstddef>
#include <memory>

#include "cli/surface_options.hpp"
#include "scene/height_source.hpp"

namespace ligne {

/// Heights, and every how many samples there is a curve (HorizonOptions).
struct Surface {
  std::unique_ptr<HeightSource> heights;
  std::size_t x_stride = 1, y_stride = 1;
};

/// Throws InputError.
Surface surface_of(const SurfaceOptions& options);

}  // namespace ligne
