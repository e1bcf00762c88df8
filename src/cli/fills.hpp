#pragma once
/// Regions as areas of colour, or hatched.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "scene/scene.hpp"
#include "view/view.hpp"

namespace CLI {
class App;
}

namespace ligne {

class Method;

enum class FillKind : std::uint8_t { none, material, shade, hatch };
inline constexpr std::string_view kFillNames[] = {"none", "material", "shade", "hatch"};

struct FillOptions {
  FillKind kind = FillKind::none;
  std::vector<Point3> lights;  ///< directions in which parallel light travels

  bool asked() const { return kind != FillKind::none || !lights.empty(); }
};

void add_fill_options(CLI::App& app, FillOptions& options);

/// The first method of the registry that gives regions.
const Method& region_method();

/// Lights that cast shadows: those of the options; without any, those of the scene when it is filled by shade or hatched, or borders of
/// shadows are drawn.
std::vector<Light> lights_of(const FillOptions& options, bool shadow_lines, const Scene& scene);

/// Colours of the regions, in painting order: those seen through most transparent faces first. `material`: the face's colour; `shade`: darker
/// as the light comes in flatter, darkest where no light comes. Without lights a light stands behind the viewer, to the upper left.
std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions, std::span<const Light> lights,
                               FillKind kind);

/// Regions that are seen directly, as parallel lines: the darker the closer, lit parts at 45 degrees, what no light reaches crossed.
Polylines hatch_regions(const Scene& scene, const View& view, const std::vector<Region>& regions, std::span<const Light> lights,
                        double pen_width_mm);

}  // namespace ligne
