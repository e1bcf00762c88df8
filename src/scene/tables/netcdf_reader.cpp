// The classic format: https://docs.unidata.ucar.edu/netcdf-c/current/file_format_specifications.html
// A value is the number in the file times scale_factor plus add_offset; numbers equal to the fill value are missing.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "files/message_text.hpp"
#include "scene/readers/load_bytes.hpp"
#include "scene/tables/data_array.hpp"

namespace ligne {
namespace {

/// The type of numbers; nothing for characters.
using NetcdfType = std::optional<NumberType>;

std::size_t bytes_of(NetcdfType type) { return type ? byte_size(*type) : 1; }

double netcdf_value(const std::byte* at, NumberType type) { return load_number(at, type, std::endian::big); }

struct NetcdfAttribute {
  std::string text;             ///< text of a character attribute
  std::vector<double> numbers;  ///< values of a numeric attribute
};
using NetcdfAttributes = std::map<std::string, NetcdfAttribute>;

struct NetcdfDimension {
  std::string name;
  std::size_t size = 0;
  bool is_record = false;  ///< its size grows with the file
};

struct NetcdfVariable {
  std::string name;
  std::vector<std::size_t> dimensions;
  NetcdfAttributes attributes;
  NetcdfType type;
  std::size_t begin = 0;
  bool is_record = false;
};

struct NetcdfHeader {
  std::vector<NetcdfDimension> dimensions;
  NetcdfAttributes attributes;
  std::vector<NetcdfVariable> variables;
  std::size_t record_bytes = 0;  ///< distance between records
};

constexpr std::uint32_t kDimensionTag = 0x0A, kVariableTag = 0x0B, kAttributeTag = 0x0C;
constexpr std::size_t kPadding = 4;
constexpr std::size_t kMostAxes = 32;

std::size_t padded(std::size_t bytes) { return (bytes + kPadding - 1) / kPadding * kPadding; }

/// Reads the header. Throws InputError. Rejects counts that do not fit into the bytes.
class HeaderReader {
 public:
  HeaderReader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  NetcdfHeader read() {
    constexpr std::size_t kMark = 4;
    version_ = std::to_integer<unsigned>(bytes_[kMark - 1]);
    at_ = kMark;
    take_count();  // number of records, which follows from the bytes after the header
    read_dimensions();
    header_.attributes = take_attributes();
    read_variables();
    count_records();
    return std::move(header_);
  }

 private:
  InputError error(const std::string& cause) const { return {name_, "netCDF header: " + cause}; }

  void need(std::size_t bytes) const {
    if (bytes > bytes_.size() - at_) throw error("ends early");
  }
  template <typename Number>
  Number take() {
    need(sizeof(Number));
    const auto value = load_bytes<Number>(bytes_.data() + at_, std::endian::big);
    at_ += sizeof(Number);
    return value;
  }
  bool is_64_bit() const { return version_ == 5; }
  std::uint64_t take_count() { return is_64_bit() ? take<std::uint64_t>() : take<std::uint32_t>(); }
  std::uint64_t take_offset() { return version_ == 1 ? take<std::uint32_t>() : take<std::uint64_t>(); }

  /// The number of elements of a list, each of which takes at least four bytes.
  std::size_t take_list(std::uint32_t tag) {
    const auto found = take<std::uint32_t>();
    const std::uint64_t count = take_count();
    if (found == 0 && count == 0) return 0;
    if (found != tag) throw error("a list begins with " + std::to_string(found) + ", not with " + std::to_string(tag));
    if (count > (bytes_.size() - at_) / kPadding) throw error("ends early");
    return count;
  }

  std::string take_name() {
    const std::uint64_t length = take_count();
    if (length > bytes_.size() - at_) throw error("ends early");
    std::string text(reinterpret_cast<const char*>(bytes_.data()) + at_, length);
    need(std::min(padded(length), bytes_.size() - at_));
    at_ += std::min(padded(length), bytes_.size() - at_);
    return text;
  }

  NetcdfType take_type() {
    const auto type = take<std::uint32_t>();
    using enum NumberType;
    constexpr NetcdfType kTypes[] = {int8, {}, int16, int32, float32, float64, uint8, uint16, uint32, int64, uint64};
    constexpr std::uint32_t kLast = 6, kLastOf64Bit = 11;
    if (type < 1 || type > (is_64_bit() ? kLastOf64Bit : kLast)) throw error("unknown type " + std::to_string(type));
    return kTypes[type - 1];
  }

  void read_dimensions() {
    const std::size_t count = take_list(kDimensionTag);
    for (std::size_t k = 0; k < count; ++k) {
      NetcdfDimension& dimension = header_.dimensions.emplace_back();
      dimension.name = take_name();
      dimension.size = take_count();
      dimension.is_record = dimension.size == 0;
    }
  }

