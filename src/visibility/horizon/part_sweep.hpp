#pragma once
/// The sweep over one part of the grid, from the nearest cell to the farthest.
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
/// Invariant: when an edge is asked for, all that lies before it on any line of sight has been taken, and nothing that lies
/// behind it.
///
/// A sight goes over the ground along one straight path, on which the surface is a function. While it rises in the picture
/// ("facing" > 0: its upper side is seen) each of its points is seen when it is above all before; so the upper horizon needs
/// to know no more than the edges where the surface stops to rise, and the lower one those where it stops to fall.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/parallel.hpp"
#include "visibility/horizon/curve_tracker.hpp"
#include "visibility/horizon/eye.hpp"
#include "visibility/horizon/facing.hpp"
#include "visibility/horizon/grid_axis.hpp"
#include "visibility/horizon/horizon.hpp"
#include "visibility/horizon/horizons.hpp"
#include "visibility/horizon/line_store.hpp"

namespace ligne::horizon {

/// Rows that are read at a time, by all threads.
inline constexpr std::size_t kRowsAtATime = 64;

template <class Horizon>
class PartSweep {
 public:
  struct Grid {
    const HeightSource& heights;
    const GridAxis &x, &y;
    const GridAxis::Part &columns, &rows;
    bool transposed;  ///< x and y have changed places
  };

  PartSweep(const Grid& grid, const View& view, const HorizonOptions& options, std::pair<double, double> u_range,
            std::size_t cells, LineStore& store)
      : heights_(grid.heights),
        view_(view),
        options_(options),
        x_(grid.x),
        y_(grid.y),
        columns_(grid.columns),
        rows_(grid.rows),
        transposed_(grid.transposed),
        anti_(grid.columns.sign == grid.rows.sign),
        eye_(view, Sight(view.camera, grid.columns.sign, grid.rows.sign)),
        picture_(view.camera.perspective ? 0 : u_range.second - u_range.first),
        horizon_(u_range.first, u_range.second, cells),
        store_(store),
        column_curves_(columns_.order.size()) {
    for (const double level : options.contours) levels_.push_back(level * options.z_scale);
  }

  /// Calls progress(rows done).
  template <class Progress>
  void run(Progress progress) {
    std::vector<std::vector<Sample>> rows(kRowsAtATime);
    std::vector<std::vector<Facings>> facings(kRowsAtATime);
    std::vector<Sample> last_row;
    // A strip is studied when the facings of the next one are known.
    std::vector<Sample> before, row;
    std::vector<Facings> strip, next;
    const std::size_t n = rows_.order.size();
    share_lines_ahead([](std::vector<Span>& here, std::vector<Span>& shared) { here = std::move(shared); });
    for (std::size_t first = 0; first < n; first += kRowsAtATime) {
      const std::size_t count = std::min(kRowsAtATime, n - first);
      parallel_for(count, [&](std::size_t k) { read(rows_.order[first + k], rows[k]); });
      parallel_for(count, [&](std::size_t k) {
        if (first + k > 0) find_facings(k > 0 ? rows[k - 1] : last_row, rows[k], first + k, facings[k]);
      });
      last_row = rows[count - 1];
      for (std::size_t k = 0; k < count; ++k) {
        const std::size_t r = first + k;
        if (r >= 2) study(before, row, strip, facings[k], r - 1);
        std::swap(before, row);
        std::swap(row, rows[k]);
        std::swap(strip, facings[k]);
      }
      progress(count);
    }
    next.assign(columns_.order.size(), Facings{});
    if (n >= 2) study(before, row, strip, next, n - 1);
    for (CurveTracker& curve : column_curves_) curve.end();
    find_back_lines();
    share_lines_ahead([](std::vector<Span>& here, std::vector<Span>& shared) { shared = std::move(here); });
  }

  std::size_t segments = 0;

