#pragma once
/// Requests for a picture: plain values, with the defaults of the command line. Lengths are in mm, angles in degrees.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/stroke.hpp"
#include "geometry/point.hpp"
#include "picture/models/memory.hpp"
#include "plotting/devices/device.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/page.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/plot_parts.hpp"
#include "plotting/stroke_text.hpp"
#include "scene/model/scene.hpp"
#include "view/axes/axes_layout.hpp"
#include "view/view.hpp"
#include "visibility/kept_visibility.hpp"
#include "visibility/method_parameters.hpp"

namespace ligne {

struct OccludedCells;
class CompiledScene;
class Method;
struct LineGroups;
struct SurfaceCurves;

/// From where the scene is seen.
struct ViewRequest {
  std::optional<std::string> named_view;  ///< one of kNamedViews; without it, a direction or an eye: "iso"
  std::optional<std::string> camera{};    ///< of the model's file, by its name (name_fits()); empty: the first
  std::optional<Point3> direction;        ///< line of sight, from the viewer into the scene: parallel projection
  std::optional<Point3> eye;              ///< perspective
  std::optional<Point3> target;           ///< default: the centre of the scene's bounding box
  double fov_degrees = 35;                ///< vertical angle of view
  std::optional<Point3> up;               ///< default: the up axis
  std::optional<Axis> up_axis;            ///< default: the scene's
  /// The model is turned so far about its vertical axis, counter-clockwise as seen from above, before it is looked at.
  double turn_degrees = 0;
  std::optional<Camera> made{};  ///< that of an earlier picture, in place of all others
};

/// A page as written on the command line.
struct PageSize {
  Page page;
  bool explicit_size = false;  ///< WxH: its orientation is meant as written
};

/// Where on which page the picture lies.
struct PageRequest {
  PageSize size;
  bool landscape = false, portrait = false;  ///< neither: as the picture becomes larger
  double margin_mm = 10;
  double pen_width_mm = 0.35;
  LineWidths widths_mm{};           ///< of layers by their names
  std::optional<double> scale;      ///< page length per true length; nothing: fit
  std::optional<double> unit_mm{};  ///< true length of one model unit; nothing: the scene's
  std::optional<Rect> extent{};     ///< what the page is to hold, see projected_extent(); nothing: what is drawn

  /// Page mm per model unit, or nothing when the picture is to fit.
  std::optional<double> page_mm_per_unit(double scene_unit_mm) const {
    return scale ? std::optional(*scale * unit_mm.value_or(scene_unit_mm)) : std::nullopt;
  }
};

enum class HiddenLines { none, dashed, solid };
inline constexpr std::string_view kHiddenLinesNames[] = {"none", "dashed", "solid"};

/// The colour of an object's lines.
struct ObjectColor {
  std::string pattern;  ///< of its name, see name_fits()
  std::array<double, 3> color{0, 0, 0};
};

/// The drawing of a mesh: the lines that an illustrator would draw of the shape it stands for, or those of every edge as
/// stored.
enum class Quality : std::uint8_t { clear, exact };
inline constexpr std::string_view kQualityNames[] = {"clear", "exact"};

/// Against what the outer outline of an object is a profile: the sheet, or other objects farther back too.
enum class ProfileKind : std::uint8_t { off, sheet, parts };
inline constexpr std::string_view kProfileNames[] = {"off", "sheet", "parts"};

/// How surfaces that run into each other are shown: by one line along the middle of a narrow fillet and lines along the
/// borders of wide ones, always by borders, or by the middles of all fillets.
enum class TangentLines : std::uint8_t { automatic, borders, middles };
inline constexpr std::string_view kTangentNames[] = {"auto", "borders", "middles"};

/// Which lines are drawn, and how they are found.
struct LineRequest {
  const Method* method = nullptr;  ///< nullptr: the default method, for regions the first that gives them
  MethodSettings settings;         ///< of the method's own parameters
  LineClasses classes = LineClasses::features();
  std::optional<ProfileKind> profile{};  ///< nothing: against the sheet when the classes name profiles
  double crease_degrees = 30;            ///< between faces
  double surface_crease_degrees = 10;    ///< of clear lines, between surfaces that meshes stand for (scene/patches)
  TangentLines tangent = TangentLines::automatic;
  HiddenLines hidden = HiddenLines::none;
  bool cull = false;  ///< leave out back faces of closed, consistently wound objects
  Quality quality = Quality::clear;
  /// Shorter visible bits of lines are left out; nothing: 1.5 widths of the pen in clear lines, 0 in exact ones.
  std::optional<double> least_mm{};

  ProfileKind profiles() const {
    return profile.value_or(classes.has(LineClass::profile) ? ProfileKind::sheet : ProfileKind::off);
  }
  /// The classes that are drawn, and those of which profiles may be parts.
  LineClasses studied() const {
    LineClasses all = classes;
    if (profiles() == ProfileKind::off) return all;
    for (const LineClass c : {LineClass::outline, LineClass::border, LineClass::crease}) all.add(c);
    return all;
  }
};

/// `paper`: all in white, for what hides without a colour of its own.
enum class FillKind : std::uint8_t { none, material, shade, paper };
inline constexpr std::string_view kFillNames[] = {"none", "material", "shade", "paper"};

/// Visible faces as areas of colour, and light.
struct FillRequest {
  FillKind kind = FillKind::none;
  std::vector<Point3> lights;  ///< directions in which parallel light travels; empty: the lights of the scene

