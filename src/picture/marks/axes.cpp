#include "picture/marks/axes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/marks/contour_labels.hpp"
#include "view/axes/axes_box.hpp"
#include "view/tolerances.hpp"

namespace ligne {
namespace {

constexpr const char* kDefaultNames[] = {"x", "y", "z"};

/// Height of capitals of numbers and names on a sheet whose shorter side is that of A4 (ISO 3098: 2.5 mm). Larger
/// sheets are read from farther away, but not in proportion. With the square root of the side it is 1.8 mm on A6 and 5
/// mm on A0, which ISO 3098 has too.
constexpr double kTextHeightMm = 2.5, kSideOfA4Mm = 210;
/// Largest height of texts, and their largest default height, as parts of the shorter side inside the margins.
constexpr double kHighestPart = 0.1, kHighestDefaultPart = 0.05;
constexpr double kTitleHeight = 1.4;   ///< relative to the other texts
constexpr double kLabelHeight = 0.75;  ///< heights in contour lines, relative to the other texts

/// Distance of labels along a contour line; on small sheets, as part of the shorter side.
constexpr double kLabelDistanceMm = 120, kLabelDistancePart = 0.6;

/// The insets is found by trials: with less insets for the picture there may be fewer or shorter numbers.
constexpr double kInsetAccuracyMm = 1e-3;  ///< the accuracy of the drawing
constexpr int kFreeTrials = 3, kMostTrials = 8;

/// The insets needed beyond the picture on each side.
Insets overhang(const Rect& picture, const Rect& all) {
  return {picture.min.x - all.min.x, picture.min.y - all.min.y, all.max.x - picture.max.x, all.max.y - picture.max.y};
}

bool holds(const Insets& insets, const Insets& need) {
  return need.left <= insets.left + kInsetAccuracyMm && need.top <= insets.top + kInsetAccuracyMm &&
         need.right <= insets.right + kInsetAccuracyMm && need.bottom <= insets.bottom + kInsetAccuracyMm;
}

Insets widest(const Insets& a, const Insets& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

std::optional<AxesRequest> request_of(const AxesChoice& choice, const std::optional<PlotBox>& plot) {
  if (!choice.style || !plot) return std::nullopt;
  const AxesBox& box = plot->box;
  if (!std::isfinite((box.high.z - box.low.z) * plot->factor.z)) return std::nullopt;
  AxesRequest request;
  request.style = *choice.style;
  for (int k = 0; k < 3; ++k) {
    request.axes[k].name = choice.names[k].value_or(kDefaultNames[k]);
    request.axes[k].from = box.low[k];
    request.axes[k].to = box.high[k];
    request.axes[k].factor = plot->factor[k];
    request.axes[k].origin = plot->origin[k];
    request.axes[k].scale = plot->scales[k];
    request.axes[k].categories = choice.categories[k];
  }
  return request;
}

/// Ratio of width to height of the sample of an area's colour.
constexpr double kSwatch = 5;

void add_swatch(Drawing& drawing, const std::array<double, 3>& color, const std::array<Point2, 2>& sample) {
  const double half = (sample[1].x - sample[0].x) / kSwatch / 2;
  const std::vector<Point2> corners{{sample[0].x, sample[0].y - half},
                                    {sample[1].x, sample[1].y - half},
                                    {sample[1].x, sample[1].y + half},
                                    {sample[0].x, sample[0].y + half}};
  drawing.fills.push_back({{corners}, color});
  drawing.layers.push_back({"legend", {}});
  std::vector<Point2> outline = corners;
  outline.push_back(corners.front());
  drawing.layers.back().lines.add(outline);
}

/// Puts the sample of a legend's entry into the layer of the lines that it explains, so that one pen draws both.
void add_sample(Drawing& drawing, const LegendEntry& entry, const std::array<Point2, 2>& sample) {
  if (entry.filled && entry.color) return add_swatch(drawing, *entry.color, sample);
  for (Layer& layer : drawing.layers) {
    if (layer.name != entry.layer || layer.object != entry.object || layer.color != entry.color) continue;
    layer.lines.add(sample);
    return;
  }
  Layer& layer = drawing.layers.emplace_back();
  layer.name = "legend";
  layer.object = entry.object;
  layer.color = entry.color;
  layer.lines.add(sample);
}

}  // namespace

double text_height_mm(const AxesChoice& choice, const Page& page) {
  const double side = std::min(page.drawable().width(), page.drawable().height());
  if (!choice.text_height_mm) {
    return std::min(kTextHeightMm * std::sqrt(std::min(page.width_mm, page.height_mm) / kSideOfA4Mm),
                    kHighestDefaultPart * side);
  }
  if (*choice.text_height_mm > kHighestPart * side) {
    throw RequestError("text-height", shortest(*choice.text_height_mm) + " mm is more than a tenth of the " +
                                          shortest(side) + " mm that the margins leave of the page");
  }
  return *choice.text_height_mm;
}

PictureMarks place_with_axes(const std::optional<PlotBox>& box, CameraPicture picture, const PageRequest& page,
                             const AxesChoice& choice, const std::string& heading) {
  std::optional<AxesRequest> request = request_of(choice, box);
  if (request && !page.extent) picture.extent = projected_extent(box_scene(request->box()), picture.camera);
  const MeasureText measure = [&](std::string_view text, double height) { return text_extent(text, height, choice.text); };

  PictureMarks result;
  Insets insets;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    result = {place(picture, page, insets), {}, {}, {}};
    const Placement& placement = result.placement;
    if (placement.picture.empty()) return result;
    const double height = text_height_mm(choice, placement.page);
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
    if (choice.scale_bar || choice.north_arrow || !choice.legend.empty()) {
      const MapGround ground = box ? MapGround{box->factor, box->unit} : MapGround{};
      result.map = lay_out_map_marks(choice, ground, placement.view, all, height, measure);
      result.texts.insert(result.texts.end(), result.map.texts.begin(), result.map.texts.end());
      if (!result.map.extent.empty()) {
        all.extend(result.map.extent.min);
        all.extend(result.map.extent.max);
      }
    }
    if (!heading.empty()) {
      const TextItem item = title_above(all, heading, kTitleHeight * height, placement.page.drawable().width(), measure);
      for (const Point2 p : text_box(item, measure(item.text, item.height_mm)).corners()) all.extend(p);
      result.texts.push_back(item);
    }
    const Insets need = overhang(placement.picture, all);
    if (holds(insets, need)) break;
    insets = trial < kFreeTrials ? need : widest(insets, need);
  }
  return result;
}

std::vector<std::array<Point3, 2>> back_lines(const PictureMarks& surroundings) {
  std::vector<std::array<Point3, 2>> lines;
  for (const AxisLine& line : surroundings.axes.lines) lines.push_back({line.a, line.b});
  return lines;
}

std::vector<std::array<Point3, 2>> all_lines(const PictureMarks& surroundings) {
  std::vector<std::array<Point3, 2>> lines = back_lines(surroundings);
  for (const AxisLine& line : surroundings.axes.front_lines) lines.push_back({line.a, line.b});
  return lines;
}

Polylines lines_of_axes(const PictureMarks& surroundings, std::span<const std::vector<VisibleInterval>> seen) {
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

void add_labels(Drawing& drawing, const PictureRequest& request, const PictureMarks& surroundings) {
  if (request.contour_labels == ContourLabels::none) return;
  const Page& page = surroundings.placement.page;
  ContourLabelOptions options;
  options.height_mm = kLabelHeight * text_height_mm(request.axes, page);
  options.style = request.axes.text;
  options.index_only = request.contour_labels == ContourLabels::index;
  options.decades = request.label_decades;
  options.distance_mm = std::min(kLabelDistanceMm, kLabelDistancePart * std::min(page.width_mm, page.height_mm));
  options.page = page.sheet();
  for (TextItem& label : label_contours(drawing, options, surroundings.texts)) drawing.texts.push_back(std::move(label));
}

void add_surroundings(Drawing& drawing, const PictureMarks& surroundings, const AxesChoice& choice, RunReport& run) {
  const std::string name(kLineClassNames[static_cast<std::size_t>(LineClass::axes)]);
  Layer layer{name, {}};
  const auto found = std::ranges::find_if(drawing.layers, [&](const Layer& l) { return l.name == name; });
  if (found != drawing.layers.end()) {
    layer = std::move(*found);
    drawing.layers.erase(found);
  }
  for (const auto& mark : surroundings.axes.marks) layer.lines.add(mark);
  for (const auto& line : surroundings.map.lines) layer.lines.add(line);
  for (std::size_t i = 0; i < surroundings.map.samples.size(); ++i) {
    add_sample(drawing, choice.legend[i], surroundings.map.samples[i]);
  }
  if (layer.lines.size() > 0) drawing.layers.push_back(std::move(layer));
  drawing.texts.insert(drawing.texts.end(), surroundings.texts.begin(), surroundings.texts.end());
  if (choice.text != TextStyle::stroke) return;
  const std::size_t unknown = draw_texts_as_strokes(drawing);
  if (unknown > 0) run.warn(std::to_string(unknown) + " characters are not in the font: drawn as boxes");
}

}  // namespace ligne
