/// Tests of the readers that are written as text, in the folder scripts. A step is a kind of file, and its text: 3ds, asc,
/// obj, off, ply, stl, binary-stl, scene are read by their readers, "file.SUFFIX" as the command reads it, and "model FILE"
/// from the shared models, where they are; json is the text of a glTF; "gltf CHANGES" changes the unit square as glTF,
/// "triangle CHANGES" a triangle, both as gltf_builder.hpp has it, and "triangle@NAME@SECONDS" reads the file at a moment of
/// an animation; 3mf is the main part of such an archive; points and lines are files of those; grid, also
/// "grid:layout=matrix", "grid:set=1", "grid:using=1,2,4", "grid:band=2", or "grid@NAME" for a file of this name; "tiff
/// PICTURES", see tiff_text.hpp, also "tiff:band=2"; "corpus FILE", a grid of the fuzzers' corpus, "corpus tiff/FILE" or
/// "corpus shared/FILE", a shared model; formula; "file NAME TEXT" writes a file beside those that are read; "subdivided" is
/// an OBJ that is subdivided three times; clean, merge, heal, append and "weld:DISTANCE" are small scenes that are mended,
/// see mended_scene.hpp; "detect.SUFFIX" tells the format. Behind "bin-", as in "bin-3ds", the text is of a binary file: see
/// binary_text.hpp. A scene that is read is sound: see expect_sound. Checks:
///
///     fails MESSAGE; begins MESSAGE; has TEXT    the whole error, its beginning, a part of it
///     is NAME                                    the format that is detected, or why there is none
///     /POINTER = JSON                            of the scene as JSON: as_json below
///     bounds X Y Z X Y Z                         of a scene, to four decimals
///     vertex X Y Z                               one of the vertices, to 1e-12
///     points X Y Z X Y Z ...; near X Y Z ...     the vertices of a scene, to 1e-12; to the precision of float32
///     x 0 1 2; y 0 1; z 1 2; nan 4               positions and rows of heights of a grid
///     height COLUMN ROW Z                        one of them
///     size COLUMNS ROWS HOLES; range LOW HIGH    their number; the heights but for a twentieth; corner X Y, the least
///     unit degrees                               of a grid's positions
///     mesh COLUMNS ROWS; point N X Y Z           of the grid's mesh
///     surfaces N                                 in the file
///     omits LIST; warns N KIND; lacks KIND; kinds N; notes TEXT   warnings; their kinds; a part of one. A grid whose checks
///                                                have none of these gives none
///     at X Y VALUE                               the value of a formula

#include "binary_text.hpp"
#include "gltf_builder.hpp"
#include "height_tools.hpp"
#include "mended_scene.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/surfaces/grids/point_table.hpp"
#include "tiff_text.hpp"
#include "zip_builder.hpp"