  bool asked() const { return kind != FillKind::none || !lights.empty(); }
};

enum class HatchKind : std::uint8_t { none, shade, material, plain };
inline constexpr std::string_view kHatchNames[] = {"none", "shade", "material", "plain"};

/// Degrees of darkness, as many as [Boulle1980] has at most.
inline constexpr unsigned kMostShades = 4;

/// The lines that strokes follow where they bend with the form: the directions of principal curvature, or the curves of a
/// surface.
enum class FormLines : std::uint8_t { none, curvature, iso };

/// Direction of the strokes: fixed, or on every face along its level lines, or along the form.
struct HatchDirection {
  bool by_face = false;
  FormLines form = FormLines::none;
  double degrees = 45;  ///< counter-clockwise as seen; of level faces too
};

/// Visible faces as strokes.
struct HatchRequest {
  HatchKind kind = HatchKind::none;
  std::optional<double> spacing_mm{};  ///< of the closest strokes; nothing: by the width of the pen
  HatchDirection direction{};
  bool cross = false;
  std::optional<unsigned> levels{};  ///< 0: continuous; nothing: kMostShades, but continuous along the form

  bool asked() const { return kind != HatchKind::none; }
};

/// Which contour lines have their height written into them.
enum class ContourLabels : std::uint8_t { none, index, all };

/// A line of the legend.
struct LegendEntry {
  std::string text;
  std::optional<std::array<double, 3>> color{};
  std::string layer{}, object{};  ///< of the lines that it is about
  bool filled = false;            ///< it is about areas: its sample is one
};

/// Axes, a title and a map's signs round the picture of what is plotted.
struct AxesChoice {
  std::optional<AxesStyle> style;  ///< nothing: no axes
  bool scale_bar = false, north_arrow = false;
  std::string scale_unit{};  ///< empty: metres, where the ground has them
  std::vector<LegendEntry> legend{};
  std::array<std::vector<std::string>, 3> categories{};  ///< names in place of the numbers 0, 1, 2 ...
  std::array<std::optional<std::string>, 3> names;
  TextStyle text = TextStyle::font;
  std::optional<double> text_height_mm;
};

/// Pens and plotter.
struct PlotterRequest {
  std::optional<Optimize> optimize;  ///< nothing: full for pens; other drawings stay as they are made
  JoinTolerances tolerances;
  bool report = false, preview = false;  ///< wanted beside the file (Picture)
  bool fit_device = false;
  bool fit_drawing = false;              ///< the drawing has no scale of its own: it fits the device without being asked
  double min_length_mm = 0;              ///< strokes that are shorter are left out
  LongPlotRequest parts;                 ///< long plots
  std::shared_ptr<const Device> device;  ///< nullptr: an SVG or PDF for no device
  PenTable pens;
  PenTable asked_pens;  ///< those of them that were asked for by name, of what must be there

  /// The drawing is dealt out to pens.
  bool by_pens() const { return device || !pens.empty(); }
  Optimize path_work() const { return optimize.value_or(by_pens() ? Optimize::full : Optimize::off); }
};

enum class OutputFormat { svg, pdf, png, json, hpgl, gcode };
inline constexpr std::string_view kOutputFormatNames[] = {"svg", "pdf", "png", "json", "hpgl", "gcode"};

/// The file.
struct OutputRequest {
  OutputFormat format = OutputFormat::svg;
  double dpi = 150;                   ///< PNG
  std::string title;                  ///< of the document, may be empty
  bool group_objects = false;         ///< SVG: a group for each object in every layer; JSON: strokes say their object
  std::vector<ObjectColor> colors{};  ///< SVG, PDF and PNG: of objects, the last that fits; others are black
  std::optional<bool> curves{};  ///< SVG, PDF and PNG: arcs where lines are tessellated ones; nothing: where lines are clear
};
inline constexpr std::string_view kSwitchNames[] = {"off", "on"};

/// A whole picture of a scene.
struct PictureRequest {
  ViewRequest view{};
  LineRequest lines{};
  PageRequest page{};
  FillRequest fill{};
  bool regions = false;  ///< visible faces as areas are wanted for themselves
  HatchRequest hatch{};
  bool gray_faces = false;  ///< faces in gray, lit from the eye, by a method that gives spans or pixels
  AxesChoice axes{};
  PlotterRequest plotter{};
  OutputRequest output{};
  std::string heading{};                       ///< title above the picture on the page, may be empty
  std::shared_ptr<const LineGroups> groups{};  ///< lines that are drawn apart; nullptr: none
  std::shared_ptr<const SurfaceCurves> iso{};  ///< curves that hatching may follow; nullptr: there are none
  ContourLabels contour_labels = ContourLabels::none;
  bool label_decades = false;                       ///< heights of contours are decimal logarithms
  std::shared_ptr<const CompiledScene> compiled{};  ///< of the scene, by the method; nullptr: it is made when it is needed
  Keep keep = Keep::nothing;                        ///< what the study leaves is wanted for that
  std::shared_ptr<const KeptVisibility> earlier{};  ///< what an earlier one has left, by the method; nullptr: nothing
  std::shared_ptr<const OccludedCells> blank{};     ///< of a streamed scene (streamed_model.hpp); nullptr: there are none
  MemoryLimit memory{};
  std::function<void(double)> progress{};  ///< called with the fraction of the study done, from one thread at a time
};

}  // namespace ligne
