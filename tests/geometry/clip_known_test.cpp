// The clip on faces that are worked out by hand: the configurations of [Boulle1980], section 3.2.3.4, and every singular
// case by name.

#include <gtest/gtest.h>

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

struct Case {
  const char* name;
  ContourFace subject, clip;
  Shape inside, outside;
};

std::vector<Case> cases() {
  const ContourFace square = face({rectangle(0, 0, 8, 8)});
  const ContourFace framed = face({rectangle(0, 0, 8, 8), rectangle(2, 2, 6, 6)});
  std::vector<Case> c;
  c.push_back({"apart", square, face({rectangle(10, 0, 12, 8)}), {}, {64, 1, 0}});
  c.push_back({"clip face holds the subject", square, face({rectangle(-1, -1, 9, 9)}), {64, 1, 0}, {}});
  c.push_back({"subject in a hole of the clip face", face({rectangle(3, 3, 5, 5)}), framed, {}, {4, 1, 0}});
  c.push_back({"hole of the clip face in the subject", square, framed, {48, 1, 1}, {16, 1, 0}});
  c.push_back({"clip face in the subject", square, face({rectangle(2, 2, 6, 6)}), {16, 1, 0}, {48, 1, 1}});
  c.push_back({"clip face in a hole of the subject", framed, face({rectangle(3, 3, 5, 5)}), {}, {48, 1, 1}});
  c.push_back({"clip face is the hole of the subject", framed, face({rectangle(2, 2, 6, 6)}), {}, {48, 1, 1}});
  c.push_back({"outer contours cross", square, face({rectangle(4, 4, 12, 12)}), {16, 1, 0}, {48, 1, 0}});
  c.push_back({"subject falls apart", square, face({rectangle(3, -1, 5, 9)}), {16, 1, 0}, {48, 2, 0}});
  c.push_back({"clip face across the hole", framed, face({rectangle(3, -1, 5, 9)}), {8, 2, 0}, {40, 2, 0}});
  c.push_back({"by itself", framed, framed, {48, 1, 1}, {}});
  c.push_back({"edge along an edge, outside", square, face({rectangle(8, 2, 12, 6)}), {}, {64, 1, 0}});
  c.push_back({"edge along an edge, inside", square, face({rectangle(4, 2, 8, 6)}), {16, 1, 0}, {48, 1, 0}});
  c.push_back({"whole edge in common", square, face({rectangle(0, 0, 8, 4)}), {32, 1, 0}, {32, 1, 0}});
  c.push_back({"corner on a corner", square, face({rectangle(8, 8, 12, 12)}), {}, {64, 1, 0}});
  c.push_back({"corner on an edge from outside", square, face({{{8, 4}, {12, 0}, {12, 8}}}), {}, {64, 1, 0}});
  c.push_back({"corner on an edge from inside", square, face({{{8, 4}, {4, 6}, {4, 2}}}), {8, 1, 0}, {56, 1, 1}});
  c.push_back({"two corners on edges: the rest is two faces",
               square,
               face({{{0, 4}, {4, 0}, {8, 4}, {4, 8}}}),
               {32, 1, 0},
               {32, 4, 0}});
  c.push_back({"hole that touches the outer contour",
               face({rectangle(0, 0, 8, 8), {{0, 4}, {4, 6}, {4, 2}}}),
               face({rectangle(0, 0, 8, 4)}),
               {28, 1, 0},
               {28, 1, 0}});
  c.push_back({"holes that overlap", framed, face({rectangle(0, 0, 8, 8), rectangle(4, 2, 8, 6)}), {40, 1, 0}, {8, 1, 0}});
  c.push_back({"figure 3.24: every edge cuts every edge",
               face({{{0, 1}, {9, 1}, {9, 2}, {1, 2}, {1, 3}, {9, 3}, {9, 4}, {0, 4}}}),
               face({{{2, 0}, {3, 0}, {3, 5}, {5, 5}, {5, 0}, {6, 0}, {6, 6}, {2, 6}}}),
               {4, 4, 0},
               {15, 5, 0}});
  return c;
}

TEST(ClipKnown, EveryConfiguration) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const ClipResult result = clip_contour_by_contour(c.subject, c.clip);
    EXPECT_EQ(shape(result.inside), c.inside);
    EXPECT_EQ(shape(result.outside), c.outside);
    expect_well_formed(result.inside);
    expect_well_formed(result.outside);
  }
}

TEST(ClipKnown, BordersAreLedBackToTheirSources) {
  const ContourFace subject = make_contour_face(std::vector<Points>{rectangle(0, 0, 8, 8)}, 100);
  const ContourFace clip = make_contour_face(std::vector<Points>{{{4, -1}, {12, 4}, {4, 9}}}, 200);
  const ClipResult result = clip_contour_by_contour(subject, clip);
  ASSERT_EQ(result.inside.size(), 1u);
  std::vector<std::uint32_t> sources;
  for (const ContourEdge& e : result.inside[0].contours[0]) sources.push_back(e.source);
  std::sort(sources.begin(), sources.end());
  EXPECT_EQ(sources, (std::vector<std::uint32_t>{100, 101, 102, 200, 201, 202}));
}

TEST(ClipKnown, NeighboursHaveTheSameCorners) {
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

TEST(ClipKnown, AHoleIsGivenToTheFaceRightRoundIt) {
  // A frame leaves its inside of 8 x 8 as a face of its own; the hole of 2 x 2 in that lies in the square of 20 x 20 too.
  const Faces square{face({rectangle(0, 0, 20, 20)})};
  const Faces clips{face({rectangle(4, 4, 16, 16), rectangle(6, 6, 14, 14)}), face({rectangle(9, 9, 11, 11)})};
  const ClipResult result = clip_contour_by_contour(square, clips);
  std::vector<double> areas;
  for (const ContourFace& f : result.outside) areas.push_back(twice_area(f) / 2);
  std::sort(areas.begin(), areas.end());
  EXPECT_EQ(areas, (std::vector<double>{64 - 4, 400 - 144}));
}

TEST(ClipKnown, FacesWithoutAreaClipNothing) {
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
