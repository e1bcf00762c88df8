/// SVG as strokes. The tree is walked once; an element is drawn, walked into, left out because it never shows, or refused by
/// name. Links (use) are followed inside the file only, to a fixed depth, and with a fixed number of elements in all, so
/// that a small file can not ask for endless work. The same holds for clip paths and style sheets.

#include <algorithm>
#include <new>
#include <stdexcept>

#include "files/input_error.hpp"
#include "plotting/pens.hpp"
#include "plotting/svg/reader.hpp"

namespace ligne {
namespace svg {
namespace {

constexpr int kDeepest = 200;
/// Elements that are shown by links, in all.
constexpr std::size_t kMostLinked = 1'000'000;
constexpr double kAssumedPx = 1000;

}  // namespace

void SvgReader::fail(const pugi::xml_node& node, const std::string& cause) const {
  const std::ptrdiff_t offset = node.offset_debug();
  std::string place = file_;
  if (offset > 0 && static_cast<std::size_t>(offset) <= text_.size()) {
    place += ":" + std::to_string(1 + std::count(text_.begin(), text_.begin() + offset, '\n'));
  }
  throw InputError(place, cause);
}

void SvgReader::refuse(std::string_view name, const pugi::xml_node& node) {
  if (skip_.contains(std::string(name))) {
    ++result_.left_out[std::string(name)];
    return;
  }
  if (name == "filter") {
    ++result_.filters;
    return;
  }
  const std::string what = name == "text"   ? "convert the text to paths, or "
                           : name == "fill" ? "--fill outline or --fill hatch draws it, "
                                            : "";
  fail(node, "<" + printable(local_name(node)) + "> has " + std::string(name) + ", which can not be drawn as strokes; " +
                 what + "--skip " + std::string(name) + " leaves it out");
}

/// Finds ids and style sheets.
void SvgReader::survey(const pugi::xml_node& root) {
  // Without recursion: the file may be nested as deep as it likes.
  for (pugi::xml_node node = root; node;) {
    if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
    if (local_name(node) == "style") {
      std::string css;
      for (const pugi::xml_node& part : node) css += part.value();
      const std::string_view type = node.attribute("type").value();
      try {
        if (type.empty() || type == "text/css") sheet_.add(css);
      } catch (const UnknownStyle&) {
        refuse("style", node);
      } catch (const std::invalid_argument& e) {
        fail(node, e.what());
      }
    }
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && node != root && !node.next_sibling()) node = node.parent();
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

/// Size of the page and where its units lie on it. Of a page that tells one side the viewBox tells the other. A file that
/// tells none has that which vpype gives it.
Context SvgReader::place_page(const pugi::xml_node& root) {
  const std::vector<double> box = numbers(root.attribute("viewBox").value());
  const auto told = [&](const char* name) {
    const std::string_view value = root.attribute(name).value();
    return !value.empty() && !value.ends_with('%') && value != "auto";
  };
  const auto side = [&](const char* name, std::size_t of_box, const char* other, std::size_t of_other) {
    if (told(name)) return length(root, name);
    if (!root.attribute("viewBox")) {
      result_.size_assumed = true;
      return kAssumedPx;
    }
    if (box.size() != 4) return 0.0;
    return told(other) && box[of_other] > 0 ? length(root, other) * box[of_box] / box[of_other] : box[of_box];
  };
  Context context;
  const double width = side("width", 2, "height", 3), height = side("height", 3, "width", 2);
  const Matrix inside = view_box_to(root, width, height, context.port);
  Page& page = result_.page;
  page = {width * kMmPerPx, height * kMmPerPx, 0};
  if (!(page.width_mm > 0 && page.height_mm > 0 && page.width_mm <= kLargestPageMm && page.height_mm <= kLargestPageMm)) {
    throw std::invalid_argument("the page is empty or larger than 100 m");
  }
  context.to_mm = Matrix{kMmPerPx, 0, 0, kMmPerPx, 0, 0} * inside;
  return context;
}

ReadDrawing SvgReader::read() {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(
      text_.data(), text_.size(), pugi::parse_default | pugi::parse_doctype | pugi::parse_ws_pcdata_single);
  if (parsed.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!parsed) {
    const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(parsed.offset, 0, static_cast<std::ptrdiff_t>(text_.size()));
    throw InputError(file_ + ":" + std::to_string(1 + std::count(text_.begin(), end, '\n')),
                     std::string("is not XML: ") + parsed.description());
  }
  pugi::xml_node root;
  for (const pugi::xml_node& node : document) {
    if (node.type() == pugi::node_doctype)
      entities_ = std::string_view(node.value()).find("<!ENTITY") != std::string_view::npos;
    if (node.type() == pugi::node_element) root = node;
  }
  if (local_name(root) != "svg") throw InputError(file_, "is not an SVG");
  survey(root);
  try {
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
      if (part.layer.lines.size() > 0) result_.drawing.layers.push_back(std::move(part.layer));
    }
  }
  return std::move(result_);
}

/// The lines of one look in a layer. `width_mm` 0: that of the pen.
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
      // A name of a colour that is not known is drawn in black.
    }
    if (width_mm > 0) layer.width_mm = width_mm;
  }
  return parts[part->second];
}

/// Takes over the style, the transform and the clip path of an element. False when it does not show.
bool SvgReader::enter(const pugi::xml_node& node, Context& context) {
  bool displayed = true;
  context.style = styled(node, context.style, displayed);
  if (!displayed) return false;
  context.opacity *= context.style.opacity;
  if (const pugi::xml_attribute placing = node.attribute("transform"))
    context.to_mm = context.to_mm * transform(placing.value());
  if (!context.style.clip.empty()) context.clip = clip_of(context.style.clip, node, context);
  if (!context.style.mask.empty()) context.clip = mask_of(context.style.mask, node, context);
  return true;
}

