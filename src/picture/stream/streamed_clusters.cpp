#include "picture/stream/streamed_clusters.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "view/tolerances.hpp"
#include "view/vertex_clusters.hpp"

namespace ligne {
namespace {

/// Reach of the vertices of a cluster, in coincidences and lattice steps. Two cubes may compete for vertices only if
/// all their vertices are within three sides of a cluster's cube, which are one and a half coincidences, apart from
/// rounding.
constexpr double kReachInCoincidences = 1.5, kReachSteps = 4;
/// Adjustable: larger cubes are fewer, but contain more vertices that belong to no cluster.
constexpr double kSideInReaches = 8;

std::uint64_t cube_number(const std::array<double, 3>& cube) {
  return place_number({cube[0], cube[1], cube[2]}) | 1;  // 0 stands for no cube
}

}  // namespace

ClusterCounter::ClusterCounter(const StreamFacets& facets, std::span<const Point3> places) : facets_(facets) {
  const ProjectedScene& page = facets.page();
  reach_mm_ = kReachInCoincidences * coincidence_mm(page) + kReachSteps * page.lattice.step_mm;
  side_mm_ = kSideInReaches * reach_mm_;
  std::vector<std::uint64_t> numbers;
  for (const Point3& place : places) {
    const std::array<double, 3> p = facets.page_place(place);
    // A vertex near the sides of its cube may belong to a cluster in the next cube too.
    for (int k = 0; k < 8; ++k) {
      std::array<double, 3> cube;
      bool repeated = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double low = std::floor((p[axis] - reach_mm_) / side_mm_), high = std::floor((p[axis] + reach_mm_) / side_mm_);
        const bool upper = k >> axis & 1;
        repeated = repeated || (upper && low == high);
        cube[axis] = upper ? high : low;
      }
      if (!repeated) numbers.push_back(cube_number(cube));
    }
  }
  cubes_ = std::vector<Cube>(std::bit_ceil(2 * numbers.size() + 1));
  for (const std::uint64_t number : numbers) cubes_[slot_of(number)].number = number;
}

std::size_t ClusterCounter::slot_of(std::uint64_t number) const {
  const std::size_t mask = cubes_.size() - 1;
  std::size_t slot = number >> 1 & mask;
  while (cubes_[slot].number != 0 && cubes_[slot].number != number) slot = (slot + 1) & mask;
  return slot;
}

std::uint64_t ClusterCounter::number_of(const Point3& vertex) const {
  std::array<double, 3> cube = facets_.page_place(vertex);
  for (double& c : cube) c = std::floor(c / side_mm_);
  return cube_number(cube);
}

void ClusterCounter::count(const Point3& vertex, bool needed) {
  Cube& cube = cubes_[slot_of(number_of(vertex))];
  if (cube.number == 0) return;
  cube.vertices.fetch_add(1, std::memory_order_relaxed);
  if (!needed) cube.not_needed.fetch_add(1, std::memory_order_relaxed);
}

bool ClusterCounter::Cube::torn() const { return vertices > kMaxVerticesPerCube && not_needed > 0; }

bool ClusterCounter::is_split(const Point3& vertex) const { return cubes_[slot_of(number_of(vertex))].torn(); }

bool ClusterCounter::any_split() const {
  return std::any_of(cubes_.begin(), cubes_.end(), [](const Cube& cube) { return cube.torn(); });
}

}  // namespace ligne
