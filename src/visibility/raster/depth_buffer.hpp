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

#include <cstdint>
#include <vector>

#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "visibility/raster/pixel_grid.hpp"

namespace ligne {
class ByteReader;
class ByteWriter;
}  // namespace ligne

namespace ligne::zbuffer {

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
  struct BandLists;
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
