#include "scene/creases/sheet_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>

#include "base/no_index.hpp"
#include "base/stop.hpp"
#include "scene/creases/across_edge.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// Smallest sine at which a face at an edge stands on the plane of two others, instead of lying in it. Adjustable.
constexpr double kBesideSine = 1e-3;

/// A face at an edge of more than two.
struct Sheet {
  std::size_t edge;  ///< index in the list of such edges
  Point3 across;     ///< from the edge into the face, unit length
  Point3 normal;     ///< of the face, unit length
};

/// If two faces continue each other and every other face stands on one side of them, coinciding with no other face: the
/// unit normal towards that side. Coincident faces are the sides of two bodies that touch, with a line between them.
std::optional<Point3> side_of_walls(std::span<const Sheet> sheets, float crease_cosine) {
  constexpr std::size_t kMostSheets = 8;
  if (sheets.size() > kMostSheets) return std::nullopt;
  const auto is_alone = [&](std::size_t k) {
    return std::ranges::count_if(sheets,
                                 [&](const Sheet& s) { return glm::dot(s.across, sheets[k].across) > crease_cosine; }) == 1;
  };
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    for (std::size_t j = i + 1; j < sheets.size(); ++j) {
      if (glm::dot(sheets[i].across, sheets[j].across) > -crease_cosine) continue;
      int on_side[2] = {0, 0};
      for (std::size_t k = 0; k < sheets.size(); ++k) {
        if (k == i || k == j || !is_alone(k)) continue;
        const double height = glm::dot(sheets[k].across, sheets[i].normal);
        if (std::abs(height) > kBesideSine) ++on_side[height > 0];
      }
      const auto others = static_cast<int>(sheets.size()) - 2;
      if (on_side[1] == others) return sheets[i].normal;
      if (on_side[0] == others) return -sheets[i].normal;
    }
  }
  return std::nullopt;
}

bool is_bent(std::span<const Sheet> sheets, float crease_cosine) {
  bool bent = false, goes_on = false;
  for (const Sheet& sheet : sheets) {
    const double cosine = glm::dot(sheet.across, sheets[0].across);
    bent |= std::abs(cosine) < crease_cosine;
    goes_on |= cosine < 0;
  }
  return bent || !goes_on;
}

}  // namespace

SheetEdges find_sheet_edges(const Scene& scene, const Topology& topology, float crease_cosine) {
  if ((flags_of_any(topology) & kEdgeManyFaces) == 0) return {};
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::size_t>> wanted;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (topology.edge_flags[e] & kEdgeManyFaces) wanted.push_back({{topology.edges[e].v0, topology.edges[e].v1}, e});
  }
  SheetEdges found;
  found.bent.assign(wanted.size(), 0);
  if (wanted.empty()) return found;
  std::vector<Sheet> sheets;
  std::vector<std::uint32_t> last_face(wanted.size(), kNone);
  std::vector<std::uint8_t> is_lower_end(scene.vertices.size(), 0);  // of such an edge
  for (const auto& [ends, e] : wanted) is_lower_end[ends.first] = 1;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for_sides(scene.faces, f, [&](std::uint32_t v, std::uint32_t w) {
      const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax(v, w);
      if (!is_lower_end[ends.first]) return;
      const auto at = std::lower_bound(wanted.begin(), wanted.end(), std::pair(ends, std::size_t{0}));
      if (at == wanted.end() || at->first != ends) return;
      const auto i = static_cast<std::size_t>(at - wanted.begin());
      if (std::exchange(last_face[i], f) == f) return;
      check_stop();
      const Point3 across = across_face(scene, topology.edges[at->second], f);
      if (across != Point3(0)) sheets.push_back({i, across / glm::length(across), face_normal(scene, f)});
    });
  }
  std::stable_sort(sheets.begin(), sheets.end(), [](const Sheet& a, const Sheet& b) { return a.edge < b.edge; });
  for (auto begin = sheets.begin(); begin != sheets.end();) {
    const auto end = std::find_if(begin, sheets.end(), [&](const Sheet& s) { return s.edge != begin->edge; });
    const std::span<const Sheet> group(begin, end);
    const auto e = static_cast<std::uint32_t>(wanted[begin->edge].second);
    found.bent[begin->edge] = is_bent(group, crease_cosine);
    if (found.bent[begin->edge]) {
      if (const auto side = side_of_walls(group, crease_cosine)) found.walls.push_back({e, *side});
    } else {
      const Edge& edge = topology.edges[e];
      const Point3 along = glm::normalize(scene.vertices[edge.v1] - scene.vertices[edge.v0]);
      for (const Sheet& sheet : group) found.folds.push_back({e, glm::cross(along, sheet.across)});
    }
    begin = end;
  }
  return found;
}

}  // namespace ligne
