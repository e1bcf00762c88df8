#pragma once
/// A drawing dealt out to pens: what a plotter draws, stroke by stroke.

#include <functional>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "plotting/device.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/pens.hpp"
#include "plotting/writers.hpp"

namespace ligne {

/// What one pen draws, in order, page mm.
struct PenLines {
  Pen pen;
  Polylines lines;
};

/// Pens in the order in which they are used, by number; each is there once and has lines.
struct Plot {
  Page page;
  std::vector<PenLines> pens;
};

struct PlotRequest {
  PlotOptions style;           ///< page and line styles of the layers
  PenTable pens;               ///< empty: everything to pen 1
  bool pen_per_layer = false;  ///< with an empty table: a pen for every layer, numbered from 1
  PathOptions paths;
};

/// Deals the layers out to their pens and turns texts and dashes into strokes, nothing else: lines stay in their order.
Plot deal_to_pens(const Drawing& drawing, const PlotRequest& request);

/// The same with the lines of every pen joined and ordered. Solid lines are made once and joined before anything is cut; so
/// are dashed ones before they become dashes.
Plot make_plot(const Drawing& drawing, const PlotRequest& request);

/// Lines of every layer joined and, with Optimize::full, ordered; layers, texts and dashes stay what they are.
Drawing optimize_layers(const Drawing& drawing, const PathOptions& options);

/// What is drawn, page mm; empty when nothing is.
Rect ink_of(const Plot& plot);
Rect ink_of(const Drawing& drawing);

/// Sum over the pens, each from the home position.
PathLengths measure(const Plot& plot, Point2 home, bool returns);
PathLengths measure(const Drawing& drawing, Point2 home, bool returns);

/// Time that the device takes, in seconds: ways at its speeds, lifts, changes of pens.
double plot_seconds(const Device& device, const PathLengths& lengths, std::size_t pens);

}  // namespace ligne
