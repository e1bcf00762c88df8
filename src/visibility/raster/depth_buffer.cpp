#include "visibility/raster/depth_buffer.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/index_lists.hpp"
#include "base/parallel.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/raster/convex_filler.hpp"
#include "visibility/raster/scan_conversion.hpp"

// Phases of add(): (1) group the scene's triangles into faces, with the sides that bound them (Td), (2) list the faces
// for each band of rows that they meet, (3) paint the bands in parallel.

namespace ligne::zbuffer {
namespace {

/// The ends of a side, the lower number first.
using Side = std::array<std::uint32_t, 2>;

/// Appends the border sides of a face to `sides`: those that its triangles do not share. `all` is work space. O(n log
/// n).
void append_borders(std::span<const Triangle> triangles, std::vector<Side>& all, std::vector<Side>& sides) {
  all.clear();
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) all.push_back({std::min(t.v[k], t.v[(k + 1) % 3]), std::max(t.v[k], t.v[(k + 1) % 3])});
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size();) {
    std::size_t same = i;
    while (same < all.size() && all[same] == all[i]) ++same;
    if ((same - i) % 2 == 1) sides.push_back(all[i]);
    i = same;
  }
}

/// Sorts the triangles by face; unchanged if every face has one triangle. O(n).
std::vector<Triangle> by_face(std::vector<Triangle> triangles) {
  std::uint32_t faces = 0;
  for (const Triangle& t : triangles) faces = std::max(faces, t.face + 1);
  std::vector<std::uint32_t> next(std::size_t{faces} + 1, 0);
  bool divided = false;
  for (const Triangle& t : triangles) divided |= next[t.face + 1]++ > 0;
  if (!divided) return triangles;  // as they lie on the page
  for (std::uint32_t f = 0; f < faces; ++f) next[f + 1] += next[f];
  std::vector<Triangle> sorted(triangles.size());
  for (const Triangle& t : triangles) sorted[next[t.face]++] = t;
  return sorted;
}

/// Rows of a band: few enough to stay in the cache while its faces are painted. Adjustable.
constexpr std::uint32_t kBandRows = 16;
/// Relative error of a depth that is stored as a float or computed along a side and a run.
constexpr double kFloatRounding = 0x1p-22;

}  // namespace

/// Depth over the plane of a triangle: at its first corner, and its change from pixel to pixel.
struct PixelPlane {
  double u = 0, v = 0, z = 0, du = 0, dv = 0;

  PixelPlane(const ProjectedVertex& a, const ProjectedVertex& b, const ProjectedVertex& c, const PixelPlaces& places)
      : u(places.u(a.p)), v(places.v(a.p)), z(a.z) {
    const double area = orientation(a.p, b.p, c.p) * places.by;
    const double abx = double(b.p.x) - a.p.x, aby = double(b.p.y) - a.p.y;
    const double acx = double(c.p.x) - a.p.x, acy = double(c.p.y) - a.p.y;
    du = ((b.z - a.z) * acy - (c.z - a.z) * aby) / area;
    dv = ((c.z - a.z) * abx - (b.z - a.z) * acx) / area;
  }
  double at(double other_u, double other_v) const { return z + (other_u - u) * du + (other_v - v) * dv; }
};

/// Triangles of one face that are painted together.
struct DepthBuffer::Piece {
  std::uint32_t triangle_begin, triangle_end;
  std::size_t side_begin, side_end;  ///< its borders; if empty, the sides of its only triangle
  std::uint32_t row_begin, row_end;  ///< rows whose line of centres meets the piece
  std::uint32_t face;                ///< number of the face in the buffer
  float reach;                       ///< hiding depth minus depth
};

/// Phase 1, for a block of triangles.
class DepthBuffer::Preparation {
 public:
  Preparation(const ProjectedScene& scene, const std::vector<Triangle>& triangles, const DepthBuffer& buffer,
              Filling filling, std::uint32_t first_face)
      : scene_(scene),
        triangles_(triangles),
        buffer_(buffer),
        places_(buffer.grid_, scene.lattice),
        filling_(filling),
        first_face_(first_face) {}

  std::vector<Piece> pieces;
  std::vector<Side> sides;
  PaintCounts counts;

  void clear() {
    std::vector<Piece>().swap(pieces);
    std::vector<Side>().swap(sides);
  }

