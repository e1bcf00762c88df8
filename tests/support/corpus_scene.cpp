#include "support/corpus_scene.hpp"

#include "scene/readers/reader.hpp"

namespace ligne::test {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/corpus";

}  // namespace

std::vector<std::filesystem::path> corpus_files(std::uintmax_t most_bytes) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder))
    if (entry.path().extension() == ".json" && entry.file_size() <= most_bytes) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string family_of(const std::filesystem::path& file) {
  static const std::map<std::string, std::string> families = [] {
    std::map<std::string, std::string> by_name;
    std::ifstream in(kFolder / "families.txt");
    for (std::string name, family; in >> name >> family;) by_name[name] = family;
    return by_name;
  }();
  return families.at(file.stem().string());
}

std::size_t place_in_family(const std::filesystem::path& file) {
  static const std::map<std::string, std::size_t> places = [] {
    std::map<std::string, std::size_t> by_name, counts;
    for (const std::filesystem::path& each : corpus_files()) by_name[each.stem().string()] = counts[family_of(each)]++;
    return by_name;
  }();
  return places.at(file.stem().string());
}

Scene scene_of_file(const std::filesystem::path& file) {
  Warnings warnings;
  return read_scene(file, {}, warnings);
}

Scene corpus_scene(const std::string& name) { return scene_of_file(kFolder / (name + ".json")); }

}  // namespace ligne::test
