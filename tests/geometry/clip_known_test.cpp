// The clip on faces that are worked out by hand. The configurations of [Boulle1980], section 3.2.3.4, and every singular
// case by name: clips/known.txt.

#include "clip_support.hpp"

namespace ligne::test {
namespace {

using Points = std::vector<LatticePoint>;

Points rectangle(int x0, int y0, int x1, int y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

ContourFace face(std::vector<Points> contours) { return make_contour_face(contours); }

/// Areas and numbers of faces and holes of both lists.
struct Shape {
  double area = 0;
  std::size_t faces = 0, holes = 0;
  friend bool operator==(const Shape&, const Shape&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Shape& s) {
    return out << "area " << s.area << ", " << s.faces << " faces, " << s.holes << " holes";
  }
};

Shape shape(const Faces& faces) {
  Shape s{twice_area(faces) / 2, faces.size(), 0};
  for (const ContourFace& f : faces) s.holes += f.contours.size() - 1;
  return s;
}

/// "SUBJECT / CLIP FACE": what is inside, and what outside.
std::string clipped(const std::string& text) {
  const std::vector<ContourFace> faces = faces_of_text(text);
  const ClipResult result = clip_contour_by_contour(faces.at(0), faces.at(1));
  expect_well_formed(result.inside);
  expect_well_formed(result.outside);
  const auto words = [](const Faces& parts) {
    const Shape s = shape(parts);
    return as_text(s.area, double(s.faces), double(s.holes));
  };
  return words(result.inside) + "; " + words(result.outside);
}

[[maybe_unused]] const bool clips_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/geometry/clips", {{"clip", clipped}});

TEST(ClipByHand, BordersAreLedBackToTheirSources) {
  const ContourFace subject = make_contour_face(std::vector<Points>{rectangle(0, 0, 8, 8)}, 100);
  const ContourFace clip = make_contour_face(std::vector<Points>{{{4, -1}, {12, 4}, {4, 9}}}, 200);
  const ClipResult result = clip_contour_by_contour(subject, clip);
  ASSERT_EQ(result.inside.size(), 1u);
  std::vector<std::uint32_t> sources;
  for (const ContourEdge& e : result.inside[0].contours[0]) sources.push_back(e.source);
  std::sort(sources.begin(), sources.end());
  EXPECT_EQ(sources, (std::vector<std::uint32_t>{100, 101, 102, 200, 201, 202}));
}

TEST(ClipByHand, NeighboursHaveTheSameCorners) {
  // Three lines through one point that is on no lattice: (1/3, 1/3).
  const ContourFace a = face({{{0, 0}, {1, 1}, {0, 1}}}), b = face({{{0, 1}, {0, -3}, {1, -1}}}),
                    c = face({{{1, 0}, {-1, 1}, {-1, 5}}});
  const ClipResult ab = clip_contour_by_contour(a, b), ac = clip_contour_by_contour(a, c);
  const LatticeSegment diagonal{{0, 0}, {1, 1}}, first{{0, 1}, {1, -1}}, second{{1, 0}, {-1, 1}};
  EXPECT_EQ(fine_point(diagonal, crossing(diagonal, first)), fine_point(first, crossing(first, diagonal)));
  EXPECT_EQ(fine_point(diagonal, crossing(diagonal, first)), fine_point(diagonal, crossing(diagonal, second)));
  EXPECT_EQ(fine_point(second, crossing(second, diagonal)), fine_point(first, crossing(first, diagonal)));
  expect_well_formed(ab.inside);
  expect_well_formed(ac.outside);
}

TEST(ClipByHand, AHoleIsGivenToTheFaceRightRoundIt) {
  // A frame leaves its inside of 8 x 8 as a face of its own; the hole of 2 x 2 in that lies in the square of 20 x 20 too.
  const Faces square{face({rectangle(0, 0, 20, 20)})};
  const Faces clips{face({rectangle(4, 4, 16, 16), rectangle(6, 6, 14, 14)}), face({rectangle(9, 9, 11, 11)})};
  const ClipResult result = clip_contour_by_contour(square, clips);
  std::vector<double> areas;
  for (const ContourFace& f : result.outside) areas.push_back(twice_area(f) / 2);
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(areas, (std::vector<double>{64 - 4, 400 - 144}));
}

TEST(ClipByHand, FacesWithoutAreaClipNothing) {
  const ContourFace square = face({rectangle(0, 0, 8, 8)});
  for (const Points& flat : {Points{{1, 1}, {5, 1}}, Points{{0, 0}, {8, 8}, {4, 4}}, Points{{3, 3}}, Points{}}) {
    const ClipResult result = clip_contour_by_contour(square, face({flat}));
    EXPECT_TRUE(result.inside.empty());
    EXPECT_EQ(shape(result.outside), (Shape{64, 1, 0}));
    EXPECT_TRUE(clip_contour_by_contour(face({flat}), square).inside.empty());
  }
}

}  // namespace
}  // namespace ligne::test
