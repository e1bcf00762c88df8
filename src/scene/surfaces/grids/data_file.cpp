#include "scene/surfaces/grids/data_file.hpp"

#include <algorithm>
#include <array>

#include "scene/readers/reader.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"

namespace ligne {
namespace {

/// Number of bytes at the beginning that are searched for bytes that no text has, and for the keys of models.
constexpr std::size_t kDetectionBytes = 65536;

#ifdef LIGNE_HAVE_GDAL
constexpr bool kHasGdal = true;
#else
constexpr bool kHasGdal = false;
#endif

bool is_tiff(std::string_view chars) {
  static constexpr std::array<std::string_view, 4> kMarks{std::string_view("II*\0", 4), std::string_view("MM\0*", 4),
                                                          std::string_view("II+\0", 4), std::string_view("MM\0+", 4)};
  return std::any_of(kMarks.begin(), kMarks.end(), [&](std::string_view mark) { return chars.starts_with(mark); });
}

}  // namespace

char netpbm_kind(std::string_view chars) {
  const bool is_netpbm = chars.size() >= 3 && chars[0] == 'P' && chars[1] >= '1' && chars[1] <= '7' &&
                         (is_blank(chars[2]) || chars[2] == '\n' || chars[2] == '\r' || chars[2] == '#');
  return is_netpbm ? chars[1] : '\0';
}

bool is_for_gdal(std::string_view chars) { return is_tiff(chars) || (kHasGdal && chars.starts_with("\x89HDF")); }

std::optional<std::string> raster_name(std::string_view chars, const std::string& name) {
  if (chars.starts_with("\x89PNG")) return "a PNG picture";
  if (netpbm_kind(chars) != '\0') return "a Netpbm picture";
  if (is_tiff(chars)) return "a TIFF raster";
  if (is_hgt_name(name)) return "a tile of SRTM heights";
  if (is_surfer_grid(chars)) return "a grid of Surfer";
  if (is_esri_grid(chars)) return "an ESRI ASCII grid";
  return {};
}

bool may_be_text(std::string_view chars) {
  const bool is_utf16 = chars.starts_with("\xFF\xFE") || chars.starts_with("\xFE\xFF");
  return is_utf16 || chars.substr(0, kDetectionBytes).find('\0') == std::string_view::npos;
}

void refuse_models(std::span<const std::byte> bytes, const std::string& name, const std::string& wanted) {
  std::string format;
  try {
    format = to_string(detect_format(bytes, "", name));
  } catch (const InputError&) {
    return;  // not a model
  }
  throw InputError(name, "is a model (" + format + "), not " + wanted + "; draw it with: ligne draw");
}

std::optional<std::vector<DataArray>> read_arrays(std::span<const std::byte> bytes, const std::string& name,
                                                  std::size_t layer, const std::string& wanted, Warnings& warnings,
                                                  std::vector<TextColumn>* texts) {
  const std::string_view chars = as_characters(bytes);
  if (is_npy(chars)) return std::vector<DataArray>{read_npy(bytes, name)};
  if (chars.starts_with("PK\x03\x04")) return read_npz(bytes, name, warnings);  // other archives have been unpacked
  if (is_classic_netcdf(chars)) return read_netcdf(bytes, name, layer);
  if (is_matlab(chars)) return read_matlab(bytes, name, warnings);
  if (may_be_text_arrays(chars)) return read_text_arrays(chars, name);
  if (!may_be_json(chars)) return {};
  // Models in JSON have keys of their own.
  const std::string_view beginning = chars.substr(0, kDetectionBytes);
  for (const std::string_view key : {"\"asset\"", "\"format\""}) {
    if (beginning.find(key) != std::string_view::npos) refuse_models(bytes, name, wanted);
  }
  return read_json_arrays(bytes, name, warnings, texts);
}

}  // namespace ligne
