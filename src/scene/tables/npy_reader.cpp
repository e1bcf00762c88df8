// "\x93NUMPY", two bytes of version, the length of the header, and the header as the text of a Python dictionary.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scene/readers/load_bytes.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/readers/zip_archive.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {
namespace {

constexpr std::string_view kNpyMark = "\x93NUMPY";
constexpr std::size_t kMostDimensions = 32;

/// The text after a key of the header, to its end.
std::string_view value_behind(std::string_view header, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::size_t at = header.find(quote + std::string(key) + quote);
    if (at == std::string_view::npos) continue;
    const std::size_t colon = header.find(':', at);
    if (colon != std::string_view::npos) return trimmed(header.substr(colon + 1));
  }
  return {};
}

double half_to_double(std::uint16_t bits) {
  const int exponent = bits >> 10 & 0x1f, fraction = bits & 0x3ff;
  const double sign = (bits & 0x8000) != 0 ? -1 : 1;
  if (exponent == 0x1f) return std::numeric_limits<double>::quiet_NaN();
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  return sign * std::ldexp(fraction + 1024, exponent - 25);
}

struct NpyNumbers {
  std::optional<NumberType> type;  ///< nothing: floats of 16 bits
  std::endian order = std::endian::little;

  std::size_t bytes_each() const { return type ? byte_size(*type) : sizeof(std::uint16_t); }
  double value(const std::byte* at) const {
    return type ? load_number(at, *type, order) : half_to_double(load_bytes<std::uint16_t>(at, order));
  }
};

NpyNumbers npy_numbers(std::string_view header, const std::string& name) {
  std::string_view text = value_behind(header, "descr");
  if (text.starts_with('['))
    throw InputError(name, "is a numpy file of records; save one of their fields: numpy.save(FILE, a[\"z\"])");
  if (!text.empty()) text.remove_prefix(1);
  text = text.substr(0, text.find_first_of("'\""));
  NpyNumbers numbers;
  if (text.starts_with('>')) numbers.order = std::endian::big;
  if (!text.empty() && std::string_view("<>=|").find(text.front()) != std::string_view::npos) text.remove_prefix(1);
  const char kind = text.empty() ? '\0' : text.front();
  const auto bytes = static_cast<std::size_t>(parse_integer(text.substr(text.empty() ? 0 : 1)).value_or(0));
  if (kind == 'f') numbers.type = number_type(NumberKind::floating, bytes);
  if (kind == 'i') numbers.type = number_type(NumberKind::signed_integer, bytes);
  if (kind == 'u' || (kind == 'b' && bytes == 1)) numbers.type = number_type(NumberKind::unsigned_integer, bytes);
  const bool is_half = kind == 'f' && bytes == sizeof(std::uint16_t);
  if (!numbers.type && !is_half)
    throw InputError(name, "holds numpy's type " + shown(text) + "; heights are integers or floats of up to 64 bits");
  return numbers;
}

std::vector<std::size_t> npy_shape(std::string_view header, const std::string& name) {
  std::string_view text = value_behind(header, "shape");
  if (!text.starts_with('(')) throw InputError(name, "has no shape in its numpy header");
  text = text.substr(1, text.find(')') - 1);
  std::vector<std::size_t> shape;
  while (!trimmed(text).empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const std::optional<std::int64_t> size = parse_integer(trimmed(text.substr(0, comma)));
    if (!size || *size < 0 || shape.size() == kMostDimensions)
      throw InputError(name, "has a numpy shape that can not be read");
    shape.push_back(static_cast<std::size_t>(*size));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return shape;
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(kNpyMark); }

DataArray read_npy(std::span<const std::byte> bytes, const std::string& name) {
  constexpr std::size_t kLengthAt = 8;
  const auto truncated = [&] { return InputError(name, "is truncated: the numpy header ends early"); };
  if (bytes.size() < kLengthAt + 4) throw truncated();
  const auto version = std::to_integer<unsigned>(bytes[kNpyMark.size()]);
  if (version < 1 || version > 3)
    throw InputError(name, "is a numpy file of version " + std::to_string(version) + "; 1 to 3 are read");
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  const std::size_t length = version == 1 ? load_bytes<std::uint16_t>(bytes.data() + kLengthAt, std::endian::little)
                                          : load_bytes<std::uint32_t>(bytes.data() + kLengthAt, std::endian::little);
  const std::size_t begin = kLengthAt + length_bytes;
  if (length > bytes.size() - begin) throw truncated();
  const std::string_view header(reinterpret_cast<const char*>(bytes.data()) + begin, length);
  const NpyNumbers numbers = npy_numbers(header, name);
  DataArray array;
  array.shape = npy_shape(header, name);
  const std::span<const std::byte> data = bytes.subspan(begin + length);
  const std::size_t count = element_count(array.shape, numbers.bytes_each(), data.size(), name);
  array.values.reserve(count);
  for (std::size_t k = 0; k < count; ++k) array.values.push_back(numbers.value(data.data() + k * numbers.bytes_each()));
  if (value_behind(header, "fortran_order").starts_with("True")) array.values = from_column_major(array.values, array.shape);
  for (double& value : array.values) {
    if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
  }
  return array;
}

std::vector<DataArray> read_npz(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  const ZipArchive archive(bytes, name);
  std::vector<DataArray> arrays;
  for (const ZipEntry& entry : archive.entries()) {
    const std::string shown = entry.name.substr(0, entry.name.size() - kNpySuffix.size());
    try {
      arrays.push_back(read_npy(archive.read(entry), name));
      arrays.back().name = shown;
    } catch (const InputError&) {  // texts and objects of Python
      warnings.leave_out("array (" + printable(shown) + ")");
    }
  }
  return arrays;
}

}  // namespace ligne
