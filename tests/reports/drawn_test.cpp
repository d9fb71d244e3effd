// What the pictures of the report draw: every number is looked up in (invented) results, and the axis, the
// title and the name of its series must be those of the study, row and column that it comes from.
#include <gtest/gtest.h>

#include <set>

#include "reports/named.hpp"
#include "tests/reports/invented_report.hpp"

namespace {

using namespace plumb::reports;
using plumb::test::InventedReport;
using plumb::test::Invention;
using plumb::test::near;
using plumb::test::Origin;
using plumb::test::Words;

/// What an axis says, and the columns that it may show, each as given or as a part of a heading.
struct Shown {
  std::string label;
  std::vector<std::string> columns;
};

/// The first that the label of an axis begins with holds.
const std::vector<Shown> axes{
    {"RMSE of dx/dX", {"rmse"}},
    {"number of particles N", {"n"}},
    {"particles", {"n"}},
    {"particle spacing d", {"d"}},
    {"spacing", {"d"}},
    {"relative error in L₂", {"relative_l2", "error"}},
    {"relative error", {"f_", "div_p_"}},
    {"CPU time per update", {"updates_per_cpu_s"}},
    {"CPU time", {"cpu_s"}},
    {"pair evaluations", {"pair_evaluations"}},
    {"updates", {"updates_per_cpu_s"}},
    {"position x", {"x"}},
    {"position X", {"X"}},
    {"kernel", {"W", "W0", "W1"}},
    {"gradient seen / exact", {"gradient"}},
    {"gradient", {"grad"}},
    {"estimate of dx/dX", {"value"}},
    {"error of the estimate", {"error"}},
    {"θ = k Δx", {"theta"}},
    {"theta", {"theta"}},
    {"response", {"value"}},
    {"time step", {"dt"}},
    {"time", {"time [s]"}},
    {"L₂ difference to the fine-step run", {"l2"}},
    {"change of angular momentum", {": angular momentum z"}},
    {"angular momentum left", {"angular momentum z"}},
    {"change of the energy", {"total energy"}},
    {"energy", {"energy"}},
    {"displacement in y", {"tip displacement y [m]"}},
    {"displacement", {"tip displacement x [m]", "tip displacement y [m]"}},
    {"hourglass share", {"hourglass share"}},
    {"1/2 - ν", {"1/2 - nu"}},
    {"error of u", {"error of u"}},
};

/// Static studies have relative errors under the plain names.
bool may_show(const std::string& label, const std::string& column, const Words& call) {
  for (const Shown& axis : axes) {
    if (!label.starts_with(axis.label)) continue;
    for (const std::string& wanted : axis.columns) {
      if (column == wanted) return true;
      const bool part_is_enough = wanted.size() > 3 || wanted == "f_";
      if (part_is_enough && column.find(wanted) != std::string::npos &&
          column.find("gap of") == std::string::npos)
        return true;
    }
    return axis.label == "relative error in L₂" && call.at("command") == "static" && column == "l2";
  }
  ADD_FAILURE() << "no column is known for an axis \"" << label << "\"";
  return false;
}

/// Where a drawn number comes from: as it is, scaled to another unit, or against the first of a column.
class Lookup {
 public:
  Lookup(const Invention& invention, const std::vector<std::string>& jobs)
      : invention_(&invention), jobs_(jobs.begin(), jobs.end()) {
    for (const auto& [value, origin] : invention.origins)
      if (jobs_.contains(origin.row->job) && (origin.column.find("momentum") != std::string::npos ||
                                              origin.column.find("energy") != std::string::npos))
        references_.push_back(value);
  }
  /// The origin that `fits`, or else the first one: 100 % of any reference is a number that is there.
  template <class Fits>
  const Origin* find(double drawn, Fits&& fits) const {
    const Origin* first = nullptr;
    std::vector<double> values{drawn, 1e-3 * drawn, 1e3 * drawn, 1e6 * drawn, 1e9 / drawn};
    for (const double reference : references_) {
      values.push_back(drawn / 100 * reference);
      values.push_back((1 + drawn / 100) * reference);
    }
    for (const double value : values) {
      const Origin* found = at(value);
      if (found && fits(*found)) return found;
      if (!first) first = found;
    }
    return first;
  }

