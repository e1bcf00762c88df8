/// Tests of the command that are written as text, in the folder scripts. A step is a command line; the command ends with
/// status 0, or as the check "exit" says: then it leaves one line on standard error and nothing on standard output, and all
/// files are as they were.
///
///     drawn ARGUMENTS       ligne draw ARGUMENTS -o - --format json, without a word on standard error
///     surfaced ARGUMENTS    the same for ligne surface
///     layered ARGUMENTS     ligne surface ARGUMENTS -o - --format svg: lengths of its layers in mm
///     piped FILE COMMAND    one of these, with the file as standard input, through a pipe
///     file NAME = TEXT      writes a file; also file NAME <<
///     model NAME = LINE     writes an OBJ of a line of mesh_text.hpp, or of several: model NAME <<
///     copy FROM TO; link TO NAME; hard-link TO NAME; folder NAME; pipe NAME
///
/// {source} is the folder of the project. Checks, where OP is = != < > <= or >=, and = may be followed by "+- TOLERANCE":
///
///     exit N; says LINE; begins TEXT; quiet; lines OP N       the line on standard error behind "ligne: "; its start; none
///     WHERE has TEXT; WHERE has N of TEXT; WHERE lacks TEXT   in out, err or a file; also: begins, is, same FILE, differs,
///                                                         matches REGEX, mismatches
///     FILE writes FILE...; no FILE; bytes WHERE OP N               the files that there are more than at the start; sizes
///     keep NAME; as NAME; unlike NAME                         strokes of a drawing, or all that was written to out
///     keep-json NAME POINTER; as-json ...; unlike-json ...    a part of the JSON
///     keep-pieces NAME FILE; as-pieces ...; unlike-pieces ... the lines of a JSON drawing in out or FILE, in any order:
///     class,
///                                                             source, and interval to a ten-thousandth
///     keep-number NAME SUM                                    a sum, which is $NAME in later numbers
///     beside NAME QUANTITY OP N                               the difference of a quantity from the one that was kept
///     classes CLASS N, ...                                    numbers of strokes by class, all of them; hidden ones: hidden
///     QUANTITY OP NUMBER     the number of strokes of a class, or strokes; width, height, left, right, top, bottom in mm,
///                            y/x; least-x:CLASS, most-x:CLASS; mm:CLASS, hidden-mm:CLASS and units:CLASS, the length of its
///                            lines (mm:all: of all) that are seen or hidden, in mm and in model units; most:CLASS:z and
///                            least:CLASS:z; a layer's length in mm, all:LAYER, paths:LAYER; drawn:FILE and
///                            drawn:FILE:LAYER, mm of the lines of an SVG; bytes:FILE; count:FILE:TEXT; down, mm on the
///                            paper as --report has it; a number of the JSON
///     SUM OP SUM             of products of numbers and quantities: 2*mm:crease+$before
///     POINTER OP JSON; POINTER has KEY; size POINTER OP N     of the JSON in out, or FILE:POINTER; /a/*/b: b of each part
///     of a

#include <sys/stat.h>
#include <regex>

#include "drawing_quantities.hpp"
#include "main/script.hpp"
#include "program.hpp"
#include "support/mesh_text.hpp"

namespace ligne::test {
namespace {

const std::set<std::string> kKeeping{"keep",        "as",          "unlike",    "keep-json",     "as-json",
                                     "unlike-json", "keep-pieces", "as-pieces", "unlike-pieces", "keep-number"};

class CommandScript : public SurfaceProgramTest {
 public:
  void TestBody() override {}
  void run_steps(const Script& script) {
    SetUp();
    for (const ScriptStep& step : script.steps) {
      SCOPED_TRACE(step.place + ": " + step.line);
      do_step(step);
    }
    TearDown();
  }

 private:
  static std::string with_source(std::string text) {
    for (std::size_t at; (at = text.find("{source}")) != text.npos;) text.replace(at, 8, LIGNE_SOURCE_DIR);
    return text;
  }

  void do_step(const ScriptStep& step) {
    std::string_view rest = step.line;
    const std::string verb = take_word(rest);
    if (verb == "file") {
      const std::string name = unescaped(take_word(rest));
      write(name, take_word(rest) == "=" ? unescaped(rest) : step.text);
    } else if (verb == "model") {
      const std::string name = take_word(rest);
      if (take_word(rest) == "=")
        write(name, obj_of_mesh(std::string(rest)));
      else
        write(name, obj_of_mesh(step.text));
    } else if (verb == "piped") {
      const std::string input = contents(file(take_word(rest)));
      run_command(step, std::string(rest), &input);
    } else if (!made_file(verb, words_of(rest))) {
      run_command(step, step.line);
    }
  }

