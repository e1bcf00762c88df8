#pragma once
/// The walk over the tree of an SVG. Private to plotting: plotting/readers/drawing_reader.hpp is for others.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <pugixml.hpp>

#include "areas/clip.hpp"
#include "areas/occluder.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "plotting/svg/shapes.hpp"
#include "plotting/svg/style/style.hpp"

namespace ligne::svg {

using ClipPointer = std::shared_ptr<const Clip>;

/// State that an element inherits from the elements around it.
struct Context {
  Style style;
  Matrix to_mm;
  std::string layer;
  Viewport port;
  ClipPointer clip;         ///< nullptr: everything shows
  double opacity = 1;       ///< product of the opacities of the element and the groups around it
  std::uint32_t since = 0;  ///< shapes painted before the translucent group around; 0: there is none
  int depth = 0, links = 0;
};

/// Marks an element while its children are drawn. An element that is marked already leads back to itself.
class OpenElement {
 public:
  OpenElement(std::unordered_set<const void*>& open, const pugi::xml_node& node)
      : open_(open), element_(node.internal_object()), is_new_(open.insert(element_).second) {}
  OpenElement(const OpenElement&) = delete;
  OpenElement& operator=(const OpenElement&) = delete;
  ~OpenElement() {
    if (is_new_) open_.erase(element_);
  }
  bool is_new() const { return is_new_; }

 private:
  std::unordered_set<const void*>& open_;
  const void* element_;
  bool is_new_;
};

/// Lines of one colour and width in a layer, and their places in the painting order.
struct PaintedLines {
  Layer layer;
  std::vector<std::uint32_t> painted;
  std::string in_layer{};  ///< layer of the document, or empty
};

/// Most elements that links show, in all.
inline constexpr std::size_t kMostLinked = 1'000'000;

inline constexpr std::string_view kWhite = "#ffffff";

/// Whether a length of the root depends on a window around the page, which paper does not have.
bool depends_on_window(std::string_view length);

/// An area painted so far. White areas and letters painted later are drawn where they lie on its colour.
struct FillBelow {
  FilledArea filled;
  std::string color;
  Rect box;
  std::optional<Area> area{};  ///< made on first use
};

class SvgReader {
 public:
  SvgReader(std::string_view text, std::string file, const std::set<std::string>& skip, const FillReading& fills,
            const SvgReading& reading);

  ReadDrawing read();

