#include "scene/subdivision/subdivision_mesh.hpp"

#include <algorithm>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/model/scene.hpp"

namespace ligne {
namespace {

/// Flags that an edge has only if all its sides have them.
constexpr std::uint8_t kFlagsOfAll = kCornerFileHidden | kCornerInner;

/// A side of a face, by its end vertices.
struct FiledSide {
  std::uint64_t ends;  ///< the lower vertex in the upper half
  std::uint32_t corner;
  friend bool operator<(const FiledSide& a, const FiledSide& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.corner < b.corner;
  }
};

std::vector<FiledSide> file_sides(const SubdivisionMesh& mesh) {
  std::vector<FiledSide> filed(mesh.corners.size());
  parallel_each(filed.size(), [&](std::size_t k) {
    const auto corner = static_cast<std::uint32_t>(k);
    const auto [low, high] = std::minmax({mesh.corners[corner], mesh.corners[mesh.next(corner)]});
    filed[k] = {std::uint64_t{low} << 32 | high, corner};
  });
  parallel_sort(filed.begin(), filed.end());
  return filed;
}

/// The corner at vertex v of a side that has v as an end.
std::uint32_t corner_at(const SubdivisionMesh& mesh, std::uint32_t side, std::uint32_t v) {
  return mesh.corners[side] == v ? side : mesh.next(side);
}

/// Makes vertices sharp where several fans of faces meet, so that they stay in place.
void sharpen_where_fans_meet(SubdivisionMesh& mesh, DisjointSets& fans) {
  std::vector<std::uint32_t> fans_at(mesh.points.size(), 0);
  for (std::uint32_t k = 0; k < mesh.corners.size(); ++k) fans_at[mesh.corners[k]] += fans.find(k) == k;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (fans_at[v] > 1) mesh.vertex_sharpness[v] = kAlwaysSharp;
  }
}

}  // namespace

void connect_edges(SubdivisionMesh& mesh, const SideTags& sides) {
  const std::vector<FiledSide> filed = file_sides(mesh);
  DisjointSets fans(mesh.corners.size());
  mesh.corner_edge.resize(mesh.corners.size());
  for (std::size_t first = 0, last = 0; first < filed.size(); first = last) {
    const auto e = static_cast<std::uint32_t>(mesh.edges.size());
    SubdivisionEdge edge{
        {static_cast<std::uint32_t>(filed[first].ends >> 32), static_cast<std::uint32_t>(filed[first].ends)},
        {filed[first].corner, kNone}};
    float sharpness = 0;
    std::uint8_t flags = 0, common = kFlagsOfAll;
    for (last = first; last < filed.size() && filed[last].ends == filed[first].ends; ++last) {
      const std::uint32_t corner = filed[last].corner;
      mesh.corner_edge[corner] = e;
      sharpness = std::max(sharpness, sides.sharpness[corner]);
      flags |= sides.flags[corner];
      common &= sides.flags[corner];
      if (last == first) continue;
      if (last == first + 1) edge.sides[1] = corner;
      for (const std::uint32_t v : edge.ends) fans.join(corner_at(mesh, edge.sides[0], v), corner_at(mesh, corner, v));
    }
    mesh.edges.push_back(edge);
    mesh.edge_sharpness.push_back(last - first == 2 ? sharpness : kAlwaysSharp);
    mesh.edge_flags.push_back(
        static_cast<std::uint8_t>((flags & ~kFlagsOfAll) | common | (sharpness > 0 ? kCornerSharp : 0)));
  }
  sharpen_where_fans_meet(mesh, fans);
}

}  // namespace ligne
