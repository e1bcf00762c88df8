#include "picture/marks/map_marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <glm/geometric.hpp>

#include "picture/errors.hpp"

namespace ligne {
namespace {

// Adjustable, in heights of capitals.
constexpr double kRowGap = 1.2, kTick = 0.6, kTextGap = 0.5;
constexpr double kArrow = 4, kArrowHead = 1.2;
constexpr double kSample = 6, kEntryGap = 3, kEntryRow = 1.8;
/// Adjustable: least length of the unit vector to the north on the page. Below it, within 0.06 degrees of the line of
/// sight, an arrow has no meaning.
constexpr double kLeastNorth = 1e-3;
constexpr double kBarPart = 0.3;  ///< largest length of a scale bar, as part of the width

/// The largest product of 1, 2 or 5 and a power of ten up to `most`.
double round_below(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return (most / power >= 5 ? 5 : most / power >= 2 ? 2 : 1) * power;
}

std::string plain_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Adds lines and texts to the marks, and extends their bounding box.
class Rows {
 public:
  Rows(MapMarks& marks, const MeasureText& measure, double height) : marks_(marks), measure_(measure), h_(height) {}

  void add_line(Point2 a, Point2 b) {
    marks_.lines.push_back({a, b});
    marks_.extent.extend(a);
    marks_.extent.extend(b);
  }
  void add_text(const std::string& text, Point2 at, TextAcross across, TextUp up) {
    const TextItem item{text, at, h_, across, up, 0};
    for (const Point2 p : text_box(item, measure_(text, h_)).corners()) marks_.extent.extend(p);
    marks_.texts.push_back(item);
  }
  double width(const std::string& text) const { return measure_(text, h_).width; }

 private:
  MapMarks& marks_;
  const MeasureText& measure_;
  double h_;
};

/// Ground units per mm of the page, from left to right; metres if the unit is degrees.
double ground_of_mm(const MapGround& ground, const View& view) {
  const Camera& camera = view.camera;
  if (camera.perspective) throw RequestError("scale-bar", "needs a parallel projection: a perspective view has no scale");
  const double across = std::hypot(camera.right.x, camera.right.y);
  if (!(across > 0)) throw RequestError("scale-bar", "the ground is seen edge on");
  if (ground.unit == GroundUnit::degrees) return kMetresPerDegree / (view.scale * across);
  return std::hypot(camera.right.x / ground.factor.x, camera.right.y / ground.factor.y) / (view.scale * across);
}

/// The place of a row of marks: its upper left corner and its width, page mm.
struct RowPlace {
  Point2 at;
  double width;
};

/// Adds a line with ticks at its ends and its middle, and numbers above. Returns its height.
double add_scale_bar(Rows& rows, const std::string& asked_unit, const MapGround& ground, const View& view,
                     const RowPlace& place, double h) {
  const Point2 at = place.at;
  const double of_mm = ground_of_mm(ground, view);
  double length = round_below(kBarPart * place.width * of_mm);
  const double mm = length / of_mm;
  std::string unit = asked_unit.empty() && ground.unit != GroundUnit::unknown ? "m" : asked_unit;
  constexpr double kMetresOfKilometre = 1000;
  if (unit == "m" && length >= kMetresOfKilometre) {
    unit = "km";
    length /= kMetresOfKilometre;
  }
  const double line = at.y + (1 + kTextGap + kTick) * h;
  const std::string last = plain_number(length) + (unit.empty() ? "" : " " + unit);
  rows.add_line({at.x, line}, {at.x + mm, line});
  for (const double part : {0.0, 0.5, 1.0}) {
    const double tick = part == 0.5 ? kTick / 2 : kTick;
    rows.add_line({at.x + part * mm, line - tick * h}, {at.x + part * mm, line});
  }
  rows.add_text("0", {at.x, at.y + h}, TextAcross::left, TextUp::base);
  rows.add_text(last, {at.x + mm, at.y + h}, TextAcross::center, TextUp::base);
  return line - at.y;
}

/// Adds an arrow in the direction of growing y with its letter at the head, inside a square whose upper right corner is
/// `right_top`. Returns its height.
double add_north_arrow(Rows& rows, const View& view, Point2 right_top, double h) {
  const Camera& camera = view.camera;
  if (camera.perspective)
    throw RequestError("north-arrow", "needs a parallel projection: it has no one direction in a perspective view");
  const Point2 north{camera.right.y, camera.down.y};
  if (!(glm::length(north) > kLeastNorth)) throw RequestError("north-arrow", "north is seen end on");
  const Point2 along = glm::normalize(north), across{-along.y, along.x};
  // The arrow and its letter are inside a square.
  const double half = (kArrow / 2 + 1) * h;
  const Point2 middle{right_top.x - half, right_top.y + half};
  const Point2 tip = middle + along * (half - 1.6 * h), tail = middle - along * half;
  rows.add_line(tail, tip);
  for (const double side : {-1.0, 1.0})
    rows.add_line(tip - along * (kArrowHead * h) + across * (side * 0.4 * kArrowHead * h), tip);
  rows.add_text("N", tip + along * (0.9 * h), TextAcross::center, TextUp::middle);
  return 2 * half;
}

}  // namespace

MapMarks lay_out_map_marks(const AxesChoice& choice, const MapGround& ground, const View& view, const Rect& all, double h,
                           const MeasureText& measure) {
  MapMarks marks;
  Rows rows(marks, measure, h);
  double y = all.max.y + kRowGap * h, row = 0;
  if (choice.scale_bar) row = add_scale_bar(rows, choice.scale_unit, ground, view, {{all.min.x, y}, all.width()}, h);
  if (choice.north_arrow) row = std::max(row, add_north_arrow(rows, view, {all.max.x, y}, h));
  if (row > 0) y += row + kRowGap * h;
  double x = all.min.x;
  for (const LegendEntry& entry : choice.legend) {
    const double width = (kSample + kTextGap) * h + rows.width(entry.text);
    if (x > all.min.x && x + width > all.max.x) {
      x = all.min.x;
      y += kEntryRow * h;
    }
    const std::array<Point2, 2> sample{Point2{x, y + h / 2}, Point2{x + kSample * h, y + h / 2}};
    marks.samples.push_back(sample);
    for (const Point2 p : sample) marks.extent.extend(p);
    rows.add_text(entry.text, {x + (kSample + kTextGap) * h, y + h}, TextAcross::left, TextUp::base);
    x += width + kEntryGap * h;
  }
  return marks;
}

}  // namespace ligne
