#include "picture/marks/scan_plane_inset.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "files/message_text.hpp"
#include "visibility/method.hpp"

namespace ligne {
namespace {

// Taste: parts of the height below the picture, widths of lines in mm, colours.
constexpr double kInsetPart = 0.52, kPlanePart = 0.6;
constexpr double kThin = 0.13, kSegment = 0.25, kSeen = 0.7;
constexpr double kRowMm = 4.2;            ///< largest height of a row of steps
constexpr double kNumberedInTexts = 1.2;  ///< shortest bar or segment with a number, in heights of texts
constexpr std::array<double, 3> kGray{0.72, 0.72, 0.72}, kLineColor{0.25, 0.25, 0.25}, kRed{0.8, 0.1, 0.1},
    kBlue{0.1, 0.3, 0.65}, kTint{0.82, 0.89, 0.97}, kBoxes{0.85, 0.55, 0.2};
constexpr std::array<const char*, 4> kStepNames{
    "merge: the visible list after every segment, from above", "stack: the current segment, and below it the stack",
    "box: parts of the line, divided from above", "point: the cells of the line"};

class PlaneDrawer {
 public:
  PlaneDrawer(Drawing& drawing, const ScanPlane& plane, const Rect& picture, const Rect& area, double text_mm)
      : drawing_(drawing), plane_(plane), picture_(picture), area_(area), text_mm_(text_mm) {
    for (const ScanPlane::Segment& s : plane.segments) {
      extent_.extend({s.x0, s.z0});
      extent_.extend({s.x1, s.z1});
    }
    const double gap = 2 * text_mm_;
    bottom_ = area.min.y + kPlanePart * area.height();
    const double height = bottom_ - area.min.y - 2 * gap, depth = extent_.height();
    scale_ = depth > 0 ? std::min(1.0, height / depth) : 1;
    base_ = bottom_ - gap - std::max(0.0, (height - depth * scale_) / 2);
  }

  void draw() {
    draw_view_direction();
    draw_boxes();
    draw_plane();
    draw_steps();
    draw_scan_line();
  }

 private:
  Point2 at(double x, double z) const { return {x, base_ - (z - extent_.min.y) * scale_}; }
  Point2 at(const ScanPlane::Segment& s, double x) const {
    const double t = s.x1 > s.x0 ? (x - s.x0) / (s.x1 - s.x0) : 0;
    return at(x, s.z0 + t * (s.z1 - s.z0));
  }

  void line(std::initializer_list<Point2> points, double width, const std::array<double, 3>& color) {
    auto& layers = drawing_.layers;
    const auto same = [&](const Layer& l) { return l.name == "debug" && l.width_mm == width && l.color == color; };
    auto layer = std::ranges::find_if(layers, same);
    if (layer == layers.end()) layer = layers.insert(layer, Layer{"debug", {}, {}, 0, {}, color, width});
    layer->lines.add(std::vector<Point2>(points));
  }
  void text(std::string words, Point2 at, TextAcross across = TextAcross::left, TextUp up = TextUp::middle) {
    TextItem item{std::move(words), at, text_mm_, across, up};
    item.halo_mm = text_mm_ / 4;
    drawing_.texts.push_back(std::move(item));
  }

  /// Draws the ends of each run: from the picture down to the visible surface.
  void draw_view_direction() {
    for (const ScanPlane::Run& run : plane_.runs) {
      const ScanPlane::Segment& s = plane_.segments[run.segment];
      for (const double x : {run.x0, run.x1}) {
        line({{x, plane_.y_mm}, {x, at(s, x).y}}, kThin, kGray);
        line({at(s, x), {x, bottom_}}, kThin, kGray);
      }
    }
  }

  /// Draws a box around the segments of every part of the line that was divided.
  void draw_boxes() {
    for (const ScanPlane::Run& bar : plane_.bars) {
      if (bar.segment != kNone) continue;
      Rect box;
      for (const ScanPlane::Segment& s : plane_.segments) {
        const double x0 = std::max(s.x0, bar.x0), x1 = std::min(s.x1, bar.x1);
        if (!(x0 < x1)) continue;
        box.extend(at(s, x0));
        box.extend(at(s, x1));
      }
      line({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}, box.min}, kThin, kBoxes);
    }
  }

