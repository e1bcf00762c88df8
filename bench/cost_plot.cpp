/// Cost of two methods against the number of faces, as an SVG plot: ligne_cost_plot OUT.svg [METHOD METHOD]. Default:
/// warnock appel.
///
/// Torus knots of 1 k to 262 k triangles in the isometric view on A4. Processor time of one study in one thread, the least
/// of a few.

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "inputs.hpp"
#include "plotting/page.hpp"
#include "scene/clean/clean.hpp"
#include "scene/model/topology.hpp"
#include "view/projected_scene.hpp"
#include "view/view.hpp"
#include "visibility/registry.hpp"

namespace {

using namespace ligne;

constexpr int kRuns = 5;

struct Curve {
  std::string name;
  std::string style;
  std::vector<double> faces, seconds;
};

Scene scene_of(const bench::TriangleMesh& mesh) {
  Scene scene;
  for (const bench::Vec3& p : mesh.positions) scene.vertices.push_back({p[0], p[1], p[2]});
  for (const bench::Corner3& t : mesh.triangles) scene.faces.add_triangle(t[0], t[1], t[2]);
  Object object;
  object.vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  object.face_end = static_cast<std::uint32_t>(scene.faces.size());
  scene.objects.push_back(object);
  Warnings warnings;
  finish_scene(scene, warnings);
  return scene;
}

double seconds_of_study(const Method& method, const ProjectedScene& scene) {
  VisibilityOptions options;
  options.wanted = kStrokes;
  double least = 1e300;
  for (int i = 0; i < kRuns; ++i) {
    const std::clock_t start = std::clock();
    method.compute_visibility(scene, options);
    least = std::min(least, double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

/// Log-log, one decade of faces as wide as one of seconds is high.
class Plot {
 public:
  std::string svg(const std::vector<Curve>& curves) {
    text_ =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"520\" viewBox=\"0 0 640 520\" font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"640\" height=\"520\" fill=\"#fff\"/>\n";
    for (int decade = 3; decade <= 5; ++decade) {
      const double v = std::pow(10.0, decade);
      line(v, kLowS, v, kHighS, "stroke=\"#ccc\"");
      label(x(v), kBottom + 18, "middle", decade == 3 ? "1 k" : decade == 4 ? "10 k" : "100 k");
    }
    const char* const names[] = {"0.1 ms", "1 ms", "10 ms", "100 ms", "1 s"};
    for (int decade = -4; decade <= 0; ++decade) {
      const double v = std::pow(10.0, decade);
      line(kLowN, v, kHighN, v, "stroke=\"#ccc\"");
      label(kLeft - 8, y(v) + 4, "end", names[decade + 4]);
    }
    label((kLeft + kRight) / 2, kBottom + 40, "middle", "triangles");
    label(kLeft, kTop - 12, "start", "processor time of the study");
    // N log N through the first point of the first curve.
    const double n0 = curves[0].faces.front(), s0 = curves[0].seconds.front();
    text_ += "<path fill=\"none\" stroke=\"#888\" stroke-dasharray=\"2 4\" d=\"";
    for (const double n : curves[0].faces) point(n, s0 * n * std::log2(n) / (n0 * std::log2(n0)), n == n0);
    text_ += "\"/>\n";
    double row = kTop + 8;
    const auto legend = [&](const std::string& style, const std::string& name) {
      text_ +=
          "<path fill=\"none\" " + style + " d=\"M" + std::to_string(kLeft + 16) + " " + std::to_string(row) + "h36\"/>\n";
      label(kLeft + 60, row + 4, "start", name);
      row += 20;
    };
    for (const Curve& c : curves) {
      text_ += "<path fill=\"none\" " + c.style + " d=\"";
      for (std::size_t i = 0; i < c.faces.size(); ++i) point(c.faces[i], c.seconds[i], i == 0);
      text_ += "\"/>\n";
      legend(c.style, c.name);
    }
    legend("stroke=\"#888\" stroke-dasharray=\"2 4\"", "N log N");
    return text_ + "</svg>\n";
  }

 private:
  static constexpr double kLeft = 80, kRight = 620, kTop = 40, kBottom = 460;
  static constexpr double kLowN = 800, kHighN = 400e3, kLowS = 1e-4, kHighS = 3;

  static double x(double n) { return kLeft + (kRight - kLeft) * std::log(n / kLowN) / std::log(kHighN / kLowN); }
  static double y(double s) { return kBottom - (kBottom - kTop) * std::log(s / kLowS) / std::log(kHighS / kLowS); }
  static std::string number(double v) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1f", v);
    return buffer;
  }
  void point(double n, double s, bool first) { text_ += (first ? "M" : "L") + number(x(n)) + " " + number(y(s)); }
  void line(double n0, double s0, double n1, double s1, const std::string& style) {
    text_ += "<path fill=\"none\" " + style + " d=\"";
    point(n0, s0, true);
    point(n1, s1, false);
    text_ += "\"/>\n";
  }
  void label(double px, double py, const char* anchor, const std::string& words) {
    text_ += "<text x=\"" + number(px) + "\" y=\"" + number(py) + "\" text-anchor=\"" + anchor + "\">" + words + "</text>\n";
  }

  std::string text_;
};

int run(const std::string& file, const std::array<const Method*, 2>& methods) {
  EdgeSelection feature, all;
  for (std::size_t i = 0; i < kLineClassCount; ++i) {
    const auto c = static_cast<LineClass>(i);
    if (c != LineClass::mesh) feature.classes.add(c);
    all.classes.add(c);
  }
  std::vector<Curve> curves;
  const char* const colours[] = {"#c22", "#228"};
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::string name(methods[m]->traits().name),
        stroke = std::string("stroke-width=\"2\" stroke=\"") + colours[m] + "\"";
    curves.push_back({name + ", all edges", stroke, {}, {}});
    curves.push_back({name + ", feature edges", stroke + " stroke-dasharray=\"7 3\"", {}, {}});
  }
  for (int bits = 10; bits <= 18; bits += 2) {  // triangles of one shape
    const bench::TriangleMesh mesh = bench::torus_knot((bits + 1) / 2, bits - 1 - (bits + 1) / 2);
    const Scene scene = scene_of(mesh);
    const Topology topology = build_topology(scene);
    const Page page;
    const View view = make_view(scene, make_camera({}, scene), {page.drawable()}, page.sheet());
    std::size_t curve = 0;
    for (const Method* method : methods) {
      for (const EdgeSelection& selection : {all, feature}) {
        const double s = seconds_of_study(*method, project(scene, topology, view, selection));
        curves[curve].faces.push_back(static_cast<double>(mesh.triangles.size()));
        curves[curve].seconds.push_back(s);
        std::printf("%zu triangles, %s: %.2f ms\n", mesh.triangles.size(), curves[curve].name.c_str(), s * 1e3);
        ++curve;
      }
    }
  }
  std::ofstream(file) << Plot().svg(curves);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::array<const Method*, 2> methods{find_method(argc > 3 ? argv[2] : "warnock"),
                                             find_method(argc > 3 ? argv[3] : "appel")};
  if (argc < 2 || !methods[0] || !methods[1]) {
    std::fputs("ligne_cost_plot OUT.svg [METHOD METHOD]\n", stderr);
    return 2;
  }
  int status = 0;
  run_with_threads(1, [&] { status = run(argv[1], methods); });
  return status;
}