  bool made_file(const std::string& verb, const std::vector<std::string>& names) const {
    const auto path = [&](std::size_t i) { return file(unescaped(names.at(i))); };
    if (verb == "copy") return std::filesystem::copy_file(path(0), path(1));
    if (verb == "folder") return std::filesystem::create_directory(path(0));
    if (verb == "pipe") return mkfifo(path(0).c_str(), 0600) == 0;
    if (verb == "link") std::filesystem::create_symlink(names.at(0), path(1));
    if (verb == "hard-link") std::filesystem::create_hard_link(path(0), path(1));
    return verb == "link" || verb == "hard-link";
  }

  /// The bytes of all files, by their paths.
  std::map<std::string, std::string> all_files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      files[entry.path().string()] = entry.is_regular_file() ? contents(entry.path()) : "";
    return files;
  }

  void run_command(const ScriptStep& step, const std::string& line, const std::string* piped = nullptr) {
    std::vector<std::string> words;
    for (const std::string& word : words_of(with_source(line))) words.push_back(unescaped(word));
    const std::string verb = words.at(0);
    const bool is_json = verb == "drawn" || verb == "surfaced", is_layered = verb == "layered";
    if (is_json || is_layered) {
      words.front() = verb == "drawn" ? "draw" : "surface";
      words.insert(words.end(), {"-o", "-", "--format", is_json ? "json" : "svg"});
    }
    int status = kDone;
    for (const std::string& check : step.checks)
      if (check.starts_with("exit ")) status = std::stoi(check.substr(5));
    const auto before = status == kDone ? std::map<std::string, std::string>() : all_files();
    outcome_ = run_ligne(folder_, words, piped);
    ASSERT_EQ(outcome_.status, status) << outcome_.err;
    drawing_ = is_json ? json::parse(outcome_.out) : json();
    layers_.clear();
    if (is_layered) layers_ = layers_of(outcome_.out);
    if (is_json || is_layered) {
      EXPECT_EQ(outcome_.err, "");
    }
    if (status != kDone) {
      EXPECT_EQ(outcome_.out, "");
      EXPECT_EQ(outcome_.error_lines(), 1u) << outcome_.err;
      EXPECT_TRUE(outcome_.err.starts_with("ligne: ")) << outcome_.err;
      EXPECT_EQ(all_files(), before) << line;
    }
    for (const std::string& check : step.checks) {
      SCOPED_TRACE(check);
      do_check(check);
    }
  }

  void do_check(const std::string& check) {
    std::string_view rest = check;
    const std::string subject = take_word(rest), text = with_source(std::string(rest));
    if (subject == "exit") return;
    if (subject == "says") {
      EXPECT_EQ(outcome_.err, "ligne: " + unescaped(text) + "\n");
    } else if (subject == "quiet") {
      EXPECT_EQ(outcome_.err, "");
    } else if (subject == "begins") {
      EXPECT_TRUE(outcome_.err.starts_with("ligne: " + unescaped(text))) << outcome_.err;
      EXPECT_EQ(outcome_.error_lines(), 1u) << outcome_.err;
    } else if (subject == "writes") {
      std::vector<std::string> names;
      for (const std::string& name : words_of(text)) names.push_back(unescaped(name));
      EXPECT_EQ(new_files(), names);
    } else if (subject == "no") {
      EXPECT_FALSE(exists(text));
    } else if (subject == "bytes") {
      std::string_view comparison = text;
      const std::string whole = text_of(take_word(comparison)), op = take_word(comparison);
      EXPECT_TRUE(holds(static_cast<double>(whole.size()), op, value_of(comparison), 0)) << whole.size();
    } else if (kKeeping.contains(subject)) {
      check_kept(subject, text);
    } else if (subject == "beside") {
      std::string_view comparison = text;
      const std::string name = take_word(comparison), what = take_word(comparison), op = take_word(comparison);
      const double found = quantity(what);
      EXPECT_TRUE(compares(found - kept_numbers_.at(name), op, std::string(comparison), kMicrometre))
          << found << ", kept " << kept_numbers_.at(name);
    } else if (subject == "classes") {
      check_classes(text);
    } else if (subject == "size") {
      std::string_view comparison = text;
      const std::string pointer = take_word(comparison), op = take_word(comparison);
      EXPECT_TRUE(holds(static_cast<double>(json_at(pointer).size()), op, value_of(comparison), 0)) << json_at(pointer);
    } else if (subject.find(":/") != subject.npos || subject.front() == '/') {
      check_json(subject, text);
    } else {
      check_text_or_number(subject, text);
    }
  }

