#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/parallel.hpp"
#include "files/input_error.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "plotting/readers/order_reader.hpp"

namespace ligne {
namespace {

using nlohmann::json;

/// Collects strokes by layer. It takes them out of the JSON tree as they are parsed, so that a large drawing is not in
/// memory twice.
class DrawingReader {
 public:
  DrawingReader(std::string file, bool with_order) : file_(std::move(file)), with_order_(with_order) {}

  ReadDrawing read(std::string_view text) {
    json root;
    SplitDrawing split;
    if (with_order_) {
      split = split_drawing(text, file_);
      text = split.rest;
    }
    try {
      root =
          json::parse(text, [this](int depth, json::parse_event_t event, json& value) { return take(depth, event, value); });
    } catch (const json::parse_error& e) {
      fail("is not JSON: at byte " + std::to_string(e.byte));
    } catch (const json::exception& e) {
      fail("is not valid JSON");
    }
    if (!root.is_object() || root.value("format", json()) != "ligne-drawing") fail("is not a ligne-drawing");
    // Strokes have the same form in both versions.
    const json version = root.value("version", json());
    if (version != 1 && version != 2) fail("the version of the ligne-drawing is neither 1 nor 2");
    if (!has_strokes_) fail("there are no strokes in the drawing");
    ReadDrawing result{.regions = std::move(regions_), .page = page_of(root)};
    if (with_order_) result.order = order_of(root, split.order);
    for (Layer& layer : layers_) {
      if (layer.lines.size() > 0) result.drawing.layers.push_back(std::move(layer));
    }
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& cause) const { throw InputError(file_, cause); }
  [[noreturn]] void fail_stroke(const std::string& cause) const { fail("stroke " + std::to_string(count_) + ": " + cause); }

  bool take(int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::key && depth == 1) {
      in_strokes_ = value == "strokes";
      if (in_strokes_ && has_strokes_) fail("there are two lists of strokes");
      has_strokes_ = has_strokes_ || in_strokes_;
      in_regions_ = value == "regions";
      in_order_ = value == "order";
      is_kept_ = with_order_ && (value == "lattice" || value == "materials");
      if (in_order_ && has_order_) fail("there are two painting orders");
      has_order_ = has_order_ || in_order_;
      return true;
    }
    if (in_order_ && depth >= 2) return false;  // pieces are read by order_reader.hpp
    if (in_regions_) {
      if (event == json::parse_event_t::object_start && depth > 2) fail_region("has an object inside");
      if (event != json::parse_event_t::object_end || depth != 2) return true;
      add_region(value);
      return false;
    }
    if (is_kept_) return true;
    if (!in_strokes_) return depth < 3 || event == json::parse_event_t::key;
    if (event == json::parse_event_t::object_start && depth > 2) return false;  // the source edge
    if (event == json::parse_event_t::object_end && depth == 2) {
      add(value);
      return false;
    }
    return true;
  }

  /// `fail_with` throws an error that names the place of the point.
  static Point2 point_of(const json& p, FunctionRef<void(const std::string&)> fail_with) {
    if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number()) fail_with("a point is not two numbers");
    const Point2 point{p[0].get<double>(), p[1].get<double>()};
    if (!(std::abs(point.x) <= kFarthestMm && std::abs(point.y) <= kFarthestMm))
      fail_with("a point is farther than a kilometre away");
    return point;
  }

  void add(const json& stroke) {
    const auto line_class = stroke.find("class"), visible = stroke.find("visible"), points = stroke.find("points");
    if (line_class == stroke.end() || !line_class->is_string()) fail_stroke("has no class");
    if (visible == stroke.end() || !visible->is_boolean()) fail_stroke("visible is neither true nor false");
    if (points == stroke.end() || !points->is_array() || points->size() < 2) fail_stroke("has fewer than two points");
    const auto level = stroke.find("level");
    if (level != stroke.end() && !level->is_number_unsigned()) fail_stroke("its level is not a whole number");
    const bool through_transparent = level != stroke.end() && level->get<std::uint64_t>() > 0;
    Polylines& lines = layer_of(line_class->get_ref<const std::string&>(), visible->get<bool>(), through_transparent);
    for (const json& p : *points) {
      lines.points.push_back(point_of(p, [&](const std::string& cause) { fail_stroke(cause); }));
    }
    lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
    if (with_order_) keep_ends(lines, visible->get<bool>(), level == stroke.end() ? 0 : level->get<std::uint64_t>());
    ++count_;
  }

  /// Keeps the ends of the stroke that was added last, to be put on the lattice.
  void keep_ends(const Polylines& lines, bool visible, std::uint64_t level) {
    if (lines[lines.size() - 1].size() != 2) fail_stroke("is not a straight line");
    painted_.strokes.strokes.push_back({.line_class = last_class_,
                                        .visible = visible,
                                        .level = static_cast<std::uint8_t>(std::min<std::uint64_t>(level, 255))});
    ends_.push_back({lines.points[lines.points.size() - 2], lines.points.back()});
  }

  [[noreturn]] void fail_region(const std::string& cause) const {
    fail("region " + std::to_string(regions_.size()) + ": " + cause);
  }

  using Contours = std::vector<std::vector<Point2>>;

  static void add_contour(const json& contour, Contours& contours, FunctionRef<void(const std::string&)> fail_with) {
    if (!contour.is_array() || contour.size() < 3) fail_with("a contour has fewer than three points");
    std::vector<Point2>& points = contours.emplace_back();
    for (const json& p : contour) points.push_back(point_of(p, fail_with));
  }

