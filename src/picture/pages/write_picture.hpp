#pragma once
/// Writes a drawing as the bytes of a file.

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
  unsigned number = 0;  ///< number of the part or sheet, from 1; 0: not divided into parts
  unsigned pen = 0;     ///< number of the pen; 0: all pens
};

/// The bytes of a file and the additional outputs.
struct Picture {
  std::string bytes;
  std::string preview{};             ///< SVG of the pen's path, if PlotterRequest::preview is set
  std::vector<PicturePart> parts{};  ///< files, instead of `bytes`, if the plot is divided into several files
  std::string plotter_report{};      ///< table of strokes, lengths and times, if PlotterRequest::report is set
};

/// The style of the lines of a picture on a page.
PlotOptions plot_options(const PictureRequest& request, const Page& page);

/// Throws RequestError for a PNG with too many pixels, MemoryError if they need too much memory.
void check_png(const Page& page, double dpi, const MemoryLimit& memory);

/// The format of a file and its special contents.
struct PictureFile {
  OutputFormat format;
  const FacePicture* under = nullptr;  ///< drawn below the lines
  /// Document that receives a PDF as a page; the picture then has no bytes of its own.
  PdfDocument* pages = nullptr;
};

/// Writes SVG, PDF, PNG, HPGL or G-code. Adds the time of path optimization to `run`.
Picture write_picture(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter,
                      const PictureFile& file, RunReport& run);

}  // namespace ligne
