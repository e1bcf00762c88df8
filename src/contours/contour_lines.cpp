#include "contours/contour_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_sights.hpp"
#include "contours/surfaces/outline_probes.hpp"
#include "geometry/degrees.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

/// Adjustable. An island is shallow if its surface is everywhere inclined to the line of sight by less than this angle.
constexpr double kShallowDegrees = 4;

/// A sector, or a connected set of sectors with one sign of g.
struct Island {
  double most = 0;    ///< largest sine of the angle between its surface and the line of sight
  bool whole = true;  ///< g has the other sign all around it, and it lies entirely on a scan
};

bool is_of_scan(std::span<const ScanObject> scans, std::uint32_t face) {
  const auto scan = std::ranges::upper_bound(scans, face, {}, &ScanObject::face_end);
  return scan != scans.end() && face >= scan->face_begin;
}

/// Distance of sights and probes beyond the mesh, in lattice steps. It exceeds two roundings plus the depth tolerance
/// of a facet.
constexpr double kSlackSteps = 8;

bool has_lines_of_its_own(const Scene& scene) {
  constexpr unsigned kLines = kCornerCurve | kCornerCrossing | kCornerContour;
  // There is no early exit, so that the loop can be vectorized.
  const auto all = std::accumulate(scene.corner_flags.begin(), scene.corner_flags.end(), std::uint8_t{0}, std::bit_or<>{});
  return (all & kLines) != 0;
}

/// Removes the outlines with these sources, which are edges of the topology, from the candidates.
void remove_outlines(ProjectedScene& projected, std::vector<std::uint32_t> sources) {
  std::ranges::sort(sources);
  projected.erase_edges([&](std::size_t i) {
    const ProjectedEdge& e = projected.edges[i];
    return e.line_class == LineClass::outline && std::ranges::binary_search(sources, e.source);
  });
}

/// Diagonals of the bounding boxes of objects, by a face of the object.
class ObjectSizes {
 public:
  explicit ObjectSizes(const Scene& scene) : scene_(scene), sizes_(scene.objects.size(), -1) {}

  /// Measures the object of a face. Must precede any query for that object.
  void measure(std::uint32_t face) {
    const std::size_t number = object_of(face);
    if (sizes_[number] >= 0) return;
    sizes_[number] = object_size(scene_, scene_.objects[number]);
  }
  double operator()(std::uint32_t face) const { return sizes_[object_of(face)]; }

 private:
  std::size_t object_of(std::uint32_t face) const {
    const auto after = std::ranges::upper_bound(scene_.objects, face, {}, &Object::face_begin);
    return static_cast<std::size_t>(after - scene_.objects.begin()) - 1;
  }

  const Scene& scene_;
  std::vector<double> sizes_;
};

/// Whether the angle between the faces at a side is less than 180 degrees inside the solid, by their winding.
bool bulges(const Scene& scene, const SmoothPatch& patch, std::uint32_t side) {
  const auto point = [&](std::uint32_t corner) { return scene.vertices[patch.triangles[corner / 3].v[corner % 3]]; };
  const Point3 from = point(side), apex = point(previous_corner(side)), other = point(previous_corner(patch.across[side]));
  return glm::dot(glm::cross(point(next_corner(side)) - from, apex - from), other - from) < 0;
}

}  // namespace

std::vector<std::uint32_t> outline_edges(const Topology& topology, const ProjectedScene& projected) {
  std::vector<std::uint32_t> outlines;
  for (const ProjectedEdge& e : projected.edges) {
    if (e.line_class == LineClass::outline && e.source < topology.edges.size()) outlines.push_back(e.source);
  }
  parallel_sort(outlines.begin(), outlines.end());
  outlines.erase(std::unique(outlines.begin(), outlines.end()), outlines.end());
  return outlines;
}

OutlinePatch patch_of_outlines(const Scene& scene, const Topology& topology, const Camera& camera,
                               const std::vector<std::uint32_t>& outlines, const RegionBorders& borders) {
  if (has_lines_of_its_own(scene)) return {};
  OutlinePatch found{outlines_inside_regions(scene, topology, outlines, borders), {}};
  if (!found.inside.empty()) found.patch = smooth_patch(scene, topology, camera, found.inside, borders);
  return found;
}

