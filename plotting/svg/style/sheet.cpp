#include "plotting/svg/style/sheet.hpp"

#include <algorithm>
#include <utility>

#include "areas/work_limit_error.hpp"
#include "files/message_text.hpp"
#include "plotting/svg/values.hpp"
#include "plotting/svg/xml.hpp"

namespace ligne::svg {
namespace {

constexpr std::size_t kMostRules = 10'000;
/// Work of applying a declaration, in comparisons of an element with a part of a selector.
constexpr std::size_t kDeclarationWork = 20;
/// Deepest nesting of @media rules.
constexpr int kDeepestRules = 8;

/// Whether a list of media queries holds for paper: one of them names all media or print, without further conditions.
bool is_for_print(std::string_view media) {
  if (trimmed(media).empty()) return true;
  while (!media.empty()) {
    const std::size_t comma = std::min(media.find(','), media.size());
    const std::string query = lower_case(trimmed(media.substr(0, comma)));
    constexpr std::string_view kPrint[] = {"all", "only all", "print", "only print", "not screen", "not speech"};
    if (std::ranges::find(kPrint, query) != std::end(kPrint)) return true;
    media.remove_prefix(std::min(comma + 1, media.size()));
  }
  return false;
}

/// Most bytes of a value with its var() resolved.
constexpr std::size_t kLongestValue = std::size_t{1} << 16;
/// Most bytes of the properties of one element: a few names could ask for many long values.
constexpr std::size_t kLongestValues = std::size_t{1} << 20;
/// Deepest nesting of var(), in fallbacks of var() and through properties that refer to properties.
constexpr int kDeepestVariable = 32;

using VariableValues = std::map<std::string, std::string, std::less<>>;

/// Resolves the properties that one element defines, each once.
class VariableResolver {
 public:
  VariableResolver(const VariablesPointer& outer, VariableValues defined) : outer_(outer), defined_(std::move(defined)) {}

  std::optional<std::string> resolve(std::string_view value, int depth) {
    if (depth > kDeepestVariable) return {};
    std::string text;
    for (std::size_t at; (at = value.find("var(")) != std::string_view::npos;) {
      text += value.substr(0, at);
      value.remove_prefix(at + 4);
      std::string_view inside = take_block(value, ')');
      const std::size_t comma = find_outside(inside, ",");
      std::optional<std::string> found = value_of(trimmed(inside.substr(0, comma)), depth);
      if (!found && comma != std::string_view::npos) found = resolve(trimmed(inside.substr(comma + 1)), depth + 1);
      if (!found) return {};
      text += *found;
      if (text.size() > kLongestValue) return {};
    }
    text += value;
    if (text.size() > kLongestValue) return {};
    return text;
  }

  VariableValues all() {
    VariableValues values;
    for (const auto& [name, value] : defined_) {
      std::optional<std::string> found = value_of(name, 0);
      if (found && total_ <= kLongestValues) values.emplace(name, std::move(*found));
    }
    return values;
  }

 private:
  std::optional<std::string> value_of(std::string_view name, int depth) {
    const auto own = defined_.find(name);
    if (own == defined_.end()) {
      for (const Variables* at = outer_.get(); at; at = at->outer.get()) {
        const auto found = at->values.find(name);
        if (found != at->values.end()) return found->second;
      }
      return {};
    }
    const auto [known, is_new] = done_.emplace(name, std::nullopt);
    // A property that is being resolved has no value: it leads back to itself.
    if (!is_new) return known->second;
    std::optional<std::string> value = total_ <= kLongestValues ? resolve(own->second, depth + 1) : std::nullopt;
    if (value) total_ += value->size();
    return known->second = std::move(value);
  }

