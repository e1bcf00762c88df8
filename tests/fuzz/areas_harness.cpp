#include "plotting/meant_areas.hpp"
#include "reader_harness.hpp"

namespace ligne {
namespace {

using namespace test;

/// Gives two bytes after the other; behind the last one it goes on at random, so that no loop waits for a number.
class ByteDice : public Dice {
 public:
  explicit ByteDice(std::span<const std::byte> bytes) : bytes_(bytes), rest_(static_cast<unsigned>(bytes.size())) {}

  result_type operator()() override {
    if (at_ + 2 > bytes_.size()) return rest_();
    const auto low = std::to_integer<result_type>(bytes_[at_]), high = std::to_integer<result_type>(bytes_[at_ + 1]);
    at_ += 2;
    // The low bits choose among few things, the high ones place what is measured.
    return (high << 24) | (low << 16) | (high << 8) | low;
  }
  bool is_at_end() const { return at_ + 2 > bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  SeededDice rest_;
};

/// A corner on a grid of a few millimetres, beside it by some steps of the lattice of areas, or far outside the page.
Point2 any_corner(Dice& dice) {
  constexpr double kHalfStep = 0x1p-15, kFar = 1e5;
  const auto coordinate = [&] {
    const Dice::result_type n = dice();
    const double place = 10.0 * (n % 10);
    switch (n / 16 % 8) {
      case 0:
        return place + kHalfStep * static_cast<double>(n / 128 % 16);
      case 1:
        return place - kHalfStep * static_cast<double>(n / 128 % 16);
      case 2:
        return n / 128 % 8 == 0 ? (place - 50) * kFar : place;
      case 3:
        return place + static_cast<double>(n >> 16) / 65536;
      default:
        return place;
    }
  };
  const double x = coordinate();
  return {x, coordinate()};
}

/// Paths of any contours with clip paths, masks, strokes and opacities.
std::string any_areas(ByteDice& dice) {
  constexpr int kMostAreas = 40;
  std::ostringstream svg;
  svg.precision(17);
  svg << "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>";
  for (int i = 0; i < kMostAreas && !dice.is_at_end(); ++i) {
    const Dice::result_type kind = dice();
    std::ostringstream path;
    path.precision(17);
    path << "<path fill-rule='" << (kind & 1 ? "evenodd" : "nonzero") << "' clip-rule='"
         << (kind & 1 ? "evenodd" : "nonzero") << "' fill='" << (kind & 2 ? "white" : "blue") << "' d='";
    for (Dice::result_type k = 0; k < 2 + kind / 4 % 8; ++k) {
      const Point2 p = any_corner(dice);
      path << (k == 0 || (kind & 32 && k == 4) ? 'M' : 'L') << p.x << ' ' << p.y;
    }
    path << (kind & 64 ? "z'" : "'");
    const std::string around = i > 0 ? std::to_string(dice() % static_cast<Dice::result_type>(i)) : "none";
    const std::string clip = kind & 128 ? " clip-path='url(#c" + around + ")'" : "";
    const std::string mask = kind & 256 ? " mask='url(#m" + around + ")'" : "";
    svg << "<clipPath id='c" << i << "'" << clip << ">" << path.str() << "/></clipPath><mask id='m" << i
        << "' maskUnits='userSpaceOnUse' x='0' y='0' width='100' height='100'>" << path.str() << "/></mask>";
    if (kind & 512) continue;
    svg << path.str() << (kind & 1024 ? " stroke='red' stroke-width='1'" : "") << (kind & 2048 ? " opacity='.5'" : "")
        << clip << mask << "/>";
  }
  return svg.str() + "</svg>";
}

void hide_any_areas(ByteDice dice) {
  try {
    const ReadDrawing drawn = read_svg_drawing(any_areas(dice), "fuzz", {}, {FillReading::How::outline, 0.35, true});
    for (const Layer& layer : drawn.drawing.layers) {
      for (std::size_t i = 0; i < layer.lines.size(); ++i) need(layer.lines[i].size() >= 2, "lines have two points");
      for (const Point2 p : layer.lines.points) need(std::isfinite(p.x) && std::isfinite(p.y), "points are finite");
    }
  } catch (const std::runtime_error& error) {
    need(std::string_view(error.what()).starts_with("fuzz"), "errors name the file");
  }
}

}  // namespace

void hide_areas_as_fuzzer(std::span<const std::byte> bytes) {
  if (bytes.empty()) return;
  const auto kind = std::to_integer<unsigned>(bytes[0]) % 3;
  ByteDice dice(bytes.subspan(1));
  if (kind == 2) return hide_any_areas(dice);
  const MeantScene scene = kind == 0 ? abutting_rectangles(dice) : polygons_of_shared_corners(dice);
  if (const int wrong = wrong_places(scene, dice)) {
    std::fprintf(stderr, "%d wrong places: %s\n", wrong, svg_of(scene).c_str());
    need(false, "borders are those of a sampled picture");
  }
}

}  // namespace ligne
