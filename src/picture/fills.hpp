#pragma once
/// Regions as areas of colour.

#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace ligne {

/// Colours of the regions, in painting order: those seen through most transparent faces first. `material`: the face's
/// colour; `shade`: darker as the light comes in flatter, darkest where no light comes; `paper`: white. Without lights a
/// light stands behind the viewer, to the upper left.
std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions,
                               std::span<const Light> lights, FillKind kind);

/// Fills by an order of painting: every piece an area of its own, over those before it. Nothing casts a shadow.
std::vector<Fill> fill_pieces(const Scene& scene, const View& view, const PaintOrder& order, std::span<const Light> lights,
                              FillKind kind);

/// Regions seen directly in the gray of the brightness of their faces (0 to 1).
std::vector<Fill> fill_gray(const std::vector<Region>& regions, const std::vector<double>& brightness);

/// The material of a face.
Material material_of(const Scene& scene, std::uint32_t face);

/// The material of a region: its own where it is part of a detail, else that of its face.
Material material_of(const Scene& scene, const Region& region);

}  // namespace ligne