  void draw_plane() {
    for (std::size_t i = 0; i < plane_.segments.size(); ++i) {
      const ScanPlane::Segment& s = plane_.segments[i];
      line({at(s.x0, s.z0), at(s.x1, s.z1)}, kSegment, kLineColor);
      if (plane_.segments.size() <= most_numbers()) write_number(i, s.x0, s.x1);
    }
    for (const ScanPlane::Run& run : plane_.runs) {
      const ScanPlane::Segment& s = plane_.segments[run.segment];
      line({at(s, run.x0), at(s, run.x1)}, kSeen, kBlue);
      if (plane_.segments.size() > most_numbers()) write_number(run.segment, run.x0, run.x1);
    }
    line({{extent_.min.x, bottom_}, {extent_.max.x, bottom_}}, kThin, kLineColor);
    text("x", {extent_.max.x + text_mm_, bottom_});
    const Point2 foot{extent_.min.x - text_mm_, bottom_}, top{foot.x, area_.min.y + text_mm_};
    line({foot, top}, kThin, kLineColor);
    line({top + Point2{-text_mm_ / 3, text_mm_}, top, top + Point2{text_mm_ / 3, text_mm_}}, kThin, kLineColor);
    text("z", top - Point2{text_mm_, 0}, TextAcross::right);
  }

  double numbered_mm() const { return kNumberedInTexts * text_mm_; }

  void write_number(std::size_t segment, double x0, double x1) {
    if (x1 - x0 < numbered_mm()) return;
    text(std::to_string(segment + 1), at(plane_.segments[segment], (x0 + x1) / 2), TextAcross::center);
  }

  /// Largest number of segments with room for their numbers.
  std::size_t most_numbers() const { return static_cast<std::size_t>(extent_.width() / numbered_mm()); }

  void draw_steps() {
    if (plane_.bars.empty()) return;
    const double head = bottom_ + 2 * text_mm_;
    text(kStepNames[plane_.kind], {extent_.min.x, head});
    unsigned rows = 0;
    for (const ScanPlane::Run& bar : plane_.bars) rows = std::max(rows, bar.row + 1);
    const double top = head + 1.5 * text_mm_, row = std::min(kRowMm, (area_.max.y - top) / rows);
    for (const ScanPlane::Run& bar : plane_.bars) draw_bar(bar, top + bar.row * row, row);
  }

  void draw_bar(const ScanPlane::Run& bar, double y, double row) {
    const double low = y + 0.85 * row, middle = (y + low) / 2;
    const std::vector<Point2> corners{{bar.x0, y}, {bar.x1, y}, {bar.x1, low}, {bar.x0, low}};
    const bool is_seen = std::ranges::any_of(plane_.runs, [&](const ScanPlane::Run& run) {
      return run.segment == bar.segment && run.x0 <= bar.x0 && bar.x1 <= run.x1;
    });
    if (is_seen) drawing_.fills.push_back({{corners}, kTint, 1, true});
    line({corners[0], corners[1], corners[2], corners[3], corners[0]}, kThin, is_seen ? kBlue : kLineColor);
    if (bar.segment == kNone || bar.x1 - bar.x0 < numbered_mm() || row < 1.2 * text_mm_) return;
    text(std::to_string(bar.segment + 1), {(bar.x0 + bar.x1) / 2, middle}, TextAcross::center);
  }

  void draw_scan_line() {
    const double y = plane_.y_mm;
    line({{picture_.min.x, y}, {picture_.max.x, y}}, kSegment, kRed);
    text("y = " + rounded(y) + " mm", {picture_.max.x, y - text_mm_}, TextAcross::right);
  }

  Drawing& drawing_;
  const ScanPlane& plane_;
  Rect picture_, area_, extent_{};
  double text_mm_, scale_ = 1, base_ = 0;
  double bottom_ = 0;  ///< lower end of the plane; the steps are drawn below
};

}  // namespace

double inset_part(const LineRequest& lines) {
  enum class Show { spans, plane };  // of watkins
  if (!lines.method || lines.method->traits().name != "watkins") return 0;
  return lines.settings.choice("show", Show::spans) == Show::plane ? kInsetPart : 0;
}

void add_scan_plane(Drawing& drawing, const ScanPlane& plane, const Rect& picture, const Rect& area, double text_mm) {
  PlaneDrawer(drawing, plane, picture, area, text_mm).draw();
}

}  // namespace ligne
