#pragma once
/// Fills areas with strokes. One engine serves regions and scan lines: both are given as runs on closely spaced lines
/// along the strokes.

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne {

/// The strokes' own coordinates: u along them, v across them, in mm.
class HatchFrame {
 public:
  /// `angle_degrees` counter-clockwise as seen; the origin is a point of the page.
  HatchFrame(Point2 origin, double angle_degrees);

  Point2 along() const { return along_; }
  Point2 across() const { return across_; }
  Point2 to_frame(Point2 page) const;
  Point2 to_page(Point2 frame) const;

 private:
  Point2 origin_, along_, across_;
};

/// A part of a line on which a surface is seen. Line i lies at v = i x line_mm.
struct SurfaceRun {
  std::int32_t line = 0;
  double from = 0, to = 0;  ///< u, mm
  std::uint32_t surface = 0;
};

/// Number of rows in a cycle, of which a surface has all or some.
inline constexpr std::uint32_t kRowCycle = 16;

/// How a surface is hatched.
struct SurfaceHatch {
  std::uint32_t every = 0;         ///< distance of the rows of strokes, in lines; 0: no strokes
  std::uint32_t rows = kRowCycle;  ///< rows of a cycle, spread over it, or 0; a surface with more rows has all rows of
                                   ///< one with fewer, and strokes continue over both
  std::uint32_t group = 0;         ///< surfaces of one group are one area; a rim separates different groups
  std::uint32_t layer = 0;         ///< layer of the strokes
  bool rim = false;                ///< also a stroke round the area, half a pen inside it
};

/// Distance of the lines of runs for rows at this spacing, mm: the spacing divided by a whole number, at most a sixth
/// of the pen width, or of 0.1 mm if the pen is finer.
double hatch_line_mm(double spacing_mm, double pen_mm);

/// Cuts an area, given by its contours in any order, into runs and appends them. With `even_odd` a point is inside if
/// an odd number of contours surrounds it, else if its winding number is not zero.
void add_runs(std::span<const std::vector<Point2>> contours, std::uint32_t surface, const HatchFrame& frame, double line_mm,
              std::vector<SurfaceRun>& runs, bool even_odd = true);

/// Hatches surfaces. Surfaces with the same group and `every` are joined first, so that the pen does not lift at
/// borders between them. Strokes and their round ends stay inside, half a pen from the rim. They run to and fro; the
/// end of one is tied to the beginning of the next if the way between them along the rim is short. `surfaces` is
/// indexed by SurfaceRun::surface, `pen_mm` by layer; the strokes are appended to `layers`, page mm. The runs come in
/// any order, and surfaces may overlap. Throws std::invalid_argument for a pen or a distance that is not above zero.
void hatch_runs(const HatchFrame& frame, double line_mm, std::span<const SurfaceRun> runs,
                std::span<const SurfaceHatch> surfaces, std::span<const double> pen_mm, std::span<Polylines> layers);

struct HatchOptions {
  double spacing_mm = 1;      ///< between the middles of neighbouring strokes
  double angle_degrees = 45;  ///< of the strokes, counter-clockwise as seen
  double pen_width_mm = 0.35;
  bool even_odd = true;  ///< see add_runs
  bool cross = false;    ///< also strokes at right angles
  bool rim = false;      ///< also a stroke round the area: with rows at most a pen width apart nothing stays white
  Point2 origin{0, 0};   ///< on the line of a stroke: hatches of areas with the same origin continue each other
};

/// Distance of the lines of an area's runs, mm: finer with a rim, so that nothing stays white.
double hatch_line_mm(const HatchOptions& options);

/// Hatches one area, page mm. An area that is narrower than the pen gets nothing. Throws std::invalid_argument for a spacing
/// or a pen width that is not above zero, and for more than `kMostHatchRows` rows.
Polylines hatch(std::span<const std::vector<Point2>> contours, const HatchOptions& options);

inline constexpr double kMostHatchRows = 1e6;

}  // namespace ligne
