#include "scene/surfaces/formula/formula_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <system_error>
#include <utility>

#include "base/portable.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// NaN in any argument (a hole) gives NaN, even where the comparison would pick another argument.
double smallest(const double* values, int n) {
  double out = values[0];
  for (int i = 1; i < n; ++i) out = values[i] < out || std::isnan(values[i]) ? values[i] : out;
  return out;
}
double largest(const double* values, int n) {
  double out = values[0];
  for (int i = 1; i < n; ++i) out = values[i] > out || std::isnan(values[i]) ? values[i] : out;
  return out;
}
double sign(double a) { return std::isnan(a) ? a : double((a > 0) - (a < 0)); }
double choice(double condition, double a, double b) { return std::isnan(condition) ? kNaN : condition != 0 ? a : b; }

/// Has the sign of b, so that mod(x, 1) continues evenly through zero.
double modulo(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

constexpr auto kFunctions = std::to_array<FormulaFunction>({
    {"sin", +[](double a) { return std::sin(a); }},
    {"cos", +[](double a) { return std::cos(a); }},
    {"tan", +[](double a) { return std::tan(a); }},
    {"asin", +[](double a) { return std::asin(a); }},
    {"acos", +[](double a) { return std::acos(a); }},
    {"atan", +[](double a) { return std::atan(a); }},
    {"arcsin", +[](double a) { return std::asin(a); }},
    {"arccos", +[](double a) { return std::acos(a); }},
    {"arctan", +[](double a) { return std::atan(a); }},
    {"sinh", +[](double a) { return std::sinh(a); }},
    {"cosh", +[](double a) { return std::cosh(a); }},
    {"tanh", +[](double a) { return std::tanh(a); }},
    {"asinh", +[](double a) { return std::asinh(a); }},
    {"acosh", +[](double a) { return std::acosh(a); }},
    {"atanh", +[](double a) { return std::atanh(a); }},
    {"sec", +[](double a) { return 1 / std::cos(a); }},
    {"csc", +[](double a) { return 1 / std::sin(a); }},
    {"cot", +[](double a) { return std::cos(a) / std::sin(a); }},
    {"sinc", +[](double a) { return a == 0 ? 1 : std::sin(a) / a; }},
    {"erf", +[](double a) { return std::erf(a); }},
    {"erfc", +[](double a) { return std::erfc(a); }},
    {"gamma", +[](double a) { return std::tgamma(a); }},
    {"j0", +[](double a) { return ::j0(a); }},  // Bessel functions of the first kind, of order 0 and 1
    {"j1", +[](double a) { return ::j1(a); }},
    {"cbrt", +[](double a) { return std::cbrt(a); }},
    {"sqrt", +[](double a) { return std::sqrt(a); }},
    {"exp", +[](double a) { return std::exp(a); }},
    {"log", +[](double a) { return std::log(a); }},
    {"ln", +[](double a) { return std::log(a); }},
    {"log10", +[](double a) { return std::log10(a); }},
    {"log2", +[](double a) { return std::log2(a); }},
    {"abs", +[](double a) { return std::abs(a); }},
    {"floor", +[](double a) { return std::floor(a); }},
    {"ceil", +[](double a) { return std::ceil(a); }},
    {"round", +[](double a) { return std::round(a); }},
    {"sign", sign},
    {"sgn", sign},
    {"atan2", +[](double a, double b) { return std::atan2(a, b); }},
    {"pow", +[](double a, double b) { return std::pow(a, b); }},
    {"hypot", +[](double a, double b) { return std::hypot(a, b); }},
    {"mod", modulo},
    {"if", choice},
    {"min", smallest},
    {"max", largest},
});

constexpr std::array kConstants{FormulaConstant{"pi", std::numbers::pi}, FormulaConstant{"e", std::numbers::e}};

/// A character of printed formulas, and its typed replacement.
struct Typeset {
  std::string_view utf8, ascii;
};
constexpr auto kTypeset = std::to_array<Typeset>({{"\u00b2", "^2"},
                                                  {"\u00b3", "^3"},
                                                  {"\u2074", "^4"},
                                                  {"\u2075", "^5"},
                                                  {"\u2076", "^6"},
                                                  {"\u00b7", "*"},
                                                  {"\u00d7", "*"},
                                                  {"\u22c5", "*"},
                                                  {"\u00f7", "/"},
                                                  {"\u2212", "-"},
                                                  {"\u2264", "<="},
                                                  {"\u2265", ">="},
                                                  {"\u03c0", "pi"}});

// The functions of <cctype> are not used, since they depend on the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

template <typename Table>
bool has_name(const Table& table, std::string_view name) {
  return std::any_of(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; });
}

