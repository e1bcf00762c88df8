#pragma once
/// Scenes of areas made at random, written as SVG, and the rule for what is seen of them, point by point. The rule works on
/// the shapes as they were meant, before any transform, and shares nothing with the code under test but points.

#include "plotting/readers/drawing_reader.hpp"
#include "support/standard.hpp"

namespace ligne::test {

/// Numbers at random. The seeded generator of the tests and the bytes of a fuzzer both give them.
struct Dice {
  using result_type = std::uint32_t;
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  virtual ~Dice() = default;
  virtual result_type operator()() = 0;
};

struct SeededDice : Dice {
  explicit SeededDice(unsigned seed) : random(seed) {}
  result_type operator()() override { return static_cast<result_type>(random()); }
  std::mt19937 random;
};

using Contour = std::vector<Point2>;  ///< closed, page mm

struct MeantArea {
  std::vector<Contour> contours;
  bool even_odd = false;
  std::vector<Contour> clips{};  ///< each is a clip path of its own, one within the other
};

struct MeantScene {
  std::vector<MeantArea> areas;  ///< from the first painted to the last
  std::string body;              ///< the same as elements of an SVG page of 100 x 100 mm, each below its own transforms
};

/// Rectangles whose sides lie on few lines, so that most of them abut or coincide.
MeantScene abutting_rectangles(Dice& dice);
/// Polygons with corners on a coarse grid, turned a little: they cross themselves, and share corners and parts of edges.
MeantScene polygons_of_shared_corners(Dice& dice);
/// Some of many edges, among which each line meets many others; they share corners too.
MeantScene scribbles(Dice& dice);

/// The whole SVG.
std::string svg_of(const MeantScene& scene);

/// How many sampled places of the plotted borders are wrong: a border is drawn once where it parts what is seen, and nowhere
/// else. Places that lie too near to other edges are not judged.
int wrong_places(const MeantScene& scene, Dice& dice);

}  // namespace ligne::test
