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
  std::map<std::string, std::size_t> unknown;   ///< elements that SVG does not know, by name, with counts: left out
  std::size_t outlined = 0;                     ///< filled areas that were drawn by their contours only
  std::size_t simplified_paints = 0;            ///< gradients and patterns drawn in one colour
  std::size_t filters = 0;                      ///< filters that were not applied
  std::size_t boxes = 0;                        ///< characters that the font lacks, drawn as boxes
  bool size_assumed = false;                    ///< the file tells no size of the page
};

/// No coordinate of a drawing is farther from the corner of its page, in mm.
inline constexpr double kFarthestMm = 1e6;

/// A ligne-drawing (docs/drawing-format.md): strokes become lines of two points in layers by class. Throws
/// InputError, "FILE: what is wrong and where".
ReadDrawing read_json_drawing(std::string_view json, const std::string& file);

/// What becomes of filled areas of an SVG. White ones are paper: they are not drawn, and hide what lies under them.
struct FillReading {
  enum class How { refuse, outline, hatch };
  How how = How::outline;      ///< or they are refused, or contours are drawn and strokes inside
  double pen_width_mm = 0.35;  ///< of the pen that hatches
  bool occlude = false;        ///< opaque areas of every colour hide what lies under them
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
