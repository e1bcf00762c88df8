/// Writes HPGL and G-code by one walk over the pens and their strokes, with the commands of the device. Coordinates are
/// rounded once, to the device's units. Consecutive points in one unit become one point.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "files/message_text.hpp"
#include "plotting/plot.hpp"
#include "plotting/writers/number_text.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

struct Unit {
  std::int64_t x, y;
  friend bool operator==(Unit, Unit) = default;
};

using Replacement = std::pair<std::string_view, std::string_view>;

/// The text with every {name} replaced. The reader of devices has refused unknown names.
std::string filled(std::string_view text, std::initializer_list<Replacement> replacements) {
  std::string out;
  while (!text.empty()) {
    bool found = false;
    for (const auto& [name, value] : replacements) {
      if (text.size() < name.size() + 2 || text[0] != '{' || text.substr(1, name.size()) != name ||
          text[name.size() + 1] != '}')
        continue;
      out += value;
      text.remove_prefix(name.size() + 2);
      found = true;
      break;
    }
    if (found) continue;
    out += text[0];
    text.remove_prefix(1);
  }
  return out;
}

/// The text of a G-code comment, without the characters that would end it.
std::string comment(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c != '(' && c != ')' && c != ';' && static_cast<unsigned char>(c) >= 0x20 && static_cast<unsigned char>(c) < 0x7f)
      text += c;
  }
  return text.empty() ? "" : ": " + text;
}

class PlotWriter {
 public:
  PlotWriter(const Device& device, const DeviceFrame& frame, const PlotStops& stops)
      : device_(device), frame_(frame), stops_(stops) {}

  std::string write(const Plot& plot) {
    lines(device_.begin, {{"paper", frame_.paper ? frame_.paper->select : std::string_view{}}});
    if (device_.language == DeviceLanguage::gcode) lines(device_.up, {});
    const Pen* held = nullptr;
    for (const PenLines& pen : plot.pens) {
      if (pen.pen.skip) continue;
      begin_pen(pen.pen, held);
      held = &pen.pen;
      for (std::size_t i = 0; i < pen.lines.size(); ++i) {
        if (std::ranges::binary_search(pen.pauses, i)) act(find_action(device_, "pause"));
        if (std::ranges::binary_search(pen.actions, i)) act(stops_.action);
        stroke(pen.lines[i]);
      }
    }
    lines(device_.end, {});
    return std::move(out_);
  }

 private:
  void line(std::string_view text, std::initializer_list<Replacement> replacements) {
    const std::string filled_in = filled(text, replacements);
    if (!filled_in.empty()) out_ += filled_in + "\n";
  }
  void lines(const std::vector<std::string>& texts, std::initializer_list<Replacement> replacements) {
    for (const std::string& text : texts) line(text, replacements);
  }
  std::string coordinate(std::int64_t units) const {
    if (device_.language == DeviceLanguage::hpgl) return std::to_string(units);
    return decimal_text(static_cast<double>(units) * device_.step_mm, kDecimals);
  }
  Unit unit(Point2 page) const { return unit_of(frame_.to_device(page)); }
  Unit unit_of(Point2 mm) const { return {std::llround(mm.x / device_.step_mm), std::llround(mm.y / device_.step_mm)}; }

  void go_to(const DevicePlace* place) {
    if (!place) return;
    const Unit at = unit_of(place->at_mm);
    line(device_.travel, {{"x", coordinate(at.x)}, {"y", coordinate(at.y)}});
  }
  void act(const DeviceAction* action) {
    if (!action) return;
    go_to(find_place(device_, action->place));
    lines(action->commands, {{"feed", feed_}, {"z_feed", feed_}});
  }

  void begin_pen(const Pen& pen, const Pen* held);
  void stroke(std::span<const Point2> points);
  void draw_points();

  static constexpr int kDecimals = 4;

  const Device& device_;
  const DeviceFrame& frame_;
  const PlotStops stops_;
  std::string out_, feed_;
  std::vector<Unit> units_;
};

/// `held` is the pen before, nullptr at the beginning.
void PlotWriter::begin_pen(const Pen& pen, const Pen* held) {
  if (device_.pens > 0 && pen.number > device_.pens) {
    throw std::runtime_error("device " + printable(device_.name) + " holds " + std::to_string(device_.pens) +
                             " pens, but the drawing needs pen " + std::to_string(pen.number));
  }
  constexpr double kSecondsPerMinute = 60, kMmPerCm = 10, kPercent = 100;
  const double speed = device_.down_mm_s * pen.speed.value_or(100) / kPercent;
  feed_ = decimal_text(std::max(1.0, speed * kSecondsPerMinute), 0);  // a feed of 0 stops the machine
  const std::string pen_number = std::to_string(pen.number), name = comment(pen.name),
                    width = decimal_text(pen.width_mm.value_or(0), 2);
  const bool changes = !held || held->number != pen.number;
  if (held && changes) go_to(stops_.park);
  if ((held && changes) || pen.pause) lines(device_.pen_change, {{"pen", pen_number}, {"name", name}});
  if (changes) line(device_.pen_select, {{"pen", pen_number}, {"width", width}});
  if (pen.delay_ms) line(device_.delay, {{"seconds", decimal_text(*pen.delay_ms / 1000.0, kDecimals)}});
  if (pen.speed || (held && held->speed))
    line(device_.velocity, {{"cm_per_s", std::to_string(std::max(1ll, std::llround(speed / kMmPerCm)))}});
}

void PlotWriter::stroke(std::span<const Point2> points) {
  units_.clear();
  for (const Point2 p : points) {
    const Unit u = unit(p);
    if (units_.empty() || units_.back() != u) units_.push_back(u);
  }
  if (units_.empty()) return;
  line(device_.travel, {{"x", coordinate(units_[0].x)}, {"y", coordinate(units_[0].y)}});
  lines(device_.down, {{"feed", feed_}, {"z_feed", feed_}});
  if (units_.size() == 1) {
    line(device_.dot, {});
  } else {
    draw_points();
  }
  lines(device_.up, {});
}

void PlotWriter::draw_points() {
  if (device_.language == DeviceLanguage::gcode) {
    for (std::size_t i = 1; i < units_.size(); ++i) {
      line(device_.draw, {{"x", coordinate(units_[i].x)}, {"y", coordinate(units_[i].y)}, {"feed", feed_}});
    }
    return;
  }
  const std::size_t most = device_.points_per_command == 0 ? units_.size() : device_.points_per_command;
  for (std::size_t i = 1; i < units_.size(); i += most) {
    std::string list;
    for (std::size_t k = i; k < std::min(units_.size(), i + most); ++k) {
      if (k > i) list += ',';
      list += coordinate(units_[k].x) + "," + coordinate(units_[k].y);
    }
    line(device_.draw, {{"points", list}});
  }
}

}  // namespace

std::string write_plot(const Plot& plot, const Device& device, const DeviceFrame& frame, const PlotStops& stops) {
  return PlotWriter(device, frame, stops).write(plot);
}

}  // namespace ligne
