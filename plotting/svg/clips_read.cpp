/// Reads clip paths and masks of an SVG, as areas on the page.

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "areas/work_limit_error.hpp"
#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

/// Most elements visited for bounding boxes in a drawing, and the deepest nesting of such elements.
constexpr std::size_t kMostBoxed = 10'000'000;
constexpr int kDeepestBox = 200;
/// Most points of a stroke in a mask; each becomes a disc. Adjustable.
constexpr std::size_t kMostStroked = 20'000;

/// Cuts the shapes of a clip path, from number `first` on, by a clip path of their own. Inner clip paths may cut them
/// already.
void cut_clip_shapes(const ClipPointer& within, std::size_t first, Clip& clip) {
  if (!within) return;
  clip.within.resize(clip.any_of.size());
  for (std::size_t i = first; i < clip.within.size(); ++i) {
    if (!clip.within[i]) {
      clip.within[i] = within;
      continue;
    }
    // This clip path is the new outer end of the chain. Chains are shared, so it is copied.
    auto both = std::make_shared<Clip>(*clip.within[i]);
    Clip* last = both.get();
    while (last->outer) {
      auto next = std::make_shared<Clip>(*last->outer);
      last->outer = next;
      last = next.get();
    }
    last->outer = within;
    clip.within[i] = both;
  }
}

/// Contours around the ink of a pen of this radius, for the nonzero rule: a rectangle for every segment, and a disc for
/// every point but the ends that have no round caps.
Polylines ink_of(const Polylines& lines, double radius, bool round_caps) {
  constexpr double kCorners = 32;
  Polylines contours;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Point2 p = line[k], q = line[k > 0 ? k - 1 : 0];
      if (p != q) {
        const Point2 to = (p - q) * (radius / glm::length(p - q)), side{-to.y, to.x};
        contours.add(std::array{p + side, p - side, q - side, q + side});
      }
      if (!round_caps && !is_loop(line) && (k == 0 || k + 1 == line.size())) continue;
      std::vector<Point2> disc;
      for (double at = 0; at < kCorners; ++at) disc.push_back(p + turn(-360 * at / kCorners)({radius, 0}));
      contours.add(disc);
    }
  }
  return contours;
}

}  // namespace

/// Extends the box by an element and its children, visible or not, except children with display: none.
void SvgReader::extend_box(const pugi::xml_node& node, const Context& context, const Matrix& to_box, Rect& box) {
  if (++boxed_ > kMostBoxed) throw WorkLimitError("has boxes of more than ten million elements");
  if (context.depth > kDeepestBox) return;
  Polylines lines;
  Outline outline(lines, to_box);
  const std::string_view name = local_name(node);
  if (outline_shape(name, node, attributes(context), outline)) {
    for (const Point2 p : lines.points) box.extend(p);
    return;
  }
  if (name != "g" && name != "a" && name != "use" && name != "switch" && name != "flowRegion") return;
  const auto extend = [&](const pugi::xml_node& child, const Matrix& m) {
    Context inside = context;
    ++inside.depth;
    bool displayed = true;
    inside.style = styled(child, context.style, context.port, displayed);
    // A transparent shape has a box too.
    if (inside.style.displayed) extend_box(child, inside, m * placing_of(child, inside), box);
  };
  if (name != "use") {
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element) extend(child, to_box);
    }
    return;
  }
  const pugi::xml_node target = target_of(node);
  if (target && context.links < kMostLinks) {
    Context inside = context;
    ++inside.links;
    extend(target, to_box * Matrix{1, 0, 0, 1, attributes(context).x(node, "x"), attributes(context).y(node, "y")});
  }
}

/// The box of an element in its own units, as a matrix from the unit square; nothing if it has no shapes. It is measured
/// in the size that the element has on the page, from the corner of the page.
std::optional<Matrix> SvgReader::box_of(const pugi::xml_node& node, const Context& context) {
  const double scale = context.to_mm.stretch();
  const std::optional<Matrix> back = context.to_mm.inverse();
  if (!back) return {};
  const Point2 corner = (*back)({0, 0});
  Rect box;
  extend_box(node, context, Matrix{scale, 0, 0, scale, -scale * corner.x, -scale * corner.y}, box);
  if (box.empty()) return {};
  return Matrix{box.width() / scale, 0, 0, box.height() / scale, box.min.x / scale + corner.x, box.min.y / scale + corner.y};
}

Style SvgReader::style_around(const pugi::xml_node& node, const Viewport& port) {
  const pugi::xml_node parent = node.parent();
  if (const auto known = styles_around_.find(parent.internal_object()); known != styles_around_.end()) return known->second;
  std::vector<pugi::xml_node> parents;
  for (pugi::xml_node at = parent; at && at.type() == pugi::node_element; at = at.parent()) parents.push_back(at);
  Style style;
  bool displayed = true;
  for (auto outer = parents.rbegin(); outer != parents.rend(); ++outer) style = styled(*outer, style, port, displayed);
  styles_around_.emplace(parent.internal_object(), style);
  return style;
}