  NetcdfAttributes take_attributes() {
    NetcdfAttributes attributes;
    const std::size_t count = take_list(kAttributeTag);
    for (std::size_t k = 0; k < count; ++k) {
      const std::string name = take_name();
      const NetcdfType type = take_type();
      const std::uint64_t length = take_count();
      if (length > (bytes_.size() - at_) / bytes_of(type)) throw error("ends early");
      NetcdfAttribute& attribute = attributes[name];
      attribute = {};
      if (!type) {
        attribute.text.assign(reinterpret_cast<const char*>(bytes_.data()) + at_, length);
      } else {
        for (std::size_t i = 0; i < length; ++i)
          attribute.numbers.push_back(netcdf_value(bytes_.data() + at_ + i * bytes_of(type), *type));
      }
      at_ += std::min(padded(length * bytes_of(type)), bytes_.size() - at_);
    }
    return attributes;
  }

  void read_variables() {
    const std::size_t count = take_list(kVariableTag);
    for (std::size_t k = 0; k < count; ++k) {
      NetcdfVariable& variable = header_.variables.emplace_back();
      variable.name = take_name();
      const std::uint64_t axes = take_count();
      if (axes > kMostAxes) throw error("variable " + shown(variable.name) + " has " + std::to_string(axes) + " dimensions");
      for (std::uint64_t i = 0; i < axes; ++i) {
        const std::uint64_t dimension = take_count();
        if (dimension >= header_.dimensions.size())
          throw error("variable " + shown(variable.name) + " has an unknown dimension");
        variable.dimensions.push_back(dimension);
      }
      variable.is_record = axes > 0 && header_.dimensions[variable.dimensions[0]].is_record;
      variable.attributes = take_attributes();
      variable.type = take_type();
      take_count();  // size in bytes, which follows from the dimensions
      variable.begin = take_offset();
      if (variable.begin > bytes_.size())
        throw error("variable " + shown(variable.name) + " begins past the end of the file");
    }
  }

  /// Size in bytes of one record of a variable, or of all of it. Throws InputError if the file is smaller.
  std::size_t part_bytes(const NetcdfVariable& variable) const {
    std::size_t bytes = bytes_of(variable.type);
    for (std::size_t i = variable.is_record ? 1 : 0; i < variable.dimensions.size(); ++i) {
      const std::size_t size = header_.dimensions[variable.dimensions[i]].size;
      if (size != 0 && bytes > bytes_.size() / size)
        throw InputError(name_, "is truncated: variable " + shown(variable.name) + " is longer than the file");
      bytes *= size;
    }
    return bytes;
  }

  void count_records() {
    std::size_t begin = bytes_.size(), variables = 0, last = 0;
    for (const NetcdfVariable& variable : header_.variables) {
      if (!variable.is_record) continue;
      begin = std::min(begin, variable.begin);
      last = part_bytes(variable);
      header_.record_bytes += padded(last);
      ++variables;
    }
    if (variables == 1) header_.record_bytes = last;  // a single record variable is not padded
    const std::size_t records =
        header_.record_bytes == 0 ? 0 : (bytes_.size() - begin + kPadding - 1) / header_.record_bytes;
    for (NetcdfDimension& dimension : header_.dimensions) {
      if (dimension.is_record) dimension.size = records;
    }
  }

  std::span<const std::byte> bytes_;
  const std::string& name_;
  unsigned version_ = 1;
  std::size_t at_ = 0;
  NetcdfHeader header_;
};

/// Numbers from here on are missing: the netCDF library fills unwritten floats and doubles with them, and no quantity
/// is as large.
constexpr double kDefaultFill = 9.96e36;

double number_of(const NetcdfAttributes& attributes, const char* name, double otherwise) {
  const auto found = attributes.find(name);
  return found == attributes.end() || found->second.numbers.empty() ? otherwise : found->second.numbers.front();
}

/// Converts the numbers of a file to values.
struct ValueScale {
  double factor = 1, offset = 0;
  std::vector<double> missing;

  explicit ValueScale(const NetcdfAttributes& attributes)
      : factor(number_of(attributes, "scale_factor", 1)), offset(number_of(attributes, "add_offset", 0)) {
    for (const char* name : {"_FillValue", "missing_value"}) {
      const auto found = attributes.find(name);
      if (found != attributes.end())
        missing.insert(missing.end(), found->second.numbers.begin(), found->second.numbers.end());
    }
  }

