#pragma once
/// Short SVG texts, read, and what is in them.

#include "drawing/measures.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "support/test.hpp"

namespace ligne::test {

/// In a page of 100 x 100 mm whose unit is the millimetre.
inline std::string page(const std::string& body, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
         "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\" fill=\"none\" stroke=\"black\" " +
         attributes + ">\n" + body + "\n</svg>";
}

inline ReadDrawing read(const std::string& body) { return read_svg_drawing(page(body), "a.svg", {}); }

/// The only line of the only layer.
inline std::vector<Point2> line_of(const std::string& body) {
  const ReadDrawing drawing = read(body);
  if (drawing.drawing.layers.size() != 1 || drawing.drawing.layers[0].lines.size() != 1) {
    ADD_FAILURE() << body << ": not one line";
    return {{0, 0}, {0, 0}};
  }
  const auto line = drawing.drawing.layers[0].lines[0];
  return {line.begin(), line.end()};
}

/// The error with which strict reading refuses an SVG.
inline std::string error_of(const std::string& svg) {
  const std::string error = failure_of([&] { read_svg_drawing(svg, "a.svg", {}, {}, {.strict = true}); });
  EXPECT_EQ(error.find('\n'), std::string::npos);
  EXPECT_LT(error.size(), 400u);
  return error;
}

/// The box of the strokes of the layer.
inline Rect box_of(const ReadDrawing& drawing, const std::string& layer) {
  Rect box;
  for (const Layer& l : drawing.drawing.layers) {
    if (l.name != layer) continue;
    for (const Point2 p : l.lines.points) box.extend(p);
  }
  return box;
}

/// All lines of all layers, as texts of whole hundredths, sorted.
inline std::multiset<std::string> lines_of(const ReadDrawing& drawing) {
  std::multiset<std::string> all;
  for (const Layer& layer : drawing.drawing.layers) {
    for (std::size_t i = 0; i < layer.lines.size(); ++i) {
      std::string text;
      for (const Point2 p : layer.lines[i])
        text += std::to_string(std::lround(p.x * 100)) + "," + std::to_string(std::lround(p.y * 100)) + " ";
      all.insert(text);
    }
  }
  return all;
}

using Lines = std::multiset<std::string>;

}  // namespace ligne::test