/// Reads the formula once, token by token.
class Preparation {
 public:
  Preparation(std::string_view formula, FormulaLanguage language) : formula_(formula) {
    out_.uses.assign(language.variables.size(), false);
    out_.language = std::move(language);
  }

  FormulaText run() {
    skip_left_side();
    while (skip_blanks(), at_ < formula_.size()) {
      const char c = formula_[at_];
      if (is_digit(c) || c == '.')
        take_number();
      else if (is_letter(c))
        take_name();
      else
        take_sign(c);
    }
    if (!open_.empty()) {
      throw formula_error(out_.language, open_.back().at + 1,
                          open_.back().is_bar ? "'|' without a second one" : "'(' without its ')'");
    }
    if (out_.text.empty()) throw formula_error(out_.language, 1, "is empty");
    out_.columns.push_back(formula_.size() + 1);
    return std::move(out_);
  }

 private:
  InputError error(const std::string& cause) const { return formula_error(out_.language, at_ + 1, cause); }

  /// Lists the names, such as "x, y, pi and e".
  std::string names() const {
    std::string list;
    for (const std::string_view variable : out_.language.variables) list += std::string(variable) + ", ";
    return list + "pi and e";
  }

  static std::string function_names() {
    std::string list;
    for (const FormulaFunction& function : kFunctions) list += (list.empty() ? "" : " ") + std::string(function.name);
    return list;
  }

  /// Skips "z =" or "f(x,y) =".
  void skip_left_side() {
    const std::size_t at = formula_.find('=');
    if (at == std::string_view::npos) return;
    std::string left(formula_.substr(0, at));
    std::erase_if(left, is_blank);
    if ((left == "z" || left == "f(x,y)") && !formula_.substr(at).starts_with("==")) at_ = at + 1;
  }

  void skip_blanks() {
    while (at_ < formula_.size() && (is_blank(formula_[at_]) || formula_[at_] == '\n' || formula_[at_] == '\r')) ++at_;
  }

  void emit(std::string_view text, std::size_t length) {
    for (std::size_t i = 0; i < text.size(); ++i) out_.columns.push_back(at_ + i + 1);
    out_.text += text;
    at_ += length;
  }

  /// Multiplies a value by one that follows it without an operator, as in "2x". Throws where that can be meant otherwise:
  /// before a number, in "x(2)", in "1/2x", and in "e^2x".
  void begin_value(std::string_view token) {
    if (after_value_) {
      if (is_digit(token.front()) || token.front() == '.' || is_divisor_ || is_exponent_ ||
          (token == "(" && is_letter(out_.text.back())))
        throw error("an operator is missing before " + shown(token));
      emit("*", 0);
    }
    after_value_ = true;
  }

  void open(std::string_view text, bool is_bar) {
    open_.push_back({at_, is_bar, is_divisor_});
    emit(text, 1);
    after_value_ = is_divisor_ = is_exponent_ = false;
  }

  void close() {
    is_divisor_ = open_.back().is_divisor;
    open_.pop_back();
    emit(")", 1);
    after_value_ = true;
    is_exponent_ = false;
  }

  void take_number() {
    const char* const begin = formula_.data() + at_;
    double value = 0;
    const auto [end, failure] = from_chars(begin, formula_.data() + formula_.size(), value);
    const std::string_view token(begin, static_cast<std::size_t>(end - begin));
    if (failure == std::errc::invalid_argument) throw error("'.' is not a number");
    if (failure != std::errc{} || !std::isfinite(value)) throw error(shown(token) + " is out of the range of numbers");
    begin_value(token);
    emit(token, token.size());
  }

