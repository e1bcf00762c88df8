#include "cli/surface_axes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "cli/text.hpp"
#include "files/message_text.hpp"
#include "view/axes_box.hpp"
#include "visibility/tolerances.hpp"

namespace ligne {
namespace {

constexpr std::string_view kAxesStyleNames[] = {"back", "grid", "box", "base"};
constexpr std::string_view kTextStyleNames[] = {"font", "stroke"};
constexpr const char* kDefaultNames[] = {"x", "y", "z"};

/// Capitals of numbers and names on a sheet whose shorter side is that of A4 (ISO 3098: 2.5 mm). Larger sheets are looked at
/// from farther away, but not in proportion: with the root of the side it is 1.8 mm on A6 and 5 mm on A0, which ISO 3098 has
/// too.
constexpr double kTextHeightMm = 2.5, kSideOfA4Mm = 210;
/// Of the shorter side of what the margins leave: as high as texts may be, and as they are at the most when nothing is said.
constexpr double kHighestPart = 0.1, kHighestDefaultPart = 0.05;
constexpr double kTitleHeight = 1.4;  ///< of the other texts
constexpr double kHighestTextMm = 1000;

/// The room is found by trying: with less room for the picture there may be fewer numbers, and these may be shorter.
constexpr double kSlackMm = 1e-3;  ///< the accuracy of the drawing
constexpr int kFreeTrials = 3, kMostTrials = 8;

AxesStyle style_of(const AxesOptions& options) {
  return options.style == "true" ? AxesStyle::back : static_cast<AxesStyle>(parse_choice(options.style, kAxesStyleNames));
}

/// Throws UsageError.
double text_height_mm(const AxesOptions& options, const Page& page) {
  const double side = std::min(page.drawable().width(), page.drawable().height());
  if (!options.text_height_mm) {
    return std::min(kTextHeightMm * std::sqrt(std::min(page.width_mm, page.height_mm) / kSideOfA4Mm),
                    kHighestDefaultPart * side);
  }
  if (*options.text_height_mm > kHighestPart * side) {
    throw UsageError("--text-height", shortest(*options.text_height_mm) + " mm is more than a tenth of the " +
                                          shortest(side) + " mm that the margins leave of the page");
  }
  return *options.text_height_mm;
}

double parse_text_height(const std::string& text) {
  const double height = parse_length_mm(text);
  if (!(height > 0 && height <= kHighestTextMm))
    throw std::invalid_argument(printable(text) + " is not above 0 and at most 1000 mm");
  return height;
}

/// What reaches over the picture, on each side.
Room overhang(const Rect& picture, const Rect& all) {
  return {picture.min.x - all.min.x, picture.min.y - all.min.y, all.max.x - picture.max.x, all.max.y - picture.max.y};
}

bool holds(const Room& room, const Room& need) {
  return need.left <= room.left + kSlackMm && need.top <= room.top + kSlackMm && need.right <= room.right + kSlackMm &&
         need.bottom <= room.bottom + kSlackMm;
}

Room widest(const Room& a, const Room& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

std::optional<AxesRequest> request_of(const AxesOptions& options, const std::optional<PlotBox>& plot) {
  if (options.style.empty() || !plot) return std::nullopt;
  const auto& [box, z_scale] = *plot;
  if (!std::isfinite((box.high.z - box.low.z) * z_scale)) return std::nullopt;
  AxesRequest request;
  request.style = style_of(options);
  for (int k = 0; k < 3; ++k) {
    request.axes[k].name = options.names[k].value_or(kDefaultNames[k]);
    request.axes[k].from = box.low[k];
    request.axes[k].to = box.high[k];
  }
  request.axes[2].factor = z_scale;
  return request;
}

}  // namespace

void add_axes_options(CLI::App& app, AxesOptions& options) {
  const std::string group = "Axes";
  app.add_flag("--axes", options.style,
               "axes with ticks and numbers, and the edges of their box behind the surface; --axes=grid: with lines at the "
               "ticks, --axes=box: all edges, --axes=base: those of the ground only")
      ->group(group);
  const auto as_written = [](const std::string& text) { return text; };
  for (int k = 0; k < 3; ++k) {
    const std::string axis = kDefaultNames[k];
    add_parsed(app, "--" + axis + "-label", "TEXT", options.names[k], as_written,
               "name of the " + axis + " axis; empty for none")
        ->default_str(axis)
        ->group(group);
  }
  add_parsed(
      app, "--text", "font|stroke", options.text,
      [](const std::string& t) { return static_cast<TextStyle>(parse_choice(t, kTextStyleNames)); },
      "text in a typeface, or as single strokes for a pen")
      ->default_str("font")
      ->group(group);
  add_parsed(app, "--text-height", "LEN", options.text_height_mm, parse_text_height, "height of capitals")
      ->default_str("2.5mm on A4")
      ->group(group);
}

void check(const AxesOptions& options) {
  if (options.style.empty()) {
    for (int k = 0; k < 3; ++k) {
      if (options.names[k]) throw UsageError("--" + std::string(kDefaultNames[k]) + "-label", "goes with --axes");
    }
    return;
  }
  try {
    style_of(options);
  } catch (const std::invalid_argument& e) {
    throw UsageError("--axes", e.what());
  }
}

Surroundings place_with_axes(const std::optional<PlotBox>& box, const Scene& scene, const Camera& camera,
                             const PageOptions& page, const AxesOptions& options, const std::string& title) {
  std::optional<AxesRequest> request = request_of(options, box);
  const Scene extent = request ? box_scene(request->box()) : scene;
  const MeasureText measure = [&](std::string_view text, double height) { return text_extent(text, height, options.text); };

  Surroundings result;
  Room room;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    result = {place(extent, camera, page, room), {}, {}};
    const Placement& placement = result.placement;
    if (placement.picture.empty()) return result;
    const double height = text_height_mm(options, placement.page);
    if (request) {
      request->text_height_mm = height;
      result.axes = lay_out_axes(*request, placement.view, measure);
      result.texts = result.axes.texts;
    }
    Rect all = placement.picture;
    if (!result.axes.extent.empty()) {
      all.extend(result.axes.extent.min);
      all.extend(result.axes.extent.max);
    }
    if (!title.empty()) {
      const TextItem item = title_above(all, title, kTitleHeight * height, placement.page.drawable().width(), measure);
      const TextExtent extent = measure(item.text, item.height_mm);
      for (const Point2 p : text_box(item, extent).corners()) all.extend(p);
      result.texts.push_back(item);
    }
    const Room need = overhang(placement.picture, all);
    if (holds(room, need)) break;
    room = trial < kFreeTrials ? need : widest(room, need);
  }
  return result;
}

std::vector<std::array<Point3, 2>> back_lines(const Surroundings& surroundings) {
  std::vector<std::array<Point3, 2>> lines;
  for (const AxisLine& line : surroundings.axes.lines) lines.push_back({line.a, line.b});
  return lines;
}

std::vector<std::array<Point3, 2>> all_lines(const Surroundings& surroundings) {
  std::vector<std::array<Point3, 2>> lines = back_lines(surroundings);
  for (const AxisLine& line : surroundings.axes.front_lines) lines.push_back({line.a, line.b});
  return lines;
}

Polylines lines_of_axes(const Surroundings& surroundings, std::span<const std::vector<VisibleInterval>> seen) {
  const AxesPicture& axes = surroundings.axes;
  std::vector<AxisLine> all = axes.lines;
  all.insert(all.end(), axes.front_lines.begin(), axes.front_lines.end());
  const auto visibility = [&](std::span<const AxisLine> given) {
    std::vector<std::vector<VisibleInterval>> visible(seen.begin(), seen.end());
    visible.resize(given.size(), {VisibleInterval{}});
    return visible;
  };
  return axis_lines(all, surroundings.placement.view, visibility, kLeastPartMm);
}

std::size_t add_surroundings(Drawing& drawing, const Surroundings& surroundings, const AxesOptions& options) {
  const std::string name(kLineClassNames[static_cast<std::size_t>(LineClass::axes)]);
  Layer layer{name, {}};
  const auto found =
      std::find_if(drawing.layers.begin(), drawing.layers.end(), [&](const Layer& l) { return l.name == name; });
  if (found != drawing.layers.end()) {
    layer = std::move(*found);
    drawing.layers.erase(found);
  }
  Polylines& lines = layer.lines;
  for (const auto& mark : surroundings.axes.marks) {
    lines.points.insert(lines.points.end(), mark.begin(), mark.end());
    lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
  }
  if (lines.size() > 0) drawing.layers.push_back(std::move(layer));
  drawing.texts = surroundings.texts;
  return options.text == TextStyle::stroke ? draw_texts_as_strokes(drawing) : 0;
}

}  // namespace ligne