 private:
  const Origin* at(double value) const {
    const auto next = invention_->origins.lower_bound(value - 1e-12 * std::abs(value));
    if (next == invention_->origins.end() || !near(next->first, value)) return nullptr;
    return jobs_.contains(next->second.row->job) ? &next->second : nullptr;
  }
  const Invention* invention_;
  std::set<std::string> jobs_;
  std::vector<double> references_;
};

class Drawn : public InventedReport {
 protected:
  void check_point(const Figure& figure, const Series& series, std::size_t k, const Lookup& lookup) const {
    const std::string where = figure.id + ", " + series.label;
    const Origin* origin = lookup.find(series.y[k], [&](const Origin& o) {
      const auto& row = o.row->numbers;
      return may_show(figure.picture.y.label, o.column, facts_of(o)) &&
             std::any_of(row.begin(), row.end(),
                         [&](const auto& entry) { return near(series.x[k], entry.second); });
    });
    ASSERT_NE(origin, nullptr) << where << ": " << series.y[k] << " stands in none of its studies";
    const Words facts = facts_of(*origin);
    EXPECT_TRUE(may_show(figure.picture.y.label, origin->column, facts))
        << where << ": the axis \"" << figure.picture.y.label << "\" shows " << origin->column;
    bool beside = false;
    for (const auto& [column, value] : origin->row->numbers)
      beside = beside || (near(series.x[k], value) && may_show(figure.picture.x.label, column, facts));
    EXPECT_TRUE(beside) << where << ": x = " << series.x[k] << " is not the \"" << figure.picture.x.label
                        << "\" of its row";
    check_claims(figure.picture.title, facts, where);
    check_claims(series.label, facts, where);
    check_name(series.label, *origin, where);
  }

