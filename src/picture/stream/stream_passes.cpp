#include "picture/stream/stream_passes.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ligne {
namespace {

/// Adjustable: number of squares for each triangle, so that facets are small against their squares; fewest squares.
constexpr double kSquaresPerTriangle = 1.0 / 8, kFewestSquares = 1024;
/// Bounds of the squares that facets meet, of which the larger one counts: squares for each facet, and squares of all
/// facets.
constexpr double kSquaresOfFacet = 8, kSquaresOfAll = 4e6;
constexpr std::size_t kSamples = 65'536;

std::vector<std::uint32_t> triangles_of(std::span<const Farthest> farthest) {
  std::vector<std::uint32_t> triangles;
  for (const Farthest& f : farthest) {
    if (f.triangle != kNone) triangles.push_back(f.triangle);
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

/// Merges the result of a block. Blocks must come in the order of the file.
void take_farthest(std::array<Farthest, 6>& all, const std::array<Farthest, 6>& block) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (block[k].triangle != kNone) all[k].offer(block[k].value, block[k].triangle);
  }
}

/// Returns one object for each block of the file.
template <class Block>
std::vector<Block> blocks_of(const TriangleFile& file) {
  return std::vector<Block>(block_count(file.triangle_count(), kStreamedBlock));
}

/// Estimates the number of squares that the bounding boxes of facets meet: n + (sum of w + h) / size + (sum of w h) /
/// size^2.
struct BoxSums {
  double sides = 0, areas = 0, count = 0;
  double squares(double size) const { return count + sides / size + areas / (size * size); }
};

BoxSums sample_boxes(const TriangleFile& file, const StreamFacets& facets) {
  BoxSums sums;
  const std::size_t n = file.triangle_count(), samples = std::min(n, kSamples);
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t t = n / samples * i;
    std::array<Point3, 3> corners;
    file.read_triangles(t, t + 1, corners.data());
    const StreamFacet f = facets.make(corners.data());
    if (f.kind != StreamFacet::Kind::odd && f.kind != StreamFacet::Kind::plain) continue;
    const auto [left, right] = std::minmax({f.p[0].x, f.p[1].x, f.p[2].x});
    const auto [top, bottom] = std::minmax({f.p[0].y, f.p[1].y, f.p[2].y});
    const double w = double(right) - left, h = double(bottom) - top;
    sums.sides += w + h;
    sums.areas += w * h;
  }
  file.forget_triangles(0, n);
  const double scale = static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(samples, 1));
  return {sums.sides * scale, sums.areas * scale, static_cast<double>(n)};
}

}  // namespace

std::vector<std::uint32_t> StreamedBounds::triangles() const { return triangles_of(farthest); }

double StreamedBounds::largest_coordinate() const {
  double largest = 0;
  for (const Farthest& f : farthest) largest = std::max(largest, f.value);
  return largest;
}

std::vector<std::uint32_t> StreamedExtent::triangles() const { return triangles_of(std::span(farthest).first(4)); }

Rect StreamedExtent::rect() const {
  return {{-farthest[1].value, -farthest[3].value}, {farthest[0].value, farthest[2].value}};
}

StreamedBounds find_bounds(const TriangleFile& file) {
  auto found = blocks_of<StreamedBounds>(file);
  for_each_streamed_block(file, [&](std::size_t begin, std::span<const Point3> corners) {
    StreamedBounds& block = found[begin / kStreamedBlock];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i % 3 == 0 && is_degenerate(&corners[i])) {
        ++block.degenerate;
        i += 2;
        continue;
      }
      for (std::size_t k = 0; k < 6; ++k) {
        const double value = corners[i][static_cast<int>(k / 2)];
        block.farthest[k].offer(k % 2 == 0 ? value : -value, begin + i / 3);
      }
    }
  });
  StreamedBounds all;
  for (const StreamedBounds& block : found) {
    take_farthest(all.farthest, block.farthest);
    all.degenerate += block.degenerate;
  }
  return all;
}

