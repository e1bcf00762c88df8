#include "visibility/horizon/horizon.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "view/clip.hpp"
#include "visibility/horizon/curve_tracker.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/grid_axis.hpp"
#include "visibility/horizon/sight.hpp"

namespace ligne {
namespace horizon {
namespace {

/// A segment is upright on the drawing plane when its ends are no farther apart across it than this part of the picture.
constexpr double kUprightPart = 0x1p-42;
/// In perspective nothing nearer to the vertical through the eye than this part of the target distance is drawn.
constexpr double kNearestPart = 0x1p-30;
/// Rows that are read at a time, by all threads.
constexpr std::size_t kRowsAtATime = 64;

/// A sample, for the horizon and on the page.
struct Sample {
  SightPoint seen;
  HomogeneousPoint page;
  bool hole;
};

std::vector<Span> joined(const std::vector<Span>& a, const std::vector<Span>& b) {
  std::vector<Span> all;
  std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all),
             [](const Span& s, const Span& t) { return s.from < t.from; });
  std::vector<Span> result;
  for (const Span& s : all) {
    if (!result.empty() && s.from <= result.back().to) {
      result.back().to = std::max(result.back().to, s.to);
    } else {
      result.push_back(s);
    }
  }
  return result;
}

/// Takes segments from the nearest to the farthest, and says of each which fractions of it in space are seen.
template <class Envelope>
class Horizons {
 public:
  Horizons(double u_min, double u_max, std::size_t cells)
      : upright_(kUprightPart * (u_max - u_min)), upper_(u_min, u_max, cells), lower_(u_min, u_max, cells) {}

  const std::vector<Span>& take(const SightPoint& a, const SightPoint& b) {
    above_.clear();
    below_.clear();
    Line line{a.u(), a.v(), b.u(), b.v()};
    if (std::abs(line.u1 - line.u0) <= upright_) {
      take_upright(line);
    } else {
      const bool turned = line.u1 < line.u0;
      if (turned) line = {line.u1, line.v1, line.u0, line.v0};
      upper_.raise(line, above_);
      lower_.raise({line.u0, -line.v0, line.u1, -line.v1}, below_);
      seen_ = below_.empty() ? above_ : above_.empty() ? below_ : joined(above_, below_);
      for (Span& s : seen_) {
        s = {(s.from - line.u0) / (line.u1 - line.u0), (s.to - line.u0) / (line.u1 - line.u0)};
        if (turned) s = {1 - s.to, 1 - s.from};
      }
      if (turned) std::reverse(seen_.begin(), seen_.end());
    }
    for (Span& s : seen_) s = {fraction_in_space(a.w, b.w, s.from), fraction_in_space(a.w, b.w, s.to)};
    return seen_;
  }

 private:
  /// Of an upright segment the parts above the upper and below the lower horizon are seen; it has no width that could hide.
  void take_upright(const Line& line) {
    seen_.clear();
    const double high = upper_.height(line.u0), low = -lower_.height(line.u0);
    if (!(high >= low)) {  // there is no horizon here yet
      seen_.push_back({0, 1});
      return;
    }
    if (line.v0 == line.v1) return;
    const auto at = [&](double v) { return std::clamp((v - line.v0) / (line.v1 - line.v0), 0.0, 1.0); };
    const bool rises = line.v1 > line.v0;
    const Span under = rises ? Span{0, at(low)} : Span{at(low), 1}, over = rises ? Span{at(high), 1} : Span{0, at(high)};
    for (const Span& s : rises ? std::array{under, over} : std::array{over, under}) {
      if (s.from < s.to) seen_.push_back(s);
    }
  }

  double upright_;
  Envelope upper_, lower_;
  std::vector<Span> above_, below_, seen_;
};

/// One part of the grid, in the order from the nearest to the farthest.
template <class Envelope>
class PartDrawer {
 public:
  PartDrawer(const HeightSource& heights, const View& view, const HorizonOptions& options, const GridAxis& x, const GridAxis& y,
             const GridAxis::Part& columns, const GridAxis::Part& rows, std::pair<double, double> u_range, std::size_t cells,
             Polylines& lines)
      : heights_(heights), view_(view), options_(options), x_(x), y_(y), columns_(columns.order), rows_(rows.order),
        first_column_(columns.first_is_drawn ? 0 : 1), first_row_(rows.first_is_drawn ? 0 : 1),
        sight_(view.camera, columns.sign, rows.sign), volume_{view.window, view.near_distance}, nearest_(kNearestPart * view.camera.target_distance),
        horizons_(u_range.first, u_range.second, cells), lines_(lines), column_curves_(columns_.size(), CurveTracker(lines)) {}

  /// Calls progress(rows done).
  template <class Progress>
  void draw(Progress progress) {
    std::vector<std::vector<Sample>> block(kRowsAtATime);
    std::vector<Sample> before;
    for (std::size_t first = 0; first < rows_.size(); first += kRowsAtATime) {
      const std::size_t n = std::min(kRowsAtATime, rows_.size() - first);
      tbb::parallel_for(std::size_t{0}, n, [&](std::size_t k) { read(rows_[first + k], block[k]); });
      for (std::size_t k = 0; k < n; ++k) {
        if (!before.empty()) draw_strip(before, block[k]);
        if (first + k >= first_row_ && y_.drawn[rows_[first + k]]) draw_row(block[k]);
        std::swap(before, block[k]);
      }
      progress(n);
    }
    for (CurveTracker& curve : column_curves_) curve.end();
  }

  std::size_t segments = 0;

