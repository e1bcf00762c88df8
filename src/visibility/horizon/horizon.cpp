#include "visibility/horizon/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "view/tolerances.hpp"
#include "visibility/horizon/coverage.hpp"
#include "visibility/horizon/edges.hpp"
#include "visibility/horizon/envelope.hpp"
#include "visibility/horizon/part_edges.hpp"
#include "visibility/horizon/part_lines.hpp"

namespace ligne {
namespace horizon {
namespace {

/// An upper and a lower horizon, functions of u: for surfaces without holes.
template <class Envelope>
class TwoHorizons {
 public:
  static constexpr bool kCovers = false;

  TwoHorizons(const Columns& columns, ColumnRange own) : upper_(columns, own), lower_(columns, own) {}

  /// Finds the visible parts of an edge over the band's own columns, as spans of its line, separately above the upper
  /// and below the lower horizon. For an upright line it returns whether a side is open: it has no horizon, or was not
  /// tested.
  bool find_seen(const HorizonEdge& edge, std::vector<Span>& above, std::vector<Span>& below) {
    const PlaneSegment& segment = edge.line;
    if (segment.upright()) return find_seen_upright(edge, above);
    if (edge.against != HorizonSide::lower) upper_.find_above(segment.line(), above);
    if (edge.against == HorizonSide::lower) lower_.find_above(segment.upside_down(), above);
    if (edge.against == HorizonSide::both) lower_.find_above(segment.upside_down(), below);
    return true;
  }

  /// Adds the edge to the horizons that it raises.
  void raise(const HorizonEdge& edge) {
    if (edge.line.upright()) return;
    raised_.clear();
    if (edge.upper) upper_.raise(edge.line.line(), raised_);
    if (edge.lower) lower_.raise(edge.line.upside_down(), raised_);
  }

  /// Largest gap over which spans of two bands are joined.
  double least() const { return upper_.least(); }

 private:
  bool find_seen_upright(const HorizonEdge& edge, std::vector<Span>& seen) {
    const Line& line = edge.line.line();
    const LineSides sides = edge.sides;
    // The surface passes through the line's nearer end on both sides.
    const double u = line.u0, nearest = edge.line.height_of_start();
    double high = upper_.height(u), low = -lower_.height(u);
    bool open = true;
    if (sides == LineSides::both) {
      high = std::min(upper_.height_beside(u, -1), upper_.height_beside(u, 1));
      low = -std::min(lower_.height_beside(u, -1), lower_.height_beside(u, 1));
      open = high == kNothing || low == -kNothing;
    } else if (sides != LineSides::none) {
      const int side = sides == LineSides::left ? -1 : 1;
      high = upper_.height_beside(u, side);
      low = -lower_.height_beside(u, side);
    }
    if (sides != LineSides::none) {
      high = std::max(high, nearest);
      low = std::min(low, nearest);
    }
    if (!(line.v0 < line.v1)) return open;
    if (sides == LineSides::none && edge.against == HorizonSide::upper) low = kNothing;
    if (!(high >= low)) {  // there is no horizon here yet
      seen.push_back({line.v0, line.v1});
      return open;
    }
    if (line.v0 < low) seen.push_back({line.v0, std::min(low, line.v1)});
    if (high < line.v1) seen.push_back({std::max(high, line.v0), line.v1});
    return open;
  }

  Envelope upper_, lower_;
  std::vector<Span> raised_;  ///< scratch
};

/// A horizon that is not a function of u: for surfaces with holes.
class GeneralHorizon {
 public:
  static constexpr bool kCovers = true;

  GeneralHorizon(const Columns& columns, ColumnRange own) : coverage_(columns, own) {}

  bool find_seen(const HorizonEdge& edge, std::vector<Span>& seen, std::vector<Span>&) {
    const Line& line = edge.line.line();
    if (!edge.line.upright()) {
      coverage_.find_uncovered(line, seen);
    } else if (line.v0 < line.v1) {
      find_seen_upright(line, edge.sides, seen);
    }
    return true;
  }

  void cover(const PlaneTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    coverage_.cover({{{a.u(), a.v()}, {b.u(), b.v()}, {c.u(), c.v()}}});
  }

