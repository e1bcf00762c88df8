#pragma once
/// Plotters as data: their language, their reach, and the place of a sheet on them.

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

/// A sheet as it lies on a device: its width along the device's x axis, its height along the y axis.
struct DevicePaper {
  std::string name;
  double width_mm = 0, height_mm = 0;
  Rect limits;                      ///< reach of the pen, in units of the device
  std::optional<Point2> origin_mm;  ///< place of (0, 0), from the corner of the sheet with the least coordinates;
                                    ///< nothing: the limits are centred on the sheet
  std::string select;               ///< command that selects the paper, or empty
  std::string note;
};

/// A point of the machine that has a name, in mm as the device counts them.
struct DevicePlace {
  std::string name;
  Point2 at_mm{0, 0};
};

/// An action of the machine between strokes with the pen raised: dip a brush, wait. The action "pause" is performed
/// between the parts of a plot.
struct DeviceAction {
  std::string name;
  std::string place;  ///< name of the place; empty: where the pen is
  std::vector<std::string> commands;
};

/// Texts may hold {names}, which the writers replace: docs/plotting.md.
struct Device {
  std::string name, title, note;
  DeviceLanguage language = DeviceLanguage::hpgl;
  double step_mm = 0.025;           ///< length of a unit; coordinates are written as whole units in HPGL, as mm in G-code
  unsigned pens = 1;                ///< number of pens that it holds; 0: any number, changed by hand
  int rotation = 0;                 ///< turn of every drawing, counter-clockwise: 0, 90, 180 or 270 degrees
  bool turn_right = false;          ///< an upright page is laid on its right side instead of its left
  bool y_down = false;              ///< y grows towards the near side of the sheet
  Rect limits_mm;                   ///< limits of a device that takes sheets of any size; may be infinite
  std::vector<DevicePaper> papers;  ///< empty: sheets of any size, origin in the corner with the least coordinates
  std::vector<std::string> begin, end, up, down, pen_change;
  std::string pen_select, travel, draw, dot, velocity, delay;
  std::size_t points_per_command = 0;  ///< most points in a command; 0: any number
  std::vector<DevicePlace> places;
  std::vector<DeviceAction> actions;
  bool inside_first = false;  ///< it cuts: lines inside a closed line are drawn before it
  bool returns = false;       ///< the pen goes back to (0, 0) at the end
  double down_mm_s = 0, up_mm_s = 0, lift_s = 0, pen_change_s = 0;
};

/// The devices that the program knows, by name.
const std::vector<Device>& devices();

/// nullptr when there is none of that name.
const Device* find_device(std::string_view name);
const DevicePlace* find_place(const Device& device, std::string_view name);
const DeviceAction* find_action(const Device& device, std::string_view name);

/// Reads a device of the user. Throws std::runtime_error, "FILE:LINE: cause".
Device read_device(std::string_view toml, const std::string& file);

/// Page mm to device mm: a turn, a shift, and a scale that is 1 unless the drawing was made to fit.
struct DeviceFrame {
  Point2 origin{0, 0}, x_axis{1, 0}, y_axis{0, -1};
  const DevicePaper* paper = nullptr;
  double scale = 1;       ///< scale of a drawing that was made to fit
  Point2 shift_mm{0, 0};  ///< shift of such a drawing on the page: p becomes scale * p + shift
  Rect limits;            ///< reach of the pen, whole units
  Point2 sheet_mm{0, 0};  ///< size of the sheet along the device's axes

  Point2 to_device(Point2 page) const { return origin + x_axis * page.x + y_axis * page.y; }
  Point2 to_page(Point2 device) const;
  /// The place on the page of a point of the drawing after it was made to fit.
  Point2 fitted(Point2 page) const { return page * scale + shift_mm; }
};

/// Places the page on the device: on the paper of its size, else in the middle of the smallest paper that holds it. The
/// page is turned if only one of page and paper is upright. `ink` is the bounding box of the drawing, page mm. Throws
/// std::runtime_error if there is no such paper, or if the ink would leave the limits; the message gives the excess.
/// With `fit` the drawing is shifted, and made smaller if need be, until it lies within the limits.
DeviceFrame place_on_device(const Device& device, const Page& page, const Rect& ink, bool fit);

}  // namespace ligne