  /// Adds triangles [begin, end), all of one face.
  void add_face(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t face = triangles_[begin].face;
    if (face < scene_.face_is_transparent.size() && scene_.face_is_transparent[face]) return;
    if (scene_.is_edge_on(triangles_[begin])) return;
    if (filling_ == Filling::table && end - begin > 1 && turned_alike(begin, end)) {
      add(begin, end);
    } else {
      for (std::uint32_t t = begin; t < end; ++t) add(t, t + 1);
    }
  }

 private:
  /// Whether all triangles are turned alike. If not, the face overlaps itself on the page, and its borders do not
  /// determine what it covers.
  bool turned_alike(std::uint32_t begin, std::uint32_t end) const {
    bool positive = false, negative = false;
    for (std::uint32_t t = begin; t < end; ++t) {
      const double area = area_of(triangles_[t]);
      positive |= area > 0;
      negative |= area < 0;
    }
    return !(positive && negative);
  }

  double area_of(const Triangle& t) const { return orientation(vertex(t.v[0]).p, vertex(t.v[1]).p, vertex(t.v[2]).p); }
  const ProjectedVertex& vertex(std::uint32_t v) const { return scene_.vertices[v]; }

  void add(std::uint32_t begin, std::uint32_t end) {
    double low_u = std::numeric_limits<double>::infinity(), low_v = low_u, high_u = -low_u, high_v = -low_u, z_near = low_u,
           largest = 0;
    const Triangle* plane_of = nullptr;
    for (std::uint32_t t = begin; t < end; ++t) {
      const Triangle& triangle = triangles_[t];
      const double area = std::abs(area_of(triangle));
      if (area > largest) {
        largest = area;
        plane_of = &triangle;
      }
      for (const std::uint32_t v : triangle.v) {
        const double u = places_.u(vertex(v).p), w = places_.v(vertex(v).p);
        low_u = std::min(low_u, u);
        high_u = std::max(high_u, u);
        low_v = std::min(low_v, w);
        high_v = std::max(high_v, w);
        z_near = std::min(z_near, vertex(v).z);
      }
    }
    if (!plane_of) return;
    ++counts.faces;
    counts.triangles += end - begin;
    // Half a unit of fixed point, the rounding error of a corner.
    constexpr double kRounding = 0.5 / (1 << FixedCorner::kPlaces);
    const PixelGrid& grid = buffer_.grid_;
    const auto whole = [](double w, std::uint32_t limit) {
      return static_cast<std::uint32_t>(std::clamp(std::ceil(w), 0.0, double(limit)));
    };
    const std::uint32_t row_begin = whole(low_v - kRounding, grid.height), row_end = whole(high_v + kRounding, grid.height);
    if (row_begin >= row_end || whole(low_u - kRounding, grid.width) >= whole(high_u + kRounding, grid.width)) {
      ++counts.small;
      return;
    }
    const std::size_t side_begin = sides.size();
    if (end - begin > 1) append_borders({triangles_.data() + begin, end - begin}, all_sides_, sides);
    pieces.push_back({begin, end, side_begin, sides.size(), row_begin, row_end, first_face_ + plane_of->face,
                      reach(begin, end, *plane_of, z_near)});
  }

  /// Largest depth by which a point of the face, or one that touches it, may lie behind the face's depth at a centre
  /// within one pixel.
  float reach(std::uint32_t begin, std::uint32_t end, const Triangle& t, double z_near) const {
    const PixelPlane plane(vertex(t.v[0]), vertex(t.v[1]), vertex(t.v[2]), places_);
    // Depths of a face that is not planar are interpolated between its corners, so none is farther off the plane than a
    // corner.
    double off_plane = 0, z_size = 0;
    for (std::uint32_t i = begin; i < end; ++i) {
      for (const std::uint32_t v : triangles_[i].v) {
        off_plane = std::max(off_plane, std::abs(vertex(v).z - plane.at(places_.u(vertex(v).p), places_.v(vertex(v).p))));
        z_size = std::max(z_size, std::abs(vertex(v).z));
      }
    }
    const double gradient = (std::abs(plane.du) + std::abs(plane.dv)) * places_.by;
    return round_up(std::abs(plane.du) + std::abs(plane.dv) + depth_tolerance_mm(scene_, gradient, z_near) + 2 * off_plane +
                    kFloatRounding * z_size + buffer_.scale_.step);
  }

  const ProjectedScene& scene_;
  const std::vector<Triangle>& triangles_;
  const DepthBuffer& buffer_;
  PixelPlaces places_;
  Filling filling_;
  std::uint32_t first_face_;
  std::vector<Side> all_sides_;  ///< working memory
};