OutlineReplacement replacement_of(const Scene& scene, const Topology& topology, const ProjectedScene& projected,
                                  OutlinePatch outlines, const ContourOptions& options) {
  OutlineReplacement replacement;
  SmoothContours& contours = replacement.contours;
  if (outlines.inside.empty()) return replacement;
  const View& view = projected.view;
  SmoothPatch& patch = outlines.patch;
  level_shallow_islands(patch, scene, view.camera, options.scans);
  const std::vector<OutlineSide> sides = outline_sides(topology, patch, outlines.inside);
  ContourChoice choice =
      choose_contours(scene, view, patch, trace_contours(scene, view.camera, patch), sides, options.pen_width_mm);

  const OutlineGraph graph(scene, view, patch, sides);
  const double slack_mm = kSlackSteps * projected.lattice.step_mm + 2 * projected.input_error_mm;
  std::vector<std::vector<ContourSight>> sights(choice.chains.size());
  std::vector<ReachedSectors> reached(thread_count());
  parallel_blocks(sights.size(), kChainsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      sights[c] = contour_sights({scene, view, patch, graph, slack_mm}, choice.chains[c], reached);
    }
  });
  std::vector<std::array<Point3, 2>>& lines = replacement.lines;
  for (std::size_t c = 0; c < sights.size(); ++c) {
    contours.first_source.push_back(projected.source_count + static_cast<std::uint32_t>(lines.size()));
    contours.faces.emplace_back();
    contours.sides.emplace_back();
    for (std::size_t i = 0; i < sights[c].size(); ++i) {
      lines.push_back({sights[c][i].from, sights[c][i].to});
      contours.faces.back().push_back(patch.triangles[choice.chains[c].triangles[i]].face);
      contours.sides.back().push_back(sights[c][i].side);
    }
  }
  contours.first_probe = projected.source_count + static_cast<std::uint32_t>(lines.size());
  const std::size_t first_line = lines.size(), count = choice.sides.size();
  contours.first_edge = contours.first_probe + static_cast<std::uint32_t>(count);
  lines.resize(first_line + 2 * count);
  contours.replaced.resize(count);
  contours.bulges.resize(count);
  contours.replaced_size_mm.resize(count);
  ObjectSizes object_size(scene);
  for (const std::uint32_t i : choice.sides) object_size.measure(topology.edges[sides[i].edge].face0);
  parallel_blocks(count, kSearchBlock, [&](std::size_t begin, std::size_t end_of_block) {
    for (std::size_t k = begin; k < end_of_block; ++k) {
      const std::uint32_t side = sides[choice.sides[k]].side;
      const Edge& edge = topology.edges[sides[choice.sides[k]].edge];
      const auto end = [&](std::uint32_t corner) { return scene.vertices[patch.triangles[corner / 3].v[corner % 3]]; };
      // The edge gets the direction of its probe, so that both have the same parameters.
      contours.replaced[k] = {{end(side), end(next_corner(side))}, {edge.face0, edge.face1}, false};
      const double size_mm = size_on_page(scene, view, patch, side);
      contours.replaced_size_mm[k] = size_mm;
      contours.bulges[k] = bulges(scene, patch, side);
      lines[first_line + k] = outline_probe(scene, view, patch, side, {size_mm, object_size(edge.face0), slack_mm});
      lines[first_line + count + k] = contours.replaced[k].ends;
    }
  });
  contours.chains = std::move(choice.chains);
  for (const std::uint32_t i : choice.sides) replacement.removed.push_back(sides[i].edge);
  return replacement;
}

SmoothContours replace_outlines(ProjectedScene& projected, OutlineReplacement replacement) {
  remove_outlines(projected, std::move(replacement.removed));
  add_lines(projected, replacement.lines, LineClass::outline);
  return std::move(replacement.contours);
}

SmoothContours replace_outlines(const Scene& scene, const Topology& topology, ProjectedScene& projected,
                                const ContourOptions& options) {
  OutlinePatch outlines =
      patch_of_outlines(scene, topology, projected.view.camera, outline_edges(topology, projected), options.borders);
  return replace_outlines(projected, replacement_of(scene, topology, projected, std::move(outlines), options));
}

void level_shallow_islands(SmoothPatch& patch, const Scene& scene, const Camera& camera, std::span<const ScanObject> scans) {
  if (scans.empty()) return;
  DisjointSets sets(patch.g.size());
  for (std::uint32_t corner = 0; corner < patch.sector.size(); ++corner) {
    if (patch.across[corner] < corner) continue;  // the neighbour has the same side
    const std::uint32_t next = next_corner(corner);
    if (patch.looks_at_viewer(corner) == patch.looks_at_viewer(next)) sets.join(patch.sector[corner], patch.sector[next]);
  }
  std::vector<Island> parts(patch.g.size());  // by sector
  for (std::uint32_t t = 0; t < patch.triangles.size(); ++t) {
    const bool on_scan = is_of_scan(scans, patch.triangles[t].face);
    for (std::uint32_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      Island& part = parts[patch.sector[corner]];
      const bool at_border = patch.across[corner] == kNone || patch.across[previous_corner(corner)] == kNone;
      if (at_border || patch.complete[corner] == 0 || !on_scan) part.whole = false;
      if (part.most > 0) continue;  // the sector has one place
      const Point3 eye = to_eye(camera, scene.vertices[patch.triangles[t].v[corner - 3 * t]]);
      part.most = std::abs(patch.g[patch.sector[corner]]) / glm::length(eye);
    }
  }
  std::vector<Island> islands(patch.g.size());  // by the sector that stands for one
  for (std::uint32_t s = 0; s < parts.size(); ++s) {
    Island& island = islands[sets.find(s)];
    island.most = std::max(island.most, parts[s].most);
    island.whole = island.whole && parts[s].whole;
  }
  const double sine = sine_cosine_degrees(kShallowDegrees).sine;
  for (std::uint32_t s = 0; s < patch.g.size(); ++s) {
    const Island& island = islands[sets.find(s)];
    if (!island.whole || island.most >= sine) continue;
    double& g = patch.g[s];
    // Zero counts as looking at the viewer.
    g = g >= 0 ? std::min(-g, -std::numeric_limits<double>::min()) : -g;
  }
}

}  // namespace ligne
