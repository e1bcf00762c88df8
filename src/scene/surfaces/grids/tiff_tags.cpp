// The tags of GeoTIFF (OGC 19-008r4) that are read: the matrix, or the scale and the tie point, and the types of
// coordinates and of pixels; and those of GDAL: NODATA, and scale and offset of bands. The projection is not needed.

#include "scene/surfaces/grids/tiff_tags.hpp"

#ifdef LIGNE_HAVE_TIFF

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

#include <pugixml.hpp>

#include "files/message_text.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr std::uint32_t kScaleTag = 33550, kTiePointTag = 33922, kMatrixTag = 34264, kGeoKeysTag = 34735,
                        kMetadataTag = 42112, kNoDataTag = 42113;
constexpr std::uint16_t kModelType = 1024, kRasterType = 1025, kGeographic = 2, kPixelIsPoint = 2;

}  // namespace

tmsize_t TiffTags::Source::read(thandle_t handle, void* to, tmsize_t size) {
  auto* const self = static_cast<Source*>(handle);
  if (self->at >= self->bytes.size() || size <= 0) return 0;
  const std::size_t n = std::min<std::uint64_t>(static_cast<std::uint64_t>(size), self->bytes.size() - self->at);
  std::memcpy(to, self->bytes.data() + self->at, n);
  self->at += n;
  return static_cast<tmsize_t>(n);
}

toff_t TiffTags::Source::seek(thandle_t handle, toff_t offset, int whence) {
  auto* const self = static_cast<Source*>(handle);
  const std::uint64_t from = whence == SEEK_CUR ? self->at : whence == SEEK_END ? self->bytes.size() : 0;
  return self->at = from + offset;
}

int TiffTags::Source::on_error(TIFF*, void* self, const char*, const char* format, va_list arguments) {
  std::array<char, 160> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  std::string& message = static_cast<Source*>(self)->message;
  if (message.empty()) message = text.data();
  return 1;
}

TiffTags::TiffTags(std::span<const std::byte> bytes, const std::string& name) : source_{bytes, 0, {}}, name_(name) {
  TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, Source::on_error, &source_);
  TIFFOpenOptionsSetWarningHandlerExtR(options, Source::on_warning, &source_);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, kLargestTiffBlock);
  tiff_.reset(TIFFClientOpenExt(name.c_str(), "rm", &source_, Source::read, Source::write, Source::seek, Source::close,
                                Source::size, nullptr, nullptr, options));
  TIFFOpenOptionsFree(options);
  if (!tiff_) throw broken();
}

InputError TiffTags::broken() const {
  const std::string cause = source_.message.empty() ? "" : ": " + printable(source_.message);
  return InputError(name_, "is a TIFF file that can not be read" + cause);
}

std::uint16_t TiffTags::number(std::uint32_t tag, std::uint16_t otherwise) const {
  std::uint16_t found = otherwise;
  return TIFFGetFieldDefaulted(file(), tag, &found) == 1 ? found : otherwise;
}

std::uint32_t TiffTags::long_number(std::uint32_t tag) const {
  std::uint32_t found = 0;
  return TIFFGetFieldDefaulted(file(), tag, &found) == 1 ? found : 0;
}

/// The values of a tag unknown to libtiff, which gives a count and a block of values.
template <class Number>
std::vector<Number> TiffTags::values(std::uint32_t tag, TIFFDataType type) const {
  const TIFFField* const field = TIFFFindField(file(), tag, TIFF_ANY);
  if (!field || TIFFFieldDataType(field) != type || !TIFFFieldPassCount(field)) return {};
  void* data = nullptr;
  std::size_t count = 0;
  if (TIFFFieldReadCount(field) == TIFF_VARIABLE2) {
    std::uint32_t found = 0;
    if (TIFFGetField(file(), tag, &found, &data) != 1) return {};
    count = found;
  } else {
    std::uint16_t found = 0;
    if (TIFFGetField(file(), tag, &found, &data) != 1) return {};
    count = found;
  }
  std::vector<Number> out(count);
  if (count > 0) std::memcpy(out.data(), data, count * sizeof(Number));
  return out;
}

