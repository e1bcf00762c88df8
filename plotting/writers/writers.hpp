#pragma once
/// Writers of drawings. All give their bytes back; writing them to a file is plotting/writers/output_file.hpp's.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

#include "drawing/drawing.hpp"
#include "drawing/result_models.hpp"
#include "drawing/shading.hpp"
#include "drawing/statistics.hpp"
#include "plotting/page.hpp"
#include "plotting/paths/fit_curves.hpp"

namespace ligne {

struct PlotOptions {
  Page page;
  double pen_width_mm = 0.35;
  LineWidths widths_mm{};  ///< of layers by their names, before what follows from the pen's
  bool hidden_solid = false;
  std::string title;                                     ///< document title, may be empty
  double dpi = 150;                                      ///< PNG
  bool curves = false;                                   ///< arcs where lines are tessellated ones (paths/fit_curves.hpp)
  std::optional<double> curve_rise_mm{};                 ///< CurveLimits::most_rise_mm; nothing: the width of the pen
  bool starts_stay = false;                              ///< with `curves`: the strokes begin where they do in the plot
  std::function<LineStyle(const std::string&)> style{};  ///< of a layer; empty: layer_style

  LineStyle style_of(const std::string& layer) const {
    LineStyle found = style ? style(layer) : layer_style(layer, pen_width_mm, hidden_solid);
    if (const auto width = widths_mm.find(layer); width != widths_mm.end()) found = with_width(found, width->second);
    return found;
  }
  LineStyle style_of(const Layer& layer) const {
    LineStyle found = style_of(layer.name);
    if (layer.color) found.color = *layer.color;
    if (layer.width_mm && !widths_mm.contains(layer.name)) found = with_width(found, *layer.width_mm);
    return found;
  }
  /// Nothing where the lines of the layer stay as they are.
  std::optional<CurveLimits> curves_of(const Layer& layer) const {
    if (!curves || !may_be_curved(layer)) return {};
    // The pen of the outline counts, not the layer's: a rim is an outline on one side and a crease on the other.
    return CurveLimits{kCurveToleranceMm, curve_rise_mm.value_or(pen_width_mm), starts_stay};
  }
};

/// SVG: width, height and viewBox in mm, one Inkscape layer group per layer with the style on it, one path per polyline.
/// Here and below `under` lies below fills and lines, or is null.
std::string write_svg(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under = nullptr);
/// The polylines as write_svg() writes them, for an SVG inside another document: its unit is the mm, and the style stands
/// about them.
std::string svg_paths(const Polylines& lines);

/// A PDF of true size, page by page.
class PdfDocument {
 public:
  PdfDocument();
  ~PdfDocument();
  /// The document's title is that of the first page.
  void add_page(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under = nullptr);
  /// The bytes. Nothing can be added afterwards.
  std::string finish();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
};
/// Writes a PDF of one page.
std::string write_pdf(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under = nullptr);
/// Pixels of a PNG, width and height.
struct PixelSize {
  std::uint32_t width = 1, height = 1;
};
/// Throws std::runtime_error when the picture would be too large.
PixelSize png_size(const PlotOptions& options);
/// Bytes of the pixels while they are painted.
inline double png_bytes(const PixelSize& size) { return 4.0 * size.width * size.height; }

/// PNG on white, for looking; the pixels of `under` are its own, as many as png_size() says.
std::string write_png(const Drawing& drawing, const PlotOptions& options, const GrayPicture* under = nullptr);

/// The facts about a region that hatching needs beyond its contours.
struct RegionAppearance {
  double light = 1;  ///< 0 dark to 1
  std::array<double, 3> color{0, 0, 0};
  std::uint32_t patch = 0;  ///< faces that meet smoothly have one: strokes go on over their borders
  std::string material{};   ///< its name
};

/// A surface behind the mesh, in model units. Members that its kind has not are not written.
struct DocumentSurface {
  std::string_view kind;  ///< "cylinder", "cone", "sphere" or "torus"
  Point3 at{0, 0, 0};
  std::optional<Point3> axis{};
  double radius = 0;
  std::optional<double> slope{}, tube{};
  std::optional<std::array<double, 2>> along{};
  std::optional<double> turn{};  ///< degrees
  bool outward = true;
  double sag = 0;
  std::size_t faces = 0;
  std::uint32_t object = 0;
};

/// The contents of the JSON drawing beside page and pens: docs/drawing-format.md.
struct DrawingDocument {
  const StrokeModel* strokes = nullptr;
  const std::vector<Region>* regions = nullptr;
  std::vector<RegionAppearance> region_looks{};  ///< one for each region, or none
  /// For each region the numbers of those that are seen through it; or none.
  std::vector<std::vector<std::uint32_t>> seen_through{};
  const PaintOrder* order = nullptr;
  const SpanModel* spans = nullptr;
  const std::vector<std::vector<Point2>>* debug = nullptr;  ///< polylines that show how the method worked
  std::function<SourceEdge(std::uint32_t)> source;  ///< the source edge of that number; called from several threads at once
  std::vector<std::string> objects{};               ///< their names, where strokes say their object
  std::function<std::uint32_t(std::uint32_t)> object{};  ///< of the source edge of that number, 0xffffffff for none
  std::vector<DocumentSurface> surfaces{};
  std::vector<std::uint32_t> surface_of_face{};  ///< where there are surfaces: their number per face, 0xffffffff for none
  glm::dmat4 model_to_page{1};
  bool perspective = false;
  Rect window;               ///< page mm; what lies outside was clipped away
  double near_distance = 0;  ///< perspective: distance of the near plane along the line of sight, model units
  std::string method;
  Statistics statistics;
};
std::string write_json(const DrawingDocument& document, const PlotOptions& options);

}  // namespace ligne
