#pragma once
#include <string>
#include <utility>
#include <vector>

#include "lib/convergence/order_fit.hpp"
#include "reports/section.hpp"

namespace plumb::reports {

/// The check as one of that kind.
Check as(CheckKind kind, Check check);

/// A measured number against the one that mathematics gives, to a relative tolerance whose reason the caller
/// gives. A measured number that is not finite fails.
Check number_check(std::string what, double measured, double expected, double tolerance,
                   const std::string& reason);

/// The largest of several errors against a bound.
Check bound_check(std::string what, double largest, double bound, const std::string& reason);

/// The order of errors under refinement against the declared one, judged by plumb::judge().
Check order_check(std::string what, const std::vector<double>& spacings, const std::vector<double>& errors,
                  double declared, const FitOptions& options = {});

/// One sentence of a paper and what became of it: status is reproduced, contradicted, ambiguous or open.
struct Sentence {
  std::string where, claim, status, found;
};

/// The account of a paper's sentences as a table.
DataTable account(std::string id, std::string title, const std::vector<Sentence>& sentences,
                  std::vector<std::string> jobs);

}  // namespace plumb::reports
