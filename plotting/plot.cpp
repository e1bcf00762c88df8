#include "plotting/plot.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/parallel.hpp"
#include "plotting/dashes.hpp"
#include "plotting/stroke_text.hpp"

namespace ligne {
namespace {

/// Lines of one style.
struct StyledLines {
  std::vector<double> dashes_mm;
  Polylines lines;
};

/// What one pen draws, before dashes are cut.
struct PenWork {
  Pen pen;
  double width_mm = 0;
  std::vector<StyledLines> styles;
};

bool empty(const Polylines& lines) {
  return std::all_of(lines.begin.begin(), lines.begin.end(), [](std::uint32_t b) { return b == 0; });
}

/// Layers by pen, in the order of the pens' numbers.
std::vector<PenWork> work_of(const Drawing& given, const PlotRequest& request) {
  Drawing drawing = given;
  draw_texts_as_strokes(drawing);
  std::map<unsigned, PenWork> work;
  unsigned next = 1;
  for (Layer& layer : drawing.layers) {
    if (empty(layer.lines)) continue;
    Pen pen;
    if (!request.pens.empty()) {
      pen = request.pens.pen(request.pens.pen_of(layer.name, layer.material, layer.shade, layer.object));
    } else if (request.pen_per_layer) {
      pen.number = next++;
      pen.name = layer.name;
    } else {
      pen.number = request.pens.pen_of(layer.name, layer.material, layer.shade, layer.object);
    }
    const LineStyle style = request.style.style_of(layer);
    if (request.pens.empty() && request.pen_per_layer) pen.color = style.color;
    PenWork& entry = work[pen.number];
    const double width = pen.width_mm.value_or(style.width_mm);
    entry.width_mm = std::max(entry.width_mm, width);
    entry.pen = pen;
    // Dashes are told in widths of the pen that draws them.
    std::vector<double> dashes = style.dashes_mm;
    for (double& dash : dashes) dash *= width / style.width_mm;
    const auto same =
        std::find_if(entry.styles.begin(), entry.styles.end(), [&](const StyledLines& s) { return s.dashes_mm == dashes; });
    if (same == entry.styles.end()) {
      entry.styles.push_back({std::move(dashes), std::move(layer.lines)});
    } else {
      append(same->lines, layer.lines);
    }
  }
  std::vector<PenWork> list;
  for (auto& [number, entry] : work) {
    if (!entry.pen.width_mm) entry.pen.width_mm = entry.width_mm;
    list.push_back(std::move(entry));
  }
  return list;
}

Polylines cut(const StyledLines& style, const Pen& pen) {
  return style.dashes_mm.empty() ? style.lines : cut_dashes(style.lines, style.dashes_mm, *pen.width_mm);
}

Polylines optimized(PenWork& work, const PathOptions& paths) {
  Polylines lines;
  for (StyledLines& style : work.styles) {
    if (paths.optimize != Optimize::off) style.lines = join_strokes(style.lines, paths.tolerances);
    append(lines, cut(style, work.pen));
  }
  return paths.optimize == Optimize::full ? order_strokes(lines, paths.order) : lines;
}

}  // namespace

Plot deal_to_pens(const Drawing& drawing, const PlotRequest& request) {
  Plot plot{request.style.page, {}};
  for (const PenWork& work : work_of(drawing, request)) {
    Polylines lines;
    for (const StyledLines& style : work.styles) append(lines, cut(style, work.pen));
    plot.pens.push_back({work.pen, std::move(lines)});
  }
  return plot;
}

Plot make_plot(const Drawing& drawing, const PlotRequest& request) {
  std::vector<PenWork> work = work_of(drawing, request);
  Plot plot{request.style.page, std::vector<PenLines>(work.size())};
  parallel_for(work.size(), [&](std::size_t i) { plot.pens[i] = {work[i].pen, optimized(work[i], request.paths)}; });
  return plot;
}

Drawing optimize_layers(const Drawing& drawing, const PathOptions& options) {
  Drawing result = drawing;
  parallel_for(result.layers.size(),
               [&](std::size_t i) { result.layers[i].lines = optimize_paths(result.layers[i].lines, options); });
  return result;
}

Rect ink_of(const Plot& plot) {
  Rect ink;
  for (const PenLines& pen : plot.pens) {
    for (const Point2 p : pen.lines.points) ink.extend(p);
  }
  return ink;
}

Rect ink_of(const Drawing& drawing) {
  Rect ink;
  for (const Layer& layer : drawing.layers) {
    for (const Point2 p : layer.lines.points) ink.extend(p);
  }
  return ink;
}

PathLengths measure(const Plot& plot, Point2 home, bool returns) {
  PathLengths sum;
  for (const PenLines& pen : plot.pens) sum += measure(pen.lines, home, returns);
  return sum;
}

PathLengths measure(const Drawing& drawing, Point2 home, bool returns) {
  PathLengths sum;
  for (const Layer& layer : drawing.layers) sum += measure(layer.lines, home, returns);
  return sum;
}

double plot_seconds(const Device& device, const PathLengths& lengths, std::size_t pens) {
  return lengths.down_mm / device.down_mm_s + lengths.up_mm / device.up_mm_s +
         static_cast<double>(lengths.strokes) * device.lift_s +
         (pens > 1 ? static_cast<double>(pens - 1) * device.pen_change_s : 0);
}

}  // namespace ligne
