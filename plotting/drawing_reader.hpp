#pragma once
/// Drawings read back from files: ours as JSON, anybody's as SVG.

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "drawing/drawing.hpp"
#include "plotting/page.hpp"

namespace ligne {

struct ReadDrawing {
  Drawing drawing;                              ///< page mm, true to scale
  Page page;                                    ///< margin 0 where the file tells none
  bool dashes_cut = false;                      ///< dashes are strokes already
  std::map<std::string, std::size_t> left_out;  ///< what was skipped because the caller allowed it, with counts
};

/// No coordinate of a drawing is farther from the corner of its page, in mm.
inline constexpr double kFarthestMm = 1e6;

/// A ligne-drawing (docs/drawing-format.md): strokes become lines of two points in layers by class. Throws
/// InputError, "FILE: what is wrong and where".
ReadDrawing read_json_drawing(std::string_view json, const std::string& file);

/// What becomes of filled areas of an SVG. White ones below everything are paper; white ones above something hide it, and
/// are refused.
struct FillReading {
  enum class How { refuse, outline, hatch };
  How how = How::refuse;       ///< or their contours are drawn, or these and strokes inside
  double pen_width_mm = 0.35;  ///< of the pen that hatches
};
inline constexpr std::string_view kFillReadingNames[] = {"refuse", "outline", "hatch"};

/// The strokes of an SVG; docs/plotting.md says what of SVG is known. Whatever else shows on the page is refused by its
/// name, unless that is in `skip`. Reads nothing but the text: no entity, no link. Throws InputError, "FILE:LINE:
/// what is wrong".
ReadDrawing read_svg_drawing(std::string_view svg, const std::string& file, const std::set<std::string>& skip,
                             const FillReading& fills = {});

/// What can be skipped, as named in errors.
inline constexpr std::string_view kSkippable[] = {"text",   "image", "fill",          "clip-path", "mask",      "filter",
                                                  "marker", "style", "foreignObject", "switch",    "animation", "paint"};

}  // namespace ligne
