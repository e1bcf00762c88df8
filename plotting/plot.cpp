#include "plotting/plot.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "plotting/dashes.hpp"
#include "plotting/stroke_text.hpp"

namespace ligne {
namespace {

/// Lines of one style.
struct StyledLines {
  std::vector<double> dashes_mm;
  StrokeStyle look;
  Polylines lines;
};

/// The strokes of one pen, before dashes are cut.
struct PenWork {
  Pen pen;
  double width_mm = 0;
  std::vector<StyledLines> styles;
};

bool empty(const Polylines& lines) {
  return std::all_of(lines.begin.begin(), lines.begin.end(), [](std::uint32_t b) { return b == 0; });
}

/// Assigns layers to pens.
class PenAssigner {
 public:
  PenAssigner(const Drawing& drawing, const PlotRequest& request) : request_(request) {
    for (const Layer& layer : drawing.layers) {
      if (!empty(layer.lines)) taken_.insert(parse_layer_label(layer.name).number);
    }
    taken_.insert(0);
  }

  Pen pen_of(const Layer& layer) {
    const PenTable& table = request_.pens;
    const auto named = table.named_pen_of(layer.name, layer.material, layer.shade, layer.object);
    if (named) return table.pen(*named);
    LayerLabel label = parse_layer_label(layer.name);
    if (table.names_rest) label.number = 0;
    const bool per_layer = table.empty() && request_.pen_per_layer;
    Pen pen = table.pen(label.number > 0 ? label.number : table.rest);
    if (per_layer && label.number == 0 && !label.skip) pen.number = next_number(layer.name);
    if (per_layer || label.number > 0) pen.name = label.name;
    if (per_layer && (label.number > 0 || label.skip)) pen.label = layer.name;
    pen.skip = pen.skip || label.skip;
    pen.pause = pen.pause || label.pause;
    if (label.speed) pen.speed = label.speed;
    if (label.height) pen.height = label.height;
    if (label.delay_ms) pen.delay_ms = label.delay_ms;
    return pen;
  }

 private:
  /// The next free number of a pen; parts of one layer get the same number.
  unsigned next_number(const std::string& layer) {
    const auto [entry, added] = number_of_.emplace(layer, 0);
    if (!added) return entry->second;
    while (taken_.contains(next_)) ++next_;
    return entry->second = next_++;
  }

