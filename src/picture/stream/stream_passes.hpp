#pragma once
/// The passes over a file of triangles that reduce the scene.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "picture/placement.hpp"
#include "scene/readers/triangle_file.hpp"
#include "visibility/stream/page_layers.hpp"

namespace ligne {

/// Number of triangles that one task reads at a time.
inline constexpr std::size_t kStreamedBlock = 16'384;

/// Calls work(number of the first triangle, corners of all) for each block of a file, from several threads.
template <class Work>
void for_each_streamed_block(const TriangleFile& file, Work work) {
  parallel_blocks(file.triangle_count(), kStreamedBlock, [&](std::size_t begin, std::size_t end) {
    thread_local std::vector<Point3> corners;
    corners.resize(3 * (end - begin));
    file.read_triangles(begin, end, corners.data());
    work(begin, std::span<const Point3>(corners));
    file.forget_triangles(begin, end);
  });
}

/// Whether two corners coincide, so that the triangle is not a face.
inline bool is_degenerate(const Point3* corners) {
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

/// Returns the triangles for which choose(number, corners) is true, ascending.
template <class Choose>
std::vector<std::uint32_t> find_triangles(const TriangleFile& file, Choose choose) {
  std::vector<std::vector<std::uint32_t>> found(block_count(file.triangle_count(), kStreamedBlock));
  for_each_streamed_block(file, [&](std::size_t begin, std::span<const Point3> corners) {
    std::vector<std::uint32_t>& block = found[begin / kStreamedBlock];
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const std::size_t t = begin + i / 3;
      if (choose(t, &corners[i])) block.push_back(static_cast<std::uint32_t>(t));
    }
  });
  std::size_t count = 0;
  for (const auto& block : found) count += block.size();
  std::vector<std::uint32_t> all;
  all.reserve(count);
  for (auto& block : found) {
    all.insert(all.end(), block.begin(), block.end());
    std::vector<std::uint32_t>().swap(block);
  }
  return all;
}

/// The largest value offered, and the first triangle that has it.
struct Farthest {
  double value;
  std::uint32_t triangle = kNone;
  void offer(double v, std::size_t t) {
    if (triangle == kNone || v > value) *this = {v, static_cast<std::uint32_t>(t)};
  }
};

/// Bounds of a model: the largest x, -x, y, -y, z, -z over triangles with three different corners.
struct StreamedBounds {
  std::array<Farthest, 6> farthest{};
  std::size_t degenerate = 0;  ///< number of triangles with coincident corners
  std::vector<std::uint32_t> triangles() const;
  double largest_coordinate() const;
};
StreamedBounds find_bounds(const TriangleFile& file);

/// Bounds of the picture: the largest x, -x, y, -y on the drawing plane at 1 mm per model unit, and the largest and
/// smallest distance along the line of sight. `in_view`: nothing lies behind the viewer.
struct StreamedExtent {
  std::array<Farthest, 6> farthest{};
  bool in_view = true;
  std::vector<std::uint32_t> triangles() const;
  Rect rect() const;
};
StreamedExtent find_extent(const TriangleFile& file, const Camera& camera);

/// Makes a scene of some triangles, each with vertices of its own.
Scene scene_of_triangles(const TriangleFile& file, std::span<const std::uint32_t> triangles);

/// Chooses squares for a model whose picture takes that part of the page. `most`: largest number of squares.
PageSquares choose_squares(const TriangleFile& file, const StreamFacets& facets, const Rect& picture, double most);

/// Finds the squares with their covers. Returns nothing if a part of the model is out of view.
std::optional<PageLayers> find_page_layers(const TriangleFile& file, const StreamFacets& facets, const PageSquares& squares,
                                           bool blanks, double crease_cosine);

/// Returns the triangles that are needed, ascending: those that the covers do not hide, and those in `always`.
std::vector<std::uint32_t> find_needed(const TriangleFile& file, const StreamFacets& facets, const PageLayers& layers,
                                       std::span<const std::uint32_t> always);

}  // namespace ligne
