#include "reports/theory/theory.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <regex>
#include <sstream>

#include "places.hpp"
#include "reports/theory/mathml.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// Blanks and the signs that only say where something stands taken out.
std::string bare(const std::string& text) {
  static const std::regex signs(R"([\s_^{}()]|sqrt)");
  return std::regex_replace(text, signs, "");
}

/// The text that a formula shows, in the notation of lib/THEORY.md.
std::string shown(const std::string& mathml) {
  static const std::regex tags("<[^>]*>");
  std::string text = std::regex_replace(mathml, tags, "");
  for (const auto& [sign, name] : std::vector<std::pair<std::string, std::string>>{
           {"∑", "sum"},    {"∇", "grad"},   {"⊗", "(x)"},   {"×", "(x-product)"}, {"·", "."},
           {"−", "-"},      {"≤", "<="},     {"≥", ">="},    {"≠", "!="},          {"←", "<-"},
           {"′", "'"},      {"\u0303", "~"}, {"α", "alpha"}, {"β", "beta"},        {"γ", "gamma"},
           {"Λ", "Lambda"}, {"λ", "lambda"}, {"κ", "kappa"}, {"θ", "theta"},       {"ω", "omega"},
           {"η", "eta"},    {"φ", "phi"},    {"ψ", "psi"},   {"ρ", "rho"},         {"μ", "mu"},
           {"ν", "nu"},     {"π", "pi"},     {"&lt;", "<"},  {"&gt;", ">"},        {"&#39;", "'"},
           {"&amp;", "&"}})
    text = replaced(text, sign, name);
  return text;
}

std::vector<std::string> formula_lines() {
  std::vector<std::string> lines;
  std::istringstream in(plumb::test::content_of(PLUMBLINE_SOURCE_DIR "/lib/THEORY.md"));
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("    ")) lines.push_back(line.substr(line.find_first_not_of(' ')));
  return lines;
}

TEST(MathML, LosesNothingAndReordersNothing) {
  const auto lines = formula_lines();
  ASSERT_GT(lines.size(), 70u);
  for (const auto& line : lines) EXPECT_EQ(bare(shown(theory::mathml(line))), bare(line));
}

TEST(MathML, LowersRaisesAndNames) {
  EXPECT_NE(theory::mathml("x_ij^2").find(
                "<msubsup><mi>x</mi><mrow><mi>ij</mi></mrow><mrow><mn>2</mn></mrow></msubsup>"),
            std::string::npos);
  EXPECT_NE(theory::mathml("a (x) b").find("<mo>⊗</mo>"), std::string::npos);
  EXPECT_EQ(theory::mathml("a = a(x)").find("⊗"), std::string::npos);  // an argument, no product
  EXPECT_NE(theory::mathml("sqrt(mu/rho)").find("<msqrt><mrow><mi>μ</mi><mo>/</mo><mi>ρ</mi></mrow></msqrt>"),
            std::string::npos);
  EXPECT_NE(theory::mathml("zero at r = 0").find("<mtext>zero</mtext>"), std::string::npos);
}

TEST(MathML, NumbersEndWhereTheyEnd) {
  EXPECT_NE(theory::mathml("2.5 a").find("<mn>2.5</mn>"), std::string::npos);
  EXPECT_NE(theory::mathml("2(3)").find("<mn>2</mn>"), std::string::npos);
  EXPECT_NE(theory::mathml("a = 1. 2").find("<mn>1</mn>"), std::string::npos);
  EXPECT_NE(theory::mathml("1e-3 a").find("<mn>1e-3</mn>"), std::string::npos);
}

TEST(Theory, EveryEquationHasItsPlaceAndThePageIsWellFormed) {
  const std::string page = theory::page();
  std::istringstream in("<page>" + page + "</page>");
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(in, tree));
  std::size_t numbers = 0;
  static const std::regex number(R"(^\((\d+)\.(\d+)\))");
  std::smatch m;
  for (const auto& line : formula_lines())
    if (std::regex_search(line, m, number)) {
      ++numbers;
      const std::string id = " id=\"eq-" + m[1].str() + "-" + m[2].str() + "\"";
      EXPECT_NE(page.find(id), std::string::npos) << line;
    }
  EXPECT_GT(numbers, 50u);
  EXPECT_NE(page.find("id=\"theory-11\""), std::string::npos);
  EXPECT_NE(page.find("<table>"), std::string::npos);  // the table of symbols
}

TEST(Theory, CitationsBecomeLinksAndOthersStayText) {
  EXPECT_EQ(theory::linked("see THEORY (5.3)."), "see THEORY <a href=\"#eq-5-3\">(5.3)</a>.");
  EXPECT_EQ(theory::linked("THEORY (5.2), (99.1)"), "THEORY <a href=\"#eq-5-2\">(5.2)</a>, (99.1)");
  EXPECT_EQ(theory::linked("lib/THEORY.md, chapter 11"),
            "lib/<a href=\"#theory-11\">THEORY.md, chapter 11</a>");
  EXPECT_EQ(theory::linked("THEORY chapter 99, and (5.3) of the paper"),
            "THEORY chapter 99, and (5.3) of the paper");
}

}  // namespace
