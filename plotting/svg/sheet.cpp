#include "plotting/svg/sheet.hpp"

#include <algorithm>

#include "plotting/svg/style.hpp"

namespace ligne::svg {
namespace {

constexpr std::size_t kMostRules = 10'000;
/// Comparisons of an element with a part of a rule; a declaration that is applied counts as so many.
constexpr std::size_t kMostWork = 200'000'000, kDeclarationWork = 20;

std::string without_comments(std::string_view css) {
  std::string text;
  while (!css.empty()) {
    const std::size_t begin = std::min(css.find("/*"), css.size());
    text += css.substr(0, begin);
    css.remove_prefix(begin);
    const std::size_t end = css.find("*/");
    css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
  }
  return text;
}

bool name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Takes a name from the beginning.
std::string take_name(std::string_view& text) {
  std::size_t n = 0;
  while (n < text.size() && name_character(text[n])) ++n;
  if (n == 0) throw UnknownStyle("a selector that is not known");
  std::string name(text.substr(0, n));
  text.remove_prefix(n);
  return name;
}

/// Takes "[name=value]" from the beginning, with or without quotes.
void take_attribute(std::string_view& text, std::string& name, std::string& value, char& how) {
  const std::size_t end = text.find(']');
  if (end == std::string_view::npos) throw UnknownStyle("a selector that is not known");
  const std::string_view inside = trimmed(text.substr(1, end - 1));
  text.remove_prefix(end + 1);
  const std::size_t equals = inside.find('=');
  std::string_view left = inside.substr(0, equals);
  if (equals != std::string_view::npos) {
    how = '=';
    if (!left.empty() && std::string_view("~|^$*").find(left.back()) != std::string_view::npos) {
      how = left.back();
      left.remove_suffix(1);
    }
    std::string_view right = trimmed(inside.substr(equals + 1));
    if (right.size() >= 2 && (right.front() == '"' || right.front() == '\'') && right.back() == right.front())
      right = right.substr(1, right.size() - 2);
    value = right;
  }
  name = trimmed(left);
  if (name.empty()) throw UnknownStyle("a selector that is not known");
}

bool has_class(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const std::size_t begin = list.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return false;
    list.remove_prefix(begin);
    const std::size_t end = std::min(list.find_first_of(kBlanks), list.size());
    if (list.substr(0, end) == name) return true;
    list.remove_prefix(end);
  }
  return false;
}

}  // namespace

std::vector<StyleSheet::Declaration> declarations(std::string_view text) {
  std::vector<StyleSheet::Declaration> list;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view entry = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t colon = entry.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view value = trimmed(entry.substr(colon + 1));
    const std::size_t mark = value.find('!');
    const bool important = mark != std::string_view::npos && trimmed(value.substr(mark + 1)) == "important";
    if (mark != std::string_view::npos) value = trimmed(value.substr(0, mark));
    list.push_back({std::string(trimmed(entry.substr(0, colon))), std::string(value), important});
  }
  return list;
}

void StyleSheet::add(std::string_view given) {
  const std::string css = without_comments(given);
  std::string_view text = css;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    if (text.starts_with("<!--")) {
      text.remove_prefix(4);
      continue;
    }
    if (text.starts_with("-->")) {
      text.remove_prefix(3);
      continue;
    }
    const std::size_t open = text.find('{');
    if (text[0] == '@') {
      const std::size_t end = text.find(';');
      const bool silent = text.starts_with("@font-face") || text.starts_with("@charset") || text.starts_with("@namespace");
      if (!silent) throw UnknownStyle("an @-rule");
      const std::size_t stop = end < open ? end : text.find('}');
      text.remove_prefix(stop == std::string_view::npos ? text.size() : stop + 1);
      continue;
    }
    const std::size_t close = text.find('}');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      throw UnknownStyle("a rule without braces");
    const std::string_view body = text.substr(open + 1, close - open - 1);
    if (body.find('{') != std::string_view::npos) throw UnknownStyle("rules in rules");
    add_rule(text.substr(0, open), body);
    text.remove_prefix(close + 1);
  }
}

bool StyleSheet::take_qualifiers(std::string_view& selector, Compound& compound, Rule& rule) {
  bool never = false;
  while (!selector.empty() && std::string_view(".#:[").find(selector[0]) != std::string_view::npos) {
    const char kind = selector[0];
    if (kind == '[') {
      Attribute& attribute = compound.attributes.emplace_back();
      take_attribute(selector, attribute.name, attribute.value, attribute.how);
      rule.weight += 1'000;
      continue;
    }
    selector.remove_prefix(1);
    const std::string name = take_name(selector);
    if (kind == '.') {
      compound.classes.push_back(name);
      rule.weight += 1'000;
    } else if (kind == '#') {
      compound.id = name;
      rule.weight += 1'000'000;
    } else if (name == "hover" || name == "active" || name == "focus" || name == "visited") {
      never = true;
    } else {
      throw UnknownStyle("a selector that is not known");
    }
  }
  return !never;
}