/// The clip path of an element, inside the clip of the context. An id that the file lacks clips nothing, as in viewers.
ClipPointer SvgReader::clip_of(const std::string& id, const pugi::xml_node& node, const Context& context) {
  const auto found = ids_.find(id);
  if (found == ids_.end() || local_name(found->second) != "clipPath") return context.clip;
  const pugi::xml_node& path = found->second;
  const OpenElement open(open_clips_, path);
  if (!open.is_new()) return context.clip;  // it leads back to itself
  if (open_clips_.size() > kMostLinks) {
    omit("clip paths that lead on", node, "has clip paths that lead on more than " + std::to_string(kMostLinks) + " times");
    return context.clip;
  }
  Context inside = context;
  bool displayed = true;
  inside.style = styled(path, style_around(path, context.port), context.port, displayed);
  // Its transform is in the units around it, even if its shapes are in units of a box.
  Matrix m = context.to_mm * placing_of(path, inside);
  if (std::string_view(path.attribute("clipPathUnits").value()) == "objectBoundingBox") {
    const std::optional<Matrix> box = box_of(node, context);
    if (!box) {
      refuse("clip-path", node);
      return context.clip;
    }
    m = m * *box;
  }
  // A clip path of the clip path lies in the units of the latter, but its box is the box of the element.
  Context around = context;
  around.to_mm = context.to_mm * placing_of(path, inside);
  if (!inside.style.clip.empty()) around.clip = clip_of(inside.style.clip, node, around);
  std::string key = id;
  for (const double v : {m.a, m.b, m.c, m.d, m.e, m.f}) key.append(reinterpret_cast<const char*>(&v), sizeof v);
  if (key == last_clip_ && last_made_->outer == around.clip) return last_made_;
  auto clip = std::make_shared<Clip>();
  clip->outer = around.clip;
  for (const pugi::xml_node& child : path) {
    if (child.type() == pugi::node_element && !add_clip_shape(child, m, inside, *clip, 0)) return context.clip;
  }
  if (!clip->within.empty()) clip->within.resize(clip->any_of.size());
  last_clip_ = std::move(key);
  last_made_ = clip;
  return clip;
}

/// The region of a mask (SVG 1.1, 14.4), inside the clip of the context. A mask that gives no region cuts nothing off.
/// Neither does a region in units of a box without area, as of a straight line.
ClipPointer SvgReader::region_of(const pugi::xml_node& mask, const pugi::xml_node& node, const Context& context) {
  constexpr const char* kSides[] = {"x", "y", "width", "height"};
  if (std::ranges::none_of(kSides, [&](const char* side) { return Attributes::has(mask, side); })) return context.clip;
  Context inside = context;
  constexpr double kBefore = -0.1, kSide = 1.2;
  if (std::string_view(mask.attribute("maskUnits").value()) != "userSpaceOnUse") {
    const std::optional<Matrix> box = box_of(node, context);
    if (!box || box->a == 0 || box->d == 0) return context.clip;
    inside.to_mm = context.to_mm * *box;
    inside.port.width = inside.port.height = 1;
  }
  const Attributes given = attributes(inside);
  const double width = given.x(mask, "width", kSide * inside.port.width),
               height = given.y(mask, "height", kSide * inside.port.height);
  const Point2 at{given.x(mask, "x", kBefore * inside.port.width), given.y(mask, "y", kBefore * inside.port.height)};
  inside.to_mm = inside.to_mm * Matrix{1, 0, 0, 1, at.x, at.y};
  return frame_clip(std::max(width, 0.0), std::max(height, 0.0), inside);
}

/// A mask of shapes: light shapes show what lies under them, dark ones hide it, and the last one painted decides.
ClipPointer SvgReader::mask_of(const std::string& id, const pugi::xml_node& node, const Context& context) {
  const auto found = ids_.find(id);
  if (found == ids_.end() || local_name(found->second) != "mask") return context.clip;
  const pugi::xml_node& mask = found->second;
  const OpenElement open(open_clips_, mask);
  if (!open.is_new() || open_clips_.size() > kMostLinks) {
    omit("self-referring masks", node, "has masks that refer to other masks or to themselves");
    return context.clip;
  }
  Context inside = context;
  bool displayed = true;
  inside.style = styled(mask, style_around(mask, context.port), context.port, displayed);
  Context around = context;
  if (!inside.style.clip.empty()) around.clip = clip_of(inside.style.clip, node, around);
  if (!inside.style.mask.empty()) around.clip = mask_of(inside.style.mask, node, around);
  auto clip = std::make_shared<Clip>();
  clip->outer = region_of(mask, node, around);
  if (std::string_view(mask.attribute("maskContentUnits").value()) == "objectBoundingBox") {
    const std::optional<Matrix> box = box_of(node, context);
    if (!box) {
      refuse("mask", node);
      return context.clip;
    }
    inside.to_mm = context.to_mm * *box;
  }
  for (const pugi::xml_node& child : mask) {
    if (child.type() == pugi::node_element && !add_clip_shape(child, inside.to_mm, inside, *clip, 0, true))
      return context.clip;
  }
  return clip;
}