  const PlotRequest& request_;
  std::set<unsigned> taken_;
  std::map<std::string, unsigned> number_of_;
  unsigned next_ = 1;
};

/// Whether both are one pen with the same settings, so that their lines may be drawn in any order.
bool one_pen(const Pen& a, const Pen& b) {
  return std::tie(a.number, a.label, a.skip, a.pause, a.speed, a.height, a.delay_ms) ==
         std::tie(b.number, b.label, b.skip, b.pause, b.speed, b.height, b.delay_ms);
}

/// Layers by pen, in the order of the pens' numbers.
std::vector<PenWork> work_of(const Drawing& given, const PlotRequest& request) {
  Drawing drawing = given;
  draw_texts_as_strokes(drawing);
  std::vector<PenWork> work;
  PenAssigner assigner(drawing, request);
  for (Layer& layer : drawing.layers) {
    if (empty(layer.lines)) continue;
    Pen pen = assigner.pen_of(layer);
    const LineStyle style = request.style.style_of(layer);
    const bool keeps_look = request.keep_looks && !request.pens.pens.contains(pen.number);
    auto entry = std::find_if(work.begin(), work.end(), [&](const PenWork& other) { return one_pen(other.pen, pen); });
    if (entry == work.end()) {
      if (keeps_look) pen.color = style.color;
      entry = work.insert(work.end(), {pen, 0, {}});
    }
    const double width = pen.width_mm.value_or(style.width_mm);
    entry->width_mm = std::max(entry->width_mm, width);
    // Dash lengths are proportional to the width of the pen that draws them.
    std::vector<double> dashes = style.dashes_mm;
    for (double& dash : dashes) dash *= width / style.width_mm;
    const StrokeStyle look = keeps_look ? StrokeStyle{style.color, width} : StrokeStyle{};
    const auto same = std::find_if(entry->styles.begin(), entry->styles.end(),
                                   [&](const StyledLines& s) { return s.dashes_mm == dashes && s.look == look; });
    if (same == entry->styles.end()) {
      entry->styles.push_back({std::move(dashes), look, std::move(layer.lines)});
    } else {
      append(same->lines, layer.lines);
    }
  }
  for (PenWork& entry : work) {
    if (!entry.pen.width_mm) entry.pen.width_mm = entry.width_mm;
  }
  std::stable_sort(work.begin(), work.end(), [](const PenWork& a, const PenWork& b) { return a.pen.number < b.pen.number; });
  return work;
}

Polylines cut(const StyledLines& style, const Pen& pen) {
  return style.dashes_mm.empty() ? style.lines : cut_dashes(style.lines, style.dashes_mm, *pen.width_mm);
}

void drop_short(PenLines& pen, double min_length_mm) {
  if (!(min_length_mm > 0)) return;
  const std::vector<std::uint32_t> kept = long_strokes(pen.lines, min_length_mm);
  pen.lines = picked(pen.lines, kept);
  if (pen.looks.empty()) return;
  for (std::size_t i = 0; i < kept.size(); ++i) pen.look_of[i] = pen.look_of[kept[i]];
  pen.look_of.resize(kept.size());
}

/// The lines of a pen unchanged, or, if `join` is given, joined within each style.
PenLines lines_of(const PenWork& work, const JoinTolerances* join) {
  PenLines pen{work.pen, {}};
  std::vector<StrokeStyle>& looks = pen.looks;
  for (const StyledLines& style : work.styles) {
    const Polylines strokes =
        join ? cut({style.dashes_mm, style.look, join_strokes(style.lines, *join)}, work.pen) : cut(style, work.pen);
    append(pen.lines, strokes);
    const auto look = static_cast<std::uint32_t>(std::find(looks.begin(), looks.end(), style.look) - looks.begin());
    if (look == looks.size()) looks.push_back(style.look);
    pen.look_of.resize(pen.lines.size(), look);
  }
  if (looks.size() > 1) return pen;
  looks.clear();
  pen.look_of.clear();
  // Dashes may continue lines of other styles, or lie on them. Gaps between dashes stay.
  if (join && work.styles.size() > 1) pen.lines = join_strokes(pen.lines, {0, join->overlap_mm, 0, 0});
  return pen;
}

void put_in_order(PenLines& pen, const OrderOptions& options) {
  std::vector<std::uint32_t> order;
  pen.lines = order_strokes(pen.lines, options, &order);
  if (pen.looks.empty()) return;
  std::vector<std::uint32_t> look_of;
  look_of.reserve(order.size());
  for (const std::uint32_t stroke : order) look_of.push_back(pen.look_of[stroke]);
  pen.look_of = std::move(look_of);
}

/// Joins and orders the lines. If the plot would then take longer than in the order of the drawing, coincident lines
/// are kept; if it still does, lines are not joined.
PenLines optimized(const PenWork& work, const PathOptions& paths) {
  PenLines before = lines_of(work, nullptr);
  drop_short(before, paths.min_length_mm);
  if (paths.optimize == Optimize::off) return before;
  const auto seconds = [&](const PenLines& pen) {
    return paths.pace.seconds(measure(pen.lines, paths.order.home, paths.order.returns));
  };
  // With a minimum length or inside_first the times are not compared. Joining then keeps more strokes of minimum
  // length, since a piece of a long line is long.
  const double allowed =
      paths.min_length_mm > 0 || paths.order.inside_first ? std::numeric_limits<double>::infinity() : seconds(before);
  const bool orders = paths.optimize != Optimize::join;
  if (paths.optimize != Optimize::order) {
    JoinTolerances twice = paths.tolerances;
    twice.overlap_mm = 0;
    for (const JoinTolerances& tolerances : {paths.tolerances, twice}) {
      PenLines pen = lines_of(work, &tolerances);
      drop_short(pen, paths.min_length_mm);
      if (orders) put_in_order(pen, paths.order);
      if (seconds(pen) <= allowed) return pen;
    }
  }
  if (orders) put_in_order(before, paths.order);
  return before;
}

}  // namespace

Plot assign_pens(const Drawing& drawing, const PlotRequest& request) {
  Plot plot{request.style.page, {}};
  for (const PenWork& work : work_of(drawing, request)) plot.pens.push_back(lines_of(work, nullptr));
  return plot;
}

Plot make_plot(const Drawing& drawing, const PlotRequest& request) {
  std::vector<PenWork> work = work_of(drawing, request);
  Plot plot{request.style.page, std::vector<PenLines>(work.size())};
  parallel_for(work.size(), [&](std::size_t i) { plot.pens[i] = optimized(work[i], request.paths); });
  return plot;
}

Drawing optimize_layers(const Drawing& drawing, const PathOptions& options) {
  Drawing result = drawing;
  parallel_for(result.layers.size(),
               [&](std::size_t i) { result.layers[i].lines = optimize_paths(result.layers[i].lines, options); });
  return result;
}

Rect drawn_bounds(const Plot& plot) {
  Rect ink;
  for (const PenLines& pen : plot.pens) {
    if (pen.pen.skip) continue;
    for (const Point2 p : pen.lines.points) ink.extend(p);
  }
  return ink;
}

Rect drawn_bounds(const Drawing& drawing) {
  Rect ink;
  for (const Layer& layer : drawing.layers) {
    for (const Point2 p : layer.lines.points) ink.extend(p);
  }
  return ink;
}

PathLengths measure(const Plot& plot, Point2 home, bool returns) {
  PathLengths sum;
  for (const PenLines& pen : plot.pens) {
    if (!pen.pen.skip) sum += measure(pen.lines, home, returns);
  }
  return sum;
}

PathLengths measure_in_turn(const Plot& plot, Point2 home, bool returns) {
  Polylines all;
  for (const PenLines& pen : plot.pens) {
    if (!pen.pen.skip) append(all, pen.lines);
  }
  return measure(all, home, returns);
}

PathLengths measure(const Drawing& drawing, Point2 home, bool returns) {
  PathLengths sum;
  for (const Layer& layer : drawing.layers) sum += measure(layer.lines, home, returns);
  return sum;
}

std::size_t pen_changes(const Plot& plot) {
  std::set<unsigned> numbers;
  for (const PenLines& pen : plot.pens) {
    if (!pen.pen.skip) numbers.insert(pen.pen.number);
  }
  return numbers.empty() ? 0 : numbers.size() - 1;
}

PathPace pace_of(const Device& device) { return {device.down_mm_s, device.up_mm_s, device.lift_s}; }

double plot_seconds(const Device& device, const PathLengths& lengths, std::size_t pen_changes) {
  return pace_of(device).seconds(lengths) + static_cast<double>(pen_changes) * device.pen_change_s;
}

}  // namespace ligne
