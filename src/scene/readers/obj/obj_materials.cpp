#include "scene/readers/obj/obj_materials.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "files/utf16.hpp"
#include "scene/readers/folder_file.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Words that change the shine of a material, which no line shows.
constexpr std::array<std::string_view, 18> kShine{"Ka", "Ks",  "Ke", "Ns", "Ni",    "Tf",     "illum", "sharpness", "Pr",
                                                  "Pm", "Pcr", "Pc", "Ps", "aniso", "anisor", "Pn",    "Km",        "Tm"};

class MtlReader {
 public:
  MtlReader(std::string_view text, const std::string& name, std::map<std::string, Material>& materials, Warnings& warnings)
      : lines_(text), name_(name), materials_(materials), warnings_(warnings) {}

  void read() {
    for (std::string_view line; lines_.next(line);) {
      std::string_view rest = trimmed(line);
      if (rest.empty() || rest[0] == '#') continue;
      const std::string_view keyword = take_word(rest);
      if (keyword == "newmtl") {
        begin(std::string(trimmed(without_comment(rest))));
      } else if (current_) {
        take(keyword, rest);
      }
    }
  }

 private:
  void begin(const std::string& name) {
    current_ = &materials_[name];
    *current_ = Material{name};
    has_d_ = false;
  }

  void take(std::string_view keyword, std::string_view rest) {
    if (keyword == "Kd") {
      read_color(rest);
    } else if (keyword == "d") {
      std::string_view word = take_word(rest);
      if (word == "-halo") word = take_word(rest);
      current_->opacity = number(word);
      has_d_ = true;
    } else if (keyword == "Tr") {
      // Some writers give both d and Tr, with different meanings of Tr, so d takes precedence.
      const double transparency = number(take_word(rest));
      // By itself, `Tr 1` would make a material that can not be seen. Writers of it mean an opaque one.
      if (!has_d_) current_->opacity = transparency < 1 ? 1 - transparency : 1;
    } else if (keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" || keyword == "decal" ||
               keyword == "refl" || keyword == "norm") {
      warnings_.leave_out("textures (" + std::string(keyword) + ")");
    } else if (std::ranges::find(kShine, keyword) == kShine.end()) {
      warnings_.leave_out("statements " + shown(keyword) + " of materials");
    }
  }

  void read_color(std::string_view rest) {
    std::string_view word = take_word(rest);
    if (word == "spectral" || word == "xyz") return warnings_.leave_out("colours (Kd " + std::string(word) + ")");
    Point3 color(number(word));
    // A single number applies to all three.
    for (int k = 1; k < 3; ++k) {
      word = take_word(rest);
      if (!word.empty()) color[k] = number(word);
    }
    current_->color = color;
  }

  double number(std::string_view word) const {
    const std::optional<double> value = number_in(word);
    if (!value) throw error_at_line(name_, lines_.number(), shown(word) + " is not a number of a material");
    return std::clamp(*value, 0.0, 1.0);
  }

  LineReader lines_;
  const std::string& name_;
  std::map<std::string, Material>& materials_;
  Warnings& warnings_;
  Material* current_ = nullptr;
  bool has_d_ = false;
};

/// The file of a library; names written under Windows may contain backslashes. Nothing if it is not a file in the
/// folder.
std::optional<std::filesystem::path> library_file(std::string library, const std::filesystem::path& folder) {
  std::ranges::replace(library, '\\', '/');
  if (library.starts_with("./")) library.erase(0, 2);
  std::error_code error;
  if (folder.empty() || !stays_in_folder(library)) return std::nullopt;
  const std::filesystem::path file = folder / library;
  return std::filesystem::is_regular_file(file, error) ? std::optional(file) : std::nullopt;
}

/// The libraries of one statement. Blanks separate their names, but a name may also contain blanks, with or without a
/// backslash before each.
std::vector<std::string> names_of(const std::string& statement, const std::filesystem::path& folder) {
  if (library_file(statement, folder)) return {statement};
  std::vector<std::string> names(1);
  std::string whole;
  for (std::size_t i = 0; i < statement.size(); ++i) {
    if (statement[i] == '\\' && i + 1 < statement.size() && is_blank(statement[i + 1])) {
      names.back() += statement[++i];
      whole += statement[i];
      continue;
    }
    whole += statement[i];
    if (!is_blank(statement[i])) {
      names.back() += statement[i];
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (library_file(whole, folder)) return {whole};
  std::erase(names, "");
  return names;
}

}  // namespace

void read_mtl(std::string_view text, const std::string& name, std::map<std::string, Material>& materials,
              Warnings& warnings) {
  MtlReader(text, name, materials, warnings).read();
}

void apply_libraries(const std::vector<std::string>& libraries, const std::filesystem::path& folder,
                     std::vector<Material>& materials, InputFiles& opened, Warnings& warnings) {
  std::map<std::string, Material> known;
  for (const std::string& statement : libraries) {
    for (const std::string& library : names_of(statement, folder)) {
      const std::optional<std::filesystem::path> file = library_file(library, folder);
      if (!file) {
        warnings.leave_out("missing libraries " + shown(library));
        continue;
      }
      const std::string name = file->string();
      const std::vector<std::byte> bytes = as_utf8(read_input(*file, name, opened));
      read_mtl(as_text(bytes, name), name, known, warnings);
    }
  }
  for (Material& material : materials) {
    if (const auto found = known.find(material.name); found != known.end()) material = found->second;
  }
}

}  // namespace ligne