 private:
  /// +1: the upper side is seen, -1: the lower one, 0: edge on. Beyond an edge there may be no face, or one of another part
  /// of the grid.
  static constexpr std::int8_t kNoFace = 2, kOtherPart = 3;
  static bool is_face(std::int8_t facing) { return facing < kNoFace; }
  struct Facings {
    std::int8_t first = kNoFace, second = kNoFace;
    bool any() const { return first != kNoFace; }
  };
  std::int8_t near_column(const Facings& f) const { return anti_ ? f.first : f.second; }
  std::int8_t far_column(const Facings& f) const { return anti_ ? f.second : f.first; }

  Point3 placed(double x, double y, double z) const { return transposed_ ? Point3{y, x, z} : Point3{x, y, z}; }

  void read(std::size_t row, std::vector<Sample>& samples) const {
    std::vector<double> z(x_.sample_count), other;
    heights_.read_row(y_.sample[row], z);
    if (y_.fraction[row] > 0) {
      other.resize(z.size());
      heights_.read_row(y_.sample[row] + 1, other);
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += (other[i] - z[i]) * y_.fraction[row];
    }
    samples.resize(columns_.order.size());
    for (std::size_t c = 0; c < samples.size(); ++c) {
      const std::size_t column = columns_.order[c], i = x_.sample[column];
      const double here = x_.fraction[column] > 0 ? z[i] + (z[i + 1] - z[i]) * x_.fraction[column] : z[i];
      const double height = here * options_.z_scale;
      samples[c] = std::isfinite(height) ? eye_.sample(placed(x_.at[column], y_.at[row], height)) : Sample{};
    }
  }

  /// Facing of the triangle a, b, c, counter-clockwise in columns and rows.
  std::int8_t facing(const Sample& a, const Sample& b, const Sample& c) const {
    const std::int8_t turned = facing_of(a.seen, b.seen, c.seen, picture_);
    return columns_.sign * rows_.sign * (transposed_ ? -1 : 1) > 0 ? turned : static_cast<std::int8_t>(-turned);
  }

  /// Whether the cell between the positions c - 1, c and r - 1, r is left out.
  bool is_left_out(std::size_t c, std::size_t r) const {
    if (!options_.left_out) return false;
    const auto cell = [](const GridAxis& axis, const GridAxis::Part& part, std::size_t k) {
      return std::min(axis.sample[part.order[k - 1]], axis.sample[part.order[k]]);
    };
    const std::size_t i = cell(x_, columns_, c), j = cell(y_, rows_, r);
    const std::size_t columns = (transposed_ ? y_ : x_).sample_count - 1;
    return (*options_.left_out)[transposed_ ? i * columns + j : j * columns + i];
  }

  void find_facings(const std::vector<Sample>& before, const std::vector<Sample>& row, std::size_t r,
                    std::vector<Facings>& facings) const {
    facings.assign(row.size(), Facings{});
    for (std::size_t c = 1; c < row.size(); ++c) {
      const Sample &n = before[c - 1], &p = before[c], &q = row[c - 1], &f = row[c];
      if (n.hole || p.hole || q.hole || f.hole || is_left_out(c, r)) continue;
      facings[c] = anti_ ? Facings{facing(n, p, q), facing(p, f, q)} : Facings{facing(n, p, f), facing(n, f, q)};
    }
  }

  /// Calls share(spans drawn here, spans of all parts) for the curves straight before the eye: each part sees one side of
  /// them, and where two parts meet v is the same for both.
  template <class Share>
  void share_lines_ahead(Share share) {
    const auto at = [&](std::size_t column, std::size_t row) {
      const Point3 p = placed(x_.at[columns_.order[column]], y_.at[rows_.order[row]], 0);
      return eye_.sample(p).seen.u();
    };
    UprightLines& lines = horizon_.upright_lines();
    if (columns_.begin > 0)
      share(lines.drawn_at(at(columns_.begin, rows_.order.size() - 1)), store_.column_ahead[rows_.sign > 0]);
    if (rows_.begin > 0)
      share(lines.drawn_at(at(columns_.order.size() - 1, rows_.begin)), store_.row_ahead[columns_.sign > 0]);
  }

