#include "picture/hidden_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "visibility/raster/scan_conversion.hpp"

namespace ligne {
namespace {

constexpr double kSampleMm = 0.1;
/// Adjustable: most sample points; larger pages are sampled more coarsely.
constexpr double kMostSamples = 0x1p28;

/// One bit for each sample point of the page: whether an opaque piece covers it.
class HiddenSamples {
 public:
  explicit HiddenSamples(const Rect& page)
      : origin_(page.min),
        step_mm_(std::max(kSampleMm, std::sqrt(page.width() * page.height() / kMostSamples))),
        columns_(static_cast<std::uint32_t>(page.width() / step_mm_) + 1),
        rows_(static_cast<std::uint32_t>(page.height() / step_mm_) + 1),
        words_((columns_ + 63) / 64),
        bits_(std::size_t{words_} * rows_, 0) {}

  bool shows(const PaintPiece& piece) {
    find_runs(piece);
    // Tests also the points next to those on the piece, since the piece may be visible between two points.
    for (const PolygonRun& run : runs_) {
      const std::uint32_t first = run.line == 0 ? 0 : run.line - 1, last = std::min(run.line + 1, rows_ - 1);
      for (std::uint32_t row = first; row <= last; ++row) {
        if (any_open(row, std::floor(run.u0) - 1, std::ceil(run.u1) + 1)) return true;
      }
    }
    if (!runs_.empty()) return false;
    const auto first = static_cast<std::uint32_t>(std::clamp(std::floor(box_.min.y), 0.0, rows_ - 1.0));
    const auto last = static_cast<std::uint32_t>(std::clamp(std::ceil(box_.max.y), 0.0, rows_ - 1.0));
    for (std::uint32_t row = first; row <= last; ++row) {
      if (any_open(row, std::floor(box_.min.x), std::ceil(box_.max.x))) return true;
    }
    return false;
  }

  /// Marks the points of the piece last passed to shows() as covered.
  void hide() {
    for (const PolygonRun& run : runs_) {
      visit_words(run.line, std::ceil(run.u0), std::ceil(run.u1) - 1, [](std::uint64_t& word, std::uint64_t mask) {
        word |= mask;
        return true;
      });
    }
  }

 private:
  void find_runs(const PaintPiece& piece) {
    scan_.begin(0, rows_);
    runs_.clear();
    box_ = {};
    for (const std::vector<Point2>& contour : piece.contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const GridPoint a = grid_point(contour[i]);
        scan_.add(a, grid_point(contour[i + 1 == contour.size() ? 0 : i + 1]));
        box_.extend({a.u, a.v});
      }
    }
    scan_.scan([&](const PolygonRun& run) { runs_.push_back(run); });
  }

  GridPoint grid_point(Point2 p) const { return {(p.x - origin_.x) / step_mm_, (p.y - origin_.y) / step_mm_, 0}; }

  bool any_open(std::uint32_t row, double from, double to) {
    return !visit_words(row, from, to, [](std::uint64_t& word, std::uint64_t mask) { return (~word & mask) == 0; });
  }

  /// Calls visit(word, mask) for the columns [from, to] of a row until it returns false. Returns whether it never did.
  template <class Visit>
  bool visit_words(std::uint32_t row, double from, double to, Visit visit) {
    if (!(to >= 0 && from <= columns_ - 1.0)) return true;
    const auto first = static_cast<std::uint32_t>(std::max(from, 0.0));
    const auto last = static_cast<std::uint32_t>(std::min(to, columns_ - 1.0));
    if (first > last) return true;
    std::uint64_t* const words = bits_.data() + std::size_t{row} * words_;
    for (std::uint32_t w = first / 64; w <= last / 64; ++w) {
      std::uint64_t mask = ~std::uint64_t{0};
      if (w == first / 64) mask &= ~std::uint64_t{0} << (first % 64);
      if (w == last / 64) mask &= ~std::uint64_t{0} >> (63 - last % 64);
      if (!visit(words[w], mask)) return false;
    }
    return true;
  }

  Point2 origin_;
  double step_mm_;
  std::uint32_t columns_, rows_, words_;
  std::vector<std::uint64_t> bits_;
  PolygonScan scan_;
  std::vector<PolygonRun> runs_;
  Rect box_;  ///< of the piece last passed to shows(), in steps
};

}  // namespace

std::vector<std::uint8_t> find_hidden_pieces(const PaintOrder& order, const Rect& page,
                                             const std::function<bool(std::uint32_t)>& is_opaque) {
  HiddenSamples samples(page);
  std::vector<std::uint8_t> is_hidden(order.pieces.size(), 0);
  for (std::size_t i = order.pieces.size(); i-- > 0;) {
    is_hidden[i] = !samples.shows(order.pieces[i]);
    if (!is_hidden[i] && is_opaque(order.pieces[i].face)) samples.hide();
  }
  return is_hidden;
}

std::size_t drop_hidden_pieces(PaintOrder& order, const Rect& page, const std::function<bool(std::uint32_t)>& is_opaque) {
  const std::vector<std::uint8_t> is_hidden = find_hidden_pieces(order, page, is_opaque);
  const PaintPiece* const first = order.pieces.data();
  return std::erase_if(order.pieces, [&](const PaintPiece& piece) { return is_hidden[std::size_t(&piece - first)] != 0; });
}

}  // namespace ligne