  /// Keeps a number, a part of the JSON or all that is comparable, or holds it against what is kept.
  void check_kept(const std::string& verb, std::string_view rest) {
    const std::string name = take_word(rest);
    if (verb == "keep-number") {
      kept_numbers_[name] = sum(std::string(rest));
      return;
    }
    std::string now = outcome_.out;
    if (verb.ends_with("-json")) {
      now = json_at(std::string(rest)).dump();
    } else if (verb.ends_with("-pieces")) {
      now = pieces_of(json::parse(text_of(std::string(rest))));
    } else if (drawing_.is_object()) {
      now = drawing_["strokes"].dump();
    }
    if (verb.starts_with("keep")) {
      kept_[name] = now;
    } else {
      EXPECT_EQ(kept_.at(name) == now, verb.starts_with("as")) << now.substr(0, 2000);
    }
  }

  std::string text_of(const std::string& place) const {
    return place == "out" ? outcome_.out : place == "err" ? outcome_.err : contents(file(place));
  }

  void check_classes(const std::string& text) const {
    std::map<std::string, int> expected;
    std::istringstream in(text);
    std::string line_class;
    for (std::string number; in >> line_class >> number;) expected[line_class] = std::stoi(number);
    EXPECT_EQ(strokes_by_class(drawing_), expected);
  }

  std::vector<json> jsons_at(const std::string& place) const {
    const std::size_t colon = place.find(":/");
    const json whole = json::parse(colon == place.npos ? outcome_.out : contents(file(place.substr(0, colon))));
    return parts_at(whole, unescaped(colon == place.npos ? place : place.substr(colon + 1)));
  }
  json json_at(const std::string& place) const { return jsons_at(place).at(0); }

  void check_json(const std::string& place, std::string_view rest) const {
    const std::string op = take_word(rest), text(rest);
    const std::vector<json> all = jsons_at(place);
    EXPECT_FALSE(all.empty());
    for (const json& found : all) check_part(found, op, text);
  }

  void check_part(const json& found, const std::string& op, const std::string& text) const {
    if (op == "has" || op == "lacks") {
      EXPECT_EQ(found.contains(text), op == "has") << found;
    } else if (found.is_number()) {
      EXPECT_TRUE(compares(found, op, text, 0)) << found;
    } else {
      EXPECT_EQ(found == json::parse(text), op == "=") << found;
    }
  }

  bool compares(double found, const std::string& op, const std::string& text, double usual) const {
    const std::size_t sign = text.find(" +- ");
    return holds(found, op, sum(text.substr(0, sign)), sign == text.npos ? usual : sum(text.substr(sign + 4)));
  }

  /// A sum of products of numbers, of quantities and of $NAMES.
  double sum(const std::string& text) const {
    if (text.find_first_of("$:/") == text.npos && text.find_first_of("abcdfghjklmnoqrstuvwxyz") == text.npos)
      return value_of(text);
    double result = 0;
    for (const std::string& term : parts_of(text, '+')) {
      double product = 1;
      for (const std::string& factor : parts_of(term, '*')) product *= this->factor(factor);
      result += product;
    }
    return result;
  }

  double factor(const std::string& text) const {
    if (text.starts_with("$")) return kept_numbers_.at(text.substr(1));
    if (text == "pi" || text.find_first_of("0123456789.-") == 0) return value_of(text);
    return quantity(text);
  }

  void check_text_or_number(const std::string& subject, std::string_view rest) const {
    const std::string verb = take_word(rest);
    if (verb.find_first_of("<>=") != verb.npos) {
      const double found = sum(subject);
      EXPECT_TRUE(compares(found, verb, std::string(rest), kMicrometre)) << subject << " is " << found;
      return;
    }
    const std::string whole = text_of(subject), text = unescaped(rest);
    const std::size_t digits = text.find_first_not_of("0123456789");
    if (verb == "has" && digits != 0 && digits != text.npos && text.compare(digits, 4, " of ") == 0) {
      EXPECT_EQ(count_of(whole, text.substr(digits + 4)), std::stoul(text)) << whole.substr(0, 2000);
    } else if (verb == "has") {
      expect_parts(whole, {text});
    } else if (verb == "lacks") {
      expect_no_parts(whole, {text});
    } else if (verb == "matches" || verb == "mismatches") {
      EXPECT_EQ(std::regex_search(whole, std::regex(std::string(rest))), verb == "matches") << whole.substr(0, 2000);
    } else if (verb == "begins") {
      EXPECT_TRUE(whole.starts_with(text)) << whole.substr(0, 2000);
    } else if (verb == "is") {
      EXPECT_EQ(whole, text);
    } else if (verb == "same" || verb == "differs") {
      EXPECT_EQ(whole == contents(file(text)), verb == "same") << whole.substr(0, 2000);
      EXPECT_FALSE(whole.empty());
    } else {
      ADD_FAILURE() << "no check: " << subject << ' ' << verb;
    }
  }