  /// The strip before row r: its cells, its columns' pieces, and row r; the part's first row too when r is the second.
  void study(const std::vector<Sample>& nearer_row, const std::vector<Sample>& row, const std::vector<Facings>& strip,
             const std::vector<Facings>& next, std::size_t r) {
    if (r <= rows_.begin) {
      strip_beyond_ = strip;
      return;
    }
    CurveTracker first_row, this_row;
    const bool first_drawn = y_.drawn[rows_.order[rows_.begin]], row_drawn = y_.drawn[rows_.order[r]];
    const std::size_t columns = row.size(), begin = columns_.begin;
    const std::int8_t before_columns = begin > 0 ? far_column(strip[begin]) : before(columns_, x_);
    for (std::size_t c = begin; c < columns; ++c) {
      const bool column_drawn = x_.drawn[columns_.order[c]];
      const std::int8_t behind = c + 1 < columns ? near_column(strip[c + 1]) : kNoFace;
      if (c == begin) {
        edge(nearer_row[c], row[c], before_columns, behind, column_drawn ? &column_curves_[c] : nullptr, begin > 0);
        continue;
      }
      const Facings& cell = strip[c];
      if (r == rows_.begin + 1) {
        edge(nearer_row[c - 1], nearer_row[c], rows_.begin > 0 ? strip_beyond_[c].second : before(rows_, y_), cell.first,
             first_drawn ? &first_row : nullptr, rows_.begin > 0);
      }
      const auto far_column_edge = [&] {
        edge(nearer_row[c], row[c], far_column(cell), behind, column_drawn ? &column_curves_[c] : nullptr);
      };
      const auto far_row_edge = [&] {
        edge(row[c - 1], row[c], cell.second, next[c].first, row_drawn ? &this_row : nullptr);
      };
      if (!cell.any()) {
        far_column_edge();
        far_row_edge();
        continue;
      }
      const Sample &n = nearer_row[c - 1], &p = nearer_row[c], &q = row[c - 1], &f = row[c];
      if (anti_) {
        contents(n, p, q, cell.first);
        edge(p, q, cell.first, cell.second, nullptr);
        cover(n, p, q);
        contents(p, f, q, cell.second);
        far_column_edge();
        far_row_edge();
        cover(p, f, q);
      } else if (first_is_nearer(n, f)) {
        contents(n, p, f, cell.first);
        far_column_edge();  // before the diagonal, whose far end it shares: it may be upright
        edge(n, f, cell.first, cell.second, nullptr);
        cover(n, p, f);
        contents(n, f, q, cell.second);
        far_row_edge();
        cover(n, f, q);
      } else {
        contents(n, f, q, cell.second);
        edge(n, f, cell.second, cell.first, nullptr);
        far_row_edge();
        cover(n, f, q);
        contents(n, p, f, cell.first);
        far_column_edge();
        cover(n, p, f);
      }
    }
    first_row.end();
    this_row.end();
  }

  /// What is before the first position of a part that nothing is known of beyond.
  static std::int8_t before(const GridAxis::Part& part, const GridAxis& axis) {
    return part.order.front() == 0 || part.order.front() + 1 == axis.at.size() ? kNoFace : kOtherPart;
  }

  /// Whether sights cross the diagonal n - f from the side of p to the side of q.
  bool first_is_nearer(const Sample& n, const Sample& f) const {
    const Camera& camera = view_.camera;
    const Point3 sight = camera.perspective ? n.p - camera.eye : camera.forward, diagonal = f.p - n.p;
    const int column = transposed_ ? 1 : 0, row = 1 - column;
    return std::abs(sight[column] * diagonal[row]) <= std::abs(sight[row] * diagonal[column]);
  }

