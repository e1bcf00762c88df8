#include "scene/readers/folder_file.hpp"

#include <filesystem>
#include <string_view>

namespace ligne {

bool stays_in_folder(const std::string& path) {
  if (path.empty() || path.front() == '/' || path.find_first_of(std::string_view(":\\\0", 3)) != std::string::npos)
    return false;
  for (const std::filesystem::path& part : std::filesystem::path(path)) {
    if (part == "..") return false;
  }
  return true;
}

}  // namespace ligne
