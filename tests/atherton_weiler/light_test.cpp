// Shadows, transparency and details on scenes whose areas are known, by the scripts of light/. All are drawn from above or
// from the front, so that a region's area is that of the part of the face.

#include "drawing/measures.hpp"
#include "linework/overlaps/coincident_strokes.hpp"
#include "main/script.hpp"
#include "picture/draw_scene.hpp"
#include "picture/light/details.hpp"
#include "picture/light/seen_through.hpp"
#include "picture/light/shadows.hpp"
#include "scene/readers/reader.hpp"
#include "support/test.hpp"
#include "view/projected_scene.hpp"
#include "view/tolerances.hpp"
#include "visibility/methods.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

using test::area_of;

Scene scene_named(const std::string& name) {
  Warnings warnings;
  return read_scene(LIGNE_SOURCE_DIR "/tests/atherton_weiler/scenes/" + name + ".json", {}, warnings);
}

/// Sums by names, as text: "NAME SUM, NAME SUM".
class Sums {
 public:
  double& operator[](const std::string& name) { return sums_[name]; }
  /// Rounded to whole multiples of one part of so many.
  std::string text(double parts) const {
    std::string text;
    for (const auto& [name, sum] : sums_)
      text += (text.empty() ? "" : ", ") + name + " " + test::as_text(std::round(sum * parts) / parts);
    return text;
  }

 private:
  std::map<std::string, double> sums_;
};

/// Contours go from page to page through the lattice: a step of 10 nm along some hundred millimetres.
constexpr double kArea = 1e4;
/// A drawing owes its coordinates to a micrometre; a dozen ends.
constexpr double kLength = 0.01;

std::string place_of(const Region& r) { return std::to_string(r.face) + "/" + std::to_string(r.level); }

struct Seen {
  Scene scene;
  Topology topology;
  View view;
  std::vector<Region> regions;
  StrokeModel strokes;

  /// "SCENE VIEW", and lights in place of those of the scene, "parallel:X,Y,Z" and "point:X,Y,Z"; "sheet:X0,Y0,X1,Y1" is
  /// the part of the page that is drawn.
  explicit Seen(const std::string& text) {
    const std::vector<std::string> words = test::words_of(text);
    scene = scene_named(words.at(0));
    Rect window{{0, 0}, {200, 200}};
    std::vector<Light> lights;
    for (std::size_t i = 2; i < words.size(); ++i) {
      const std::vector<std::string> kind = test::parts_of(words[i], ':'), n = test::parts_of(kind.at(1), ',');
      const auto number = [&](std::size_t k) { return std::stod(n.at(k)); };
      if (kind[0] == "sheet") {
        window = {{number(0), number(1)}, {number(2), number(3)}};
      } else {
        const auto way = kind[0] == "point" ? Light::Kind::point : Light::Kind::parallel;
        lights.push_back({way, {number(0), number(1), number(2)}});
      }
    }
    if (!lights.empty()) scene.lights = lights;
    topology = build_topology(scene);
    CameraRequest request;
    request.named_view = words.at(1);
    view = make_view(scene, make_camera(request, scene), {{{0, 0}, {200, 200}}}, window, 1);
    EdgeSelection selection;
    for (std::size_t c = 0; c < kEdgeClassCount; ++c) selection.classes.add(static_cast<LineClass>(c));
    const ProjectedScene projected = project(scene, topology, view, selection);
    VisibilityResult result = atherton_weiler_method().compute_visibility(projected, {});
    regions = std::move(*result.regions);
    strokes = std::move(*result.strokes);
    remove_coincident_strokes(strokes, coincidence_mm(projected));
  }

  auto shadows() const { return cast_shadows(scene, topology, view, scene.lights, regions); }

  std::string lit() const {
    Sums sums;
    for (const Region& r : shadows().regions) sums[std::to_string(r.face) + "/" + std::to_string(r.lights)] += area_of(r);
    return sums.text(kArea);
  }

  std::string shares() const {
    Sums sums;
    for (const Region& r : shadows().regions) {
      const double share = r.lights == 0 ? 0 : r.light_shares.empty() ? 1 : r.light_shares[0];
      sums[std::to_string(r.face) + "/" + test::as_text(std::round(share * 1000) / 1000)] += area_of(r);
    }
    return sums.text(kArea);
  }

  std::string borders() const {
    StrokeModel model = strokes;
    add_shadow_strokes(scene, view, shadows().borders, model);
    remove_coincident_strokes(model, 0.001);
    return lengths(model, [](const Stroke& s) { return s.line_class == LineClass::shadow; });
  }

  std::string lines() const {
    return lengths(strokes, [](const Stroke& s) { return s.visible; });
  }

  std::string layers() const {
    std::string names;
    for (const Layer& layer : make_drawing(strokes).layers) names += (names.empty() ? "" : " ") + layer.name;
    return names;
  }

  std::string areas() const {
    Sums sums;
    for (const Region& r : regions) sums[place_of(r)] += area_of(r);
    return sums.text(kArea);
  }

