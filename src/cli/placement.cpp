#include "cli/placement.hpp"

#include "cli/errors.hpp"
#include "cli/text.hpp"

namespace ligne {
namespace {

/// Slack for the rounding of the picture's size: the micrometre to which a drawing is right.
constexpr double kSlackMm = 1e-3;

}  // namespace

bool Placement::larger_than_page() const {
  return !picture.empty() && (picture.width() > page.width_mm + kSlackMm || picture.height() > page.height_mm + kSlackMm);
}

Placement place(const Scene& scene, const Camera& camera, const PageOptions& options, const Room& room) {
  const Rect extent = projected_extent(scene, camera);
  Placement placement;
  placement.page = page_for(options, extent);
  Rect area = placement.page.drawable();
  area.min += Point2(room.left, room.top);
  area.max -= Point2(room.right, room.bottom);
  if (!(area.width() > 0 && area.height() > 0)) {
    throw UsageError("--page", "numbers and names of the axes leave nothing of a page of " +
                                   shortest(placement.page.width_mm) + " x " + shortest(placement.page.height_mm) +
                                   " mm; --text-height makes them smaller");
  }
  placement.view = make_view(scene, camera, {area}, placement.page.sheet(), options.page_mm_per_unit());
  if (!extent.empty()) {
    const Point2 size = Point2(extent.width(), extent.height()) * placement.view.scale;
    const Point2 centre = (area.min + area.max) * 0.5;
    placement.picture = {centre - size * 0.5, centre + size * 0.5};
  }
  return placement;
}

}  // namespace ligne
