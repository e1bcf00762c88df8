#pragma once
/// A drawing from a file, ours or anybody's, made ready for pens.

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
  std::optional<PageSize> page;  ///< nothing: that of the drawing
  bool landscape = false, portrait = false;
  double margin_mm = 10;
  std::optional<double> pen_width_mm;     ///< nothing: the widths of the drawing, and 0.35 mm where it tells none
  LineWidths widths_mm{};                 ///< of layers by their names
  std::optional<double> scale = 1;        ///< nothing: what is drawn fills the page
  std::set<std::string> skip;             ///< kinds of SVG content that may be left out
  SvgReading reading;                     ///< how strictly an SVG is read, and the size of its units
  std::optional<FillReading::How> fills;  ///< nothing: outline, or hatch where hatches are given
  StoredPaint paint;                      ///< areas of the order of painting that a ligne-drawing keeps
  bool occlude = false;                   ///< opaque areas hide
  bool own_layer = false;                 ///< areas, white ones too, hide only what is in their layer
  FillHatches hatches;
  bool hatches_given = false;
  std::optional<PageSize> tile;                 ///< paper of the sheets that the page is cut into; nothing: one sheet
  double overlap_mm = 5;                        ///< what neighbouring sheets have in common
  std::optional<std::array<unsigned, 2>> grid;  ///< columns and rows of cells, a drawing in each
  OutputFormat format = OutputFormat::svg;
  double dpi = 150;
  bool curves = false;  ///< arcs where lines are tessellated ones: SVG, PDF, PNG
  PlotterRequest plotter;
  MemoryLimit memory;
};

/// A drawing as it stands in a file.
struct DrawingText {
  std::string name;  ///< stands in messages
  std::string text;
};

/// Reads the file, or standard input for "-"; it is added to `opened`. Throws InputError.
DrawingText read_drawing_text(const std::string& file, InputFiles& opened);

/// Whether it is taken for an SVG, by its first character.
bool is_svg(const DrawingText& drawing);

/// Throws RequestError for a format that has no strokes.
void check(const PlotDrawingRequest& request);

/// The drawings, ligne-drawings or SVGs by their first characters, in their places on the page, dealt to pens and written;
/// several in the cells of a grid. `tile_files`: sheets become files of their own, also of a PDF, which can hold them as
/// pages. Warnings and times go to `run`. Throws RequestError, InputError, std::runtime_error.
Picture plot_drawings(std::span<const DrawingText> drawings, const PlotDrawingRequest& request, bool tile_files,
                      RunReport& run);

}  // namespace ligne
