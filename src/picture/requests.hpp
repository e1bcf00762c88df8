#pragma once
/// Requests for a picture: plain values with the defaults of the command line. Lengths are in mm on the page, angles in
/// degrees; points and directions are in model coordinates.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "linework/stroke.hpp"
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
#include "visibility/method.hpp"
#include "visibility/method_parameters.hpp"

namespace ligne {

struct OccludedCells;
class CompiledScene;
class Method;
struct LineGroups;
struct SurfaceCurves;

/// The view of the scene. Without any of named_view, camera, direction, eye and made, the view is "iso".
struct ViewRequest {
  std::optional<std::string> named_view;  ///< one of kNamedViews
  std::optional<std::string> camera{};    ///< name pattern of a camera of the file (name_fits()); "": the first one
  std::optional<Point3> direction;        ///< parallel projection along this direction, from the viewer into the scene
  std::optional<Point3> eye;              ///< perspective from this point
  std::optional<Point3> target;           ///< default: the centre of the scene's bounding box
  double fov_degrees = 35;                ///< vertical angle of view
  std::optional<Point3> up;               ///< default: the up axis
  std::optional<Axis> up_axis;            ///< default: the scene's
  /// Rotation of the model about its vertical axis before it is viewed, counter-clockwise as seen from above.
  double turn_degrees = 0;
  std::optional<Camera> made{};  ///< camera of an earlier picture; it overrides all other members
};

/// A page as written on the command line.
struct PageSize {
  Page page;
  bool explicit_size = false;  ///< given as WxH, so its orientation stays as written
};

/// The page, and the size of the picture on it.
struct PageRequest {
  PageSize size{};
  bool landscape = false, portrait = false;  ///< neither: the orientation in which the picture is larger
  double margin_mm = 10;
  double pen_width_mm = 0.35;
  LineWidths widths_mm{};           ///< line widths by layer name
  std::optional<double> scale{};    ///< page length divided by true length; nothing: the picture fits the page
  std::optional<double> unit_mm{};  ///< true length of one model unit in mm; nothing: Scene::unit_mm
  double inset_part = 0;            ///< part of the drawable height that is kept free below the picture
  std::optional<Rect> extent{};     ///< area to fit to the page, see projected_extent(); nothing: that of the scene

  /// Page mm per model unit; none if the picture is fitted to the page.
  std::optional<double> page_mm_per_unit(double scene_unit_mm) const {
    return scale ? std::optional(*scale * unit_mm.value_or(scene_unit_mm)) : std::nullopt;
  }
};

enum class HiddenLines { none, dashed, solid };
inline constexpr std::string_view kHiddenLinesNames[] = {"none", "dashed", "solid"};
/// Largest LineRequest::most_hiding: strokes count up to 255 faces; 255 stands for 255 or more.
inline constexpr unsigned kMostCountedFaces = 254;

/// The colour of the lines of some objects.
struct ObjectColor {
  std::string pattern;  ///< for names of objects, see name_fits()
  std::array<double, 3> color{0, 0, 0};
};

/// How a mesh is drawn. `clear`: with the lines that an illustrator would draw of the shape that the mesh approximates.
/// `exact`: with the edges as they are stored.
enum class Quality : std::uint8_t { clear, exact };
inline constexpr std::string_view kQualityNames[] = {"clear", "exact"};

/// Selects the lines that become profiles. `sheet`: where the empty paper is visible beside the line; `parts`: also
/// where another object farther back is visible.
enum class ProfileKind : std::uint8_t { off, sheet, parts };
inline constexpr std::string_view kProfileNames[] = {"off", "sheet", "parts"};

/// Where tangent lines are drawn between surfaces that join smoothly. `automatic`: one line along the middle of each
/// narrow fillet, and lines along the borders of wide ones; `borders`: always along borders; `middles`: along the
/// middles of all fillets; `none`: nowhere.
enum class TangentLines : std::uint8_t { automatic, borders, middles, none };
inline constexpr std::string_view kTangentNames[] = {"auto", "borders", "middles", "none"};

/// The lines that are drawn, and the method that computes their visibility.
struct LineRequest {
  const Method* method = nullptr;  ///< nullptr: chosen automatically
  MethodSettings settings;         ///< values of the method's own parameters
  LineClasses classes = LineClasses::features();
  std::optional<ProfileKind> profile{};  ///< nothing: `sheet` if the classes include profiles, else `off`
  double crease_degrees = 30;            ///< smallest angle between faces that makes a crease
  double surface_crease_degrees = 10;    ///< clear lines: the same between recognised surfaces (scene/patches)
  TangentLines tangent = TangentLines::automatic;
  HiddenLines hidden = HiddenLines::none;
  /// Hidden lines behind more faces than this are left out; nothing: none are. Needs their number, see count_hidden().
  std::optional<unsigned> most_hiding{};
  bool cull = false;  ///< leave out back faces of closed, consistently wound objects
  Quality quality = Quality::clear;
  /// Visible pieces of lines shorter than this are left out. Nothing: 1.5 pen widths for clear lines, 0 for exact ones.
  std::optional<double> least_mm{};

