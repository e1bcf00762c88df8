#pragma once
/// Coloured areas for visible faces.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "picture/hatching/smooth_tones.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"
#include "view/brightness.hpp"
#include "view/view.hpp"

namespace ligne {

/// Fills for regions, in painting order: regions behind the most transparent faces first. The colour is, for
/// `material`, that of the face; for `shade`, that colour made darker the more obliquely the light falls, darkest
/// without light; for `paper`, white. Without lights, a light behind the viewer to the upper left is assumed.
std::vector<Fill> fill_regions(const Scene& scene, const View& view, const std::vector<Region>& regions,
                               std::span<const Light> lights, FillKind kind);

/// Fills for areas of spans or pixels, which have the colours of fill_regions(). An area behind transparent faces
/// (Region::in_front, a list of `layers`) has the colour that all of them give together on white paper.
std::vector<Fill> fill_areas(const Scene& scene, const View& view, const std::vector<Region>& areas,
                             const TransparentLayers& layers, std::span<const Light> lights, FillKind kind);

/// Fills for pieces in painting order: each piece is an area that covers earlier ones. There are no cast shadows.
std::vector<Fill> fill_pieces(const Scene& scene, const View& view, const PaintOrder& order, std::span<const Light> lights,
                              FillKind kind);

/// The colour of a face, components in [0, 1] in steps of 1/255, as `kind` says: the colour of its material, that
/// colour lit with `light` (0 to 1), white, or a random colour that depends only on the face number.
std::array<double, 3> fill_color(const Point3& material, double light, std::uint32_t face, FillKind kind);

/// Per piece the light on its face, 0 to 1, as fill_pieces() uses it.
std::vector<double> lights_of_pieces(const Scene& scene, const View& view, const PaintOrder& order,
                                     std::span<const Light> lights);

/// Grey fills for areas as in fill_areas(). `brightness`: per face, 0 to 1.
std::vector<Fill> fill_gray(const Scene& scene, const std::vector<Region>& areas, const TransparentLayers& layers,
                            const std::vector<double>& brightness);

/// The light of fills on the points of smooth surfaces; it keeps references to its arguments.
class SmoothFillColors {
 public:
  /// `lights` as for fill_regions().
  SmoothFillColors(const Scene& scene, const Camera& camera, std::span<const Light> lights);
  /// The colour of a point of a face, components in [0, 1]. `surface`: SmoothTones::surface_at().
  std::array<double, 3> of(std::uint32_t face, const std::optional<SurfacePoint>& surface) const;

 private:
  const Scene& scene_;
  Light shoulder_;
  FaceLight light_;
};

/// The material of a face.
const Material& material_of(const Scene& scene, std::uint32_t face);

/// The material of a region: its own if it is part of a detail, else that of its face.
const Material& material_of(const Scene& scene, const Region& region);

}  // namespace ligne