/// Phase 3: paints the rows [row_begin, row_end).
class DepthBuffer::BandPainter {
 public:
  BandPainter(const ProjectedScene& scene, const std::vector<Triangle>& triangles, DepthBuffer& buffer,
              const std::vector<Side>& sides, std::uint32_t row_begin, std::uint32_t row_end)
      : scene_(scene),
        triangles_(triangles),
        buffer_(buffer),
        sides_(sides),
        places_(buffer.grid_, scene.lattice),
        row_begin_(row_begin),
        row_end_(row_end) {}

  PaintCounts counts;

  void paint(const Piece& piece, Filling filling) { filling == Filling::table ? paint_by_table(piece) : paint_fixed(piece); }

 private:
  GridPoint corner(std::uint32_t v) const {
    const ProjectedVertex& vertex = scene_.vertices[v];
    return {places_.u(vertex.p), places_.v(vertex.p), vertex.z};
  }

  void paint_by_table(const Piece& piece) {
    scan_.begin(row_begin_, row_end_);
    if (piece.side_begin == piece.side_end) {
      const Triangle& t = triangles_[piece.triangle_begin];
      for (int k = 0; k < 3; ++k) scan_.add(corner(t.v[k]), corner(t.v[(k + 1) % 3]));
    } else {
      for (std::size_t i = piece.side_begin; i < piece.side_end; ++i) scan_.add(corner(sides_[i][0]), corner(sides_[i][1]));
    }
    scan_.scan([&](const PolygonRun& run) {
      const double width = buffer_.grid_.width;
      const double from = std::clamp(std::ceil(run.u0), 0.0, width), to = std::clamp(std::ceil(run.u1), 0.0, width);
      if (from >= to) return;
      const double step = (run.z1 - run.z0) / (run.u1 - run.u0);
      paint_run(run.line, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), run.z0 + (from - run.u0) * step,
                step, piece);
    });
  }

  void paint_fixed(const Piece& piece) {
    const Triangle& t = triangles_[piece.triangle_begin];
    const ProjectedVertex &a = scene_.vertices[t.v[0]], &b = scene_.vertices[t.v[1]], &c = scene_.vertices[t.v[2]];
    const PixelPlane plane(a, b, c, places_);
    const double z_near = std::min({a.z, b.z, c.z}), z_far = std::max({a.z, b.z, c.z});
    const FixedCorner corners[3] = {FixedCorner::at(places_.u(a.p), places_.v(a.p)),
                                    FixedCorner::at(places_.u(b.p), places_.v(b.p)),
                                    FixedCorner::at(places_.u(c.p), places_.v(c.p))};
    filler_.fill(corners, row_begin_, row_end_, [&](std::int64_t row, std::int64_t left, std::int64_t right) {
      const std::int64_t from = std::max<std::int64_t>(left, 0), to = std::min<std::int64_t>(right, buffer_.grid_.width);
      if (from >= to) return;
      // Rounded corners may include a centre beside a slender triangle, where the plane is far from the corners'
      // depths.
      const auto depth_at = [&](std::int64_t column) {
        return std::clamp(plane.at(double(column), double(row)), z_near, z_far);
      };
      const double z = depth_at(from), step = to - from > 1 ? (depth_at(to - 1) - z) / double(to - 1 - from) : 0;
      paint_run(static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), z, step,
                piece);
    });
  }

  /// Paints columns [from, to) of a row; `z` is the depth at the first, `step` its change per column.
  void paint_run(std::uint32_t row, std::uint32_t from, std::uint32_t to, double z, double step, const Piece& piece) {
    const DepthScale& scale = buffer_.scale_;
    if (scale.step == 0) {
      paint_pixels(buffer_.place(from, row), to - from, piece, [&](double i) { return static_cast<float>(z + i * step); });
    } else {
      paint_pixels(buffer_.place(from, row), to - from, piece, [&](double i) { return scale.stored(z + i * step); });
    }
  }

  /// Paints `count` pixels from `begin` on; stored_at(i) is the depth of pixel i. The loop has no branches and always
  /// stores all three values, so that the compiler can paint several pixels at once.
  template <class StoredAt>
  void paint_pixels(std::size_t begin, std::uint32_t count, const Piece& piece, StoredAt stored_at) {
    float* depth = buffer_.depth_.data() + begin;
    float* hiding_depth = buffer_.hiding_depth_.data() + begin;
    std::uint32_t* face = buffer_.face_.data() + begin;
    const float reach = piece.reach;
    const std::uint32_t number = piece.face;
    std::uint32_t writes = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const float stored = stored_at(double(std::int32_t(i)));
      const float hiding = stored + reach, before = depth[i], hiding_before = hiding_depth[i];
      const std::uint32_t face_before = face[i];
      const bool nearer = (stored < before) | ((stored == before) & (number < face_before));
      hiding_depth[i] = hiding < hiding_before ? hiding : hiding_before;
      depth[i] = nearer ? stored : before;
      face[i] = nearer ? number : face_before;
      writes += nearer;
    }
    counts.tests += count;
    counts.writes += writes;
  }

  const ProjectedScene& scene_;
  const std::vector<Triangle>& triangles_;
  DepthBuffer& buffer_;
  const std::vector<Side>& sides_;
  PixelPlaces places_;
  std::uint32_t row_begin_, row_end_;
  PolygonScan scan_;
  ConvexFiller filler_;
};

