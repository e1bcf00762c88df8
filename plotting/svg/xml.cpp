#include "plotting/svg/xml.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "plotting/svg/values.hpp"

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

/// Deepest nesting of entities.
constexpr int kDeepestEntity = 20;
/// Bytes that references may add: kMostAdded, and kMostTimes the size of the document. Style entities of Illustrator
/// are a dozen times as long as their names.
constexpr std::size_t kMostAdded = std::size_t{1} << 24, kMostTimes = 16;
/// Most references: they take time even if they add nothing.
constexpr std::size_t kMostReferences = 4'000'000;

struct EntityValue {
  std::string text;
  bool external = false;
};
using EntityValues = std::unordered_map<std::string, EntityValue>;

bool entity_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' ||
         c == ':' || static_cast<unsigned char>(c) >= 0x80;
}

/// The position behind the first `end` from `from` on; the end of the text if there is none.
std::size_t behind(std::string_view text, std::string_view end, std::size_t from) {
  const std::size_t found = text.find(end, from);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

/// References to ASCII characters by number are expanded where an entity is declared (XML 1.0, 4.5).
std::string with_characters(std::string_view value) {
  std::string text;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::size_t end = value.substr(i, 2) == "&#" ? value.find(';', i) : std::string_view::npos;
    constexpr std::size_t kLongest = 8;  // "&#x0003c"
    unsigned code = 0;
    bool plain = end != std::string_view::npos && end - i <= kLongest && end > i + 2;
    if (plain) {
      const bool hexadecimal = value[i + 2] == 'x';
      const std::string digits(value.substr(i + (hexadecimal ? 3 : 2), end - i - (hexadecimal ? 3 : 2)));
      const std::string_view known = hexadecimal ? "0123456789abcdefABCDEF" : "0123456789";
      plain = !digits.empty() && digits.find_first_not_of(known) == std::string::npos;
      if (plain) code = static_cast<unsigned>(std::stoul(digits, nullptr, hexadecimal ? 16 : 10));
    }
    if (plain && code > 0 && code < 0x80) {
      text += static_cast<char>(code);
      i = end;
    } else {
      text += value[i];
    }
  }
  return text;
}

/// Reads the declaration that begins at `at`, behind "<!ENTITY". Parameter entities ("%") are left out: they stand only
/// in declarations.
void read_declaration(std::string_view text, std::size_t at, EntityValues& entities) {
  const auto skip_blanks = [&] { at = std::min(text.find_first_not_of(kBlanks, at), text.size()); };
  skip_blanks();
  const std::size_t begin = at;
  while (at < text.size() && entity_name_character(text[at])) ++at;
  std::string name(text.substr(begin, at - begin));
  skip_blanks();
  if (name.empty() || at >= text.size()) return;
  const char quote = text[at];
  if (quote != '"' && quote != '\'') {
    entities.emplace(std::move(name), EntityValue{{}, true});
    return;
  }
  const std::size_t end = text.find(quote, at + 1);
  if (end == std::string_view::npos) return;
  // The first declaration of a name holds.
  entities.emplace(std::move(name), EntityValue{with_characters(text.substr(at + 1, end - at - 1)), false});
}

/// Reads the declarations between "[" and "]" of a document type. Returns the position of the "]".
std::size_t read_declarations(std::string_view text, std::size_t at, EntityValues& entities) {
  constexpr std::string_view kEntity = "<!ENTITY";
  while (at < text.size() && text[at] != ']') {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(text, "-->", at + 4);
    } else if (rest.starts_with("<?")) {
      at = behind(text, "?>", at + 2);
    } else if (rest.starts_with("<!")) {
      if (rest.starts_with(kEntity)) read_declaration(text, at + kEntity.size(), entities);
      for (; at < text.size() && text[at] != '>'; ++at) {
        if (text[at] == '"' || text[at] == '\'') at = std::min(text.find(text[at], at + 1), text.size() - 1);
      }
      at = std::min(at + 1, text.size());
    } else {
      ++at;
    }
  }
  return at;
}

/// The position at which the document type ends; 0 if the document has none.
std::size_t read_document_type(std::string_view xml, EntityValues& entities) {
  std::size_t at = xml.starts_with("\xef\xbb\xbf") ? 3 : 0;
  while (true) {
    at = xml.find_first_not_of(kBlanks, at);
    if (at == std::string_view::npos) return 0;
    const std::string_view rest = xml.substr(at);
    if (rest.starts_with("<?")) {
      at = behind(xml, "?>", at);
    } else if (rest.starts_with("<!--")) {
      at = behind(xml, "-->", at);
    } else if (rest.starts_with("<!DOCTYPE")) {
      break;
    } else {
      return 0;
    }
  }
  for (; at < xml.size() && xml[at] != '>'; ++at) {
    if (xml[at] == '"' || xml[at] == '\'') at = std::min(xml.find(xml[at], at + 1), xml.size() - 1);
    if (xml[at] == '[') at = read_declarations(xml, at + 1, entities);
  }
  return std::min(at + 1, xml.size());
}

