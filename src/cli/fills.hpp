#pragma once
/// Regions as areas of colour.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "scene/model/scene.hpp"
#include "view/view.hpp"

namespace CLI {
class App;
}

namespace ligne {

enum class FillKind : std::uint8_t { none, material, shade };
inline constexpr std::string_view kFillNames[] = {"none", "material", "shade"};

struct FillOptions {
  FillKind kind = FillKind::none;
  std::vector<Point3> lights;  ///< directions in which parallel light travels

  bool asked() const { return kind != FillKind::none || !lights.empty(); }
};

void add_fill_options(CLI::App& app, FillOptions& options);

/// Lights that cast shadows: those of the options; without any, and when shadows are `cast`, those of the scene.
std::vector<Light> lights_of(const FillOptions& options, const Scene& scene, bool cast);

/// Colours of the regions, in painting order: those seen through most transparent faces first. `material`: the face's
/// colour; `shade`: darker as the light comes in flatter, darkest where no light comes. Without lights a light stands behind
/// the viewer, to the upper left.
std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions,
                               std::span<const Light> lights, FillKind kind);

/// The material of a face.
Material material_of(const Scene& scene, std::uint32_t face);

/// The material of a region: its own where it is part of a detail, else that of its face.
Material material_of(const Scene& scene, const Region& region);

}  // namespace ligne
