#include "view/clip.hpp"

#include <algorithm>
#include <tuple>

namespace ligne {
namespace {

/// Margin of lines in lattice steps: a point that is rounded onto the border of the window lies on it.
constexpr double kLineMarginSteps = 0.5;

ClipVolume widened(const View& view, double margin_mm) {
  return {{view.window.min - Point2(margin_mm), view.window.max + Point2(margin_mm)}, view.near_distance};
}

}  // namespace

ClipVolume line_volume(const View& view, const Lattice& lattice) {
  return widened(view, kLineMarginSteps * lattice.step_mm);
}

ClipVolume face_volume(const View& view, const Lattice& lattice) {
  return widened(view, kWindowMarginSteps * lattice.step_mm);
}

HomogeneousPoint interpolate(const HomogeneousPoint& a, const HomogeneousPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), a.w + t * (b.w - a.w)};
}

void clip_contour(std::vector<HomogeneousPoint>& contour, const ClipVolume& volume) {
  std::vector<HomogeneousPoint> kept;
  for (int plane = 0; plane < ClipVolume::kPlanes && !contour.empty(); ++plane) {
    kept.clear();
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const HomogeneousPoint& a = contour[i];
      const HomogeneousPoint& b = contour[i + 1 == contour.size() ? 0 : i + 1];
      const double da = volume.distance(plane, a), db = volume.distance(plane, b);
      if (da >= 0) kept.push_back(a);
      if ((da >= 0) == (db >= 0)) continue;
      // Both faces of an edge must cut it at the same point to the last bit, in either direction of the edge.
      const bool forward = std::tie(a.x, a.y, a.z, a.w) < std::tie(b.x, b.y, b.z, b.w);
      kept.push_back(forward ? interpolate(a, b, da / (da - db)) : interpolate(b, a, db / (db - da)));
    }
    contour.swap(kept);
  }
}

std::optional<SegmentPart> clip_segment(const HomogeneousPoint& a, const HomogeneousPoint& b, const ClipVolume& volume) {
  SegmentPart part;
  auto& [from, to] = part.range;
  for (int plane = 0; plane < ClipVolume::kPlanes; ++plane) {
    const double da = volume.distance(plane, a), db = volume.distance(plane, b);
    if (da < 0 && db < 0) return std::nullopt;
    if (da < 0) from = std::max(from, da / (da - db)), part.cut[0] = true;
    if (db < 0) to = std::min(to, da / (da - db)), part.cut[1] = true;
  }
  if (!(from < to)) return std::nullopt;
  return part;
}

}  // namespace ligne
