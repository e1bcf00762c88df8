/// Diagnostics of the SVG reader about the parts that it leaves out: they are counted or refused.

#include <algorithm>

#include "files/input_error.hpp"
#include "plotting/svg/reader.hpp"

namespace ligne::svg {
namespace {

/// Nouns under which parts that can be skipped by name are counted.
std::string noun_of(std::string_view name, const pugi::xml_node& node) {
  if (name == "text") return "<" + printable(node.name()) + "> elements in texts";
  if (name == "image") return "images";
  if (name == "clip-path") return "clip paths that are no shape";
  if (name == "mask") return "masks that are not shapes of one colour";
  if (name == "filter") return "filters";
  if (name == "foreignObject") return "foreignObject elements";
  if (name == "animation") return "animations";
  return std::string(name);
}

}  // namespace

SvgReader::SvgReader(std::string_view text, std::string file, const std::set<std::string>& skip, const FillReading& fills,
                     const SvgReading& reading)
    : text_(text), file_(std::move(file)), skip_(skip), fills_(fills), reading_(reading) {
  diagnostics_.refuse = [this](std::string_view name, const pugi::xml_node& node) { refuse(name, node); };
  diagnostics_.bad_value = [this](std::string_view property, const pugi::xml_node& node, const std::string& cause) {
    const std::string shown_property = printable(property);
    omit("values of " + shown_property + " that are not known", node,
         "<" + printable(node.name()) + "> " + shown_property + ": " + cause);
  };
  diagnostics_.cut_short = [this](const pugi::xml_node& node, const std::string& cause) {
    const std::string name = "<" + printable(node.name()) + ">";
    omit("ends of " + name + " elements after an error", node, name + " " + cause);
  };
}

std::size_t SvgReader::line_of(const pugi::xml_node& node) const {
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset <= 0 || static_cast<std::size_t>(offset) > text_.size()) return 0;
  return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + offset, '\n'));
}

void SvgReader::fail(const pugi::xml_node& node, const std::string& cause) const {
  const std::size_t line = line_of(node);
  throw InputError(line > 0 ? file_ + ":" + std::to_string(line) : file_, cause);
}

void SvgReader::leave_out(const std::string& kind, const pugi::xml_node& node) {
  if (!omitted_.emplace(node.internal_object(), kind).second) return;
  if (result_.omitted.empty()) result_.first_omitted_line = line_of(node);
  result_.omitted.count(kind);
}

void SvgReader::omit(const std::string& kind, const pugi::xml_node& node, const std::string& cause) {
  if (reading_.strict) fail(node, cause);
  leave_out(kind, node);
}

void SvgReader::refuse(std::string_view name, const pugi::xml_node& node) {
  if (skip_.contains(std::string(name))) {
    ++result_.left_out[std::string(name)];
    return;
  }
  if (name == "filter") return leave_out(noun_of(name, node), node);
  const std::string what = name == "text"   ? "convert the text to paths, or "
                           : name == "fill" ? "--fill outline or --fill hatch draws it, "
                                            : "";
  const std::string cause = "<" + printable(local_name(node)) + "> has " + std::string(name) +
                            ", which can not be drawn as strokes; " + what + "--skip " + std::string(name) +
                            " leaves it out";
  // Fills get here only if the user chose to refuse them.
  if (name == "fill") fail(node, cause);
  omit(noun_of(name, node), node, cause);
}

}  // namespace ligne::svg
