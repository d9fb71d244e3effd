#pragma once
#include <string>

/// The pages of lib/theory, as they stood when the program was built, for the page.
namespace plumb::reports::theory {

/// The index, the chapters, what was measured, and the papers as HTML. Equation (5.3) has the id "eq-5-3", chapter 5
/// the id "theory-5". Formulas are LaTeX in elements <x-equation>, which page.js renders by KaTeX; a program that was
/// built without KaTeX says so at the beginning.
std::string page();

/// HTML of a page `name` ("05-momentum.md") in Markdown with formulas in $..$ and $$..$$.
std::string page_of(const std::string& name, const std::string& markdown);

/// HTML text in which "THEORY (5.3)", "THEORY (5.2), (5.3)" and "THEORY chapter 5" link to their places in
/// page(). A number that is not there stays text.
std::string linked(const std::string& html);

}  // namespace plumb::reports::theory
