#pragma once
/// A drawing for plotters, and what a device is sent for it.

#include <string>

#include "gcode_interpreter.hpp"
#include "plotting/plot_writers.hpp"
#include "sample_drawing.hpp"

namespace ligne::test {

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
  w.frame = place_on_device(device, request.style.page, ink_of(drawing), fit);
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
