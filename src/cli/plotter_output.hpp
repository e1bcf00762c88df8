#pragma once
/// From a drawing to the bytes of a file: what all commands that draw have in common.

#include <string>

#include "cli/parse.hpp"
#include "cli/plotter_options.hpp"
#include "cli/stages.hpp"
#include "drawing/drawing.hpp"
#include "plotting/writers.hpp"

namespace ligne {

/// SVG, PDF, PNG, HPGL or G-code. Writes the preview and the report where they are asked for, and adds the time of the path
/// work to `run`. `under` is a picture below the lines of a PNG.
std::string written(const Drawing& drawing, const PlotOptions& style, const PlotterSetup& setup, OutputFormat format,
                    RunFiles& files, RunReport& run, const GrayPicture* under = nullptr);

}  // namespace ligne
