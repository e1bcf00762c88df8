#pragma once
/// The edges of one part of the grid, from the nearest cell to the farthest: those tested against the horizons, and those
/// that raise them.
///
/// Notation. Positions are counted from the viewer: column c and row r grow away from it. Cell c of a strip between two rows
/// has the corners
///
///     q ---- f      row            n: nearest, f: farthest
///     |      |
///     n ---- p      before         columns c - 1, c
///
/// Its diagonal runs p - q ("anti") or n - f ("main"): the diagonal of HiddenBy::surface, in the part's directions.
/// `first` is the triangle at the side n - p, `second` the triangle at the side q - f.
///
/// Invariant: when an edge comes, everything in front of it on any line of sight has come, and nothing behind it has.
///
/// A line of sight passes over the ground along one straight path, on which the surface is a function. While the
/// surface rises in the picture ("facing" > 0: its upper side is visible), a point of it is visible if it is above
/// everything before. So only the edges where the surface stops rising raise the upper horizon, and only those where it
/// stops falling the lower one.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/grid_axis.hpp"
#include "visibility/horizon/horizon.hpp"
#include "visibility/horizon/plane_projection.hpp"

namespace ligne::horizon {

/// A part of the grid: its positions from the nearest to the farthest.
struct GridPart {
  const HeightSource& heights;
  const GridAxis &x, &y;
  const GridAxis::Part &columns, &rows;
  bool transposed;  ///< x and y are exchanged

  Point3 placed(double at_x, double at_y, double z) const {
    return transposed ? Point3{at_y, at_x, z} : Point3{at_x, at_y, z};
  }
};

class PartEdges {
 public:
  /// `covers`: triangles hide, not only edges.
  PartEdges(const GridPart& grid, const View& view, const HorizonOptions& options, const Eye& eye, const Bands& bands,
            bool covers);

  /// Reads the next rows, with all threads, and puts their strips into `lists`, nearest first. The lists are valid
  /// until the next call. Returns the number of rows read, 0 at the end.
  std::size_t next(std::vector<EdgeList>& lists);

  /// Adds the lines off the surface, after all strips.
  void add_back_lines(EdgeList& list) const;

  std::vector<CurveTracker>& column_curves() { return column_curves_; }

 private:
  /// Facing: +1 if the upper side is visible, -1 if the lower one, 0 if edge on. Across an edge there may be no face,
  /// or a face of another part of the grid.
  static constexpr std::int8_t kNoFace = 2, kOtherPart = 3;
  static bool is_face(std::int8_t facing) { return facing < kNoFace; }
  struct Facings {
    std::int8_t first = kNoFace, second = kNoFace;
    bool any() const { return first != kNoFace; }
  };
  /// A strip: the rows in front of and behind it, its cells, and the cells beyond its farther row.
  struct Strip {
    const std::vector<Sample>&nearer, &row;
    const std::vector<Facings>&cells, &beyond;
    std::size_t r;  ///< number of the farther row
  };
  std::int8_t near_column(const Facings& f) const { return anti_ ? f.first : f.second; }
  std::int8_t far_column(const Facings& f) const { return anti_ ? f.second : f.first; }

  void read(std::size_t row, std::vector<Sample>& samples) const;
  std::int8_t facing(const Sample& a, const Sample& b, const Sample& c) const;
  bool is_left_out(std::size_t c, std::size_t r) const;
  void find_facings(const std::vector<Sample>& before, const std::vector<Sample>& row, std::size_t r,
                    std::vector<Facings>& facings) const;
  void add_strip(const Strip& strip, EdgeList& list);
  void add_near_row(const Strip& strip, std::size_t c, EdgeList& list);
  void add_cell(const Strip& strip, std::size_t c, CurveTracker* column_curve, CurveTracker* row_curve,
                EdgeList& list) const;
  static std::int8_t before(const GridAxis::Part& part, const GridAxis& axis);
  bool first_is_nearer(const Sample& n, const Sample& f) const;
  /// `faces`: facings of the nearer and the farther face.
  void add_edge(EdgeList& list, const Sample& a, const Sample& b, Facings faces, CurveTracker* curve,
                bool ahead = false) const;
  void add_triangle(EdgeList& list, const Sample& a, const Sample& b, const Sample& c) const;
  void add_contours(EdgeList& list, const Sample& a, const Sample& b, const Sample& c, std::int8_t facing) const;
  HorizonEdge* add_contour(EdgeList& list, const std::array<Point3, 2>& ends, std::size_t number) const;
  double away(const Point3& p) const;

  const Sample* placed(EdgeList& list, const Sample& sample) const;
  HorizonEdge& put(EdgeList& list, const FrontPart& part, bool upper, bool lower) const;
  void put_triangle(EdgeList& list, const PlaneTriangle& triangle) const;

  GridPart grid_;
  const View& view_;
  const HorizonOptions& options_;
  const Eye& eye_;
  const Bands& bands_;
  bool covers_;
  bool anti_;       ///< the diagonal is p - q
  double picture_;  ///< width of the picture; 0 in perspective
  double upright_;
  std::vector<CurveTracker> column_curves_;
  std::vector<double> levels_;  ///< heights of the contours, scaled

  std::size_t read_ = 0;  ///< rows read so far
  /// The last two rows of the block before, then the rows of this block; facings_ holds the cells in front of each row.
  std::vector<std::vector<Sample>> rows_;
  std::vector<std::vector<Facings>> facings_;
  std::vector<Facings> no_cells_;      ///< cells behind the last row: none
  std::vector<Facings> strip_beyond_;  ///< cells in front of the part's first row, which belong to another part
};

/// Finds the visible side of a triangle.

/// 1 if the corners turn counter-clockwise for the viewer, -1 if clockwise, 0 if the triangle is seen edge on: it is
/// then no thicker on the drawing plane than the difference of level heights, since rounding must not separate its
/// sides. `picture` is the picture's width in parallel projection; in perspective it is 0, and the distance of the
/// corners takes its place. The points may lie behind the eye.
inline std::int8_t facing_of(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r, double picture) {
  if (picture > 0) {  // w is 1, which simplifies the determinant
    const double turn = (q.x * r.y - q.y * r.x) + (r.x * p.y - r.y * p.x) + (p.x * q.y - p.y * q.x);
    const double extent =
        std::max(std::max(std::abs(q.x - p.x), std::abs(q.y - p.y)), std::max(std::abs(r.x - p.x), std::abs(r.y - p.y)));
    if (std::abs(turn) <= kLevelPart * picture * extent) return 0;
    return turn > 0 ? 1 : -1;
  }
  const double det = p.w * (q.x * r.y - q.y * r.x) + q.w * (r.x * p.y - r.y * p.x) + r.w * (p.x * q.y - p.y * q.x);
  // The determinant is thickness times side times, in perspective, the square of the distance.
  const double side = std::max({std::abs(q.x - p.x), std::abs(q.y - p.y), std::abs(q.w - p.w), std::abs(r.x - p.x),
                                std::abs(r.y - p.y), std::abs(r.w - p.w)});
  const double distance = std::max({std::abs(p.w), std::abs(q.w), std::abs(r.w), std::abs(p.x), std::abs(p.y)});
  if (std::abs(det) <= kLevelPart * distance * distance * side) return 0;
  return det > 0 ? 1 : -1;
}

}  // namespace ligne::horizon