  const VariablesPointer& outer_;
  VariableValues defined_;
  std::map<std::string, std::optional<std::string>, std::less<>> done_;
  std::size_t total_ = 0;  ///< bytes of the resolved values
};

}  // namespace

void StyleSheet::add(std::string_view given, std::string_view media, const Unknown& unknown) {
  if (!is_for_print(media)) return unknown("style sheets for other media than print");
  add_statements(without_comments(given), 0, unknown);
}

void StyleSheet::add_statements(std::string_view text, int depth, const Unknown& unknown) {
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    if (text.starts_with("<!--")) {
      text.remove_prefix(4);
    } else if (text.starts_with("-->")) {
      text.remove_prefix(3);
    } else if (text[0] == '@') {
      add_at_rule(text, depth, unknown);
    } else {
      const std::size_t open = find_outside(text, "{");
      if (open == std::string_view::npos) return unknown("style rules without braces");
      const std::string_view selectors = text.substr(0, open);
      text.remove_prefix(open + 1);
      add_rules(selectors, take_block(text, '}'), unknown);
    }
  }
}

void StyleSheet::add_at_rule(std::string_view& text, int depth, const Unknown& unknown) {
  text.remove_prefix(1);
  const std::string name = lower_case(take_css_name(text));
  const std::size_t end = std::min(find_outside(text, ";{"), text.size());
  const std::string_view head = text.substr(0, end);
  const bool has_block = end < text.size() && text[end] == '{';
  text.remove_prefix(std::min(end + 1, text.size()));
  const std::string_view body = has_block ? take_block(text, '}') : std::string_view();
  if (name == "font-face" || name == "charset" || name == "namespace") return;
  if (name == "media" && has_block && depth < kDeepestRules && is_for_print(head))
    return add_statements(body, depth + 1, unknown);
  unknown("@" + printable(name) + " rules");
}

void StyleSheet::add_rules(std::string_view selectors, std::string_view body, const Unknown& unknown) {
  if (has_rules(body)) unknown("style rules inside others");
  declarations_.push_back(declarations(body));
  while (!selectors.empty()) {
    Rule rule;
    try {
      rule.selector = take_selector(selectors);
    } catch (const UnknownStyle& e) {
      unknown(e.what());
      continue;
    }
    if (rule.selector.never) continue;
    if (rules_.size() == kMostRules) throw WorkLimitError("there are more than 10,000 style rules");
    rule.declarations = static_cast<std::uint32_t>(declarations_.size() - 1);
    const Compound& own = rule.selector.path.back();
    const std::string key = !own.id.empty()        ? "#" + own.id
                            : !own.classes.empty() ? "." + own.classes[0]
                            : own.element.empty()  ? "*"
                                                   : own.element;
    by_key_[key].push_back(static_cast<std::uint32_t>(rules_.size()));
    rules_.push_back(std::move(rule));
  }
}

bool StyleSheet::sets(std::string_view property) const {
  return std::ranges::any_of(declarations_, [&](const std::vector<Declaration>& rule) {
    return std::ranges::any_of(rule, [&](const Declaration& declaration) { return declaration.name == property; });
  });
}

std::vector<const Declaration*> StyleSheet::of(const pugi::xml_node& node) const {
  std::vector<std::uint32_t> found;
  const auto look = [&](const std::string& key) {
    const auto entry = by_key_.find(key);
    if (entry == by_key_.end()) return;
    for (const std::uint32_t rule : entry->second) {
      if (holds(rules_[rule].selector, node, work_)) found.push_back(rule);
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
    const std::uint32_t weight_a = rules_[a].selector.weight, weight_b = rules_[b].selector.weight;
    return weight_a != weight_b ? weight_a < weight_b : a < b;
  });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<const Declaration*> matching;
  for (const std::uint32_t rule : found) {
    for (const Declaration& declaration : declarations_[rules_[rule].declarations]) matching.push_back(&declaration);
    work_.comparisons += kDeclarationWork * declarations_[rules_[rule].declarations].size();
  }
  return matching;
}

VariablesPointer with_variables(VariablesPointer outer, VariableValues defined) {
  auto made = std::make_shared<Variables>();
  made->values = VariableResolver(outer, std::move(defined)).all();
  made->outer = std::move(outer);
  return made;
}

std::optional<std::string> resolved(std::string_view value, const VariablesPointer& variables) {
  return VariableResolver(variables, {}).resolve(value, 0);
}

}  // namespace ligne::svg