namespace ligne::height_test {
namespace {

using namespace reader_test;
using test::take_word;

#ifdef LIGNE_HAVE_TIFF
constexpr bool kReadsTiff = true;
#else
constexpr bool kReadsTiff = false;
#endif

json triple(const Point3& p) { return {p.x, p.y, p.z}; }

/// A scene as JSON: of faces all contours, of objects the ranges of vertices and faces.
json as_json(const Scene& scene, const ReadReport& report) {
  json all{{"up", std::string(1, "xyz"[static_cast<int>(scene.up_axis)])}, {"material_of_face", scene.face_material}};
  all["stored"] = {{"faces", report.faces}, {"triangles", report.triangles}, {"vertices", report.vertices}};
  all["format"] = to_string(report.format);
  for (const std::filesystem::path& file : report.files) all["files"].push_back(file.filename().string());
  for (const Point3& p : scene.vertices) all["vertices"].push_back(triple(p));
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    json face;
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      face.push_back(std::vector<std::uint32_t>(contour.begin(), contour.end()));
    }
    all["faces"].push_back(face);
  }
  for (const Object& o : scene.objects) {
    all["objects"].push_back({{"name", o.name},
                              {"vertices", {o.vertex_begin, o.vertex_end}},
                              {"faces", {o.face_begin, o.face_end}},
                              {"precision", o.precision}});
  }
  for (const Material& m : scene.materials)
    all["materials"].push_back({{"name", m.name}, {"color", triple(m.color)}, {"opacity", m.opacity}});
  for (const Light& l : scene.lights)
    all["lights"].push_back({{"kind", l.kind == Light::Kind::point ? "point" : "parallel"}, {"vector", triple(l.vector)}});
  for (const SceneCamera& c : scene.cameras) {
    // Angles and directions are worked out.
    const auto rounded = [](double v) { return std::round(v * 1e9) / 1e9 + 0.0; };
    all["cameras"].push_back({{"forward", triple(c.forward)}, {"fov", rounded(c.fov_degrees)}});
    if (c.up) all["cameras"].back()["up"] = {rounded(c.up->x), rounded(c.up->y), rounded(c.up->z)};
  }
  for (const auto& detail : scene.details) {
    all["details"].push_back({{"face", detail.face}, {"material", detail.material}});
    for (const Point3& p : detail.contour) all["details"].back()["contour"].push_back(triple(p));
  }
  all["hidden_edges"] = std::count(scene.corner_flags.begin(), scene.corner_flags.end(), kCornerFileHidden);
  all["flags"] = json(std::vector<int>(scene.corner_flags.begin(), scene.corner_flags.end()));
  for (const char* list : {"vertices", "faces", "objects", "materials", "lights", "details"})
    all["number"][list] = all.contains(list) ? all[list].size() : 0;
  return all;
}

/// NaN is equal to NaN.
void expect_equal(double found, double wanted) {
  EXPECT_TRUE(found == wanted || (std::isnan(found) && std::isnan(wanted))) << found << ", not " << wanted;
}

std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string& word : test::words_of(text)) numbers.push_back(word == "nan" ? kNaN : test::value_of(word));
  return numbers;
}

class ReaderScript {
 public:
  ReaderScript(const std::string& kind, std::string_view text, const std::filesystem::path& folder)
      : kind_(kind.starts_with("bin-") ? kind.substr(4) : kind),
        text_(kind_.starts_with("tiff") ? tiff_of(text)
              : kind_ == kind           ? test::unescaped(text)
                                        : test::binary_of(text)),
        folder_(folder) {
    error_ = error_line([&] { read(); });
    if (error_ == "no error") error_.clear();
  }

  void check(const std::string& check) const {
    std::string_view rest = check;
    const std::string verb = take_word(rest), wanted = test::unescaped(rest);
    if (verb == "fails") {
      EXPECT_EQ(error_, wanted);
    } else if (verb == "begins") {
      EXPECT_TRUE(error_.starts_with(wanted)) << error_;
    } else if (verb == "has") {
      test::expect_parts(error_, {wanted});
    } else if (verb == "is") {
      EXPECT_EQ(format_.empty() ? error_ : format_, wanted);
    } else if (verb == "at") {
      check_value(numbers_of(rest));
    } else if (verb.starts_with("/")) {
      take_word(rest);
      EXPECT_EQ(json_.at(json::json_pointer(verb)), json::parse(rest)) << error_;
    } else if (verb == "bounds") {
      const std::vector<double> b = numbers_of(rest);
      expect_bounds(scene_, {b.at(0), b.at(1), b.at(2)}, {b.at(3), b.at(4), b.at(5)});
    } else if (verb == "vertex") {
      const std::vector<double> n = numbers_of(rest);
      EXPECT_TRUE(std::ranges::any_of(
          scene_.vertices, [&](const Point3& p) { return glm::distance(p, Point3(n.at(0), n.at(1), n.at(2))) < 1e-12; }));
    } else if (verb == "points" || verb == "near") {
      check_points(numbers_of(rest), verb == "points" ? 1e-12 : 1e-7);
    } else if (verb == "omits") {
      EXPECT_EQ(warnings_.left_out().text(), wanted == "nothing" ? "" : wanted);
    } else if (verb == "warns") {
      EXPECT_EQ(warnings_.counts().at(wanted.substr(wanted.find(' ') + 1)), std::stoul(wanted));
    } else if (verb == "lacks") {
      EXPECT_FALSE(warnings_.counts().contains(wanted));
    } else if (verb == "notes") {
      EXPECT_TRUE(std::ranges::any_of(warnings_.lines(), [&](const std::string& line) {
        return line.find(wanted) != line.npos;
      })) << testing::PrintToString(warnings_.lines());
    } else if (verb == "kinds") {
      EXPECT_EQ(warnings_.lines().size(), std::stoul(wanted)) << testing::PrintToString(warnings_.lines());
    } else {
      check_grid(verb, wanted);
    }
  }

