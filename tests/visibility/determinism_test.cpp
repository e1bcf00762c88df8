// The same strokes whatever the number of threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "geometry/parallel.hpp"
#include "main/tier.hpp"
#include "support/scenes.hpp"

namespace ligne::test {
namespace {

bool same(const Stroke& a, const Stroke& b) {
  return a.from == b.from && a.to == b.to && a.t_from == b.t_from && a.t_to == b.t_to && a.source == b.source &&
         a.line_class == b.line_class && a.visible == b.visible;
}

/// A method of another product has its own test of it.
std::vector<const Method*> methods_of_strokes() {
  std::vector<const Method*> methods;
  for (const Method* method : all_methods()) {
    if (method->traits().products & kStrokes) methods.push_back(method);
  }
  return methods;
}

class Determinism : public testing::TestWithParam<const Method*> {};

TEST_P(Determinism, OneThreadAndManyGiveTheSameStrokes) {
  // Hidden lines and intersections cost a method the more, the more boxes hide each other.
  const int part = runs_all() ? 1 : 2;
  for (const auto& [boxes, hidden] : {std::pair(1500 / part, false), std::pair(500 / part, true)}) {
    Scene scene;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(-1, 1);
    for (int i = 0; i < boxes; ++i) {
      add_box(scene, Point3{u(random), u(random), u(random)} * 10.0, {2, 2, 2},
              rotation(u(random) * 3, u(random) * 3, u(random) * 3));
    }
    const auto with_threads = [&, hidden = hidden](int n) {
      Picture picture;
      run_with_threads(n, [&] {
        picture = draw(scene, {along({-1, 2, -1}), "all", hidden, 0, std::string(GetParam()->traits().name)});
      });
      return picture;
    };
    const Picture one = with_threads(1), four = with_threads(4);
    ASSERT_GT(one.model.strokes.size(), 1000u);
    ASSERT_EQ(one.model.strokes.size(), four.model.strokes.size());
    for (std::size_t i = 0; i < one.model.strokes.size(); ++i) {
      ASSERT_TRUE(same(one.model.strokes[i], four.model.strokes[i])) << "stroke " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Determinism, testing::ValuesIn(methods_of_strokes()), [](const auto& info) {
  std::string name(info.param->traits().name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace ligne::test