std::vector<double> TiffTags::doubles(std::uint32_t tag) const {
  std::vector<double> all = values<double>(tag, TIFF_DOUBLE);
  const bool finite = std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v); });
  return finite ? all : std::vector<double>{};
}

std::string TiffTags::text(std::uint32_t tag) const {
  const std::vector<char> all = values<char>(tag, TIFF_ASCII);
  return {all.begin(), std::find(all.begin(), all.end(), '\0')};
}

/// The short value of a key of the GeoTIFF directory, or 0.
std::uint16_t TiffTags::geo_key(std::uint16_t key) const {
  const std::vector<std::uint16_t> keys = values<std::uint16_t>(kGeoKeysTag, TIFF_SHORT);
  for (std::size_t k = 4; k + 3 < keys.size(); k += 4) {
    if (keys[k] == key && keys[k + 1] == 0) return keys[k + 3];
  }
  return 0;
}

std::optional<double> TiffTags::no_data() const { return number_in(trimmed(text(kNoDataTag))); }

BandScale TiffTags::scale_of(unsigned band) const {
  BandScale found;
  const std::string metadata = text(kMetadataTag);
  pugi::xml_document document;
  if (!document.load_buffer(metadata.data(), metadata.size())) return found;
  for (const pugi::xml_node& item : document.child("GDALMetadata").children("Item")) {
    if (item.attribute("sample").as_uint() != band) continue;
    const std::string_view role = item.attribute("role").value();
    const std::optional<double> number = number_in(trimmed(item.child_value()));
    if (!number || !std::isfinite(*number)) continue;
    if (role == "scale" && *number != 0) found.scale = *number;
    if (role == "offset") found.offset = *number;
  }
  return found;
}

std::optional<RasterTransform> TiffTags::transform() const {
  const std::vector<double> scale = doubles(kScaleTag), tie = doubles(kTiePointTag), matrix = doubles(kMatrixTag);
  RasterTransform transform;
  transform.sample_at = geo_key(kRasterType) == kPixelIsPoint ? 0 : 0.5;
  if (scale.size() >= 2 && tie.size() >= 6 && scale[0] != 0 && scale[1] != 0) {
    transform.pixel = {tie[0], tie[1]};
    transform.at = {tie[3], tie[4]};
    transform.per_column = {scale[0], 0};
    transform.per_row = {0, -std::abs(scale[1])};  // as in GDAL, rows run south whatever the sign
    return transform;
  }
  constexpr std::size_t kMatrixSize = 16;  // four rows; the first two are those of x and y
  if (matrix.size() < kMatrixSize) return std::nullopt;
  transform.at = {matrix[3], matrix[7]};
  transform.per_column = {matrix[0], matrix[4]};
  transform.per_row = {matrix[1], matrix[5]};
  return transform;
}

std::size_t TiffTags::control_points() const {
  constexpr std::size_t kNumbersOfPoint = 6;
  return transform() ? 0 : doubles(kTiePointTag).size() / kNumbersOfPoint;
}

std::optional<unsigned> TiffTags::alpha_band(unsigned channels) const {
  std::uint16_t count = 0;
  std::uint16_t* kinds = nullptr;
  if (TIFFGetField(file(), TIFFTAG_EXTRASAMPLES, &count, &kinds) != 1 || count > channels) return std::nullopt;
  for (unsigned k = 0; k < count; ++k) {
    if (kinds[k] == EXTRASAMPLE_ASSOCALPHA || kinds[k] == EXTRASAMPLE_UNASSALPHA) return channels - count + k;
  }
  return std::nullopt;
}

bool TiffTags::is_geographic() const { return geo_key(kModelType) == kGeographic; }

}  // namespace ligne

#endif