  /// An edge between the nearer and the farther of its faces; `curve` when it is drawn as part of a curve. Of an edge
  /// straight before the eye (`ahead`), where two parts meet, each looks at its own side.
  void edge(const Sample& a, const Sample& b, std::int8_t nearer, std::int8_t farther, CurveTracker* curve,
            bool ahead = false) {
    if (!is_face(nearer) && !is_face(farther)) {
      if (curve) curve->interrupt();
      return;
    }
    const bool by_curves = options_.hidden_by == HiddenBy::curves;
    const bool rim = nearer == kNoFace || farther == kNoFace;
    const bool folded = is_face(nearer) && is_face(farther) && nearer != farther;
    const bool outlined = (folded || rim) && !curve && options_.outline;
    bool upper = by_curves && curve, lower = upper && options_.underside != Underside::none;
    if (!Horizon::kCovers && !by_curves) {
      upper = (!is_face(nearer) || nearer >= 0) && farther != 1;
      lower = (!is_face(nearer) || nearer <= 0) && farther != -1;
    }
    if (!curve && !outlined && !upper && !lower) return;
    const auto part = eye_.part_in_front(a, b);
    if (!part) {
      if (curve) curve->interrupt();
      return;
    }
    const std::int8_t facing = is_face(nearer) ? nearer : farther;
    const bool left_out = curve && facing < 0 && options_.underside == Underside::none && !by_curves;
    if (left_out) curve->interrupt();
    if ((curve && !left_out) || outlined) {
      Against against = !is_face(nearer) || nearer == 0 ? Against::both : nearer > 0 ? Against::upper : Against::lower;
      if (by_curves) against = lower ? Against::both : Against::upper;
      ++segments;
      LineSides sides = by_curves ? LineSides::none : LineSides::both;
      if (ahead && !by_curves) sides = a.seen.u() > 0 ? LineSides::left : LineSides::right;  // the part lies at |u| < 1
      const std::vector<Span>& seen = horizon_.seen(part->a, part->b, against, sides);
      if (outlined) {
        eye_.give(a, b, *part, seen,
                  [&](double t0, double t1) { add_to(rim ? store_.border : store_.outline, a, b, t0, t1); });
      } else {
        Polylines& lines =
            facing < 0 && options_.underside == Underside::apart ? store_.lines.underside : store_.lines.curves;
        eye_.give(a, b, *part, seen, [&](double t0, double t1) { curve->add(a.page, b.page, t0, t1, lines); });
        curve->next_segment();
      }
    }
    if constexpr (!Horizon::kCovers) {
      if (upper || lower) horizon_.raise(part->a, part->b, upper, lower);
    } else if (nearer == 0 || farther == 0) {
      // The other sides of a triangle that is seen edge on lie on this line: they are asked for before it is added.
      horizon_.cover(part->a, part->b, part->b);
    }
  }

  void cover(const Sample& a, const Sample& b, const Sample& c) {
    if constexpr (Horizon::kCovers) {
      // What is too near to the vertical through the eye is cut away.
      const std::vector<SightPoint> contour = eye_.contour_in_front({&a.seen, &b.seen, &c.seen});
      for (std::size_t i = 2; i < contour.size(); ++i) horizon_.cover(contour[0], contour[i - 1], contour[i]);
    }
  }

