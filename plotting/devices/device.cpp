#include "plotting/devices/device.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "files/message_text.hpp"
#include "plotting/writers/number_text.hpp"

namespace ligne {
namespace {

/// Largest difference of sides of the same paper, mm: letter in whole tenths of a millimetre, trimmed sheets.
constexpr double kSameSizeMm = 1;

/// Slack for rounding, in units: 300 mm / 0.025 mm must give 12,000 units, however the division rounds.
constexpr double kUnitSlack = 1e-3;

bool same(double a, double b) { return std::abs(a - b) <= kSameSizeMm; }

std::string mm(double value) { return decimal_text(value, 2) + " mm"; }

/// The paper of the page's size, else the smallest that holds it; with `fit` the largest when none does.
const DevicePaper* paper_for(const Device& device, const Page& page, bool fit) {
  const double low = std::min(page.width_mm, page.height_mm), high = std::max(page.width_mm, page.height_mm);
  const DevicePaper *exact = nullptr, *holds = nullptr, *largest = nullptr;
  const auto area = [](const DevicePaper* p) { return p->width_mm * p->height_mm; };
  for (const DevicePaper& paper : device.papers) {
    const double paper_low = std::min(paper.width_mm, paper.height_mm),
                 paper_high = std::max(paper.width_mm, paper.height_mm);
    if (!exact && same(paper_low, low) && same(paper_high, high)) exact = &paper;
    if (paper_low >= low && paper_high >= high && (!holds || area(&paper) < area(holds))) holds = &paper;
    if (!largest || area(&paper) > area(largest)) largest = &paper;
  }
  if (exact) return exact;
  if (holds) return holds;
  if (fit) return largest;
  std::string names;
  for (const DevicePaper& paper : device.papers) names += (names.empty() ? "" : ", ") + printable(paper.name);
  throw std::runtime_error("device " + printable(device.name) + ": no paper holds a page of " + mm(page.width_mm) + " x " +
                           mm(page.height_mm) + "; there are " + names + "; --fit-device makes the drawing smaller");
}

/// Turns the frame by this number of right angles counter-clockwise, about the device's origin.
void turn(DeviceFrame& frame, int quarters) {
  for (int i = 0; i < quarters; ++i) {
    for (Point2* v : {&frame.origin, &frame.x_axis, &frame.y_axis}) *v = {-v->y, v->x};
  }
}

/// Shifts the frame so that the middle of the page comes to `middle`.
void put_middle(DeviceFrame& frame, const Page& page, Point2 middle) {
  frame.origin += middle - frame.to_device({page.width_mm / 2, page.height_mm / 2});
}

Rect bounds_on_device(const DeviceFrame& frame, const Rect& ink) {
  Rect bounds;
  for (const Point2 corner : {ink.min, ink.max}) bounds.extend(frame.to_device(corner));
  return bounds;
}

/// The box in whole units, rounded as a writer rounds.
Rect in_units(const Rect& mm, double step) {
  return {{std::round(mm.min.x / step), std::round(mm.min.y / step)},
          {std::round(mm.max.x / step), std::round(mm.max.y / step)}};
}

void refuse_excess(const Device& device, const Rect& units, const DeviceFrame& frame) {
  const std::array<std::pair<double, const char*>, 4> sides{{{frame.limits.min.x - units.min.x, "x below its minimum"},
                                                             {units.max.x - frame.limits.max.x, "x above its maximum"},
                                                             {frame.limits.min.y - units.min.y, "y below its minimum"},
                                                             {units.max.y - frame.limits.max.y, "y above its maximum"}}};
  std::string text;
  for (const auto& [excess, side] : sides) {
    if (excess > 0) text += (text.empty() ? "" : ", ") + mm(excess * device.step_mm) + " " + side;
  }
  if (text.empty()) return;
  throw std::runtime_error("device " + printable(device.name) +
                           (frame.paper ? ", paper " + printable(frame.paper->name) : "") +
                           ": the drawing leaves the limits: " + text + "; a wider --margin or --fit-device helps");
}

/// Makes the drawing smaller if need be, then shifts it as little as possible.
void fit_into_limits(DeviceFrame& frame, const Rect& ink, const Rect& limits_mm) {
  const DeviceFrame unfitted = frame;
  const Rect before = bounds_on_device(frame, ink);
  double scale = 1;
  if (before.width() > limits_mm.width()) scale = std::min(scale, limits_mm.width() / before.width());
  if (before.height() > limits_mm.height()) scale = std::min(scale, limits_mm.height() / before.height());
  const Point2 middle = (ink.min + ink.max) * 0.5, place = frame.to_device(middle);
  frame.scale = scale;
  frame.x_axis *= scale;
  frame.y_axis *= scale;
  frame.origin += place - frame.to_device(middle);
  const Rect bounds = bounds_on_device(frame, ink);
  for (const int axis : {0, 1}) {
    if (bounds.min[axis] < limits_mm.min[axis]) {
      frame.origin[axis] += limits_mm.min[axis] - bounds.min[axis];
    } else if (bounds.max[axis] > limits_mm.max[axis]) {
      frame.origin[axis] += limits_mm.max[axis] - bounds.max[axis];
    }
  }
  frame.shift_mm = unfitted.to_page(frame.origin);
}

}  // namespace

Point2 DeviceFrame::to_page(Point2 device) const {
  const Point2 from = device - origin;
  const double squared = scale * scale;
  return {(from.x * x_axis.x + from.y * x_axis.y) / squared, (from.x * y_axis.x + from.y * y_axis.y) / squared};
}

const Device* find_device(std::string_view name) {
  for (const Device& device : devices()) {
    if (device.name == name) return &device;
  }
  return nullptr;
}

const DevicePlace* find_place(const Device& device, std::string_view name) {
  const auto found = std::ranges::find(device.places, name, &DevicePlace::name);
  return found == device.places.end() ? nullptr : &*found;
}

const DeviceAction* find_action(const Device& device, std::string_view name) {
  const auto found = std::ranges::find(device.actions, name, &DeviceAction::name);
  return found == device.actions.end() ? nullptr : &*found;
}

DeviceFrame place_on_device(const Device& device, const Page& page, const Rect& ink, bool fit) {
  DeviceFrame frame;
  const bool stands = page.height_mm > page.width_mm;
  if (!device.papers.empty()) {
    frame.paper = paper_for(device, page, fit);
    const DevicePaper& paper = *frame.paper;
    const bool paper_stands = paper.height_mm > paper.width_mm;
    frame.sheet_mm = {paper.width_mm, paper.height_mm};
    if (stands != paper_stands && page.width_mm != page.height_mm) turn(frame, device.turn_right ? 3 : 1);
    turn(frame, device.rotation / 90);
    const Rect reach{paper.limits.min * device.step_mm, paper.limits.max * device.step_mm};
    const Point2 origin = paper.origin_mm.value_or((frame.sheet_mm - (reach.min + reach.max)) * 0.5);
    put_middle(frame, page, frame.sheet_mm * 0.5 - origin);
    frame.limits = paper.limits;
  } else {
    const bool limits_stand = device.limits_mm.height() > device.limits_mm.width();
    const bool bounded = std::isfinite(device.limits_mm.width()) && std::isfinite(device.limits_mm.height());
    const bool reaches = page.width_mm <= device.limits_mm.width() && page.height_mm <= device.limits_mm.height();
    if (bounded && !reaches && stands != limits_stand) turn(frame, device.turn_right ? 3 : 1);
    turn(frame, device.rotation / 90);
    const bool lies_across = frame.x_axis.x == 0;
    frame.sheet_mm = lies_across ? Point2{page.height_mm, page.width_mm} : Point2{page.width_mm, page.height_mm};
    put_middle(frame, page, frame.sheet_mm * 0.5);
    const Rect& mm = device.limits_mm;
    frame.limits = {mm.min / device.step_mm, mm.max / device.step_mm};
    for (const int axis : {0, 1}) {
      frame.limits.min[axis] = std::ceil(frame.limits.min[axis] - kUnitSlack);
      frame.limits.max[axis] = std::floor(frame.limits.max[axis] + kUnitSlack);
    }
  }
  if (device.y_down) {
    for (Point2* v : {&frame.x_axis, &frame.y_axis}) v->y = -v->y;
    frame.origin.y = frame.sheet_mm.y - frame.origin.y;
  }
  if (ink.empty()) return frame;
  if (fit) fit_into_limits(frame, ink, {frame.limits.min * device.step_mm, frame.limits.max * device.step_mm});
  refuse_excess(device, in_units(bounds_on_device(frame, ink), device.step_mm), frame);
  return frame;
}

}  // namespace ligne
