#include "reports/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/convergence/verdict.hpp"
#include "reports/page/page.hpp"

namespace plumb::reports {

const char* name_of(CheckKind kind) {
  switch (kind) {
    case CheckKind::verified:
      return "verified";
    case CheckKind::reproduced:
      return "reproduced";
    case CheckKind::regression:
      return "regression";
    case CheckKind::book_keeping:
      break;
  }
  return "book-keeping";
}

const std::vector<CheckKind>& check_kinds() {
  static const std::vector<CheckKind> kinds{CheckKind::verified, CheckKind::reproduced, CheckKind::regression,
                                            CheckKind::book_keeping};
  return kinds;
}

Check as(CheckKind kind, Check check) {
  check.kind = kind;
  return check;
}

Check number_check(std::string what, double measured, double expected, double tolerance,
                   const std::string& reason) {
  const double error = std::abs(measured - expected);
  const bool holds = error <= tolerance * std::abs(expected);
  const int digits =
      std::clamp(3 - static_cast<int>(std::floor(std::log10(tolerance))), 3, 12);  // one to spare
  return {std::move(what), fmt::format("{:.{}g} within {:.0e} ({})", expected, digits, tolerance, reason),
          error == 0 ? fmt::format("{:.{}g}, exactly", measured, digits)
                     : fmt::format("{:.{}g}, off by {:.1e}", measured, digits, error / std::abs(expected)),
          pass_if(holds)};
}

Check bound_check(std::string what, double largest, double bound, const std::string& reason) {
  return {std::move(what), fmt::format("at most {:g} ({})", bound, reason), number_text(largest, 2),
          pass_if(largest <= bound)};
}

Check order_check(std::string what, const std::vector<double>& spacings, const std::vector<double>& errors,
                  double declared, const FitOptions& options) {
  std::vector<Level> levels;
  for (std::size_t k = 0; k < spacings.size(); ++k) levels.push_back({spacings[k], errors[k]});
  const OrderFit fit = fit_order(levels, options);
  return {std::move(what), fmt::format("order {:g}", declared),
          fmt::format("{:.3f}, 95 % interval [{:.3f}, {:.3f}], {} of {} levels fitted", fit.order, fit.lower,
                      fit.upper, fit.levels.size(), fit.given),
          std::string(name_of(judge(fit, declared)))};
}

DataTable account(std::string id, std::string title, const std::vector<Sentence>& sentences,
                  std::vector<std::string> jobs) {
  DataTable table{std::move(id),
                  std::move(title),
                  {{"where"}, {"the paper says"}, {"status"}, {"found here"}},
                  {},
                  std::move(jobs)};
  for (const auto& s : sentences) table.rows.push_back({s.where, s.claim, s.status, s.found});
  return table;
}

}  // namespace plumb::reports