  double least() const { return coverage_.least(); }

 private:
  void find_seen_upright(const Line& line, LineSides sides, std::vector<Span>& seen) {
    std::array<std::vector<Span>, 2> covered;  // left, right
    for (const int k : {0, 1}) {
      if (sides != (k == 0 ? LineSides::right : LineSides::left))
        coverage_.find_covered_beside(line.u0, line.v0, line.v1, k == 0 ? -1 : 1, covered[k]);
    }
    std::vector<Span> hidden;
    if (sides == LineSides::left || sides == LineSides::right) {
      hidden = covered[sides == LineSides::left ? 0 : 1];
    } else {
      for (const Span& a : covered[0]) {
        for (const Span& b : covered[1]) {
          const Span both{std::max(a.from, b.from), std::min(a.to, b.to)};
          if (both.from < both.to) hidden.push_back(both);
        }
      }
    }
    Coverage::append_uncovered(line.v0, line.v1, coverage_.least(), hidden, seen);
  }

  Coverage coverage_;
};

/// Horizons of bands of columns, which work in parallel. A band uses only the part of an edge over its columns, so no
/// band waits for another. All bands take the edges in the same order.

template <class Horizon>
class HidingBands {
 public:
  explicit HidingBands(const Bands& bands) {
    for (std::size_t b = 0; b < bands.size(); ++b) bands_.push_back({Horizon(bands.columns(), bands.of_band(b)), {}, {}});
  }

  /// Finds the visible parts of the edges of the lists, in order.
  void take(std::vector<EdgeList>& lists) {
    parallel_tasks(bands_.size(), [&](std::size_t b) {
      for (EdgeList& list : lists) take(list, b);
    });
  }

  /// Largest gap over which spans of two bands are joined.
  double least() const { return bands_.front().horizon.least(); }

 private:
  struct Band {
    Horizon horizon;
    std::vector<Span> above, below;  ///< scratch
  };

  void take(EdgeList& list, std::size_t b) {
    Band& band = bands_[b];
    for (const std::uint32_t number : list.of_band[b]) {
      if constexpr (Horizon::kCovers) {
        if (number & EdgeList::kTriangle) {
          band.horizon.cover(list.triangles[number & ~EdgeList::kTriangle]);
          continue;
        }
      }
      HorizonEdge& edge = list.edges[number];
      if (edge.is_tested() && edge.first_band <= b && b <= edge.last_band) {
        band.above.clear();
        band.below.clear();
        const bool open = band.horizon.find_seen(edge, band.above, band.below);
        if (edge.line.upright()) edge.open = open;  // an upright line lies in one band
        for (const Span& span : band.above) list.seen[b].push_back({number, false, span});
        for (const Span& span : band.below) list.seen[b].push_back({number, true, span});
      }
      if constexpr (!Horizon::kCovers) {
        if (edge.upper || edge.lower) band.horizon.raise(edge);
      }
    }
  }

  std::vector<Band> bands_;
};

template <class Horizon>
class PartSweep {
 public:
  PartSweep(const GridPart& grid, const View& view, const HorizonOptions& options, const Columns& columns, LineStore& store)
      : grid_(grid),
        eye_(view, PlaneProjection(view.camera, grid.columns.sign, grid.rows.sign)),
        bands_(columns),
        edges_(grid, view, options, eye_, bands_, Horizon::kCovers),
        hiding_(bands_),
        lines_(eye_, columns, hiding_.least(), store),
        store_(store) {}

  /// Calls progress(rows done). Returns the number of tested edges of the surface.
  template <class Progress>
  std::size_t run(Progress progress) {
    std::size_t tested = 0;
    std::vector<EdgeList> lists;
    share_lines_ahead([](std::vector<Span>& here, std::vector<Span>& shared) { here = std::move(shared); });
    while (const std::size_t rows = edges_.next(lists)) {
      hiding_.take(lists);
      for (EdgeList& list : lists) {
        lines_.add(list);
        tested += list.tested;
      }
      progress(rows);
    }
    for (CurveTracker& curve : edges_.column_curves()) curve.end();
    lists.resize(1);
    edges_.add_back_lines(lists.front());
    hiding_.take(lists);
    lines_.add(lists.front());
    share_lines_ahead([](std::vector<Span>& here, std::vector<Span>& shared) { shared = std::move(here); });
    return tested;
  }

