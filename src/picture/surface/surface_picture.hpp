#pragma once
/// Pictures of surfaces z = f(x, y) and of parametric ones.

#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/surface/surface_request.hpp"
#include "picture/surface/surface_samples.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// The drawing of the floating horizon, to be written in any format but JSON.
struct HorizonDrawing {
  Drawing drawing;
  Page page;
  PictureRequest picture;  ///< what write_horizon() looks at
};

/// Draws a surface for which drawn_by_horizon() holds; nothing where it ends or jumps inside and is for a mesh, which can be
/// cut there. Throws as draw_surface().
/// `surfaces`: those of surfaces_of(), which are used up when something is drawn.
std::optional<HorizonDrawing> draw_horizon(const SurfaceRequest& request, std::vector<Surface>& surfaces, RunReport& run);
Picture write_horizon(const HorizonDrawing& drawn, RunReport& run);

/// Whether the floating horizon draws these: one surface z = f(x, y). Throws RequestError for options that it alone knows
/// when a file turns out to hold others.
bool drawn_by_horizon(const SurfaceRequest& request, const std::vector<Surface>& surfaces);

/// Draws the surfaces by the floating horizon where it can, else as meshes. Warnings go to `run`, as do the grids that were
/// read. Throws RequestError, InputError, std::runtime_error.
Picture draw_surface(const SurfaceRequest& request, RunReport& run);

}  // namespace ligne