  std::string through() const {
    const Lattice lattice = page_lattice(view);
    EXPECT_TRUE(seen_through(scene, {}, lattice).empty());
    const auto through = seen_through(scene, regions, lattice);
    EXPECT_EQ(through.size(), regions.size());
    std::map<std::string, std::set<std::string>> found;
    for (std::size_t i = 0; i < through.size(); ++i)
      for (std::set<std::string>& places = found[place_of(regions[i])]; const std::uint32_t k : through[i])
        places.insert(place_of(regions[k]));
    std::string text;
    for (const auto& [place, places] : found) {
      text += (text.empty() ? "" : ", ") + place;
      for (const std::string& seen : places) text += " " + seen;
    }
    return text;
  }

  std::string details() const {
    constexpr double kParts = 1e3;  // faces go on a little beyond the sheet
    std::array<double, 2> sums{0, 0};
    for (const Region& r : cut_details(scene, view, regions))
      if (r.face == 0) sums[0] += r.material == 1 ? area_of(r) : 0, sums[1] += area_of(r);
    return test::as_text(std::round(sums[0] * kParts) / kParts, std::round(sums[1] * kParts) / kParts);
  }

  template <class Wanted>
  static std::string lengths(const StrokeModel& model, Wanted wanted) {
    Sums sums;
    for (const Stroke& s : model.strokes)
      if (wanted(s)) sums[std::to_string(s.level)] += glm::distance(model.lattice.to_mm(s.from), model.lattice.to_mm(s.to));
    return sums.text(1 / kLength);
  }
};

[[maybe_unused]] const bool light_is_added = test::add_function_scripts(
    LIGNE_SOURCE_DIR "/tests/atherton_weiler/light", {{"lit", [](auto& t) { return Seen(t).lit(); }},
                                                      {"shares", [](auto& t) { return Seen(t).shares(); }},
                                                      {"borders", [](auto& t) { return Seen(t).borders(); }},
                                                      {"regions", [](auto& t) { return Seen(t).areas(); }},
                                                      {"lines", [](auto& t) { return Seen(t).lines(); }},
                                                      {"layers", [](auto& t) { return Seen(t).layers(); }},
                                                      {"through", [](auto& t) { return Seen(t).through(); }},
                                                      {"details", [](auto& t) { return Seen(t).details(); }}});

double perimeter(const Region& region) {
  double sum = 0;
  for (const auto& contour : region.contours)
    for (std::size_t i = 0; i < contour.size(); ++i) sum += glm::distance(contour[i], contour[(i + 1) % contour.size()]);
  return sum;
}

TEST(Shadows, NoSliversAlongTheBordersOfFaces) {
  // The lit part of a triangle ends at its border, on the light's page as on the viewer's, but rounded otherwise. The
  // two dark parts have the square's sides and, twice, the piece in it of the line from (0, 0) to (9.3, 10.7): nothing
  // that runs on along the line.
  const Seen seen("shadow_triangles_askew top");
  constexpr double kSlope = 10.7 / 9.3;
  for (const double x : {1.0, 1.01, 1.07, 1.13, 1.21}) {
    const std::vector<Light> lights{{Light::Kind::parallel, {x, 1.02, -1.1}}};
    const double dx = 3 * x / 1.1,
                 dy = 3 * 1.02 / 1.1;  // the shadow is (2, 3) to (5, 6), moved by this
    const double from = std::max(2 + dx, (3 + dy) / kSlope), to = std::min(5 + dx, (6 + dy) / kSlope);
    double sum = 0;
    for (const Region& r : cast_shadows(seen.scene, seen.topology, seen.view, lights, seen.regions).regions)
      if (r.lights == 0 && r.face < 2) sum += perimeter(r);
    EXPECT_NEAR(sum, 4 * 3 + 2 * std::hypot(1, kSlope) * (to - from), kLength) << x;
  }
}

/// Lengths drawn of the details, in the view from the front, by every method that draws their face.
TEST(Details, AreLinesOfTheirOwnClass) {
  const Scene scene = scene_named("details");
  // The bar hides z = 5 to 6: the sides of the first detail at x = 8 and x = 14 lose 1 each. Its bottom has length 6,
  // the notch 5 twice. The hole removes the part of the second detail between (2, 2) and (6, 6).
  const double first = 7 + 6 + 7 + 5 + 5, second = std::sqrt(8) + std::sqrt(20) + 4;
  double on_face = 0;
  for (const DetailLine& line : detail_lines(scene)) {
    EXPECT_EQ(line.face, 0u);
    on_face += glm::distance(line.ends[0], line.ends[1]);
  }
  EXPECT_NEAR(on_face, first + 2 + second, kLength);
  for (const Method* method : all_methods()) {
    if (!method->traits().exact || !method->traits().only_for.empty()) continue;
    PictureRequest request;
    request.view.named_view = "front";
    request.page.margin_mm = 0;
    request.page.scale = 1;
    request.lines.method = method;
    request.lines.classes.add(LineClass::detail);
    request.lines.quality = Quality::exact;
    RunReport run;
    const DrawnScene drawn = draw_lines(scene, request, run);
    double length = 0;
    const StrokeModel& strokes = *drawn.visibility().result.strokes;
    for (const Stroke& s : strokes.strokes)
      if (s.line_class == LineClass::detail)
        length += glm::distance(strokes.lattice.to_mm(s.from), strokes.lattice.to_mm(s.to));
    EXPECT_NEAR(length, first + second, kLength) << method->traits().name;
  }
}

}  // namespace
}  // namespace ligne
