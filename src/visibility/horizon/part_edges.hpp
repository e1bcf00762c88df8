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
/// Its diagonal runs p - q ("anti") or n - f ("main"), whichever is the one of HiddenBy::surface in the grid's own
/// directions. `first` is the triangle at the side n - p, `second` the one at the side q - f.
///
/// Invariant: when an edge comes, all that lies before it on any line of sight has come, and nothing that lies behind it.
///
/// A sight goes over the ground along one straight path, on which the surface is a function. While it rises in the picture
/// ("facing" > 0: its upper side is seen) each of its points is seen when it is above all before; so the upper horizon needs
/// to know no more than the edges where the surface stops to rise, and the lower one those where it stops to fall.

#include <vector>

#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/grid_axis.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne::horizon {

/// A part of the grid: its positions from the nearest to the farthest.
struct GridPart {
  const HeightSource& heights;
  const GridAxis &x, &y;
  const GridAxis::Part &columns, &rows;
  bool transposed;  ///< x and y have changed places

  Point3 placed(double at_x, double at_y, double z) const {
    return transposed ? Point3{at_y, at_x, z} : Point3{at_x, at_y, z};
  }
};

class PartEdges {
 public:
  /// `covers`: whether what hides is made of triangles, not of edges alone.
  PartEdges(const GridPart& grid, const View& view, const HorizonOptions& options, const Eye& eye, const Bands& bands,
            bool covers);

  /// Reads the next rows, by all threads, and puts their strips into `lists`, the nearer first. They are good until the next
  /// call. The number of rows read; none at the end.
  std::size_t next(std::vector<EdgeList>& lists);

  /// The lines off the surface, after all strips.
  void add_back_lines(EdgeList& list) const;

  std::vector<CurveTracker>& column_curves() { return column_curves_; }

 private:
  /// +1: the upper side is seen, -1: the lower one, 0: edge on. Beyond an edge there may be no face, or one of another part
  /// of the grid.
  static constexpr std::int8_t kNoFace = 2, kOtherPart = 3;
  static bool is_face(std::int8_t facing) { return facing < kNoFace; }
  struct Facings {
    std::int8_t first = kNoFace, second = kNoFace;
    bool any() const { return first != kNoFace; }
  };
  /// A strip: the rows before and behind it, its cells, and those beyond its farther row.
  struct Strip {
    const std::vector<Sample>&nearer, &row;
    const std::vector<Facings>&cells, &beyond;
    std::size_t r;  ///< of the farther row
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
  /// `faces`: the nearer and the farther one.
  void add_edge(EdgeList& list, const Sample& a, const Sample& b, Facings faces, CurveTracker* curve,
                bool ahead = false) const;
  void add_triangle(EdgeList& list, const Sample& a, const Sample& b, const Sample& c) const;
  void add_contours(EdgeList& list, const Sample& a, const Sample& b, const Sample& c, std::int8_t facing) const;
  SightEdge* add_contour(EdgeList& list, const std::array<Point3, 2>& ends, std::size_t number) const;
  double away(const Point3& p) const;

  const Sample* placed(EdgeList& list, const Sample& sample) const;
  SightEdge& put(EdgeList& list, const FrontPart& part, bool upper, bool lower) const;
  void put_triangle(EdgeList& list, const SightTriangle& triangle) const;

  GridPart grid_;
  const View& view_;
  const HorizonOptions& options_;
  const Eye& eye_;
  const Bands& bands_;
  bool covers_;
  bool anti_;       ///< the diagonal runs from column to column against the rows
  double picture_;  ///< its width; 0 in perspective
  double upright_;
  std::vector<CurveTracker> column_curves_;
  std::vector<double> levels_;  ///< of contours, scaled

  std::size_t read_ = 0;  ///< rows so far
  /// The last two rows of the block before, and then those of this one; of each row the cells before it.
  std::vector<std::vector<Sample>> rows_;
  std::vector<std::vector<Facings>> facings_;
  std::vector<Facings> no_cells_;      ///< behind the last row
  std::vector<Facings> strip_beyond_;  ///< before the part's first row, where another part begins
};

}  // namespace ligne::horizon
