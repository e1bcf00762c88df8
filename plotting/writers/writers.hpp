#pragma once
/// Writers of drawings. They return the bytes of a file; plotting/writers/output_file.hpp writes bytes to a file.

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
#include "drawing/statistics.hpp"
#include "plotting/curves/fit_curves.hpp"
#include "plotting/page.hpp"

namespace ligne {

/// Page and line styles of a written drawing.
struct PlotOptions {
  Page page{};
  double pen_width_mm = 0.35;
  LineWidths widths_mm{};                                ///< line widths by layer name; they override all other widths
  bool hidden_solid = false;                             ///< hidden lines are not dashed
  std::string title{};                                   ///< document title, may be empty
  double dpi = 150;                                      ///< resolution of a PNG
  bool curves = false;                                   ///< fit arcs to polylines that approximate them
  std::optional<double> curve_rise_mm{};                 ///< CurveLimits::most_rise_mm; nothing: the pen width
  bool starts_stay = false;                              ///< with `curves`: closed strokes keep their starting points
  std::shared_ptr<const KnownEllipses> known{};          ///< with `curves`: CurveLimits::known
  std::function<LineStyle(const std::string&)> style{};  ///< style of a layer by its name; empty: layer_style()

  /// Style of the layers of that name.
  LineStyle style_of(const std::string& layer) const {
    LineStyle found = style ? style(layer) : layer_style(layer, pen_width_mm, hidden_solid);
    if (const auto width = widths_mm.find(layer); width != widths_mm.end()) found = with_width(found, width->second);
    return found;
  }
  /// Style of a layer, with the colour and the width that the layer itself gives.
  LineStyle style_of(const Layer& layer) const {
    LineStyle found = style_of(layer.name);
    if (layer.color) found.color = *layer.color;
    if (layer.width_mm && !widths_mm.contains(layer.name)) found = with_width(found, *layer.width_mm);
    return found;
  }
  /// Limits for fitting arcs to the lines of a layer; nothing if they stay polylines.
  std::optional<CurveLimits> curves_of(const Layer& layer) const {
    if (!curves || !may_be_curved(layer)) return {};
    // One limit for all layers, whatever their widths: a rim is an outline on one side and a crease on the other.
    return CurveLimits{kCurveToleranceMm, curve_rise_mm.value_or(pen_width_mm), starts_stay, known.get()};
  }
};

/// Writes an SVG: width, height and viewBox in mm, one Inkscape layer group per layer, which has the style, and one
/// path per polyline. Here and below, `under` is a picture painted below fills and lines, or null.
std::string write_svg(const Drawing& drawing, const PlotOptions& options, const FacePicture* under = nullptr);
/// The path elements that write_svg() writes for polylines, for use in another SVG. Their unit is the mm; an enclosing
/// group must set the style.
std::string svg_paths(const Polylines& lines);

/// A PDF document at true scale, written page by page.
class PdfDocument {
 public:
  PdfDocument();
  ~PdfDocument();
  /// Adds a page. The title of the first page becomes the title of the document.
  void add_page(const Drawing& drawing, const PlotOptions& options, const FacePicture* under = nullptr);
  /// Returns the bytes of the document. No page can be added afterwards.
  std::string finish();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
};
/// Writes a PDF of one page.
std::string write_pdf(const Drawing& drawing, const PlotOptions& options, const FacePicture* under = nullptr);
/// Size of a PNG in pixels.
struct PixelSize {
  std::uint32_t width = 1, height = 1;
};
/// Size of the PNG of the page at `options.dpi`. Throws std::runtime_error if it would be too large.
PixelSize png_size(const PlotOptions& options);
/// Bytes of memory that the pixels take while they are painted.
inline double png_bytes(const PixelSize& size) { return 4.0 * size.width * size.height; }

/// Writes a PNG on white, for viewing. `under`, if given, must have the size png_size() in pixels.
std::string write_png(const Drawing& drawing, const PlotOptions& options, const FacePicture* under = nullptr);

/// Properties of a region that hatching needs besides its contours.
struct RegionAppearance {
  double light = 1;                      ///< brightness from 0, dark, to 1
  std::array<double, 3> color{0, 0, 0};  ///< red, green, blue in [0, 1]
  std::uint32_t patch = 0;               ///< number shared by regions of faces that meet smoothly: hatching strokes
                                         ///< continue across their common borders
  std::string material{};                ///< name of the material
};

/// An analytic surface recognised behind the mesh, in model units: FoundSurface in scene/patches/found_surfaces.hpp,
/// which explains the members. Members that do not apply to its kind have no value, and are not written.
struct DocumentSurface {
  std::string_view kind{};  ///< "cylinder", "cone", "sphere", "torus", "extruded" or "revolved"
  Point3 at{0, 0, 0};
  std::optional<Point3> axis{};
  std::optional<double> radius{}, slope{}, tube{};
  std::optional<std::array<double, 2>> along{};
  std::optional<double> turn{};  ///< degrees
  bool outward = true;
  double sag = 0;
  std::size_t faces = 0;
  std::uint32_t object = 0;
};

/// A material of the scene, for painting from a stored order.
struct DocumentMaterial {
  std::string name{};
  std::array<double, 3> color{0, 0, 0};  ///< red, green, blue in [0, 1]
  double opacity = 1;
};

/// Properties of a piece of an order that painting needs besides its contours.
struct PieceAppearance {
  double light = 1;            ///< brightness from 0, dark, to 1
  std::uint32_t material = 0;  ///< index into DrawingDocument::materials
  bool hidden = false;         ///< opaque pieces in front hide it: it need not be painted
};

/// The contents of a JSON drawing, except page and pens. The format is docs/drawing-format.md. Null pointers and empty
/// members are not written.
struct DrawingDocument {
  const StrokeModel* strokes = nullptr;
  const std::vector<Region>* regions = nullptr;
  std::vector<RegionAppearance> region_looks{};  ///< per region, or empty
  /// Per region: the numbers of the regions that are seen through it; or empty.
  std::vector<std::vector<std::uint32_t>> seen_through{};
  const PaintOrder* order = nullptr;
  std::vector<PieceAppearance> piece_looks{};  ///< per piece of the order, or empty
  std::vector<DocumentMaterial> materials{};   ///< materials that the pieces name
  const SpanModel* spans = nullptr;
  const ScanPlane* plane = nullptr;
  const std::vector<std::vector<Point2>>* debug = nullptr;  ///< polylines (page mm) that show how the method worked
  std::function<SourceEdge(std::uint32_t)> source;          ///< maps a source number to its edge; must be thread-safe
  std::vector<std::string> objects{};                       ///< names of the objects, if strokes name their object
  std::function<std::uint32_t(std::uint32_t)> object{};     ///< maps a source number to its object, 0xffffffff for none
  std::vector<DocumentSurface> surfaces{};
  std::vector<std::uint32_t> surface_of_face{};  ///< per face: index into `surfaces`, 0xffffffff for none; or empty
  glm::dmat4 model_to_page{1};
  bool perspective = false;
  Rect window{};             ///< page mm; lines outside it were clipped away
  double near_distance = 0;  ///< perspective: distance of the near plane along the line of sight, model units
  std::string method{};
  Statistics statistics{};
};
/// Writes the document as JSON.
std::string write_json(const DrawingDocument& document, const PlotOptions& options);

}  // namespace ligne
