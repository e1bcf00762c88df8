#include "picture/marks/point_marks.hpp"

#include <utility>

#include "geometry/search/nearest_points.hpp"
#include "picture/marks/box_grid.hpp"
#include "picture/marks/contour_labels.hpp"
#include "picture/marks/halos.hpp"
#include "plotting/stroke_text.hpp"

namespace ligne {
namespace {

constexpr double kBeforeMm = 0.2, kTestSegmentMm = 0.02;  ///< distance of a probe before its point; length of a probe
// In heights of capitals.
constexpr double kMarkPart = 0.45, kBesidePart = 0.4;
constexpr double kCellHeights = 2;  ///< side of the cells that list the boxes of texts

/// Places of a label in order of preference: right, left, above, below, and between these.
struct LabelPlace {
  double x, y;
  TextAcross across;
  TextUp up;
};
constexpr LabelPlace kLabelPlaces[] = {{1, -1, TextAcross::left, TextUp::base},   {-1, -1, TextAcross::right, TextUp::base},
                                       {1, 0, TextAcross::left, TextUp::middle},  {-1, 0, TextAcross::right, TextUp::middle},
                                       {1, 1, TextAcross::left, TextUp::top},     {-1, 1, TextAcross::right, TextUp::top},
                                       {0, -1, TextAcross::center, TextUp::base}, {0, 1, TextAcross::center, TextUp::top}};

/// Boxes of texts that do not overlap each other.
class TakenPlaces {
 public:
  explicit TakenPlaces(double cell_mm) : grid_(cell_mm) {}

  void add(const TextBox& box) {
    grid_.add(bounds_of(box), static_cast<std::uint32_t>(boxes_.size()));
    boxes_.push_back(box);
  }
  bool is_taken(const TextBox& box) const {
    return grid_.any_near(bounds_of(box), [&](std::uint32_t i) { return overlap(boxes_[i], box); });
  }

 private:
  static Rect bounds_of(const TextBox& box) {
    Rect rect;
    for (const Point2 p : box.corners()) rect.extend(p);
    return rect;
  }

  BoxGrid grid_;
  std::vector<TextBox> boxes_;
};

}  // namespace

std::vector<std::array<Point3, 2>> probes_of(const std::vector<MarkedPoint>& points, const View& view) {
  std::vector<std::array<Point3, 2>> probes;
  for (const MarkedPoint& point : points) {
    const Camera& camera = view.camera;
    const Point3 sight = camera.perspective ? (point.at - camera.eye) / camera.target_distance : camera.forward;
    const Point3 p = point.at - sight * (kBeforeMm / view.scale);
    probes.push_back({p, p + camera.right * (kTestSegmentMm / view.scale)});
  }
  return probes;
}

std::vector<std::uint8_t> read_probes(StrokeModel& model, std::uint32_t first, std::size_t count) {
  std::vector<std::uint8_t> seen(count);
  std::erase_if(model.strokes, [&](const Stroke& stroke) {
    if (stroke.source < first || stroke.source - first >= count) return false;
    if (stroke.visible) seen[stroke.source - first] = 1;
    return true;
  });
  return seen;
}

std::string unseen_points(const std::vector<MarkedPoint>& points, const std::vector<std::uint8_t>& seen, const View& view) {
  std::size_t hidden = 0, outside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (seen[i]) continue;
    const Point2 p = page_point(view, points[i].at);
    const Rect& area = view.window;
    const bool is_inside = p.x >= area.min.x && p.x <= area.max.x && p.y >= area.min.y && p.y <= area.max.y;
    ++(is_inside ? hidden : outside);
  }
  if (hidden + outside == 0) return {};
  std::string text = std::to_string(hidden + outside) + " of " + std::to_string(points.size()) + " points are not marked: ";
  if (outside > 0) text += std::to_string(outside) + " outside the page";
  if (hidden > 0) text += (outside > 0 ? ", " : "") + std::to_string(hidden) + " hidden";
  return text;
}

std::vector<TextItem> mark_points(Drawing& drawing, const std::vector<MarkedPoint>& points,
                                  const std::vector<std::uint8_t>& seen, const View& view, const LabelStyle& labelled,
                                  std::span<const TextItem> taken) {
  const double h = labelled.height_mm;
  const TextStyle style = labelled.text;
  Layer layer{"points", {}};
  std::vector<TextItem> labels;
  std::vector<TextBox> gaps;
  std::vector<Point2> marks;
  const double r = kMarkPart * h;
  TakenPlaces places(kCellHeights * h);
  for (const TextItem& item : taken) places.add(text_box(item, text_extent(item.text, item.height_mm, style)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!seen[i]) continue;
    const Point2 p = page_point(view, points[i].at);
    for (const Point2 d : {Point2{r, r}, Point2{r, -r}}) layer.lines.add(std::array{p - d, p + d});
    marks.push_back(p);
    gaps.push_back({p, {r, r}, 0});
  }
  const NearestPoints tree(marks);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!seen[i] || points[i].label.empty()) continue;
    const Point2 p = page_point(view, points[i].at);
    const TextExtent extent = text_extent(points[i].label, h, style);
    for (const LabelPlace& side : kLabelPlaces) {
      const double away = (kMarkPart + kBesidePart) * h;
      const TextItem item{points[i].label, p + Point2{side.x * away, side.y * away}, h, side.across, side.up, 0};
      TextBox box = text_box(item, extent);
      if (places.is_taken(box) || tree.any_within(box.center, box.half + Point2{r, r})) continue;
      places.add(box);
      box.half += Point2{kBesidePart * h / 2, kBesidePart * h / 2};
      gaps.push_back(box);
      labels.push_back(item);
      break;
    }
  }
  make_gaps(drawing, gaps);
  set_off_from_fills(drawing, labels, style);
  if (layer.lines.size() > 0) drawing.layers.push_back(std::move(layer));
  return labels;
}

}  // namespace ligne
