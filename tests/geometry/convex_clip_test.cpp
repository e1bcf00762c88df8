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

/// The convex hull of points; points on its sides are kept as corners if `straight`. Empty without area.
std::vector<LatticePoint> hull(std::vector<LatticePoint> points, bool straight) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<LatticePoint> chain;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = chain.size();
    for (const LatticePoint p : points) {
      const auto turns = [&] { return orientation(chain[chain.size() - 2], chain.back(), p); };
      while (chain.size() >= base + 2 && (straight ? turns() < 0 : turns() <= 0)) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  double area = 0;
  for (std::size_t i = 2; i < chain.size(); ++i) area += orientation(chain[0], chain[i - 1], chain[i]);
  return area > 0 ? chain : std::vector<LatticePoint>{};
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

/// Figure 3.31: the intersection is convex; a part outside is convex if one side of the clip contour cuts it off.
TEST(ConvexClipKnown, ConvexityIsKept) {
  const ContourFace square = face_of({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  const struct {
    const char* name;
    std::vector<LatticePoint> clip;
    ConvexMeeting meeting;
    std::vector<bool> outside;  ///< whether each part is convex
    bool linked = false;
  } rows[] = {
      {"a side cuts off one part", {{6, -2}, {12, -2}, {12, 10}, {6, 10}}, ConvexMeeting::cut, {true}},
      {"a strip between two parts", {{3, -2}, {5, -2}, {5, 10}, {3, 10}}, ConvexMeeting::cut, {true, true}},
      {"a corner", {{6, 6}, {12, 6}, {12, 12}, {6, 12}}, ConvexMeeting::cut, {false}},
      {"a triangle cut off at a corner", {{6, -2}, {10, -2}, {10, 4}}, ConvexMeeting::cut, {true}},
      {"a hole", {{3, 3}, {5, 3}, {5, 5}, {3, 5}}, ConvexMeeting::cut, {false}},
      {"a hole that touches the contour", {{0, 4}, {3, 3}, {3, 5}}, ConvexMeeting::cut, {false}, true},
      {"two corners that touch", {{0, 4}, {4, 0}, {6, 6}}, ConvexMeeting::cut, {true, false}, true},
      {"apart by a side of the clip contour", {{9, 0}, {12, 0}, {12, 8}}, ConvexMeeting::apart, {}},
      {"apart by a side of the subject", {{9, -9}, {30, 4}, {9, 17}}, ConvexMeeting::apart, {}},
      {"a common side", {{8, 0}, {12, 0}, {12, 8}, {8, 8}}, ConvexMeeting::apart, {}},
      {"a common corner", {{8, 8}, {12, 8}, {12, 12}}, ConvexMeeting::apart, {}},
      {"the same", {{0, 0}, {8, 0}, {8, 8}, {0, 8}}, ConvexMeeting::within, {}},
      {"within, on a side", {{0, -1}, {9, -1}, {9, 9}, {0, 9}}, ConvexMeeting::within, {}},
  };
  for (const auto& row : rows) {
    SCOPED_TRACE(row.name);
    ConvexClip work;
    ASSERT_EQ(work.meet(square.contours[0], face_of(row.clip).contours[0]), row.meeting);
    EXPECT_EQ(work.linked(), row.linked ? 1u : 0u);
    if (row.meeting != ConvexMeeting::cut) continue;
    std::vector<bool> outside;
    for (const ContourFace& face : work.outside()) {
      outside.push_back(face.is_convex);
      EXPECT_EQ(face.is_convex, is_convex(face));
    }
    std::sort(outside.rbegin(), outside.rend());
    EXPECT_EQ(outside, row.outside);
    EXPECT_TRUE(is_convex({{work.inside()}}));
  }
}

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