bool StyleSheet::take_path(std::string_view selector, Rule& rule) {
  bool ever = true, child = false;
  while (!selector.empty()) {
    Compound compound;
    compound.child = child;
    child = false;
    if (selector[0] == '*') {
      selector.remove_prefix(1);
    } else if (name_character(selector[0])) {
      compound.element = take_name(selector);
      rule.weight += 1;
    } else if (selector[0] != '.' && selector[0] != '#' && selector[0] != ':' && selector[0] != '[') {
      throw UnknownStyle("a selector that is not known");
    }
    ever = take_qualifiers(selector, compound, rule) && ever;
    rule.path.push_back(std::move(compound));
    const std::string_view rest = trimmed(selector);
    if (!rest.empty() && rest[0] == '>') {
      child = true;
      selector = trimmed(rest.substr(1));
      if (selector.empty()) throw UnknownStyle("a selector that is not known");
    } else if (rest.size() == selector.size() && !rest.empty()) {
      throw UnknownStyle("a selector that is not known");
    } else {
      selector = rest;
    }
  }
  return ever && !rule.path.empty();
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view body) {
  const std::vector<Declaration> said = declarations(body);
  while (!selectors.empty()) {
    const std::size_t comma = std::min(selectors.find(','), selectors.size());
    const std::string_view selector = trimmed(selectors.substr(0, comma));
    selectors.remove_prefix(std::min(comma + 1, selectors.size()));
    Rule rule;
    rule.declarations = said;
    if (!take_path(selector, rule)) continue;
    if (rules_.size() == kMostRules) throw std::invalid_argument("there are more than 10,000 rules of style");
    const Compound& own = rule.path.back();
    const std::string key = !own.id.empty()        ? "#" + own.id
                            : !own.classes.empty() ? "." + own.classes[0]
                            : own.element.empty()  ? "*"
                                                   : own.element;
    by_key_[key].push_back(static_cast<std::uint32_t>(rules_.size()));
    rules_.push_back(std::move(rule));
  }
}

bool StyleSheet::holds(const Compound& compound, const pugi::xml_node& node) const {
  if (++work_ > kMostWork) throw std::invalid_argument("the style sheets ask for endless work");
  if (!compound.element.empty() && local_name(node) != compound.element) return false;
  if (!compound.id.empty() && compound.id != node.attribute("id").value()) return false;
  const auto fits = [&](const Attribute& wanted) {
    const pugi::xml_attribute attribute = node.attribute(wanted.name.c_str());
    const std::string_view value = attribute.value();
    if (!attribute) return false;
    if (wanted.how == '\0') return true;
    if (wanted.how == '=') return value == wanted.value;
    if (wanted.value.empty()) return false;
    if (wanted.how == '~') return has_class(value, wanted.value);
    if (wanted.how == '^') return value.starts_with(wanted.value);
    if (wanted.how == '$') return value.ends_with(wanted.value);
    if (wanted.how == '*') return value.find(wanted.value) != std::string_view::npos;
    return value == wanted.value || value.starts_with(wanted.value + "-");
  };
  if (!std::all_of(compound.attributes.begin(), compound.attributes.end(), fits)) return false;
  return std::all_of(compound.classes.begin(), compound.classes.end(),
                     [&](const std::string& name) { return has_class(node.attribute("class").value(), name); });
}

/// Whether path[0..last] holds, its last part for this node.
bool StyleSheet::holds(const Rule& rule, std::size_t last, const pugi::xml_node& node) const {
  if (!holds(rule.path[last], node)) return false;
  if (last == 0) return true;
  for (pugi::xml_node outside = node.parent(); outside.type() == pugi::node_element; outside = outside.parent()) {
    if (holds(rule, last - 1, outside)) return true;
    if (rule.path[last].child) return false;
  }
  return false;
}

std::vector<const StyleSheet::Declaration*> StyleSheet::of(const pugi::xml_node& node) const {
  std::vector<std::uint32_t> found;
  const auto look = [&](const std::string& key) {
    const auto entry = by_key_.find(key);
    if (entry == by_key_.end()) return;
    for (const std::uint32_t rule : entry->second) {
      if (holds(rules_[rule], rules_[rule].path.size() - 1, node)) found.push_back(rule);
    }
  };
  look("*");
  look(std::string(local_name(node)));
  if (const pugi::xml_attribute id = node.attribute("id")) look("#" + std::string(id.value()));
  if (const pugi::xml_attribute list = node.attribute("class")) {
    std::string_view rest = list.value();
    while (!(rest = trimmed(rest)).empty()) {
      const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
      look("." + std::string(rest.substr(0, end)));
      rest.remove_prefix(end);
    }
  }
  std::sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
    return rules_[a].weight != rules_[b].weight ? rules_[a].weight < rules_[b].weight : a < b;
  });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<const Declaration*> said;
  for (const std::uint32_t rule : found) {
    for (const Declaration& declaration : rules_[rule].declarations) said.push_back(&declaration);
    work_ += kDeclarationWork * rules_[rule].declarations.size();
  }
  return said;
}

}  // namespace ligne::svg
