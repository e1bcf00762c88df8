#pragma once
/// Requests for a picture of surfaces: plain values, with the defaults of the command line.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/requests.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne {

/// A range of a variable and its number of curves.
struct CurveRange {
  double from = -5, to = 5;
  std::optional<unsigned> curves;
};

enum class CurveFamilies { x, y, xy, none };
inline constexpr std::string_view kCurveFamilyNames[] = {"x", "y", "xy", "none"};

/// Lines beside plain curves, and what hides.
struct CurveRequest {
  std::optional<unsigned> contours;        ///< number of contour lines: about so many, at round heights
  bool even_contours = false;              ///< exactly so many, at equal distances
  std::vector<double> contour_heights{};   ///< or these, ascending; `contours` is their number
  std::optional<double> contour_step;      ///< or their distance in height
  std::optional<unsigned> index_contours;  ///< one of so many is drawn heavier, 0: none; nothing: every fifth of a step
  ContourLabels labels = ContourLabels::none;
  bool contours_base = false;
  std::optional<double> contour_base;  ///< height of the plane; nothing: a good deal below the lowest height
  std::optional<bool> outline;         ///< nothing: yes, unless curves hide
  Underside underside = Underside::same;
  HiddenBy hidden_by = HiddenBy::surface;
  bool ridgeline = false;
  double ridgeline_overlap = 6;  ///< range of heights in distances of rows
};

enum class WaterFill : std::uint8_t { blank, hatch };
enum class HachureKind : std::uint8_t { none, contour, slope };

/// Features of terrain maps.
struct TerrainRequest {
  std::optional<double> water;  ///< what is lower is water, up to this height
  bool water_at_holes = false;  ///< where there is no height is water, as high as the lowest height
  WaterFill water_fill = WaterFill::blank;
  HachureKind hachures = HachureKind::none;     ///< strokes where it is dark: along contours, or down the slope
  std::optional<double> hachure_mm;             ///< distance of the closest strokes; nothing: by the width of the pen
  double sun_azimuth = 315, sun_altitude = 45;  ///< degrees: clockwise from north, and above the ground

  bool has_water() const { return water || water_at_holes; }
};

/// Heights in memory: z[j * x.size() + i] over x[i], y[j], which ascend; NaN where there is none.
struct GivenHeights {
  std::string name;
  std::vector<double> x, y, z;
};

/// How long the axes are in the picture: as their numbers are, with the two sides of the ground alike, or as the numbers of
/// a ratio.
struct AspectRequest {
  enum Kind : std::uint8_t { equal, box, ratio } kind = equal;
  Point3 sides{1, 1, 1};  ///< of a ratio
};

/// The unit of a grid's positions: as the file says or lets see, metres or any other unit that the heights have too, or
/// degrees of longitude and latitude with heights in metres.
enum class GroundChoice : std::uint8_t { as_read, metres, degrees };

/// Formulas of x, y and z in t; that of z may be kOnSurface.
using SpaceCurve = std::array<std::string, 3>;

/// Heights in bands that are told apart by colours: so many, or at limits.
struct BandRequest {
  unsigned count = 0;
  std::vector<double> limits{};
};

/// Surfaces z = f(x, y) and parametric ones. Of `picture` the line classes and the crease angle are not looked at.
struct SurfaceRequest {
  std::vector<std::string> formulas, grids;
  std::vector<GivenHeights> heights{};                 ///< treated as grids are
  std::vector<std::array<std::string, 3>> parametric;  ///< formulas of x, y and z in u and v
  std::optional<CurveRange> x, y;
  std::vector<CurveRange> u, v;  ///< of the parametric surfaces in their order; the last serves for all that follow
  std::optional<unsigned> samples;
  std::optional<unsigned> every;    ///< grid: a curve at every so many samples; nothing: so that the curves keep apart
  std::optional<double> max_slope;  ///< grid: steeper cells are left out
  std::optional<unsigned> gridded;  ///< scattered points: a grid of so many columns in place of triangles
  TableLayout layout = TableLayout::automatic;  ///< grid: how a table is understood
  std::optional<unsigned> data_set;             ///< grid: the one that is drawn, from 0
  std::vector<std::string> using_columns{};     ///< grid: columns of x, y and z, or of z alone
  std::optional<unsigned> band{};               ///< of rasters, counted from 1; nothing: the first
  GroundChoice ground = GroundChoice::as_read;
  CurveFamilies lines = CurveFamilies::xy;
  /// Where the viewer stands, in degrees, when `picture.view` names no view; defaults -60 and 30.
  std::optional<double> azimuth_degrees, elevation_degrees;
  std::optional<AspectRequest> aspect;  ///< nothing: equal, or box where x and y range too differently
  std::optional<double> z_scale;        ///< nothing: heights take half of the larger side of the ground
  std::optional<double> exaggeration;   ///< heights against the ground, both in one unit
  std::array<bool, 3> log_axes{};       ///< coordinates are decimal logarithms
  std::optional<std::array<double, 2>> z_range;
  bool skirt = false;
  std::optional<double> skirt_base;       ///< height; nothing: a little below the lowest
  bool horizon = false;                   ///< the horizon is asked for, also where it leaves out cells that a mesh can cut
  std::optional<unsigned> pixel_columns;  ///< the horizon as an array of so many pixels; nothing: exact
  CurveRequest curves;
  TerrainRequest terrain;
  std::vector<SpaceCurve> space_curves{};
  std::vector<CurveRange> t{};                  ///< of the space curves in their order; the last serves for all that follow
  std::vector<std::string> point_files{};       ///< points with labels
  std::vector<std::string> line_files{};        ///< lines through the rows of a file
  std::vector<std::array<double, 3>> colors{};  ///< of surfaces in turn, or of bands
  std::optional<BandRequest> bands{};
  bool legend = false;
  std::vector<std::string> names{};  ///< of its lines, as far as they go
  PictureRequest picture;
};

/// Surfaces of z = f(x, y), from wherever they come.
inline std::size_t height_count(const SurfaceRequest& request) {
  return request.formulas.size() + request.grids.size() + request.heights.size();
}

/// Throws RequestError when parts of the request do not go together: sources and their ranges, curves.
void check(const SurfaceRequest& request);

/// The request that only meshes can draw, as a word for messages; empty where the floating horizon can draw it all.
std::string needs_mesh(const SurfaceRequest& request);

/// The request that only the floating horizon can draw, as the name of an option; or nothing.
std::string needs_horizon(const SurfaceRequest& request);

/// Whether the floating horizon draws it: one surface z = f(x, y) without anything that only meshes can do, and no mesh
/// method is asked for.
bool drawn_by_horizon(const SurfaceRequest& request);

/// The view, the two angles as a direction.
ViewRequest view_of(const SurfaceRequest& request);

/// The subject of warnings: the only grid, or "surface".
std::string place_of_warnings(const SurfaceRequest& request);

/// Heights of the contour lines between `low` and `high`, ascending. About N lines are at the multiples of 1, 2 or 5 times a
/// power of ten whose number is nearest to N; of heights that are `decades`, at powers of ten and round numbers between
/// them. Throws RequestError when they are too many.
std::vector<double> contour_levels(const CurveRequest& request, double low, double high, bool decades);

/// Whether a contour line is an index contour: `number` counts from 0 in the levels.
bool is_index_contour(const CurveRequest& request, double level, std::size_t number);

/// Whether contour lines are told apart by their heights.
bool tells_heights(const CurveRequest& request);

/// Height of the plane of the contours at the base.
double contour_base_of(const CurveRequest& request, double low, double high);

}  // namespace ligne
