#pragma once
/// A depth buffer: for each pixel the depth of the nearest face at its centre, which face that is, and the hiding depth:
/// what lies farther is hidden within a pixel of the centre.
///
/// A face over the centre is at depth z there and changes by at most s_u and s_v from pixel to pixel. Its own points within
/// a pixel of the centre, edges among them, are no farther than z + s_u + s_v, and what is, is behind the face as long as
/// that goes on. The hiding depth is the least such depth of all faces over the centre.
///
/// Faces are added in any number of calls: what is there stays, and nothing of it is looked at again. Of two faces at
/// one depth the one of the lower number is seen. Rows are dealt out to threads in bands of constant height. So the buffer
/// is the same for any number of threads, and whether faces come at once or one after the other.

#include <cstdint>
#include <limits>
#include <vector>

#include "drawing/result_models.hpp"
#include "view/projected_scene.hpp"
#include "visibility/raster/pixel_grid.hpp"

namespace ligne {
class ByteReader;
class ByteWriter;
}  // namespace ligne

namespace ligne::zbuffer {

/// How depths are stored: as they are, to the precision of a float; or as whole steps behind the nearest one.
struct DepthScale {
  double nearest = 0;
  double step = 0;  ///< mm; 0: no steps

  float stored(double z) const {
    return static_cast<float>(step == 0 ? z : nearest + step * std::floor((z - nearest) / step));
  }
};

/// By what faces are filled.
enum class Filling : std::uint8_t {
  table,  ///< each face with its holes by a table of active edges, depth interpolated along edges and runs
  fixed,  ///< triangle by triangle in fixed point (common/convex_filler.hpp), depth by that of the triangle's plane
};

struct PaintCounts {
  std::uint64_t faces = 0;      ///< faces, and triangles of faces that had to be divided
  std::uint64_t triangles = 0;  ///< in them
  std::uint64_t small = 0;      ///< of the faces: those that hold no centre of a pixel
  std::uint64_t tests = 0;      ///< depths compared
  std::uint64_t writes = 0;     ///< of them those that were nearer
};

class DepthBuffer {
 public:
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  DepthBuffer(const PixelGrid& grid, const DepthScale& scale);

  /// Adds the opaque faces of a scene that is seen by the same camera on the same page; its face 0 counts as `first_face`.
  PaintCounts add(const ProjectedScene& scene, Filling filling, std::uint32_t first_face = 0);
  /// Adds those of its faces whose numbers are not below `begin`, under their numbers: the others were added before.
  PaintCounts add_from(std::uint32_t begin, const ProjectedScene& scene, Filling filling);

  void write(ByteWriter& bytes) const;
  /// A buffer over that window that shows faces below `faces`. Throws InputError.
  static DepthBuffer read(ByteReader& bytes, const Rect& window, std::uint32_t faces);

  const PixelGrid& grid() const { return grid_; }
  const DepthScale& scale() const { return scale_; }

  /// The face seen at a pixel, or kNothing; its depth at the centre; the hiding depth. Infinite where nothing is seen.
  std::uint32_t face(std::uint32_t column, std::uint32_t row) const { return face_[place(column, row)]; }
  float depth(std::uint32_t column, std::uint32_t row) const { return depth_[place(column, row)]; }
  float hiding_depth(std::uint32_t column, std::uint32_t row) const { return hiding_depth_[place(column, row)]; }

  /// The faces seen and their depths; the buffer is empty afterwards.
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
