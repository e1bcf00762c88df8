#include "main/script.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "main/tier.hpp"

namespace ligne::test {
namespace {

struct Line {
  std::size_t indent;
  std::string text;
  int number;
};

std::vector<Line> lines_of(const std::filesystem::path& file) {
  std::vector<Line> lines;
  std::ifstream in(file);
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    const std::size_t indent = std::min(text.find_first_not_of(' '), text.size());
    lines.push_back({indent, text.substr(indent), ++number});
  }
  return lines;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file), lines_(lines_of(file)) {}

  std::vector<Script> scripts() {
    std::vector<Script> scripts;
    std::vector<ScriptStep> common;
    std::string suite;
    while (at_ < lines_.size()) {
      const Line& line = lines_[at_];
      if (line.text.starts_with("suite ")) {
        suite = line.text.substr(6);
        ++at_;
      } else if (line.text.starts_with("== ")) {
        scripts.push_back({suite, line.text.substr(3), file_, line.number, common});
        ++at_;
        const auto before = names_;
        read_steps(0, scripts.back().steps);
        names_ = before;
      } else {
        read_steps(0, common);
      }
    }
    return scripts;
  }

 private:
  /// Reads the steps that are indented so far at least, up to the next test.
  void read_steps(std::size_t indent, std::vector<ScriptStep>& steps) {
    while (at_ < lines_.size()) {
      const Line line = lines_[at_];
      const bool is_blank = line.text.empty() || line.text.starts_with("#");
      if (!is_blank && (line.indent < indent || line.text.starts_with("== ") || line.text.starts_with("suite "))) return;
      ++at_;
      if (is_blank) continue;
      if (line.text.starts_with("let ")) {
        std::string_view rest = std::string_view(line.text).substr(4);
        const std::string name = take_word(rest);
        take_word(rest);
        names_[name] = filled(std::string(rest));
      } else if (line.text.starts_with("for ")) {
        read_loop(line, steps);
      } else if (line.text.starts_with("| ")) {
        if (steps.empty()) throw std::invalid_argument(place(line) + ": a check without a step");
        add_checks(filled(line.text), steps.back());
      } else {
        add_step(line, steps);
      }
    }
  }

  void read_loop(const Line& line, std::vector<ScriptStep>& steps) {
    const std::size_t colon = line.text.find(": "), begin = at_;
    const std::string head = line.text.substr(4, colon - 4), name = head.substr(0, head.find(','));
    const std::size_t of = head.find(", 1 of "), one_in = of == head.npos ? 1 : std::stoul(head.substr(of + 7));
    std::size_t number = 0;
    for (const std::string& value : words_of(filled(line.text.substr(colon + 2)))) {
      at_ = begin;
      if (!is_chosen(place(line), number++, one_in)) {
        std::vector<ScriptStep> left_out;
        read_steps(line.indent + 1, left_out);
        continue;
      }
      names_[name] = value;
      read_steps(line.indent + 1, steps);
    }
    names_.erase(name);
  }

  void add_step(const Line& line, std::vector<ScriptStep>& steps) {
    const std::string text = filled(line.text);
    const std::size_t bar = text.find(" | ");
    steps.push_back({text.substr(0, bar), {}, {}, place(line)});
    if (bar != std::string::npos) add_checks(text.substr(bar), steps.back());
    if (!text.ends_with("<<")) return;
    for (; at_ < lines_.size() && lines_[at_].text != ">>"; ++at_)
      steps.back().text += std::string(lines_[at_].indent, ' ') + filled(lines_[at_].text) + '\n';
    ++at_;
  }

  static void add_checks(const std::string& text, ScriptStep& step) {
    for (std::size_t at = text.find("| "); at != std::string::npos;) {
      const std::size_t next = text.find(" | ", at + 2);
      step.checks.push_back(text.substr(at + 2, next == std::string::npos ? next : next - at - 2));
      at = next == std::string::npos ? next : next + 1;
    }
  }

  /// The names may stand for others in turn: {size-of-{kind}}.
  std::string filled(std::string text) const {
    for (std::string before; before != text;) {
      before = text;
      for (const auto& [name, value] : names_) {
        const std::string sign = "{" + name + "}";
        for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + value.size()))
          text.replace(at, sign.size(), value);
      }
    }
    return text;
  }

  std::string place(const Line& line) const { return file_.filename().string() + ":" + std::to_string(line.number); }

  std::filesystem::path file_;
  std::vector<Line> lines_;
  std::size_t at_ = 0;
  std::map<std::string, std::string> names_;
};

