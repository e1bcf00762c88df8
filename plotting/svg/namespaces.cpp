#include "plotting/svg/namespaces.hpp"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ligne::svg {
namespace {

constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";
/// Prefix for elements without one that are not of SVG.
constexpr char kForeign[] = "foreign:";

/// Namespaces whose attributes are read, and the prefixes that they get.
constexpr std::pair<std::string_view, std::string_view> kAttributeNamespaces[] = {
    {"http://www.w3.org/1999/xlink", "xlink"}, {"http://www.inkscape.org/namespaces/inkscape", "inkscape"}};

std::pair<std::string, std::string> split_name(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return {{}, std::string(name)};
  return {std::string(name.substr(0, colon)), std::string(name.substr(colon + 1))};
}

class PlainNames {
 public:
  explicit PlainNames(const pugi::xml_node& root) {
    declare(root, 0);
    const std::string prefix = split_name(root.name()).first;
    root_prefix_ = prefix;
    root_namespace_ = namespace_of(prefix);
    leave(0);
  }

  /// Declarations at `depth` hold until leave(depth).
  void enter(pugi::xml_node node, std::size_t depth) {
    declare(node, depth);
    const auto [prefix, local] = split_name(node.name());
    const std::string_view uri = namespace_of(prefix);
    const bool of_svg = uri == kSvgNamespace || uri == root_namespace_ ||
                        (uri.empty() && (prefix.empty() || prefix == "svg" || prefix == root_prefix_));
    if (of_svg && !prefix.empty()) node.set_name(local.c_str());
    if (!of_svg && prefix.empty()) node.set_name((kForeign + local).c_str());
    for (pugi::xml_attribute attribute : node.attributes()) rename(attribute);
  }
  void leave(std::size_t depth) {
    while (!declared_.empty() && declared_.back().first == depth) {
      declared_.back().second->pop_back();
      declared_.pop_back();
    }
  }

 private:
  void declare(const pugi::xml_node& node, std::size_t depth) {
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string_view name = attribute.name();
      if (!name.starts_with("xmlns") || (name.size() > 5 && name[5] != ':')) continue;
      auto& uris = namespaces_[std::string(name.size() > 5 ? name.substr(6) : "")];
      uris.emplace_back(attribute.value());
      declared_.emplace_back(depth, &uris);
    }
  }
  std::string_view namespace_of(const std::string& prefix) const {
    const auto found = namespaces_.find(prefix);
    return found == namespaces_.end() || found->second.empty() ? std::string_view() : found->second.back();
  }
  void rename(pugi::xml_attribute attribute) const {
    const std::string_view name = attribute.name();
    if (name.find(':') == std::string_view::npos || name.starts_with("xml")) return;
    const auto [prefix, local] = split_name(name);
    const std::string_view uri = namespace_of(prefix);
    for (const auto& [known, usual] : kAttributeNamespaces) {
      if (uri == known && prefix != usual) attribute.set_name((std::string(usual) + ":" + local).c_str());
    }
  }

  std::unordered_map<std::string, std::vector<std::string>> namespaces_;  ///< by prefix, the innermost last
  std::vector<std::pair<std::size_t, std::vector<std::string>*>> declared_;
  std::string root_prefix_, root_namespace_;
};

}  // namespace

void use_plain_names(pugi::xml_node root) {
  PlainNames names(root);
  std::size_t depth = 0;
  // Without recursion, since a file may be nested to any depth.
  for (pugi::xml_node node = root; node;) {
    if (node.type() == pugi::node_element) names.enter(node, depth);
    if (node.first_child()) {
      node = node.first_child();
      ++depth;
      continue;
    }
    names.leave(depth);
    while (node && node != root && !node.next_sibling()) {
      node = node.parent();
      names.leave(--depth);
    }
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
}

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.find(':') == std::string_view::npos ? name : std::string_view();
}

}  // namespace ligne::svg