  /// A file that is not read is one whose checks name an error; and a grid that is warned of, or a merged scene, one whose
  /// checks name warnings.
  void expect_all_is_meant(const std::vector<std::string>& checks) const {
    static const std::set<std::string> errors{"fails", "begins", "has", "is"}, warnings{"omits", "warns", "kinds", "notes"};
    const auto has_one_of = [&](const std::set<std::string>& verbs) {
      return std::ranges::any_of(checks, [&](const std::string& c) { return verbs.contains(c.substr(0, c.find(' '))); });
    };
    EXPECT_TRUE(error_.empty() || has_one_of(errors)) << error_;
    EXPECT_TRUE(!(is_grid() || kind_ == "merge") || !error_.empty() || warnings_.lines().empty() || has_one_of(warnings))
        << testing::PrintToString(warnings_.lines());
  }

 private:
  void read() {
    const auto bytes = bytes_of(text_);
    const bool is_file = kind_.starts_with("file.");
    ReadReport report;
    if (kind_ == "asc") scene_ = read_asc({{bytes, "M"}, report, warnings_});
    if (kind_ == "obj") scene_ = read_obj({{bytes, "M", folder_}, report, warnings_});
    if (kind_ == "subdivided") {
      const ReadOptions options{.shading = true, .subdivision = Subdivision{SubdivisionScheme::catmull_clark, 3}};
      scene_ = read_scene({bytes, "M"}, ModelFormat::obj, options, warnings_, &report);
    }
    if (kind_ == "off") scene_ = read_off({{bytes, "M"}, report, warnings_});
    if (kind_ == "ply") scene_ = read_ply({{bytes, "M"}, report, warnings_});
    if (kind_ == "stl") scene_ = read_stl_ascii({{bytes, "M"}, report, warnings_});
    if (kind_ == "binary-stl") scene_ = read_stl_binary({{bytes, "M"}, report, warnings_});
    FileShading shading;
    if (kind_ == "3ds") scene_ = read_3ds({{bytes, "M"}, report, warnings_, &shading});
    if (kind_ == "scene") scene_ = read_ligne_scene({{bytes, "M"}, report, warnings_});
    if (kind_ == "gltf" || kind_.starts_with("triangle")) {
      const std::string text = gltf_test::changed(kind_ == "gltf" ? gltf_test::square() : gltf_test::triangle(), text_);
      scene_ = read_gltf({{bytes_of(text), "M", folder_}, report, warnings_, nullptr, nullptr, false, pose()}, false);
    }
    if (kind_ == "3mf") {
      const std::string archive = zip_test::three_mf(text_);
      scene_ = read_three_mf({{bytes_of(archive), "M"}, report, warnings_});
    }
    if (kind_ == "json") scene_ = read_gltf({{bytes, "M"}, report, warnings_}, false);
    if (is_file) scene_ = read_scene({bytes, "M"}, detect_format(bytes, kind_.substr(4), "M"), {}, warnings_, &report);
    if (kind_ == "model") scene_ = read_scene(LIGNE_MODELS_DIR "/" + text_, {}, warnings_, &report);
    if (is_grid()) {
      const std::string file = kind_ == "corpus" ? corpus_file(text_) : text_;
      const std::string name = kind_.starts_with("grid@") ? kind_.substr(5) : "M";
      surfaces_ = read_surfaces(bytes_of(file), name, warnings_, {}, nullptr, choice());
    }
    if (kind_ == "points" || kind_ == "lines") read_places();
    if (kind_ == "formula") formula_heights(text_, {0, 1}, {0, 1});
    if (kind_.starts_with("detect")) format_ = to_string(detect_format(bytes, kind_.substr(6), "M"));
    const bool is_mended =
        kind_ == "clean" || kind_ == "merge" || kind_ == "heal" || kind_ == "append" || kind_.starts_with("weld:");
    if (kind_ == "heal") scene_ = small_scene(json::parse(text_));
    const json healing = kind_ == "heal" ? healed(scene_, warnings_) : json();
    if (is_mended && kind_ != "heal") scene_ = mended(kind_, text_, warnings_);
    if (scene_.faces.empty() && !is_mended) return;
    if (!is_mended || kind_ == "append") expect_sound(scene_, text_.find("KHR_mesh_quantization") != std::string::npos);
    json_ = as_json(scene_, report);
    if (is_mended) add_contours(scene_, json_);
    json_["healed"] = healing;
    json_["sharp_edges"] = report.subdivision.sharp_edges;
    json_["smoothing"] = {{"groups", shading.face_groups}, {"bits", shading.groups_are_bits}};
  }