class EntityExpansion {
 public:
  EntityExpansion(const EntityValues& entities, std::size_t size)
      : entities_(entities), most_(size + kMostAdded + kMostTimes * size) {}

  /// Adds elements and the text between them.
  void add_content(std::string_view text, int depth) {
    for (std::size_t i = 0; i < text.size();) {
      const std::string_view rest = text.substr(i);
      std::size_t n = 1;
      if (rest.starts_with("<!--")) {
        n = behind(rest, "-->", 4);
      } else if (rest.starts_with("<![CDATA[")) {
        n = behind(rest, "]]>", 9);
      } else if (rest.starts_with("<?")) {
        n = behind(rest, "?>", 2);
      } else if (rest[0] == '<') {
        i += add_tag(rest, depth);
        continue;
      } else if (rest[0] == '&') {
        i += add_reference(rest, depth, false);
        continue;
      } else {
        n = std::min(rest.find_first_of("<&"), rest.size());
      }
      add(rest.substr(0, n), depth);
      i += n;
    }
  }

  ExpandedDocument result;

 private:
  /// Line ends of entities become blanks, so that lines keep their numbers.
  void add(std::string_view text, int depth) {
    if (result.text.size() + text.size() > most_) throw std::invalid_argument("has entities that expand it too much");
    const std::size_t begin = result.text.size();
    result.text += text;
    if (depth > 0) std::replace(result.text.begin() + static_cast<std::ptrdiff_t>(begin), result.text.end(), '\n', ' ');
  }

  /// Adds a tag from "<" to ">", with the values of attributes expanded. Returns its length in the text.
  std::size_t add_tag(std::string_view text, int depth) {
    char quote = '\0';
    std::size_t i = 0;
    while (i < text.size()) {
      if (quote != '\0' && text[i] == '&') {
        i += add_reference(text.substr(i), depth, true);
        continue;
      }
      const std::size_t next =
          quote == '\0' ? text.find_first_of("\"'>", i) : text.find_first_of(std::string{quote, '&'}, i);
      const bool stops = next != std::string_view::npos && text[next] != '&';
      const std::size_t end = next == std::string_view::npos ? text.size() : stops ? next + 1 : next;
      add(text.substr(i, end - i), depth);
      i = end;
      if (!stops) continue;
      if (text[next] == '>' && quote == '\0') break;
      quote = quote == '\0' ? text[next] : '\0';
    }
    return i;
  }

  /// Adds the text of an entity inside the value of an attribute. Characters that would end the value are escaped.
  void add_value(std::string_view text, int depth) {
    for (std::size_t i = 0; i < text.size();) {
      const char c = text[i];
      if (c == '&') {
        i += add_reference(text.substr(i), depth, true);
        continue;
      }
      const std::size_t end = std::min(text.find_first_of("&<\"'", i + 1), text.size());
      const std::string_view escaped = c == '<' ? "&lt;" : c == '"' ? "&quot;" : c == '\'' ? "&apos;" : "";
      add(escaped, depth);
      const std::size_t begin = escaped.empty() ? i : i + 1;
      add(text.substr(begin, end - begin), depth);
      i = end;
    }
  }

  /// Adds the reference that begins with the "&" of the text. Returns its length.
  std::size_t add_reference(std::string_view text, int depth, bool in_value) {
    std::size_t n = 1;
    while (n < text.size() && entity_name_character(text[n])) ++n;
    const auto found =
        n < text.size() && text[n] == ';' ? entities_.find(std::string(text.substr(1, n - 1))) : entities_.end();
    if (found == entities_.end()) {
      add(text.substr(0, n), depth);
      return n;
    }
    if (++references_ > kMostReferences) throw std::invalid_argument("has more than four million references to entities");
    if (depth == kDeepestEntity) throw std::invalid_argument("has entities that contain each other more than 20 times");
    if (found->second.external) {
      ++result.external;
    } else if (in_value) {
      add_value(found->second.text, depth + 1);
    } else {
      add_content(found->second.text, depth + 1);
    }
    return n + 1;
  }

  const EntityValues& entities_;
  std::size_t most_, references_ = 0;
};

}  // namespace

std::optional<ExpandedDocument> expand_entities(std::string_view xml) {
  EntityValues entities;
  const std::size_t begin = read_document_type(xml, entities);
  for (const char* known : {"lt", "gt", "amp", "quot", "apos"}) entities.erase(known);
  if (entities.empty()) return {};
  EntityExpansion expansion(entities, xml.size());
  expansion.result.text = xml.substr(0, begin);
  expansion.add_content(xml.substr(begin), 0);
  return std::move(expansion.result);
}

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

std::string_view link_of(const pugi::xml_node& node) {
  std::string_view link = node.attribute("href").value();
  if (link.empty()) link = node.attribute("xlink:href").value();
  return link.starts_with('#') ? link.substr(1) : std::string_view();
}

}  // namespace ligne::svg
