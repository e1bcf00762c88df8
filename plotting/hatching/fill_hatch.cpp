/// Fills areas of read drawings with strokes.

#include <cmath>
#include <iterator>
#include <span>
#include <stdexcept>

#include "plotting/hatching/hatch.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne {
namespace {

/// Distance of strokes, in pen widths: of strokes that cover an area, and of strokes for the darkest tone. Adjustable.
constexpr double kCoverPens = 0.8, kTonePens = 4;
/// Brightness, from 0 to 1, above which an area stays white.
constexpr double kBrightest = 0.92;
/// Most runs of regions on the lines of hatches, so that a file cannot ask for endless work.
constexpr double kMostRuns = 2e8;

}  // namespace

FillHatch FillHatches::of(std::string_view layer, std::string_view color) const {
  FillHatch hatch = all;
  for (const std::string_view name : {color, layer}) {
    if (const auto spacing = spacing_mm_of.find(name); spacing != spacing_mm_of.end()) hatch.spacing_mm = spacing->second;
    if (const auto angle = degrees_of.find(name); angle != degrees_of.end()) hatch.angle_degrees = angle->second;
    hatch.cross = hatch.cross || crossed.contains(name);
  }
  return hatch;
}

void hatch_regions(ReadDrawing& drawing, const FillReading& fills) {
  if (drawing.regions.empty())
    throw std::runtime_error("has no regions to hatch: --method atherton-weiler or warnock of ligne draw stores them");
  std::map<std::string, std::vector<std::size_t>> by_material;
  for (std::size_t i = 0; i < drawing.regions.size(); ++i) by_material[drawing.regions[i].material].push_back(i);
  std::vector<Layer> layers;
  for (const auto& [material, numbers] : by_material) {
    const FillHatch how = fills.hatches.of("material:" + material, "hatch");
    const double spacing = how.spacing_mm.value_or((how.tone ? kTonePens : kCoverPens) * fills.pen_width_mm);
    const double line_mm = hatch_line_mm(spacing, fills.pen_width_mm);
    Polylines lines;
    const auto closest = static_cast<std::uint32_t>(std::lround(spacing / line_mm));
    std::vector<SurfaceHatch> surfaces;
    double work = 0;
    for (const std::size_t i : numbers) {
      const ReadRegion& region = drawing.regions[i];
      std::uint32_t rows = kRowCycle;
      if (how.tone && region.light) {
        rows = *region.light > kBrightest ? 0 : static_cast<std::uint32_t>(std::ceil((1 - *region.light) * kRowCycle));
      }
      surfaces.push_back({closest, rows, region.patch, 0});
      Rect box;
      for (const Point2 p : region.contours.front()) box.extend(p);
      work += std::hypot(box.width(), box.height()) / line_mm;
    }
    if (work > kMostRuns) throw std::runtime_error("has regions whose hatching takes too much work");
    for (const double turn : {0.0, 90.0}) {
      if (turn > 0 && !how.cross) continue;
      const HatchFrame frame({drawing.page.width_mm / 2, drawing.page.height_mm / 2}, how.angle_degrees + turn);
      std::vector<SurfaceRun> runs;
      for (std::uint32_t k = 0; k < numbers.size(); ++k)
        add_runs(drawing.regions[numbers[k]].contours, k, frame, line_mm, runs);
      hatch_runs(frame, line_mm, runs, surfaces, std::span(&fills.pen_width_mm, 1), std::span(&lines, 1));
    }
    if (lines.size() > 0) layers.push_back({"hatch", std::move(lines), material});
  }
  drawing.drawing.layers.insert(drawing.drawing.layers.begin(), std::make_move_iterator(layers.begin()),
                                std::make_move_iterator(layers.end()));
}

}  // namespace ligne
