#pragma once
/// A plot: the strokes of a drawing, divided among pens and in drawing order.

#include <array>
#include <cstdint>
#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/devices/device.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// Colour and width of a stroke, for plots that are written as pictures.
struct StrokeStyle {
  std::array<double, 3> color{0, 0, 0};
  double width_mm = 0;
  friend bool operator==(const StrokeStyle&, const StrokeStyle&) = default;
};

/// The strokes of one pen in drawing order.
struct PenLines {
  Pen pen;
  Polylines lines;                       ///< page mm
  std::vector<StrokeStyle> looks{};      ///< the different styles of the strokes; empty if all have the style of the pen
  std::vector<std::uint32_t> look_of{};  ///< per stroke: index into `looks`; empty with it
  std::vector<std::uint32_t> actions{};  ///< strokes before which the machine performs its action, ascending
                                         ///< (LongPlotRequest::action in plot_parts.hpp)
  std::vector<std::uint32_t> pauses{};   ///< strokes before which the machine waits, ascending
};

/// Pens in the order of use, ascending by number. A pen appears more than once if layers give it different settings or,
/// in pictures, different names.
struct Plot {
  Page page;
  std::vector<PenLines> pens;
};

struct PlotRequest {
  PlotOptions style;           ///< page and line styles of the layers
  PenTable pens;               ///< if empty, pen 1 draws everything
  bool pen_per_layer = false;  ///< with an empty table: one pen per layer, numbered as the layer's name says or else
                               ///< with the next free number
  bool keep_looks = false;     ///< strokes of pens that the table does not describe keep their colours and widths
  PathOptions paths;
};

/// Divides the layers among their pens, and converts texts and dashes to strokes. The order of lines does not change.
Plot assign_pens(const Drawing& drawing, const PlotRequest& request);

/// Divides the layers among their pens, then joins and orders the lines of every pen as `request.paths` says. Dashed
/// lines are joined before they are cut into dashes. If joining would make the plot of a pen slower, its lines are only
/// ordered, except with a minimum length or OrderOptions::inside_first.
Plot make_plot(const Drawing& drawing, const PlotRequest& request);

/// Joins and orders the lines of every layer as the options say. Texts and line styles do not change.
Drawing optimize_layers(const Drawing& drawing, const PathOptions& options);

/// Bounding box of the drawn points, page mm; empty if nothing is drawn. Pens that are skipped do not count.
Rect drawn_bounds(const Plot& plot);
Rect drawn_bounds(const Drawing& drawing);

/// Sum of the path lengths of all pens that are not skipped, if every pen starts at `home`. Ordering assumes the same.
PathLengths measure(const Plot& plot, Point2 home, bool returns);
/// Path lengths if the pens that are not skipped are plotted one after the other: each starts where the previous one
/// ended.
PathLengths measure_in_turn(const Plot& plot, Point2 home, bool returns);
/// Sum of the path lengths of all layers, if every layer starts at `home`.
PathLengths measure(const Drawing& drawing, Point2 home, bool returns);

/// Number of times the plotter changes its pen.
std::size_t pen_changes(const Plot& plot);

/// The speeds of a device.
PathPace pace_of(const Device& device);
/// Plotting time in seconds: travel at the device's speeds, pen lifts, and pen changes.
double plot_seconds(const Device& device, const PathLengths& lengths, std::size_t pen_changes);

/// Actions of a machine besides drawing: `action` before the strokes of PenLines::actions, and `park`, where it goes
/// when pens are changed.
struct PlotStops {
  const DeviceAction* action = nullptr;
  const DevicePlace* park = nullptr;
};

/// Writes HPGL or G-code, by the device's language, with the commands of the device's description. Throws
/// std::runtime_error if the device does not hold a pen of the plot. Pens to be skipped are left out.
std::string write_plot(const Plot& plot, const Device& device, const DeviceFrame& frame, const PlotStops& stops = {});

/// The plot as a drawing with a layer for every pen, named as layer_label names it, and the style of these layers for
/// PlotOptions::style.
Drawing drawing_of(const Plot& plot);
std::function<LineStyle(const std::string&)> styles_of(const Plot& plot);

/// An SVG that shows the way of the pens: strokes in colours from blue (first) over green and yellow to red (last), the
/// raised pen thin and grey.
std::string write_preview(const Plot& plot, Point2 home, bool returns);

}  // namespace ligne
