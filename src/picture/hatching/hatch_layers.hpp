#pragma once
/// The layers that hatching needs: one, or one for each shade or material that pens are chosen by.

#include <string>
#include <vector>

#include "picture/hatching/hatching.hpp"

namespace ligne {

/// It refers to the scene.
class HatchLayers {
 public:
  explicit HatchLayers(const HatchScene& hatch) : hatch_(hatch) {}

  /// Width of the pen that draws such a layer.
  double pen_mm(unsigned shade, const std::string& material) const;
  double pen_mm(const Layer& layer) const { return pen_mm(layer.shade, layer.material); }
  /// The layer's number. Shades and materials are distinguished only when pens are.
  std::uint32_t number(unsigned shade, const std::string& material);

  std::vector<Layer>& all() { return layers_; }
  /// Those with lines, without the ones that are too short for the request.
  std::vector<Layer> take();

 private:
  const HatchScene& hatch_;
  std::vector<Layer> layers_;
};

/// Distance of the closest strokes: that of the request, or by the pen.
double closest_strokes_mm(const HatchRequest& request, double pen_mm);

/// Continuous shades: what gets more light is left white.
inline constexpr double kBrightestHatched = 0.92;

}  // namespace ligne