  static Contours contours_of(const json& value, FunctionRef<void(const std::string&)> fail_with) {
    const auto outer = value.find("outer"), holes = value.find("holes");
    Contours contours;
    if (outer == value.end()) fail_with("has no outer contour");
    add_contour(*outer, contours, fail_with);
    if (holes == value.end() || !holes->is_array()) return contours;
    for (const json& hole : *holes) add_contour(hole, contours, fail_with);
    return contours;
  }

  /// Reads the materials and the lattice, which are not in the pieces, and returns the order.
  ReadOrder order_of(const json& root, std::string_view pieces) {
    if (!has_order_) fail("has no painting order; ligne draw --method newell -o FILE.json stores one");
    if (!pieces.empty()) read_pieces(pieces, file_, painted_);
    for (const json& one : root.value("materials", json::array())) {
      DocumentMaterial material;
      if (!one.is_object()) fail("a material is not an object");
      if (const auto name = one.find("name"); name != one.end() && name->is_string())
        material.name = name->get<std::string>();
      const auto color = one.find("color"), opacity = one.find("opacity");
      for (std::size_t c = 0; color != one.end() && color->is_array() && c < std::min<std::size_t>(color->size(), 3); ++c) {
        if ((*color)[c].is_number()) material.color[c] = std::clamp((*color)[c].get<double>(), 0.0, 1.0);
      }
      if (opacity != one.end() && opacity->is_number()) material.opacity = std::clamp(opacity->get<double>(), 0.0, 1.0);
      painted_.materials.push_back(std::move(material));
    }
    for (const ReadOrder::Piece& piece : painted_.pieces) {
      if (piece.material >= painted_.materials.size()) fail("a piece of the order has a missing material");
    }
    put_on_lattice(root.value("lattice", json()));
    return std::move(painted_);
  }

  void put_on_lattice(const json& lattice) {
    const json origin = lattice.is_object() ? lattice.value("origin_mm", json()) : json();
    const json step = lattice.is_object() ? lattice.value("step_mm", json()) : json();
    if (!step.is_number() || !(step.get<double>() > 0)) fail("the lattice has no step_mm");
    Lattice& to = painted_.strokes.lattice;
    to.origin_mm = point_of(origin, [&](const std::string& cause) { fail("the lattice: " + cause); });
    to.step_mm = step.get<double>();
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      painted_.strokes.strokes[i].from = to.snap(ends_[i][0]);
      painted_.strokes.strokes[i].to = to.snap(ends_[i][1]);
    }
  }

  /// Regions seen through transparent faces are not hatched.
  void add_region(const json& value) {
    const auto level = value.find("level");
    if (level != value.end() && level->is_number() && level->get<double>() > 0) return;
    ReadRegion region;
    region.contours = contours_of(value, [&](const std::string& cause) { fail_region(cause); });
    // Files of earlier versions have neither patch nor light: each region is an area of its own.
    const auto patch = value.find("patch"), light = value.find("light"), color = value.find("color"),
               material = value.find("material_name");
    region.patch = patch != value.end() && patch->is_number_unsigned() ? patch->get<std::uint32_t>()
                                                                       : static_cast<std::uint32_t>(regions_.size());
    if (light != value.end() && light->is_number()) region.light = std::clamp(light->get<double>(), 0.0, 1.0);
    if (color != value.end() && color->is_array() && color->size() == region.color.size()) {
      for (std::size_t i = 0; i < region.color.size(); ++i) {
        if ((*color)[i].is_number()) region.color[i] = std::clamp((*color)[i].get<double>(), 0.0, 1.0);
      }
    }
    if (material != value.end() && material->is_string()) region.material = material->get<std::string>();
    regions_.push_back(std::move(region));
  }

  Polylines& layer_of(const std::string& line_class, bool visible, bool through_transparent) {
    for (std::size_t c = 0; c < kLineClassCount; ++c) {
      if (kLineClassNames[c] != line_class) continue;
      last_class_ = static_cast<LineClass>(c);
      return layers_[stroke_layer(last_class_, visible, through_transparent)].lines;
    }
    fail_stroke("there is no class of that name");
  }

  Page page_of(const json& root) const {
    Page page;
    const json sheet = root.value("page", json());
    const auto side = [&](const char* key, double& mm, bool may_be_zero) {
      const json value = sheet.is_object() ? sheet.value(key, json()) : json();
      if (!value.is_number()) fail(std::string("the page has no ") + key);
      mm = value.get<double>();
      if (!(mm >= 0 && mm <= kLargestPageMm) || (mm == 0 && !may_be_zero))
        fail(std::string(key) + " of the page is out of range");
    };
    side("width_mm", page.width_mm, false);
    side("height_mm", page.height_mm, false);
    side("margin_mm", page.margin_mm, true);
    return page;
  }

  std::string file_;
  bool in_strokes_ = false, has_strokes_ = false, in_regions_ = false;
  bool with_order_ = false, in_order_ = false, has_order_ = false, is_kept_ = false;
  std::vector<ReadRegion> regions_;
  ReadOrder painted_;
  std::vector<std::array<Point2, 2>> ends_;  ///< ends of the strokes in painted_
  LineClass last_class_ = LineClass::mesh;
  std::size_t count_ = 0;
  /// The layers in the order of painting.
  std::array<Layer, kStrokeLayerCount> layers_ = [] {
    std::array<Layer, kStrokeLayerCount> layers;
    for (std::size_t l = 0; l < kStrokeLayerCount; ++l) layers[l].name = stroke_layer_name(l);
    return layers;
  }();
};

}  // namespace

ReadDrawing read_json_drawing(std::string_view json, const std::string& file, bool with_order) {
  return DrawingReader(file, with_order).read(json);
}

}  // namespace ligne
