#pragma once
#include <string>

/// lib/THEORY.md, as it stood when the program was built, for the page.
namespace plumb::reports::theory {

/// All of it as HTML. Equation (5.3) has the id "eq-5-3", chapter 5 the id "theory-5"; formulas are MathML
/// with the text of the file as their alternative.
std::string page();

/// The same for any text in the notation of lib/THEORY.md.
std::string page_of(const std::string& markdown);

/// HTML text in which "THEORY (5.3)", "THEORY (5.2), (5.3)" and "THEORY chapter 5" link to their places in
/// page(). A number that is not there stays text.
std::string linked(const std::string& html);

}  // namespace plumb::reports::theory