DepthBuffer::DepthBuffer(const PixelGrid& grid, const DepthScale& scale)
    : grid_(grid),
      scale_(scale),
      depth_(std::size_t{grid.width} * grid.height, std::numeric_limits<float>::infinity()),
      hiding_depth_(depth_.size(), std::numeric_limits<float>::infinity()),
      face_(depth_.size(), kNothing) {}

PaintCounts DepthBuffer::add(const ProjectedScene& scene, Filling filling, std::uint32_t first_face) {
  return paint(scene, by_face(scene.triangles), filling, first_face);
}

PaintCounts DepthBuffer::add_from(std::uint32_t begin, const ProjectedScene& scene, Filling filling) {
  std::vector<Triangle> added;
  std::copy_if(scene.triangles.begin(), scene.triangles.end(), std::back_inserter(added),
               [&](const Triangle& t) { return t.face >= begin; });
  return paint(scene, by_face(std::move(added)), filling, 0);
}

/// `triangles`: of the scene, sorted by face.
PaintCounts DepthBuffer::paint(const ProjectedScene& scene, const std::vector<Triangle>& triangles, Filling filling,
                               std::uint32_t first_face) {
  // 1. Faces. A block begins where a face does.
  constexpr std::size_t kBlock = 16'384;
  const std::size_t n = triangles.size(), blocks = block_count(n, kBlock);
  const auto face_begin = [&](std::size_t i) {
    while (i > 0 && i < n && triangles[i].face == triangles[i - 1].face) ++i;
    return std::min(i, n);
  };
  std::vector<Preparation> prepared(blocks, Preparation(scene, triangles, *this, filling, first_face));
  parallel_for(blocks, [&](std::size_t block) {
    const std::size_t end = face_begin(std::min(n, (block + 1) * kBlock));
    for (std::size_t i = face_begin(block * kBlock); i < end;) {
      std::size_t next = i + 1;
      while (next < end && triangles[next].face == triangles[i].face) ++next;
      prepared[block].add_face(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(next));
      i = next;
    }
  });
  PaintCounts counts;
  std::vector<Piece> pieces;
  std::vector<Side> sides;
  for (Preparation& p : prepared) {
    for (Piece& piece : p.pieces) {
      piece.side_begin += sides.size();
      piece.side_end += sides.size();
    }
    pieces.insert(pieces.end(), p.pieces.begin(), p.pieces.end());
    sides.insert(sides.end(), p.sides.begin(), p.sides.end());
    counts.faces += p.counts.faces;
    counts.triangles += p.counts.triangles;
    counts.small += p.counts.small;
    p.clear();
  }

  // 2. Bands: the numbers of the pieces that meet each band of rows.
  const IndexLists bands(block_count(grid_.height, kBandRows), [&](const auto& put) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t band = pieces[i].row_begin / kBandRows; band * kBandRows < pieces[i].row_end; ++band) put(band, i);
    }
  });

  // 3. Painting.
  std::vector<PaintCounts> of_bands(bands.size());
  parallel_tasks(of_bands.size(), [&](std::size_t band) {
    const auto row = static_cast<std::uint32_t>(band * kBandRows);
    BandPainter painter(scene, triangles, *this, sides, row, std::min(grid_.height, row + kBandRows));
    for (const std::uint32_t piece : bands[band]) painter.paint(pieces[piece], filling);
    of_bands[band] = painter.counts;
  });
  for (const PaintCounts& c : of_bands) {
    counts.tests += c.tests;
    counts.writes += c.writes;
  }
  return counts;
}

PixelModel DepthBuffer::take_pixels() {
  return {grid_.width, grid_.height, grid_.corner_mm, grid_.pixel_mm, std::move(face_), std::move(depth_)};
}

}  // namespace ligne::zbuffer