 private:
  /// Calls share(spans drawn here, spans of all parts) for the curves straight in front of the eye. Each part tests one
  /// side of these curves; on them v has the same value for both parts.
  template <class Share>
  void share_lines_ahead(Share share) {
    const GridAxis::Part &columns = grid_.columns, &rows = grid_.rows;
    const auto at = [&](std::size_t column, std::size_t row) {
      return eye_.sample(grid_.placed(grid_.x.at[columns.order[column]], grid_.y.at[rows.order[row]], 0)).seen.u();
    };
    UprightLines& lines = lines_.upright_lines();
    if (columns.begin > 0)
      share(lines.drawn_at(at(columns.begin, rows.order.size() - 1)), store_.column_ahead[rows.sign > 0]);
    if (rows.begin > 0) share(lines.drawn_at(at(columns.order.size() - 1, rows.begin)), store_.row_ahead[columns.sign > 0]);
  }

  GridPart grid_;
  Eye eye_;
  Bands bands_;
  PartEdges edges_;
  HidingBands<Horizon> hiding_;
  PartLines lines_;
  LineStore& store_;
};

/// Columns over the extent of the grid across the picture: `resolution` if it is not 0; else as many as the grid has
/// rows and columns, or fewer where its edges would span too many.
Columns picture_columns(const Camera& camera, const PlaneProjection& projection, const GridAxis& x, const GridAxis& y,
                        std::size_t resolution, bool transposed) {
  const std::size_t count = resolution ? resolution : x.at.size() + y.at.size();
  if (camera.perspective) return {-1, 1, count};
  const auto u = [&](double cx, double cy) { return projection(transposed ? Point3{cy, cx, 0} : Point3{cx, cy, 0}).u(); };
  const std::array corners{u(x.at.front(), y.at.front()), u(x.at.front(), y.at.back()), u(x.at.back(), y.at.front()),
                           u(x.at.back(), y.at.back())};
  const auto [from, to] = std::minmax_element(corners.begin(), corners.end());
  if (resolution) return {*from, *to, count};
  return {*from, *to, column_count(x.at.size(), corners[2] - corners[0], y.at.size(), corners[1] - corners[0])};
}

/// The view with its eye moved exactly over samples from which it differs only by rounding.
View with_eye_over(const View& view, int column, const GridAxis& x, int row, const GridAxis& y) {
  View study = view;
  if (x.eye()) study.camera.eye[column] = *x.eye();
  if (y.eye()) study.camera.eye[row] = *y.eye();
  return study;
}

/// Joins the contour lines of one height after the other.
void join(std::vector<Chains>& chains, Polylines& lines, std::vector<std::uint32_t>& levels) {
  for (std::uint32_t level = 0; level < chains.size(); ++level) {
    append(lines, chains[level].finish());
    levels.resize(lines.size(), level);
  }
}

template <class Horizon>
HorizonLines sweep_all(const HeightSource& heights, bool transposed, const View& view, const HorizonOptions& options,
                       Statistics& statistics) {
  const auto eye = [&](int axis) { return view.camera.perspective ? std::optional(view.camera.eye[axis]) : std::nullopt; };
  const int column = transposed ? 1 : 0, row = 1 - column;
  const GridAxis x(heights.x(), transposed ? options.y_stride : options.x_stride, eye(column));
  const GridAxis y(heights.y(), transposed ? options.x_stride : options.y_stride, eye(row));
  const View study = with_eye_over(view, column, x, row, y);
  const Camera& camera = study.camera;
  const auto parts_x = x.parts(camera.forward[column]), parts_y = y.parts(camera.forward[row]);

  const Chains none(view.window);
  const std::vector<Chains> none_of_any(options.contours.size(), none);
  LineStore store{{}, none, none, none_of_any, none_of_any, {}, {}};
  store.lines.back_lines.resize(options.back_lines.size());
  const double all_rows = static_cast<double>(parts_x.size() * y.at.size());
  double done = 0;
  const auto progress = [&](std::size_t rows) {
    done += static_cast<double>(rows);
    if (options.progress) options.progress(std::min(1.0, done / all_rows));
  };
  std::size_t segments = 0;
  for (const GridAxis::Part& py : parts_y) {
    for (const GridAxis::Part& px : parts_x) {
      const Columns columns =
          picture_columns(camera, PlaneProjection(camera, px.sign, py.sign), x, y, options.resolution, transposed);
      PartSweep<Horizon> sweep({heights, x, y, px, py, transposed}, study, options, columns, store);
      segments += sweep.run(progress);
    }
  }
  HorizonLines lines = std::move(store.lines);
  lines.outline = store.outline.finish();
  lines.border = store.border.finish();
  join(store.contours, lines.contours, lines.contour_levels);
  join(store.base_contours, lines.base_contours, lines.base_levels);
  for (auto& spans : lines.back_lines) {
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
  }
  statistics.count("segments studied", segments);
  statistics.count("curve strokes", lines.curves.size() + lines.underside.size());
  statistics.count("outline strokes", lines.outline.size() + lines.border.size());
  statistics.count("contour strokes", lines.contours.size() + lines.base_contours.size());
  return lines;
}

}  // namespace
}  // namespace horizon

namespace {

/// Whether the study needs Coverage: it has lines off the surface, and the eye is over the grid. Then the surface
/// reaches down to the point below the eye, and no edge lowers the lower horizon accordingly.
bool needs_coverage(const HeightSource& heights, const Camera& camera, const HorizonOptions& options) {
  if (!camera.perspective || (options.back_lines.empty() && !options.contour_base)) return false;
  const Point3& eye = camera.eye;
  return heights.x().front() < eye.x && eye.x < heights.x().back() && heights.y().front() < eye.y &&
         eye.y < heights.y().back();
}

/// The view to be studied. If a row or a column is so narrow on the page that its ends coincide, it is seen end on. The
/// study then looks exactly along it, so that it lies on one upright line, in order along the lines of sight. The page
/// keeps the original view.
View along_axis_if_nearly(const HeightSource& heights, const View& view) {
  View study = view;
  Point3& forward = study.camera.forward;
  const double level = std::hypot(forward.x, forward.y);
  if (view.camera.perspective || level == 0) return study;
  const auto width_mm = [&](double across, const std::vector<double>& at) {
    return std::abs(across) / level * (at.back() - at.front()) * view.scale;
  };
  if (width_mm(forward.y, heights.x()) <= kLeastPartMm) {
    forward = {std::copysign(level, forward.x), 0, forward.z};
  } else if (width_mm(forward.x, heights.y()) <= kLeastPartMm) {
    forward = {0, std::copysign(level, forward.y), forward.z};
  }
  return study;
}

}  // namespace

HorizonLines horizon_lines(const HeightSource& heights, const View& view, const HorizonOptions& options,
                           Statistics& statistics) {
  using namespace horizon;
  const View study = along_axis_if_nearly(heights, view);
  const bool by_curves = options.hidden_by == HiddenBy::curves;
  const auto sweep = [&](const HeightSource& source, bool transposed) {
    if (options.resolution) return sweep_all<TwoHorizons<PixelEnvelope>>(source, transposed, study, options, statistics);
    // Hiding curves cover no area, so the classical method cannot handle holes.
    const auto has_holes = [&] { return options.holes ? *options.holes : survey(heights).holes; };
    if (!by_curves && (needs_coverage(heights, study.camera, options) || has_holes())) {
      return sweep_all<GeneralHorizon>(source, transposed, study, options, statistics);
    }
    return sweep_all<TwoHorizons<ExactEnvelope>>(source, transposed, study, options, statistics);
  };
  // Columns may lie along the lines of sight, since a strip has the cells on both sides of them; rows may not.
  const Point3& forward = study.camera.forward;
  if (!study.camera.perspective && forward.y == 0 && forward.x != 0) return sweep(*transposed(heights), true);
  return sweep(heights, false);
}

}  // namespace ligne
