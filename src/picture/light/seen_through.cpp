#include "picture/light/seen_through.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "picture/light/region_faces.hpp"
#include "view/projected_scene.hpp"

namespace ligne {
namespace {

double border_mm(const Region& region) {
  double length = 0;
  for (const auto& contour : region.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      length += glm::length(contour[i + 1 == contour.size() ? 0 : i + 1] - contour[i]);
    }
  }
  return length;
}

/// Whether two regions overlap. Adjacent regions share a border, which rounding to the lattice moves by at most one
/// step.
bool overlap(const Region& a, const Region& b, const Lattice& lattice) {
  const double border_steps = std::min(border_mm(a), border_mm(b)) / lattice.step_mm;
  const ClipResult clip = clip_contour_by_contour(on_lattice(a, lattice), on_lattice(b, lattice));
  return twice_area(clip.inside) > 2 * border_steps;
}

Rect box_of(const Region& region) {
  Rect box;
  for (const Point2& p : region.contours[0]) box.extend(p);
  return box;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> seen_through(const Scene& scene, const std::vector<Region>& regions,
                                                     const Lattice& lattice) {
  if (std::ranges::none_of(regions, [](const Region& r) { return r.level > 0; })) return {};
  const std::vector<std::uint8_t> transparent = transparent_faces(scene);
  std::vector<Rect> boxes;
  std::vector<std::vector<std::uint32_t>> at_level;  // by level; each sorted from left to right
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    boxes.push_back(box_of(regions[i]));
    at_level.resize(std::max<std::size_t>(at_level.size(), regions[i].level + 1));
    at_level[regions[i].level].push_back(i);
  }
  for (auto& level : at_level) {
    std::ranges::stable_sort(level, {}, [&](std::uint32_t i) { return boxes[i].min.x; });
  }
  std::vector<std::vector<std::uint32_t>> through(regions.size());
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    const std::size_t behind = regions[i].level + 1;
    if (transparent.empty() || !transparent[regions[i].face] || behind == at_level.size()) continue;
    for (const std::uint32_t k : at_level[behind]) {
      if (boxes[k].min.x >= boxes[i].max.x) break;
      const bool meet =
          boxes[i].min.x < boxes[k].max.x && boxes[i].min.y < boxes[k].max.y && boxes[k].min.y < boxes[i].max.y;
      if (meet && overlap(regions[i], regions[k], lattice)) through[i].push_back(k);
    }
    std::ranges::sort(through[i]);
  }
  return through;
}

}  // namespace ligne