  /// Points with their names, or lines, of a file M.
  void read_places() {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("M", text_).string();
    InputFiles opened;
    const auto place = [](const Point3& p) { return json{p.x, p.y, std::isnan(p.z) ? json() : json(p.z)}; };
    const std::string error = error_line([&] {
      json_ = {{"points", json::array()}, {"lines", json::array()}};
      if (kind_ == "lines") {
        for (const std::vector<Point3>& line : read_lines(file, opened, warnings_)) {
          json_["lines"].push_back(json::array());
          for (const Point3& p : line) json_["lines"].back().push_back(place(p));
        }
      } else {
        for (const LabelledPoint& point : read_points(file, opened, warnings_)) {
          json_["points"].push_back(place(point.at));
          json_["points"].back().push_back(point.label);
        }
      }
    });
    if (error != "no error") throw InputError("M" + error.substr(file.size()));
  }

  std::optional<ScenePose> pose() const {
    const std::size_t name = kind_.find('@'), seconds = kind_.rfind('@');
    if (name == kind_.npos) return {};
    return ScenePose{kind_.substr(name + 1, seconds - name - 1), std::stod(kind_.substr(seconds + 1))};
  }

  void check_points(const std::vector<double>& wanted, double tolerance) const {
    ASSERT_EQ(3 * scene_.vertices.size(), wanted.size()) << error_;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      EXPECT_NEAR(scene_.vertices[i / 3][static_cast<int>(i % 3)], wanted[i], tolerance) << "vertex " << i / 3;
  }

  void check_value(const std::vector<double>& x_y_value) const {
    const double x = x_y_value.at(0), y = x_y_value.at(1), wanted = x_y_value.at(2);
    const double found = heights_of(*formula_heights(text_, {x, x + 1}, {y, y + 1}))[0][0];
    expect_equal(found, wanted);
  }

  bool is_grid() const { return kind_ == "corpus" || kind_.starts_with("grid") || kind_.starts_with("tiff"); }

  GridChoice choice() const {
    static const std::map<std::string, TableLayout> layouts{
        {"matrix", TableLayout::matrix}, {"series", TableLayout::series}, {"frame", TableLayout::frame}};
    GridChoice choice;
    const std::size_t equals = kind_.find('=');
    if (equals == kind_.npos) return choice;
    const std::string what = kind_.substr(5, equals - 5), value = kind_.substr(equals + 1);
    if (what == "layout") choice.layout = layouts.at(value);
    if (what == "band") choice.band = static_cast<unsigned>(std::stoul(value));
    if (what == "set") choice.data_set = static_cast<unsigned>(std::stoul(value));
    std::istringstream names(what == "using" ? value : "");
    for (std::string name; std::getline(names, name, ',');) choice.using_columns.push_back(name);
    return choice;
  }

