#pragma once
/// Plotters as data: what they speak, how far they reach, where a sheet lies on them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "plotting/page.hpp"

namespace ligne {

enum class DeviceLanguage { hpgl, gcode, svg };
inline constexpr std::string_view kDeviceLanguageNames[] = {"hpgl", "gcode", "svg"};

/// A sheet as it lies on a device, x to the right and y away from it as the device counts them.
struct DevicePaper {
  std::string name;
  double width_mm = 0, height_mm = 0;
  Rect limits;                      ///< what the pen can reach, in units of the device
  std::optional<Point2> origin_mm;  ///< where (0, 0) lies, from the corner of the sheet with the least coordinates; nothing:
                                    ///< the limits lie in the middle
  std::string select;               ///< command, or empty
  std::string note;
};

/// A point of the machine that has a name, in mm as the device counts them.
struct DevicePlace {
  std::string name;
  Point2 at_mm{0, 0};
};

/// An action of the machine between strokes, the pen raised: dip a brush, wait. "pause" is its action between parts.
struct DeviceAction {
  std::string name;
  std::string place;  ///< where; empty: where it stands
  std::vector<std::string> commands;
};

/// Texts may hold {names}, which the writers replace: docs/plotting.md.
struct Device {
  std::string name, title, note;
  DeviceLanguage language = DeviceLanguage::hpgl;
  double step_mm = 0.025;           ///< length of a unit; coordinates are written as whole units in HPGL, as mm in G-code
  unsigned pens = 1;                ///< that it holds; 0: somebody changes them by hand, as many as there are
  int rotation = 0;                 ///< of every drawing, counter-clockwise: 0, 90, 180 or 270 degrees
  bool turn_right = false;          ///< a page that stands is laid on its right side instead of its left
  bool y_down = false;              ///< y grows towards the near side of the sheet
  Rect limits_mm;                   ///< of a device that takes sheets of any size; may be infinite
  std::vector<DevicePaper> papers;  ///< empty: sheets of any size, origin in the corner with the least coordinates
  std::vector<std::string> begin, end, up, down, pen_change;
  std::string pen_select, travel, draw, dot, velocity, delay;
  std::size_t points_per_command = 0;  ///< 0: any number
  std::vector<DevicePlace> places;
  std::vector<DeviceAction> actions;
  bool inside_first = false;  ///< it cuts: what lies in a closed line comes before that
  bool returns = false;       ///< the pen goes back to (0, 0) at the end
  double down_mm_s = 0, up_mm_s = 0, lift_s = 0, pen_change_s = 0;
};

/// The devices that the program knows, by name.
const std::vector<Device>& devices();

/// nullptr when there is none of that name.
const Device* find_device(std::string_view name);
const DevicePlace* find_place(const Device& device, std::string_view name);
const DeviceAction* find_action(const Device& device, std::string_view name);

/// A device of one's own. Throws std::runtime_error, "FILE:LINE: what is wrong".
Device read_device(std::string_view toml, const std::string& file);

/// Page mm to device mm: a turn, a shift, and a scale that is 1 unless the drawing was made to fit.
struct DeviceFrame {
  Point2 origin{0, 0}, x_axis{1, 0}, y_axis{0, -1};
  const DevicePaper* paper = nullptr;
  double scale = 1;       ///< of a drawing that was made to fit
  Point2 shift_mm{0, 0};  ///< of the same, on the page: p becomes scale * p + shift
  Rect limits;            ///< whole units
  Point2 sheet_mm{0, 0};  ///< along the device's axes

  Point2 to_device(Point2 page) const { return origin + x_axis * page.x + y_axis * page.y; }
  Point2 to_page(Point2 device) const;
  /// Where a point of the page comes to lie on the page when the drawing was made to fit.
  Point2 fitted(Point2 page) const { return page * scale + shift_mm; }
};

/// Lays the page on the device: on the paper of its size, else in the middle of the smallest paper that holds it; turned
/// where page and paper do not lie alike. `ink` is what is drawn, page mm. Throws std::runtime_error when there is no such
/// paper, or, with the excess, when the ink would leave the limits. With `fit` the drawing is shifted, and made smaller if
/// need be, until it lies within the limits.
DeviceFrame place_on_device(const Device& device, const Page& page, const Rect& ink, bool fit);

}  // namespace ligne