  /// A name that a column, a case or a method has.
  void check_name(const std::string& label, const Origin& origin, const std::string& where) const {
    const std::string& column = origin.column;
    const bool energy =
        column.find(" energy [") != std::string::npos && column.find(':') == std::string::npos;
    if (energy && label.size() < 8) {
      EXPECT_TRUE(column.starts_with(label)) << where << " shows " << column;
    }
    if (const auto at = column.find(": "); at != std::string::npos) {
      EXPECT_EQ(column.substr(0, at), label) << where;
    }
    if (column.starts_with("W")) {
      EXPECT_EQ(label.substr(0, label.find(' ')), column) << where;
    }
    if (const auto at = label.find("∇"); at != std::string::npos) {
      EXPECT_EQ(label.substr(0, at) + "grad" + label.substr(at + std::string("∇").size()), column) << where;
    }
    for (const std::string& word : {std::string(": F, "), std::string(": Div P, ")})
      if (const auto at = label.find(word); at != std::string::npos) {
        EXPECT_EQ(column, (word == ": F, " ? "f_" : "div_p_") + label.substr(at + word.size())) << where;
      }
    const Words& words = origin.row->words;
    if (words.contains("method") && label != "Pareto front" && !words.contains("material.poisson")) {
      EXPECT_EQ(words.at("method"), label) << where;
    }
    for (const char* key : {"direction", "integrator"})
      if (const auto word = words.find(key); word != words.end()) {
        EXPECT_NE((" " + label + ":").find(word->second), std::string::npos) << where << ": " << word->second;
      }
  }
};

/// Lines that are no numbers of a study: the exact answer, speeds and recorded errors of other codes, and differences of two runs
/// (Drawn.TheWorkOfTheColumnIsThatOfItsTip).
bool is_computed(const Figure& figure, const Series& series) {
  return series.label == "exact" || figure.id == "column-work" || figure.id.starts_with("mixed-columns-") ||
         (figure.id == "peers" && !series.label.starts_with("Plumbline")) ||
         (figure.id == "foreign-codes" && series.label != "invented elements");
}

TEST_F(Drawn, EveryNumberIsThatOfItsAxisTitleAndName) {
  std::size_t points = 0;
  for (const auto& [id, section] : sections)
    for (const auto& figure : section.figures) {
      const Lookup lookup(invention, figure.jobs);
      for (const auto& series : figure.picture.series) {
        if (is_computed(figure, series)) continue;
        ASSERT_FALSE(series.x.empty()) << figure.id << ", " << series.label;
        for (std::size_t k = 0; k < series.x.size(); ++k, ++points) {
          if (std::abs(series.y[k]) < 1e-12 && figure.picture.y.label.starts_with("change")) continue;
          check_point(figure, series, k, lookup);
        }
      }
    }
  EXPECT_GT(points, 500u);
}

TEST_F(Drawn, OrdersAreThoseOfTheNamedStudyAndNorm) {
  std::size_t rows = 0;
  for (const auto& [id, section] : sections)
    for (const auto& figure : section.figures) {
      const auto* drawn = std::get_if<Intervals>(&figure.picture.map);
      if (!drawn) continue;
      std::set<std::string> names;
      for (std::size_t k = 0; k < drawn->names.size(); ++k, ++rows) {
        const std::string where = figure.id + ", " + drawn->names[k];
        EXPECT_TRUE(names.insert(drawn->names[k]).second) << where << " twice";
        const Origin order = invention.origins.at(drawn->value[k]);
        EXPECT_EQ(order.column, "order") << where;
        EXPECT_EQ(invention.origins.at(drawn->low[k]).column, "low") << where;
        EXPECT_EQ(invention.origins.at(drawn->high[k]).column, "high") << where;
        EXPECT_EQ(invention.origins.at(drawn->high[k]).row->job, order.row->job) << where;
        EXPECT_EQ(order.row->words.at("norm"), "l2") << where;
        EXPECT_NE(figure.picture.x.label.find("L₂"), std::string::npos) << where;
        check_claims(drawn->names[k], facts_of(order), where);
      }
    }
  EXPECT_GT(rows, 40u);
}

/// The pictures of layouts and edges show each treatment of the edge once, of the amplitude and pair of the
/// title.
TEST_F(Drawn, EdgesShowEveryTreatmentOnce) {
  for (const std::string amplitude : {"0.01", "0.2"}) {
    const Figure figure =
        by_id(sections.at("edges").figures, amplitude == "0.2" ? "mms-edges-large" : "mms-edges-small");
    std::set<std::string> names;
    for (const auto& series : figure.picture.series) names.insert(series.label);
    EXPECT_EQ(names,
              (std::set<std::string>{"node, exact band", "node, rollers", "node, outer particles held",
                                     "cell, rollers", "cell, outer particles held", "cell, exact band"}));
    EXPECT_EQ(figure.picture.series.size(), names.size());
    ASSERT_EQ(figure.jobs.size(), names.size());
    for (const auto& job : figure.jobs) {
      EXPECT_EQ(calls.at(job).at("method.pair"), "W1");
      EXPECT_EQ(calls.at(job).at("study.parameters.amplitude"), amplitude);
    }
  }
}

/// The front of a cost holds the points that the study says are on it: invented ones of d = 0.1 m by CPU
/// time, of d = 0.2 m by work.
TEST_F(Drawn, FrontsAreThoseOfTheirCost) {
  std::size_t fronts = 0;
  for (const auto& figure : sections.at("work").figures) {
    const Series front = by_label(figure.picture.series, "Pareto front");
    const double spacing = figure.id.ends_with("-cpu") ? 0.1 : 0.2;
    std::set<double> shown(front.y.begin(), front.y.end()), expected;
    for (const auto& [value, origin] : invention.origins)
      if (origin.column == "error" && origin.row->job == figure.jobs.at(0) &&
          origin.row->numbers.at("d") == spacing)
        expected.insert(value);
    EXPECT_EQ(shown, expected) << figure.id;
    fronts += expected.empty() ? 0 : 1;
  }
  EXPECT_EQ(fronts, 6u);
}

/// Every drawn body has one number that is held against theory or an independent solution.
TEST_F(Drawn, EveryBodyHasANumberThatIsCompared) {
  const Section& bodies = sections.at("bodies");
  std::map<std::string, int> compared;
  for (const auto& check : bodies.checks)
    if (check.kind == CheckKind::verified) ++compared[check.job];
  std::set<std::string> drawn;
  for (const auto& figure : bodies.figures) drawn.insert(figure.jobs.at(0));
  EXPECT_GE(drawn.size(), 4u);
  for (const auto& job : drawn) EXPECT_EQ(compared[job], 1) << job;
}

/// How far each scheme's tip is from where two schemes tend to, over its CPU time; in a column in bending.
TEST_F(Drawn, TheErrorsOfTheColumnsOfPaper003AreThoseOfTheirTips) {
  for (const auto& figure : sections.at("mixed-columns").figures) {
    if (figure.id != "mixed-columns-bending") continue;
    const Series series = by_label(figure.picture.series, "mixed, upwinding R^T S R");
    ASSERT_EQ(series.y.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto run =
          invention.results.json("mixed-columns-bending-mixed-" + std::vector<std::string>{"4", "6"}[k]);
      const auto u = run.at("probes").at("tip").at("displacement").get<std::vector<double>>();
      EXPECT_DOUBLE_EQ(series.y[k], std::abs(u[0] - 0.5 - 2.632));
      EXPECT_DOUBLE_EQ(series.x[k], number(run.at("timing"), "cpu_s"));
    }
  }
}

/// Error of the tip of each scheme against the finest adjoint run, over its CPU time.
TEST_F(Drawn, TheWorkOfTheColumnIsThatOfItsTip) {
  const auto& figure = sections.at("column-work").figures.at(0);
  const auto tip = [&](const std::string& job) {
    return invention.results.json(job).at("probes").at("tip").at("displacement").get<std::vector<double>>();
  };
  const auto reference = tip("column-work-adjoint-12");
  for (const auto& [label, scheme] :
       {std::pair("adjoint, Verlet, no JST", "adjoint"), {"symmetrised, RK3, JST", "paper"}}) {
    const Series series = by_label(figure.picture.series, label);
    ASSERT_EQ(series.y.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string job = "column-work-" + std::string(scheme) + "-" + std::vector{"4", "6", "8"}[k];
      const auto u = tip(job);
      EXPECT_DOUBLE_EQ(series.y[k],
                       std::hypot(u[0] - reference[0], u[1] - reference[1], u[2] - reference[2]));
      EXPECT_DOUBLE_EQ(series.x[k], number(invention.results.json(job).at("timing"), "cpu_s"));
    }
  }
}

}  // namespace
