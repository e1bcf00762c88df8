/// Reads SVG as strokes. The tree is walked once; an element is drawn, walked into, left out because it is never
/// visible, or left out and counted because it can not be drawn. Links (use) are followed inside the file only, to a
/// fixed depth, and with a fixed number of elements in all, so that a small file can not ask for endless work. The same
/// holds for entities, clip paths and style sheets.

#include <algorithm>
#include <new>
#include <stdexcept>

#include "areas/work_limit_error.hpp"
#include "files/input_error.hpp"
#include "plotting/devices/pens.hpp"
#include "plotting/svg/reader.hpp"
#include "plotting/svg/xml.hpp"

namespace ligne {
namespace svg {
namespace {

/// Deepest nesting of elements that are drawn.
constexpr int kDeepest = 200;
/// Elements that show nothing where they stand.
constexpr std::string_view kUnseen[] = {
    "defs",           "title",   "desc",      "metadata",      "script", "style",  "linearGradient",
    "radialGradient", "pattern", "clipPath",  "mask",          "filter", "marker", "symbol",
    "view",           "font",    "font-face", "color-profile", "cursor", "hatch",  "altGlyphDef"};

/// Elements that a <switch> can choose.
constexpr std::string_view kDrawn[] = {"g",    "a",    "use",  "switch",  "svg",     "text",     "image",
                                       "line", "path", "rect", "polygon", "ellipse", "polyline", "circle"};

/// Whether an element requires no extension, and no language other than English.
bool is_for_everybody(const pugi::xml_node& node) {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (name == "requiredExtensions" || name == "requiredFormats") return false;
    if (name != "systemLanguage") continue;
    const std::string list = "," + std::string(attribute.value());
    if (list.find(",en") == std::string::npos && list.find(", en") == std::string::npos) return false;
  }
  return true;
}

}  // namespace

void SvgReader::read_sheet(const pugi::xml_node& node) {
  std::string css;
  for (const pugi::xml_node& part : node) css += part.value();
  const std::string_view type = node.attribute("type").value();
  if (!type.empty() && type != "text/css") return;
  try {
    sheet_.add(css, node.attribute("media").value(), [&](const std::string& kind) {
      if (skip_.contains("style")) return refuse("style", node);
      omit(kind, node, "<style> has style, which is not known: " + kind + "; --skip style leaves it out");
    });
  } catch (const WorkLimitError& e) {
    fail(node, e.what());
  }
}

void SvgReader::for_each_element(const pugi::xml_node& root, const std::function<void(const pugi::xml_node&)>& visit) {
  // Without recursion, since a file may be nested to any depth.
  for (pugi::xml_node node = root; node;) {
    if (node.type() == pugi::node_element) visit(node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

/// Finds ids and style sheets.
void SvgReader::survey(const pugi::xml_node& root) {
  for_each_element(root, [&](const pugi::xml_node& node) {
    if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
    if (local_name(node) == "style") read_sheet(node);
  });
}

/// Parses the document and returns its root, with its entities and its namespaces resolved.
pugi::xml_node SvgReader::parse(pugi::xml_document& document) {
  std::size_t external = 0;
  try {
    if (std::optional<ExpandedDocument> expanded = expand_entities(text_)) {
      external = expanded->external;
      expanded_ = std::move(expanded->text);
      text_ = expanded_;
    }
  } catch (const std::invalid_argument& e) {
    throw InputError(file_, e.what());
  }
  const pugi::xml_parse_result parsed =
      document.load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
  if (parsed.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!parsed) {
    const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(parsed.offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    throw InputError(file_ + ":" + std::to_string(1 + std::count(text_.begin(), end, '\n')),
                     std::string("is not XML: ") + parsed.description());
  }
  pugi::xml_node root;
  for (const pugi::xml_node& node : document) {
    if (node.type() == pugi::node_element) root = node;
  }
  if (root) use_plain_names(root);
  if (local_name(root) != "svg") throw InputError(file_, "is not an SVG");
  if (external > 0) leave_out("entities of other files", root);
  if (text_.find("<?xml-stylesheet") != std::string_view::npos) leave_out("style sheets of other files", root);
  return root;
}

ReadDrawing SvgReader::read() {
  pugi::xml_document document;
  const pugi::xml_node root = parse(document);
  survey(root);
  try {
    apply_geometry_properties(root);
    Context context = place_page(root);
    if (enter(root, context)) walk_children(root, context);
  } catch (const std::invalid_argument& e) {
    fail(root, e.what());
  }
  result_.dashes_cut = true;
  try {
    remove_hidden();
  } catch (const std::invalid_argument& e) {
    fail(root, e.what());
  }
  for (std::vector<PaintedLines>& parts : layers_) {
    for (PaintedLines& part : parts) {
      if (result_.size_assumed) extend_page(part.layer.lines);
      if (part.layer.lines.size() > 0) result_.drawing.layers.push_back(std::move(part.layer));
    }
  }
  return std::move(result_);
}

/// The lines of one colour and width in a layer. `width_mm` 0: the width of the pen.
PaintedLines& SvgReader::layer_of(const std::string& name, const std::string& color, double width_mm) {
  const auto [number, is_new] = layer_numbers_.emplace(name, layers_.size());
  if (is_new) layers_.emplace_back();
  std::vector<PaintedLines>& parts = layers_[number->second];
  const auto [part, added] = parts_.emplace(std::tuple(number->second, color, width_mm), parts.size());
  if (added) {
    Layer& layer = parts.emplace_back(PaintedLines{{name, {}}, {}}).layer;
    try {
      layer.color = parse_color(color);
    } catch (const std::invalid_argument&) {
      // An unknown name of a colour is drawn in black.
    }
    if (width_mm > 0) layer.width_mm = width_mm;
  }
  return parts[part->second];
}

/// The transform of an element, about its origin.
Matrix SvgReader::placing_of(const pugi::xml_node& node, const Context& context) {
  const Style& style = context.style;
  if (!style.placing) return {};
  if (style.origin.empty()) return *style.placing;
  Matrix box{context.port.width, 0, 0, context.port.height, 0, 0};
  if (style.origin_of_box) {
    const std::optional<Matrix> own = box_of(node, context);
    if (!own) {
      omit("origins of transforms in boxes of groups", node,
           "<" + printable(node.name()) + "> has a transform-origin in its box");
      return *style.placing;
    }
    box = *own;
  }
  try {
    const Point2 origin = transform_origin(style.origin, context.port, box);
    return Matrix{1, 0, 0, 1, origin.x, origin.y} * *style.placing * Matrix{1, 0, 0, 1, -origin.x, -origin.y};
  } catch (const std::invalid_argument& e) {
    diagnostics_.bad_value("transform-origin", node, e.what());
    return *style.placing;
  }
}

/// Applies the style, the transform and the clip path of an element to the context. False if it is not displayed.
bool SvgReader::enter(const pugi::xml_node& node, Context& context) {
  bool displayed = true;
  context.style = styled(node, context.style, context.port, displayed);
  context.port.em = context.style.font_size;
  if (!displayed) return false;
  context.opacity *= context.style.opacity;
  if (context.style.opacity < 1 || context.style.blended) context.since = painted_;
  if (context.style.placing) context.to_mm = context.to_mm * placing_of(node, context);
  if (!context.style.clip.empty()) context.clip = clip_of(context.style.clip, node, context);
  if (!context.style.mask.empty()) context.clip = mask_of(context.style.mask, node, context);
  return true;
}

void SvgReader::omit_deep(const pugi::xml_node& node) {
  const std::string deep = "deeper than " + std::to_string(kDeepest) + " elements";
  omit("elements nested " + deep, node, "is nested " + deep);
}

void SvgReader::walk_children(const pugi::xml_node& node, const Context& context) {
  if (context.depth > kDeepest) return omit_deep(node);
  const OpenElement open(open_, node);
  Context inside = context;
  ++inside.depth;
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_element) walk(child, inside);
  }
}

void SvgReader::walk(const pugi::xml_node& node, const Context& around) {
  if (around.links > 0 && ++linked_ > kMostLinked) fail(node, "<use> shows more than a million elements");
  const std::string_view name = local_name(node);
  // Elements of editors and metadata have prefixes of their own.
  if (name.empty()) return;
  if (std::ranges::find(kUnseen, name) != std::end(kUnseen) || !is_for_everybody(node)) return;
  for (const std::string_view known : {"image", "foreignObject"}) {
    if (name == known) return refuse(known, node);
  }
  if (name.starts_with("animate") || name == "set" || name == "discard") return refuse("animation", node);
  const std::string shown_name = "<" + printable(name) + ">";
  try {
    walk_element(name, node, around);
  } catch (const WorkLimitError& e) {
    fail(node, shown_name + " " + e.what());
  } catch (const CoordinateRangeError& e) {
    omit("elements farther than a kilometre away", node, shown_name + " " + e.what());
  } catch (const std::invalid_argument& e) {
    omit(shown_name + " elements with errors", node, shown_name + " " + e.what());
  }
}

void SvgReader::walk_element(std::string_view name, const pugi::xml_node& node, const Context& around) {
  Context context = around;
  if (!enter(node, context)) return;
  if (name == "g" || name == "a") {
    const bool is_layer = std::string_view(node.attribute("inkscape:groupmode").value()) == "layer";
    const std::string label = node.attribute("inkscape:label").value();
    if (is_layer && !label.empty()) context.layer = label;
    return walk_children(node, context);
  }
  if (name == "switch") return walk_switch(node, context);
  if (name == "svg") return walk_viewport(node, context, node);
  if (name == "use") return follow_use(node, context);
  if (name == "text" || name == "flowRoot") return context.style.visible ? draw_text(node, context) : void();
  // Viewers show neither unknown elements nor their children: notes of editors and of plotter software.
  if (!draw_shape(name, node, context)) leave_out("<" + printable(name) + "> elements", node);
}

/// Walks the first alternative that is meant for everybody and can be drawn.
void SvgReader::walk_switch(const pugi::xml_node& node, const Context& context) {
  Context inside = context;
  ++inside.depth;
  if (inside.depth > kDeepest) return omit_deep(node);
  for (const pugi::xml_node& child : node) {
    const bool drawable = std::ranges::find(kDrawn, local_name(child)) != std::end(kDrawn);
    if (child.type() == pugi::node_element && drawable && is_for_everybody(child)) return walk(child, inside);
  }
}

ClipPointer SvgReader::frame_clip(double width, double height, const Context& context) const {
  Polylines frame;
  Outline outline(frame, context.to_mm);
  outline.move_to({0, 0});
  for (const Point2 p : {Point2{width, 0}, {width, height}, {0, height}}) outline.line_to(p);
  outline.close();
  auto clip = std::make_shared<Clip>();
  clip->any_of.emplace_back(frame, FillRule::nonzero, clip_work_);
  clip->outer = context.clip;
  return clip;
}

/// Walks a nested svg, or a symbol whose size its <use> gives.
void SvgReader::walk_viewport(const pugi::xml_node& node, Context context, const pugi::xml_node& size) {
  if (local_name(node) == "svg") {
    context.to_mm = context.to_mm * Matrix{1, 0, 0, 1, attributes(context).x(node, "x"), attributes(context).y(node, "y")};
  }
  const Attributes given = attributes(context);
  const bool own = local_name(node) == "svg";
  const double width = given.x(size, "width", own ? given.x(node, "width", context.port.width) : context.port.width),
               height = given.y(size, "height", own ? given.y(node, "height", context.port.height) : context.port.height);
  if (!(width > 0 && height > 0)) return;
  const Matrix inside = view_box_to(node, given, width, height, context.port);
  // SVG 2, 5.5: the reference point lies where the <use> stands; without one it is the corner of the frame.
  const auto shift = [&](const char* name) { return node.attribute(name) && local_name(node) == "symbol"; };
  const Point2 reference = inside({given.x(node, "refX"), given.y(node, "refY")});
  context.to_mm = context.to_mm * Matrix{1, 0, 0, 1, shift("refX") ? -reference.x : 0, shift("refY") ? -reference.y : 0};
  if (!context.style.overflow.value_or(false)) context.clip = frame_clip(width, height, context);
  context.to_mm = context.to_mm * inside;
  walk_children(node, context);
}

/// The element that a <use> shows; nothing if no element has that id, as in viewers.
pugi::xml_node SvgReader::target_of(const pugi::xml_node& use) {
  std::string_view target = use.attribute("href").value();
  if (target.empty()) target = use.attribute("xlink:href").value();
  if (target.empty()) return {};
  if (!target.starts_with('#')) {
    omit("<use> elements of other files", use, "<use> leads out of the file");
    return {};
  }
  const auto found = ids_.find(std::string(target.substr(1)));
  return found == ids_.end() ? pugi::xml_node() : found->second;
}

void SvgReader::follow_use(const pugi::xml_node& node, const Context& context) {
  const pugi::xml_node target = target_of(node);
  if (!target) return;
  const OpenElement open(open_, node);
  if (context.links >= kMostLinks || !open.is_new() || open_.contains(target.internal_object())) {
    return omit("self-referring <use> elements", node,
                "<use> leads on more than " + std::to_string(kMostLinks) + " times, or back to itself");
  }
  if (context.depth > kDeepest) return omit_deep(node);
  Context inside = context;
  inside.to_mm = context.to_mm * Matrix{1, 0, 0, 1, attributes(context).x(node, "x"), attributes(context).y(node, "y")};
  ++inside.depth;
  ++inside.links;
  inside.style.context_fill = context.style.fill;
  inside.style.context_stroke = context.style.stroke;
  const std::string_view name = local_name(target);
  if (name != "symbol" && name != "svg") return walk(target, inside);
  if (++linked_ > kMostLinked) fail(node, "<use> shows more than a million elements");
  if (enter(target, inside)) walk_viewport(target, inside, node);
}

}  // namespace svg

ReadDrawing read_svg_drawing(std::string_view text, const std::string& file, const std::set<std::string>& skip,
                             const FillReading& fills, const SvgReading& reading) {
  return svg::SvgReader(text, file, skip, fills, reading).read();
}

}  // namespace ligne
