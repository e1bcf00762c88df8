/// Surfaces that run into themselves, and the pairs of triangles that this is decided by.

#include "scene/model/self_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <random>

#include "scene/model/triangle_contact.hpp"

namespace ligne {
namespace {

const Corners3 kFlat{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

/// The answer for the pair, which must not depend on the order of the two, nor on how they are wound.
bool apart(Corners3 t, Corners3 u, int shared) {
  const bool answer = are_apart(t, u, shared);
  EXPECT_EQ(are_apart(u, t, shared), answer);
  if (shared < 2) std::swap(t[1], t[2]);
  EXPECT_EQ(are_apart(t, u, shared), answer);
  return answer;
}

TEST(PlaneSide, Identities) {
  EXPECT_EQ(plane_side({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), 1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto point = [&] {
    const double x = u(random), y = u(random), z = u(random);
    return Point3{x, y, z};
  };
  for (int i = 0; i < 1000; ++i) {
    const Point3 a = point(), b = point(), c = point(), d = point();
    const int side = plane_side(a, b, c, d);
    EXPECT_EQ(plane_side(b, c, a, d), side);
    EXPECT_EQ(plane_side(b, a, c, d), -side);
    const Point3 p = glm::round(a * 1000.0), q = glm::round(b * 1000.0), r = glm::round(c * 1000.0);
    EXPECT_EQ(plane_side(p, q, r, q + r - p), 0) << "a point of the plane";
  }
}

TEST(TriangleContact, TrianglesWithoutCommonCorners) {
  EXPECT_TRUE(apart(kFlat, {{{0, 0, 1}, {4, 0, 1}, {0, 4, 2}}}, 0)) << "above";
  EXPECT_FALSE(apart(kFlat, {{{1, 1, -1}, {1, 1, 1}, {1, 2, 1}}}, 0)) << "pierced";
  EXPECT_TRUE(apart(kFlat, {{{5, 5, -1}, {5, 5, 1}, {5, 6, 1}}}, 0)) << "beside, across the plane";
  EXPECT_FALSE(apart(kFlat, {{{1, 1, 0}, {1, 1, 1}, {1, 2, 1}}}, 0)) << "a corner on the face";
  EXPECT_FALSE(apart(kFlat, {{{1, 0, 0}, {1, 0, 1}, {1, -2, 1}}}, 0)) << "a corner on a side";
  EXPECT_FALSE(apart(kFlat, {{{1, -1, -1}, {1, 1, 1}, {1, -5, 1}}}, 0)) << "a side through a side";
  EXPECT_FALSE(apart(kFlat, {{{1, 1, 0}, {9, 1, 0}, {9, 2, 0}}}, 0)) << "coplanar, overlapping";
  EXPECT_TRUE(apart(kFlat, {{{3, 3, 0}, {9, 3, 0}, {9, 4, 0}}}, 0)) << "coplanar, beside";
  EXPECT_FALSE(apart(kFlat, {{{0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0}}}, 0)) << "coplanar, within";
}

TEST(TriangleContact, TrianglesWithACommonCorner) {
  EXPECT_TRUE(apart(kFlat, {{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}}, 1));
  EXPECT_FALSE(apart(kFlat, {{{0, 0, 0}, {2, 1, 1}, {2, 1, -1}}}, 1)) << "cuts into it";
  EXPECT_TRUE(apart(kFlat, {{{0, 0, 0}, {-2, 1, 1}, {-2, 1, -1}}}, 1)) << "across its plane, on the other side";
  EXPECT_FALSE(apart(kFlat, {{{0, 0, 0}, {2, 0, 0}, {2, 0, 1}}}, 1)) << "along a part of a side";
  EXPECT_TRUE(apart(kFlat, {{{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}}}, 1)) << "coplanar, opposite";
  EXPECT_FALSE(apart(kFlat, {{{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}}}, 1)) << "coplanar, overlapping";
}

TEST(TriangleContact, TrianglesWithACommonSide) {
  EXPECT_TRUE(apart(kFlat, {{{0, 0, 0}, {4, 0, 0}, {0, 1, 1}}}, 2));
  EXPECT_TRUE(apart(kFlat, {{{0, 0, 0}, {4, 0, 0}, {0, -1, 0}}}, 2)) << "coplanar";
  EXPECT_FALSE(apart(kFlat, {{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}}, 2)) << "folded onto it";
  EXPECT_FALSE(apart(kFlat, kFlat, 3)) << "twice the same";
}

TEST(TriangleContact, CoplanarTrianglesThatAreTurnedDoNotMeet) {
  // Rounding leaves their corners beside the plane; the projections tell them apart.
  const Point3 x = Point3{0.6, 0.48, 0.64}, y{-0.8, 0.36, 0.48};
  const auto at = [&](double a, double b) { return x * a + y * b; };
  for (int i = 1; i < 50; ++i) {
    const double s = i / 7.0;
    EXPECT_TRUE(apart({{at(0, 0), at(s, s), at(s, 0)}}, {{at(0, 0), at(s, s), at(0, s)}}, 2));
    EXPECT_TRUE(apart({{at(s, s), at(2 * s, s), at(2 * s, 2 * s)}}, {{at(s, s), at(0, s), at(0, 0)}}, 1));
  }
}

TEST(TriangleContact, AreaIsTold) {
  EXPECT_TRUE(has_no_area({{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}}));
  EXPECT_FALSE(has_no_area({{{0, 0, 0}, {1, 2, 3}, {2, 4, 6.5}}}));
}

/// A torus of n by n quadrilaterals, each cut in two; its tube has the radius `tube`, the circle that it goes round is 1.
struct Torus {
  std::vector<Point3> vertices;
  std::vector<Triangle> triangles;

  Torus(std::uint32_t n, double tube) {
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t k = 0; k < n; ++k) {
        const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * (k + 0.5) / n, r = 1 + tube * std::cos(v);
        vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
        const auto at = [&](std::uint32_t a, std::uint32_t b) { return (i + a) % n * n + (k + b) % n; };
        add({at(0, 0), at(1, 0), at(1, 1)});
        add({at(0, 0), at(1, 1), at(0, 1)});
      }
    }
  }
  void add(const std::array<std::uint32_t, 3>& v) { triangles.push_back({v, static_cast<std::uint32_t>(triangles.size())}); }
};

TEST(SelfContact, ATorusPenetratesItselfWhenItsTubeIsTooThick) {
  for (const double tube : {0.2, 0.9, 0.99, 1.02, 1.5}) {
    const Torus torus(24, tube);
    const std::vector<std::uint32_t> one(torus.triangles.size(), 0);
    EXPECT_EQ(find_self_contacts(torus.vertices, torus.triangles, one, 1), (std::vector<std::uint8_t>{tube > 1}));
  }
}

TEST(SelfContact, SurfacesAreHeldAgainstThemselvesOnly) {
  Torus torus(16, 0.3);
  const auto half = static_cast<std::uint32_t>(torus.triangles.size());
  std::vector<Triangle> twice = torus.triangles;
  for (Triangle t : torus.triangles) {
    t.face += half;
    twice.push_back(t);
  }
  std::vector<std::uint32_t> surface(2 * half, 0);
  std::fill(surface.begin() + half, surface.end(), 1);
  EXPECT_EQ(find_self_contacts(torus.vertices, twice, surface, 2), (std::vector<std::uint8_t>{0, 0}));
  std::fill(surface.begin(), surface.begin() + half, kNone);
  EXPECT_EQ(find_self_contacts(torus.vertices, twice, surface, 2), (std::vector<std::uint8_t>{0, 0}));
  std::fill(surface.begin(), surface.end(), 1);
  EXPECT_EQ(find_self_contacts(torus.vertices, twice, surface, 2), (std::vector<std::uint8_t>{0, 1}));
}

}  // namespace
}  // namespace ligne
