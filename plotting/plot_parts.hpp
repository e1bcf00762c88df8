#pragma once
/// Long plots: the part that is left, the parts they are drawn in, and what the machine does on the way. Strokes of pens
/// that are skipped are not counted.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plotting/plot.hpp"

namespace ligne {

enum class SplitBy { time, distance, lifts };
inline constexpr std::string_view kSplitNames[] = {"time", "distance", "lifts"};

/// No part is larger, unless it is one stroke: strokes are not cut.
struct PlotSplit {
  SplitBy by = SplitBy::time;
  double most = 0;  ///< seconds, mm that the pen draws, or strokes
};

struct LongPlotRequest {
  std::optional<PlotSplit> split;
  bool split_files = false;  ///< a file for each part; otherwise the machine waits between them
  bool pen_files = false;    ///< a file for each pen
  std::size_t from_stroke = 1;
  double from_seconds = 0;         ///< the stroke that is drawn then is the first
  std::optional<double> every_mm;  ///< the machine does `action` before the pen has drawn more than that
  std::string action, park;        ///< names of the device; `park`: where pens are changed, empty: where it stands

  bool asked() const { return split || pen_files || from_stroke > 1 || from_seconds > 0 || every_mm || !park.empty(); }
};

/// How many strokes are drawn.
std::size_t stroke_count(const Plot& plot);

/// The plot without its first strokes.
Plot without_first(const Plot& plot, std::size_t strokes);

/// How many strokes are drawn, from first to last point, within the first `seconds` on the device.
std::size_t strokes_within(const Plot& plot, const Device& device, Point2 home, double seconds);

/// The plot with an action before the first stroke, and again before the pen has drawn more than `every_mm`: strokes are cut
/// there.
Plot with_actions(const Plot& plot, double every_mm);

/// The parts in their order. `device` tells the time, and may be null for the others.
std::vector<Plot> split_plot(const Plot& plot, const PlotSplit& split, const Device* device, Point2 home);

/// The parts as one plot in which the machine waits between them.
Plot with_pauses(const std::vector<Plot>& parts);

/// The strokes of each pen, with its number.
std::vector<std::pair<unsigned, Plot>> plots_of_pens(const Plot& plot);

}  // namespace ligne
