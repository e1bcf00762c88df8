/// Drawings of refined parts name the faces and edges of the given scene.

#include "base/no_index.hpp"
#include "clear/true_parts.hpp"
#include "picture/draw_scene.hpp"
#include "picture/models/models.hpp"
#include "support/page_lines.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

TEST(RefinedPicture, NamesGivenFacesAndEdges) {
  for (const TruePart& part : true_parts()) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / (part.name + ".stl");
    write_mesh(part, 12, file);
    const Scene scene = load_models({.files = {file.string()}}).scene;
    const Topology topology = build_topology(scene);
    RunReport run;
    const DrawnScene drawn = draw_lines(scene, {}, run, std::nullopt, {}, true);
    const SceneVisibility& found = drawn.visibility();
    const StrokeModel& model = *found.result.strokes;
    EXPECT_EQ(&drawn.prepared().scene, &scene) << part.name;
    ASSERT_EQ(found.edges.size(), topology.edges.size()) << part.name;
    const FoundSurfaces surfaces = drawn.surfaces();
    if (!surfaces.list.empty()) {
      EXPECT_EQ(surfaces.of_face.size(), scene.faces.size()) << part.name;
    }
    for (const Stroke& s : model.strokes) {
      const SourceEdge source = found.source(scene, s.source);
      for (const std::uint32_t face : source.faces) EXPECT_TRUE(face == kNone || face < scene.faces.size()) << part.name;
      if (s.source >= found.edges.size()) continue;
      const Point2 from = page_point(drawn.prepared().view(), source.ends[0]),
                   to = page_point(drawn.prepared().view(), source.ends[1]);
      EXPECT_LT(distance_to_segment(model.lattice.to_mm(s.from), from, to), 2.0) << part.name;
    }
  }
}

}  // namespace
}  // namespace ligne::test