  ProfileKind profiles() const {
    return profile.value_or(classes.has(LineClass::profile) ? ProfileKind::sheet : ProfileKind::off);
  }
  /// The classes whose visibility is computed: those that are drawn, and those that profiles are cut from.
  LineClasses studied() const {
    LineClasses all = classes;
    if (profiles() == ProfileKind::off) return all;
    for (const LineClass c : {LineClass::outline, LineClass::border, LineClass::crease}) all.add(c);
    return all;
  }
};

/// How visible faces are filled. `material`: in the colour of the material; `shade`: that colour, lit; `paper`: in
/// white, so that faces only hide what lies under them; `random`: each face in its own random colour.
enum class FillKind : std::uint8_t { none, material, shade, paper, random };
inline constexpr std::string_view kFillNames[] = {"none", "material", "shade", "paper", "random"};

/// Areas of colour for visible faces, and the lights of fills, hatching and shadows.
struct FillRequest {
  FillKind kind = FillKind::none;
  std::vector<Point3> lights;  ///< travel directions of parallel lights; empty: the lights of the scene

  bool is_requested() const { return kind != FillKind::none || !lights.empty(); }
};

enum class HatchKind : std::uint8_t { none, shade, material, plain };
inline constexpr std::string_view kHatchNames[] = {"none", "shade", "material", "plain"};

/// Largest number of degrees of darkness in hatching, as in [Boulle1980].
inline constexpr unsigned kMostShades = 4;

/// The curves that hatching strokes follow. `curvature`: directions of principal curvature; `iso`: the parameter curves
/// of a parametric surface.
enum class FormLines : std::uint8_t { none, curvature, iso };

/// Direction of hatching strokes: a fixed angle, the level lines of each face, or the curves of the surface.
struct HatchDirection {
  bool by_face = false;  ///< along the level lines of each face
  FormLines form = FormLines::none;
  double degrees = 45;  ///< fixed angle on the page, counter-clockwise; with `by_face` that of horizontal faces
};

/// Hatching of visible faces.
struct HatchRequest {
  HatchKind kind = HatchKind::none;
  std::optional<double> spacing_mm{};  ///< distance of strokes where they are closest; nothing: from the pen width
  HatchDirection direction{};
  bool cross = false;                ///< adds a second family of strokes across the first
  std::optional<unsigned> levels{};  ///< degrees of darkness, 0: continuous; nothing: kMostShades; curved strokes: 0

  bool is_requested() const { return kind != HatchKind::none; }
};

/// Which contour lines are labelled with their height: none, index contours, or all.
enum class ContourLabels : std::uint8_t { none, index, all };

/// An entry of the legend: a sample and a text.
struct LegendEntry {
  std::string text;
  std::optional<std::array<double, 3>> color{};
  std::string layer{}, object{};  ///< layer and object of the lines that it explains
  bool filled = false;            ///< it explains areas, so its sample is a filled area
};

/// Axes, a title, and map signs around the picture of a plot.
struct AxesChoice {
  std::optional<AxesStyle> style;  ///< nothing: no axes
  bool scale_bar = false, north_arrow = false;
  std::string scale_unit{};  ///< unit of the scale bar; empty: metres, if the coordinates have a known length
  std::vector<LegendEntry> legend{};
  std::array<std::vector<std::string>, 3> categories{};  ///< per axis: tick names in place of the numbers 0, 1, 2 ...
  std::array<std::optional<std::string>, 3> names;       ///< names of the x, y and z axis
  TextStyle text = TextStyle::font;
  std::optional<double> text_height_mm;
};

/// Pens and plotter.
struct PlotterRequest {
  std::optional<Optimize> optimize;  ///< nothing: full if by_pens(), else off
  JoinTolerances tolerances;
  bool report = false, preview = false;  ///< whether Picture gets a plotter report and a preview
  bool fit_device = false;               ///< scale the drawing to the drawable area of the device
  bool fit_drawing = false;              ///< the drawing has no fixed scale, so it may be fitted without a request
  double min_length_mm = 0;              ///< shorter strokes are left out
  LongPlotRequest parts;                 ///< parts, pauses and restarts of long plots
  std::shared_ptr<const Device> device;  ///< nullptr: an SVG or PDF for no particular device
  PenTable pens;
  PenTable asked_pens;  ///< the entries of `pens` that the user gave: the layers and objects that they name must exist

