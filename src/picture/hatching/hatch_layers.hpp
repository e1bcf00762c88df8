#pragma once
/// The layers of hatching: one, or one for each shade or material that selects pens.

#include <string>
#include <vector>

#include "picture/hatching/hatching.hpp"

namespace ligne {

/// Collects the layers. It refers to the scene.
class HatchLayers {
 public:
  explicit HatchLayers(const HatchScene& hatch) : hatch_(hatch) {}

  /// Width of the pen that draws this layer, in mm.
  double pen_mm(unsigned shade, const std::string& material) const;
  double pen_mm(const Layer& layer) const { return pen_mm(layer.shade, layer.material); }
  /// The layer's number. Shades and materials have layers of their own only if they select pens.
  std::uint32_t number(unsigned shade, const std::string& material);

  std::vector<Layer>& all() { return layers_; }
  /// Returns the layers that have lines, without lines too short for the request.
  std::vector<Layer> take();

 private:
  const HatchScene& hatch_;
  std::vector<Layer> layers_;
};

/// Spacing of the densest hatching, in mm: as requested, or in proportion to the pen width.
double closest_strokes_mm(const HatchRequest& request, double pen_mm);

/// Brightness above which nothing is hatched, for continuous shades.
inline constexpr double kBrightestHatched = 0.92;

}  // namespace ligne
