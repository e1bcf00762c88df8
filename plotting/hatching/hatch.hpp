#pragma once
/// Areas filled with strokes. There is one engine for regions and for scan lines: both are given as runs on lines that lie
/// closely side by side along the strokes, in *runs*.

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

/// A part of a line under which a surface is seen. Line i lies at v = i x line_mm.
struct SurfaceRun {
  std::int32_t line = 0;
  double from = 0, to = 0;  ///< u
  std::uint32_t surface = 0;
};

/// So many rows in turn make a cycle, of which a surface has all or some.
inline constexpr std::uint32_t kRowCycle = 16;

/// How a surface is hatched.
struct SurfaceHatch {
  std::uint32_t every = 0;         ///< a row of strokes on every so many lines; 0: none
  std::uint32_t rows = kRowCycle;  ///< so many of a cycle, spread over it, or 0; a surface with more rows has all those of
                                   ///< one with fewer, and strokes run on over both
  std::uint32_t group = 0;         ///< surfaces of one group are one area, those of different groups have a rim between them
  std::uint32_t layer = 0;         ///< of the strokes
  bool rim = false;                ///< a stroke round the area too, half a pen inside it
};

/// Distance of the lines of the runs for rows at this spacing: a whole part of it, and at most a sixth of the pen (of a
/// tenth of a millimetre, where the pen is finer).
double hatch_line_mm(double spacing_mm, double pen_mm);

/// Cuts an area, its contours in any order, into runs; appends them. Inside is what an odd number of contours surrounds, or,
/// if not `even_odd`, what they wind round.
void add_runs(std::span<const std::vector<Point2>> contours, std::uint32_t surface, const HatchFrame& frame, double line_mm,
              std::vector<SurfaceRun>& runs, bool even_odd = true);

/// Strokes for surfaces. Those of one group and one `every` are joined before they are hatched, so that borders between them
/// lift no pen. Strokes and their round ends stay inside, half a pen from the rim. They run to and fro; the end of one is
/// tied to the beginning of the next where the way between them along the rim is short. `surfaces` is indexed by
/// SurfaceRun::surface, `pen_mm` by layer; the strokes are appended to `layers`, page mm. The runs come in any order, and
/// surfaces may overlap. Throws std::invalid_argument for a pen or a distance that is not above zero.
void hatch_runs(const HatchFrame& frame, double line_mm, std::span<const SurfaceRun> runs,
                std::span<const SurfaceHatch> surfaces, std::span<const double> pen_mm, std::span<Polylines> layers);

struct HatchOptions {
  double spacing_mm = 1;      ///< between the middles of neighbouring strokes
  double angle_degrees = 45;  ///< of the strokes, counter-clockwise as seen
  double pen_width_mm = 0.35;
  bool even_odd = true;  ///< see add_runs
  bool cross = false;    ///< a second family at right angles
  bool rim = false;  ///< a stroke round the area too: with rows no farther apart than the pen is wide nothing stays white
  Point2 origin{0,
                0};  ///< a stroke would run through this point: areas with one origin have hatches that continue each other
};

/// Distance of the lines of an area's runs; finer where a rim must not leave anything white.
double hatch_line_mm(const HatchOptions& options);

/// Hatches one area, page mm. An area that is narrower than the pen gets nothing. Throws std::invalid_argument for a spacing
/// or a pen width that is not above zero, and for more than `kMostHatchRows` rows.
Polylines hatch(std::span<const std::vector<Point2>> contours, const HatchOptions& options);

inline constexpr double kMostHatchRows = 1e6;

}  // namespace ligne
