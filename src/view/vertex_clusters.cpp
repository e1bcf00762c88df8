#include "view/vertex_clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "base/hash.hpp"
#include "view/equal_runs.hpp"
#include "view/spatial_order.hpp"

namespace ligne {
namespace {

/// Least number of vertices in a square of the page that may belong to a cluster: a cluster spans at most four squares,
/// so one of them has more than this.
constexpr std::size_t kMaxVerticesPerSquare = kMaxVerticesPerCube / 4;

using Cube = std::array<double, 3>;

/// Side of a cube, on the page and in depth.
struct Side {
  double steps, mm;
  Cube cube(const ProjectedVertex& v) const {
    return {std::floor(v.p.x / steps), std::floor(v.p.y / steps), std::floor(v.z / mm)};
  }
};

/// Vertices sorted into cubes of the page's space.
struct Cubes {
  struct Member {
    Cube cube;
    ProjectedVertex place;
    std::uint32_t vertex;
    auto order() const { return std::tie(cube, place.p.x, place.p.y, place.z, vertex); }
  };
  struct Group {
    std::size_t begin, end;
  };
  std::vector<Member> members;  ///< sorted by cube, then by place
  std::vector<Group> groups;    ///< of equal cubes, ascending
  std::vector<std::uint8_t> taken;

  Cubes(const std::vector<ProjectedVertex>& vertices, std::span<const std::uint32_t> of, Side side) {
    for (const std::uint32_t v : of) members.push_back({side.cube(vertices[v]), vertices[v], v});
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.order() < b.order(); });
    for (std::size_t i = 0; i < members.size();) {
      const std::size_t first = i;
      // A cube of NaN, from a place out of range, equals nothing.
      do ++i;
      while (i < members.size() && members[i].cube == members[first].cube);
      groups.push_back({first, i});
    }
    taken.assign(groups.size(), 0);
  }

  /// The groups of more than `least` vertices, the largest first.
  std::vector<std::size_t> larger_than(std::size_t least) const {
    const auto size = [&](std::size_t g) { return groups[g].end - groups[g].begin; };
    std::vector<std::size_t> result;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (size(g) > least) result.push_back(g);
    }
    std::stable_sort(result.begin(), result.end(), [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
    return result;
  }

  /// The group of the cube; groups.size() if it is empty.
  std::size_t find(const Cube& cube) const {
    const auto found = std::lower_bound(groups.begin(), groups.end(), cube,
                                        [&](const Group& g, const Cube& c) { return members[g.begin].cube < c; });
    const bool there = found != groups.end() && members[found->begin].cube == cube;
    return there ? static_cast<std::size_t>(found - groups.begin()) : groups.size();
  }

  /// Calls visit(vertex) for the vertices in the cube of the group and in the 26 around it that were not taken before.
  template <class Visit>
  void take_around(std::size_t group, Visit visit) {
    const Cube centre = members[groups[group].begin].cube;
    for (int k = 0; k < 27; ++k) {
      const int columns = k % 3 - 1, rows = k / 3 % 3 - 1, layers = k / 9 - 1;
      const std::size_t g = find({centre[0] + columns, centre[1] + rows, centre[2] + layers});
      if (g == groups.size() || std::exchange(taken[g], std::uint8_t{1})) continue;
      for (std::size_t i = groups[g].begin; i < groups[g].end; ++i) visit(members[i].vertex);
    }
  }
};

/// Whether more than `least` vertices of [begin, end) may be in one cube, judged by hashes of their cubes.
bool may_have_cluster(const std::vector<ProjectedVertex>& vertices, std::size_t begin, std::size_t end, Side side,
                      std::size_t least) {
  if (end - begin <= least) return false;
  thread_local std::vector<std::uint64_t> numbers;
  numbers.clear();
  for (std::size_t i = begin; i < end; ++i) {
    const Cube cube = side.cube(vertices[i]);
    std::uint64_t number = 0;
    for (const double c : cube) number = extend_hash(number, bits_of_number(c));
    numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = least; i < numbers.size(); ++i) {
    if (numbers[i] == numbers[i - least]) return true;
  }
  return false;
}

/// Whether a cluster around the vertex may reach into another square of the page.
bool near_border(const ProjectedVertex& v, double reach) {
  const auto near = [&](std::int32_t c) {
    const auto offset = static_cast<double>((c + kLatticeLimit) % kPageSquareSteps);
    return offset < reach || offset >= kPageSquareSteps - reach;
  };
  return near(v.p.x) || near(v.p.y);
}

/// Vertices that include all clusters: those in squares that may contain one, and all near the borders of squares.
std::vector<std::uint32_t> candidates(const std::vector<ProjectedVertex>& vertices, Side side) {
  std::vector<std::vector<std::uint32_t>> inside(block_count(vertices.size(), kRunBlock));
  const auto square = [&](std::size_t i) { return page_square(vertices[i].p); };
  for_each_run(vertices.size(), square, [&](std::size_t begin, std::size_t end) {
    if (!may_have_cluster(vertices, begin, end, side, kMaxVerticesPerSquare)) return;
    auto& block = inside[begin / kRunBlock];
    for (std::size_t i = begin; i < end; ++i) block.push_back(static_cast<std::uint32_t>(i));
  });
  std::vector<std::uint32_t> result;
  for (const auto& block : inside) result.insert(result.end(), block.begin(), block.end());
  if (result.empty()) return result;
  const std::size_t in_squares = result.size();
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    if (near_border(vertices[i], 3 * side.steps)) result.push_back(i);
  }
  std::inplace_merge(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(in_squares), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

void merge_vertex_clusters(std::vector<ProjectedVertex>& vertices, double side_steps, double side_mm) {
  const Side side{side_steps, side_mm};
  const std::vector<std::uint32_t> near = candidates(vertices, side);
  if (near.empty()) return;
  Cubes cubes(vertices, near, side);
  for (const std::size_t g : cubes.larger_than(kMaxVerticesPerCube)) {
    if (cubes.taken[g]) continue;
    const ProjectedVertex to = cubes.members[cubes.groups[g].begin].place;
    cubes.take_around(g, [&](std::uint32_t v) { vertices[v] = to; });
  }
}

}  // namespace ligne
