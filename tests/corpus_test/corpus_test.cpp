// The corpus of scenes: every file reads, is about something, and is degenerate only where it says so.

#include <cctype>
#include <nlohmann/json.hpp>

#include "scene/readers/reader.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using nlohmann::json;

constexpr char kOnPurpose[] = "Degenerate on purpose";
constexpr std::size_t kFewestScenes = 60;

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

json load(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return json::parse(in);
}

bool degenerate_on_purpose(const json& scene) { return scene.at("about").get<std::string>().ends_with(kOnPurpose); }

TEST(Corpus, NamesAreUniqueInEveryCase) {
  std::set<std::string> names;
  for (const auto& file : corpus()) {
    std::string name = file.stem().string();
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), name.npos) << name;
  }
  EXPECT_GE(names.size(), kFewestScenes);
}

TEST(Corpus, EverySceneSaysWhatItIsAbout) {
  std::map<std::string, std::string> scene_about;
  for (const auto& file : corpus()) {
    SCOPED_TRACE(file.filename().string());
    const json scene = load(file);
    ASSERT_TRUE(scene.contains("about"));
    const auto about = scene["about"].get<std::string>();
    EXPECT_GE(about.size(), 10u);
    EXPECT_EQ(about.find('\n'), about.npos) << "more than one line";
    const auto [other, is_new] = scene_about.emplace(about, file.stem().string());
    EXPECT_TRUE(is_new) << "the same as " << other->second;
  }
}

TEST(Corpus, EverySceneReadsWithoutAWarning) {
  std::size_t with_warnings = 0;
  for (const auto& file : corpus()) {
    SCOPED_TRACE(file.filename().string());
    Warnings warnings;
    ReadReport report;
    Scene scene;
    ASSERT_NO_THROW(scene = read_scene(file, {}, warnings, &report));
    EXPECT_EQ(report.format, ModelFormat::ligne_scene);
    EXPECT_GE(scene.faces.size(), 1u);
    with_warnings += !warnings.counts().empty();
    const json source = load(file);
    if (degenerate_on_purpose(source)) continue;
    for (const auto& [kind, count] : warnings.counts()) ADD_FAILURE() << count << " " << kind;
    EXPECT_EQ(scene.faces.size(), report.faces);
    EXPECT_EQ(scene.objects.size(), source.at("objects").size());
  }
  EXPECT_GE(with_warnings, 2u) << "the scenes that are to warn";
}

// Directed edges of an object's faces, and how often each stands.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(const Scene& scene, const Object& object) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::uint32_t f = object.face_begin; f < object.face_end; ++f)
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const auto contour = scene.faces.contour(f, c);
      for (std::size_t k = 0; k < contour.size(); ++k) ++edges[{contour[k], contour[(k + 1) % contour.size()]}];
    }
  return edges;
}

bool is_closed(const Scene& scene, const Object& object) {
  const auto edges = directed_edges(scene, object);
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

// A few by name, so that a reader or a script that gets winding or holes wrong fails here too.
TEST(Corpus, SolidsAreClosedAndSurfacesAreOpen) {
  const std::map<std::string, bool> expected{
      {"cube", true},           {"tunnel", true},          {"gear", true},      {"torus", true},
      {"low_sphere", true},     {"pocket", true},          {"letter_e", true},  {"window_frames", true},
      {"grid_3", true},         {"inside_out_cube", true}, {"open_box", false}, {"mixed_winding", false},
      {"moebius_strip", false}, {"one_triangle", false},   {"book_four", false}};
  for (const auto& [name, closed] : expected) {
    SCOPED_TRACE(name);
    Warnings warnings;
    Scene scene;
    ASSERT_NO_THROW(
        scene = read_scene(std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus" / (name + ".json"), {}, warnings));
    for (const Object& object : scene.objects) EXPECT_EQ(is_closed(scene, object), closed) << object.name;
  }
}

}  // namespace
}  // namespace ligne
