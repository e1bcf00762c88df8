#pragma once
/// Draws pictures of surfaces z = f(x, y) and of parametric surfaces.

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/surface/surface_request.hpp"
#include "picture/surface/surface_samples.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// A drawing of the floating horizon, to be written in any format except JSON.
struct HorizonDrawing {
  Drawing drawing;
  Page page;
  PictureRequest picture;  ///< the request for write_horizon()
};

/// Draws a surface for which drawn_by_horizon() holds. Returns nothing if the surface ends or jumps inside, because a
/// mesh can be cut there. Throws as draw_surface(). `surfaces`: result of surfaces_of(); a drawing consumes it.
std::optional<HorizonDrawing> draw_horizon(const SurfaceRequest& request, std::vector<Surface>& surfaces, RunReport& run);
Picture write_horizon(const HorizonDrawing& drawn, RunReport& run);

/// Whether the floating horizon draws the surfaces: it draws a single surface z = f(x, y). Throws RequestError if a
/// file has other surfaces but an option works for the horizon only.
bool drawn_by_horizon(const SurfaceRequest& request, const std::vector<Surface>& surfaces);

/// Draws the surfaces by the floating horizon if it can draw them, else as meshes. Adds warnings and the grids read to
/// `run`. Throws RequestError, InputError, std::runtime_error.
Picture draw_surface(const SurfaceRequest& request, RunReport& run);

}  // namespace ligne
