#include "visibility/horizon/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/surfaces/height_filters.hpp"
#include "view/tolerances.hpp"
#include "visibility/horizon/part_sweep.hpp"

namespace ligne {
namespace horizon {
namespace {

/// Extent of the grid across the picture.
std::pair<double, double> u_range(const Camera& camera, const PlaneProjection& projection, const GridAxis& x,
                                  const GridAxis& y, bool transposed) {
  if (camera.perspective) return {-1, 1};
  std::pair<double, double> range{1e300, -1e300};
  for (const double cx : {x.at.front(), x.at.back()}) {
    for (const double cy : {y.at.front(), y.at.back()}) {
      const double u = projection(transposed ? Point3{cy, cx, 0} : Point3{cx, cy, 0}).u();
      range = {std::min(range.first, u), std::max(range.second, u)};
    }
  }
  return range;
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
      const std::size_t cells = options.resolution ? options.resolution : x.at.size() + y.at.size();
      const auto range = u_range(camera, PlaneProjection(camera, px.sign, py.sign), x, y, transposed);
      const Columns columns(range.first, range.second, cells);
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