 private:
  std::size_t line_of(const pugi::xml_node& node) const;
  [[noreturn]] void fail(const pugi::xml_node& node, const std::string& cause) const;
  /// Leaves out and counts a part that can be skipped by this name, or fails.
  void refuse(std::string_view name, const pugi::xml_node& node);
  /// Counts a part that is not drawn, once for each element; `kind` is a noun in the plural.
  void leave_out(const std::string& kind, const pugi::xml_node& node);
  /// Leaves a part out likewise, or fails with `cause` if reading is strict.
  void omit(const std::string& kind, const pugi::xml_node& node, const std::string& cause);
  pugi::xml_node parse(pugi::xml_document& document);
  static void for_each_element(const pugi::xml_node& root, const std::function<void(const pugi::xml_node&)>& visit);
  void survey(const pugi::xml_node& root);
  void apply_geometry(pugi::xml_node node, const Declaration& declaration);
  void apply_geometry_properties(const pugi::xml_node& root);
  void read_sheet(const pugi::xml_node& node);
  void note_paper(double width, double height);
  Attributes attributes(const Context& context) const { return {context.port, diagnostics_}; }
  Matrix placing_of(const pugi::xml_node& node, const Context& context);
  double mm_per_px() const { return kMmPerInch / reading_.px_per_inch; }
  Context place_page(const pugi::xml_node& root);
  void extend_page(const Polylines& lines);
  bool enter(const pugi::xml_node& node, Context& context);
  void walk(const pugi::xml_node& node, const Context& around);
  void walk_element(std::string_view name, const pugi::xml_node& node, const Context& around);
  void omit_deep(const pugi::xml_node& node);
  void walk_children(const pugi::xml_node& node, const Context& context);
  void walk_switch(const pugi::xml_node& node, const Context& context);
  void walk_viewport(const pugi::xml_node& node, Context context, const pugi::xml_node& size);
  void follow_use(const pugi::xml_node& node, const Context& context);
  pugi::xml_node target_of(const pugi::xml_node& use);
  /// The clip of the frame at (0, 0) inside the clip of the context.
  ClipPointer frame_clip(double width, double height, const Context& context) const;
  /// The style that an element inherits where it is defined, for elements that are used elsewhere.
  Style style_around(const pugi::xml_node& node, const Viewport& port);
  ClipPointer clip_of(const std::string& id, const pugi::xml_node& node, const Context& context);
  ClipPointer mask_of(const std::string& id, const pugi::xml_node& node, const Context& context);
  ClipPointer region_of(const pugi::xml_node& mask, const pugi::xml_node& node, const Context& context);
  bool add_clip_shape(const pugi::xml_node& node, Matrix to_mm, const Context& context, Clip& clip, int links,
                      bool is_mask = false);
  bool is_whitened(const pugi::xml_node& node) const;
  bool add_clip_areas(const pugi::xml_node& node, const Polylines& lines, const Context& context, Clip& clip, bool is_mask);
  void extend_box(const pugi::xml_node& node, const Context& context, const Matrix& to_box, Rect& box);
  std::optional<Matrix> box_of(const pugi::xml_node& node, const Context& context);
  bool draw_shape(std::string_view name, const pugi::xml_node& node, const Context& context);
  void draw_stroke(const pugi::xml_node& node, Polylines lines, const Context& context);
  void draw_markers(const pugi::xml_node& node, const std::vector<PathVertex>& vertices, const Context& context);
  void draw_marker(const pugi::xml_node& marker, const pugi::xml_node& node, const PathVertex& vertex, bool start,
                   const Context& context);
  double stroke_width_mm(const Context& context) const;
  double units_of_path_length(const pugi::xml_node& node, Polylines lines, const Context& context);
  static FillRule fill_rule(const Context& context);
  void draw_rim(const Polylines& contours, const Context& context, const std::string& color);
  /// Draws white lines in the colours of the areas on which they lie, and returns the rest. `white`: the area whose
  /// borders they are; nullptr: letters.
  Polylines draw_on_colors(Polylines lines, const Area* white, const Context& context);
  /// `stroked`: a stroke is painted along the fill; `stroke_follows`: after it.
  void draw_fill(const pugi::xml_node& node, const Polylines& lines, const Context& context, bool stroked,
                 bool stroke_follows);
  void hatch_fill(const Polylines& contours, const Context& context, const std::string& color);
  void add_lines(const Polylines& lines, const Context& context, const std::string& color, double width_mm);
  void draw_text(const pugi::xml_node& node, const Context& context);
  void draw_letter(const pugi::xml_node& node, const std::string& letter, const Style& style, const Matrix& place,
                   const Context& context);
  bool has_paint(const std::optional<Paint>& paint, const pugi::xml_node& node);
  /// Kinds of a gradient or pattern, with the links that it follows.
  enum class ServerKind { opaque, translucent, empty };
  ServerKind kind_of_server(const std::string& id) const;
  bool is_opaque_fill(const Context& context) const;
  bool is_server(const std::string& id) const;
  std::string color_of(const Paint& paint, const pugi::xml_node& node);
  /// `rim_width`: width of the line drawn along the contours, mm; 0: the width of the pen; nothing: no line.
  void hide(const Polylines& contours, const Context& context, std::optional<double> rim_width);
  void remove_hidden();
  PaintedLines& layer_of(const std::string& name, const std::string& color, double width_mm);
  Style styled(const pugi::xml_node& node, const Style& inherited, const Viewport& port, bool& displayed) const {
    return style_of(node, inherited, sheet_, port, displayed, diagnostics_);
  }

  std::string_view text_;
  std::string file_;
  const std::set<std::string>& skip_;
  FillReading fills_;
  SvgReading reading_;
  Diagnostics diagnostics_;
  std::string expanded_;  ///< the document with its entities expanded, if it has any
  ReadDrawing result_;
  std::set<std::pair<const void*, std::string>> omitted_;  ///< elements and kinds that have been counted
  std::unordered_set<const void*> open_;                   ///< elements whose children are being drawn
  std::vector<std::vector<PaintedLines>> layers_;          ///< by name, each by colours and widths
  std::unordered_map<std::string, std::size_t> layer_numbers_;
  std::map<std::tuple<std::size_t, std::string, double>, std::size_t> parts_;  ///< index in layers_[first]
  std::unordered_map<std::string, pugi::xml_node> ids_;
  StyleSheet sheet_;
  std::unordered_map<const void*, Style> styles_around_;  ///< by the parents of clip paths, masks and markers
  std::unordered_set<const void*> open_clips_;            ///< clip paths and masks that are being made
  std::size_t linked_ = 0, clip_points_ = 0, boxed_ = 0;
  double border_work_ = 0;  ///< work on contours cut down to borders
  double white_work_ = 0;   ///< work on white lines on colours
  ClipWork clip_work_ = std::make_shared<std::size_t>(0);
  std::vector<Occluder> occluders_;
  FilledAreas filled_;
  std::vector<FillBelow> fills_below_;  ///< in painting order
  std::uint32_t painted_ = 0;           ///< number of fills, strokes, markers and texts so far
  double fill_work_ = 0;
  std::string last_clip_;  ///< id and matrix of the clip path that was made last
  ClipPointer last_made_;
  bool drawn_ = false;
};

}  // namespace ligne::svg