StreamedExtent find_extent(const TriangleFile& file, const Camera& camera) {
  auto found = blocks_of<StreamedExtent>(file);
  for_each_streamed_block(file, [&](std::size_t begin, std::span<const Point3> corners) {
    StreamedExtent& block = found[begin / kStreamedBlock];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i % 3 == 0 && is_degenerate(&corners[i])) {
        i += 2;
        continue;
      }
      const Point3 c = camera_coordinates(camera, corners[i]);
      double x = c.x, y = c.y;
      if (camera.perspective) {  // as projected_extent() does
        block.in_view = block.in_view && c.z > 0;
        x = c.x * camera.target_distance / c.z;
        y = c.y * camera.target_distance / c.z;
      }
      const double values[] = {x, -x, y, -y, c.z, -c.z};
      for (std::size_t k = 0; k < 6; ++k) block.farthest[k].offer(values[k], begin + i / 3);
    }
  });
  StreamedExtent all;
  for (const StreamedExtent& block : found) {
    take_farthest(all.farthest, block.farthest);
    all.in_view = all.in_view && block.in_view;
  }
  return all;
}

Scene scene_of_triangles(const TriangleFile& file, std::span<const std::uint32_t> triangles) {
  Scene scene;
  for (const std::uint32_t t : triangles) {
    const auto v = static_cast<std::uint32_t>(scene.vertices.size());
    scene.vertices.resize(v + std::size_t{3});
    file.read_triangles(t, t + std::size_t{1}, &scene.vertices[v]);
    scene.faces.add_triangle(v, v + 1, v + 2);
  }
  return scene;
}

PageSquares choose_squares(const TriangleFile& file, const StreamFacets& facets, const Rect& picture, double most) {
  const Lattice& lattice = facets.page().lattice;
  const LatticePoint low = lattice.snap(picture.min), high = lattice.snap(picture.max);
  const double width = double(high.x) - low.x + 1, height = double(high.y) - low.y + 1;
  const double n = static_cast<double>(file.triangle_count());
  const double wanted = std::clamp(n * kSquaresPerTriangle, kFewestSquares, std::max(most, kFewestSquares));
  const BoxSums boxes = sample_boxes(file, facets);
  double size = std::max(std::sqrt(width * height / wanted), std::max(width, height) / wanted);
  while (boxes.squares(size) > std::max(kSquaresOfFacet * n, kSquaresOfAll)) size *= 1.25;
  // The size is even, so that a square's centre is on the lattice, and larger than the margins.
  const auto half = std::max(static_cast<std::int64_t>(std::ceil(size / 2)), 4 * facets.margin());
  PageSquares squares{.x = low.x, .y = low.y, .size = 2 * half};
  squares.columns = static_cast<std::int64_t>(width) / squares.size + 1;
  squares.rows = static_cast<std::int64_t>(height) / squares.size + 1;
  return squares;
}

std::optional<PageLayers> find_page_layers(const TriangleFile& file, const StreamFacets& facets, const PageSquares& squares,
                                           bool blanks, double crease_cosine) {
  std::optional<PageLayers> layers(std::in_place, squares, facets.margin());
  std::atomic<bool> outside{false};
  const auto add_all = [&](auto add) {
    for_each_streamed_block(file, [&](std::size_t, std::span<const Point3> corners) {
      for (std::size_t i = 0; i < corners.size(); i += 3) {
        const StreamFacet facet = facets.make(&corners[i]);
        if (facet.kind == StreamFacet::Kind::outside) outside = true;
        if (facet.kind >= StreamFacet::Kind::odd) add(facet);
      }
    });
  };
  add_all([&](const StreamFacet& facet) { layers->add_depths(facet); });
  if (outside) return std::nullopt;
  layers->find_layers();
  add_all([&](const StreamFacet& facet) { layers->add(facet); });
  layers->find_covers(blanks, crease_cosine);
  return layers;
}

std::vector<std::uint32_t> find_needed(const TriangleFile& file, const StreamFacets& facets, const PageLayers& layers,
                                       std::span<const std::uint32_t> always) {
  return find_triangles(file, [&](std::size_t t, const Point3* corners) {
    const StreamFacet facet = facets.make(corners);
    if (facet.kind == StreamFacet::Kind::none) return false;
    return !layers.can_be_left_out(facet) || std::ranges::binary_search(always, static_cast<std::uint32_t>(t));
  });
}

}  // namespace ligne
