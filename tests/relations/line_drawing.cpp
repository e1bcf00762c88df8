#include "main/tier.hpp"
#include "relations/relations.hpp"
#include "scene/surfaces/mesh_writer.hpp"
#include "support/scenes.hpp"

namespace ligne::test {

PlainScene plain(const Scene& scene) {
  PlainScene result;
  result.up_axis = scene.up_axis;
  for (const Object& object : scene.objects) {
    PlainObject& o = result.objects.emplace_back();
    o.precision = object.precision;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      PlainFace& face = o.faces.emplace_back();
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        Contour& contour = face.contours.emplace_back();
        for (const std::uint32_t v : scene.faces.contour(f, c)) contour.push_back(scene.vertices[v]);
      }
    }
  }
  return result;
}

Scene to_scene(const PlainScene& plain) {
  Scene scene;
  scene.up_axis = plain.up_axis;
  for (const PlainObject& o : plain.objects) {
    Object object;
    object.precision = o.precision;
    object.vertex_begin = static_cast<std::uint32_t>(scene.vertices.size());
    object.face_begin = static_cast<std::uint32_t>(scene.faces.size());
    std::map<std::array<double, 3>, std::uint32_t> numbers;
    for (const PlainFace& face : o.faces)
      for (const Contour& contour : face.contours) {
        std::vector<std::uint32_t> corners;
        for (const Point3& p : contour) {
          const std::array<double, 3> key{p.x + 0.0, p.y + 0.0, p.z + 0.0};
          const auto [found, fresh] = numbers.emplace(key, static_cast<std::uint32_t>(scene.vertices.size()));
          if (fresh) scene.vertices.push_back(p);
          corners.push_back(found->second);
        }
        &contour == &face.contours.front() ? scene.faces.add_face(corners) : scene.faces.add_hole(corners);
      }
    object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
    object.face_end = static_cast<std::uint32_t>(scene.faces.size());
    scene.objects.push_back(object);
  }
  return scene;
}

namespace {

/// Parts of the lines of `a` that no line of `b` of the same class covers, but for parts up to `shortest_mm`; empty when
/// nothing.
std::string not_covered(const LineDrawing& a, const LineDrawing& b, double tolerance, double shortest_mm) {
  std::string text;
  for (const Line& line : a.lines) {
    std::vector<Range> covered;
    for (const Line& other : b.lines) {
      if (other.line_class != line.line_class) continue;
      if (const auto range = along(line.place, other.place, tolerance)) covered.push_back(*range);
    }
    for (const Range& gap : gaps(std::move(covered), 0, line.place.length())) {
      if (gap.length() <= std::max(tolerance, shortest_mm)) continue;
      const Point2 from = line.place.at(gap.from), to = line.place.at(gap.to);
      char buffer[160];
      std::snprintf(buffer, sizeof buffer, "    %s, page mm (%.5f, %.5f) - (%.5f, %.5f), %.6f mm long\n",
                    kLineClassNames[static_cast<std::size_t>(line.line_class)].data(), from.x, from.y, to.x, to.y,
                    gap.length());
      text += buffer;
    }
  }
  return text;
}

/// The view as options of `ligne draw`.
std::string options(const CameraRequest& camera) {
  std::string text;
  const auto add = [&](const char* name, const std::optional<Point3>& p) {
    if (!p) return;
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, " --%s=%.17g,%.17g,%.17g", name, p->x, p->y, p->z);
    text += buffer;
  };
  add("direction", camera.direction);
  add("eye", camera.eye);
  add("target", camera.target);
  add("up", camera.up);
  if (camera.eye) text += " --fov=" + std::to_string(camera.fov_degrees);
  return text;
}

}  // namespace

LineDrawing drawn(const Method& method, const Sight& sight) {
  const Picture picture =
      draw(to_scene(sight.scene), {sight.camera, "feature", false, 0, std::string(method.traits().name)});
  LineDrawing result;
  const Lattice& lattice = picture.model.lattice;
  for (const Stroke& s : picture.model.strokes)
    if (s.visible) result.lines.push_back({s.line_class, {lattice.to_mm(s.from), lattice.to_mm(s.to)}});
  result.tolerance_mm = coincidence_mm(picture.projected) + 2 * lattice.step_mm;
  return result;
}

LineDrawing mirror_image(LineDrawing drawing) {
  for (Line& line : drawing.lines) {
    line.place.from.x = kPageWidth - line.place.from.x;
    line.place.to.x = kPageWidth - line.place.to.x;
  }
  return drawing;
}

std::string differences(const LineDrawing& expected, const LineDrawing& found, double shortest_mm) {
  count_checks(Check::pairs);
  const double tolerance = std::max(expected.tolerance_mm, found.tolerance_mm);
  std::string text;
  const std::string missing = not_covered(expected, found, tolerance, shortest_mm);
  const std::string extra = not_covered(found, expected, tolerance, shortest_mm);
  if (!missing.empty()) text += "  no longer drawn:\n" + missing;
  if (!extra.empty()) text += "  newly drawn:\n" + extra;
  return text;
}

std::string command(const std::string& stem, const Sight& sight, const Method& method) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / ("ligne-" + stem + ".json");
  std::ofstream(file, std::ios::binary) << write_ligne_scene(to_scene(sight.scene));
  return "  ligne draw " + file.string() + options(sight.camera) + " --landscape --quality exact --method " +
         std::string(method.traits().name) + " -o " + stem + ".svg\n";
}

std::vector<const Method*> exact_methods() {
  std::vector<const Method*> methods;
  for (const Method* method : all_methods()) {
    const MethodTraits& traits = method->traits();
    if ((traits.products & kStrokes) && traits.exact && traits.only_for.empty()) methods.push_back(method);
  }
  return methods;
}

bool draws_well(const Method& method, const LineDrawing& drawing) {
  if (method.traits().penetration) return true;
  return std::none_of(drawing.lines.begin(), drawing.lines.end(),
                      [](const Line& line) { return line.line_class == LineClass::intersection; });
}

}  // namespace ligne::test