class ScriptTest : public testing::Test {
 public:
  ScriptTest(const Script& script, const std::function<void(const Script&)>& run) : script_(script), run_(run) {}
  void TestBody() override { run_(script_); }

 private:
  Script script_;
  std::function<void(const Script&)> run_;
};

double product_of(std::string_view text) {
  double product = 1;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find_first_of("*/", begin), text.size());
    const std::string_view factor = text.substr(begin, end - begin);
    const double value = factor == "pi" ? std::numbers::pi : std::stod(std::string(factor));
    product = begin > 0 && text[begin - 1] == '/' ? product / value : product * value;
    begin = end + 1;
  }
  return product;
}

}  // namespace

std::vector<Script> read_scripts(const std::filesystem::path& file) { return Reader(file).scripts(); }

bool add_scripts(const std::filesystem::path& folder, const std::function<void(const Script&)>& run) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    for (const Script& script : read_scripts(file))
      testing::RegisterTest(script.suite.c_str(), script.name.c_str(), nullptr, nullptr, script.file.c_str(), script.line,
                            [script, run]() -> testing::Test* { return new ScriptTest(script, run); });
  }
  return !files.empty();
}

namespace {

void run_functions(const Script& script, const TextFunctions& functions) {
  for (const ScriptStep& step : script.steps) {
    SCOPED_TRACE(step.place + ": " + step.line);
    std::string_view rest = step.line;
    const auto& function = functions.at(take_word(rest));
    std::string found, error;
    try {
      found = function(unescaped(rest));
    } catch (const std::exception& thrown) {
      error = thrown.what();
    }
    ASSERT_FALSE(step.checks.empty());
    for (const std::string& check : step.checks) {
      std::string_view text = check;
      const std::string verb = take_word(text), wanted = unescaped(text);
      EXPECT_EQ(error.empty(), verb == "=") << error << found;
      EXPECT_EQ(error.find('\n'), error.npos) << error;
      if (verb == "=") {
        EXPECT_EQ(found, wanted);
      } else if (verb == "says") {
        EXPECT_EQ(error, wanted);
      } else if (verb == "tells") {
        EXPECT_NE(error.find(wanted), error.npos) << error;
      } else {
        EXPECT_EQ(verb, "fails");
      }
    }
  }
}

}  // namespace

bool add_function_scripts(const std::filesystem::path& folder, const TextFunctions& functions) {
  return add_scripts(folder, [functions](const Script& script) { run_functions(script, functions); });
}

std::string as_text(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string unescaped(std::string_view text) {
  static const std::map<char, char> kEscapes{{'n', '\n'}, {'t', '\t'}, {'r', '\r'}, {'s', ' '}};
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
    } else if (text[++i] == 'x') {
      out += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      const auto known = kEscapes.find(text[i]);
      out += known == kEscapes.end() ? text[i] : known->second;
    }
  }
  return out;
}

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  bool quoted = false, in_word = false;
  for (const char c : line) {
    const bool is_quote = c == '\'';
    if (is_quote) quoted = !quoted;
    const bool is_gap = c == ' ' && !quoted;
    if (!is_gap && !in_word) words.emplace_back();
    in_word = !is_gap;
    if (!is_gap && !is_quote) words.back() += c;
  }
  return words;
}

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

std::string take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  const std::string word(text.substr(0, end));
  text.remove_prefix(std::min(text.find_first_not_of(' ', end), text.size()));
  return word;
}

double value_of(std::string_view expression) {
  double sum = 0;
  for (std::size_t begin = 0; begin < expression.size();) {
    std::size_t end = expression.find_first_of("+-", begin + 1);
    while (end < expression.size() && expression[end - 1] == 'e') end = expression.find_first_of("+-", end + 1);
    end = std::min(end, expression.size());
    const bool signed_term = expression[begin] == '+' || expression[begin] == '-';
    const double term = product_of(expression.substr(begin + signed_term, end - begin - signed_term));
    sum += expression[begin] == '-' ? -term : term;
    begin = end;
  }
  return sum;
}

bool holds(double left, std::string_view comparison, double right, double tolerance) {
  if (comparison == "=") return std::abs(left - right) <= tolerance;
  if (comparison == "!=") return std::abs(left - right) > tolerance;
  if (comparison == "<") return left < right;
  if (comparison == "<=") return left <= right;
  if (comparison == ">") return left > right;
  if (comparison == ">=") return left >= right;
  throw std::invalid_argument("no comparison: " + std::string(comparison));
}

}  // namespace ligne::test
