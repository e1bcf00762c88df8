#pragma once
/// Requests for a picture of surfaces: plain values with the defaults of the command line.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/requests.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne {

/// The range of a variable, and the number of iso-curves in it.
struct CurveRange {
  double from = -5, to = 5;
  std::optional<unsigned> curves;  ///< nothing: a default
};

enum class CurveFamilies { x, y, xy, none };
inline constexpr std::string_view kCurveFamilyNames[] = {"x", "y", "xy", "none"};

/// Contour lines and other lines besides iso-curves, and the rule of visibility.
struct CurveRequest {
  std::optional<unsigned> contours;        ///< approximate number of contour lines, at round heights
  bool even_contours = false;              ///< exactly `contours` lines at equal distances in height
  std::vector<double> contour_heights{};   ///< instead: their heights, ascending; `contours` is their number
  std::optional<double> contour_step;      ///< instead: the difference in height between contour lines
  std::optional<unsigned> index_contours;  ///< every n-th contour line is wider, 0: none; nothing: every fifth, if
                                           ///< `contour_step` is given
  ContourLabels labels = ContourLabels::none;
  bool contours_base = false;          ///< draw the contour lines in a horizontal plane below the surface, too
  std::optional<double> contour_base;  ///< height of that plane; nothing: well below the lowest height
  std::optional<bool> outline;         ///< draw the outline of the surface; nothing: yes, unless curves hide curves
  Underside underside = Underside::same;
  HiddenBy hidden_by = HiddenBy::surface;
  bool ridgeline = false;        ///< a ridgeline plot: rows of curves that overlap
  double ridgeline_overlap = 6;  ///< range of heights, in distances between rows
};

enum class WaterFill : std::uint8_t { blank, hatch };
enum class HachureKind : std::uint8_t { none, contour, slope };

/// Features of terrain maps.
struct TerrainRequest {
  std::optional<double> water;  ///< height of the water level; lower ground is under water
  bool water_at_holes = false;  ///< missing heights are water at the lowest height
  WaterFill water_fill = WaterFill::blank;
  HachureKind hachures = HachureKind::none;     ///< shading strokes along contour lines, or down the slope
  std::optional<double> hachure_mm;             ///< distance of the closest strokes; nothing: from the pen width
  double sun_azimuth = 315, sun_altitude = 45;  ///< degrees: clockwise from north, and above the ground

  bool has_water() const { return water || water_at_holes; }
};

/// A grid of heights in memory: z[j * x.size() + i] is the height at x[i], y[j], or NaN if it is missing. x and y
/// ascend.
struct GivenHeights {
  std::string name;
  std::vector<double> x, y, z;
};

/// The lengths of the axes in the picture. `equal`: proportional to their ranges; `box`: x and y are equally long;
/// `ratio`: given by `sides`.
struct AspectRequest {
  enum Kind : std::uint8_t { equal, box, ratio } kind = equal;
  Point3 sides{1, 1, 1};  ///< lengths of the axes, for `ratio`
};

/// The unit of the positions of a grid. `as_read`: as the file states or implies; `metres`: metres or any other unit,
/// the same as that of the heights; `degrees`: longitude and latitude, with heights in metres.
enum class GroundChoice : std::uint8_t { as_read, metres, degrees };

/// Formulas of x, y and z in the parameter t. The one of z may be kOnSurface: the curve then lies on the surface.
using SpaceCurve = std::array<std::string, 3>;

/// Colour bands of heights: their number, or the limits between them.
struct BandRequest {
  unsigned count = 0;
  std::vector<double> limits{};
};

