#pragma once
/// From a drawing to the bytes of a file.

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// One of several files of a plot.
struct PicturePart {
  std::string bytes;
  unsigned number = 0;  ///< of the part or the sheet, from 1; 0: of all
  unsigned pen = 0;     ///< 0: of all
};

/// The bytes of a file, and what was asked for beside it.
struct Picture {
  std::string bytes;
  std::string preview{};             ///< SVG of the pen's way, where PlotterRequest::preview asks for it
  std::vector<PicturePart> parts{};  ///< instead of `bytes`, where the plot is cut into several files
  std::string plotter_report{};      ///< table of strokes, lengths and times, where PlotterRequest::report asks for it
};

/// The style of the lines of a picture on a page.
PlotOptions plot_options(const PictureRequest& request, const Page& page);

/// Throws RequestError for a PNG that has too many pixels, MemoryError where they take too much.
void check_png(const Page& page, double dpi, const MemoryLimit& memory);

/// The kind of file that a drawing becomes.
struct PictureFile {
  OutputFormat format;
  const GrayPicture* under = nullptr;  ///< below the lines
  PdfDocument* pages = nullptr;        ///< of which a PDF becomes a page; it then has no bytes of its own
};

/// SVG, PDF, PNG, HPGL or G-code. Adds the time of the path work to `run`.
Picture write_picture(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter,
                      const PictureFile& file, RunReport& run);

}  // namespace ligne
