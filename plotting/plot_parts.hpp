#pragma once
/// Long plots: resuming after an interruption, splitting into parts, and actions of the machine in between. Strokes of
/// skipped pens do not count.

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

/// How a plot is split. No part exceeds the limit unless it is a single stroke, since strokes are not cut.
struct PlotSplit {
  SplitBy by = SplitBy::time;
  double most = 0;  ///< largest part: seconds, drawn mm, or number of strokes
};

struct LongPlotRequest {
  std::optional<PlotSplit> split;
  bool split_files = false;        ///< one file per part; otherwise the machine pauses between parts
  bool pen_files = false;          ///< one file per pen
  std::size_t from_stroke = 1;     ///< first stroke to draw, counted from 1
  double from_seconds = 0;         ///< start with the stroke that is being drawn at this time
  std::optional<double> every_mm;  ///< drawn length after which the machine performs `action` at the latest
  std::string action, park;        ///< an action and a position that the device defines; pens are changed at
                                   ///< `park`, or, if that is empty, where the pen is

  bool is_requested() const {
    return split || pen_files || from_stroke > 1 || from_seconds > 0 || every_mm || !park.empty();
  }
};

/// Number of strokes of a plot.
std::size_t stroke_count(const Plot& plot);

/// The plot without its first `strokes` strokes.
Plot without_first(const Plot& plot, std::size_t strokes);

/// Number of strokes that the device completes within the first `seconds`.
std::size_t strokes_within(const Plot& plot, const Device& device, Point2 home, double seconds);

/// Adds an action before the first stroke and whenever the pen has drawn `every_mm` since the last one. Strokes are cut
/// at these points.
Plot with_actions(const Plot& plot, double every_mm);

/// Splits a plot into parts, in order. `device` is needed to split by time, and may be null otherwise.
std::vector<Plot> split_plot(const Plot& plot, const PlotSplit& split, const Device* device, Point2 home);

/// Joins the parts to one plot with a pause between them.
Plot with_pauses(const std::vector<Plot>& parts);

/// Splits a plot by pens: pairs of pen number and plot.
std::vector<std::pair<unsigned, Plot>> plots_of_pens(const Plot& plot);

}  // namespace ligne
