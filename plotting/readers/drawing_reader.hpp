#pragma once
/// Reads drawings from files: ligne-drawings in JSON, and SVG of any program.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "files/omissions.hpp"
#include "plotting/page.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {

/// A visible part of a face, as stored in a ligne-drawing.
struct ReadRegion {
  std::vector<std::vector<Point2>> contours;  ///< page mm
  std::uint32_t patch = 0;                    ///< regions of one patch are hatched as one area
  std::optional<double> light;                ///< 0 dark to 1; nothing: not in the file
  std::array<double, 3> color{0, 0, 0};
  std::string material;  ///< its name, or empty
};

/// The order of painting stored in a ligne-drawing, and its strokes on their lattice.
struct ReadOrder {
  struct Piece {
    std::uint32_t face = 0, material = 0;  ///< `material` is an index into `materials`
    double light = 1;                      ///< 0 dark to 1
  };
  PaintOrder order;           ///< without the pieces that the file marks as hidden
  std::vector<Piece> pieces;  ///< per piece of the order
  bool tells_hidden = false;  ///< whether the file marks any piece as hidden
  std::vector<DocumentMaterial> materials;
  StrokeModel strokes;  ///< without sources and parameters
};

struct ReadDrawing {
  Drawing drawing{};                              ///< page mm, true to scale
  std::vector<ReadRegion> regions{};              ///< regions of a ligne-drawing, if it has any
  std::optional<ReadOrder> order{};               ///< only if requested
  Page page{};                                    ///< margin 0 if the file has none
  bool dashes_cut = false;                        ///< dashes are strokes already
  std::map<std::string, std::size_t> left_out{};  ///< parts skipped because the caller allowed it, with counts
  std::size_t outlined = 0;                       ///< filled areas that were drawn by their contours only
  std::size_t simplified_paints = 0;              ///< gradients and patterns drawn in one colour
  std::size_t boxes = 0;                          ///< characters that the font lacks, drawn as boxes
  bool size_assumed = false;                      ///< the file gives no size of the page
  Omissions omitted{};                            ///< parts of an SVG that could not be drawn, by kind
  std::size_t first_omitted_line = 0;             ///< line of the first of these; 0: none, or not known
  std::string paper_of_view_box{};                ///< paper that the view box fits at another resolution, or empty
  double paper_dpi = 0;                           ///< that resolution
};

/// Largest distance of a coordinate from the corner of the page, mm.
inline constexpr double kFarthestMm = 1e6;

/// Reads a ligne-drawing (docs/drawing-format.md): strokes become lines of two points in layers by class. Throws
/// InputError, "FILE: what is wrong and where". `with_order`: also reads the order of painting, which the file must
/// have.
ReadDrawing read_json_drawing(std::string_view json, const std::string& file, bool with_order = false);

/// How areas are filled with strokes.
struct FillHatch {
  std::optional<double> spacing_mm;  ///< nothing: close enough to cover the area, or set by the tone
  double angle_degrees = 45;         ///< counter-clockwise as seen
  bool cross = false;                ///< also strokes at right angles
  bool tone = false;                 ///< lighter fills get a wider spacing
};

/// Hatches by the names of layers and colours; all others are as in `all`. A layer takes precedence over a colour.
struct FillHatches {
  FillHatch all{};
  std::map<std::string, double, std::less<>> spacing_mm_of{}, degrees_of{};
  std::set<std::string, std::less<>> crossed{};

  FillHatch of(std::string_view layer, std::string_view color) const;
};

/// The treatment of filled areas of an SVG. White areas are paper: they are not drawn, and hide the lines under them.
struct FillReading {
  enum class How { refuse, outline, hatch };
  How how = How::outline;      ///< outline: only contours; hatch: contours, and strokes inside; refuse: an error
  double pen_width_mm = 0.35;  ///< width of the pen that hatches
  bool occlude = false;        ///< opaque areas of every colour hide the lines under them
  bool own_layer = false;      ///< areas hide only lines of their own layer
  FillHatches hatches{};
};
inline constexpr std::string_view kFillReadingNames[] = {"refuse", "outline", "hatch"};

/// Hatches the regions of a drawing into layers "hatch", one per material. Regions of one patch are one area. With
/// FillHatch::tone, darker regions are hatched more closely. Throws std::runtime_error if the drawing has no regions.
void hatch_regions(ReadDrawing& drawing, const FillReading& fills);

struct SvgReading {
  bool strict = false;      ///< anything that can not be drawn is an error
  double px_per_inch = 96;  ///< size of a unit of the page: 96 to the inch for CSS, 72 or 90 for some programs
};

/// Reads the strokes of an SVG; docs/plotting.md lists the parts of SVG that are known. Other visible parts are left
/// out and counted, or with `strict` refused by their name, unless it is in `skip`. No other file is read. Throws
/// InputError, "FILE:LINE: cause", if the text is no SVG, or asks for endless work.
ReadDrawing read_svg_drawing(std::string_view svg, const std::string& file, const std::set<std::string>& skip,
                             const FillReading& fills = {}, const SvgReading& reading = {});

/// Kinds of elements that can be skipped, as named in errors.
inline constexpr std::string_view kSkippable[] = {"text",   "image", "fill",          "clip-path", "mask",      "filter",
                                                  "marker", "style", "foreignObject", "switch",    "animation", "paint"};

}  // namespace ligne