  double operator()(double number) const {
    const bool is_missing =
        !std::isfinite(number) || std::abs(number) > kDefaultFill || std::ranges::find(missing, number) != missing.end();
    const double value = number * factor + offset;
    return is_missing || !std::isfinite(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }
};

/// One layer of a variable: its last two dimensions, or all if there are no more.
DataArray layer_of(const NetcdfHeader& header, const NetcdfVariable& variable, std::span<const std::byte> bytes,
                   std::size_t layer, const std::string& name) {
  DataArray array;
  array.name = variable.name;
  const auto unit = variable.attributes.find("units");
  if (unit != variable.attributes.end()) array.unit = unit->second.text;
  const std::size_t axes = variable.dimensions.size();
  for (std::size_t k = 0; k < axes; ++k) {
    const NetcdfDimension& dimension = header.dimensions[variable.dimensions[k]];
    if (k + 2 < axes) {
      if (dimension.size != 0 && array.layers > bytes.size() / dimension.size) throw InputError(name, "is truncated");
      array.layers *= dimension.size;
      continue;
    }
    array.shape.push_back(dimension.size);
    array.dimensions.push_back(dimension.name);
  }
  const std::size_t each = bytes_of(variable.type);
  const std::size_t count = element_count(array.shape, each, bytes.size(), name);
  if (layer >= array.layers || count == 0) return array;
  // Records of one variable are not adjacent: those of other variables lie between them.
  const std::size_t first = layer * count;
  std::size_t per_record = 1;
  for (std::size_t k = 1; k < axes; ++k) per_record *= header.dimensions[variable.dimensions[k]].size;
  const ValueScale scale(variable.attributes);
  array.values.reserve(count);
  for (std::size_t k = first; k < first + count; ++k) {
    const std::size_t at = variable.is_record ? variable.begin + k / per_record * header.record_bytes + k % per_record * each
                                              : variable.begin + k * each;
    if (at > bytes.size() || bytes.size() - at < each) {
      throw InputError(name, "is truncated: variable " + shown(variable.name) + " extends past the end of the file");
    }
    array.values.push_back(scale(netcdf_value(bytes.data() + at, *variable.type)));
  }
  return array;
}

/// Reads grids of GMT before version 4: x_range, y_range and spacing, and z as one row, north first.
void restore_old_gmt(const NetcdfHeader& header, std::vector<DataArray>& arrays, const std::string& name) {
  const auto find = [&](const char* wanted) -> DataArray* {
    const auto found = std::ranges::find_if(arrays, [&](const DataArray& a) { return a.name == wanted; });
    return found == arrays.end() || found->values.empty() ? nullptr : &*found;
  };
  DataArray *x_range = find("x_range"), *y_range = find("y_range"), *counts = find("dimension"), *z = find("z");
  if (!x_range || !y_range || !counts || !z || x_range->values.size() < 2 || y_range->values.size() < 2 ||
      counts->values.size() < 2)
    return;
  const double columns = counts->values[0], rows = counts->values[1];
  if (!(columns >= 2 && rows >= 2) || columns * rows != static_cast<double>(z->values.size())) {
    throw InputError(name, "is a grid of GMT whose dimension does not fit its heights");
  }
  const auto variable = std::ranges::find_if(header.variables, [](const NetcdfVariable& v) { return v.name == "z"; });
  const bool by_pixels = number_of(variable->attributes, "node_offset", 0) != 0;
  const auto positions = [&](const char* axis, const DataArray& range, double count) {
    const double step = (range.values[1] - range.values[0]) / (by_pixels ? count : count - 1);
    DataArray at{axis, {static_cast<std::size_t>(count)}, {}, {axis}};
    for (double k = 0; k < count; ++k) at.values.push_back(range.values[0] + (by_pixels ? k + 0.5 : k) * step);
    return at;
  };
  DataArray y = positions("y", *y_range, rows),
            heights{"z", {y.shape[0], static_cast<std::size_t>(columns)}, z->values, {"y", "x"}};
  std::ranges::reverse(y.values);
  DataArray x = positions("x", *x_range, columns);
  arrays = {std::move(x), std::move(y), std::move(heights)};
}

}  // namespace

bool is_classic_netcdf(std::string_view bytes) {
  return bytes.starts_with("CDF") && bytes.size() > 3 && (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

std::vector<DataArray> read_netcdf(std::span<const std::byte> bytes, const std::string& name, std::size_t layer) {
  constexpr std::size_t kShortest = 32;
  if (bytes.size() < kShortest) throw InputError(name, "netCDF header: ends early");
  const NetcdfHeader header = HeaderReader(bytes, name).read();
  std::vector<DataArray> arrays;
  std::size_t taken = 0;
  for (const NetcdfVariable& variable : header.variables) {
    if (!variable.type || variable.dimensions.empty()) continue;
    arrays.push_back(layer_of(header, variable, bytes, variable.dimensions.size() > 2 ? layer : 0, name));
    // In a forged file, variables may overlap.
    taken += arrays.back().values.size() * bytes_of(variable.type);
    if (taken > bytes.size()) throw InputError(name, "has variables whose total size exceeds the file");
  }
  restore_old_gmt(header, arrays, name);
  return arrays;
}

}  // namespace ligne