/// A picture of surfaces z = f(x, y) and parametric surfaces. The line classes and the crease angle of `picture` are
/// ignored.
struct SurfaceRequest {
  std::vector<std::string> formulas, grids;            ///< formulas of z in x and y; names of grid files
  std::vector<GivenHeights> heights{};                 ///< treated like grid files
  std::vector<std::array<std::string, 3>> parametric;  ///< formulas of x, y and z in u and v
  std::optional<CurveRange> x, y;
  std::vector<CurveRange> u, v;  ///< per parametric surface; the last one applies to all further surfaces
  std::optional<unsigned> samples;
  std::optional<unsigned> every;    ///< grid: number of samples between curves; nothing: so that curves stay distinct
  std::optional<double> max_slope;  ///< grid: cells with a larger slope are left out
  std::optional<unsigned> gridded;  ///< scattered points: number of columns of a grid in place of triangles
  TableLayout layout = TableLayout::automatic;  ///< grid: layout of a table
  std::optional<unsigned> data_set;             ///< grid: index of the data set to draw, from 0
  std::vector<std::string> using_columns{};     ///< grid: columns of x, y and z, or of z alone
  std::optional<unsigned> band{};               ///< rasters: number of the band, from 1; nothing: the first
  GroundChoice ground = GroundChoice::as_read;
  CurveFamilies lines = CurveFamilies::xy;
  /// Direction to the viewer, in degrees, if `picture.view` names no view; the defaults are -60 and 30.
  std::optional<double> azimuth_degrees, elevation_degrees;
  std::optional<AspectRequest> aspect;  ///< nothing: equal, or box if the ranges of x and y differ too much
  std::optional<double> z_scale;        ///< nothing: heights take half of the larger side of the ground
  std::optional<double> exaggeration;   ///< scale of heights relative to the ground, both in one unit
  std::array<bool, 3> log_axes{};       ///< x, y, z: the axis is logarithmic; coordinates are decimal logarithms
  std::optional<std::array<double, 2>> z_range;
  bool skirt = false;
  std::optional<double> skirt_base;       ///< height of its lower edge; nothing: a little below the lowest height
  bool horizon = false;                   ///< use the floating horizon, even if it omits cells that a mesh could cut
  std::optional<unsigned> pixel_columns;  ///< number of columns of a horizon stored by pixels; nothing: exact
  CurveRequest curves;
  TerrainRequest terrain;
  std::vector<SpaceCurve> space_curves{};
  std::vector<CurveRange> t{};                  ///< per space curve; the last one applies to all further curves
  std::vector<std::string> point_files{};       ///< names of files of labelled points
  std::vector<std::string> line_files{};        ///< names of files whose rows are the points of lines
  std::vector<std::array<double, 3>> colors{};  ///< colours of the surfaces, used cyclically, or of the bands
  std::optional<BandRequest> bands{};
  bool legend = false;
  std::vector<std::string> names{};  ///< texts of the legend entries, in order; further entries get default texts
  PictureRequest picture;
};

/// Number of surfaces z = f(x, y) of all sources.
inline std::size_t height_count(const SurfaceRequest& request) {
  return request.formulas.size() + request.grids.size() + request.heights.size();
}

/// Whether the request has any surface.
inline bool has_surfaces(const SurfaceRequest& request) { return height_count(request) > 0 || !request.parametric.empty(); }

/// Throws RequestError if parts of the request contradict each other, such as sources, ranges and curves.
void check(const SurfaceRequest& request);

/// The first requested feature that only a mesh can draw, as a word for messages; empty if the floating horizon can
/// draw all.
std::string needs_mesh(const SurfaceRequest& request);

/// The first requested feature that only the floating horizon can draw, as the name of its option; empty if there is
/// none.
std::string needs_horizon(const SurfaceRequest& request);

/// Whether the floating horizon draws the picture: for a single surface z = f(x, y) without features that need a mesh,
/// if the request names no method for meshes.
bool drawn_by_horizon(const SurfaceRequest& request);

/// The view of the request, with the two angles converted to a direction.
ViewRequest view_of(const SurfaceRequest& request);

/// The subject of warnings: the name of the grid if there is only one, or "surface".
std::string place_of_warnings(const SurfaceRequest& request);

/// Heights of the contour lines between `low` and `high`, ascending. For about N lines, they are at multiples of 1, 2
/// or 5 times a power of ten, whichever gives the number nearest to N. With `decades` heights are decimal logarithms,
/// and lines are at powers of ten and round numbers in between. Throws RequestError if there are too many.
std::vector<double> contour_levels(const CurveRequest& request, double low, double high, bool decades);

/// Whether a contour line is an index contour. `number` is its index in contour_levels().
bool is_index_contour(const CurveRequest& request, double level, std::size_t number);

/// Whether contour lines are grouped by height, since labels or index contours need their heights.
bool names_heights(const CurveRequest& request);

/// Height of the plane of CurveRequest::contours_base.
double contour_base_of(const CurveRequest& request, double low, double high);

}  // namespace ligne
