#include "scene/surfaces/contours/cell_contours.hpp"

#include "scene/surfaces/contours/cell_cut.hpp"

namespace ligne {

CellContours::CellContours(const SurfacePoints& surface, const HeightWindow& window, double range,
                           const std::vector<BrokenEdge>& broken, std::vector<Point3>& vertices)
    : surface_(surface),
      window_(window),
      vertices_(vertices),
      outside_(surface.columns, surface.rows, [&](std::size_t k) { return counts(k); }) {
  heights_to_cells_ = range > 0 ? static_cast<double>(std::max(surface.columns, surface.rows)) / (2 * range) : 1;
  for (const BrokenEdge& edge : broken) {
    std::vector<Piece>& pieces = pieces_[edge.edge.key()];
    for (const LinePiece& piece : edge.pieces) {
      Piece& numbered = pieces.emplace_back(Piece{piece.from_start, piece.to_end, {}});
      for (const Point3& p : piece.points) {
        numbered.vertices.push_back(static_cast<std::uint32_t>(vertices.size()));
        vertices.push_back(p);
      }
    }
  }
}

/// Flags of the low row, the high column, the high row and the low column.
std::array<std::uint8_t, 4> CellContours::side_flags(std::size_t i, std::size_t j) const {
  const auto flags = [](bool is_curve, bool is_rim, std::uint8_t rim) {
    return static_cast<std::uint8_t>((is_curve ? kCornerCurve : 0) | (is_rim ? rim : 0));
  };
  const std::size_t last_column = surface_.columns - 1, last_row = surface_.rows - 1;
  const auto row = [&](std::size_t k) { return is_curve_at(k, surface_.rows, surface_.y_stride); };
  const auto column = [&](std::size_t k) { return is_curve_at(k, surface_.columns, surface_.x_stride); };
  return {flags(row(j), j == 0, SurfaceMesh::kRimBottom), flags(column(i + 1), i + 1 == last_column, SurfaceMesh::kRimRight),
          flags(row(j + 1), j + 1 == last_row, SurfaceMesh::kRimTop), flags(column(i), i == 0, SurfaceMesh::kRimLeft)};
}

void CellContours::cut_row(std::size_t j, Found& found) const {
  surface_.function->use([&](HeightFunction::At& at) {
    LineBreaks breaks(at, window_);
    for (std::size_t i = 0; i + 1 < surface_.columns; ++i) CellCut(*this, i, j, breaks, found).run();
  });
}

}  // namespace ligne
