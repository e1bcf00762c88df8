#include "cli/placement.hpp"

namespace ligne {
namespace {

/// Slack for the rounding of the picture's size: the micrometre to which a drawing is right.
constexpr double kSlackMm = 1e-3;

}  // namespace

bool Placement::larger_than_page() const {
  return !picture.empty() && (picture.width() > page.width_mm + kSlackMm || picture.height() > page.height_mm + kSlackMm);
}

Placement place(const Scene& scene, const Camera& camera, const PageOptions& options) {
  const Rect extent = projected_extent(scene, camera);
  Placement placement;
  placement.page = page_for(options, extent);
  placement.view = make_view(scene, camera, {placement.page.drawable()}, placement.page.sheet(), options.page_mm_per_unit());
  if (!extent.empty()) {
    const Point2 size = Point2(extent.width(), extent.height()) * placement.view.scale;
    const Point2 centre = (placement.page.drawable().min + placement.page.drawable().max) * 0.5;
    placement.picture = {centre - size * 0.5, centre + size * 0.5};
  }
  return placement;
}

}  // namespace ligne
