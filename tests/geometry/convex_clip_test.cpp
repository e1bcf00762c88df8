// The clip of convex contours against the general clip: on small grids, where everything is singular, and on the whole
// lattice; results are clipped again and again.

#include "geometry/polygons/convex_clip.hpp"

#include "clip_support.hpp"
#include "main/tier.hpp"

namespace ligne::test {
namespace {

ContourFace face_of(std::vector<LatticePoint> corners) {
  ContourFace face = make_contour_face(std::span(&corners, 1));
  face.is_convex = is_convex(face);
  return face;
}

ContourFace random_convex(std::mt19937& random, std::int32_t limit, int most, bool straight) {
  std::uniform_int_distribution<std::int32_t> at(-limit, limit);
  std::uniform_int_distribution<int> count(3, most);
  for (;;) {
    std::vector<LatticePoint> points(static_cast<std::size_t>(count(random)));
    for (LatticePoint& p : points) p = {at(random), at(random)};
    const std::vector<LatticePoint> corners = hull(points, straight);
    if (!corners.empty()) return face_of(corners);
  }
}

/// The corners of all contours, each contour from its lowest corner on, in order.
std::vector<std::vector<FinePoint>> corners_of(const Faces& faces) {
  std::vector<std::vector<FinePoint>> list;
  for (const ContourFace& face : faces) {
    for (const EdgeLoop& loop : face.contours) {
      std::vector<FinePoint>& corners = list.emplace_back();
      for (const ContourEdge& e : loop) corners.push_back(e.begin());
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    }
  }
  std::sort(list.begin(), list.end());
  return list;
}

TEST(ConvexContours, AreToldExactly) {
  EXPECT_TRUE(face_of({{0, 0}, {4, 0}, {0, 4}}).is_convex);
  EXPECT_TRUE(face_of({{0, 0}, {0, 4}, {4, 0}}).is_convex) << "wound the other way";
  EXPECT_TRUE(face_of({{0, 0}, {2, 0}, {4, 0}, {4, 4}}).is_convex) << "a corner on a straight side";
  EXPECT_FALSE(face_of({{0, 0}, {4, 0}, {1, 1}, {0, 4}}).is_convex);
  constexpr std::int32_t kFar = kLatticeLimit;
  EXPECT_TRUE(face_of({{-kFar, -kFar}, {0, -1}, {kFar, kFar}, {-kFar, kFar}}).is_convex);
  EXPECT_FALSE(face_of({{-kFar, -kFar}, {0, 1}, {kFar, kFar}, {-kFar, kFar}}).is_convex) << "by one step";
  // A star of five points turns positively at every corner, twice round.
  EXPECT_FALSE(face_of({{0, 100}, {59, -81}, {-95, 31}, {95, 31}, {-59, -81}}).is_convex);
  std::vector<std::vector<LatticePoint>> frame{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {6, 3}, {6, 6}, {3, 6}}};
  EXPECT_FALSE(is_convex(make_contour_face(frame)));
  ContourFace open = face_of({{0, 0}, {4, 0}, {0, 4}});
  open.contours[0][0].to = {1, 2};
  EXPECT_FALSE(is_convex(open)) << "an edge that does not end where the next one begins";
}

/// "SUBJECT / CLIP": how two convex contours meet, how often parts were linked, and whether each part outside is convex.
/// Figure 3.31: the intersection is convex; a part outside is convex if one side of the clip contour cuts it off.
std::string met(const std::string& text) {
  const std::vector<ContourFace> faces = faces_of_text(text);
  ConvexClip work;
  const ConvexMeeting meeting = work.meet(faces.at(0).contours[0], faces.at(1).contours[0]);
  if (meeting != ConvexMeeting::cut) return meeting == ConvexMeeting::apart ? "apart" : "within";
  std::vector<std::string> outside;
  for (const ContourFace& face : work.outside()) {
    outside.push_back(face.is_convex ? " convex" : " not");
    EXPECT_EQ(face.is_convex, is_convex(face));
  }
  std::ranges::sort(outside);
  EXPECT_TRUE(is_convex({{work.inside()}}));
  return std::accumulate(outside.begin(), outside.end(), "cut" + std::string(work.linked() == 1 ? ", linked:" : ":"));
}

[[maybe_unused]] const bool meetings_are_added =
    add_function_scripts(LIGNE_SOURCE_DIR "/tests/geometry/meetings", {{"meet", met}});

/// Clips the subject by the clip face both ways and compares. Gives the part outside by the convex clip.
Faces compare_clips(const ContourFace& subject, const ContourFace& clip, ConvexClip& work, std::array<int, 4>& met) {
  const ClipResult wanted = clip_contour_by_contour(std::span(&subject, 1), std::span(&clip, 1), true);
  const ConvexMeeting meeting = work.meet(subject.contours[0], clip.contours[0]);
  ++met[static_cast<std::size_t>(meeting)];
  switch (meeting) {
    case ConvexMeeting::apart:
      EXPECT_TRUE(wanted.inside.empty());
      return {subject};
    case ConvexMeeting::within:
      EXPECT_TRUE(wanted.outside.empty());
      EXPECT_EQ(corners_of(wanted.inside), corners_of({subject}));
      return {};
    case ConvexMeeting::thin:
      return wanted.outside;
    case ConvexMeeting::cut:
      break;
  }
  ContourFace inside{{work.inside()}, true};
  EXPECT_TRUE(is_convex(inside));
  EXPECT_EQ(corners_of({inside}), corners_of(wanted.inside));
  EXPECT_EQ(corners_of(work.outside()), corners_of(wanted.outside));
  for (const ContourFace& face : work.outside()) EXPECT_EQ(face.is_convex, is_convex(face));
  return std::move(work.outside());
}

class ConvexClipRandom : public testing::TestWithParam<unsigned> {};

/// In the first tier the first tenth of them.
const int kPairs = runs_all() ? 20'000 : 2'000;

TEST_P(ConvexClipRandom, IsTheGeneralClip) {
  std::mt19937 random(GetParam());
  ConvexClip work;
  std::array<int, 4> met{};
  for (int i = 0; i < kPairs && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    const std::int32_t limit = std::array{2, 4, 12, 1 << 20, kLatticeLimit}[static_cast<std::size_t>(i % 5)];
    const int most = i % 7 == 0 ? 24 : 5;
    Faces faces{random_convex(random, limit, most, i % 3 == 0)};
    for (int clips = 0; clips < 4; ++clips) {  // a convex part that is left is clipped again
      const auto convex = std::find_if(faces.begin(), faces.end(), [](const ContourFace& f) { return f.is_convex; });
      if (convex == faces.end()) break;
      const ContourFace subject = *convex;
      faces = compare_clips(subject, random_convex(random, limit, most, i % 4 == 0), work, met);
    }
  }
  for (const ConvexMeeting meeting : {ConvexMeeting::apart, ConvexMeeting::within, ConvexMeeting::cut})
    EXPECT_GT(met[static_cast<std::size_t>(meeting)], kPairs / 50);
  EXPECT_GT(work.linked(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ConvexClipRandom, testing::Values(1u, 2u, 3u, 4u));

// The clip on faces that are worked out by hand. The configurations of [Boulle1980], section 3.2.3.4, and every singular
// case by name: clips/known.txt.

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
