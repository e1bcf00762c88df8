#include "scene/readers/ply/ply_header.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

std::optional<NumberType> type_named(std::string_view word) {
  static constexpr std::pair<std::string_view, NumberType> kNames[] = {
      {"char", NumberType::int8},      {"int8", NumberType::int8},       {"uchar", NumberType::uint8},
      {"uint8", NumberType::uint8},    {"short", NumberType::int16},     {"int16", NumberType::int16},
      {"ushort", NumberType::uint16},  {"uint16", NumberType::uint16},   {"int", NumberType::int32},
      {"int32", NumberType::int32},    {"uint", NumberType::uint32},     {"uint32", NumberType::uint32},
      {"float", NumberType::float32},  {"float32", NumberType::float32}, {"double", NumberType::float64},
      {"float64", NumberType::float64}};
  for (const auto& [name, type] : kNames) {
    if (name == word) return type;
  }
  return {};
}

class HeaderReader {
 public:
  HeaderReader(std::string_view text, const std::string& name) : text_(text), name_(name) {
    // Edited files may begin with a byte order mark and blank lines.
    if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n", at_), text.size());
    header_.lines =
        static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    at_ = begin;
    const std::size_t end = text.find_first_of("\r\n", begin);
    if (end != std::string_view::npos) line_end_ = text.substr(end).starts_with("\r\n") ? "\r\n" : text.substr(end, 1);
  }

  PlyHeader read() {
    if (take_line() != "ply") throw error("a PLY file begins with a line 'ply'");
    for (;;) {
      std::string_view line = take_line();
      const std::string_view keyword = take_word(line);
      if (keyword == "end_header") break;
      if (keyword == "format")
        read_format(line);
      else if (keyword == "element")
        read_element(line);
      else if (keyword == "property")
        read_property(line);
      else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        if (!header_.elements.empty()) throw error(shown(keyword) + " is not a statement of a PLY header");
        header_.remarks.emplace_back(keyword);
      }
    }
    if (!has_format_) throw error("PLY header without 'format'");
    header_.bytes = at_;
    return std::move(header_);
  }

 private:
  InputError error(const std::string& cause) const { return error_at_line(name_, header_.lines, cause); }

  std::string_view take_line() {
    ++header_.lines;
    if (at_ >= text_.size()) throw error("PLY header without 'end_header'");
    const std::size_t end = std::min(line_end_.empty() ? text_.size() : text_.find(line_end_, at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + line_end_.size(), text_.size());
    if (line.ends_with('\r')) line.remove_suffix(1);  // some lines of the header may end in \r\n
    return trimmed(line);
  }

  void read_format(std::string_view line) {
    const std::string_view encoding = take_word(line), version = take_word(line);
    if (encoding == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (encoding == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (encoding == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      throw error(shown(encoding) + " is not a PLY format (ascii, binary_little_endian, binary_big_endian)");
    if (version != "1.0") throw error("PLY version " + shown(version) + " is not known, only 1.0 is");
    has_format_ = true;
  }

  void read_element(std::string_view line) {
    PlyElement element;
    element.name = take_word(line);
    const std::string_view word = take_word(line);
    const std::optional<std::int64_t> count = parse_integer(word);
    if (element.name.empty()) throw error("element without a name");
    if (!count || *count < 0) throw error(shown(word) + " is not a number of elements");
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) throw error("element " + shown(element.name) + " a second time");
    }
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::string_view line) {
    if (header_.elements.empty()) throw error("property before the first element");
    PlyProperty property;
    std::string_view word = take_word(line);
    if (word == "list") {
      property.is_list = true;
      property.count_type = take_type(take_word(line));
      if (is_float(property.count_type)) throw error("the length of a list can not be a float");
      word = take_word(line);
    }
    property.type = take_type(word);
    property.name = take_word(line);
    if (property.name.empty()) throw error("property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  NumberType take_type(std::string_view word) const {
    const std::optional<NumberType> type = type_named(word);
    if (!type) throw error(shown(word) + " is not a PLY type");
    return *type;
  }

  std::string_view text_;
  const std::string& name_;
  std::string_view line_end_;
  std::size_t at_ = 0;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t PlyElement::find(std::initializer_list<const char*> names) const {
  const auto named = [&](const PlyProperty& p) { return std::find(names.begin(), names.end(), p.name) != names.end(); };
  return static_cast<std::size_t>(std::find_if(properties.begin(), properties.end(), named) - properties.begin());
}

PlyHeader read_ply_header(std::span<const std::byte> bytes, const std::string& name) {
  return HeaderReader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name).read();
}

}  // namespace ligne
