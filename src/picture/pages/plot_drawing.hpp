#pragma once
/// Prepares a drawing from a file, a ligne-drawing or an SVG, for pens.

#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "files/input_file.hpp"
#include "picture/pages/paint_stored.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

/// The request for a plot of a drawing, with the defaults of the command line. Lengths are in mm.
struct PlotDrawingRequest {
  std::optional<PageSize> page;  ///< none: the page of the drawing
  bool landscape = false, portrait = false;
  double margin_mm = 10;
  std::optional<double> pen_width_mm;     ///< none: the widths of the drawing, or 0.35 mm if it has none
  LineWidths widths_mm{};                 ///< of layers, by name
  std::optional<double> scale = 1;        ///< none: the lines are scaled to fill the page
  std::set<std::string> skip;             ///< kinds of SVG content that may be left out
  SvgReading reading;                     ///< how strictly an SVG is read, and the size of its units
  std::optional<FillReading::How> fills;  ///< none: outline, or hatch if hatches are given
  StoredPaint paint;                      ///< painting of areas in the order that a ligne-drawing stores
  bool occlude = false;                   ///< whether opaque areas hide lines
  bool own_layer = false;                 ///< areas, white ones too, hide only lines of their layer
  FillHatches hatches;
  bool hatches_given = false;
  std::optional<PageSize> tile;                 ///< paper of the sheets that the page is cut into; none: one sheet
  double overlap_mm = 5;                        ///< width that adjacent sheets share
  std::optional<std::array<unsigned, 2>> grid;  ///< columns and rows of cells, one drawing in each
  OutputFormat format = OutputFormat::svg;
  double dpi = 150;
  bool curves = false;  ///< fit arcs to polylines: SVG, PDF, PNG
  PlotterRequest plotter;
  MemoryLimit memory;
};

/// The text of a drawing file.
struct DrawingText {
  std::string name;  ///< name for messages
  std::string text;
};

/// Reads the file, or standard input for "-", and adds it to `opened`. Throws InputError.
DrawingText read_drawing_text(const std::string& file, InputFiles& opened);

/// Whether the first character is that of an SVG.
bool is_svg(const DrawingText& drawing);

/// Throws RequestError if options contradict each other or the format.
void check(const PlotDrawingRequest& request);

/// Places the drawings on the page, several in the cells of a grid, assigns their lines to pens, and writes the result.
/// The first character distinguishes ligne-drawings from SVGs. `tile_files`: sheets become separate files even in PDF,
/// which could hold them as pages. Warnings and times go to `run`. Throws RequestError, InputError, std::runtime_error.
Picture plot_drawings(std::span<const DrawingText> drawings, const PlotDrawingRequest& request, bool tile_files,
                      RunReport& run);

}  // namespace ligne
