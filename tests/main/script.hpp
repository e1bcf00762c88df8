#pragma once
/// Tests that are written as text: a file of scripts, each of which is a test of GoogleTest by itself.
///
///     suite Draw                         the name of the suite; what stands before the first test is done in each of them
///     let cell = 0 1 2                   {cell} stands for the text from here on
///     == ATest                           begins a test
///     # a remark
///     a step | check | check             what a step and its checks mean is a matter of the area
///       | a further check
///     for x: 1 2 'three words'           the steps below that are indented are done for each, with {x} for the value
///       a step with {x}
///     for x, 1 of 3: a b c               in the first tier one value of three
///     file NAME <<                       a step with a text of several lines
///     the text
///     >>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ligne::test {

struct ScriptStep {
  std::string line, text;  ///< text: what stands between << and >>
  std::vector<std::string> checks;
  std::string place;  ///< "draw.txt:12"
};

struct Script {
  std::string suite, name;
  std::filesystem::path file;
  int line = 0;
  std::vector<ScriptStep> steps;
};

std::vector<Script> read_scripts(const std::filesystem::path& file);

/// Makes tests of all scripts of the folder; `run` does the steps of one.
bool add_scripts(const std::filesystem::path& folder, const std::function<void(const Script&)>& run);

/// Functions of a text, by their names, that give a text. A step is a function and its text, which may be empty; checks:
///
///     = TEXT       what it gives, to the letter
///     fails        it throws, with one line; says LINE: that line; tells PART: a part of it
using TextFunctions = std::map<std::string, std::function<std::string(const std::string&)>>;

/// Makes tests of all scripts of the folder whose steps are calls of the functions.
bool add_function_scripts(const std::filesystem::path& folder, const TextFunctions& functions);

/// The shortest text that stands for the number; numbers with spaces between them.
std::string as_text(double value);
template <class... Rest>
std::string as_text(double first, double second, Rest... rest) {
  return as_text(first) + " " + as_text(second, rest...);
}

/// The text with characters in place of \n, \t, \r, \s (a space), \\ and \xHH.
std::string unescaped(std::string_view text);

/// The words of a line. It is taken apart at its spaces, but for what stands in '...'.
std::vector<std::string> words_of(std::string_view line);

/// The parts of a text between the separators.
std::vector<std::string> parts_of(const std::string& text, char separator);

/// Takes the first word off the text, with the spaces behind it.
std::string take_word(std::string_view& text);

/// The value of a sum of products and quotients of numbers and pi, such as "2*pi*3+1".
double value_of(std::string_view expression);

/// Compares two numbers by =, !=, <, >, <= or >=; = within the tolerance.
bool holds(double left, std::string_view comparison, double right, double tolerance);

}  // namespace ligne::test
