#include "visibility/order/order_numbers.hpp"

#include <algorithm>
#include <numeric>

namespace ligne {
namespace {

constexpr int kCells = 64;  ///< columns and rows of the grid for searching pieces. Tuned

bool covers(const PaintPiece& piece, Point2 p) {
  bool in = false;
  for (const auto& contour : piece.contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
      if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
  }
  return in;
}

/// The pieces over each cell of the page, in painting order.
class PieceGrid {
 public:
  explicit PieceGrid(const PaintOrder& order) : pieces_(order.pieces), cells_(kCells * kCells) {
    for (const PaintPiece& piece : pieces_) {
      for (const Point2& p : piece.contours[0]) page_.extend(p);
    }
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      Rect box;
      for (const Point2& p : pieces_[i].contours[0]) box.extend(p);
      for (int y = row(box.min.y); y <= row(box.max.y); ++y) {
        for (int x = column(box.min.x); x <= column(box.max.x); ++x) cells_[y * kCells + x].push_back(i);
      }
    }
  }

  /// True if the piece is the last that covers the point.
  bool is_seen(std::uint32_t piece, Point2 p) const {
    const std::vector<std::uint32_t>& cell = cells_[row(p.y) * kCells + column(p.x)];
    for (auto later = cell.rbegin(); later != cell.rend() && *later >= piece; ++later) {
      if (covers(pieces_[*later], p)) return *later == piece;
    }
    return false;
  }

 private:
  static int cell(double v, double low, double high) {
    return high > low ? std::clamp(static_cast<int>((v - low) / (high - low) * kCells), 0, kCells - 1) : 0;
  }
  int column(double x) const { return cell(x, page_.min.x, page_.max.x); }
  int row(double y) const { return cell(y, page_.min.y, page_.max.y); }

  const std::vector<PaintPiece>& pieces_;
  Rect page_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

/// The centre of a contour's corners, and points between it and the corners and midpoints of sides.
std::vector<Point2> points_to_try(const std::vector<Point2>& contour) {
  constexpr double kParts[] = {0.5, 0.8, 0.95};  // adjustable
  const Point2 middle = std::accumulate(contour.begin(), contour.end(), Point2{0, 0}) / double(contour.size());
  std::vector<Point2> points{middle};
  for (const double part : kParts) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Point2 a = contour[i], b = contour[i + 1 == contour.size() ? 0 : i + 1];
      points.push_back(middle + (a - middle) * part);
      points.push_back(middle + ((a + b) * 0.5 - middle) * part);
    }
  }
  return points;
}

}  // namespace

std::vector<PageNumber> order_numbers(const PaintOrder& order, std::span<const std::uint32_t> group_of) {
  const PieceGrid grid(order);
  std::vector<PageNumber> numbers;
  std::vector<std::uint8_t> has_number(group_of.empty() ? 0 : *std::ranges::max_element(group_of) + 1, 0);
  for (std::uint32_t i = 0; i < order.pieces.size(); ++i) {
    if (has_number[group_of[i]]) continue;
    const std::vector<Point2> points = points_to_try(order.pieces[i].contours[0]);
    const auto seen = std::ranges::find_if(points, [&](Point2 p) { return grid.is_seen(i, p); });
    if (seen == points.end()) continue;
    has_number[group_of[i]] = 1;
    numbers.push_back({*seen, group_of[i]});
  }
  return numbers;
}

std::vector<PageNumber> order_numbers(const PaintOrder& order) {
  std::vector<std::uint32_t> group_of;
  std::uint32_t group = 0;
  for (std::size_t i = 0; i < order.pieces.size(); ++i) {
    if (i == 0 || order.pieces[i].face != order.pieces[i - 1].face) ++group;
    group_of.push_back(group);
  }
  return order_numbers(order, group_of);
}

}  // namespace ligne
