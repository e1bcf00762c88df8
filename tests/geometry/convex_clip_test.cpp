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

}  // namespace
}  // namespace ligne::test