void SvgReader::walk_children(const pugi::xml_node& node, const Context& context) {
  if (context.depth > kDeepest) fail(node, "is nested deeper than " + std::to_string(kDeepest) + " elements");
  Context inside = context;
  ++inside.depth;
  for (const pugi::xml_node& child : node) {
    if (child.type() == pugi::node_element) walk(child, inside);
  }
}

void SvgReader::walk(const pugi::xml_node& node, const Context& around) {
  if (around.links > 0 && ++linked_ > kMostLinked) fail(node, "<use> shows more than a million elements");
  const std::string_view full = node.name(), name = local_name(node);
  // Elements of editors and metadata have prefixes of their own.
  if (full != name && !full.starts_with("svg:")) return;
  for (const std::string_view unseen : {"defs", "title", "desc", "metadata", "script", "style", "linearGradient",
                                        "radialGradient", "pattern", "clipPath", "mask", "filter", "marker", "symbol"}) {
    if (name == unseen) return;
  }
  for (const std::string_view known : {"image", "foreignObject"}) {
    if (name == known) return refuse(known, node);
  }
  if (name == "animate" || name == "animateTransform" || name == "animateMotion" || name == "set")
    return refuse("animation", node);
  try {
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
    if (name == "text") return context.style.visible ? draw_text(node, context) : void();
    // No viewer shows what SVG does not know, nor what is in it: notes of editors and of plotters' software.
    if (!draw_shape(name, node, context)) ++result_.unknown["<" + printable(name) + ">"];
  } catch (const std::invalid_argument& e) {
    fail(node, "<" + printable(name) + "> " + e.what());
  }
}

/// The first of the alternatives that is meant for everybody and can be drawn.
void SvgReader::walk_switch(const pugi::xml_node& node, const Context& context) {
  Context inside = context;
  ++inside.depth;
  if (inside.depth > kDeepest) fail(node, "is nested deeper than " + std::to_string(kDeepest) + " elements");
  for (const pugi::xml_node& child : node) {
    if (child.type() != pugi::node_element || local_name(child) == "foreignObject") continue;
    if (child.attribute("requiredExtensions") || child.attribute("requiredFormats")) continue;
    const std::string_view language = child.attribute("systemLanguage").value();
    if (!language.empty() && !language.starts_with("en")) continue;
    return walk(child, inside);
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

/// A nested svg, or a symbol whose size its <use> gives.
void SvgReader::walk_viewport(const pugi::xml_node& node, Context context, const pugi::xml_node& size) {
  if (local_name(node) == "svg") {
    context.to_mm = context.to_mm *
                    Matrix{1, 0, 0, 1, length(node, "x", 0, context.port.width), length(node, "y", 0, context.port.height)};
  }
  const auto side = [&](const char* name, double whole) {
    const double own = local_name(node) == "svg" ? length(node, name, whole, whole) : whole;
    return length(size, name, own, whole);
  };
  const double width = side("width", context.port.width), height = side("height", context.port.height);
  if (!(width > 0 && height > 0)) return;
  const Matrix inside = view_box_to(node, width, height, context.port);
  // SVG 2, 5.5: the point that lies where the <use> stands; where none is told, it is the corner of the frame.
  const auto shift = [&](const char* name) { return node.attribute(name) && local_name(node) == "symbol"; };
  const Point2 reference =
      inside({length(node, "refX", 0, context.port.width), length(node, "refY", 0, context.port.height)});
  context.to_mm = context.to_mm * Matrix{1, 0, 0, 1, shift("refX") ? -reference.x : 0, shift("refY") ? -reference.y : 0};
  if (!context.style.overflow) context.clip = frame_clip(width, height, context);
  context.to_mm = context.to_mm * inside;
  walk_children(node, context);
}

/// What a <use> shows; nothing when there is none of that id, as viewers do.
pugi::xml_node SvgReader::target_of(const pugi::xml_node& use) const {
  std::string_view target = use.attribute("href").value();
  if (target.empty()) target = use.attribute("xlink:href").value();
  if (!target.starts_with('#')) fail(use, "<use> leads out of the file");
  const auto found = ids_.find(std::string(target.substr(1)));
  return found == ids_.end() ? pugi::xml_node() : found->second;
}

void SvgReader::follow_use(const pugi::xml_node& node, const Context& context) {
  if (context.links >= kMostLinks) fail(node, "<use> leads on more than " + std::to_string(kMostLinks) + " times");
  const pugi::xml_node target = target_of(node);
  if (!target) return;
  if (context.depth > kDeepest) fail(node, "is nested deeper than " + std::to_string(kDeepest) + " elements");
  Context inside = context;
  inside.to_mm = context.to_mm *
                 Matrix{1, 0, 0, 1, length(node, "x", 0, context.port.width), length(node, "y", 0, context.port.height)};
  ++inside.depth;
  ++inside.links;
  const std::string_view name = local_name(target);
  if (name != "symbol" && name != "svg") return walk(target, inside);
  if (++linked_ > kMostLinked) fail(node, "<use> shows more than a million elements");
  if (enter(target, inside)) walk_viewport(target, inside, node);
}

}  // namespace svg

ReadDrawing read_svg_drawing(std::string_view text, const std::string& file, const std::set<std::string>& skip,
                             const FillReading& fills) {
  return svg::SvgReader(text, file, skip, fills).read();
}

}  // namespace ligne