  /// Whether the drawing is divided among pens.
  bool by_pens() const { return device || !pens.empty(); }
  Optimize path_work() const { return optimize.value_or(by_pens() ? Optimize::full : Optimize::off); }
};

enum class OutputFormat { svg, pdf, png, json, hpgl, gcode };
inline constexpr std::string_view kOutputFormatNames[] = {"svg", "pdf", "png", "json", "hpgl", "gcode"};

/// The output file.
struct OutputRequest {
  OutputFormat format = OutputFormat::svg;
  double dpi = 150;                   ///< resolution of a PNG
  std::string title;                  ///< title of the document, may be empty
  bool group_objects = false;         ///< SVG: a group per object in every layer; JSON: strokes name their object
  std::vector<ObjectColor> colors{};  ///< SVG, PDF and PNG: the last pattern that fits applies; other objects are black
  std::optional<bool> curves{};       ///< SVG, PDF and PNG: fit arcs to polylines; nothing: if lines are clear
};
inline constexpr std::string_view kSwitchNames[] = {"off", "on"};

/// Tone of grey faces and of lit colours: one for each face; continuous over smooth surfaces, with interpolated normals.
enum class GrayTone : std::uint8_t { face, smooth };
inline constexpr std::string_view kGrayToneNames[] = {"face", "smooth"};

/// A whole picture of a scene.
struct PictureRequest {
  ViewRequest view{};
  LineRequest lines{};
  PageRequest page{};
  FillRequest fill{};
  bool regions = false;  ///< whether the visible areas of faces are a result in themselves
  HatchRequest hatch{};
  bool gray_faces = false;  ///< grey faces, lit from the eye; needs a method that returns spans or pixels
  GrayTone gray_tone = GrayTone::face;
  AxesChoice axes{};
  PlotterRequest plotter{};
  OutputRequest output{};
  std::string heading{};                       ///< title above the picture on the page, may be empty
  std::shared_ptr<const LineGroups> groups{};  ///< lines and points with styles of their own; nullptr: none
  std::shared_ptr<const SurfaceCurves> iso{};  ///< parameter curves for HatchDirection::form; nullptr: none
  ContourLabels contour_labels = ContourLabels::none;
  bool label_decades = false;                       ///< the heights of contour lines are decimal logarithms
  std::shared_ptr<const CompiledScene> compiled{};  ///< made by this method from this scene; nullptr: made when needed
  Keep keep = Keep::nothing;                        ///< purpose for which the method keeps intermediate results
  std::shared_ptr<const KeptVisibility> earlier{};  ///< kept by an earlier run of the same method; nullptr: nothing
  std::shared_ptr<const OccludedCells> blank{};     ///< streamed scenes (streamed_model.hpp): squares of the page that
                                                    ///< faces outside this scene hide; nullptr: none
  MemoryLimit memory{};
  std::function<void(double)> progress{};  ///< called with the fraction of visibility work done, one thread at a time
};

/// Throws RequestError if parts of the request contradict each other or the method: grey faces or hatching in a format
/// that can not have them, hatching or fills with a method that does not return what they need, margins that leave no
/// page.
void check(const PictureRequest& request);

/// Gives a request for grey faces or a continuous tone without a method one that makes spans.
void choose_method_of_gray_faces(PictureRequest& request);

/// Makes the method count the faces in front of lines if LineRequest::most_hiding needs it. Throws RequestError for a
/// method that does not count them.
void count_hidden(LineRequest& request);

}  // namespace ligne
