#pragma once
/// Contours in words: "0,0 8,0 8,8; rectangle 2,2 6,6" are two.

#include "geometry/point.hpp"
#include "main/script.hpp"
#include "support/test.hpp"

namespace ligne::test {

inline std::vector<std::vector<Point2>> contours_of(const std::string& text) {
  std::vector<std::vector<Point2>> contours;
  for (const std::string& part : parts_of(text, ';')) {
    std::vector<Point2>& contour = contours.emplace_back();
    bool is_rectangle = false;
    for (const std::string& word : words_of(part)) {
      Point2 p;
      if (std::sscanf(word.c_str(), "%lf,%lf", &p.x, &p.y) == 2) {
        contour.push_back(p);
      } else if (word == "rectangle") {
        is_rectangle = true;
      } else {
        throw std::invalid_argument(text);
      }
    }
    if (is_rectangle) contour = {contour.at(0), {contour.at(1).x, contour[0].y}, contour[1], {contour[0].x, contour[1].y}};
  }
  return contours;
}

}  // namespace ligne::test
