#include "scene/form/free_forms.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// Adjustable: least part of the area of an object that is a free form.
constexpr double kFreePart = 0.75;
/// Number of edges whose mean length stands for that of all.
constexpr std::uint32_t kSampledEdges = 4096;

bool is_free(const Scene& scene, const Object& object, std::span<const std::uint8_t> is_freeform) {
  const auto faces = is_freeform.subspan(object.face_begin, object.face_end - object.face_begin);
  const auto free_faces = static_cast<std::size_t>(std::ranges::count(faces, 1));
  if (free_faces == faces.size() || free_faces == 0) return free_faces > 0;
  struct Areas {
    double free = 0, all = 0;
    Areas operator+(const Areas& o) const { return {free + o.free, all + o.all}; }
  };
  const Areas areas = parallel_reduce(faces.size(), kShortWorkBlock, Areas{}, [&](std::size_t begin, std::size_t end) {
    Areas sum;
    for (std::size_t f = begin; f < end; ++f) {
      const double area = glm::length(double_area(scene, object.face_begin + static_cast<std::uint32_t>(f)));
      sum.all += area;
      if (faces[f]) sum.free += area;
    }
    return sum;
  });
  return areas.free >= kFreePart * areas.all;
}

double mean_length(const Scene& scene, const Topology& topology, EdgeRange range) {
  const std::uint32_t step = (range.end - range.begin) / kSampledEdges + 1;
  double sum = 0;
  std::size_t count = 0;
  for (std::uint32_t e = range.begin; e < range.end; e += step, ++count) sum += edge_length(scene, topology.edges[e]);
  return sum / static_cast<double>(count);
}

}  // namespace

std::vector<FreeForm> find_free_forms(const Scene& scene, const Topology& topology,
                                      std::span<const std::uint8_t> is_freeform, FunctionRef<bool(EdgeRange)> takes_part) {
  std::vector<FreeForm> found;
  for (const Object& object : scene.objects) {
    const EdgeRange range = edges_of(topology, object);
    if (range.begin == range.end || !takes_part(range) || !is_free(scene, object, is_freeform)) continue;
    found.push_back({range.begin, range.end, mean_length(scene, topology, range) / object_size(scene, object)});
  }
  return found;
}

}  // namespace ligne