 private:
  void read(std::size_t row, std::vector<Sample>& samples) const {
    std::vector<double> z(x_.sample_count), other;
    heights_.read_row(y_.sample[row], z);
    if (y_.fraction[row] > 0) {
      other.resize(z.size());
      heights_.read_row(y_.sample[row] + 1, other);
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += (other[i] - z[i]) * y_.fraction[row];
    }
    samples.resize(columns_.size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const std::size_t column = columns_[c], i = x_.sample[column];
      const double here = x_.fraction[column] > 0 ? z[i] + (z[i + 1] - z[i]) * x_.fraction[column] : z[i];
      Sample& s = samples[c];
      s.hole = !std::isfinite(here * options_.z_scale);
      if (s.hole) continue;
      const Point3 p{x_.at[column], y_.at[row], here * options_.z_scale};
      s.seen = sight_(p);
      s.page = to_homogeneous(view_, p);
    }
  }

  /// The pieces of the columns' curves between two rows.
  void draw_strip(const std::vector<Sample>& before, const std::vector<Sample>& row) {
    for (std::size_t c = first_column_; c < columns_.size(); ++c) {
      if (x_.drawn[columns_[c]]) draw_segment(before[c], row[c], column_curves_[c]);
    }
  }

  void draw_row(const std::vector<Sample>& row) {
    CurveTracker curve(lines_);
    for (std::size_t c = 1; c < row.size(); ++c) draw_segment(row[c - 1], row[c], curve);
    curve.end();
  }

  void draw_segment(const Sample& a, const Sample& b, CurveTracker& curve) {
    if (a.hole || b.hole) return curve.interrupt();
    double from = 0, to = 1;  // what is in front of the eye
    SightPoint sa = a.seen, sb = b.seen;
    if (sight_.perspective() && (sa.w < nearest_ || sb.w < nearest_)) {
      if (sa.w < nearest_ && sb.w < nearest_) return curve.interrupt();
      const double t = (nearest_ - sa.w) / (sb.w - sa.w);
      (sa.w < nearest_ ? from : to) = t;
      (sa.w < nearest_ ? sa : sb) = between(sa, sb, t);
    }
    ++segments;
    const std::vector<Span>& seen = horizons_.take(sa, sb);
    if (seen.empty()) return curve.interrupt();
    std::array<double, 2> inside{0, 1};
    if (!volume_.contains(a.page) || !volume_.contains(b.page)) {
      const auto part = clip_segment(a.page, b.page, volume_);
      if (!part) return curve.interrupt();
      inside = *part;
    }
    for (const Span& s : seen) {
      const double t0 = std::max(from + s.from * (to - from), inside[0]), t1 = std::min(from + s.to * (to - from), inside[1]);
      if (t0 < t1) curve.add(a.page, b.page, t0, t1);
    }
    curve.next_segment();
  }

  /// The point at the fraction t in space.
  static SightPoint between(const SightPoint& a, const SightPoint& b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
  }

  const HeightSource& heights_;
  const View& view_;
  const HorizonOptions& options_;
  const GridAxis &x_, &y_;
  const std::vector<std::size_t>&columns_, &rows_;
  std::size_t first_column_, first_row_;
  Sight sight_;
  ClipVolume volume_;
  double nearest_;
  Horizons<Envelope> horizons_;
  Polylines& lines_;
  std::vector<CurveTracker> column_curves_;
};

template <class Envelope>
Polylines draw_all(const HeightSource& heights, const View& view, const HorizonOptions& options, Statistics& statistics) {
  const Camera& camera = view.camera;
  const auto eye = [&](int axis) { return camera.perspective ? std::optional(camera.eye[axis]) : std::nullopt; };
  const GridAxis x(heights.x(), options.x_stride, eye(0)), y(heights.y(), options.y_stride, eye(1));
  const auto parts_x = x.parts(eye(0), camera.forward.x), parts_y = y.parts(eye(1), camera.forward.y);

  Polylines lines;
  const double all_rows = static_cast<double>(parts_x.size() * y.at.size());
  double done = 0;
  const auto progress = [&](std::size_t rows) {
    done += static_cast<double>(rows);
    if (options.progress) options.progress(std::min(1.0, done / all_rows));
  };
  for (const GridAxis::Part& py : parts_y) {
    for (const GridAxis::Part& px : parts_x) {
      const Sight sight(camera, px.sign, py.sign);
      std::pair<double, double> u_range{-1, 1};
      if (!camera.perspective) {
        u_range = {1e300, -1e300};
        for (const double cx : {x.at.front(), x.at.back()}) {
          for (const double cy : {y.at.front(), y.at.back()}) {
            const double u = sight({cx, cy, 0}).u();
            u_range = {std::min(u_range.first, u), std::max(u_range.second, u)};
          }
        }
      }
      const std::size_t cells = options.resolution ? options.resolution : x.at.size() + y.at.size();
      PartDrawer<Envelope> drawer(heights, view, options, x, y, px, py, u_range, cells, lines);
      drawer.draw(progress);
      statistics.count("curve segments", drawer.segments);
    }
  }
  statistics.count("strokes", lines.size());
  return lines;
}

}  // namespace
}  // namespace horizon

Polylines horizon_curves(const HeightSource& heights, const View& view, const HorizonOptions& options, Statistics& statistics) {
  return options.resolution ? horizon::draw_all<horizon::PixelEnvelope>(heights, view, options, statistics)
                            : horizon::draw_all<horizon::ExactEnvelope>(heights, view, options, statistics);
}

}  // namespace ligne
