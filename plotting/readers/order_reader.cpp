#include "plotting/readers/order_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "files/input_error.hpp"
#include "plotting/readers/json_cursor.hpp"

namespace ligne {
namespace {

class PieceReader {
 public:
  PieceReader(std::string_view array, const std::string& file, ReadOrder& to) : json_(array), file_(file), to_(to) {}

  void read() {
    try {
      json_.for_each_item([&] { read_piece(); });
    } catch (const JsonSyntaxError& e) {
      fail("is not valid JSON: at byte " + std::to_string(e.at) + " of the order");
    }
  }

 private:
  [[noreturn]] void fail(const std::string& cause) const {
    throw InputError(file_, "piece " + std::to_string(to_.pieces.size()) + " of the order: " + cause);
  }

  void read_piece() {
    PaintPiece piece;
    std::vector<std::vector<Point2>> outer, holes;
    std::optional<double> face, material, light;
    bool hidden = false;
    json_.for_each_member([&](std::string_view name) {
      if (name == "hidden") {
        hidden = json_.value().starts_with("true");
        return;
      }
      if (hidden) {
        json_.value();
        return;
      }
      if (name == "face") {
        face = json_.number();
      } else if (name == "material") {
        material = json_.number();
      } else if (name == "light") {
        light = json_.number();
      } else if (name == "outer") {
        read_contour(outer);
      } else if (name == "holes") {
        json_.for_each_item([&] { read_contour(holes); });
      } else {
        json_.value();
      }
    });
    to_.tells_hidden = to_.tells_hidden || hidden;
    if (hidden) return;
    if (outer.size() != 1) fail("has no outer contour");
    piece.contours = std::move(outer);
    std::ranges::move(holes, std::back_inserter(piece.contours));
    piece.face = whole(face, "face");
    to_.pieces.push_back({piece.face, whole(material, "material"), std::clamp(light.value_or(1), 0.0, 1.0)});
    to_.order.pieces.push_back(std::move(piece));
  }

  std::uint32_t whole(const std::optional<double>& number, const char* name) const {
    constexpr double kMost = 0xffffffffp0;
    if (!number || !(*number >= 0 && *number <= kMost && *number == std::floor(*number)))
      fail(std::string("has no ") + name + "; draw it again with this version");
    return static_cast<std::uint32_t>(*number);
  }

  void read_contour(std::vector<std::vector<Point2>>& contours) {
    std::vector<Point2>& points = contours.emplace_back();
    json_.for_each_item([&] {
      json_.expect('[');
      Point2 p;
      p.x = json_.number();
      json_.expect(',');
      p.y = json_.number();
      json_.expect(']');
      if (!(std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm)) fail("a point is farther than a kilometre away");
      points.push_back(p);
    });
    if (points.size() < 3) fail("a contour has fewer than three points");
  }

  JsonCursor json_;
  const std::string& file_;
  ReadOrder& to_;
};

}  // namespace

SplitDrawing split_drawing(std::string_view json, const std::string& file) {
  SplitDrawing split;
  try {
    JsonCursor cursor(json);
    std::size_t copied = 0;
    cursor.for_each_member([&](std::string_view name) {
      const std::size_t begin = cursor.place();
      const std::string_view value = cursor.value();
      if ((name != "order" && name != "regions") || !value.starts_with('[')) return;
      if (name == "order") split.order = value;
      split.rest += json.substr(copied, begin - copied);
      split.rest += "[]";
      copied = begin + value.size();
    });
    split.rest += json.substr(copied);
  } catch (const JsonSyntaxError& e) {
    throw InputError(file, "is not JSON: at byte " + std::to_string(e.at));
  }
  return split;
}

void read_pieces(std::string_view array, const std::string& file, ReadOrder& to) { PieceReader(array, file, to).read(); }

}  // namespace ligne
