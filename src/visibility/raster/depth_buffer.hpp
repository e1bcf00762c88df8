#pragma once
/// A depth buffer. Each pixel has the depth of the nearest face at its centre, the number of that face, and the hiding
/// depth: anything farther is hidden within one pixel of the centre.
///
/// Let a face over the centre have depth z there, which changes by at most s_u and s_v from pixel to pixel. Its points
/// within one pixel of the centre, edges included, are no farther than z + s_u + s_v, and anything farther is behind
/// the face where the face covers it. The hiding depth is the least such depth of all faces over the centre.
///
/// Faces may be added in any number of calls; earlier faces stay, and are not processed again. Of two faces at equal
/// depth the one with the lower number is visible. Threads paint bands of rows of constant height. So the buffer
/// depends neither on the number of threads nor on how the faces are divided among calls.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "drawing/result_models.hpp"
#include "geometry/lattice.hpp"
#include "geometry/point.hpp"
#include "view/projected_scene.hpp"

namespace ligne {
class ByteReader;
class ByteWriter;
}  // namespace ligne

namespace ligne::zbuffer {

/// The pixels of a depth buffer on the page. u and v are page coordinates in pixels, rightwards and downwards; the centre of
/// pixel (i, j), column i of row j, is at u = i, v = j.
struct PixelGrid {
  Point2 corner_mm{0, 0};  ///< upper left corner of pixel (0, 0)
  double pixel_mm = 1;
  std::uint32_t width = 1, height = 1;

  /// A grid of `rows` rows if given; else the pixels of the picture with these lines; else `standard` rows over the
  /// window.
  static PixelGrid of(const Rect& window, const std::optional<SpanLines>& lines, std::optional<std::uint32_t> rows,
                      std::uint32_t standard) {
    if (rows || !lines) return over(window, rows.value_or(standard));
    const auto columns = static_cast<std::uint32_t>(std::ceil(std::fmax(window.max.x / lines->spacing_mm, 1)));
    return {{0, lines->first_mm - lines->spacing_mm / 2}, lines->spacing_mm, columns, lines->count};
  }

  /// Covers the window with `rows` rows of square pixels. If that needs more than 16 columns per row, the pixels are
  /// larger and the rows fewer.
  static PixelGrid over(const Rect& window, std::uint32_t rows) {
    constexpr double kMostColumns = 16;  // columns per row
    const double by_height = window.height() / rows, by_width = window.width() / (kMostColumns * rows);
    const auto count = [](double pixels) { return static_cast<std::uint32_t>(std::ceil(std::fmax(pixels, 1))); };
    if (by_height >= by_width) return {window.min, by_height, count(window.width() / by_height), rows};
    return {window.min, by_width, count(window.width() / by_width), count(window.height() / by_width)};
  }
};

/// Converts lattice points to pixels. Equal points give equal places, to the last bit.
struct PixelPlaces {
  double by, u0, v0;

  PixelPlaces(const PixelGrid& grid, const Lattice& lattice)
      : by(lattice.step_mm / grid.pixel_mm),
        u0((lattice.origin_mm.x - grid.corner_mm.x) / grid.pixel_mm - 0.5),
        v0((lattice.origin_mm.y - grid.corner_mm.y) / grid.pixel_mm - 0.5) {}

  double u(LatticePoint p) const { return p.x * by + u0; }
  double v(LatticePoint p) const { return p.y * by + v0; }
};

/// Rounding of stored depths: to the precision of a float, or to whole steps behind the nearest depth.
struct DepthScale {
  double nearest = 0;
  double step = 0;  ///< mm; 0: no steps

  float stored(double z) const {
    return static_cast<float>(step == 0 ? z : nearest + step * std::floor((z - nearest) / step));
  }
};

/// Method of filling faces.
enum class Filling : std::uint8_t {
  table,  ///< whole faces with their holes, by a table of active edges; depth is interpolated along edges and runs
  fixed,  ///< triangle by triangle, in fixed point (raster/convex_filler.hpp); depth is that of the triangle's plane
};

struct PaintCounts {
  std::uint64_t faces = 0;      ///< faces, and triangles of faces that had to be divided
  std::uint64_t triangles = 0;  ///< triangles in these faces
  std::uint64_t small = 0;      ///< faces that contain no centre of a pixel
  std::uint64_t tests = 0;      ///< depths compared
  std::uint64_t writes = 0;     ///< depths that were nearer, and were written
};

class DepthBuffer {
 public:
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  DepthBuffer(const PixelGrid& grid, const DepthScale& scale);

  /// Adds the opaque faces of a scene with the same camera and page. Face 0 of the scene gets the number `first_face`.
  PaintCounts add(const ProjectedScene& scene, Filling filling, std::uint32_t first_face = 0);
  /// Adds the faces with numbers from `begin` on, under their own numbers; the others were added before.
  PaintCounts add_from(std::uint32_t begin, const ProjectedScene& scene, Filling filling);

  void write(ByteWriter& bytes) const;
  /// Reads a buffer over the window, with face numbers below `faces`. Throws InputError.
  static DepthBuffer read(ByteReader& bytes, const Rect& window, std::uint32_t faces);

  const PixelGrid& grid() const { return grid_; }
  const DepthScale& scale() const { return scale_; }

  /// The visible face at a pixel, or kNothing; its depth at the centre; the hiding depth. The depths are infinite where
  /// no face is visible.
  std::uint32_t face(std::uint32_t column, std::uint32_t row) const { return face_[place(column, row)]; }
  float depth(std::uint32_t column, std::uint32_t row) const { return depth_[place(column, row)]; }
  float hiding_depth(std::uint32_t column, std::uint32_t row) const { return hiding_depth_[place(column, row)]; }

  /// Moves the visible faces and their depths out of the buffer.
  PixelModel take_pixels();

 private:
  struct Piece;
  class Preparation;
  class BandPainter;

  PaintCounts paint(const ProjectedScene& scene, const std::vector<Triangle>& triangles, Filling filling,
                    std::uint32_t first_face);
  std::size_t place(std::uint32_t column, std::uint32_t row) const { return std::size_t{row} * grid_.width + column; }

  PixelGrid grid_;
  DepthScale scale_;
  std::vector<float> depth_, hiding_depth_;
  std::vector<std::uint32_t> face_;
};

}  // namespace ligne::zbuffer
