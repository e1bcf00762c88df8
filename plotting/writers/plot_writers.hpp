#pragma once
/// Writers of plots.

#include <string>

#include "plotting/plot.hpp"

namespace ligne {

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
