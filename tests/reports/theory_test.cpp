#include "reports/theory/theory.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <filesystem>
#include <regex>
#include <sstream>

#include "places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace plumb::reports;

/// All formulas of a page of lib/theory, code left out: what stands between $$ and $$, and between $ and $.
std::vector<std::string> formulas_of(const std::string& markdown) {
  static const std::regex code("`[^`]*`");
  const std::string text = std::regex_replace(markdown, code, "");
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = text.find('$', at)) != std::string::npos;) {
    const std::string fence = text.compare(at, 2, "$$") == 0 ? "$$" : "$";
    const std::size_t from = at + fence.size(), end = text.find(fence, from);
    if (end == std::string::npos) {
      ADD_FAILURE() << "a formula without an end: " << text.substr(at, 80);
      break;
    }
    found.push_back(text.substr(from, end - from));
    at = end + fence.size();
  }
  return found;
}

/// Forges read Markdown before formulas: they take a backslash from before a punctuation mark, and a line that begins with a sign of
/// Markdown for an item, a heading or a quotation. KaTeX does not see such a fault.
TEST(Theory, FormulasAreSafeInMarkdown) {
  static const std::regex escaped(R"(\\[^A-Za-z\s])"), item(R"((^|\n)\s*[-+=>#|*])"),
      refused(R"(\\operatorname)");
  std::size_t formulas = 0;
  for (const auto& page : std::filesystem::directory_iterator(PLUMBLINE_SOURCE_DIR "/lib/theory"))
    for (const auto& formula : formulas_of(plumb::test::content_of(page.path().string()))) {
      ++formulas;
      EXPECT_FALSE(std::regex_search(formula, escaped)) << page.path() << ": " << formula;
      EXPECT_FALSE(formula.find('\n') != std::string::npos && std::regex_search(formula, item))
          << page.path() << ": " << formula;
      EXPECT_FALSE(std::regex_search(formula, refused)) << page.path() << ": GitHub refuses " << formula;
      EXPECT_EQ(formula.find("\n\n"), std::string::npos) << page.path() << ": " << formula;
    }
  EXPECT_GT(formulas, 1000u);
}

TEST(Theory, EveryEquationHasItsPlaceAndThePageIsWellFormed) {
  const std::string page = theory::page();
  std::istringstream in("<page>" + page + "</page>");
  boost::property_tree::ptree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(in, tree));
  std::size_t numbers = 0;
  static const std::regex number(R"(\\tag\{(\d+)\.(\d+)\})");
  for (std::sregex_iterator m(page.begin(), page.end(), number), end; m != end; ++m) {
    ++numbers;
    const std::string id = " id=\"eq-" + m->str(1) + "-" + m->str(2) + "\"";
    EXPECT_NE(page.find(id), std::string::npos) << m->str();
  }
  EXPECT_GT(numbers, 150u);
  EXPECT_NE(page.find("<h3 id=\"theory-11\">11. Compatible bonds</h3>"), std::string::npos);
  EXPECT_NE(page.find("<h4>Symbols</h4>"), std::string::npos);
  EXPECT_NE(page.find("<table>"), std::string::npos);  // the table of symbols
}

TEST(Theory, PagesBecomeOnePage) {
  EXPECT_EQ(
      theory::page_of(
          "05-momentum.md",
          "# 5. Momentum\n\n$$\nf_i < 0\n\\tag{5.3}\n$$\n\nBy (5.3), not by (99.1): `(5.3)`, $(5.3)_i$.\n"),
      "<h3 id=\"theory-5\">5. Momentum</h3>\n"
      "<div class=\"eq\" id=\"eq-5-3\"><x-equation type=\"display\">f_i &lt; 0 \\tag{5.3} </x-equation></div>\n"
      "<p>By <a href=\"#eq-5-3\">(5.3)</a>, not by (99.1): <code>(5.3)</code>, <x-equation>(5.3)_i</x-equation>.</p>\n");
  EXPECT_EQ(theory::page_of("README.md",
                            "# Theory\n\n[one](09-spectrum.md), [two](papers.md), [code](decisions.md)\n"),
            "<p><a href=\"#theory-9\">one</a>, <a href=\"#theory-papers\">two</a>, code</p>\n");
}

TEST(Theory, CitationsBecomeLinksAndOthersStayText) {
  EXPECT_EQ(theory::linked("see THEORY (5.3)."), "see THEORY <a href=\"#eq-5-3\">(5.3)</a>.");
  EXPECT_EQ(theory::linked("THEORY (5.2), (99.1)"), "THEORY <a href=\"#eq-5-2\">(5.2)</a>, (99.1)");
  EXPECT_EQ(theory::linked("THEORY, chapter 11"), "<a href=\"#theory-11\">THEORY, chapter 11</a>");
  EXPECT_EQ(theory::linked("THEORY chapter 99, and (5.3) of the paper"),
            "THEORY chapter 99, and (5.3) of the paper");
}

}  // namespace
