// Elements consist of a type, a length and data; those of matrices contain further elements:
// https://www.mathworks.com/help/pdf_doc/matlab/matfile_format.pdf

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "files/message_text.hpp"
#include "scene/readers/load_bytes.hpp"
#include "scene/tables/data_array.hpp"
#include "scene/tables/unpack.hpp"

namespace ligne {
namespace {

constexpr std::string_view kMatlabMark = "MATLAB 5.0 MAT-file";
constexpr std::size_t kMatHeader = 128, kEndianAt = 126, kTag = 8;
constexpr std::uint32_t kMatrix = 14, kCompressed = 15;
constexpr std::uint32_t kFirstNumericClass = 6, kLastNumericClass = 15;
constexpr std::size_t kMostMatDimensions = 32;

/// The numbers of an element by its type; nothing for types without numbers.
std::optional<NumberType> number_type_of(std::uint32_t mat_type) {
  using enum NumberType;
  constexpr std::array<std::optional<NumberType>, 14> kTypes{std::nullopt, int8, uint8,   int16, uint16, int32, uint32,
                                                             float32,      {},   float64, {},    {},     int64, uint64};
  return mat_type < kTypes.size() ? kTypes[mat_type] : std::nullopt;
}

struct MatElement {
  std::uint32_t type = 0;
  std::span<const std::byte> data;
};

class MatReader {
 public:
  MatReader(const std::string& name, Warnings& warnings) : name_(name), warnings_(warnings) {}

  std::vector<DataArray> read(std::span<const std::byte> bytes) {
    const bool is_little = std::to_integer<char>(bytes[kEndianAt]) == 'I';
    order_ = is_little ? std::endian::little : std::endian::big;
    read_elements(bytes.subspan(kMatHeader), true);
    return std::move(arrays_);
  }

 private:
  InputError error(const std::string& cause) const { return {name_, "MATLAB file: " + cause}; }

  std::uint32_t number(std::span<const std::byte> bytes, std::size_t at) const {
    return load_bytes<std::uint32_t>(bytes.data() + at, order_);
  }

  /// Reads an element. A short one has type and length in four bytes, and data in the next four.
  MatElement take(std::span<const std::byte>& bytes) const {
    if (bytes.size() < kTag) throw error("ends within an element");
    MatElement element;
    element.type = number(bytes, 0);
    std::size_t length = number(bytes, 4), begin = kTag, end = 0;
    if (element.type >> 16 != 0) {
      length = element.type >> 16;
      element.type &= 0xffff;
      begin = 4;
      if (length > 4) throw error("a short element is too long");
      end = kTag;
    } else {
      if (length > bytes.size() - kTag) throw error("is truncated");
      // Compressed elements are not padded.
      const std::size_t padded = element.type == kCompressed ? length : (length + kTag - 1) / kTag * kTag;
      end = std::min(begin + padded, bytes.size());
    }
    element.data = bytes.subspan(begin, length);
    bytes = bytes.subspan(end);
    return element;
  }

  void read_elements(std::span<const std::byte> bytes, bool may_be_compressed) {
    while (bytes.size() >= kTag) {
      const MatElement element = take(bytes);
      if (element.type == kCompressed && may_be_compressed) {
        const std::vector<std::byte> inner = inflated(element.data, name_);
        read_elements(inner, false);
      } else if (element.type == kMatrix) {
        read_matrix(element.data);
      }
    }
  }

  void read_matrix(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    const MatElement flags = take(bytes);
    if (flags.data.size() < 4) throw error("an array has no flags");
    const std::uint32_t array_flags = number(flags.data, 0), array_class = array_flags & 0xff;
    constexpr std::uint32_t kComplex = 0x800, kOpaque = 17;
    const bool is_numeric = array_class >= kFirstNumericClass && array_class <= kLastNumericClass;
    DataArray array;
    if (array_class == kOpaque) return warnings_.leave_out("objects");
    const MatElement sizes = take(bytes);
    std::vector<std::size_t> shape;
    for (std::size_t at = 0; at + 4 <= sizes.data.size(); at += 4) shape.push_back(number(sizes.data, at));
    const MatElement label = take(bytes);
    array.name.assign(reinterpret_cast<const char*>(label.data.data()), label.data.size());
    if (shape.size() > kMostMatDimensions) throw error("an array has too many dimensions");
    if (!is_numeric || (array_flags & kComplex) != 0) return leave_out(array.name, array_class);
    const MatElement data = take(bytes);
    const std::optional<NumberType> type = number_type_of(data.type);
    if (!type) throw error("array " + shown(array.name) + " holds no numbers");
    const std::size_t each = byte_size(*type);
    const std::size_t count = element_count(shape, each, data.data.size(), name_);
    for (std::size_t k = 0; k < count; ++k) array.values.push_back(load_number(data.data.data() + k * each, *type, order_));
    array.shape = std::move(shape);
    turn(array);
    arrays_.push_back(std::move(array));
  }

  /// MATLAB's first two indices vary fastest and the others count pages. Reorders to pages first, and rows of columns
  /// in each.
  static void turn(DataArray& array) {
    if (array.shape.size() < 2) return;
    const std::array<std::size_t, 2> page{array.shape[0], array.shape[1]};
    const std::size_t size = page[0] * page[1];
    for (std::size_t at = 0; size > 0 && at < array.values.size(); at += size) {
      const auto begin = array.values.begin() + static_cast<std::ptrdiff_t>(at);
      const std::vector<double> turned = from_column_major({begin, begin + static_cast<std::ptrdiff_t>(size)}, page);
      std::copy(turned.begin(), turned.end(), begin);
    }
    if (array.shape.size() == 2) return;
    const std::size_t pages = size == 0 ? 0 : array.values.size() / size;
    array.shape = {pages, page[0], page[1]};
  }

  void leave_out(const std::string& name, std::uint32_t array_class) {
    constexpr std::array<const char*, 6> kClasses{"array", "cell array", "struct", "object", "text", "sparse matrix"};
    const char* what = array_class < kClasses.size() ? kClasses[array_class] : "array";
    warnings_.leave_out(std::string(what) + (name.empty() ? "" : " (" + printable(name) + ")"));
  }

  const std::string& name_;
  Warnings& warnings_;
  std::endian order_ = std::endian::little;
  std::vector<DataArray> arrays_;
};

}  // namespace

bool is_matlab(std::string_view bytes) { return bytes.starts_with(kMatlabMark) && bytes.size() >= kMatHeader; }

std::vector<DataArray> read_matlab(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings) {
  std::vector<DataArray> arrays = MatReader(name, warnings).read(bytes);
  for (DataArray& array : arrays) {
    for (double& value : array.values) {
      if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
    }
  }
  if (arrays.empty()) {
    const std::string left_out = warnings.left_out().text();
    throw InputError(name, "is a MATLAB file without an array of numbers" + (left_out.empty() ? "" : "; " + left_out) +
                               ": save them as plain matrices: save('OUT.mat', 'z', 'x', 'y', '-v7')");
  }
  return arrays;
}

}  // namespace ligne