  void take_name() {
    std::size_t end = at_;
    while (end < formula_.size() && (is_letter(formula_[end]) || is_digit(formula_[end]))) ++end;
    const std::string_view name = formula_.substr(at_, end - at_);
    const std::size_t next = formula_.find_first_not_of(" \t\v\f\r\n", end);
    const bool is_call = next != std::string_view::npos && formula_[next] == '(';

    const auto variables = out_.language.variables;
    if (const auto variable = std::ranges::find(variables, name); variable != variables.end()) {
      out_.uses[static_cast<std::size_t>(variable - variables.begin())] = true;
    } else if (has_name(kFunctions, name)) {
      if (!is_call) throw error("function " + shown(name) + " without its arguments in parentheses");
    } else if (!has_name(kConstants, name)) {
      throw error(is_call ? "unknown function " + shown(name) + "; there are " + function_names()
                          : "unknown name " + shown(name) + "; there are " + names());
    }
    begin_value(name);
    if (has_name(kFunctions, name)) after_value_ = false;
    emit(name, name.size());
  }

  void take_sign(char c) {
    const std::string_view rest = formula_.substr(at_);
    for (const Typeset& typeset : kTypeset) {
      if (rest.starts_with(typeset.utf8)) return take_typeset(typeset);
    }
    if (c == '|' && after_value_ && !open_.empty() && open_.back().is_bar) return close();
    if (c == '|' && (!after_value_ || !rest.starts_with("||"))) {
      begin_value("|");
      return open("abs(", true);
    }
    for (const std::string_view two : {"<=", ">=", "!=", "==", "&&", "||"}) {
      if (rest.starts_with(two)) return take_operator(two, two.size());
    }
    if (rest.starts_with("**")) return take_operator("^", 2);
    if (c == '=') throw error("assignment is not allowed; use == to compare");
    if (c == '(') {
      begin_value("(");
      return open("(", false);
    }
    if (c == ')') {
      if (open_.empty() || open_.back().is_bar) throw error("')' without its '('");
      return close();
    }
    if (c == ',' && open_.empty()) throw error("',' outside the arguments of a function");
    if (std::string_view("+-*/^<>?:,").find(c) == std::string_view::npos) {
      std::size_t end = 1;  // bytes of the character in UTF-8
      while (end < rest.size() && (static_cast<unsigned char>(rest[end]) & 0xc0) == 0x80) ++end;
      throw error("character " + shown(rest.substr(0, end)) + " is not allowed in a formula");
    }
    take_operator(rest.substr(0, 1), 1);
  }

  /// Inserts the plain form of a typeset character into the text, at the column of the character.
  void take_typeset(const Typeset& typeset) {
    if (typeset.ascii == "pi") begin_value(typeset.utf8);
    const std::size_t place = at_;
    emit(typeset.ascii, typeset.utf8.size());
    std::fill(out_.columns.end() - static_cast<std::ptrdiff_t>(typeset.ascii.size()), out_.columns.end(), place + 1);
    after_value_ = typeset.ascii.front() == '^' || typeset.ascii == "pi";
    if (!after_value_) is_divisor_ = typeset.ascii == "/";
  }

  void take_operator(std::string_view text, std::size_t length) {
    const bool after_number =
        !out_.text.empty() && std::string_view("0123456789.ei").find(out_.text.back()) != std::string_view::npos;
    is_exponent_ = text == "^" && after_number;  // also after e and pi
    emit(text, length);
    after_value_ = false;
    if (text != "^") is_divisor_ = text == "/";
  }

  std::string_view formula_;
  std::size_t at_ = 0;
  bool after_value_ = false;  ///< the token before ended a value
  bool is_divisor_ = false;   ///< the value is divided by
  bool is_exponent_ = false;  ///< the value is an exponent of a number, which may go on
  struct Parenthesis {
    std::size_t at;
    bool is_bar, is_divisor;
  };
  std::vector<Parenthesis> open_;
  FormulaText out_;
};

}  // namespace

std::span<const FormulaFunction> formula_functions() { return kFunctions; }
std::span<const FormulaConstant> formula_constants() { return kConstants; }

FormulaText prepare_formula(std::string_view formula, FormulaLanguage language) {
  if (formula.size() > kLongestFormula) {
    throw formula_error(language, kLongestFormula + 1, "is longer than " + std::to_string(kLongestFormula) + " characters");
  }
  return Preparation(formula, std::move(language)).run();
}

InputError formula_error(const FormulaLanguage& language, std::size_t column, const std::string& cause) {
  return InputError(language.name + ":" + std::to_string(column), cause);
}

}  // namespace ligne