  /// The contour lines in a triangle.
  void contents(const Sample& a, const Sample& b, const Sample& c, std::int8_t facing) {
    if (levels_.empty()) return;
    const std::array<const Sample*, 3> corners{&a, &b, &c};
    const auto [low, high] = std::minmax({a.p.z, b.p.z, c.p.z});
    for (auto level = std::upper_bound(levels_.begin(), levels_.end(), low); level != levels_.end() && *level <= high;
         ++level) {
      std::array<Point3, 2> ends;
      int n = 0;
      for (int i = 0; i < 3 && n < 2; ++i) {
        // From the lower to the higher end, so that both neighbours of an edge find the same point.
        const Sample *s = corners[i], *e = corners[(i + 1) % 3];
        if (s->p.z > e->p.z) std::swap(s, e);
        if (!(s->p.z < *level && *level <= e->p.z)) continue;
        const double t = (*level - s->p.z) / (e->p.z - s->p.z);
        ends[n++] = {s->p.x + t * (e->p.x - s->p.x), s->p.y + t * (e->p.y - s->p.y), *level};
      }
      if (n < 2) continue;
      if (away(ends[1]) < away(ends[0])) std::swap(ends[0], ends[1]);
      const auto number = static_cast<std::size_t>(level - levels_.begin());
      if (options_.contours_on_surface && facing != 0) {
        contour(ends, facing > 0 ? Against::upper : Against::lower, LineSides::both, store_.contours[number]);
      }
      if (options_.contour_base) {
        // What lies below the surface here can not be seen above what is nearer.
        const double base = *options_.contour_base * options_.z_scale;
        for (Point3& end : ends) end.z = base;
        contour(ends, base < *level ? Against::lower : Against::upper, LineSides::none, store_.base_contours[number]);
      }
    }
  }

  /// Along every sight this grows.
  double away(const Point3& p) const {
    const int column = transposed_ ? 1 : 0;
    return columns_.sign * p[column] + rows_.sign * p[1 - column];
  }

  /// `ends`: the nearer one first.
  void contour(const std::array<Point3, 2>& ends, Against against, LineSides sides, Chains& chains) {
    const Sample a = eye_.sample(ends[0]), b = eye_.sample(ends[1]);
    const auto part = eye_.part_in_front(a, b);
    if (part)
      eye_.give(a, b, *part, horizon_.seen(part->a, part->b, against, sides),
                [&](double t0, double t1) { add_to(chains, a, b, t0, t1); });
  }

  void find_back_lines() {
    for (std::size_t i = 0; i < options_.back_lines.size(); ++i) {
      const auto& line = options_.back_lines[i];
      const Sample a = eye_.sample(line[0]), b = eye_.sample(line[1]);
      double from = 0, to = 1;  // what is in this part
      if (eye_.perspective()) {
        const std::array<std::array<double, 2>, 2> ahead{
            {{columns_.sign * (a.p.x - view_.camera.eye.x), columns_.sign * (b.p.x - view_.camera.eye.x)},
             {rows_.sign * (a.p.y - view_.camera.eye.y), rows_.sign * (b.p.y - view_.camera.eye.y)}}};
        for (const auto& [da, db] : ahead) {
          if (da < 0 && db < 0) to = -1;
          if (da < 0 && db > 0) from = std::max(from, da / (da - db));
          if (db < 0 && da > 0) to = std::min(to, da / (da - db));
        }
      }
      if (!(from < to)) continue;
      const auto part = eye_.part_in_front(a, b, from, to);
      if (!part) continue;
      auto& seen = store_.lines.back_lines[i];
      eye_.give(a, b, *part, horizon_.seen(part->a, part->b, Against::both, LineSides::none), [&](double t0, double t1) {
        seen.push_back({t0, t1});
      });
    }
  }

  static void add_to(Chains& chains, const Sample& a, const Sample& b, double t0, double t1) {
    chains.add(CurveTracker::at(a.page, b.page, t0), CurveTracker::at(a.page, b.page, t1));
  }

  const HeightSource& heights_;
  const View& view_;
  const HorizonOptions& options_;
  const GridAxis &x_, &y_;
  const GridAxis::Part &columns_, &rows_;
  bool transposed_;
  bool anti_;  ///< the diagonal runs from column to column against the rows
  Eye eye_;
  double picture_;  ///< its width; 0 in perspective
  Horizon horizon_;
  LineStore& store_;
  std::vector<CurveTracker> column_curves_;
  std::vector<Facings> strip_beyond_;  ///< before the part's first row, where another part begins
  std::vector<double> levels_;         ///< of contours, scaled
};

}  // namespace ligne::horizon
