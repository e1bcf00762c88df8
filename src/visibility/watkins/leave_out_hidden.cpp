#include "visibility/watkins/leave_out_hidden.hpp"

#include <cstdint>

#include "base/parallel.hpp"
#include "visibility/common/hidden_interval.hpp"

namespace ligne::watkins {
bool lies_behind(const CellGrid& grid, const SweepLine& line) {
  bool behind = true;
  const PageLine on_page(line.from, line.to, line.face0, line.face1);
  grid.for_each_leaf(on_page, [&](const Cell& cell, const CellSquare&, double from, double to) {
    behind = behind && cell.occluder_depth < on_page.z(from) && cell.occluder_depth < on_page.z(to);
  });
  return behind;
}

void leave_out_hidden(const ProjectedScene& scene, const OccluderGrid& covers, std::vector<Facet>& facets,
                      std::vector<SweepLine>& lines) {
  std::vector<std::uint8_t> hidden(facets.size());
  parallel_for(facets.size(), [&](std::size_t i) { hidden[i] = covers.hides(facets[i], scene.vertices); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!hidden[i]) facets[kept++] = facets[i];
  }
  facets.resize(kept);
  parallel_for(lines.size(), [&](std::size_t i) {
    const ProjectedVertex &a = lines[i].from, &b = lines[i].to;
    lines[i].behind = covers.hides(PageSegment{{double(a.p.x), double(a.p.y), a.z}, {double(b.p.x), double(b.p.y), b.z}});
  });
}

void leave_out_hidden(const CellGrid& grid, std::vector<Facet>& facets, std::vector<SweepLine>& lines) {
  const std::vector<std::uint8_t> listed = grid.listed(facets.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (listed[i]) facets[kept++] = facets[i];
  }
  facets.resize(kept);
  parallel_for(lines.size(), [&](std::size_t i) { lines[i].behind = lines[i].behind || lies_behind(grid, lines[i]); });
}

}  // namespace ligne::watkins