  void check_grid(const std::string& verb, const std::string& wanted) const {
    ASSERT_FALSE(surfaces_.empty()) << error_;
    const auto& [heights, mesh] = std::tie(surfaces_[0].heights, surfaces_[0].mesh);
    if (verb == "surfaces") {
      EXPECT_EQ(surfaces_.size(), std::stoul(wanted));
      return;
    }
    if (verb == "mesh" || verb == "point") {
      ASSERT_TRUE(mesh);
      const std::vector<double> n = numbers_of(wanted);
      if (verb == "mesh") {
        EXPECT_TRUE(mesh->parametric && mesh->columns == n.at(0) && mesh->rows == n.at(1));
      } else {
        for (int k = 0; k < 3; ++k)
          expect_equal(mesh->points.at(static_cast<std::size_t>(n[0]))[k], n.at(1 + std::size_t(k)));
      }
      return;
    }
    ASSERT_TRUE(heights);
    if (verb == "unit") {
      EXPECT_EQ(heights->unit() == GroundUnit::degrees, wanted == "degrees");
    } else if (verb == "x") {
      EXPECT_EQ(heights->x(), numbers_of(wanted));
    } else if (verb == "y") {
      EXPECT_EQ(heights->y(), numbers_of(wanted));
    } else if (verb == "corner") {
      EXPECT_EQ((std::vector{heights->x().front(), heights->y().front()}), numbers_of(wanted));
    } else if (verb == "size" || verb == "range") {
      const std::vector<double> n = numbers_of(wanted);
      double low = 1e300, high = -1e300, holes = 0;
      for (const std::vector<double>& row : heights_of(*heights))
        for (const double z : row) low = std::fmin(low, z), high = std::fmax(high, z), holes += std::isnan(z);
      EXPECT_TRUE(verb == "range" || (heights->x().size() == n.at(0) && heights->y().size() == n.at(1) && holes == n.at(2)))
          << heights->x().size() << " x " << heights->y().size() << ", holes: " << holes;
      EXPECT_TRUE(verb == "size" || (std::abs(low - n.at(0)) <= 0.05 && std::abs(high - n.at(1)) <= 0.05))
          << low << " " << high;
    } else if (verb == "height") {
      const std::vector<double> n = numbers_of(wanted);
      expect_equal(heights_of(*heights).at(std::size_t(n.at(1))).at(std::size_t(n.at(0))), n.at(2));
    } else if (verb == "z") {
      std::vector<std::vector<double>> rows;
      std::istringstream lines(wanted);
      for (std::string line; std::getline(lines, line, ';');) rows.push_back(numbers_of(line));
      expect_grid(*heights, heights->x(), heights->y(), rows);
    } else {
      ADD_FAILURE() << "no check: " << verb;
    }
  }

  std::string kind_, text_, error_, format_;
  std::filesystem::path folder_;
  Warnings warnings_;
  Scene scene_;
  json json_;
  std::vector<GridSurface> surfaces_;
};

[[maybe_unused]] const bool scripts_are_added =
    test::add_scripts(LIGNE_SOURCE_DIR "/tests/scene/scripts", [](const test::Script& script) {
      const test::TemporaryFolder folder;
      for (const test::ScriptStep& step : script.steps) {
        SCOPED_TRACE(step.place + ": " + step.line);
        std::string_view text = step.line;
        const std::string kind = take_word(text);
        if (kind == "model" && !std::filesystem::is_directory(LIGNE_MODELS_DIR)) continue;
        if (text.starts_with("shared/") && !std::filesystem::is_directory(LIGNE_MODELS_DIR)) continue;
        if (!kReadsTiff && (kind.starts_with("tiff") || text.starts_with("tiff/") || text.ends_with(".tif"))) continue;
        if (kind == "file") {
          const std::string name = test::unescaped(take_word(text));
          folder.write(name, test::unescaped(text));
          continue;
        }
        const ReaderScript reader(kind, text, folder);
        for (const std::string& check : step.checks) reader.check(check);
        reader.expect_all_is_meant(step.checks);
      }
    });

}  // namespace
}  // namespace ligne::height_test
