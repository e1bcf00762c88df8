#include "support/line_text.hpp"

#include "main/script.hpp"
#include "support/mesh_text.hpp"

namespace ligne::test {
namespace {

constexpr std::array<std::string_view, 1> kVariables{"k"};

/// The formulas between commas that stand in no brackets.
std::vector<std::string> formulas_of(const std::string& text) {
  std::vector<std::string> formulas(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(') - (c == ')');
    if (c == ',' && depth == 0)
      formulas.emplace_back();
    else
      formulas.back() += c;
  }
  return formulas;
}

void add_arc(std::vector<Point2>& line, const std::vector<double>& ellipse, double from, double sweep, double steps) {
  const Point2 axis{std::cos(ellipse[4]), std::sin(ellipse[4])}, across{-axis.y, axis.x};
  for (int i = 0; i <= steps; ++i) {
    const double t = from + sweep * i / steps;
    line.push_back(Point2(ellipse[0], ellipse[1]) + ellipse[2] * std::cos(t) * axis + ellipse[3] * std::sin(t) * across);
  }
}

void add_walk(std::vector<Point2>& line, unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> step(-9, 9);
  line.emplace_back(0, 0);
  for (int i = 1; i < count; ++i) line.push_back(line.back() + Point2{step(random), step(random)} * 0.125);
}

void add_word(std::vector<Point2>& line, const std::string& word) {
  const std::size_t colon = word.find(':'), range = word.find("..");
  const std::vector<std::string> formulas = formulas_of(word.substr(colon + 1));
  if (word == "close") {
    line.push_back(line.at(0));
  } else if (range < colon && colon != word.npos) {
    const auto place = place_formula(formulas.at(0) + ";" + formulas.at(1) + ";0", kVariables);
    for (double k = number_of(word.substr(0, range)); k <= number_of(word.substr(range + 2, colon - range - 2)); ++k)
      line.emplace_back(place({k}));
  } else {
    std::vector<double> n;
    for (const std::string& formula : formulas) n.push_back(number_of(formula));
    if (colon == word.npos) {
      line.emplace_back(n.at(0), n.at(1));
    } else if (word.starts_with("arc:")) {
      add_arc(line, n, n.at(5), n.at(6), n.at(7));
    } else if (word.starts_with("ellipse:")) {
      const std::size_t first = line.size();
      add_arc(line, n, 0.1, 2 * std::numbers::pi, n.at(5));
      line.back() = line[first];
    } else {
      add_walk(line, static_cast<unsigned>(n.at(0)), static_cast<int>(n.at(1)));
    }
  }
}

}  // namespace

Polylines lines_of_text(const std::string& text) {
  Polylines lines;
  for (const std::string& part : parts_of(text, ';')) {
    std::vector<Point2> line;
    const std::vector<std::string> words = words_of(part);
    const bool is_rectangle = !words.empty() && words[0] == "rectangle";
    const auto each = std::ranges::find(words, "each");
    std::for_each(words.begin() + is_rectangle, each, [&](const std::string& word) { add_word(line, word); });
    if (is_rectangle) line = {line.at(0), {line.at(1).x, line[0].y}, line[1], {line[0].x, line[1].y}};
    const std::size_t count = each == words.end() ? line.size() : std::stoul(each[1]);
    for (std::size_t i = 0; i < line.size(); i += count) lines.add(std::span(line).subspan(i, count));
  }
  return lines;
}

std::vector<Point2> line_of_text(const std::string& text) {
  const Polylines lines = lines_of_text(text);
  return lines.size() == 0 ? std::vector<Point2>() : std::vector<Point2>(lines[0].begin(), lines[0].end());
}

std::vector<std::vector<Point2>> contours_of_text(const std::string& text) {
  const Polylines lines = lines_of_text(text);
  std::vector<std::vector<Point2>> contours;
  for (std::size_t i = 0; i < lines.size(); ++i) contours.emplace_back(lines[i].begin(), lines[i].end());
  return contours;
}

}  // namespace ligne::test