/// Whether a filter makes an element white: the masks of opacity that Cairo writes.
bool SvgReader::is_whitened(const pugi::xml_node& node) const {
  const std::string_view filter = node.attribute("filter").value();
  const auto found = filter.starts_with("url(#") ? ids_.find(std::string(filter.substr(5, filter.size() - 6))) : ids_.end();
  return found != ids_.end() && std::string_view(found->second.child("feColorMatrix").attribute("values").value())
                                    .starts_with("0 0 0 0 1 0 0 0 0 1 0");
}

/// Adds the fill of a shape of a clip path, or fills and strokes of an element of a mask. False if it can not be drawn as
/// an area: it has been refused.
bool SvgReader::add_clip_shape(const pugi::xml_node& node, Matrix to_mm, const Context& context, Clip& clip, int links,
                               bool is_mask) {
  if (links > 0 && ++linked_ > kMostLinked) throw WorkLimitError("has masks of more than a million elements");
  const std::string_view name = local_name(node);
  bool displayed = true;
  const Style style = styled(node, context.style, context.port, displayed);
  // A clip path is an outline: its opacity has no effect (CSS Masking 1, 6.1).
  if (!(is_mask ? displayed : style.displayed) || !style.visible) return true;
  if (links > kMostLinks || name == "text" || (is_mask && (name == "image" || name == "svg" || name == "switch"))) {
    refuse(is_mask ? "mask" : "clip-path", node);
    return false;
  }
  Context inside = context;
  inside.style = style;
  inside.style.alpha_mask |= is_mask && is_whitened(node);
  inside.to_mm = to_mm = to_mm * placing_of(node, inside);
  ClipPointer within;
  if (!style.clip.empty()) {
    inside.clip = nullptr;
    within = clip_of(style.clip, node, inside);
  }
  const std::size_t first = clip.any_of.size();
  const auto add_inside = [&](const pugi::xml_node& child, Point2 shift) {
    return add_clip_shape(child, to_mm * Matrix{1, 0, 0, 1, shift.x, shift.y}, inside, clip, links + 1, is_mask);
  };
  if (name == "use") {
    const pugi::xml_node target = target_of(node);
    if (target && !add_inside(target, {attributes(context).x(node, "x"), attributes(context).y(node, "y")})) return false;
  } else if (is_mask && (name == "g" || name == "a")) {
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element && !add_inside(child, {0, 0})) return false;
    }
  }
  Polylines lines;
  Outline outline(lines, to_mm);
  // Groups and other elements may not stand in a clip path (CSS Masking 1, 6.1): viewers leave them out too.
  if (outline_shape(name, node, attributes(context), outline) && !add_clip_areas(node, lines, inside, clip, is_mask))
    return false;
  cut_clip_shapes(within, first, clip);
  return true;
}

/// Adds the fill of a shape, and its fill and its stroke in a mask, where they are painted in one colour.
bool SvgReader::add_clip_areas(const pugi::xml_node& node, const Polylines& lines, const Context& context, Clip& clip,
                               bool is_mask) {
  const Style& style = context.style;
  const auto add = [&](const Polylines& contours, FillRule rule, const std::optional<Paint>& paint) {
    clip_points_ += contours.points.size() + 1;
    if (clip_points_ > kMostPoints) throw WorkLimitError("has clip paths of more than fifty million points");
    clip.any_of.emplace_back(contours, rule, clip_work_);
    constexpr double kHalf = 0.5;
    if (is_mask) clip.opens.push_back(style.alpha_mask || brightness(paint->color) > kHalf);
  };
  if (!is_mask) return add(lines, style.clip_even_odd ? FillRule::even_odd : FillRule::nonzero, {}), true;
  const bool filled = style.fill && style.fill_seen, stroked = style.stroke && style.stroke_seen && style.stroke_width > 0;
  const bool stroke_refused = stroked && (is_server(style.stroke->server) || lines.points.size() > kMostStroked);
  if (stroke_refused || (filled && is_server(style.fill->server))) {
    refuse("mask", node);
    return false;
  }
  if (filled) add(lines, fill_rule(context), style.fill);
  if (stroked) add(ink_of(lines, stroke_width_mm(context) / 2, style.round_caps), FillRule::nonzero, style.stroke);
  return true;
}

}  // namespace ligne::svg