  double quantity(const std::string& name) const {
    if (name == "lines") return static_cast<double>(outcome_.error_lines());
    if (name == "down") return down();
    if (name.find(":/") != name.npos || name.front() == '/') return json_at(name).get<double>();
    const std::vector<std::string> words = parts_of(name, ':');
    if (words[0] == "drawn") return drawn_length(contents(file(words.at(1))), words.size() > 2 ? words[2] : "");
    if (words[0] == "bytes") return static_cast<double>(contents(file(words.at(1))).size());
    if (words[0] == "count") return static_cast<double>(count_of(contents(file(words.at(1))), unescaped(words.at(2))));
    if (!drawing_.is_object()) return of_layers(name);
    if (words[0] == "mm") return length_mm(drawing_, words.at(1), true);
    if (words[0] == "hidden-mm") return length_mm(drawing_, words.at(1), false);
    if (words[0] == "units") return length(drawing_, words.at(1));
    if (name == "strokes") return static_cast<double>(drawing_["strokes"].size());
    if (name.starts_with("most:") || name.starts_with("least:")) return outermost(name);
    const Extent box = extent_of(drawing_, words.size() > 1 ? words[1] : "");
    if (words[0] == "least-x") return box.left;
    if (words[0] == "most-x") return box.right;
    if (name == "y/x") return (box.bottom - box.top) / (box.right - box.left);
    if (name == "width") return box.right - box.left;
    if (name == "height") return box.bottom - box.top;
    if (name == "left") return box.left;
    if (name == "right") return box.right;
    if (name == "top") return box.top;
    if (name == "bottom") return box.bottom;
    return strokes_by_class(drawing_)[name];
  }

  double down() const {
    double mm = 0;
    const std::size_t before = outcome_.err.find("before");
    EXPECT_TRUE(before != outcome_.err.npos && std::sscanf(outcome_.err.c_str() + before, "before %*d %lf", &mm) == 1);
    return mm;
  }

  /// The length of a layer; "all:NAME", of the layers NAME-... too; "paths:NAME", the number of its lines.
  double of_layers(const std::string& name) const {
    if (name.starts_with("paths:")) {
      const std::string& svg = outcome_.out;
      const std::size_t from = svg.find("id=\"" + name.substr(6) + "\"");
      if (from == svg.npos) return 0;
      return static_cast<double>(count_of(svg.substr(from, svg.find("</g>", from) - from), "<path"));
    }
    double sum = 0;
    for (const auto& [layer, length] : layers_)
      if (name.starts_with("all:") ? layer.substr(0, layer.find('-')) == name.substr(4) : layer == name) sum += length;
    return sum;
  }

  /// "most:CLASS:z": the largest z of the source edges of the class, or of all; "least:CLASS:z", the smallest.
  double outermost(const std::string& name) const {
    const std::size_t first = name.find(':'), second = name.find(':', first + 1);
    const std::string line_class = name.substr(first + 1, second - first - 1);
    const std::size_t axis = static_cast<std::size_t>(name.back() - 'x');
    const double sign = name.starts_with("most") ? 1 : -1;
    double found = -std::numeric_limits<double>::infinity();
    for (const json& stroke : drawing_["strokes"]) {
      if (!line_class.empty() && stroke["class"] != line_class) continue;
      for (const json& end : stroke["source"]["ends"]) found = std::max(found, sign * end[axis].get<double>());
    }
    return sign * found;
  }

  Outcome outcome_;
  json drawing_;
  std::map<std::string, double> layers_;
  std::map<std::string, std::string> kept_;
  std::map<std::string, double> kept_numbers_;
};

[[maybe_unused]] const bool scripts_are_added = add_scripts(LIGNE_SOURCE_DIR "/tests/cli/scripts", [](const Script& script) {
  CommandScript test;
  test.run_steps(script);
});

}  // namespace
}  // namespace ligne::test
