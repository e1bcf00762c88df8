#pragma once
/// Faces laid straight onto the lattice, for tests of the modules of the method warnock.

#include "support/standard.hpp"
#include "visibility/warnock/control.hpp"
#include "visibility/warnock/initial_window.hpp"

namespace ligne::test {

/// A corner: lattice steps and depth in mm.
struct Corner {
  std::int32_t x, y;
  double z;
};

/// A few faces, and all that the modules ask of them.
class Stage {
 public:
  Stage() { scene_.lattice.step_mm = 0x1p-17; }

  /// Faces in words, in the order of their numbers: "face 0,0,1 500,0,2 0,500,2; rectangle -9 -9 9 9 6; cover 1 3" are a
  /// triangle, an upright rectangle at depth 6, and a face that covers the steps from -5000 to 5000, its depth 1 at the left
  /// and 3 at the right.
  explicit Stage(const std::string& text) : Stage() {
    std::istringstream faces(text);
    for (std::string words; std::getline(faces, words, ';');) {
      std::replace(words.begin(), words.end(), ',', ' ');
      std::istringstream in(words);
      std::string kind;
      in >> kind;
      const std::vector<double> n{std::istream_iterator<double>(in), {}};
      const auto at = [&](std::size_t i) { return static_cast<std::int32_t>(n.at(i)); };
      if (kind == "rectangle") {
        add_rectangle(at(0), at(1), at(2), at(3), n.at(4));
      } else if (kind == "cover") {
        add({{-5000, -5000, n.at(0)}, {5000, -5000, n.back()}, {5000, 5000, n.back()}, {-5000, 5000, n.at(0)}});
      } else {
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < n.size(); i += 3) corners.push_back({at(i), at(i + 1), n.at(i + 2)});
        add(corners);
      }
    }
  }

  /// A convex face (or a fan from its first corner that covers it); returns its number.
  std::uint32_t add(const std::vector<Corner>& corners) {
    const std::uint32_t face = faces_++;
    const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
    for (const Corner& c : corners) scene_.vertices.push_back({{c.x, c.y}, c.z});
    for (std::uint32_t i = 2; i < corners.size(); ++i) scene_.triangles.push_back({{first, first + i - 1, first + i}, face});
    return face;
  }

  /// Upright rectangle of one depth.
  std::uint32_t add_rectangle(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1, double z) {
    return add({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
  }

  /// Call once, when all faces are there.
  const warnock::FaceTable& table(const warnock::WindowFrame& frame = {}) {
    facets_ = make_facets(scene_, 1);
    table_ = warnock::make_faces(scene_, facets_.facets, frame);
    return table_;
  }

 private:
  ProjectedScene scene_;
  Facets facets_;
  warnock::FaceTable table_;
  std::uint32_t faces_ = 0;
};

}  // namespace ligne::test
