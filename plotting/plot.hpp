#pragma once
/// A drawing dealt out to pens: what a plotter draws, stroke by stroke.

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/devices/device.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// How strokes look in a picture.
struct StrokeLook {
  std::array<double, 3> color{0, 0, 0};
  double width_mm = 0;
  friend bool operator==(const StrokeLook&, const StrokeLook&) = default;
};

/// The strokes of one pen, in order, page mm.
struct PenLines {
  Pen pen;
  Polylines lines;
  std::vector<StrokeLook> looks{};       ///< where strokes do not all look like their pen
  std::vector<std::uint32_t> look_of{};  ///< with `looks`: of each stroke the index of its own
  std::vector<std::uint32_t> actions{};  ///< strokes before which the machine does its action, ascending (plot_parts.hpp)
  std::vector<std::uint32_t> pauses{};   ///< strokes before which it waits, ascending
};

/// Pens in the order in which they are used, by number. One is there several times where layers give it other settings,
/// or, in pictures, other names.
struct Plot {
  Page page;
  std::vector<PenLines> pens;
};

struct PlotRequest {
  PlotOptions style;           ///< page and line styles of the layers
  PenTable pens;               ///< empty: everything to pen 1
  bool pen_per_layer = false;  ///< with an empty table: a pen for every layer, of the number in its name, else numbered on
  bool keep_looks = false;     ///< strokes of pens that the table does not describe keep their colours and widths
  PathOptions paths;
};

/// Deals the layers out to their pens and turns texts and dashes into strokes, nothing else: lines stay in their order.
Plot deal_to_pens(const Drawing& drawing, const PlotRequest& request);

/// Makes a plot with the lines of every pen joined and ordered. Solid lines are made once and joined before anything is cut;
/// so are dashed ones before they become dashes.
Plot make_plot(const Drawing& drawing, const PlotRequest& request);

/// Lines of every layer joined and, with Optimize::full, ordered; layers, texts and dashes stay what they are.
Drawing optimize_layers(const Drawing& drawing, const PathOptions& options);

/// The box of the ink, page mm; empty when nothing is drawn.
Rect ink_of(const Plot& plot);
Rect ink_of(const Drawing& drawing);

/// Sum over the pens that are not skipped, each from the home position, as each is put in order.
PathLengths measure(const Plot& plot, Point2 home, bool returns);
/// Lengths of the pens that are not skipped, plotted one after the other: pens are changed where the last one ends.
PathLengths measure_in_turn(const Plot& plot, Point2 home, bool returns);
PathLengths measure(const Drawing& drawing, Point2 home, bool returns);

/// How often a plotter changes its pen.
std::size_t pen_changes(const Plot& plot);

PathPace pace_of(const Device& device);
/// Time that the device takes, in seconds: ways at its speeds, lifts, changes of pens.
double plot_seconds(const Device& device, const PathLengths& lengths, std::size_t pen_changes);

}  // namespace ligne
