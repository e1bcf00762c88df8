// Drawings that must be equal. A scene told in another order, moved, scaled, turned about the line of sight, cut into other
// faces, or with more in it that is not seen gives the same visible lines; its mirror image gives the mirror image. No
// oracle takes part, and no known answer: a fault that both of these share shows here.

#include "relations/relations.hpp"
#include "base/parallel.hpp"
#include "main/tier.hpp"
#include "support/corpus_scene.hpp"
#include "support/scenes.hpp"
#include "support/standard_views.hpp"

namespace ligne::test {
namespace {

struct Subject {
  const char* name;           ///< tests/corpus/NAME.json
  bool closed_solid = false;  ///< the first object is a closed convex solid
};

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  for (const char* name : {"cube", "tetrahedron", "hexagonal_prism", "mixed_winding", "cube_on_table",
                           "cubes_stacked_shifted", "edge_on_edge_part", "vertex_on_face", "duplicate_parts",
                           "two_prisms_penetrating", "two_triangular_prisms_penetrating", "pyramid_in_cube"})
    all.push_back({name, true});
  for (const char* name :
       {"l_block", "letter_e", "star_prism", "stair", "open_box", "moebius_strip", "plate_one_hole",
        "concave_plate_with_hole", "holes_behind_holes", "island_in_hole", "pocket", "tunnel", "peg_in_hole",
        "coplanar_overlap_part", "three_plates_penetrating", "penetrating_plates_with_holes", "cyclic_3", "thesis_2_73"})
    all.push_back({name});
  return all;
}

const char* const kViewNames[] = {"odd", "front", "far"};

Sight sight_of(const Scene& scene, const std::string& view_name) {
  for (const StandardView& view : standard_views(scene))
    if (view.name == view_name) return {plain(scene), view.camera};
  throw std::invalid_argument("there is no standard view " + view_name);
}

class Relations : public testing::TestWithParam<std::tuple<Relation, Subject>> {};

TEST_P(Relations, GiveTheSameDrawing) {
  const Relation& relation = std::get<0>(GetParam());
  const Subject& subject = std::get<1>(GetParam());
  const Scene scene = corpus_scene(subject.name);
  for (const char* const view : chosen("relations, " + relation.name + subject.name, 3, kViewNames)) {
    const Sight sight = sight_of(scene, view);
    const Related related = relation.change(sight, subject.closed_solid);
    const Sight base{related.base ? *related.base : sight.scene, sight.camera};
    for (const Method* method : exact_methods()) {
      const LineDrawing expected = drawn(*method, base);
      if (!draws_well(*method, expected)) continue;
      EXPECT_FALSE(expected.lines.empty());
      const LineDrawing found = drawn(*method, related.changed);
      const std::string text = differences(related.mirrored ? mirror_image(expected) : expected, found);
      if (text.empty()) continue;
      const std::string stem = std::string(subject.name) + "-" + view + "-" + relation.name;
      ADD_FAILURE() << subject.name << ", view " << view << ", relation " << relation.name << ", method "
                    << method->traits().name << (related.mirrored ? ", places in the mirrored drawing\n" : "\n") << text
                    << command(stem + "-before", base, *method) << command(stem + "-after", related.changed, *method);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, Relations,
                         testing::Combine(testing::ValuesIn(all_relations()), testing::ValuesIn(subjects())),
                         [](const auto& info) { return std::get<0>(info.param).name + "_" + std::get<1>(info.param).name; });

/// Bit for bit, not within a tolerance.
bool equal(const Stroke& a, const Stroke& b) {
  return a.from == b.from && a.to == b.to && a.t_from == b.t_from && a.t_to == b.t_to && a.z_from == b.z_from &&
         a.z_to == b.z_to && a.w_from == b.w_from && a.w_to == b.w_to && a.source == b.source &&
         a.line_class == b.line_class && a.visible == b.visible && a.needs_overlap_check == b.needs_overlap_check;
}

class Threads : public testing::TestWithParam<Subject> {};

TEST_P(Threads, GiveEqualStrokes) {
  const Scene scene = corpus_scene(GetParam().name);
  for (const char* const view : chosen(std::string("threads, ") + GetParam().name, 3, kViewNames)) {
    const Sight sight = sight_of(scene, view);
    for (const Method* method : exact_methods()) {
      const auto with_threads = [&](int n) {
        std::vector<Stroke> strokes;
        run_with_threads(n, [&] {
          strokes = draw(scene, {sight.camera, "all", true, 0, std::string(method->traits().name)}).model.strokes;
        });
        return strokes;
      };
      const std::vector<Stroke> one = with_threads(1), four = with_threads(4);
      EXPECT_TRUE(std::equal(one.begin(), one.end(), four.begin(), four.end(), equal))
          << GetParam().name << ", view " << view << ", relation threads, method " << method->traits().name
          << "\n  ligne draw tests/corpus/" << GetParam().name << ".json" << options(sight.camera)
          << " --landscape --edges all --hidden solid --threads 4 -o x.svg";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, Threads, testing::ValuesIn(subjects()),
                         [](const auto& info) { return std::string(info.param.name); });

/// The comparison itself.
class Differences : public testing::Test {
 protected:
  Sight sight_ = sight_of(corpus_scene("cube"), "odd");
  LineDrawing cube_ = drawn(*all_methods().front(), sight_);
};

TEST_F(Differences, AreNoneOfADrawingFromItself) { EXPECT_EQ(differences(cube_, cube_), ""); }

TEST_F(Differences, AreNoneWhenALineIsCutInTwo) {
  LineDrawing cut = cube_;
  const Segment whole = cut.lines[0].place;
  cut.lines[0].place.to = whole.at(whole.length() / 3);
  cut.lines.push_back({cut.lines[0].line_class, {cut.lines[0].place.to, whole.to}});
  EXPECT_EQ(differences(cube_, cut), "");
}

TEST_F(Differences, ShowAMissingLine) {
  LineDrawing less = cube_;
  less.lines.pop_back();
  expect_parts(differences(cube_, less), {"no longer drawn"});
  expect_parts(differences(less, cube_), {"newly drawn"});
}

TEST_F(Differences, ShowALineOfAnotherClass) {
  LineDrawing other = cube_;
  other.lines[0].line_class = LineClass::border;
  EXPECT_NE(differences(cube_, other), "");
}

TEST_F(Differences, ShowALineThatIsTwoMicrometresOff) {
  for (const Point2 by : {Point2{0.002, 0}, Point2{0, 0.002}}) {
    LineDrawing off = cube_;
    for (Line& line : off.lines) line.place = {line.place.from + by, line.place.to + by};
    EXPECT_NE(differences(cube_, off), "");
  }
}

TEST_F(Differences, ShowAFaceThatIsGone) {
  Sight open = sight_;
  // The face on top: what it hid comes out.
  std::erase_if(open.scene.objects[0].faces, [&](const PlainFace& face) {
    const auto& corners = face.contours[0];
    return std::all_of(corners.begin(), corners.end(), [&](const Point3& p) { return p.z == corners[0].z && p.z > 0; });
  });
  ASSERT_EQ(open.scene.objects[0].faces.size(), 5u);
  EXPECT_NE(differences(cube_, drawn(*all_methods().front(), open)), "");
}

}  // namespace
}  // namespace ligne::test
