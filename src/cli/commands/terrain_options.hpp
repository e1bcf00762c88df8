#pragma once
/// Options for maps: contour labels, water, hachures, scale bar, north arrow; curves, points, colours and names.

#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

void add_terrain_options(CLI::App& surface, SurfaceRequest& request);
void add_annotation_options(CLI::App& surface, SurfaceRequest& request);

}  // namespace ligne
