#pragma once
/// A drawing for plotters, what a device is sent for it, and machines that replay that.

#include "plotting/plot.hpp"
#include "plotting/writers/writers.hpp"
#include "sample_drawing.hpp"

namespace ligne::test {

struct Replay {
  std::vector<std::vector<Point2>> strokes;  ///< mm for G-code, units for HPGL
  std::vector<std::string> faults;           ///< moves with the pen half down, unknown commands and the like
  std::vector<int> pens;                     ///< selected, in order; G-code: pauses
  Rect reach;                                ///< of all moves, raised ones too
  bool ends_up = false;
};

/// How the pen of a G-code device goes down.
enum class PenKind { servo, servo_reversed, z };

Replay replay_gcode(std::string_view text, PenKind kind);
Replay replay_hpgl(std::string_view text);

// A drawing for plotters, and what a device is sent for it.

/// A frame, a diagonal, a dot, and a dashed line, on A4 with room for every device.
inline Drawing plotter_drawing() {
  Drawing drawing;
  add_line(drawing, "hidden", {{30, 60}, {70, 60}});
  add_line(drawing, "mesh", {{40, 100}, {60, 120}, {80, 100}});
  add_line(drawing, "mesh", {{100, 100}, {100, 100}});
  add_line(drawing, "outline", {{30, 40}, {180, 40}, {180, 240}, {30, 240}, {30, 40}});
  add_line(drawing, "outline", {{30, 40}, {180, 240}});
  return drawing;
}

inline PlotRequest request_for(bool two_pens) {
  PlotRequest request;
  if (two_pens) {
    add_pen(request.pens, "outline=1,black,0.5");
    add_pen(request.pens, "rest=2,#0000ff,0.3");
    request.pens.pens[2].name = "blue (fine)";
    request.pens.pens[2].speed = 50;
  }
  return request;
}

struct Written {
  Plot plot;
  DeviceFrame frame;
  std::string text;
};

inline Written written(const Device& device, const Drawing& drawing, bool two_pens, bool fit = false) {
  PlotRequest request = request_for(two_pens);
  Written w;
  w.frame = place_on_device(device, request.style.page, drawn_bounds(drawing), fit);
  request.paths.order.home = w.frame.to_page({0, 0});
  request.paths.order.returns = device.returns;
  w.plot = make_plot(drawing, request);
  w.text = write_plot(w.plot, device, w.frame);
  return w;
}

inline PenKind kind_of(const Device& device) {
  return device.name == "grbl-z"                ? PenKind::z
         : device.name == "grbl-servo-reversed" ? PenKind::servo_reversed
                                                : PenKind::servo;
}

inline Replay replay(const Device& device, const std::string& text) {
  return device.language == DeviceLanguage::hpgl ? test::replay_hpgl(text) : test::replay_gcode(text, kind_of(device));
}

}  // namespace ligne::test
